// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Paths of light through all that a scene can hold. Furnaces: where walls shine with L (1 - albedo)
// and media with L sigma_a, radiance is L everywhere, whatever scatters and reflects in between. And
// lights of other kinds against those that they can be made of.

#include "AirlightTestPaths.h"

#include "vtkAirlightLight.h"
#include "vtkCubeSource.h"
#include "vtkLightCollection.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
constexpr double Level = 0.7; // radiance everywhere

//------------------------------------------------------------------------------
class Furnace : public PathScene
{
public:
  explicit Furnace(int side = 6)
    : PathScene(side)
  {
    this->Look({ 0.3, -0.2, 1.1 }, { 0.1, 0.2, -1.0 }, 100.0);
    this->AddLamp({ 0.0, 0.0, 0.0 }, 0.0); // without one, surfaces show their colour
  }

  void AddWall(vtkPolyDataAlgorithm* source, double albedo)
  {
    this->AddSurface(source, glm::dvec3(albedo), Level * (1.0 - albedo));
  }

  void AddRoom(double albedo)
  {
    vtkNew<vtkCubeSource> room;
    room->SetXLength(4.0);
    room->SetYLength(3.0);
    room->SetZLength(5.0);
    this->AddWall(room, albedo);
  }

  // One medium in which the same share of extinction is absorption in each colour.
  static void Set(vtkParticipatingMedium* medium, double c, const glm::dvec3& sigmaT)
  {
    PathScene::SetMedium(medium, glm::dvec3(c), sigmaT);
    const double ambient = c < 1.0 ? Level * (1.0 - c) / c : 0.0;
    medium->SetAmbientRadiance(ambient, ambient, ambient);
  }

  // Each pixel in its own standard errors; their squares are 1 in the mean.
  void Check(const std::string& what, int samples)
  {
    this->Compute(samples, 3);
    vtkDataArray* radiance = this->Get("Radiance");
    vtkDataArray* error = this->Get("StandardError");
    double chi2 = 0.0;
    int count = 0;
    bool finite = true;
    for (vtkIdType i = 0; i < radiance->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double e = std::max(error->GetComponent(i, c), 1e-9);
        const double deviation = (radiance->GetComponent(i, c) - Level) / e;
        finite = finite && std::isfinite(deviation);
        chi2 += deviation * deviation;
        ++count;
      }
    }
    std::cout << what << ": chi^2 per value " << chi2 / count << "\n";
    airlight_test::Check(finite && chi2 / count < 2.0, what + ": radiance is the same everywhere");
    for (int c = 0; c < 3; ++c)
    {
      CheckMean(what, *this, c, Level, 0.05);
    }
  }
};

//------------------------------------------------------------------------------
void CheckRooms()
{
  Furnace white;
  white.AddRoom(0.8);
  Furnace::Set(white.Medium, 1.0, { 0.5, 1.0, 2.0 });
  white.Check("a room with a medium that absorbs nothing", 100);

  Furnace empty;
  empty.AddRoom(0.7);
  Furnace::Set(empty.Medium, 0.5, glm::dvec3(0.0));
  empty.Check("a room without a medium", 60);

  Furnace grey;
  grey.AddRoom(0.3);
  vtkNew<vtkSphereSource> ball; // facets without normals of their own
  ball->GenerateNormalsOff();
  ball->SetCenter(0.5, 0.0, -1.0);
  grey.AddWall(ball, 0.9);
  Furnace::Set(grey.Medium, 0.6, { 0.3, 1.0, 5.0 });
  grey.Medium->SetPhaseFunctionToHenyeyGreenstein();
  grey.Medium->SetAnisotropy(-0.6);
  grey.Check("a ball in a room of a medium that absorbs", 60);
}

vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5, 4, 6);
  image->SetOrigin(-1.2, -1.0, -2.0);
  image->SetSpacing(0.6, 0.6, 0.6);
  image->AllocateScalars(VTK_DOUBLE, 1);
  Random random(5);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(
      i, 0, i % 3 == 0 ? 0.0 : random.Uniform(0.0, 3.0));
  }
  return image;
}

// An image, height fog, a sphere and a box, of different phase functions, all over one another.
void CheckMedia()
{
  Furnace scene;
  scene.AddRoom(0.5);
  Furnace::Set(scene.Medium, 0.7, { 1.0, 0.5, 2.0 });
  scene.Medium->SetDensityImage(MakeImage());
  scene.Medium->SetDensityToImage();
  scene.Check("an image", 60);

  vtkNew<vtkParticipatingMedium> fog;
  Furnace::Set(fog, 0.8, { 0.3, 0.6, 0.4 });
  fog->SetDensityToExponentialHeight();
  fog->SetScaleHeight(0.8);
  fog->SetPhaseFunctionToRayleigh();
  vtkNew<vtkParticipatingMedium> sphere;
  Furnace::Set(sphere, 0.5, { 2.0, 1.0, 0.1 });
  sphere->SetRegionToSphere();
  sphere->SetRadius(1.3);
  sphere->SetPhaseFunctionToHenyeyGreenstein();
  sphere->SetAnisotropy(0.8);
  scene.Reference->AddMedium(fog);
  scene.Reference->AddMedium(sphere);
  scene.Check("an image, height fog and a sphere", 60);

  scene.Reference->RemoveMedium(scene.Medium);
  scene.Check("height fog and a sphere", 60);
  scene.Reference->SetMedium(fog);
  scene.Check("height fog", 60);

  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.2, 0.1, -0.5);
  ball->SetRadius(1.0);
  ball->Update();
  sphere->SetSurface(ball->GetOutput());
  sphere->SetRegionToSurface();
  fog->SetDensityToUniform();
  fog->SetRegionToCylinder();
  fog->SetHeight(2.0);
  fog->SetRadius(1.2);
  scene.Reference->AddMedium(sphere);
  scene.Check("a closed surface and a cylinder", 60);
}

