// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightReference against what vtkAirlightPass and VTK's own mappers draw: all that surfaces
// can be shaded by, culled and clipped faces, assemblies and blocks, translucent layers,
// headlights, parallel projection. Pixels at edges may differ: there rasterisers decide in single
// precision.

#include "AirlightTestCompareScene.h"
#include "AirlightTestScene.h"

#include "Scene/AirlightVTKVersions.h"
#include "vtkAirlightReference.h"
#include "vtkAssembly.h"
#include "vtkCellData.h"
#include "vtkConeSource.h"
#include "vtkCylinderSource.h"
#include "vtkDoubleArray.h"
#include "vtkElevationFilter.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTransform.h"
#include "vtkVersionMacros.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

vtkDataArray* GetArray(vtkAirlightReference* reference, const char* name)
{
  return reference->GetOutput()->GetPointData()->GetArray(name);
}

//------------------------------------------------------------------------------
// Share of pixels that may be wrong by more than a thousandth, as they are at edges.
constexpr double MostAtEdges = 0.001;

void CompareBuffer(
  const std::string& scene, const char* name, vtkImageData* drawn, vtkDataArray* computed)
{
  if (!Check(drawn && computed && drawn->GetNumberOfPoints() == computed->GetNumberOfTuples(),
        scene + ": both have " + name))
  {
    return;
  }
  vtkDataArray* values = drawn->GetPointData()->GetScalars();
  const int components = computed->GetNumberOfComponents();
  std::vector<double> sizes;
  for (vtkIdType i = 0; i < computed->GetNumberOfTuples(); ++i)
  {
    sizes.push_back(std::abs(computed->GetComponent(i, 0)));
  }
  std::sort(sizes.begin(), sizes.end());
  const double floor = 1e-3 * sizes[sizes.size() * 99 / 100] + 1e-12;
  std::vector<double> errors;
  for (vtkIdType i = 0; i < computed->GetNumberOfTuples(); ++i)
  {
    double error = 0.0;
    for (int c = 0; c < components; ++c)
    {
      const double expected = values->GetComponent(i, c);
      const double difference = std::abs(computed->GetComponent(i, c) - expected);
      error = std::max(error, difference / std::max(std::abs(expected), floor));
    }
    errors.push_back(error);
  }
  std::sort(errors.begin(), errors.end());
  const auto gross = errors.end() - std::upper_bound(errors.begin(), errors.end(), 1e-3);
  const double share = static_cast<double>(gross) / static_cast<double>(errors.size());
  const double median = errors[errors.size() / 2];
  std::cout << scene << ", " << name << ": median " << median << ", 95 % below "
            << errors[errors.size() * 95 / 100] << ", above 1e-3 " << 100.0 * share << " %\n";
  Check(median <= 5e-6, scene + ": median error of " + name);
  Check(errors[errors.size() * 95 / 100] <= 9e-5, scene + ": 95 % of the errors of " + name);
  Check(share <= MostAtEdges, scene + ": share of wrong pixels of " + name);
}

void CompareScene(const std::string& name, Scene& scene, vtkAirlightReference* reference)
{
  scene.Window->Render();
  reference->Update();
  for (const char* buffer :
    { "Radiance", "Airlight", "Surface", "Transmittance", "Depth", "LitLength" })
  {
    CompareBuffer(name, buffer, scene.GetBuffer(buffer), GetArray(reference, buffer));
  }
}

//------------------------------------------------------------------------------
vtkActor* AddColoured(Scene& scene, vtkPolyData* data, const glm::dvec3& place)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(place.x, place.y, place.z);
  scene.Renderer->AddActor(actor);
  return actor;
}

