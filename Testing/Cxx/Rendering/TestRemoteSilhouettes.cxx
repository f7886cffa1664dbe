// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A scene in two parts, as two processes have them: each draws its own part with the shadows of
// both, and the nearer pixel of the two is that of the whole scene.

#include "AirlightTestBuffers.h"
#include "AirlightTestErrors.h"
#include "AirlightTestScene.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkIdList.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace airlight_test;

namespace
{
void AddBall(Scene& scene, double x, double y, double z, double radius)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(x, y, z);
  ball->SetRadius(radius);
  ball->SetThetaResolution(20);
  ball->SetPhiResolution(13);
  scene.Add(ball);
}

void AddFirstPart(Scene& scene)
{
  scene.Add(MakeSoup({ { { -8, -2, -6 }, { 8, -2, -6 }, { 8, -2, 8 } },
    { { -8, -2, -6 }, { 8, -2, 8 }, { -8, -2, 8 } } }));
  AddBall(scene, -2.0, 0.0, 0.0, 0.8);
  AddBall(scene, 1.2, 0.6, -2.0, 0.7);
}

// An open sheet casts as well as bodies do.
void AddSecondPart(Scene& scene)
{
  AddBall(scene, 2.0, -0.3, 1.0, 0.7);
  AddBall(scene, -1.0, 1.2, 2.0, 0.4);
  scene.Add(MakeSoup({ { { -0.5, -1.0, -1.0 }, { 0.7, -1.1, -0.5 }, { 0.2, 1.0, -1.2 } } }));
}

//------------------------------------------------------------------------------
// The whole scene and its two parts, all with the same lights and camera.
struct Parts
{
  Scene Whole;
  Scene First;
  Scene Second;

  Parts()
  {
    AddFirstPart(this->Whole);
    AddSecondPart(this->Whole);
    AddFirstPart(this->First);
    AddSecondPart(this->Second);
  }

  template <typename Action>
  void ForEach(const Action& action)
  {
    for (Scene* scene : { &this->Whole, &this->First, &this->Second })
    {
      action(*scene);
    }
  }

  vtkIdType Exchange()
  {
    vtkNew<vtkUnsignedCharArray> first;
    vtkNew<vtkUnsignedCharArray> second;
    Check(this->First.Pass->GetSilhouettes(this->First.Renderer, first), "silhouettes");
    Check(this->Second.Pass->GetSilhouettes(this->Second.Renderer, second), "silhouettes");
    this->First.Pass->RemoveAllRemoteSilhouettes();
    this->Second.Pass->RemoveAllRemoteSilhouettes();
    Check(this->First.Pass->AddRemoteSilhouettes(second), "silhouettes are taken");
    Check(this->Second.Pass->AddRemoteSilhouettes(first), "silhouettes are taken");
    return first->GetNumberOfValues() + second->GetNumberOfValues();
  }
};

double Get(const Buffers& buffers, const char* name, vtkIdType i, int component = 0)
{
  return buffers.at(name)->GetPointData()->GetScalars()->GetComponent(i, component);
}

// Of the two parts that whose surface is nearer.
const Buffers& GetNearer(const Buffers& a, const Buffers& b, vtkIdType i)
{
  const double ta = Get(a, "Depth", i);
  const double tb = Get(b, "Depth", i);
  return tb < 0.0 || (ta >= 0.0 && ta <= tb) ? a : b;
}

//------------------------------------------------------------------------------
// Rasterised on other paths, single pixels on edges may fall on the other side.
void Compare(const std::string& what, Parts& parts, double shadowed)
{
  const Buffers whole = parts.Whole.Render();
  const Buffers first = parts.First.Render();
  const Buffers second = parts.Second.Render();
  const vtkIdType count = whole.at("Depth")->GetNumberOfPoints();
  vtkIdType off = 0;
  vtkIdType dark = 0;
  double worst = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Buffers& nearer = GetNearer(first, second, i);
    double difference = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double expected = Get(whole, "Radiance", i, c);
      difference = std::max(
        difference, std::abs(Get(nearer, "Radiance", i, c) - expected) / std::max(expected, 1e-3));
    }
    dark += Get(whole, "BoundaryCount", i) > 0.0 ? 1 : 0;
    off += difference > 2e-5 ? 1 : 0;
    worst = std::max(worst, difference);
  }
  std::cout << what << ": " << off << " of " << count << " pixels differ, at most by " << worst
            << "; " << dark << " with shadows before them\n";
  Check(off <= count / 5000, what + ": the parts' picture is that of the whole scene");
  Check(dark > shadowed * count, what + ": there are shadows");
}

