// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps with an extent: the points that frames take are spread evenly over them; the mean of frames
// is the light of many small lamps, one by one and added by hand in the CPU reference.

#include "AirlightTestErrors.h"
#include "AirlightTestMeans.h"
#include "AirlightTestWindowScene.h"
#include "Scene/AirlightLampSamples.h"
#include "Scene/AirlightScrambledNet.h"

#include "vtkAirlight.h"
#include "vtkAirlightLight.h"
#include "vtkAirlightReference.h"
#include "vtkDataArray.h"
#include "vtkLightCollection.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

using namespace airlight_test;
using airlight::GetLampNumbers;
using airlight::GetLampOffset;
using airlight::LampExtent;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int PictureWidth = 100;
constexpr int PictureHeight = 40;
constexpr int Frames = 256;

// Means of coordinates and of their squares are those of even discs, seen from any side.
void TestSpread()
{
  LampExtent ball;
  ball.Radius = 2.0;
  LampExtent sheet;
  sheet.Size = { 4.0, 1.0 };
  const glm::dvec3 axis(0.0, 0.0, 1.0);
  const glm::dvec3 up(0.0, 1.0, 0.0);
  for (int light = 0; light < 3; ++light)
  {
    glm::dvec3 mean(0.0);
    glm::dvec3 square(0.0);
    glm::dvec3 disc(0.0);
    glm::dvec3 rectangle(0.0);
    int inner = 0;
    double largest = 0.0;
    for (int i = 0; i < 1024; ++i)
    {
      const glm::dvec3 numbers = GetLampNumbers(i, light);
      const glm::dvec3 place = GetLampOffset(ball, glm::dvec3(0.0), glm::dvec3(0.0), numbers);
      mean += place / 1024.0;
      square += place * place / 1024.0;
      largest = std::max(largest, glm::length(place));
      inner += std::hypot(place.x, place.y) < 1.0 ? 1 : 0; // a quarter of the disc that is seen
      const glm::dvec3 flat = GetLampOffset(ball, axis, up, numbers);
      disc += flat * flat / 1024.0;
      const glm::dvec3 corner = GetLampOffset(sheet, axis, up, numbers);
      rectangle += corner * corner / 1024.0;
    }
    Check(glm::length(mean) < 0.02, "the middle of a ball");
    Check(glm::length(square - glm::dvec3(1.0)) < 0.03, "an even disc from all sides: R^2/4");
    Check(largest <= 2.0 && std::abs(inner - 256) < 16, "and a quarter of it within half of it");
    Check(glm::length(disc - glm::dvec3(1.0, 1.0, 0.0)) < 0.03, "a disc across the axis");
    Check(glm::length(rectangle - glm::dvec3(16.0 / 12.0, 1.0 / 12.0, 0.0)) < 0.03, "a rectangle");
  }
}

//------------------------------------------------------------------------------
class ExtentScene : public WindowScene
{
public:
  ExtentScene()
    : WindowScene(PictureWidth, PictureHeight, 1)
    , Lamp(vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0)))
  {
    this->Lamp->SetFocalPoint(0.0, 0.0, 0.0);
  }

  vtkLight* Lamp;
};

// The mean of the reference's airlight and radiance with the lamp at each of these places, or with
// each of these focal points for a lamp in the sky.
std::vector<double> AddByHand(
  ExtentScene& scene, const char* name, const std::vector<glm::dvec3>& places, bool sun = false)
{
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(scene.Renderer);
  reference->SetMedium(scene.Medium);
  reference->SetSize(PictureWidth, PictureHeight);
  reference->SetLampPoints(1);
  std::vector<double> sums(3 * PictureWidth * PictureHeight, 0.0);
  double before[3];
  double focus[3];
  scene.Lamp->GetPosition(before);
  scene.Lamp->GetFocalPoint(focus);
  for (const glm::dvec3& place : places)
  {
    scene.Lamp->SetPosition(place.x, place.y, place.z);
    if (!sun)
    {
      scene.Lamp->SetFocalPoint(focus[0] + place.x - before[0], focus[1] + place.y - before[1],
        focus[2] + place.z - before[2]);
    }
    reference->Modified();
    reference->Update();
    vtkDataArray* array = reference->GetOutput()->GetPointData()->GetArray(name);
    for (size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] += array->GetComponent(static_cast<vtkIdType>(i / 3), static_cast<int>(i % 3)) /
        static_cast<double>(places.size());
    }
  }
  scene.Lamp->SetPosition(before);
  scene.Lamp->SetFocalPoint(focus);
  return sums;
}