//------------------------------------------------------------------------------
// Two scenes that must look alike, by the mean of each channel.
void CheckAlike(const std::string& what, const std::function<void(PathScene&)>& build,
  const std::function<void(PathScene&)>& one, const std::function<void(PathScene&)>& other)
{
  PathScene scenes[2];
  for (int k = 0; k < 2; ++k)
  {
    build(scenes[k]);
    (k == 0 ? one : other)(scenes[k]);
    scenes[k].Compute(60, 10 + k);
  }
  for (int c = 0; c < 3; ++c)
  {
    const PathMean expected(scenes[1], c);
    CheckMean(what, scenes[0], c, expected.Value, 0.1, expected.Error);
  }
}

// A box of medium over a floor.
void AddBox(PathScene& scene)
{
  PathScene::SetMedium(scene.Medium, { 0.9, 0.8, 0.7 }, { 0.5, 1.0, 1.5 });
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-1.0, 1.0, -1.0, 1.0, 0.0, 2.0);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-2.0, -2.0, 0.0);
  floor->SetPoint1(2.0, -2.0, 0.0);
  floor->SetPoint2(-2.0, 2.0, 0.0);
  scene.AddSurface(floor, { 0.5, 0.6, 0.7 });
  scene.Look({ 4.0, 0.5, 2.0 }, { -1.0, -0.1, -0.3 });
}

void CheckLights()
{
  const glm::dvec3 toSun = glm::normalize(glm::dvec3(0.5, -0.3, 1.0));
  CheckAlike(
    "a sun and a far lamp", AddBox,
    [&](PathScene& scene) {
      vtkLight* sun = scene.AddLamp(toSun);
      const double irradiance[3] = { 2.0, 2.0, 2.0 };
      vtkAirlight::SetIrradiance(sun, irradiance);
    },
    [&](PathScene& scene) { scene.AddLamp(1e4 * toSun, 2e8); });

  // The whole box is in its cone, which does not change with the angle.
  CheckAlike(
    "a spot and a lamp", AddBox,
    [](PathScene& scene) {
      vtkLight* spot = scene.AddLamp({ 0.2, 0.1, 5.0 }, 20.0);
      spot->SetFocalPoint(0.2, 0.1, 0.0);
      spot->SetConeAngle(60.0);
      spot->SetExponent(0.0);
    },
    [](PathScene& scene) {
      scene.AddLamp({ 0.2, 0.1, 5.0 }, 20.0);
    });

  // Many lights against one of their sum; and a small ball.
  CheckAlike(
    "four lamps and one", AddBox,
    [](PathScene& scene) {
      for (const double share : { 0.1, 0.2, 0.3, 0.4 })
      {
        scene.AddLamp({ 0.2, 0.1, 1.0 }, share);
      }
    },
    [](PathScene& scene) {
      scene.AddLamp({ 0.2, 0.1, 1.0 });
    });
  CheckAlike(
    "a small ball and a lamp", AddBox,
    [](PathScene& scene) {
      vtkAirlightLight::SetRadius(scene.AddLamp({ 0.2, 0.1, 1.0 }), 1e-3);
      scene.Reference->SetLampPoints(16);
    },
    [](PathScene& scene) {
      scene.AddLamp({ 0.2, 0.1, 1.0 });
    });
}

// An image of constant density against a box of the same.
void CheckImageAgainstBox()
{
  const auto build = [](PathScene& scene) {
    AddBox(scene);
    scene.AddLamp({ 0.2, 0.1, 1.0 });
  };
  CheckAlike(
    "an image and a box", build,
    [](PathScene& scene) {
      vtkNew<vtkImageData> image;
      image->SetDimensions(4, 3, 5);
      image->SetOrigin(-1.0, -1.0, 0.0);
      image->SetSpacing(2.0 / 3.0, 1.0, 0.5);
      image->AllocateScalars(VTK_DOUBLE, 1);
      image->GetPointData()->GetScalars()->Fill(1.0);
      scene.Medium->SetDensityImage(image);
      scene.Medium->SetDensityToImage();
    },
    [](PathScene&) {});
}
}

int TestPathTracerScenes(int, char*[])
{
  CheckRooms();
  CheckMedia();
  CheckLights();
  CheckImageAgainstBox();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
