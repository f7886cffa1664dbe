// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances that programs of their own draw (AirlightStageVariants.h) are to the last bit
// those of the mappers' programs, whatever the mapper draws; and where there is no such program,
// the mapper's own draws them. The programs follow changes of the mappers' programs, are made again
// after a release, and are right for all actors of a mapper.

#include "AirlightTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUniforms.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// Draws as its parent does. The pass does not know such a class, so its mapper's own program draws
// the distances.
class OwnMapper : public vtkOpenGLPolyDataMapper
{
public:
  static OwnMapper* New();
  vtkTypeMacro(OwnMapper, vtkOpenGLPolyDataMapper);
};

using Change = std::function<void(vtkActor*, vtkPolyDataMapper*)>;

// Counts the drawings of which another program than the mapper's is bound right before.
class DepthScene : public Scene
{
public:
  DepthScene()
    : Scene(100, 75)
  {
    this->AddPointLight({ 2.0, 4.0, 3.0 });
    this->AddPointLight({ -3.0, 2.0, 4.0 });
    this->Count->SetClientData(this);
    this->Count->SetCallback([](vtkObject*, unsigned long, void* client, void* program) {
      auto* self = static_cast<DepthScene*>(client);
      auto* window = vtkOpenGLRenderWindow::SafeDownCast(self->Window);
      self->Others += window->GetShaderCache()->GetLastShaderBound() != program ? 1 : 0;
    });
  }

  // After all other observers.
  void Watch(vtkPolyDataMapper* mapper)
  {
    mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->Count, -1e6f);
  }

  int Others = 0;
  vtkNew<vtkCallbackCommand> Count;
};

//------------------------------------------------------------------------------
OwnMapper* OwnMapper::New() { VTK_STANDARD_NEW_BODY(OwnMapper); }

//------------------------------------------------------------------------------
// The picture's distances with an actor whose mapper is of this class.
vtkSmartPointer<vtkImageData> GetDepths(
  vtkPolyDataMapper* mapper, vtkPolyData* data, const Change& change, int& others)
{
  DepthScene scene;
  mapper->SetInputData(data);
  vtkSmartPointer<vtkActor> actor = Scene::MakeActor(mapper);
  actor->SetPosition(0.3, -0.2, 0.4);
  actor->RotateWXYZ(30.0, 1.0, 0.3, 0.2);
  change(actor, mapper);
  scene.Renderer->AddActor(actor);
  scene.Watch(mapper);
  scene.Window->Render();
  // The second frame has the programs that the first one made.
  scene.Renderer->GetActiveCamera()->Azimuth(7.0);
  scene.Others = 0;
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(scene.Render().at("Depth"));
  others = scene.Others;
  return copy;
}

