// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Several media, and lights at a region's face, by what must be the same picture: one box or two
// touching ones, two media in one place or one twice as dense, a light a little before or a little
// beyond a face, two lights together or one by one. The expected numbers are the pass' own.

#include "AirlightTestMatrix.h"
#include "AirlightTestPixelScene.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <vector>

using namespace airlight_test;

namespace
{
using Values = std::vector<double>;

class Experiment : public PixelScene
{
public:
  Experiment()
  {
    this->Pass->SetShadowTechniqueToNone();
    this->Renderer->AddLight(this->Light);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(1.0, 1.5, 7.0);
    camera->SetFocalPoint(0.1, 0.2, -0.3);
    camera->SetViewAngle(45.0);
    camera->SetClippingRange(0.1, 50.0);
    this->Light->SetColor(4.0, 7.0, 2.0);
  }

  Values Render(const char* name)
  {
    this->Window->Render();
    Values values;
    for (int pixel = 0; pixel < Width * Height; ++pixel)
    {
      const float* rgb = this->GetPixel(name, pixel % Width, pixel / Width);
      for (int k = 0; k < 3; ++k)
      {
        values.push_back(rgb ? rgb[k] : std::numeric_limits<double>::quiet_NaN());
      }
    }
    return values;
  }
};

void SetFog(vtkParticipatingMedium* medium, double scale)
{
  medium->SetScattering(0.2 * scale, 0.1 * scale, 0.3 * scale);
  medium->SetAbsorption(0.05 * scale, 0.1 * scale, 0.0);
}

// |got - expected| against `limit` of expected, with a floor of 1e-6 of the 99th percentile.
void CompareValues(const std::string& what, const Values& expected, const Values& got, double limit,
  Comparison& comparison)
{
  Values sorted = expected;
  std::sort(sorted.begin(), sorted.end());
  const double floor = 1e-6 * sorted[sorted.size() * 99 / 100];
  for (size_t i = 0; i < expected.size(); ++i)
  {
    comparison.Add(std::abs(got[i] - expected[i]), std::max(limit * expected[i], floor), [&] {
      return Text(what, ", pixel ", i / 3 % PixelScene::Width, " ", i / 3 / PixelScene::Width,
        ", channel ", i % 3, ": expected ", expected[i], ", got ", got[i]);
    });
  }
}

void PlaceLight(const MatrixCell& cell, Experiment& scene)
{
  cell.Apply(scene.Medium, scene.Light);
  scene.Light->SetPosition(-0.8, 1.1, 0.4);
  scene.Light->SetFocalPoint(0.5, -0.6, -0.3);
}

//------------------------------------------------------------------------------
// A box cut in two at each axis in turn: the parts' depths add up, and so does what they scatter.
bool TestTouchingBoxes()
{
  Comparison airlight("two touching boxes and one, Airlight");
  Comparison transmittance("two touching boxes and one, Transmittance, absolute");
  const double whole[6] = { -2.0, 2.5, -1.5, 2.0, -2.5, 1.8 };
  for (const int light : { MATRIX_POINT, MATRIX_SPOT, MATRIX_SPOT_EXPONENT, MATRIX_SUN })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const MatrixCell cell{ light, vtkParticipatingMedium::BOX, vtkParticipatingMedium::UNIFORM,
        axis == 1 ? MATRIX_ISOTROPIC : MATRIX_FORWARD };
      Experiment scene;
      PlaceLight(cell, scene);
      SetFog(scene.Medium, 1.0);
      scene.Medium->SetBounds(whole);
      const Values one = scene.Render("Airlight");
      const Values passes = scene.Render("Transmittance");

      vtkNew<vtkParticipatingMedium> other;
      cell.Apply(other, scene.Light);
      SetFog(other, 1.0);
      double part[6];
      std::copy_n(whole, 6, part);
      part[2 * axis] = 0.3;
      other->SetBounds(part);
      part[2 * axis] = whole[2 * axis];
      part[2 * axis + 1] = 0.3;
      scene.Medium->SetBounds(part);
      scene.Pass->AddMedium(other);
      const std::string what = Text(cell.Describe(), ", cut at axis ", axis);
      CompareValues(what, one, scene.Render("Airlight"), 1e-3, airlight);
      const Values both = scene.Render("Transmittance");
      for (size_t i = 0; i < both.size(); ++i)
      {
        transmittance.Add(std::abs(both[i] - passes[i]), 1e-6,
          [&] { return Text(what, ", value ", i, ": expected ", passes[i], ", got ", both[i]); });
      }
    }
  }
  return AllOk({ &airlight, &transmittance });
}

