// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// airlightScatteredIrradiance() of Module/glsl in double and in single precision against the brute
// force of AirlightTestIrradiance.h, over random settings: a light of strength 1 at distance 1,
// optical distance 0.01 to 10, any normal. The pass with it is in TestScatteredSurfaceLight.

#include "AirlightTestIrradiance.h"
#include "AirlightTestSingle.h"
#include "AirlightTestTools.h"
#include "Integration/AirlightMath.h"
#include "Medium/AirlightConvert.h"

#include "vtkNew.h"

#include <cstdlib>
#include <vector>

using namespace airlight_test;

namespace
{
enum Kind
{
  IRRADIANCE_POINT,
  IRRADIANCE_SUN,
  IRRADIANCE_SPOT,
  IRRADIANCE_BOX_INSIDE,
  IRRADIANCE_BOX_FACE, // a wall of the region
  IRRADIANCE_BOX_OUTSIDE,
  IRRADIANCE_SPHERE_INSIDE,
  IRRADIANCE_SPHERE_OUTSIDE,
  IRRADIANCE_SUN_BOX,
  IRRADIANCE_FALLOFF,   // by quadrature
  IRRADIANCE_LIGHT_OUT, // light outside the box that holds the surface: by quadrature
  IRRADIANCE_KINDS
};

struct Family
{
  const char* Name;
  int Count;    // settings
  int Fineness; // of the brute force
  double Limit; // relative, as the header of vtkAirlightPass states it
};

const Family& GetFamily(int kind)
{
  static const Family families[IRRADIANCE_KINDS] = {
    { "point light, unbounded", 40, 1, 0.003 },
    { "directional light, unbounded", 40, 1, 0.003 },
    { "spot, unbounded", 40, 1, 0.01 },
    { "point light in a box that holds the surface", 24, 1, 0.01 },
    { "point light in a box that the surface is a face of", 24, 1, 0.01 },
    { "point light in a box away from the surface", 24, 1, 0.01 },
    { "point light in a sphere that holds the surface", 24, 1, 0.01 },
    { "point light in a sphere away from the surface", 24, 1, 0.01 },
    { "directional light, box", 24, 1, 0.03 },
    { "point light of another attenuation", 4, 1, 0.01 },
    { "point light outside the box", 4, 1, 0.03 },
  };
  return families[kind];
}

//------------------------------------------------------------------------------
// A setting with the surface's point at the origin.
class Setting
{
public:
  Setting(int kind, int index, Random& random)
  {
    const double anisotropies[] = { 0.0, 0.9, -0.6, 0.5 };
    const double sigma = random.LogUniform(0.01, 10.0);
    this->Medium->SetScattering(sigma, 0.5 * sigma, 0.0);
    this->Medium->SetAbsorption(0.0, 0.3 * sigma, sigma);
    this->Medium->SetPhaseFunctionToHenyeyGreenstein();
    this->Medium->SetAnisotropy(anisotropies[index % 4]);
    this->Normal = RandomUnit(random);
    this->Position = RandomUnit(random);
    const double one[3] = { 1.0, 1.0, 1.0 };
    vtkAirlight::SetRadiantIntensity(this->Light, one);
    if (kind == IRRADIANCE_SUN || kind == IRRADIANCE_SUN_BOX)
    {
      vtkAirlight::SetIrradiance(this->Light, one);
    }
    if (kind == IRRADIANCE_BOX_OUTSIDE || kind == IRRADIANCE_SPHERE_OUTSIDE)
    {
      // The surface sees some of the region.
      this->Normal *= glm::dot(this->Normal, this->Position) < 0.0 ? -1.0 : 1.0;
    }
    this->PlaceRegion(kind, random);
    this->Light->SetPosition(&this->Position.x);
    this->Light->SetExponent(0.0);
    if (kind == IRRADIANCE_SPOT)
    {
      const glm::dvec3 aim = this->Position + RandomUnit(random);
      this->Light->SetFocalPoint(&aim.x);
      this->Light->SetConeAngle(random.Uniform(10.0, 80.0));
    }
    if (kind == IRRADIANCE_FALLOFF)
    {
      this->Light->SetAttenuationValues(1.0, 0.1, 0.02);
    }
  }

  std::string Describe() const
  {
    const double* b = this->Medium->GetBounds();
    return Text("sigmaT ", this->Medium->GetExtinction()[0], ", g ", this->Medium->GetAnisotropy(),
      ", normal ", Text3(&this->Normal.x), ", light ", Text3(&this->Position.x), " to ",
      Text3(this->Light->GetFocalPoint()), ", cone ", this->Light->GetConeAngle(), ", box ",
      Text3(b), " ", Text3(b + 3), ", sphere ", Text3(this->Medium->GetCenter()), " ",
      this->Medium->GetRadius());
  }

  vtkNew<vtkParticipatingMedium> Medium;
  vtkNew<vtkLight> Light;
  glm::dvec3 Normal;
  glm::dvec3 Position;

private:
  // A box that holds two points, its faces 0.05 to 2 away from them.
  void SetBox(const glm::dvec3& a, const glm::dvec3& b, Random& random)
  {
    double bounds[6];
    for (int i = 0; i < 3; ++i)
    {
      bounds[2 * i] = std::min(a[i], b[i]) - random.LogUniform(0.05, 2.0);
      bounds[2 * i + 1] = std::max(a[i], b[i]) + random.LogUniform(0.05, 2.0);
    }
    this->Medium->SetBounds(bounds);
    this->Medium->SetRegionToBox();
  }

