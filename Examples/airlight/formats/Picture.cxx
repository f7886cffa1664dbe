// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/Picture.h"

#include "formats/ImageFile.h"
#include "formats/UserError.h"

#include <vtkNew.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

namespace airlight
{

namespace
{
vtkSmartPointer<vtkImageData> GetExposedBuffer(
  vtkAirlightPass* pass, const PictureSettings& settings)
{
  const std::string name = settings.Buffer.empty() ? "Radiance" : settings.Buffer;
  vtkImageData* buffer = pass->GetBuffer(name.c_str());
  if (!buffer || buffer->GetScalarType() != VTK_FLOAT)
  {
    throw UserError("the pass recorded no buffer " + name);
  }
  auto exposed = vtkSmartPointer<vtkImageData>::New();
  exposed->DeepCopy(buffer);
  auto* values = static_cast<float*>(exposed->GetScalarPointer());
  const vtkIdType count = exposed->GetNumberOfPoints() * exposed->GetNumberOfScalarComponents();
  const auto exposure = static_cast<float>(settings.Exposure);
  std::transform(
    values, values + count, values, [exposure](float value) { return value * exposure; });
  return exposed;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> GrabWindow(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  grabber->Update();
  return grabber->GetOutput();
}

//------------------------------------------------------------------------------
const std::vector<std::string>& GetBufferNames()
{
  static const std::vector<std::string> names = { "Radiance", "Airlight", "MultipleScattering",
    "Surface", "Transmittance", "Depth", "LitLength", "BoundaryCount", "ErrorBound" };
  return names;
}

//------------------------------------------------------------------------------
bool NeedsBuffers(const PictureSettings& settings, const std::string& fileName)
{
  return CheckImageFile(fileName) != ImageFormat::Png || !settings.Buffer.empty();
}

//------------------------------------------------------------------------------
void RenderToFile(
  RenderedScene& scene, const PictureSettings& settings, const std::string& fileName)
{
  const bool buffers = NeedsBuffers(settings, fileName);
  scene.Render();
  if (buffers)
  {
    WriteFloatImage(GetExposedBuffer(scene.Pass, settings), fileName);
  }
  else
  {
    WritePng(GrabWindow(scene.Window), fileName);
  }
}

}