//------------------------------------------------------------------------------
// Where media overlap, their coefficients add.
bool TestOverlap()
{
  Comparison airlight("two media in one place and one twice as dense, Airlight");
  Comparison transmittance("two media in one place and one twice as dense, Transmittance");
  for (int light = 0; light < MATRIX_LIGHTS; ++light)
  {
    for (const int phase : { MATRIX_ISOTROPIC, MATRIX_FORWARD })
    {
      const MatrixCell cell{ light, vtkParticipatingMedium::UNBOUNDED,
        vtkParticipatingMedium::UNIFORM, phase };
      Experiment scene;
      PlaceLight(cell, scene);
      SetFog(scene.Medium, 2.0);
      // Over a part of the picture; without it all rays pass nothing.
      vtkNew<vtkPlaneSource> plane;
      plane->SetOrigin(-2.0, -3.0, -1.0);
      plane->SetPoint1(1.5, -2.5, 0.5);
      plane->SetPoint2(-1.0, 2.0, -0.5);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(plane->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      scene.Renderer->AddActor(actor);
      const Values one = scene.Render("Airlight");
      const Values passes = scene.Render("Transmittance");
      vtkNew<vtkParticipatingMedium> other;
      cell.Apply(other, scene.Light);
      SetFog(other, 1.0);
      SetFog(scene.Medium, 1.0);
      scene.Pass->AddMedium(other);
      CompareValues(cell.Describe(), one, scene.Render("Airlight"), 1e-3, airlight);
      CompareValues(cell.Describe(), passes, scene.Render("Transmittance"), 1e-6, transmittance);
    }
  }
  return AllOk({ &airlight, &transmittance });
}

//------------------------------------------------------------------------------
// From inside a region, where some lights have a closed form, out through its upper end, which lies
// above the picture: near a light that is seen, pixels are too far apart for a mean that is smooth.
// A step is 1e-3; the mean's trend is the line through its neighbours.
bool TestLightAtFace()
{
  Comparison comparison("light through a face, mean Radiance and its neighbours' trend");
  for (const int light : { MATRIX_POINT, MATRIX_SPOT, MATRIX_SPOT_EXPONENT, MATRIX_FALLOFF })
  {
    for (const int region : { vtkParticipatingMedium::BOX, vtkParticipatingMedium::SPHERE })
    {
      Experiment scene;
      const MatrixCell cell{ light, region, vtkParticipatingMedium::UNIFORM, MATRIX_FORWARD };
      cell.Apply(scene.Medium, scene.Light);
      SetFog(scene.Medium, 1.0);
      scene.Medium->SetBounds(-2.0, 2.5, -2.0, 3.0, -2.5, 1.8);
      scene.Medium->SetRadius(3.0);
      scene.Renderer->GetActiveCamera()->SetPosition(0.5, -0.5, 7.0);
      scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, -0.5, 0.0);
      scene.Renderer->GetActiveCamera()->SetViewAngle(20.0);
      std::vector<double> means;
      for (int step = -10; step <= 10; ++step)
      {
        // On the y axis, both regions end at 3.
        scene.Light->SetPosition(0.0, 3.0 + 1e-3 * (step + 0.5), 0.0);
        scene.Light->SetFocalPoint(0.2, -2.0, 0.3);
        double sum = 0.0;
        for (const double value : scene.Render("Radiance"))
        {
          sum += value;
        }
        means.push_back(sum);
      }
      for (size_t i = 1; i + 1 < means.size(); ++i)
      {
        const double trend = 0.5 * (means[i - 1] + means[i + 1]);
        comparison.Add(std::abs(means[i] - trend), 1e-3 * trend, [&] {
          return Text(cell.Describe(), ", step ", i, ": trend ", trend, ", got ", means[i]);
        });
      }
    }
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// Each light's own buffer; sums of two single-precision numbers, to a few roundings.
bool TestTwoLights()
{
  Comparison comparison("Airlight:0 + Airlight:1 and Airlight");
  for (int light = 0; light < MATRIX_LIGHTS; ++light)
  {
    for (int region = 0; region < 3; ++region)
    {
      Experiment scene;
      const MatrixCell cell{ light, region, vtkParticipatingMedium::UNIFORM, MATRIX_FORWARD };
      vtkNew<vtkLight> second;
      MatrixCell{ MATRIX_SPOT_EXPONENT, region, 0, MATRIX_FORWARD }.Apply(scene.Medium, second);
      second->SetPosition(2.0, 3.0, 3.0);
      second->SetFocalPoint(0.0, 0.0, 0.0);
      PlaceLight(cell, scene);
      SetFog(scene.Medium, 1.0);
      scene.Medium->SetBounds(-2.0, 2.5, -1.5, 2.0, -2.5, 1.8);
      scene.Medium->SetRadius(2.0);
      scene.Renderer->AddLight(second);
      const Values both = scene.Render("Airlight");
      Values sum = scene.Render("Airlight:0");
      const Values more = scene.Render("Airlight:1");
      double brightest[2] = { 0.0, 0.0 };
      for (size_t i = 0; i < sum.size(); ++i)
      {
        brightest[0] = std::max(brightest[0], sum[i]);
        brightest[1] = std::max(brightest[1], more[i]);
        sum[i] += more[i];
      }
      CompareValues(cell.Describe(), sum, both, 1e-6, comparison);
      comparison.Add(brightest[0] > 0.0 && brightest[1] > 0.0 ? 0.0 : 1.0, 0.5,
        [&] { return cell.Describe() + ": both lights are seen"; });
    }
  }
  return AllOk({ &comparison });
}
}

//------------------------------------------------------------------------------
int TestAirlightPassMedia(int, char*[])
{
  bool ok = TestTouchingBoxes();
  ok = TestOverlap() && ok;
  ok = TestLightAtFace() && ok;
  ok = TestTwoLights() && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