// A specular ball with normals, one coloured by its points, a cone coloured by its cells and with
// their normals.
void AddShaded(Scene& scene)
{
  vtkActor* ball = AddColoured(scene, MakeSphere(0.9), { -2.2, 0.8, 0 });
  vtkProperty* property = ball->GetProperty();
  property->SetInterpolationToPhong();
  property->SetColor(0.8, 0.4, 0.2);
  property->SetAmbient(0.02);
  property->SetAmbientColor(0.2, 0.9, 0.4);
  property->SetSpecular(0.7);
  property->SetSpecularPower(12.0);
  property->SetSpecularColor(0.9, 1.0, 0.8);

  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputData(MakeSphere(0.8));
  elevation->SetLowPoint(0, -0.8, 0);
  elevation->SetHighPoint(0, 0.8, 0);
  elevation->Update();
  AddColoured(scene, elevation->GetPolyDataOutput(), { 0, 0.9, 0.5 });

  vtkNew<vtkConeSource> cone;
  cone->SetResolution(7);
  vtkSmartPointer<vtkPolyData> cells = Make(cone);
  vtkNew<vtkDoubleArray> numbers;
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i) / 7.0);
    normals->InsertNextTuple3(0.3, 0.8, 0.1 * static_cast<double>(i));
  }
  cells->GetCellData()->SetScalars(numbers);
  cells->GetCellData()->SetNormals(normals);
  vtkActor* actor = AddColoured(scene, cells, { 2.0, 0.7, 0 });
  actor->SetScale(1.0, 1.8, -1.3); // mirrored
  actor->SetOrientation(20, 30, 40);
  vtkNew<vtkTransform> transform;
  transform->RotateZ(15);
  actor->SetUserTransform(transform);
}

// An open cylinder cut away, with a back of its own; a culled one; a wall of blocks; an assembly.
void AddOthers(Scene& scene)
{
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->CappingOff();
  cylinder->SetResolution(16);
  vtkActor* open = scene.Add(cylinder, [](vtkActor* actor) { actor->SetPosition(-1, -0.6, 2); });
  vtkNew<vtkProperty> back;
  back->SetColor(0.1, 0.3, 0.9);
  open->SetBackfaceProperty(back);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(-1, -0.6, 2);
  plane->SetNormal(0.3, -1.0, -0.3);
  open->GetMapper()->AddClippingPlane(plane);

  scene
    .Add(cylinder,
      [](vtkActor* actor) {
        actor->SetPosition(1.1, -0.5, 2);
        actor->RotateX(40);
      })
    ->GetProperty()
    ->FrontfaceCullingOn();

  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-5, -1.2, 4);
  ground->SetPoint1(5, -1.2, 4);
  ground->SetPoint2(-5, -1.2, -6);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Make(ground));
  blocks->SetBlock(1, MakeSphere(0.3));
  vtkNew<airlight::BlocksMapper> mapper;
  mapper->SetInputDataObject(blocks);
  scene.Renderer->AddActor(Scene::MakeActor(mapper));

  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(Scene::MakeActor(MakeSphere(0.4)));
  assembly->SetPosition(0.2, -0.8, 2.5);
  scene.Renderer->AddActor(assembly);

  vtkSmartPointer<vtkActor> unlit = Scene::MakeActor(MakeSphere(0.25));
  unlit->GetProperty()->LightingOff();
  unlit->SetPosition(2.4, -0.7, 1.5);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
  unlit->SetPropertyKeys(keys);
  scene.Renderer->AddActor(unlit);
}

//------------------------------------------------------------------------------
bool AreSameBits(vtkImageData* a, vtkImageData* b)
{
  bool same = a->GetPointData()->GetNumberOfArrays() == 6;
  for (int i = 0; same && i < a->GetPointData()->GetNumberOfArrays(); ++i)
  {
    auto* p = vtkDoubleArray::SafeDownCast(a->GetPointData()->GetArray(i));
    auto* q = vtkDoubleArray::SafeDownCast(b->GetPointData()->GetArray(p->GetName()));
    same = q && p->GetNumberOfValues() == q->GetNumberOfValues() &&
      std::equal(p->GetPointer(0), p->GetPointer(p->GetNumberOfValues()), q->GetPointer(0));
  }
  return same;
}
}