//------------------------------------------------------------------------------
void TestPictures()
{
  Parts parts;
  parts.ForEach([](Scene& scene) {
    scene.AddPointLight({ 1, 4, 3 });
    scene.AddPointLight({ -5, 2, -4 }, { 10.0, 20.0, 30.0 });
  });
  const vtkIdType bytes = parts.Exchange();
  std::cout << bytes << " bytes\n";
  // Five bodies of 480 triangles each, of 36 bytes at least.
  Check(bytes < 2 * 5 * 480 * 36, "silhouettes are smaller than the triangles are");
  Compare("point lights", parts, 0.2);

  parts.ForEach([](Scene& scene) { scene.Lights[0]->SetPosition(-1, 5, 2); });
  parts.Exchange();
  Compare("after a light moved", parts, 0.2);

  // In the shadow of a ball of the second part.
  parts.ForEach([](Scene& scene) {
    scene.Lights[0]->SetPosition(2.0, -0.3, -3.0);
    scene.Look({ 2.0, -0.3, 4.0 }, { 0, 0, 0 });
  });
  parts.Exchange();
  Compare("an eye in shadow", parts, 0.2);

  parts.ForEach([](Scene& scene) {
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(3.0);
  });
  parts.Exchange();
  Compare("parallel projection", parts, 0.2);
}

void TestSun()
{
  Parts parts;
  parts.ForEach([](Scene& scene) {
    scene.Medium->SetRegionToBox();
    scene.Medium->SetBounds(-9, 9, -3, 4, -7, 9);
    scene.AddDirectionalLight({ 0.4, 1.0, 0.3 });
  });
  parts.Exchange();
  Compare("sun", parts, 0.05);

  // The second part's own shadows alone.
  parts.Second.Pass->RemoveAllRemoteSilhouettes();
  Scene alone;
  AddSecondPart(alone);
  alone.Medium->SetRegionToBox();
  alone.Medium->SetBounds(-9, 9, -3, 4, -7, 9);
  alone.AddDirectionalLight({ 0.4, 1.0, 0.3 });
  alone.Window->Render();
  parts.Second.Window->Render();
  CheckSame(alone.CopyBuffers(), parts.Second.CopyBuffers(), "without the others' silhouettes");
}

// Some of the triangles of a ball.
vtkSmartPointer<vtkPolyData> CutBall(bool upper)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1.2);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(19);
  ball->Update();
  vtkPolyData* whole = ball->GetOutput();
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(whole->GetPoints());
  part->AllocateExact(whole->GetNumberOfCells(), 3);
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < whole->GetNumberOfCells(); ++cell)
  {
    whole->GetCellPoints(cell, points);
    if ((whole->GetPoint(points->GetId(0))[0] > 0.1) == upper)
    {
      part->InsertNextCell(VTK_TRIANGLE, points);
    }
  }
  return part;
}

// The borders of a body that is cut into two parts cancel out: rays meet as many boundaries as with
// the whole body, where they would be far more.
void TestCut()
{
  Scene whole;
  Scene first;
  Scene second;
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(CutBall(false));
  both->AddInputData(CutBall(true));
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputConnection(both->GetOutputPort());
  joined->PointMergingOn();
  joined->SetTolerance(0.0);
  joined->Update();
  whole.Add(joined->GetOutput());
  first.Add(CutBall(false));
  second.Add(CutBall(true));
  for (Scene* scene : { &whole, &first, &second })
  {
    scene->AddPointLight({ 2, 4, 3 });
  }
  const Buffers alone = first.Render();
  vtkNew<vtkUnsignedCharArray> bytes;
  second.Pass->GetSilhouettes(second.Renderer, bytes);
  Check(first.Pass->AddRemoteSilhouettes(bytes), "silhouettes are taken");
  const Buffers expected = whole.Render();
  const Buffers found = first.Render();
  double sums[3] = { 0.0, 0.0, 0.0 };
  double worst = 0.0;
  for (vtkIdType i = 0; i < expected.at("Depth")->GetNumberOfPoints(); ++i)
  {
    if (Get(expected, "Depth", i) < 0.0)
    {
      sums[0] += Get(expected, "BoundaryCount", i);
      sums[1] += Get(found, "BoundaryCount", i);
      sums[2] += Get(alone, "BoundaryCount", i);
      const double airlight = Get(expected, "Airlight", i);
      worst = std::max(worst, std::abs(Get(found, "Airlight", i) - airlight) / airlight);
    }
  }
  std::cout << "a ball that is cut: " << sums[0] << " boundaries of the whole, " << sums[1]
            << " of its parts, " << sums[2] << " of one of them; airlight is at most " << worst
            << " off\n";
  Check(sums[0] > 1000.0 && sums[1] == sums[0], "no boundaries along the cut");
  Check(worst < 2e-5, "the airlight is that of the whole ball");
}

