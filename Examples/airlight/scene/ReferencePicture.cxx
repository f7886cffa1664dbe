// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/ReferencePicture.h"

#include "formats/ImageFile.h"
#include "formats/UserError.h"
#include "formats/VTKMessages.h"
#include "scene/SceneBuilder.h"

#include <vtkAirlightReference.h>
#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace airlight
{

namespace
{
// Buffers of the pass that the reference does not have: what they say is of the pass's own work.
constexpr const char* PassBuffers[] = { "BoundaryCount", "ErrorBound", "MultipleScattering" };

void CheckKnown(const Scene& scene, const PictureSettings& settings, const PathChoices& paths)
{
  if (settings.Buffer == StandardErrorBuffer && paths.Orders == 1)
  {
    throw UserError("--buffer StandardError is of pictures with --orders 0 or from 2 on: add it");
  }
  for (const char* name : PassBuffers)
  {
    if (settings.Buffer == name)
    {
      throw UserError("--reference has no buffer " + settings.Buffer + ": leave out one of them");
    }
  }
  if (scene.ScatteredSurfaceLight)
  {
    throw UserError(scene.FileName +
      ": --reference does not know scattered_surface_light: leave out one of them");
  }
  for (const LightSource& light : scene.Lights)
  {
    if (light.Visible)
    {
      throw UserError(scene.FileName +
        ": --reference shows no lamps: leave out --reference, or --lamp-visible and visible");
    }
  }
}

// One array of a picture, as floats.
vtkSmartPointer<vtkImageData> GetFloats(
  vtkImageData* picture, const std::string& name, double exposure)
{
  vtkDataArray* array = picture->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    throw UserError("the reference computed no " + name);
  }
  auto floats = vtkSmartPointer<vtkImageData>::New();
  floats->SetDimensions(picture->GetDimensions());
  floats->AllocateScalars(VTK_FLOAT, array->GetNumberOfComponents());
  vtkDataArray* values = floats->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < array->GetNumberOfComponents(); ++j)
    {
      values->SetComponent(i, j, array->GetComponent(i, j) * exposure);
    }
  }
  return floats;
}
}

//------------------------------------------------------------------------------
void ComputeToFile(const Scene& scene, const PictureSettings& settings, const PathChoices& paths,
  const std::string& fileName, const std::function<void(double)>& progress)
{
  CheckImageFile(fileName);
  CheckKnown(scene, settings, paths);
  const RenderedScene built = BuildSceneWithoutWindow(scene);
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(built.Renderer);
  reference->SetMedium(scene.Medium);
  reference->SetSize(scene.Width, scene.Height);
  reference->SetScatteringOrders(paths.Orders);
  if (paths.Orders != 1)
  {
    reference->SetSamplesPerPixel(paths.Samples);
    reference->SetTargetError(paths.Error);
    reference->SetTimeLimit(paths.TimeLimit);
    reference->SetSeed(paths.Seed);
  }
  vtkNew<vtkCallbackCommand> observer;
  if (progress)
  {
    observer->SetClientData(const_cast<std::function<void(double)>*>(&progress));
    observer->SetCallback([](vtkObject*, unsigned long, void* show, void* done) {
      (*static_cast<std::function<void(double)>*>(show))(*static_cast<double*>(done));
    });
    reference->AddObserver(vtkCommand::ProgressEvent, observer);
  }
  {
    const VTKMessages messages;
    reference->Update();
    ReportMessages(messages, "computing failed");
  }
  const std::string name = settings.Buffer.empty() ? "Radiance" : settings.Buffer;
  WriteFloatImage(GetFloats(reference->GetOutput(), name, settings.Exposure), fileName);
}

}