  void PlaceRegion(int kind, Random& random)
  {
    const glm::dvec3 origin(0.0);
    double bounds[6];
    switch (kind)
    {
      case IRRADIANCE_BOX_INSIDE:
      case IRRADIANCE_SUN_BOX:
        this->SetBox(origin, this->Position, random);
        break;
      case IRRADIANCE_BOX_FACE:
        this->Position.z = std::abs(this->Position.z);
        this->SetBox(origin, this->Position, random);
        this->Medium->GetBounds(bounds);
        bounds[4] = 0.0;
        this->Medium->SetBounds(bounds);
        this->Normal = { 0.0, 0.0, 1.0 };
        break;
      case IRRADIANCE_BOX_OUTSIDE:
      case IRRADIANCE_LIGHT_OUT:
        for (int i = 0; i < 6; ++i)
        {
          // No face reaches as far as the other of the two.
          const double centre = kind == IRRADIANCE_LIGHT_OUT ? 0.0 : this->Position[i / 2];
          bounds[i] = centre + (i % 2 ? 1.0 : -1.0) * random.Uniform(0.05, 0.5);
        }
        this->Medium->SetBounds(bounds);
        this->Medium->SetRegionToBox();
        break;
      case IRRADIANCE_SPHERE_INSIDE:
      case IRRADIANCE_SPHERE_OUTSIDE:
        this->PlaceSphere(kind == IRRADIANCE_SPHERE_INSIDE, random);
        break;
      default:
        break;
    }
  }

  void PlaceSphere(bool holdsSurface, Random& random)
  {
    double radius = random.LogUniform(0.05, 0.6);
    glm::dvec3 centre = this->Position + 0.6 * radius * RandomUnit(random);
    if (holdsSurface)
    {
      centre = 0.5 * this->Position + 0.3 * RandomUnit(random);
      radius += std::max(glm::length(centre), glm::distance(centre, this->Position));
    }
    this->Medium->SetCenter(&centre.x);
    this->Medium->SetRadius(radius);
    this->Medium->SetRegionToSphere();
  }
};

//------------------------------------------------------------------------------
// Errors relative to the irradiance, or to 1e-7 of the light's strength where it is less.
double GetError(const glm::dvec3& value, const glm::dvec3& expected)
{
  double worst = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double error = std::abs(value[i] - expected[i]) / std::max(expected[i], 1e-7);
    worst = error <= worst ? worst : error; // keeps NaN
  }
  return worst;
}

// One family. The brute force is known to have converged because twice as many panels change every
// fourth setting by a fifth of the limit at most.
bool CompareFamily(int kind)
{
  const Family& family = GetFamily(kind);
  Comparison doubles(Text(family.Name, ", double precision, relative"));
  Comparison singles(Text(family.Name, ", single precision, relative"));
  Comparison brute(Text(family.Name, ", brute force against twice the panels, relative"));
  std::vector<double> errors;
  Random random(100 + kind);
  for (int i = 0; i < family.Count; ++i)
  {
    const Setting setting(kind, i, random);
    const Hemisphere hemisphere(setting.Medium, setting.Light, glm::dvec3(0.0), setting.Normal);
    glm::dvec3 expected = hemisphere.Irradiance(family.Fineness);
    const auto describe = [&] { return Text("setting ", i, ": ", setting.Describe()); };
    if (i % 4 == i / 4 % 4)
    {
      const glm::dvec3 finer = hemisphere.Irradiance(2 * family.Fineness);
      brute.Add(GetError(expected, finer), 0.2 * family.Limit, describe);
      expected = finer;
    }
    const airlight::f64::AirlightMedia media =
      airlight::ConvertMedia({ setting.Medium }, glm::dvec3(0.0));
    airlight::f64::AirlightLight light;
    airlight::ConvertLight(media, setting.Light, glm::dvec3(0.0), light);
    light.radius = 1e-5; // as the pass has it
    const double error = GetError(
      airlight::f64::airlightScatteredIrradiance(media, light, glm::dvec3(0.0), setting.Normal),
      expected);
    doubles.Add(error, family.Limit, describe);
    errors.push_back(GetError(airlight::f32::airlightScatteredIrradiance(ToSingle(media),
                                ToSingle(light), glm::vec3(0.0f), glm::vec3(setting.Normal)),
      expected));
    singles.Add(errors.back(), family.Limit, describe);
  }
  std::nth_element(errors.begin(), errors.begin() + family.Count / 2, errors.end());
  std::cout << family.Name << ": median " << errors[family.Count / 2] << "\n";
  return AllOk({ &doubles, &singles, &brute });
}
}

//------------------------------------------------------------------------------
int TestScatteredIrradiance(int, char*[])
{
  bool ok = true;
  for (int kind = 0; kind < IRRADIANCE_KINDS; ++kind)
  {
    ok = CompareFamily(kind) && ok;
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
