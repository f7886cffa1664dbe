// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows of what props draw inside them: levels of detail, and parts of assemblies whose mappers
// draw something else than their input's polygons. Against brute force (see
// AirlightTestBruteForce.h), and against the same content outside of them.

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestErrors.h"
#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkAirlightReference.h"
#include "vtkAssembly.h"
#include "vtkCubeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkImageSliceMapper.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLODProp3D.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointGaussianMapper.h"

#include <algorithm>
#include <cstdlib>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// A ball or a long box, of different shadows, in one prop.
class Levels
{
public:
  Levels()
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(2.4);
    cube->SetYLength(0.5);
    cube->SetZLength(0.6);
    this->Data[0] = MakeSphere({ 0, 0, 0 }, 0.9);
    this->Data[1] = Make(cube);
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(this->Data[i]);
      mapper->ScalarVisibilityOff();
      vtkNew<vtkProperty> property;
      property->SetInterpolationToFlat();
      this->Ids[i] = this->Prop->AddLOD(mapper, property, 0.0);
    }
    this->Prop->RotateWXYZ(30, 1, 1, 0);
  }

  // By name, or as the only one that VTK may choose.
  void Choose(int level, bool automatic)
  {
    this->Prop->SetAutomaticLODSelection(automatic);
    automatic ? this->Prop->DisableLOD(this->Ids[1 - level])
              : this->Prop->SetSelectedLODID(this->Ids[level]);
  }

  vtkNew<vtkLODProp3D> Prop;
  vtkSmartPointer<vtkPolyData> Data[2];
  int Ids[2];
};

void TestLevels(int level, bool automatic, bool seen)
{
  const std::string name =
    Text("level ", level, automatic ? ", VTK's choice" : ", selected", seen ? "" : ", not in view");
  Scene scene;
  seen ? scene.AddPointLight({ 3, 5, 3 }) : scene.AddPointLight({ 0.5, 9, 0.5 }, glm::dvec3(90.0));
  AddFloor(scene);
  scene.Add(MakeSphere({ -2.5, 0, 0 }, 0.4));
  Levels levels;
  levels.Choose(level, automatic);
  levels.Prop->SetPosition(0.7, seen ? 0.3 : 6.0, 0.2);
  scene.Renderer->AddViewProp(levels.Prop);
  scene.AddTriangles(levels.Data[level], levels.Prop->GetMatrix());

  vtkNew<vtkAirlightReference> reference;
  ErrorListener warnings(reference, vtkCommand::WarningEvent);
  reference->SetRenderer(scene.Renderer);
  reference->SetSize(scene.Width, scene.Height);
  reference->SetMedium(scene.Medium);
  const bool knows = !automatic || level == 0; // before VTK has chosen
  if (knows)
  {
    reference->Update();
  }
  CompareScene(name, scene);
  for (const char* buffer : { "Airlight", "Depth", "Surface" })
  {
    Check(!knows || CompareWithReference(scene, reference, buffer) < 1e-3,
      name + ": the reference before the first frame: " + buffer);
  }
  reference->Modified();
  reference->Update();
  for (const char* buffer : { "Airlight", "Depth", "Surface" })
  {
    Check(CompareWithReference(scene, reference, buffer) < 1e-3,
      name + ": the reference: " + std::string(buffer));
  }
  Check(warnings.Take() == 0, name + ": the reference knows it all");
}

//------------------------------------------------------------------------------
// A prop that shows an image casts nothing, and says so.
void TestImageLevel()
{
  Scene scene(80, 60);
  scene.AddPointLight({ 3, 5, 3 });
  scene.Add(MakeSphere({ 0, 0, 0 }, 0.4));
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkLODProp3D> prop;
  prop->AddLOD(mapper, 0.0);
  scene.Renderer->AddViewProp(prop);
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  scene.Window->Render();
  Check(warnings.Take() == 1, "an image as a level of detail: one warning");
  const std::string text = warnings.GetText();
  Check(text.find("vtkLODProp3D casts no shadow") != std::string::npos &&
      text.find("volume or an image") != std::string::npos &&
      text.find("SetCastsShadow(") != std::string::npos,
    "it names class, reason and remedy: " + text);
  scene.Window->Render();
  Check(warnings.Take() == 0, "said once");
}

//------------------------------------------------------------------------------
// Glyphs on blocks of points, from which no planes can be drawn.
vtkSmartPointer<vtkActor> MakeGlyphs(vtkPolyData* body, const std::vector<glm::dvec3>& places)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (size_t i = 0; i < places.size(); ++i)
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(&places[i].x);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    blocks->SetBlock(static_cast<unsigned int>(i), data);
  }
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetSourceData(body);
  mapper->ScalingOff();
  mapper->ScalarVisibilityOff();
  return Scene::MakeActor(mapper);
}