// The reference's own points, too.
void CheckReference(
  const std::string& name, ExtentScene& scene, const std::vector<double>& expected)
{
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(scene.Renderer);
  reference->SetMedium(scene.Medium);
  reference->SetSize(PictureWidth, PictureHeight);
  const auto getErrors = [&reference, &expected](int points) {
    reference->SetLampPoints(points);
    reference->Update();
    vtkImageData* image = reference->GetOutput();
    image->GetPointData()->SetActiveScalars("Radiance");
    return GetRelativeErrors(image, expected);
  };
  const std::vector<double> point = getErrors(1);
  const std::vector<double> lamp = getErrors(256);
  const size_t most = lamp.size() * 9 / 10;
  std::cout << name << ", reference: median " << lamp[lamp.size() / 2] << ", 90 % below "
            << lamp[most] << "; of a point " << point[most] << "\n";
  Check(lamp[lamp.size() / 2] < 1e-3 && lamp[most] < 0.01, name + ": the reference's points");
  Check(point[most] > 3.0 * lamp[most], name + ": and not its point");
}

// The pass moves the camera, too: what changes within a pixel is left out by the median and the
// 90 %.
void CheckLamp(const std::string& name, ExtentScene& scene, const std::vector<glm::dvec3>& places,
  bool sun = false)
{
  double position[3];
  scene.Lamp->GetPosition(position);
  const std::vector<double> expected = AddByHand(scene, "Radiance", places, sun);
  CheckReference(name, scene, expected);
  const vtkMTimeType time = scene.Lamp->GetMTime();
  scene.Pass->SetSubpixelFrames(1);
  scene.Window->Render();
  Check(scene.Lamp->GetMTime() == time, name + ": one frame does not move the lamp");
  const std::vector<double> point = GetRelativeErrors(scene.GetBuffer("Radiance"), expected);
  scene.Pass->SetSubpixelFrames(Frames);
  scene.Window->Render();
  const std::vector<double> mean = GetRelativeErrors(scene.GetBuffer("Radiance"), expected);
  const size_t most = mean.size() * 9 / 10;
  std::cout << name << ": median " << mean[mean.size() / 2] << ", 90 % below " << mean[most]
            << "; of a point " << point[point.size() / 2] << " and " << point[most] << "\n";
  Check(mean[mean.size() / 2] < 5e-4 && mean[most] < 0.02, name + ": the light of its points");
  Check(point[most] > 3.0 * mean[most], name + ": and not of a point");
  double after[3];
  scene.Lamp->GetPosition(after);
  Check(std::equal(position, position + 3, after), name + ": the lamp is where it was");
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> MakePlaces(
  vtkLight* lamp, const std::function<glm::dvec3(double u, double v)>& offset)
{
  std::vector<glm::dvec3> places;
  glm::dvec3 middle;
  lamp->GetPosition(&middle.x);
  for (int i = 0; i < 256; ++i)
  {
    places.push_back(middle + offset((i % 16 + 0.5) / 16.0, (i / 16 + 0.5) / 16.0));
  }
  return places;
}

// Two directions across another.
std::pair<glm::dvec3, glm::dvec3> MakeAxes(const glm::dvec3& axis)
{
  const glm::dvec3 up = glm::normalize(glm::dvec3(0, 1, 0) - axis.y * axis);
  return { glm::cross(axis, up), up };
}

void TestBall()
{
  ExtentScene scene;
  vtkAirlightLight::SetRadius(scene.Lamp, 0.6);
  // Spheres whose radii R sin(a) have the density r^2/sqrt(R^2 - r^2), and Fibonacci's spiral on
  // each.
  constexpr int Shells = 16;
  constexpr int Points = 64;
  std::vector<glm::dvec3> places;
  glm::dvec3 middle;
  scene.Lamp->GetPosition(&middle.x);
  double angle = 0.0;
  for (int shell = 0; shell < Shells; ++shell)
  {
    const double share = (shell + 0.5) / Shells;
    while ((angle - std::sin(angle) * std::cos(angle)) / (0.5 * Pi) < share)
    {
      angle += 1e-5;
    }
    for (int i = 0; i < Points; ++i)
    {
      const double z = 1.0 - 2.0 * (i + 0.5) / Points;
      const double turn = i * Pi * (3.0 - std::sqrt(5.0)) + shell;
      const double across = std::sqrt(1.0 - z * z);
      places.push_back(middle +
        0.6 * std::sin(angle) * glm::dvec3(across * std::cos(turn), across * std::sin(turn), z));
    }
  }
  CheckLamp("ball", scene, places);
}

void TestDisc()
{
  ExtentScene scene;
  scene.Lamp->SetConeAngle(40.0);
  scene.Lamp->SetExponent(0.0);
  vtkAirlightLight::SetRadius(scene.Lamp, 0.7);
  const auto axes = MakeAxes(-glm::normalize(glm::dvec3(3, 4, 2)));
  CheckLamp("disc", scene, MakePlaces(scene.Lamp, [&axes](double u, double v) {
    return 0.7 * std::sqrt(u) *
      (std::cos(2.0 * Pi * v) * axes.first + std::sin(2.0 * Pi * v) * axes.second);
  }));
}

void TestRectangle()
{
  ExtentScene scene;
  vtkAirlightLight::SetSize(scene.Lamp, 2.0, 0.4);
  const auto axes = MakeAxes(-glm::normalize(glm::dvec3(3, 4, 2)));
  CheckLamp("rectangle", scene, MakePlaces(scene.Lamp, [&axes](double u, double v) {
    return 2.0 * (u - 0.5) * axes.first + 0.4 * (v - 0.5) * axes.second;
  }));
}

// A large sun: 60 degrees, by solid angle.
void TestSun()
{
  ExtentScene scene;
  scene.Lamp->SetPositional(false);
  const double irradiance[3] = { 2.0, 2.0, 2.0 };
  vtkAirlight::SetIrradiance(scene.Lamp, irradiance);
  vtkAirlightLight::SetAngularDiameter(scene.Lamp, 60.0);
  const auto axes = MakeAxes(-glm::normalize(glm::dvec3(3, 4, 2)));
  CheckLamp("sun", scene,
    MakePlaces(scene.Lamp,
      [&axes](double u, double v) {
        // Zones of equal height have equal solid angles.
        const double angle = std::acos(1.0 - u * (1.0 - std::cos(Pi / 6.0)));
        return std::sqrt(29.0) * std::tan(angle) *
          (std::cos(2.0 * Pi * v) * axes.first + std::sin(2.0 * Pi * v) * axes.second);
      }),
    true);
}

//------------------------------------------------------------------------------
void TestErrors()
{
  vtkNew<vtkLight> light;
  ErrorListener errors(light);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkAirlightLight::SetRadius(light, 0.5);
  for (const double radius : { -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    vtkAirlightLight::SetRadius(light, radius);
    Check(errors.Take() == 1 && errors.GetText().find("radius") != std::string::npos,
      "a radius out of range");
  }
  Check(vtkAirlightLight::GetRadius(light) == 0.5, "the old radius stays");
  for (const glm::dvec2 size : { glm::dvec2(1.0, -1.0), glm::dvec2(nan, 1.0) })
  {
    vtkAirlightLight::SetSize(light, size.x, size.y);
    Check(errors.Take() == 1, "a size out of range");
  }
  for (const double angle : { 180.0, -0.5, nan })
  {
    vtkAirlightLight::SetAngularDiameter(light, angle);
    Check(errors.Take() == 1, "an angle out of range");
  }
  double size[2];
  vtkAirlightLight::GetSize(light, size);
  Check(size[0] == 0.0 && size[1] == 0.0 && vtkAirlightLight::GetAngularDiameter(light) == 0.0,
    "the old values stay");
  vtkNew<vtkLight> copy;
  copy->DeepCopy(light);
  Check(vtkAirlightLight::GetRadius(copy) == 0.5, "a copy has the extent");
  // A lamp that contains the eye.
  ExtentScene scene;
  double eye[3];
  scene.Renderer->GetActiveCamera()->GetPosition(eye);
  scene.Lamp->SetPosition(eye);
  vtkAirlightLight::SetRadius(scene.Lamp, 1.0);
  scene.Pass->SetSubpixelFrames(16);
  CheckFinite(scene.Render(), "around the eye");
}
}

//------------------------------------------------------------------------------
int TestLampExtents(int, char*[])
{
  TestSpread();
  TestBall();
  TestDisc();
  TestRectangle();
  TestSun();
  TestErrors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
