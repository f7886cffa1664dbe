// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The filters and the reference on a few odd triangles, lights and media: finite input gives finite
// output, and whatever else gives errors.

#include "AirlightFuzzScene.h"

#include "vtkActor.h"
#include "vtkAirlightComparison.h"
#include "vtkAirlightProbeFilter.h"
#include "vtkAirlightReference.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLitIntervalsFilter.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkShadowPlanesFilter.h"
#include "vtkTable.h"

using namespace airlight_fuzz;

namespace
{
// Empty, or all finite.
void Run(vtkAlgorithm* filter, bool finite, const char* name)
{
  filter->Update();
  auto* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  if (data && finite)
  {
    RequireFinite(data, name);
  }
}

void FuzzShadows(Input& input, vtkLight* light)
{
  vtkNew<vtkShadowPlanesFilter> planes;
  vtkNew<vtkSilhouetteEdgesFilter> edges;
  vtkSilhouetteEdgesFilter* const filter = input.Flag() ? planes.Get() : edges.Get();
  filter->SetInputData(MakeMesh(input));
  if (input.Flag())
  {
    filter->SetLight(light);
  }
  for (int i = input.Integer(0, 6); i > 0; --i)
  {
    switch (input.Integer(0, 5))
    {
      case 0:
        filter->SetLightPosition(input.Numbers().data());
        break;
      case 1:
        planes->SetExtent(input.Integer(-1, 3));
        break;
      case 2:
        planes->SetFarDistance(input.Number());
        break;
      case 3:
        planes->SetBounds(input.Number(), input.Number(), input.Number(), input.Number(),
          input.Number(), input.Number());
        break;
      case 4:
        planes->SetLightCap(input.Flag());
        break;
      default:
        planes->SetFarCap(input.Flag());
    }
  }
  Run(filter, input.IsModest(), "a shadow");
}

void FuzzIntervals(Input& input, vtkLight* light, vtkParticipatingMedium* medium)
{
  vtkNew<vtkLitIntervalsFilter> filter;
  filter->SetInputData(MakeLines(input));
  filter->SetLight(input.Integer(0, 7) == 0 ? nullptr : light);
  filter->SetMedium(input.Flag() ? medium : nullptr);
  for (int i = input.Integer(0, 2); i > 0; --i)
  {
    filter->AddOccluderData(MakeMesh(input));
  }
  Run(filter, input.IsModest(), "a lit interval");
}

void FuzzProbe(Input& input, vtkLight* light, vtkParticipatingMedium* medium)
{
  vtkNew<vtkAirlightProbeFilter> filter;
  filter->SetInputData(MakeLines(input));
  filter->AddLight(light);
  filter->SetMedium(input.Integer(0, 7) == 0 ? nullptr : medium);
  filter->SetViewpoint(input.Numbers().data());
  filter->SetShadowTolerance(input.Number());
  filter->SetScatteredIrradiance(input.Integer(0, 3) == 0);
  for (int i = input.Integer(0, 2); i > 0; --i)
  {
    filter->AddOccluderData(MakeMesh(input));
  }
  Run(filter, input.IsModest(), "a probe");
}

void FuzzComparison(Input& input)
{
  vtkNew<vtkAirlightComparison> filter;
  filter->SetImageData(MakeImage(input));
  filter->SetReferenceData(input.Integer(0, 7) == 0 ? nullptr : MakeImage(input));
  if (input.Integer(0, 3) == 0)
  {
    filter->SetMaskData(MakeImage(input));
  }
  filter->SetSkipNonFinite(input.Flag());
  filter->Update();
  Require(filter->GetMetrics(), "there is a table");
}

void FuzzReference(Input& input, vtkLight* light, vtkParticipatingMedium* medium)
{
  vtkNew<vtkRenderer> renderer;
  renderer->AutomaticLightCreationOff();
  renderer->AddLight(light);
  for (int i = input.Integer(0, 2); i > 0; --i)
  {
    renderer->AddActor(MakeActor(input));
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(input.Point().data());
  camera->SetFocalPoint(input.Point().data());
  camera->SetParallelProjection(input.Integer(0, 3) == 0);
  camera->SetViewAngle(input.Integer(0, 3) == 0 ? input.Number() : 40.0);
  vtkNew<vtkAirlightReference> filter;
  filter->SetRenderer(renderer);
  filter->SetMedium(medium);
  filter->SetSize(input.Integer(-1, 5), input.Integer(0, 4));
  filter->SetSurfaceShadows(input.Flag());
  filter->SetLightRadius(input.Number());
  filter->SetLightScatters(light, input.Integer(0, 3) != 0);
  Run(filter, input.IsModest(), "the reference");
}
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  Input input(data, size);
  vtkNew<vtkParticipatingMedium> medium;
  vtkNew<vtkLight> light;
  medium->SetScattering(0.1, 0.2, 0.3);
  light->SetPositional(true);
  light->SetPosition(0.0, 3.0, 1.0);
  const int kind = input.Integer(0, 4);
  for (int i = input.Integer(0, 6); i > 0; --i)
  {
    input.Flag() ? ChangeMedium(input, medium) : ChangeLight(input, light);
  }
  switch (kind)
  {
    case 0:
      FuzzShadows(input, light);
      break;
    case 1:
      FuzzIntervals(input, light, medium);
      break;
    case 2:
      FuzzProbe(input, light, medium);
      break;
    case 3:
      FuzzComparison(input);
      break;
    default:
      FuzzReference(input, light, medium);
  }
  return 0;
}
