// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Where shadow planes end behind a floor or a wall, nothing that is seen is lost: all places beyond
// are hidden, and the airlight is the same as where the floor may be looked through as far as is
// known.

#include "AirlightTestCheck.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"
#include "Casters/AirlightCasters.h"
#include "Scene/AirlightCameraRays.h"
#include "ShadowVolumes/AirlightPlanarOccluders.h"

#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

airlight::Caster MakeCaster(vtkPolyData* data, const glm::dmat4& toWorld, const vtkProp* owner)
{
  airlight::Caster caster;
  caster.Mesh = std::make_shared<airlight::CasterMesh>(data);
  caster.Faces =
    std::make_shared<std::vector<airlight::PlanarFace>>(airlight::FindPlanarFaces(*caster.Mesh));
  caster.ToWorld = toWorld;
  caster.Owner = owner;
  return caster;
}

// Around a unit cube or square.
glm::dmat4 RandomPlace(Random& random, const glm::dvec3& centre, double size)
{
  glm::dmat4 matrix(1.0);
  const glm::dmat3 axes = RandomAxes(random);
  for (int i = 0; i < 3; ++i)
  {
    matrix[i] = glm::dvec4(size * random.Uniform(0.3, 2.0) * axes[i], 0.0);
  }
  matrix[3] = glm::dvec4(centre, 1.0);
  return matrix;
}

void PlaceCamera(Random& random, vtkCamera* camera)
{
  const glm::dvec3 position = 10.0 * RandomUnit(random);
  const glm::dvec3 focus = 2.0 * RandomUnit(random);
  const glm::dvec3 up = RandomUnit(random);
  camera->SetPosition(&position.x);
  camera->SetFocalPoint(&focus.x);
  camera->SetViewUp(&up.x);
  camera->SetViewAngle(random.Uniform(10.0, 80.0));
  camera->SetClippingRange(random.LogUniform(0.1, 4.0), random.LogUniform(20.0, 200.0));
}