// What casts no shadow of its own is drawn with those of the others.
void TestNothingOfItsOwn()
{
  Parts parts;
  Scene empty;
  parts.ForEach([](Scene& scene) { scene.AddPointLight({ 1, 4, 3 }); });
  empty.AddPointLight({ 1, 4, 3 });
  for (Scene* scene : { &parts.First, &parts.Second })
  {
    vtkNew<vtkUnsignedCharArray> bytes;
    scene->Pass->GetSilhouettes(scene->Renderer, bytes);
    Check(empty.Pass->AddRemoteSilhouettes(bytes), "silhouettes are taken");
  }
  const Buffers whole = parts.Whole.Render();
  const Buffers none = empty.Render();
  vtkIdType compared = 0;
  double worst = 0.0;
  for (vtkIdType i = 0; i < whole.at("Depth")->GetNumberOfPoints(); ++i)
  {
    if (Get(whole, "Depth", i) < 0.0)
    {
      const double expected = Get(whole, "Airlight", i);
      worst = std::max(worst, std::abs(Get(none, "Airlight", i) - expected) / expected);
      compared++;
    }
  }
  std::cout << "background: " << compared << " pixels, at most " << worst << " off\n";
  Check(compared > 1000 && worst < 2e-5, "shadows of others before the background");
}

//------------------------------------------------------------------------------
void Expect(ErrorListener& listener, const std::string& part)
{
  const bool once = listener.Take() == 1;
  Check(once && listener.GetText().find(part) != std::string::npos,
    "one error that says: " + part + "; there was " + listener.GetText());
}

void TestErrors()
{
  Parts parts;
  parts.ForEach([](Scene& scene) { scene.AddPointLight({ 1, 4, 3 }); });
  vtkAirlightPass* pass = parts.First.Pass;
  ErrorListener listener(pass);
  vtkNew<vtkUnsignedCharArray> bytes;
  Check(!pass->GetSilhouettes(nullptr, bytes), "no renderer");
  Expect(listener, "needs a renderer");
  Check(!pass->GetSilhouettes(parts.First.Renderer, nullptr), "no array");
  Expect(listener, "null");
  vtkNew<vtkRenderer> loose;
  Check(!pass->GetSilhouettes(loose, bytes) && bytes->GetNumberOfValues() == 0, "no window");
  Expect(listener, "without a window");
  Check(!pass->AddRemoteSilhouettes(nullptr), "null");
  Expect(listener, "null");
  Check(!pass->AddRemoteSilhouettes(bytes), "empty");
  Expect(listener, "0 bytes");

  parts.Second.Pass->GetSilhouettes(parts.Second.Renderer, bytes);
  const vtkIdType size = bytes->GetNumberOfValues();
  for (vtkIdType cut = 1; cut < size; cut += 97)
  {
    vtkNew<vtkUnsignedCharArray> part;
    part->DeepCopy(bytes);
    part->SetNumberOfValues(cut);
    Check(!pass->AddRemoteSilhouettes(part), "cut short");
    Expect(listener, "bytes");
  }
  vtkNew<vtkUnsignedCharArray> wrong;
  wrong->DeepCopy(bytes);
  for (vtkIdType i = size - 48; i < size; ++i)
  {
    wrong->SetValue(i, 0xff); // not numbers
  }
  Check(!pass->AddRemoteSilhouettes(wrong), "not numbers");
  Expect(listener, "not numbers");

  // A weight that no edge has: that of the first one, behind 16 bytes for all and 80 for its light.
  wrong->DeepCopy(bytes);
  const float weight = 3.0f;
  std::memcpy(wrong->GetPointer(16 + 80 + 3 * sizeof(float)), &weight, sizeof(weight));
  Check(!pass->AddRemoteSilhouettes(wrong), "an edge that is too heavy");
  Expect(listener, "not numbers");

  // What was made for another place of the light is left out.
  Check(pass->AddRemoteSilhouettes(bytes), "silhouettes are taken");
  parts.First.Lights[0]->SetPosition(3, 4, 3);
  const Buffers buffers = parts.First.Render();
  pass->RemoveAllRemoteSilhouettes();
  CheckSame(buffers, parts.First.Render(), "silhouettes of another light");
}
}

//------------------------------------------------------------------------------
int TestRemoteSilhouettes(int, char*[])
{
  TestPictures();
  TestSun();
  TestCut();
  TestNothingOfItsOwn();
  TestErrors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
