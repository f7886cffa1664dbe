// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Casters whose opacity varies by the alpha of a texture or of scalars, against brute force with
// strips, each of one opacity, in their place. Along the sheets alpha rises evenly, so that each
// strip's sides follow from the rule by hand: opacities k/8 meet at (k + 1/2)/8.
//
// All these sheets hang above what the picture shows, between a lamp and the floor. Leaves in the
// picture, of random alpha, are compared with vtkAirlightReference, which looks alpha up at each
// point and knows of no parts.

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestTools.h"

#include "vtkAirlightReference.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
const glm::dvec3 Corner(-1.1, 6.0, -0.9);
const glm::dvec3 Along(2.3, 0.2, 0.1); // the way alpha rises
const glm::dvec3 Across(-0.1, 0.0, 2.1);

vtkSmartPointer<vtkPolyData> MakeHangingSheet() { return MakeSheet(Corner, Along, Across); }

void Reset(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 0.4, 9.0, 0.3 }, { 400.0, 300.0, 200.0 });
}

// The part of the sheet between two shares of the way along it, for brute force alone.
void AddStrip(Scene& scene, double from, double to, double opacity)
{
  const size_t first = scene.Triangles.size();
  vtkNew<vtkMatrix4x4> identity;
  scene.AddTriangles(MakeSheet(Corner + from * Along, (to - from) * Along, Across), identity);
  for (size_t i = first; i < scene.Triangles.size(); ++i)
  {
    scene.Triangles[i].Opacity = glm::dvec3(opacity);
    scene.Triangles[i].Stops = false;
  }
}

// White texels of these alphas, in a row.
vtkSmartPointer<vtkTexture> MakeTexture(const std::vector<int>& alphas)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(alphas.size()), 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (size_t i = 0; i < alphas.size(); ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      image->SetScalarComponentFromDouble(static_cast<int>(i), 0, 0, c, c < 3 ? 255 : alphas[i]);
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->SetWrap(vtkTexture::ClampToEdge);
  return texture;
}

vtkActor* AddTextured(Scene& scene, vtkTexture* texture)
{
  const vtkSmartPointer<vtkActor> actor = Scene::MakeActor(MakeHangingSheet());
  actor->SetTexture(texture);
  scene.Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
// What is forced to be drawn as opaque, as glTF's masked materials are, is cut at 1/2.
void TestHole(Scene& scene)
{
  Reset(scene);
  const vtkSmartPointer<vtkActor> actor = AddTextured(scene, MakeTexture({ 255, 0, 255 }));
  actor->ForceOpaqueOn();
  AddStrip(scene, 0.0, 1.0 / 3.0, 1.0);
  AddStrip(scene, 2.0 / 3.0, 1.0, 1.0);
  CompareScene("a hole", scene);
  Limits map;
  map.Technique = vtkAirlightPass::SHADOW_MAP;
  map.Median = 1e-2;
  map.P99 = 0.2;
  map.SurfaceMedian = 2e-5;
  map.Wrong = 0.3;
  map.EdgePixels = 3.0;
  scene.Pass->SetShadowTechniqueToShadowMap();
  CompareScene("a hole in a shadow map", scene, 500, map);
  scene.Pass->SetShadowTechniqueToShadowPlanes();

  // Another picture in the same texture; then a key, which is the opacity of all.
  actor->GetTexture()->SetInputData(MakeTexture({ 0, 255, 0 })->GetInput());
  Reset(scene);
  scene.Renderer->AddActor(actor);
  AddStrip(scene, 1.0 / 3.0, 2.0 / 3.0, 1.0);
  CompareScene("another picture", scene);
  SetShadowOpacity(actor, glm::dvec3(0.25));
  Reset(scene);
  scene.Renderer->AddActor(actor);
  AddStrip(scene, 0.0, 1.0, 0.25);
  CompareScene("a key", scene);
}

// Strips of a ramp from `from`, where alpha is 0, to `to`, where it is 1, and of what follows.
void AddRamp(Scene& scene, double from, double to, double opacity)
{
  for (int k = 1; k <= 8; ++k)
  {
    const auto place = [=](double alpha) {
      return std::min(from + (to - from) * alpha / opacity, 1.0);
    };
    const double begin = place((k - 0.5) / 8.0);
    const double end = k == 8 ? 1.0 : place((k + 0.5) / 8.0);
    if (begin < end)
    {
      AddStrip(scene, begin, end, k / 8.0);
    }
  }
}

//------------------------------------------------------------------------------
void TestTranslucentTexture(Scene& scene)
{
  Reset(scene);
  vtkActor* actor = AddTextured(scene, MakeTexture({ 0, 255 }));
  actor->ForceTranslucentOn();
  AddRamp(scene, 0.25, 0.75, 1.0);
  CompareScene("a ramp of alpha", scene);
  scene.Pass->SetShadowTechniqueToShadowMap();
  scene.Window->Render();
  scene.Pass->SetShadowTechniqueToShadowPlanes();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLookupTable> MakeTable()
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i)
  {
    table->SetTableValue(i, 1.0, 1.0, 1.0, i / 255.0);
  }
  table->SetRange(0.0, 1.0);
  return table;
}

