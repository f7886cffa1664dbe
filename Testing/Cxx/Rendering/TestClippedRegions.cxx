// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Casters that clipping planes cut off: of random boxes and cameras, each that has a point in the
// view and outside the clipping range is found, and those are let alone that typical scenes have.

#include "AirlightTestCheck.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"
#include "Casters/AirlightCasters.h"
#include "Scene/AirlightCameraRays.h"
#include "ShadowVolumes/AirlightClippedRegions.h"

#include "vtkCubeSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

airlight::Caster MakeBox(const glm::dmat4& toWorld)
{
  static const auto mesh =
    std::make_shared<airlight::CasterMesh>(Make(vtkNew<vtkCubeSource>().Get()).Get());
  airlight::Caster caster;
  caster.Mesh = mesh;
  caster.ToWorld = toWorld;
  return caster;
}

glm::dmat4 RandomPlace(Random& random)
{
  glm::dmat4 matrix(1.0);
  const glm::dmat3 axes = RandomAxes(random);
  for (int i = 0; i < 3; ++i)
  {
    matrix[i] = glm::dvec4(random.LogUniform(0.01, 30.0) * axes[i], 0.0);
  }
  matrix[3] = glm::dvec4(random.Uniform(0.0, 12.0) * RandomUnit(random), 1.0);
  return matrix;
}

void PlaceCamera(Random& random, vtkCamera* camera)
{
  const glm::dvec3 position = random.Uniform(0.0, 5.0) * RandomUnit(random);
  const glm::dvec3 focus = position + RandomUnit(random);
  const glm::dvec3 up = RandomUnit(random);
  camera->SetPosition(&position.x);
  camera->SetFocalPoint(&focus.x);
  camera->SetViewUp(&up.x);
  camera->SetViewAngle(random.Uniform(10.0, 100.0));
  camera->SetParallelProjection(random.Index(3) == 0);
  camera->SetParallelScale(random.Uniform(0.5, 4.0));
  const double nearest = random.LogUniform(0.05, 3.0);
  camera->SetClippingRange(nearest, nearest * random.LogUniform(2.0, 200.0));
}

bool IsCutOff(vtkCamera* camera, const glm::dvec3& point)
{
  const glm::dvec4 clip = Project(camera, Width / double(Height), point);
  return IsInPicture(clip) && std::abs(clip.z) > clip.w;
}

//------------------------------------------------------------------------------
void CheckRandom()
{
  Random random(1);
  int cut = 0;
  int found = 0;
  int missed = 0;
  constexpr int count = 4000;
  for (int k = 0; k < count; ++k)
  {
    vtkNew<vtkCamera> camera;
    PlaceCamera(random, camera);
    const airlight::CameraRays rays(camera, Width / double(Height), Width, Height);
    const airlight::Caster caster = MakeBox(RandomPlace(random));
    bool isCut = false;
    for (int i = 0; i < 400 && !isCut; ++i)
    {
      const double x = random.Uniform(-0.5, 0.5);
      const double y = random.Uniform(-0.5, 0.5);
      const double z = random.Uniform(-0.5, 0.5);
      isCut = IsCutOff(camera, glm::dvec3(caster.ToWorld * glm::dvec4(x, y, z, 1.0)));
    }
    const bool may = airlight::ClippedRegions(rays).MayCutOff(caster);
    cut += isCut;
    found += may;
    missed += isCut && !may;
    Check(!may || airlight::ClippedRegions(rays, true).MayCutOff(caster),
      "of any picture, what is found in this one is found");
  }
  std::cout << count << " boxes: " << cut << " cut off at one of 400 places, " << found
            << " found, " << missed << " missed\n";
  Check(missed == 0, "each box that is cut off is found");
  Check(cut > count / 10 && cut < 9 * count / 10, "there are both kinds");
  // What the places miss are slivers; the rest of it, boxes that pass corners of the regions.
  Check(found < cut + count / 10, "few others are taken for one");
}

//------------------------------------------------------------------------------
void CheckTypical()
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 4.0, 11.0);
  camera->SetFocalPoint(0.0, 1.2, 0.0);
  camera->SetClippingRange(0.1, 60.0);
  const airlight::CameraRays rays(camera, Width / double(Height), Width, Height);
  glm::dmat4 floor(40.0);
  floor[1] = glm::dvec4(0.0, 1e-9, 0.0, 0.0);
  floor[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
  const airlight::ClippedRegions view(rays);
  Check(!view.MayCutOff(MakeBox(floor)), "a floor that the camera stands above");
  Check(airlight::ClippedRegions(rays, true).MayCutOff(MakeBox(floor)), "but for any picture");
  floor[3].y = 3.99;
  Check(view.MayCutOff(MakeBox(floor)), "a floor that the near plane cuts");
  floor[3] = glm::dvec4(0.0, 0.0, -30.0, 1.0);
  Check(view.MayCutOff(MakeBox(floor)), "a floor that the far plane cuts");
}
}

//------------------------------------------------------------------------------
int TestClippedRegions(int, char*[])
{
  CheckRandom();
  CheckTypical();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
