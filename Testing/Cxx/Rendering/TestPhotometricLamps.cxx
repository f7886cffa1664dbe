// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps that have a size and a photometric file: the mean of frames, in the air and on surfaces, is
// that of single frames with the lamp at points that the test chooses, and the reference's own
// points give the same. TestPhotometryPass has single frames beside quadrature.

#include "AirlightTestPhotometry.h"
#include "AirlightTestTools.h"
#include "LampBruteForce.h"

#include "vtkAirlightLight.h"

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr int Frames = 256;

std::map<std::string, Means> AddFrames(
  Lamp& lamp, const Offset& offset, const std::vector<Sample>& samples)
{
  lamp.Pass->SetSubpixelFrames(1); // which does not move the lamp
  return lamp.AddByHand(offset, samples, [&lamp] {
    const Buffers buffers = lamp.Render();
    Arrays arrays;
    for (const char* name : { "Radiance", "Airlight", "Surface" })
    {
      arrays[name] = buffers.at(name)->GetPointData()->GetScalars();
    }
    return arrays;
  });
}

// Of half of all values, and of 99 %.
struct Errors
{
  Errors(vtkImageData* image, const Means& expected)
  {
    const std::vector<double> errors = GetRelativeErrors(image, expected);
    this->Middle = errors[errors.size() / 2];
    this->Most = errors[errors.size() * 99 / 100];
  }
  double Middle;
  double Most;
};

//------------------------------------------------------------------------------
void CheckMean(const std::string& name, Lamp& lamp, const Offset& offset)
{
  const std::map<std::string, Means> expected = AddFrames(lamp, offset, MakeSamples());
  const Buffers point = lamp.Render();
  lamp.Pass->SetSubpixelFrames(Frames);
  const Buffers mean = lamp.Render();
  for (const auto& buffer : expected)
  {
    const Errors errors(mean.at(buffer.first), buffer.second);
    const Errors before(point.at(buffer.first), buffer.second);
    std::cout << name << ", " << buffer.first << ": median " << errors.Middle << ", 99 % below "
              << errors.Most << "; of a point " << before.Middle << " and " << before.Most << "\n";
    Check(errors.Middle < 1e-4, name + ": the median of " + buffer.first);
    Check(errors.Most < 0.03, name + ": 99 % of " + buffer.first);
    Check(before.Most > 5.0 * errors.Most, name + ": not a point's " + buffer.first);
  }
}

//------------------------------------------------------------------------------
// At the points that vtkAirlightReference has of a flat lamp.
void CheckReference(const std::string& name, Lamp& lamp, const Offset& offset)
{
  constexpr int Points = 8;
  std::vector<Sample> samples;
  for (int i = 0; i < Points; ++i)
  {
    const double turn = i * 0.5 * (std::sqrt(5.0) - 1.0);
    samples.push_back({ glm::dvec2(0.0), { (i + 0.5) / Points, turn - std::floor(turn), 0.0 } });
  }
  const Means expected = AddFrames(lamp, offset, samples).at("Radiance");
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(lamp.Renderer);
  reference->SetMedium(lamp.Medium);
  reference->SetSize(lamp.Width, lamp.Height);
  reference->SetLampPoints(Points);
  reference->Update();
  vtkImageData* image = reference->GetOutput();
  image->GetPointData()->SetActiveScalars("Radiance");
  const Errors errors(image, expected);
  std::cout << name << ", reference: median " << errors.Middle << ", 99 % below " << errors.Most
            << "\n";
  Check(errors.Middle < 1e-5 && errors.Most < 1e-3, name + ": the reference's points");
}

//------------------------------------------------------------------------------
void TestDisc(const std::string& file)
{
  for (const int width : { 48, 16 })
  {
    Lamp lamp(width, width * 3 / 4);
    vtkAirlightLight::SetPhotometry(lamp.Light, file.c_str());
    vtkAirlightLight::SetRadius(lamp.Light, 0.5);
    const Offset offset = [&lamp](const glm::dvec3& numbers) {
      return lamp.OnCircle(0.5 * std::sqrt(numbers.x), numbers.y);
    };
    width > 16 ? CheckMean("disc", lamp, offset) : CheckReference("disc", lamp, offset);
  }
}

// Its width is across its height, and that along the direction of the file's angle 0, here the x
// axis as far as it crosses the lamp's.
void TestRectangle(const std::string& file)
{
  for (const int width : { 48, 16 })
  {
    Lamp lamp(width, width * 3 / 4);
    vtkAirlightLight::SetPhotometry(lamp.Light, file.c_str());
    vtkAirlightLight::SetPhotometryUp(lamp.Light, 1.0, 0.0, 0.0);
    vtkAirlightLight::SetSize(lamp.Light, 0.3, 1.5);
    const glm::dvec3 axis = -glm::normalize(glm::dvec3(3, 4, 2));
    const glm::dvec3 up = glm::normalize(glm::dvec3(1, 0, 0) - axis.x * axis);
    const glm::dvec3 right = glm::cross(axis, up);
    const Offset offset = [&up, &right](const glm::dvec3& numbers) {
      return 0.3 * (numbers.x - 0.5) * right + 1.5 * (numbers.y - 0.5) * up;
    };
    width > 16 ? CheckMean("rectangle", lamp, offset) : CheckReference("rectangle", lamp, offset);
  }
}
}

//------------------------------------------------------------------------------
int TestPhotometricLamps(int argc, char* argv[])
{
  TestDisc(GetPhotometricFile(argc, argv, "streetlight.ies"));
  TestRectangle(GetPhotometricFile(argc, argv, "tube.ies"));
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
