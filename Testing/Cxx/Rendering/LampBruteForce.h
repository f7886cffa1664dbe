// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of lamps with a size share: a scene with one, and the mean over points of the lamp
 * and places in the pixel by hand.
 */

#ifndef LampBruteForce_h
#define LampBruteForce_h

#include "AirlightTestMeans.h"
#include "AirlightTestWindowScene.h"

#include "vtkAirlightReference.h"
#include "vtkDataArray.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace airlight_test
{
//------------------------------------------------------------------------------
// A lattice of Korobov's in a pixel and three numbers of a lamp. Folded, what is no angle has no
// jump at its ends.
struct Sample
{
  glm::dvec2 Pixel;
  glm::dvec3 Lamp;
};

inline std::vector<Sample> MakeSamples()
{
  constexpr int Count = 2039; // a prime
  constexpr int Generator = 67;
  const auto fold = [](double x) { return 1.0 - std::abs(2.0 * x - 1.0); };
  std::vector<Sample> samples;
  for (int i = 0; i < Count; ++i)
  {
    std::array<double, 5> x;
    int multiple = i;
    for (double& coordinate : x)
    {
      coordinate = (multiple + 0.5) / Count;
      multiple = multiple * Generator % Count;
    }
    samples.push_back({ { x[0] - 0.5, x[1] - 0.5 }, { fold(x[2]), fold(x[3]), fold(x[4]) } });
  }
  return samples;
}

//------------------------------------------------------------------------------
// A lamp's offset from its middle for numbers from 0 to 1. A sun moves in a plane, and its focal
// point stays.
using Offset = std::function<glm::dvec3(const glm::dvec3& numbers)>;

// By the names of buffers.
using Arrays = std::map<std::string, vtkSmartPointer<vtkDataArray>>;

class Lamp : public WindowScene
{
public:
  Lamp(int width, int height)
    : WindowScene(width, height, 1)
    , Light(vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0)))
  {
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    const glm::dvec3 axis = -glm::normalize(glm::dvec3(3, 4, 2));
    this->Up = glm::normalize(glm::dvec3(0, 1, 0) - axis.y * axis);
    this->Right = glm::cross(axis, this->Up);
  }

  glm::dvec3 OnCircle(double radius, double turn) const
  {
    return radius *
      (std::cos(2.0 * vtkMath::Pi() * turn) * this->Right +
        std::sin(2.0 * vtkMath::Pi() * turn) * this->Up);
  }

  // Means of what `draw` returns, by name.
  std::map<std::string, Means> AddByHand(
    const Offset& offset, const std::vector<Sample>& samples, const std::function<Arrays()>& draw);

  // Of the reference with a point.
  std::map<std::string, Means> AddReferences(const Offset& offset);

  vtkLight* Light;
  glm::dvec3 Right;
  glm::dvec3 Up;
};

inline std::map<std::string, Means> Lamp::AddByHand(
  const Offset& offset, const std::vector<Sample>& samples, const std::function<Arrays()>& draw)
{
  std::map<std::string, Means> means;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  glm::dvec3 middle;
  this->Light->GetPosition(&middle.x);
  for (const Sample& sample : samples)
  {
    camera->SetWindowCenter(
      2.0 * sample.Pixel.x / this->Width, 2.0 * sample.Pixel.y / this->Height);
    const glm::dvec3 moved = offset(sample.Lamp);
    const glm::dvec3 position = middle + moved;
    this->Light->SetPosition(position.x, position.y, position.z);
    if (this->Light->GetPositional())
    {
      this->Light->SetFocalPoint(moved.x, moved.y, moved.z);
    }
    for (const auto& array : draw())
    {
      Means& mean = means[array.first];
      mean.resize(3 * this->Width * this->Height);
      for (size_t i = 0; i < mean.size(); ++i)
      {
        const double value =
          array.second->GetComponent(static_cast<vtkIdType>(i / 3), static_cast<int>(i % 3));
        mean[i] += value / static_cast<double>(samples.size());
      }
    }
  }
  camera->SetWindowCenter(0.0, 0.0);
  this->Light->SetPosition(middle.x, middle.y, middle.z);
  this->Light->SetFocalPoint(0.0, 0.0, 0.0);
  return means;
}

inline std::map<std::string, Means> Lamp::AddReferences(const Offset& offset)
{
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(this->Renderer);
  reference->SetMedium(this->Medium);
  reference->SetSize(this->Width, this->Height);
  reference->SetLampPoints(1);
  return this->AddByHand(offset, MakeSamples(), [&reference] {
    reference->Modified();
    reference->Update();
    Arrays arrays;
    for (const char* name : { "Radiance", "Airlight", "Surface" })
    {
      arrays[name] = reference->GetOutput()->GetPointData()->GetArray(name);
    }
    return arrays;
  });
}
}

#endif