// Whether the ray from the eye to a point meets one of the triangles before it, in the clipping
// range; true for what is not in the picture.
bool IsHidden(vtkCamera* camera, const std::vector<Triangle>& triangles, const glm::dvec3& point)
{
  if (!IsInPicture(Project(camera, Width / double(Height), point)))
  {
    return true;
  }
  glm::dvec3 eye;
  glm::dvec3 forward;
  camera->GetPosition(&eye.x);
  camera->GetDirectionOfProjection(&forward.x);
  const Ray ray = { eye, glm::normalize(point - eye) };
  for (const Triangle& triangle : triangles)
  {
    const double t = Hit(triangle, ray);
    const double depth = t * glm::dot(forward, ray.Direction);
    if (t < glm::distance(point, eye) && depth > camera->GetClippingRange()[0] &&
      depth < camera->GetClippingRange()[1])
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// A square or a box that is large, a small box that casts, and places behind where its planes end.
class RandomCut
{
public:
  explicit RandomCut(std::uint64_t seed)
    : Numbers(seed)
  {
  }

  void Check()
  {
    vtkNew<vtkCamera> camera;
    PlaceCamera(this->Numbers, camera);
    const airlight::CameraRays rays(camera, Width / double(Height), Width, Height);
    vtkNew<vtkActor> owner;
    const bool isBox = this->Numbers.Index(2) == 0;
    const glm::dvec3 middle = this->Numbers.Uniform(0.0, 3.0) * RandomUnit(this->Numbers);
    const double size = this->Numbers.LogUniform(2.0, 60.0);
    const vtkSmartPointer<vtkPolyData> data =
      isBox ? Make(vtkNew<vtkCubeSource>().Get()) : Make(vtkNew<vtkPlaneSource>().Get());
    const airlight::Caster wall = MakeCaster(data, RandomPlace(this->Numbers, middle, size), owner);
    const glm::dvec3 place = this->Numbers.Uniform(0.0, 4.0) * RandomUnit(this->Numbers);
    const airlight::Caster caster = MakeCaster(Make(vtkNew<vtkCubeSource>().Get()),
      RandomPlace(this->Numbers, place, this->Numbers.LogUniform(0.05, 2.0)), nullptr);
    const glm::dvec3 lamp = this->Numbers.Uniform(1.0, 9.0) * RandomUnit(this->Numbers);
    const glm::dvec4 light(lamp, this->Numbers.Index(2));

    const std::vector<airlight::Caster> casters = { wall, caster };
    const auto faces = airlight::FindPlanarOccluders(casters, { owner }, rays);
    airlight_test::Check(airlight::FindPlanarOccluders(casters, {}, rays).empty(),
      "what may be looked through hides nothing");
    const auto ends = airlight::FindTruncationPlanes(casters, faces, light, rays.GetEye());
    airlight_test::Check(ends.size() == 3 && ends[2] == glm::vec4(0.0f), "one more end, of none");
    ++this->Count;
    this->Faces += !faces.empty();
    this->Cut += ends[1] != glm::vec4(0.0f);
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 16; ++i)
    {
      matrix->SetElement(i % 4, i / 4, wall.ToWorld[i / 4][i % 4]);
    }
    const std::vector<Triangle> triangles = GetTriangles(data, matrix);
    for (int i = 0; i < 100 && ends[1] != glm::vec4(0.0f); ++i)
    {
      this->Lost += !IsHidden(camera, triangles, this->PlaceBehind(caster, light, ends[1], rays));
    }
  }

  int Count = 0;
  int Faces = 0;
  int Cut = 0;
  int Lost = 0;

private:
  // On the ray from the light through a place in the caster, from the plane on.
  glm::dvec3 PlaceBehind(const airlight::Caster& caster, const glm::dvec4& light,
    const glm::vec4& end, const airlight::CameraRays& rays)
  {
    const double x = this->Numbers.Uniform(-0.5, 0.5);
    const double y = this->Numbers.Uniform(-0.5, 0.5);
    const double z = this->Numbers.Uniform(-0.5, 0.5);
    const glm::dvec3 from(caster.ToWorld * glm::dvec4(x, y, z, 1.0));
    const glm::dvec3 away = light.w != 0.0 ? from - glm::dvec3(light) : -glm::dvec3(light);
    const glm::dvec3 normal(end);
    const double height = glm::dot(normal, from - rays.GetEye()) + end.w;
    const double steps = height / -glm::dot(normal, away);
    const double beyond =
      this->Numbers.Index(2) ? 0.0 : this->Numbers.LogUniform(1e-3, 1e3) / glm::length(away);
    return from + (steps + beyond) * away;
  }

  Random Numbers;
};

//------------------------------------------------------------------------------
void CheckRandom()
{
  RandomCut cut(2);
  for (int k = 0; k < 3000; ++k)
  {
    cut.Check();
  }
  std::cout << cut.Count << " walls: " << cut.Faces << " hide enough, " << cut.Cut
            << " end a caster's planes; " << cut.Lost << " of " << 100 * cut.Cut
            << " places behind are seen\n";
  Check(cut.Lost == 0, "what lies behind the ends is hidden");
  Check(cut.Faces > cut.Count / 4 && cut.Cut > cut.Count / 20, "there are enough of them");
}

//------------------------------------------------------------------------------
enum class Look
{
  AsIs,
  Clipped,
  Glass
};

// A room's corner, and a box and a ball that throw their shadows on it. `replaced`: the corner's
// shaders have a replacement.
vtkSmartPointer<vtkImageData> Draw(Look look, bool replaced, bool sun)
{
  Scene scene;
  const auto change = [=](vtkActor* actor) {
    if (replaced)
    {
      MakeUnknown(actor);
    }
    if (look == Look::Clipped)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1.0, 0.0, 0.0);
      actor->GetMapper()->AddClippingPlane(plane);
    }
    if (look == Look::Glass)
    {
      actor->GetProperty()->SetOpacity(0.5);
    }
  };
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-12.0, -2.0, 12.0);
  floor->SetPoint1(12.0, -2.0, 12.0);
  floor->SetPoint2(-12.0, -2.0, -6.0);
  scene.Add(floor, change);
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-12.0, -2.0, -6.0);
  wall->SetPoint1(12.0, -2.0, -6.0);
  wall->SetPoint2(-12.0, 9.0, -6.0);
  scene.Add(wall, change);
  vtkNew<vtkCubeSource> box;
  box->SetCenter(-1.5, -1.0, 0.5);
  scene.Add(box);
  scene.Add(MakeSphere(0.7), [](vtkActor* actor) { actor->SetPosition(1.5, 0.4, 1.0); });
  sun ? scene.AddDirectionalLight({ 0.3, 0.8, 0.5 }) : scene.AddPointLight({ 0.5, 3.0, 4.0 });
  scene.Window->Render();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->DeepCopy(scene.Pass->GetBuffer("Airlight"));
  return image;
}

// Pixels of which one is more than a thousandth brighter than the other.
int CountDifferent(vtkImageData* a, vtkImageData* b)
{
  auto* first = vtkFloatArray::SafeDownCast(a->GetPointData()->GetScalars());
  auto* second = vtkFloatArray::SafeDownCast(b->GetPointData()->GetScalars());
  int count = 0;
  for (vtkIdType i = 0; i < first->GetNumberOfTuples(); ++i)
  {
    const float x = first->GetTypedComponent(i, 0);
    const float y = second->GetTypedComponent(i, 0);
    count += !(std::abs(x - y) <= 1e-3f * std::max(x, y));
  }
  return count;
}

void CheckPictures()
{
  const std::pair<const char*, Look> looks[] = { { "a corner", Look::AsIs },
    { "cut away", Look::Clipped }, { "of glass", Look::Glass } };
  for (const auto& [name, look] : looks)
  {
    for (const bool sun : { false, true })
    {
      const int different = CountDifferent(Draw(look, false, sun), Draw(look, true, sun));
      const std::string what = std::string(name) + (sun ? ", sun" : ", lamp");
      std::cout << what << ": " << different << " pixels differ\n";
      // Planes that end elsewhere have other roundings of their sides, by less than a hundredth of
      // a pixel.
      Check(different <= 3, what + ": the airlight is the same whether planes may end or not");
    }
  }
}
}

//------------------------------------------------------------------------------
int TestPlanarOccluders(int, char*[])
{
  CheckRandom();
  CheckPictures();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
