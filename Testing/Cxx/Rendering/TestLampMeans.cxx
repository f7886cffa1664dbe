// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Means of frames with lamps of a size beside brute force: the CPU reference, once for each of
// two thousand pairs of a point of the lamp and a place in the pixel, at all pixels, edges too. The
// pairs are those of another kind of rule than the pass has.

#include "AirlightTestTools.h"
#include "LampBruteForce.h"
#include "Scene/AirlightScrambledNet.h"

#include "vtkAirlight.h"
#include "vtkAirlightLight.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int PictureWidth = 28;
constexpr int PictureHeight = 21;

//------------------------------------------------------------------------------
// Of 2^m points, one is in each of 2^m rectangles of any one shape, and the first is not moved.
void CheckNet(int count)
{
  for (int width = 1; width <= count; width *= 2)
  {
    std::set<std::pair<int, int>> pixels;
    std::array<std::set<int>, 3> numbers;
    for (int i = 0; i < count; ++i)
    {
      const glm::dvec2 place = 0.5 + airlight::GetPixelOffset(i);
      pixels.emplace(std::floor(place.x * width), std::floor(place.y * count / width));
      const glm::dvec3 lamp = airlight::GetLampNumbers(i, width % 3);
      for (int k = 0; k < 3; ++k)
      {
        Check(lamp[k] > 0.0 && lamp[k] < 1.0, "a number from 0 to 1");
        numbers[k].insert(static_cast<int>(lamp[k] * count));
      }
    }
    const size_t expected = count;
    Check(pixels.size() == expected, Text("a net of ", count, ", columns: ", width));
    Check(numbers[0].size() == expected && numbers[1].size() == expected &&
        numbers[2].size() == expected,
      "each number by itself");
  }
  Check(airlight::GetPixelOffset(0) == glm::dvec2(0.0), "the first frame is not moved");
  Check(airlight::GetLampNumbers(1, 0) != airlight::GetLampNumbers(1, 1), "lights differ");
}

//------------------------------------------------------------------------------
// `edges`: the radiance's error at 99 % of all pixels is this times N^-5/8, as theory has it for
// edges in the four dimensions of a flat lamp and a pixel. `largest`: allowed there with 1024
// frames.
void CheckLamp(
  const std::string& name, Lamp& lamp, const Offset& offset, double edges, double largest)
{
  const std::map<std::string, Means> expected = lamp.AddReferences(offset);
  for (const int frames : { 16, 64, 256, 1024 })
  {
    lamp.Pass->SetSubpixelFrames(frames);
    const Buffers buffers = lamp.Render();
    std::cout << name << ", " << frames << " frames:";
    for (const auto& buffer : expected)
    {
      const std::vector<double> errors = GetRelativeErrors(buffers.at(buffer.first), buffer.second);
      const double middle = errors[errors.size() / 2];
      const double most = errors[errors.size() * 99 / 100];
      std::cout << " " << buffer.first << " median " << middle << ", 99 % below " << most << ";";
      const bool whole = buffer.first == "Radiance";
      const double law = edges * std::pow(frames, -0.625);
      Check(!whole || (most > 0.2 * law && most < 2.5 * law), Text(name, ": law at ", frames));
      Check(frames < 1024 || middle < 1e-4, name + ": the median of all pixels");
      // The mean of surfaces, to which errors are relative, is about half of the whole.
      const bool surface = buffer.first == "Surface";
      Check(frames < 1024 || most < (surface ? 2.0 : 1.0) * largest,
        name + ": 99 % of all pixels, edges too");
    }
    std::cout << "\n";
  }
}

//------------------------------------------------------------------------------
// Spheres whose radii R sin(a) have the density r^2/sqrt(R^2 - r^2): a share of them is within a.
void TestBall()
{
  Lamp lamp(PictureWidth, PictureHeight);
  vtkAirlightLight::SetRadius(lamp.Light, 0.6);
  const Offset offset = [](const glm::dvec3& numbers) {
    double low = 0.0;
    double high = 0.5 * Pi;
    for (int i = 0; i < 50; ++i)
    {
      const double angle = 0.5 * (low + high);
      const bool above = angle - std::sin(angle) * std::cos(angle) > 0.5 * Pi * numbers.z;
      (above ? high : low) = angle;
    }
    const double z = 1.0 - 2.0 * numbers.x;
    const double across = std::sqrt(1.0 - z * z);
    const double turn = 2.0 * Pi * numbers.y;
    return 0.6 * std::sin(low) * glm::dvec3(across * std::cos(turn), across * std::sin(turn), z);
  };
  CheckLamp("ball", lamp, offset, 0.65, 1e-2);
}

// A spotlight's sharp rim moves over the floor with each point: larger errors than of shadows.
void TestDisc()
{
  Lamp lamp(PictureWidth, PictureHeight);
  lamp.Light->SetConeAngle(40.0);
  lamp.Light->SetExponent(0.0);
  vtkAirlightLight::SetRadius(lamp.Light, 0.7);
  const Offset offset = [&lamp](const glm::dvec3& numbers) {
    return lamp.OnCircle(0.7 * std::sqrt(numbers.x), numbers.y);
  };
  CheckLamp("disc", lamp, offset, 1.6, 3e-2);
}

Offset MakeRectangle(const Lamp& lamp, double width, double height)
{
  return [&lamp, width, height](const glm::dvec3& numbers) {
    return width * (numbers.x - 0.5) * lamp.Right + height * (numbers.y - 0.5) * lamp.Up;
  };
}

void TestRectangle()
{
  Lamp lamp(PictureWidth, PictureHeight);
  vtkAirlightLight::SetSize(lamp.Light, 2.0, 0.4);
  CheckLamp("rectangle", lamp, MakeRectangle(lamp, 2.0, 0.4), 0.28, 1e-2);
}

// A large sun: 60 degrees, by solid angle. Zones of equal height have equal solid angles.
void TestSun()
{
  Lamp lamp(PictureWidth, PictureHeight);
  lamp.Light->SetPositional(false);
  const double irradiance[3] = { 2.0, 2.0, 2.0 };
  vtkAirlight::SetIrradiance(lamp.Light, irradiance);
  vtkAirlightLight::SetAngularDiameter(lamp.Light, 60.0);
  const Offset offset = [&lamp](const glm::dvec3& numbers) {
    const double angle = std::acos(1.0 - numbers.x * (1.0 - std::cos(Pi / 6.0)));
    return lamp.OnCircle(std::sqrt(29.0) * std::tan(angle), numbers.y);
  };
  CheckLamp("sun", lamp, offset, 0.52, 1e-2);
}
}

//------------------------------------------------------------------------------
int TestLampMeans(int, char*[])
{
  CheckNet(64);
  CheckNet(1024);
  TestBall();
  TestDisc();
  TestRectangle();
  TestSun();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