//------------------------------------------------------------------------------
int CountSurface(vtkImageData* depths)
{
  int count = 0;
  for (int y = 0; y < 75; ++y)
  {
    for (int x = 0; x < 100; ++x)
    {
      count += GetValue(depths, x, y) > 0.0 ? 1 : 0;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
// `programs`: the drawings of a frame that have a program for distances alone.
void CompareDistances(
  const std::string& name, vtkPolyData* data, int programs, const Change& change)
{
  int ours = 0;
  int others = 0;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<OwnMapper> own;
  const vtkSmartPointer<vtkImageData> a = GetDepths(mapper, data, change, ours);
  const vtkSmartPointer<vtkImageData> b = GetDepths(own, data, change, others);
  const int pixels = CountSurface(a);
  std::cout << name << ": " << pixels << " pixels, " << ours << " programs for distances\n";
  Check(AreSame(a, b), name + ": the same distances");
  Check(pixels > 50, name + ": there is something to see");
  Check(ours == programs, name + ": " + std::to_string(programs) + " programs for distances");
  Check(others == 0, name + ": an unknown class keeps its program");
}

//------------------------------------------------------------------------------
// Vertices, lines, triangles and strips, each drawn on its own.
vtkSmartPointer<vtkPolyData> MakeAllKinds()
{
  const double corners[8][3] = { { -2, -2, 0 }, { 0, -2, 0 }, { -2, 0, 0 }, { 0, 0, 1 },
    { 0.5, 0.5, 0 }, { 2, 2, 1 }, { 2, -2, 0 }, { 2, -1, 0 } };
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  const vtkIdType vertices[2] = { 6, 7 };
  const vtkIdType line[2] = { 4, 5 };
  const vtkIdType triangle[3] = { 0, 1, 2 };
  const vtkIdType strip[4] = { 1, 2, 3, 4 };
  const auto cells = [](vtkIdType count, const vtkIdType* ids) {
    vtkNew<vtkCellArray> array;
    array->InsertNextCell(count, ids);
    return vtkSmartPointer<vtkCellArray>(array);
  };
  data->SetPoints(points);
  data->SetVerts(cells(2, vertices));
  data->SetLines(cells(2, line));
  data->SetPolys(cells(3, triangle));
  data->SetStrips(cells(4, strip));
  return data;
}

void SetTexture(vtkActor* actor)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  image->GetPointData()->GetScalars()->Fill(255.0);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  actor->SetTexture(texture);
}

//------------------------------------------------------------------------------
void TestData()
{
  const vtkSmartPointer<vtkPolyData> ball = MakeSphere(2.0);
  vtkSmartPointer<vtkPolyData> bare = MakeSphere(2.0);
  bare->GetPointData()->SetNormals(nullptr);
  vtkNew<vtkFloatArray> heights;
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(ball->GetPoint(i)[1]));
  }
  vtkSmartPointer<vtkPolyData> coloured = MakeSphere(2.0);
  coloured->GetPointData()->SetScalars(heights);
  vtkSmartPointer<vtkPolyData> cells = MakeSphere(2.0);
  vtkNew<vtkFloatArray> numbers;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<float>(i));
  }
  cells->GetCellData()->SetScalars(numbers);
  const Change none = [](vtkActor*, vtkPolyDataMapper*) {};
  const Change colours = [](vtkActor* actor, vtkPolyDataMapper* mapper) {
    mapper->ScalarVisibilityOn();
    mapper->SetScalarRange(-2.0, 200.0);
    actor->GetProperty()->SetInterpolationToGouraud();
  };
  CompareDistances("a ball", ball, 1, none);
  CompareDistances("without normals", bare, 1, none);
  CompareDistances("smooth", ball, 1,
    [](vtkActor* actor, vtkPolyDataMapper*) { actor->GetProperty()->SetInterpolationToPhong(); });
  CompareDistances("colours of points", coloured, 1, colours);
  CompareDistances("colours of cells", cells, 1, colours);
  CompareDistances(
    "all kinds of cells", MakeAllKinds(), 4, [](vtkActor* actor, vtkPolyDataMapper*) {
      actor->GetProperty()->SetPointSize(9.0);
      actor->GetProperty()->SetLineWidth(3.0);
    });
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.0, -2.0, 0.0);
  plane->SetPoint1(2.0, -2.0, 0.0);
  plane->SetPoint2(-2.0, 2.0, 0.0);
  // A texel may be transparent, where the mapper's program discards the fragment.
  CompareDistances(
    "a texture", Make(plane), 0, [](vtkActor* actor, vtkPolyDataMapper*) { SetTexture(actor); });
}

//------------------------------------------------------------------------------
void TestProperties()
{
  const vtkSmartPointer<vtkPolyData> ball = MakeSphere(2.0);
  CompareDistances("a wireframe", ball, 1, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->GetProperty()->SetRepresentationToWireframe();
  });
  CompareDistances("wide lines", ball, 0, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->GetProperty()->SetRepresentationToWireframe();
    actor->GetProperty()->SetRenderLinesAsTubes(true);
    actor->GetProperty()->SetLineWidth(4.0);
  });
  CompareDistances("points", ball, 1, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->GetProperty()->SetRepresentationToPoints();
    actor->GetProperty()->SetPointSize(4.0);
  });
  CompareDistances("a specular surface", ball, 1, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->GetProperty()->SetSpecular(0.5);
    actor->GetProperty()->SetInterpolationToPBR();
  });
  CompareDistances("a clipping plane", ball, 0, [](vtkActor*, vtkPolyDataMapper* mapper) {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(1.0, 0.2, 0.0);
    mapper->AddClippingPlane(plane);
  });
  // There the mapper keeps corners relative to another place.
  vtkNew<vtkSphereSource> far;
  far->SetCenter(1000.0, 0.0, 0.0);
  far->SetRadius(2.0);
  CompareDistances("far from the origin", Make(far), 1, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->SetOrientation(0.0, 0.0, 0.0);
    actor->SetPosition(-1000.0, 0.0, 0.0);
  });
}

