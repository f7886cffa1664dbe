// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPolyDataMapper, evaluated at vertices. The meshes have their vertices where the rays
// of pixels' centres meet a plane: there the picture must be exact. Between them transmittance and
// airlight are linear on each triangle, and finer meshes come closer to the exact picture.

#include "AirlightTestMapper.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double ClosedForm = 1e-4;
constexpr int First = 4;  // pixels beside the mesh
constexpr int Cells = 32; // of pixels, a multiple of all steps

glm::dvec3 MeetPlane(const PixelRay& ray, const glm::dvec3& centre)
{
  const glm::dvec3 normal(0.1, -0.3, 1.0);
  const double t = glm::dot(normal, centre - ray.Origin) / glm::dot(normal, ray.Direction);
  return ray.Origin + t * ray.Direction;
}

// Triangles between every `step`th pixel's point on a plane through `centre`.
vtkSmartPointer<vtkPolyData> MakeMesh(MapperScene& scene, int step, const glm::dvec3& centre)
{
  const auto corner = [&](int a, int b) {
    return MeetPlane(scene.GetRay(First + step * a, First + step * b), centre);
  };
  std::vector<Triangle> triangles;
  for (int pixel = 0; pixel < (Cells / step) * (Cells / step); ++pixel)
  {
    const int a = pixel % (Cells / step);
    const int b = pixel / (Cells / step);
    triangles.push_back({ corner(a, b), corner(a + 1, b), corner(a + 1, b + 1) });
    triangles.push_back({ corner(a, b), corner(a + 1, b + 1), corner(a, b + 1) });
  }
  return MakeSoup(triangles);
}

struct Fog
{
  glm::dvec3 Passes, Added;
};

// The mathematics at a point of the world.
Fog At(MapperScene& scene, const glm::dvec3& point, const PixelRay& through)
{
  const bool parallel = scene.Renderer->GetActiveCamera()->GetParallelProjection();
  PixelRay ray = through;
  ray.Direction = parallel ? through.Direction : glm::normalize(point - through.Origin);
  const double t = glm::dot(point - through.Origin, ray.Direction);
  ray.Origin = point - t * ray.Direction;
  return { scene.GetTransmittance(ray, t), scene.GetAirlight(ray, t) };
}

// Linear on the triangle.
glm::dvec3 Interpolate(
  MapperScene& scene, const Triangle& triangle, const glm::dvec3& point, const PixelRay& ray)
{
  const glm::dvec3 corners[3] = { triangle.A, triangle.B, triangle.C };
  const glm::dvec3 normal = glm::cross(triangle.B - triangle.A, triangle.C - triangle.A);
  Fog sum{ glm::dvec3(0.0), glm::dvec3(0.0) };
  for (int k = 0; k < 3; ++k)
  {
    const glm::dvec3& b = corners[(k + 1) % 3];
    const glm::dvec3& c = corners[(k + 2) % 3];
    const double weight =
      glm::dot(normal, glm::cross(b - point, c - point)) / glm::dot(normal, normal);
    const Fog fog = At(scene, corners[k], ray);
    sum.Passes += weight * fog.Passes;
    sum.Added += weight * fog.Added;
  }
  return scene.Colour * sum.Passes + sum.Added;
}

const Triangle& FindTriangle(MapperScene& scene, const PixelRay& ray)
{
  const Triangle* nearest = &scene.Triangles[0];
  for (const Triangle& triangle : scene.Triangles)
  {
    if (std::isfinite(Hit(triangle, { ray.Origin, ray.Direction })))
    {
      nearest = &triangle;
    }
  }
  return *nearest;
}

// The largest difference, of the exact picture; not on the mesh's own edge, which rounding moves.
double GetLargestError(MapperScene& scene, const FloatPicture& picture, const glm::dvec3& centre)
{
  double largest = 0.0;
  for (int pixel = 0; pixel < (Cells - 1) * (Cells - 1); ++pixel)
  {
    const int i = First + 1 + pixel % (Cells - 1);
    const int j = First + 1 + pixel / (Cells - 1);
    const MapperSample sample{ i, j, scene.GetRay(i, j), 0.0 };
    const glm::dvec3 point = MeetPlane(sample.Ray, centre);
    const glm::dvec3 exact =
      scene.Fog(sample.Ray, glm::distance(point, sample.Ray.Origin), scene.Colour);
    for (int k = 0; k < 3; ++k)
    {
      const double got = picture[4 * (sample.J * PixelScene::Width + sample.I) + k];
      largest = std::max(largest, std::abs(got - exact[k]) / exact[k]);
    }
  }
  return largest;
}

