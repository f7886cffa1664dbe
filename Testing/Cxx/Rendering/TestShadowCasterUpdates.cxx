// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes whose geometry is swapped, as animations do: each frame is that of a pass that knows
// nothing of the frames before, also where the new points, polygons or strips are older than what
// they replace.
//
// Casters that a shadow map draws with their mappers, point Gaussians here: the map is drawn again
// when anything changes that they are drawn from, as a pass draws it that knows nothing of the
// frames before, and only then.

#include "AirlightTestScene.h"
#include "AirlightTestWindowScene.h"
#include "Casters/AirlightNonPolygonalCaster.h"

#include "vtkAssembly.h"
#include "vtkCallbackCommand.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLPointGaussianMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkShaderProperty.h"
#include "vtkStripper.h"

#include <functional>
#include <iostream>

using namespace airlight_test;
using airlight::NonPolygonalCaster;

namespace
{
vtkSmartPointer<vtkPolyData> MakeBall(double x, bool strips)
{
  vtkSmartPointer<vtkPolyData> ball = MakeSphere(0.8);
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    double p[3];
    ball->GetPoint(i, p);
    ball->GetPoints()->SetPoint(i, p[0] + x, p[1], p[2]);
  }
  if (!strips)
  {
    return ball;
  }
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(ball);
  stripper->Update();
  return stripper->GetOutput();
}

// A ball over a floor.
struct BallScene : Scene
{
  explicit BallScene(vtkPolyData* ball)
    : Scene(80, 60)
  {
    vtkNew<vtkCubeSource> floor;
    floor->SetBounds(-6, 6, -2.1, -2, -6, 6);
    this->Add(floor);
    this->Add(ball);
    this->AddPointLight({ 0.5, 4.0, 1.0 });
  }
};

vtkSmartPointer<vtkPolyData> ShareGeometry(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(data->GetPoints());
  copy->SetPolys(data->GetPolys());
  copy->SetStrips(data->GetStrips());
  return copy;
}

// Draws a mesh before and after a change, which has to be seen.
void TestMeshChange(
  const std::string& what, vtkPolyData* mesh, const std::function<void(vtkPolyData*)>& change)
{
  BallScene scene(mesh);
  const Buffers before = scene.Render();
  change(mesh);
  const Buffers after = scene.Render();
  BallScene fresh(ShareGeometry(mesh));
  const double changed = CompareBuffers(before.at("Airlight"), after.at("Airlight"));
  const double wrong = CompareBuffers(fresh.Render(), after);
  std::cout << what << ": changes airlight by " << changed << ", off by " << wrong << "\n";
  Check(changed > 1e-3, what + ": the shadow moves");
  Check(wrong == 0.0, what + ": the frame is that of a new pass");
}

void TestMeshes()
{
  for (const bool strips : { false, true })
  {
    const std::string kind = strips ? "strips" : "polygons";
    // In the order of their times: what is made first is oldest.
    const vtkSmartPointer<vtkPolyData> right = MakeBall(1.5, strips);
    const vtkSmartPointer<vtkPolyData> left = MakeBall(-1.5, strips);
    (strips ? left->GetStrips() : left->GetPolys())->Modified();
    TestMeshChange(kind + ", older points", left,
      [&](vtkPolyData* mesh) { mesh->SetPoints(right->GetPoints()); });
    TestMeshChange(kind + ", newer points", right,
      [&](vtkPolyData* mesh) { mesh->SetPoints(MakeBall(-1.5, strips)->GetPoints()); });

    const vtkSmartPointer<vtkPolyData> half = MakeBall(0.0, strips);
    vtkNew<vtkCellArray> some;
    vtkCellArray* cells = strips ? half->GetStrips() : half->GetPolys();
    for (vtkIdType i = 0; i < cells->GetNumberOfCells() / 2; ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(i, size, ids);
      some->InsertNextCell(size, ids);
    }
    const vtkSmartPointer<vtkPolyData> whole = MakeBall(0.0, strips);
    whole->GetPoints()->Modified();
    TestMeshChange(kind + ", older cells", whole,
      [&](vtkPolyData* mesh) { strips ? mesh->SetStrips(some) : mesh->SetPolys(some); });
  }
}

//------------------------------------------------------------------------------
// Counts how often it is drawn.
class CountingMapper : public vtkOpenGLPointGaussianMapper
{
public:
  static CountingMapper* New();
  vtkTypeMacro(CountingMapper, vtkOpenGLPointGaussianMapper);
  void Render(vtkRenderer* renderer, vtkActor* actor) override
  {
    ++this->Count;
    this->Superclass::Render(renderer, actor);
  }
  int Count = 0;
};
vtkStandardNewMacro(CountingMapper);

// Two Gaussians above a floor, in an assembly.
struct GaussianScene : Scene
{
  GaussianScene()
    : Scene(120, 90)
  {
    this->Pass->SetShadowTechniqueToShadowMap();
    this->AddPointLight({ 0.5, 9.0, 0.5 }, glm::dvec3(90.0));
    vtkNew<vtkCubeSource> floor;
    floor->SetBounds(-6, 6, -2.1, -2, -6, 6);
    this->Add(floor);
    this->Points->InsertNextPoint(0.0, 0.0, 0.0);
    this->Points->InsertNextPoint(1.0, 0.3, 0.2);
    vtkNew<vtkPolyData> data;
    data->SetPoints(this->Points);
    this->Mapper->SetInputData(data);
    this->Mapper->SetScaleFactor(0.8);
    this->Actor->SetMapper(this->Mapper);
    this->Assembly->AddPart(this->Actor);
    this->Renderer->AddActor(this->Assembly);
  }