vtkSmartPointer<vtkActor> AddScalarSheet(Scene& scene, vtkPolyData* data)
{
  const vtkSmartPointer<vtkActor> actor = Scene::MakeActor(data);
  actor->GetMapper()->ScalarVisibilityOn();
  actor->GetMapper()->SetLookupTable(MakeTable());
  actor->GetMapper()->SetScalarRange(0.0, 1.0);
  scene.Renderer->AddActor(actor);
  return actor;
}

// Interpolated from point to point, times the property's opacity.
void TestPointScalars(Scene& scene)
{
  Reset(scene);
  const vtkSmartPointer<vtkPolyData> data = MakeHangingSheet();
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    data->GetPoint(i, &point.x);
    values->InsertNextValue(glm::dot(point - Corner, Along) > 0.5 * glm::dot(Along, Along));
  }
  data->GetPointData()->SetScalars(values);
  AddScalarSheet(scene, data)->GetProperty()->SetOpacity(0.6);
  AddRamp(scene, 0.0, 1.0, 0.6);
  CompareScene("scalars of points", scene);
}

// Kept exactly.
void TestCellScalars(Scene& scene)
{
  Reset(scene);
  vtkNew<vtkPlaneSource> source;
  const glm::dvec3 first = Corner + Along;
  const glm::dvec3 second = Corner + Across;
  source->SetOrigin(Corner.x, Corner.y, Corner.z);
  source->SetPoint1(first.x, first.y, first.z);
  source->SetPoint2(second.x, second.y, second.z);
  source->SetXResolution(5);
  const vtkSmartPointer<vtkPolyData> data = Make(source);
  const int alphas[5] = { 77, 0, 200, 31, 255 };
  vtkNew<vtkDoubleArray> values;
  for (int i = 0; i < 5; ++i)
  {
    values->InsertNextValue(alphas[i] / 255.0);
    if (alphas[i] > 0)
    {
      AddStrip(scene, 0.2 * i, 0.2 * (i + 1), alphas[i] / 255.0);
    }
  }
  data->GetCellData()->SetScalars(values);
  AddScalarSheet(scene, data);
  CompareScene("scalars of cells", scene);
}

//------------------------------------------------------------------------------
// A square of texels of random alpha; `soft`: of any alpha, else holes in an opaque picture.
vtkSmartPointer<vtkTexture> MakeRandomTexture(int side, bool soft, unsigned int seed)
{
  Random random(seed);
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 4 * side * side; ++i)
  {
    const double value = random.Uniform(0, 255);
    bytes[i] =
      static_cast<unsigned char>(i % 4 == 3 && !soft ? (value < 128.0 ? 0.0 : 255.0) : value);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->SetWrap(vtkTexture::Repeat);
  return texture;
}

void CompareLeaf(const std::string& name, bool soft, unsigned int seed)
{
  Scene scene(80, 60);
  Reset(scene);
  scene.Renderer->RemoveAllLights();
  scene.AddPointLight({ 1.2, 4.0, 2.3 });
  const vtkSmartPointer<vtkPolyData> data =
    MakeSheet({ -1.2, 1.1, 0 }, { 2.1, 0.3, 0.4 }, { 0, 0.5, 1.9 });
  const vtkSmartPointer<vtkActor> leaf = Scene::MakeActor(data);
  leaf->SetTexture(MakeRandomTexture(9, soft, seed));
  scene.Renderer->AddActor(leaf);
  scene.Pass->SetShadowTechniqueToShadowPlanes();
  scene.Window->Render();
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(scene.Renderer);
  reference->SetMedium(scene.Medium);
  reference->SetSize(scene.Width, scene.Height);
  reference->Update();
  const double airlight = CompareWithReference(scene, reference, "Airlight");
  const double surface = CompareWithReference(scene, reference, "Surface");
  vtkAirlightPass::SetCastsShadow(leaf, false);
  scene.Window->Render();
  const double without = CompareWithReference(scene, reference, "Airlight");
  Check(without > 20.0 * airlight, Text(name, ": without it the air differs by ", without));
  std::cout << name << ": airlight " << airlight << " (" << without << " without it), surface "
            << surface << "\n";
  Check(airlight < 2e-4, Text(name, ": airlight differs by ", airlight));
  Check(surface < 0.02, Text(name, ": surfaces differ by ", surface));
}
}

//------------------------------------------------------------------------------
int TestCastersWithHoles(int, char*[])
{
  Scene scene;
  scene.Pass->SetShadowTechniqueToShadowPlanes();
  TestHole(scene);
  TestTranslucentTexture(scene);
  TestPointScalars(scene);
  TestCellScalars(scene);
  CompareLeaf("a leaf", false, 71);
  CompareLeaf("stained glass", true, 72);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