//------------------------------------------------------------------------------
struct Comparisons
{
  Comparison Vertices{ "at the vertices" };
  Comparison Between{ "between the vertices, linear" };
};

// Returns the largest error between vertices.
double TestMesh(bool parallel, int step, const glm::dvec3& shift, Comparisons& comparisons)
{
  MapperScene scene;
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(shift.x, shift.y + 1.0, shift.z + 10.0);
  camera->SetFocalPoint(&shift.x);
  camera->SetParallelProjection(parallel);
  // Above the picture: near a visible light airlight is not smooth.
  scene.AddPointLight(shift + glm::dvec3(-0.5, 5.5, 1.5), { 40.0, 30.0, 20.0 });
  scene.Add(MakeMesh(scene, step, shift));
  scene.Mapper->SetEvaluationToVertex();
  const FloatPicture picture = scene.Render();
  const std::string what = Text(parallel ? "parallel" : "perspective", ", step ", step);
  for (int b = 1; b < Cells / step; ++b)
  {
    for (int a = 1; a < Cells / step; ++a)
    {
      const int i = First + step * a;
      const int j = First + step * b;
      const MapperSample vertex{ i, j, scene.GetRay(i, j), 0.0 };
      const glm::dvec3 point = MeetPlane(vertex.Ray, shift);
      const glm::dvec3 exact =
        scene.Fog(vertex.Ray, glm::distance(point, vertex.Ray.Origin), scene.Colour);
      MapperScene::CompareColour(what, vertex, picture, exact, ClosedForm, comparisons.Vertices);

      const MapperSample inner{ i + 1, j + 2, scene.GetRay(i + 1, j + 2), 0.0 };
      const glm::dvec3 linear =
        Interpolate(scene, FindTriangle(scene, inner.Ray), MeetPlane(inner.Ray, shift), inner.Ray);
      MapperScene::CompareColour(what, inner, picture, linear, ClosedForm, comparisons.Between);
    }
  }
  return GetLargestError(scene, picture, shift);
}

//------------------------------------------------------------------------------
// Evaluated per fragment in any case, since a geometry shader draws it.
void TestGeometryShader()
{
  MapperScene scene;
  scene.AddPointLight({ -0.5, 0.6, 1.5 }, { 40.0, 30.0, 20.0 });
  scene.Add(MakePlane(2));
  const FloatPicture plain = scene.Render();
  scene.Mapper->SetEvaluationToVertex();
  Check(scene.Render() != plain, "vertices and fragments differ on a coarse mesh");
  scene.Actor->GetProperty()->EdgeVisibilityOn();
  const FloatPicture vertices = scene.Render();
  scene.Mapper->SetEvaluationToFragment();
  Check(scene.Render() == vertices, "a surface with edges is evaluated per fragment");
  scene.Actor->GetProperty()->EdgeVisibilityOff();
  Check(scene.Render() == plain, "the first picture is there again");
}
}

//------------------------------------------------------------------------------
int TestAirlightPolyDataMapperVertices(int, char*[])
{
  Comparisons comparisons;
  for (const bool parallel : { false, true })
  {
    double before = 0.0;
    for (const int step : { 16, 8, 4 })
    {
      const double largest = TestMesh(parallel, step, glm::dvec3(0.0), comparisons);
      std::cout << (parallel ? "parallel" : "perspective") << ", vertices " << step
                << " pixels apart: largest error " << largest << "\n";
      // Linear interpolation of what is smooth leaves a fourth, less only as the mesh gets fine; an
      // error of the first order would leave a half.
      Check(before == 0.0 || largest < before / 2.5, "finer meshes come closer");
      before = largest;
    }
  }
  // VTK shifts and scales what it puts into vertex buffers there.
  TestMesh(false, 8, glm::dvec3(1e5, -2e5, 3e5), comparisons);
  TestGeometryShader();
  const bool ok = AllOk({ &comparisons.Vertices, &comparisons.Between });
  return ok && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