  vtkNew<vtkPoints> Points;
  vtkNew<CountingMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkAssembly> Assembly;
};

void TestGaussianChange(
  GaussianScene& scene, const std::string& what, const std::function<void(GaussianScene&)>& change)
{
  const Buffers before = scene.Render();
  change(scene);
  const Buffers after = scene.Render();
  scene.Pass->ReleaseGraphicsResources(scene.Window); // which forgets all frames
  const Buffers fresh = scene.Render();
  const double changed = CompareBuffers(before.at("Airlight"), after.at("Airlight"));
  const double wrong = CompareBuffers(fresh, after);
  std::cout << what << ": changes airlight by " << changed << ", off by " << wrong << "\n";
  Check(changed > 1e-3, what + ": the shadow changes");
  Check(wrong == 0.0, what + ": the frame is that of a new pass");
}

void TestGaussians()
{
  GaussianScene scene;
  TestGaussianChange(scene, "scale", [](GaussianScene& s) { s.Mapper->SetScaleFactor(0.5); });
  TestGaussianChange(scene, "points", [](GaussianScene& s) {
    s.Points->SetPoint(1, -1.0, 0.5, 0.0);
    s.Points->Modified();
  });
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName("sizes");
  sizes->InsertNextValue(1.0);
  sizes->InsertNextValue(1.0);
  scene.Mapper->GetInput()->GetPointData()->AddArray(sizes);
  scene.Mapper->SetScaleArray("sizes");
  vtkNew<vtkPiecewiseFunction> scale;
  scale->AddPoint(0.0, 0.2);
  scale->AddPoint(2.0, 0.2);
  TestGaussianChange(
    scene, "scale function", [&](GaussianScene& s) { s.Mapper->SetScaleFunction(scale); });
  TestGaussianChange(scene, "values of the scale function", [&](GaussianScene&) {
    scale->AddPoint(0.0, 0.8);
    scale->AddPoint(2.0, 0.8);
  });
  scene.Mapper->SetScaleFunction(nullptr);
  scene.Mapper->SetScaleArray(nullptr);
  TestGaussianChange(scene, "part", [](GaussianScene& s) { s.Actor->AddPosition(0.5, 0.0, 0.0); });
  TestGaussianChange(
    scene, "assembly", [](GaussianScene& s) { s.Assembly->AddPosition(0.0, 0.0, 0.8); });
  TestGaussianChange(scene, "shape", [](GaussianScene& s) {
    s.Mapper->SetSplatShaderCode("//VTK::Color::Impl\n"
                                 "if (abs(offsetVCVSOutput.x) > 0.3) { discard; }\n");
  });
  TestGaussianChange(scene, "shader", [](GaussianScene& s) {
    s.Actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
      "//VTK::Color::Impl\nif (offsetVCVSOutput.y > 0.2) { discard; }\n", false);
  });
  TestGaussianChange(scene, "visibility", [](GaussianScene& s) { s.Assembly->VisibilityOff(); });
}

//------------------------------------------------------------------------------
// The map is kept while the camera turns.
void TestResting()
{
  GaussianScene scene;
  const auto count = [&scene] {
    scene.Mapper->Count = 0;
    scene.Renderer->GetActiveCamera()->Azimuth(0.5);
    scene.Window->Render();
    return scene.Mapper->Count;
  };
  const int first = count();
  count(); // the first frame modifies the mapper
  const int resting = count();
  scene.Points->Modified();
  const int changed = count();
  std::cout << "drawn " << first << " times at first, at rest " << resting << "\n";
  Check(resting < first, "the map is not drawn again at rest");
  Check(changed == first, "it is after a change");
}

//------------------------------------------------------------------------------
// Where nothing tells whether what is drawn changed, it may have.
void TestUnknown()
{
  GaussianScene scene;
  const auto make = [&scene] {
    return NonPolygonalCaster(scene.Actor, scene.Actor, scene.Actor->GetMatrix());
  };
  const NonPolygonalCaster caster = make();
  Check(caster.DrawsAs(make()), "the same while nothing changes");
  scene.Actor->GetProperty()->SetOpacity(0.9);
  Check(!make().DrawsAs(caster), "another opacity");
  Check(make().DrawsAs(make()), "and then the same");
  vtkNew<vtkMatrix4x4> place;
  const NonPolygonalCaster part(scene.Actor, scene.Assembly, place);
  Check(!part.DrawsAs(make()), "a part");
  place->SetElement(0, 3, 1.0);
  Check(!NonPolygonalCaster(scene.Actor, scene.Assembly, place).DrawsAs(part), "another place");
  vtkNew<vtkCallbackCommand> observer;
  scene.Mapper->AddObserver(vtkCommand::UpdateShaderEvent, observer);
  Check(!make().DrawsAs(make()), "an observer that may set uniforms");
  scene.Mapper->RemoveAllObservers();
  Check(make().DrawsAs(make()), "no observer");
  vtkNew<vtkPlane> plane;
  scene.Mapper->AddClippingPlane(plane);
  Check(!make().DrawsAs(make()), "clipping planes, which may move");
  scene.Mapper->RemoveAllClippingPlanes();
  vtkNew<vtkFollower> follower;
  follower->SetMapper(scene.Mapper);
  const NonPolygonalCaster other(follower, follower, follower->GetMatrix());
  Check(!other.DrawsAs(other), "an actor that may draw something else");
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputDataObject(scene.Mapper->GetInput());
  scene.Actor->SetMapper(glyphs);
  Check(!make().DrawsAs(make()), "sources of glyphs");
}
}

//------------------------------------------------------------------------------
int TestShadowCasterUpdates(int, char*[])
{
  TestMeshes();
  TestGaussians();
  TestResting();
  TestUnknown();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
