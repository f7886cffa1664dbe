// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A medium inside a closed surface, and rays that are hard to tell in or out of it.
 */

#ifndef AirlightTestSurfaceRays_h
#define AirlightTestSurfaceRays_h

#include "AirlightTestTools.h"
#include "Integration/AirlightMath.h"
#include "Region/AirlightSurfaceTree.h"

#include "vtkAirlight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <array>
#include <memory>
#include <vector>

namespace airlight_test
{
// A uniform medium of sigmaT 1 inside a mesh, as the shaders see it.
class Body
{
public:
  explicit Body(vtkPolyData* mesh)
  {
    this->Medium->SetScattering(1.0, 1.0, 1.0);
    this->Medium->SetAbsorption(0.0, 0.0, 0.0);
    this->Medium->SetSurface(mesh);
    this->Medium->SetRegionToSurface();
    this->Tree = this->Medium->GetSurfaceTree();
    for (const glm::dvec4& texel : this->Tree->GetTexels())
    {
      this->Texels.emplace_back(texel);
    }
  }

  // By vtkAirlight::Transmittance() on the ray's part up to l: no longer than 40, else there is
  // nothing left to take the logarithm of.
  double GetLength(const glm::dvec3& o, const glm::dvec3& d, double l)
  {
    const glm::dvec3 end = o + l * d;
    double rgb[3];
    vtkAirlight::Transmittance(this->Medium, &o.x, &end.x, rgb);
    return -std::log(rgb[0]);
  }

  // The same by the shader's function in single precision, from the ray's origin as the shader has
  // it.
  double GetShaderLength(const glm::dvec3& o, const glm::dvec3& d, double l)
  {
    airlight::f32::AirlightMedium medium{};
    medium.region.kind = AIRLIGHT_REGION_SURFACE;
    medium.region.boxMin = this->Tree->GetLeast() - o;
    medium.region.boxMax = this->Tree->GetGreatest() - o;
    medium.region.centre = this->Tree->GetCentre() - o;
    medium.region.data = this->Texels.data();
    medium.region.nodes = this->Tree->GetNodeCount();
    return airlight::f32::airlightPathDepth(
      medium, glm::vec3(0.0f), glm::normalize(glm::vec3(d)), static_cast<float>(l));
  }

  // Corner k of a random triangle.
  std::array<glm::dvec3, 3> TakeTriangle(Random& random) const
  {
    const int first = 2 * this->Tree->GetNodeCount();
    const int count = (static_cast<int>(this->Texels.size()) - first) / 3;
    const auto at = static_cast<size_t>(first) + 3 * random.Index(count);
    std::array<glm::dvec3, 3> triangle;
    for (size_t k = 0; k < 3; ++k)
    {
      triangle[k] = glm::dvec3(this->Tree->GetTexels()[at + k]) + this->Tree->GetCentre();
    }
    return triangle;
  }

  vtkNew<vtkParticipatingMedium> Medium;

private:
  std::shared_ptr<const airlight::SurfaceTree> Tree;
  std::vector<glm::vec4> Texels;
};

struct TestRay
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;
};

inline TestRay Between(const glm::dvec3& a, const glm::dvec3& b)
{
  return { a, glm::normalize(b - a) };
}

// What rays are aimed at.
enum Aim
{
  VERTEX,
  EDGE,
  ALONG_EDGE,
  ALONG_FACE,
  BESIDE_FACE, // by some 1e-7
  AIMS
};

const char* const AimNames[] = { "vertex", "edge", "along edge", "along face", "beside face" };

inline TestRay TakeRay(const Body& body, int aim, Random& random)
{
  const std::array<glm::dvec3, 3> t = body.TakeTriangle(random);
  const glm::dvec3 u = t[1] - t[0];
  const glm::dvec3 v = t[2] - t[0];
  const glm::dvec3 away = t[0] +
    random.LogUniform(0.5, 1000.0) *
      glm::dvec3(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
  const double share = random.Uniform(0.0, 1.0);
  switch (aim)
  {
    case VERTEX:
      return Between(away, t[0]);
    case EDGE:
      return Between(away, t[0] + share * u);
    case ALONG_EDGE:
      return Between(t[0] - random.Uniform(0.1, 9.0) * u, t[1]);
    default:
      break;
  }
  TestRay ray = Between(t[0] + random.Uniform(-9.0, 9.0) * u + random.Uniform(-9.0, 9.0) * v,
    t[0] + 0.5 * share * u + random.Uniform(0.0, 0.5) * v);
  if (aim == BESIDE_FACE)
  {
    ray.Origin +=
      1e-7 * glm::dvec3(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
  }
  return ray;
}
}

#endif