//------------------------------------------------------------------------------
// Shaders of the user's that move vertices by a uniform, set by the property or by an observer.
void TestShaders()
{
  const auto move = [](vtkActor* actor, const char* declaration) {
    vtkShaderProperty* shaders = actor->GetShaderProperty();
    shaders->AddVertexShaderReplacement(
      "//VTK::PositionVC::Dec", true, std::string("//VTK::PositionVC::Dec\n") + declaration, false);
    shaders->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
      "//VTK::PositionVC::Impl\n  gl_Position.x += moved * gl_Position.w;\n", false);
  };
  const vtkSmartPointer<vtkPolyData> ball = MakeSphere(2.0);
  CompareDistances("a uniform of the property", ball, 1, [&](vtkActor* actor, vtkPolyDataMapper*) {
    move(actor, "");
    actor->GetShaderProperty()->GetVertexCustomUniforms()->SetUniformf("moved", 0.3f);
  });
  CompareDistances(
    "a uniform of an observer", ball, 1, [&](vtkActor* actor, vtkPolyDataMapper* mapper) {
      move(actor, "uniform float moved;\n");
      vtkNew<vtkCallbackCommand> set;
      set->SetCallback([](vtkObject*, unsigned long, void*, void* program) {
        if (program)
        {
          static_cast<vtkShaderProgram*>(program)->SetUniformf("moved", -0.4f);
        }
      });
      mapper->AddObserver(vtkCommand::UpdateShaderEvent, set);
    });
}

//------------------------------------------------------------------------------
// Programs go with the window's resources, and other ones come to where they were.
void TestReleases()
{
  DepthScene scene;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeSphere(2.0));
  vtkSmartPointer<vtkActor> actor = Scene::MakeActor(mapper);
  scene.Renderer->AddActor(actor);
  scene.Watch(mapper);
  vtkNew<vtkImageData> first;
  first->DeepCopy(scene.Render().at("Depth"));
  for (int i = 0; i < 5; ++i)
  {
    actor->GetProperty()->SetInterpolation(i % 3);
    scene.Window->Finalize();
    scene.Others = 0;
    const Buffers buffers = scene.Render();
    Check(scene.Others == 1, "a program for distances after a release");
    Check(AreSame(first, buffers.at("Depth")), "the same distances after a release");
  }
}

//------------------------------------------------------------------------------
// Two actors of one mapper, and a parallel projection in between.
void TestSharing()
{
  const auto draw = [](vtkPolyDataMapper* mapper) {
    DepthScene scene;
    mapper->SetInputData(MakeSphere(1.0));
    for (const double x : { -1.5, 1.5 })
    {
      vtkSmartPointer<vtkActor> actor = Scene::MakeActor(mapper);
      actor->SetPosition(x, 0.0, x);
      scene.Renderer->AddActor(actor);
    }
    std::vector<Buffers> all;
    for (const bool parallel : { false, true, false })
    {
      scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
      all.push_back(scene.Render());
    }
    return all;
  };
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<OwnMapper> own;
  const std::vector<Buffers> a = draw(mapper);
  const std::vector<Buffers> b = draw(own);
  for (size_t i = 0; i < a.size(); ++i)
  {
    Check(AreSame(a[i].at("Depth"), b[i].at("Depth")), "two actors of one mapper");
  }
}
}

//------------------------------------------------------------------------------
int TestDepthPrePass(int, char*[])
{
  TestData();
  TestProperties();
  TestShaders();
  TestReleases();
  TestSharing();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