void TestGlyphPart(bool directional)
{
  const std::string name =
    std::string("glyphs in an assembly, ") + (directional ? "directional light" : "point light");
  Scene scene;
  directional ? scene.AddDirectionalLight({ 0.7, 2, 0.5 })
              : scene.AddPointLight({ 0.3, 8, 0.5 }, glm::dvec3(90.0));
  AddFloor(scene);
  vtkNew<vtkCubeSource> source;
  source->SetXLength(0.8);
  source->SetZLength(0.7);
  vtkSmartPointer<vtkPolyData> cube = Make(source);
  // The last one is out of the view.
  const std::vector<glm::dvec3> places = { { -1.8, 0.1, 0.3 }, { 1.7, 0.4, 0.2 }, { 0.2, 4.9, 1 } };
  vtkSmartPointer<vtkActor> glyphs = MakeGlyphs(cube, places);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(glyphs);
  assembly->RotateY(20);
  assembly->SetPosition(0.1, 0.2, 0.0);
  scene.Renderer->AddActor(assembly);
  for (const glm::dvec3& place : places)
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(i, 3, place[i]);
    }
    vtkMatrix4x4::Multiply4x4(assembly->GetMatrix(), matrix, matrix);
    scene.AddTriangles(cube, matrix);
  }
  // As shadow maps promise, see TestShadowMap.
  Limits limits;
  limits.Technique = vtkAirlightPass::SHADOW_MAP;
  limits.Median = 5e-3;
  limits.P99 = 5e-2;
  limits.Wrong = 1.0;
  limits.EdgePixels = 0.7;
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  CompareScene(name, scene, 700, limits);
  Check(warnings.Take() == 1 && warnings.GetText().find("Glyph3DMapper") != std::string::npos,
    name + ": one warning that names the mapper");
}

//------------------------------------------------------------------------------
enum class Frame
{
  Actor,
  Assembly,
  Level
};

// Splats at a place, as an actor or inside another prop.
Buffers DrawPointGaussians(Frame frame, bool seen, bool casts = true)
{
  Scene scene(120, 90);
  scene.Pass->SetShadowTechniqueToShadowMap();
  scene.AddPointLight({ 0.5, 9, 0.5 }, glm::dvec3(90.0));
  scene.Medium->SetRegionToBox(); // so that lit lengths are finite
  scene.Medium->SetBounds(-7, 7, -3, 10, -7, 7);
  AddFloor(scene);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.3, 0.2);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleFactor(0.8);
  vtkNew<vtkMatrix4x4> place;
  place->SetElement(1, 3, seen ? 0.5 : 6.0);
  place->SetElement(0, 3, -0.4);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkAssembly> assembly;
  vtkNew<vtkLODProp3D> level;
  vtkProp3D* prop = actor;
  if (frame == Frame::Assembly)
  {
    assembly->AddPart(actor);
    prop = assembly;
  }
  else if (frame == Frame::Level)
  {
    level->AddLOD(mapper, 0.0);
    prop = level;
  }
  prop->SetUserMatrix(place);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), casts ? 1 : 0);
  prop->SetPropertyKeys(keys);
  scene.Renderer->AddViewProp(prop);
  scene.Window->Render();
  return scene.Render();
}

// The largest difference beside the splats themselves, which end rays inside of other props only;
// over the largest value.
double CompareBeside(const Buffers& a, const Buffers& b, const char* name)
{
  const auto get = [](const Buffers& buffers, const char* buffer) {
    return static_cast<float*>(buffers.at(buffer)->GetScalarPointer());
  };
  double largest = 0.0;
  double difference = 0.0;
  int compared = 0;
  const vtkIdType count = a.at(name)->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (std::abs(get(a, "Depth")[i] - get(b, "Depth")[i]) < 1e-4)
    {
      ++compared;
      largest = std::max<double>(largest, get(a, name)[i]);
      difference = std::max<double>(difference, std::abs(get(a, name)[i] - get(b, name)[i]));
    }
  }
  Check(compared > 0.6 * static_cast<double>(count), "most pixels are beside the splats");
  return difference / largest;
}

void TestPointGaussians(bool seen)
{
  const std::string where = seen ? ", in view" : ", not in view";
  const Buffers actor = DrawPointGaussians(Frame::Actor, seen);
  const Buffers none = DrawPointGaussians(Frame::Actor, seen, false);
  const double shadow = CompareBeside(none, actor, "LitLength");
  Check(shadow > 0.1, Text("splats cast a shadow", where, ": ", shadow));
  const std::pair<Frame, const char*> frames[] = { { Frame::Assembly, "splats in an assembly" },
    { Frame::Level, "splats as a level of detail" } };
  for (const auto& frame : frames)
  {
    const std::string name = frame.second + where;
    const Buffers inside = DrawPointGaussians(frame.first, seen);
    for (const char* buffer : { "LitLength", "BoundaryCount" })
    {
      const double error = CompareBeside(actor, inside, buffer);
      Check(error < 1e-3, Text(name, " cast as an actor's: ", buffer, " is off by ", error));
    }
    const Buffers quiet = DrawPointGaussians(frame.first, seen, false);
    Check(CompareBeside(none, quiet, "LitLength") < 1e-3, name + ", kept from casting");
  }
}
}

//------------------------------------------------------------------------------
int TestShadowParts(int, char*[])
{
  for (const bool automatic : { false, true })
  {
    TestLevels(0, automatic, true);
    TestLevels(1, automatic, true);
  }
  TestLevels(1, false, false);
  TestLevels(0, true, false);
  TestImageLevel();
  TestGlyphPart(false);
  TestGlyphPart(true);
  TestPointGaussians(true);
  TestPointGaussians(false);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
