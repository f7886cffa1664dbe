// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPolyDataMapper, evaluated per fragment, pixel by pixel against vtkAirlight: kinds of
// lights, regions and phase functions, both projections, lit and translucent surfaces, a viewport
// off the window's origin, and a scene far from the world's.

#include "AirlightTestMapper.h"
#include "AirlightTestMatrix.h"

#include "vtkMath.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double ClosedForm = 1e-4;
constexpr double Quadrature = 1e-3;

//------------------------------------------------------------------------------
void SetFog(vtkParticipatingMedium* medium)
{
  // The second channel absorbs only.
  medium->SetScattering(0.05, 0.0, 0.1);
  medium->SetAbsorption(0.02, 0.06, 0.01);
  SetBox(medium, Box{ -5.0, 5.5, -4.0, 4.5, -5.0, 6.0 });
  medium->SetCenter(0.3, 0.2, 0.5);
  medium->SetRadius(4.0);
  medium->SetScaleHeight(2.5);
}

void TestKinds(Comparison& comparison)
{
  using Medium = vtkParticipatingMedium;
  const MatrixCell cells[] = { { MATRIX_POINT, Medium::UNBOUNDED, Medium::UNIFORM, MATRIX_FORWARD },
    { MATRIX_SPOT, Medium::BOX, Medium::UNIFORM, MATRIX_ISOTROPIC },
    { MATRIX_SUN, Medium::UNBOUNDED, Medium::EXPONENTIAL_HEIGHT, MATRIX_RAYLEIGH },
    { MATRIX_SPOT_EXPONENT, Medium::UNBOUNDED, Medium::UNIFORM, MATRIX_BACKWARD },
    { MATRIX_FALLOFF, Medium::SPHERE, Medium::UNIFORM, MATRIX_ISOTROPIC },
    { MATRIX_POINT, Medium::SURFACE, Medium::UNIFORM, MATRIX_MIE_MURKY } };
  MapperScene scene;
  SetFog(scene.Medium);
  vtkLight* light = scene.AddPointLight({ -1.5, 1.2, 2.0 }, { 40.0, 50.0, 20.0 });
  light->SetFocalPoint(0.5, -1.0, -1.0);
  for (const bool sphere : { false, true })
  {
    scene.Renderer->RemoveAllViewProps();
    scene.Add(sphere ? MakeSphere(2.0) : MakePlane(1));
    for (const bool parallel : { false, true })
    {
      scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      const std::vector<MapperSample> samples = scene.GetSamples();
      for (const MatrixCell& cell : cells)
      {
        cell.Apply(scene.Medium, light);
        const double limit = cell.HasClosedForm(true, scene.Medium) ? ClosedForm : Quadrature;
        scene.Compare(
          Text(cell.Describe(), sphere ? ", sphere" : ", plane", parallel ? ", parallel" : ""),
          samples, limit + scene.Medium->GetPhaseErrorBound(), comparison);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Lights that move with the camera, and all kinds together; quadrature.
void TestLights(Comparison& comparison)
{
  MapperScene scene;
  scene.Add(MakePlane(1));
  const std::vector<MapperSample> samples = scene.GetSamples();
  vtkNew<vtkLight> light;
  light->SetColor(0.5, 0.4, 0.3);
  light->SetAttenuationValues(0.3, 0.0, 0.2);
  scene.Mapper->SetLightScatters(light, true);
  for (const bool camera : { false, true })
  {
    scene.Renderer->RemoveAllLights();
    camera ? light->SetLightTypeToCameraLight() : light->SetLightTypeToHeadlight();
    camera ? light->SetPosition(0.3, 0.4, 0.2) : light->SetPosition(0.0, 0.0, 1.0);
    light->SetPositional(!camera);
    scene.Renderer->AddLight(light);
    scene.Compare(camera ? "camera light" : "headlight", samples, Quadrature, comparison);
  }
  for (int kind = 0; kind < MATRIX_LIGHTS; ++kind)
  {
    vtkLight* more = scene.AddPointLight({ kind - 2.0, 2.0, 1.0 + kind }, { 9.0, 7.0, 8.0 });
    MatrixCell{ kind, 0, 0, MATRIX_FORWARD }.Apply(scene.Medium, more);
    more->SetFocalPoint(0.1 * kind, -1.0, -1.0);
    scene.Compare(Text(kind + 2, " lights"), samples, Quadrature, comparison);
  }
}

//------------------------------------------------------------------------------
// A white diffuse surface shows I/pi cos(theta)/r^2 of a point light, times the transmittance from
// the light, all behind the medium.
void TestLitSurface(Comparison& comparison)
{
  MapperScene scene;
  const glm::dvec3 lamp(1.0, 0.5, 2.5);
  const glm::dvec3 intensity(60.0, 40.0, 50.0);
  scene.AddPointLight(lamp, intensity);
  scene.Add(MakePlane(1))->GetProperty()->LightingOn();
  scene.Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  scene.Actor->GetProperty()->SetInterpolationToFlat();
  const Triangle& triangle = scene.Triangles[0];
  const glm::dvec3 normal =
    glm::normalize(glm::cross(triangle.B - triangle.A, triangle.C - triangle.A));
  const FloatPicture picture = scene.Render();
  for (const MapperSample& sample : scene.GetSamples())
  {
    const glm::dvec3 point = sample.Ray.Origin + sample.Depth * sample.Ray.Direction;
    const double r = glm::distance(point, lamp);
    const double cosine = std::abs(glm::dot(normal, lamp - point)) / r;
    glm::dvec3 arrives;
    vtkAirlight::Transmittance(scene.Medium, &point.x, &lamp.x, &arrives.x);
    const glm::dvec3 colour = arrives * intensity / vtkMath::Pi() * cosine / (r * r);
    MapperScene::CompareColour(
      "lit", sample, picture, scene.Fog(sample.Ray, sample.Depth, colour), ClosedForm, comparison);
  }
}

//------------------------------------------------------------------------------
// Before an opaque plane: alpha (C1 T1 + L1) + (1 - alpha) (C2 T2 + L2), blended in single
// precision; then in the window's own ways, weighted and by depth peeling. There eight bits keep
// the plane behind, half a step times 1 - alpha, and both products of the sum, half a step each:
// 1.3.
void TestTranslucent(Comparison& comparison, Comparison& window)
{
  MapperScene scene;
  scene.AddPointLight({ 1.0, 1.5, 0.5 }, { 4.0, 3.0, 2.0 });
  const double alpha = 0.4;
  scene.Add(MakePlane(1, -3.0));
  const std::vector<Triangle> behind = scene.Triangles;
  scene.Add(MakePlane(1, 1.0))->GetProperty()->SetOpacity(alpha);
  const std::vector<MapperSample> samples = scene.GetSamples();
  const FloatPicture picture = scene.Render();
  scene.Renderer->SetPass(nullptr);
  const Picture weighted = Capture(scene.Window);
  scene.Renderer->UseDepthPeelingOn();
  const Picture peeled = Capture(scene.Window);
  scene.Triangles = behind;
  for (const MapperSample& sample : samples)
  {
    const double depth = scene.GetDepth(sample.I, sample.J);
    if (!std::isfinite(depth))
    {
      continue;
    }
    const glm::dvec3 expected = alpha * scene.Fog(sample.Ray, sample.Depth, scene.Colour) +
      (1.0 - alpha) * scene.Fog(sample.Ray, depth, scene.Colour);
    MapperScene::CompareColour("blended", sample, picture, expected, ClosedForm, comparison);
    CompareWindow(
      "weighted", weighted, PixelScene::Width, sample.I, sample.J, expected, 1.3, window);
    CompareWindow("peeled", peeled, PixelScene::Width, sample.I, sample.J, expected, 1.3, window);
  }
}

//------------------------------------------------------------------------------
// The window's own framebuffer, in a viewport off its corner.
void TestViewport(Comparison& comparison)
{
  MapperScene scene;
  scene.AddPointLight({ 1.0, 0.5, 0.5 }, { 4.0, 3.0, 2.0 });
  scene.Add(MakePlane(1));
  scene.Renderer->SetPass(nullptr);
  scene.Window->SetSize(2 * PixelScene::Width, 2 * PixelScene::Height);
  scene.Renderer->SetViewport(0.25, 0.5, 0.75, 1.0);
  const Picture picture = Capture(scene.Window);
  for (const MapperSample& sample : scene.GetSamples())
  {
    CompareWindow("viewport", picture, 2 * PixelScene::Width, sample.I + PixelScene::Width / 2,
      sample.J + PixelScene::Height, scene.Fog(sample.Ray, sample.Depth, scene.Colour), 1.0,
      comparison);
  }
}

//------------------------------------------------------------------------------
// All of a mesh that faces the camera is at one distance in parallel projection, its edges and
// vertices, too, wherever their pixels' centres are.
void TestLinesAndPoints(Comparison& comparison)
{
  MapperScene scene;
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->ParallelProjectionOn();
  scene.AddPointLight({ 1.0, 0.5, 2.0 }, { 4.0, 3.0, 2.0 });
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(4, 4);
  scene.Add(Make(plane));
  scene.Actor->SetScale(4.0);
  vtkProperty* property = scene.Actor->GetProperty();
  for (const int representation : { VTK_POINTS, VTK_WIREFRAME })
  {
    for (const float size : { 1.0f, 3.0f })
    {
      property->SetRepresentation(representation);
      property->SetLineWidth(size);
      property->SetPointSize(size);
      const FloatPicture picture = scene.Render();
      int count = 0;
      for (int pixel = 0; pixel < PixelScene::Width * PixelScene::Height; ++pixel)
      {
        const MapperSample sample{ pixel % PixelScene::Width, pixel / PixelScene::Width,
          scene.GetRay(pixel % PixelScene::Width, pixel / PixelScene::Width), 10.0 };
        if (picture[4 * pixel] > 0.0f) // the background is black
        {
          ++count;
          MapperScene::CompareColour(Text("representation ", representation, ", size ", size),
            sample, picture, scene.Fog(sample.Ray, sample.Depth, scene.Colour), ClosedForm,
            comparison);
        }
      }
      // 25 points, or five lines each way of 32 pixels.
      Check(count >= (representation == VTK_POINTS ? 25 : 250), "lines or points are drawn");
    }
  }
}

//------------------------------------------------------------------------------
// What single precision leaves, as the header states it: 2e-8 d/h where a ray passes at h a light
// that is d away. The picture of a telescope; rays within the light's radius are left out.
void TestNearLight(Comparison& comparison)
{
  MapperScene scene;
  scene.Renderer->GetActiveCamera()->SetViewAngle(0.05);
  const glm::dvec3 lamp(0.003, 0.2, 2.0);
  scene.AddPointLight(lamp, { 4.0, 3.0, 2.0 });
  scene.Add(MakePlane(1));
  const FloatPicture picture = scene.Render();
  for (const MapperSample& sample : scene.GetSamples())
  {
    const glm::dvec3 toLamp = lamp - sample.Ray.Origin;
    const double h = glm::length(glm::cross(toLamp, sample.Ray.Direction));
    if (h > 2e-5 * glm::length(toLamp))
    {
      MapperScene::CompareColour(Text("distance ", h), sample, picture,
        scene.Fog(sample.Ray, sample.Depth, scene.Colour),
        ClosedForm + 2e-8 * glm::length(toLamp) / h, comparison);
    }
  }
}

//------------------------------------------------------------------------------
// Single precision resolves no pixel there; positions relative to the eye do.
void TestFarFromOrigin(Comparison& comparison)
{
  MapperScene scene;
  const glm::dvec3 shift(1e6, -2e6, 3e6);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(shift.x, shift.y + 1.0, shift.z + 10.0);
  camera->SetFocalPoint(&shift.x);
  scene.AddPointLight(shift + glm::dvec3(1.0, 0.5, 0.5), { 10.0, 8.0, 6.0 });
  scene.Add(MakePlane(1));
  scene.Actor->SetPosition(shift.x, shift.y, shift.z);
  for (Triangle& triangle : scene.Triangles)
  {
    triangle = { triangle.A + shift, triangle.B + shift, triangle.C + shift };
  }
  scene.Compare("far from the origin", scene.GetSamples(), ClosedForm, comparison);
}
}

//------------------------------------------------------------------------------
int TestAirlightPolyDataMapper(int, char*[])
{
  Comparison kinds("kinds of lights and media");
  Comparison lights("headlight, camera light, several lights");
  Comparison lit("lit surface");
  Comparison translucent("translucent plane");
  Comparison window("window, viewport off the origin and translucent");
  Comparison lines("lines and points");
  Comparison near("rays close to a light");
  Comparison far("far from the origin");
  TestKinds(kinds);
  TestLights(lights);
  TestLitSurface(lit);
  TestTranslucent(translucent, window);
  TestViewport(window);
  TestLinesAndPoints(lines);
  TestNearLight(near);
  TestFarFromOrigin(far);
  const bool ok = AllOk({ &kinds, &lights, &lit, &translucent, &window, &lines, &near, &far });
  return ok && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
