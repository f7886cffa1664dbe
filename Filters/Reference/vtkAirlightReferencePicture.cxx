// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
// The picture of vtkAirlightReference; its settings are in vtkAirlightReference.cxx.
#include "vtkAirlightReference.h"

#include "Reference/AirlightReferenceTracer.h"
#include "Reference/vtkAirlightReferenceInternals.h"
#include "Scene/AirlightAbort.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkWindow.h"

#include <algorithm>

using namespace airlight;

namespace
{
// The output's arrays.
class Buffers
{
public:
  explicit Buffers(vtkImageData* image)
    : Radiance(Add(image, "Radiance", 3))
    , Airlight(Add(image, "Airlight", 3))
    , Surface(Add(image, "Surface", 3))
    , Transmittance(Add(image, "Transmittance", 3))
    , Depth(Add(image, "Depth", 1))
    , LitLength(Add(image, "LitLength", 1))
  {
    image->GetPointData()->SetActiveScalars("Radiance");
  }

  void Set(vtkIdType index, const ReferencePixel& pixel) const
  {
    std::copy_n(&pixel.Radiance.x, 3, this->Radiance + 3 * index);
    std::copy_n(&pixel.Airlight.x, 3, this->Airlight + 3 * index);
    std::copy_n(&pixel.Surface.x, 3, this->Surface + 3 * index);
    std::copy_n(&pixel.Transmittance.x, 3, this->Transmittance + 3 * index);
    this->Depth[index] = pixel.Depth;
    this->LitLength[index] = pixel.LitLength;
  }

private:
  static double* Add(vtkImageData* image, const char* name, int components)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(image->GetNumberOfPoints());
    array->Fill(0.0);
    image->GetPointData()->AddArray(array);
    return array->GetPointer(0);
  }

  double* Radiance;
  double* Airlight;
  double* Surface;
  double* Transmittance;
  double* Depth;
  double* LitLength;
};
}

//------------------------------------------------------------------------------
// The size to compute. False, with an error, where nobody knows it.
bool vtkAirlightReference::FindSize(int size[2])
{
  std::copy_n(this->Size, 2, size);
  vtkRenderer* renderer = this->Impl->Renderer;
  if (size[0] == 0 && renderer && renderer->GetVTKWindow())
  {
    renderer->GetTiledSize(&size[0], &size[1]);
  }
  if (size[0] < 1 || size[1] < 1)
  {
    vtkErrorMacro("The renderer has no size, as it has no window or a closed one: call SetSize().");
    return false;
  }
  return true;
}

bool vtkAirlightReference::Check()
{
  if (!this->Impl->Renderer)
  {
    vtkErrorMacro("There is no renderer: call SetRenderer().");
    return false;
  }
  const std::string text = this->Impl->Media.Check();
  if (!text.empty())
  {
    vtkErrorMacro(<< text);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkAirlightReference::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  int size[2] = { 0, 0 };
  if (!this->Check() || !this->FindSize(size))
  {
    std::fill_n(size, 2, 0);
  }
  const int extent[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, 0 };
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 3);
  return size[0] > 0 ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkAirlightReference::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  image->Initialize();

  ReferenceSettings settings;
  settings.Width = extent[1] + 1;
  settings.Height = extent[3] + 1;
  settings.LightRadius = this->LightRadius;
  settings.SurfaceShadows = this->SurfaceShadows;
  settings.Switches = this->Impl->Switches;
  std::vector<vtkParticipatingMedium*> media = this->Impl->Media.GetAll();
  if (media.empty())
  {
    media.push_back(this->Impl->Vacuum);
  }
  const ReferenceTracer tracer(this->Impl->Renderer, media, settings);
  if (!tracer.IsValid())
  {
    vtkErrorMacro("The camera's matrices are not finite or cannot be inverted: give it a position "
                  "apart from its focal point, and angles and a clipping range above 0.");
    return 0;
  }
  const std::string unsupported = tracer.GetScene().GetUnsupported();
  if (!unsupported.empty())
  {
    vtkWarningMacro(<< "Not computed, or not as VTK draws it: " << unsupported << ".");
  }
  if (tracer.GetLights().HasInvalid())
  {
    vtkWarningMacro(<< InvalidLightText);
  }
  const std::string leftOut = tracer.DescribeLeftOut();
  if (!leftOut.empty() && !this->Impl->WarnedCameraLights)
  {
    this->Impl->WarnedCameraLights = true;
    vtkWarningMacro(<< leftOut);
  }

  image->SetExtent(extent);
  image->SetSpacing(1.0, 1.0, 1.0);
  image->SetOrigin(0.0, 0.0, 0.0);
  const Buffers buffers(image);
  // Some rows at a time: progress is for this thread to tell.
  const int step = std::max(1, settings.Height / 50);
  for (int row = 0; row < settings.Height && !airlight::IsAborted(this); row += step)
  {
    const vtkIdType first = static_cast<vtkIdType>(row) * settings.Width;
    const vtkIdType last =
      static_cast<vtkIdType>(std::min(row + step, settings.Height)) * settings.Width;
    vtkSMPTools::For(first, last, 16, [&](vtkIdType from, vtkIdType to) {
      for (vtkIdType i = from; i < to; ++i)
      {
        const vtkIdType column = i % settings.Width;
        const vtkIdType row = i / settings.Width;
        buffers.Set(
          i, tracer.Trace(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5));
      }
    });
    this->UpdateProgress(static_cast<double>(last) / image->GetNumberOfPoints());
  }
  if (airlight::IsAborted(this))
  {
    image->Initialize();
  }
  return 1;
}