int TestAirlightReference(int, char*[])
{
  Scene scene(Width, Height);
  AddShaded(scene);
  AddOthers(scene);
  scene.Look({ 0.5, 1.6, 8 }, { 0, 0, 0 });
  vtkLight* lamp = scene.AddPointLight({ 1.3, 4.1, 4.2 });
  scene.Renderer->SetBackground(0.2, 0.4, 0.6); // whole numbers of 1/255: VTK rounds gradients
  scene.Renderer->SetBackground2(0.8, 0.6, 0.0);
  scene.Renderer->GradientBackgroundOn();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 1)
  scene.Renderer->DitherGradientOff(); // since 9.3.1 VTK adds noise of half a step of 1/255
#endif
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(scene.Renderer);
  reference->SetMedium(scene.Medium);
  CompareScene("point light", scene, reference); // at the window's size

  vtkNew<vtkImageData> first;
  first->DeepCopy(reference->GetOutput());
  const vtkMTimeType done = reference->GetOutput()->GetMTime();
  reference->Update();
  Check(reference->GetOutput()->GetMTime() == done, "nothing is computed twice");
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 }, [&] {
    reference->Modified();
    reference->Update();
  });
  Check(reference->GetOutput()->GetMTime() > done, "computed again");
  Check(AreSameBits(first, reference->GetOutput()), "the same bits with one thread");

  scene.Pass->SurfaceShadowsOff();
  reference->SurfaceShadowsOff();
  CompareScene("no shadows on surfaces", scene, reference);
  scene.Pass->SurfaceShadowsOn();
  reference->SurfaceShadowsOn();

  vtkLight* sun = scene.AddDirectionalLight({ -1, 2, 1.5 }, { 0.5, 0.7, 0.4 });
  scene.Pass->SetLightScatters(sun, false);
  reference->SetLightScatters(sun, false);
  Check(!reference->GetLightScatters(sun) && reference->GetLightScatters(lamp),
    "the sun does not scatter, the lamp does");
  lamp->SetConeAngle(40.0);
  lamp->SetExponent(2.0);
  lamp->SetAttenuationValues(0.5, 0.1, 0.6);
  lamp->SetFocalPoint(-0.5, 0.0, 0.5);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(3.0);
  CompareScene("spot and quiet sun, parallel", scene, reference);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();

  vtkNew<vtkParticipatingMedium> ball;
  ball->SetScattering(0.2, 0.1, 0.3);
  ball->SetPhaseFunctionToMieHazy();
  ball->SetRegionToSphere();
  ball->SetRadius(2.5);
  ball->SetAmbientRadiance(0.1, 0.1, 0.2);
  scene.Pass->AddMedium(ball);
  reference->AddMedium(ball);
  vtkNew<vtkPlaneSource> pane;
  pane->SetOrigin(-2.0, -1.0, 3.5);
  pane->SetPoint1(1.5, -1.0, 3.0);
  pane->SetPoint2(-2.0, 2.0, 3.5);
  vtkSmartPointer<vtkActor> glass = Scene::MakeActor(Make(pane));
  glass->GetProperty()->SetOpacity(0.4);
  glass->GetProperty()->SetColor(0.2, 0.9, 0.5);
  scene.Renderer->AddActor(glass);
  CompareScene("two media and a pane", scene, reference);
  scene.Pass->TranslucentShadowsOff();
  reference->TranslucentShadowsOff();
  CompareScene("two media and a pane without a shadow", scene, reference);

  scene.Renderer->RemoveAllLights();
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  headlight->SetColor(0.4, 0.5, 0.6);
  scene.Renderer->AddLight(headlight);
  scene.Pass->RemoveAllMedia();
  reference->RemoveAllMedia();
  CompareScene("headlight, no medium", scene, reference);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
