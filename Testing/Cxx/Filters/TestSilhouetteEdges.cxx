// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Silhouettes: shapes whose edges and weights follow by hand, and random soups against the
// definition.

#include "AirlightTestCheck.h"
#include "AirlightTestSoup.h"

#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSilhouetteEdgesFilter.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

#include <cstdlib>
#include <string>

using namespace airlight_test;

namespace
{
void SetLight(vtkSilhouetteEdgesFilter* filter, const glm::dvec4& light)
{
  filter->SetLightPosition(light.x, light.y, light.z);
  const glm::dvec3 direction = light.w != 0.0 ? glm::dvec3(0.0) : -glm::dvec3(light);
  filter->SetLightDirection(&direction.x);
}

vtkSmartPointer<vtkPolyData> FindEdges(vtkPolyData* input, const glm::dvec4& light)
{
  vtkNew<vtkSilhouetteEdgesFilter> filter;
  filter->SetInputData(input);
  SetLight(filter, light);
  filter->Update();
  return filter->GetOutput();
}

// What the filter found. Checks on the way that the arrays belong to the lines.
EdgeWeights Read(vtkPolyData* lines, vtkPolyData* input, const std::string& name)
{
  auto* weights = vtkIntArray::SafeDownCast(lines->GetCellData()->GetArray("Weight"));
  auto* ends = vtkIdTypeArray::SafeDownCast(lines->GetCellData()->GetArray("EdgePoints"));
  EdgeWeights result;
  std::map<Position, int> leaving;
  bool ok = weights && ends && weights->GetNumberOfTuples() == lines->GetNumberOfCells();
  for (vtkIdType i = 0; ok && i < lines->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCellPoints(i, size, ids);
    Position p[2] = {};
    for (int k = 0; k < 2; ++k)
    {
      Position source;
      lines->GetPoint(ids[k], p[k].data());
      input->GetPoint(ends->GetTypedComponent(i, k), source.data());
      ok = ok && p[k] == source;
    }
    ok = ok && size == 2 && weights->GetValue(i) > 0 && result.count({ p[0], p[1] }) == 0;
    result[{ p[0], p[1] }] = weights->GetValue(i);
    leaving[p[0]] += weights->GetValue(i);
    leaving[p[1]] -= weights->GetValue(i);
  }
  Check(ok, name + ": lines once each, of positive weight, with their source points");
  for (const auto& [point, sum] : leaving)
  {
    ok = ok && sum == 0;
  }
  Check(ok, name + ": at every point as much arrives as leaves");
  return result;
}

EdgeWeights FindWeights(vtkPolyData* input, const glm::dvec4& light, const std::string& name)
{
  return Read(FindEdges(input, light), input, name);
}

bool AllHaveWeight(const EdgeWeights& edges, int weight)
{
  for (const auto& edge : edges)
  {
    if (edge.second != weight)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void TestCube()
{
  vtkNew<vtkCubeSource> cube; // half an edge is 0.5; every corner comes three times
  cube->Update();
  vtkPolyData* data = cube->GetOutput();
  // Only the face x = 0.5 sees the light: its four edges. Seen from there with z up, y grows to the
  // right, so that (y, z) = (-, -), (+, -), (+, +), (-, +) is anticlockwise, the shadow to the
  // left.
  const EdgeWeights one = FindWeights(data, { 5.0, 0.1, 0.2, 1.0 }, "cube, one face");
  const double h = 0.5;
  const EdgeWeights expected{ { { { h, -h, -h }, { h, h, -h } }, 2 },
    { { { h, h, -h }, { h, h, h } }, 2 }, { { { h, h, h }, { h, -h, h } }, 2 },
    { { { h, -h, h }, { h, -h, -h } }, 2 } };
  Check(one == expected, "cube: the four edges of the face that the light sees, anticlockwise");
  // Two faces in light are bounded by six edges, and so are three, a hexagon.
  for (const glm::dvec4& light : { glm::dvec4(5, 4, 0.1, 1), glm::dvec4(5, 4, 3, 1),
         glm::dvec4(5, 4, 3, 0), glm::dvec4(-1, 0.2, 1, 0) })
  {
    const EdgeWeights edges = FindWeights(data, light, "cube, several faces");
    Check(edges.size() == 6 && AllHaveWeight(edges, 2), "cube: six edges of weight 2");
  }
  const EdgeWeights inside = FindWeights(data, { 0.1, 0.2, -0.1, 1.0 }, "cube from inside");
  Check(inside.empty(), "a light inside a cube is shut in without any silhouette");
}

//------------------------------------------------------------------------------
void TestSheets()
{
  const TriangleList triangle{ { { { -2, 0, -1 }, { 2, 0.5, 0 }, { 0, 0.2, 2 } } } };
  const EdgeWeights three = FindWeights(MakeSoup(triangle), { 1, 4, 0, 1 }, "triangle");
  Check(three.size() == 3 && AllHaveWeight(three, 1), "a triangle: three edges of weight 1");
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(3, 2);
  plane->Update();
  const EdgeWeights border = FindWeights(plane->GetOutput(), { 0.1, 0.3, 2, 1 }, "sheet");
  Check(border.size() == 10 && AllHaveWeight(border, 1), "a sheet: its border of weight 1");
  Check(FindWeights(plane->GetOutput(), { 1, 2, 0, 0 }, "edge-on").empty(),
    "a sheet that the light sees edge-on casts nothing");
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(plane->GetOutput());
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(triangles->GetOutputPort());
  stripper->Update();
  Check(stripper->GetOutput()->GetNumberOfStrips() > 0 &&
      FindWeights(stripper->GetOutput(), { 0.1, 0.3, 2, 1 }, "strips") == border,
    "strips have the silhouette of their quads");
  // Twice the same sheet: twice the weight.
  TriangleList twice = GetFans(plane->GetOutput());
  const TriangleList once = twice;
  twice.insert(twice.end(), once.begin(), once.end());
  const EdgeWeights two = FindWeights(MakeSoup(twice), { 0.1, 0.3, 2, 1 }, "double sheet");
  Check(two.size() == 10 && AllHaveWeight(two, 2), "two sheets in one place: weight 2");
}

//------------------------------------------------------------------------------
// Triangles at one edge, from (0,0,0) to (0,0,1), lit from above (+y): the light sees tips at +x to
// the left of the edge and tips at -x to its right. n on the left and m on the right: weight n - m.
void TestNonManifold()
{
  const glm::dvec3 a(0, 0, 0);
  const glm::dvec3 b(0, 0, 1);
  for (int left = 0; left <= 3; ++left)
  {
    for (int right = 0; right <= 3; ++right)
    {
      TriangleList fan;
      for (int i = 0; i < left + right; ++i)
      {
        const glm::dvec3 tip(i < left ? 1.0 : -1.0, -0.1 * i, 0.5);
        fan.push_back({ a, i % 2 == 0 ? tip : b, i % 2 == 0 ? b : tip });
      }
      if (fan.empty())
      {
        continue;
      }
      const std::string name = Text("fan of ", left, " and ", right);
      EdgeWeights edges = FindWeights(MakeSoup(fan), { 0.0, 10.0, 0.5, 1.0 }, name);
      const auto take = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const auto found = edges.find({ ToPosition(from), ToPosition(to) });
        return found != edges.end() ? found->second : 0;
      };
      Check(take(a, b) == std::max(left - right, 0) && take(b, a) == std::max(right - left, 0),
        name + ": the middle edge's weight and direction");
      const size_t outer = 2 * fan.size();
      Check(edges.size() == outer + (left != right ? 1 : 0), name + ": the outer edges");
    }
  }
}

//------------------------------------------------------------------------------
void TestSoups()
{
  Random random(5);
  for (int i = 0; i < 200; ++i)
  {
    const TriangleList triangles = MakeLatticeSoup(random, 1 + i / 2);
    const glm::dvec4 light(
      random.Uniform(-3, 3), random.Uniform(-3, 3), random.Uniform(-3, 3), i % 3 == 0 ? 0.0 : 1.0);
    const std::string name = Text("soup ", i);
    const vtkSmartPointer<vtkPolyData> soup = MakeSoup(triangles);
    // The numbers are tame: the definition's facing is as exact as the filter's.
    const glm::dvec4 unit =
      light.w != 0.0 ? light : glm::dvec4(glm::normalize(glm::dvec3(light)), 0.0);
    Check(FindWeights(soup, light, name) == SumDirections(triangles, unit),
      name + ": the edges and weights of the definition");
  }
}

//------------------------------------------------------------------------------
void TestPointData()
{
  Random random(9);
  const vtkSmartPointer<vtkPolyData> soup = MakeSoup(MakeLatticeSoup(random, 30));
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("numbers");
  for (vtkIdType i = 0; i < soup->GetNumberOfPoints(); ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i));
  }
  soup->GetPointData()->AddArray(numbers);
  const vtkSmartPointer<vtkPolyData> lines = FindEdges(soup, { 4.1, 3.3, 5.7, 1.0 });
  vtkDataArray* passed = lines->GetPointData()->GetArray("numbers");
  bool ok = passed && passed->GetNumberOfTuples() == lines->GetNumberOfPoints();
  for (vtkIdType i = 0; ok && i < lines->GetNumberOfPoints(); ++i)
  {
    // The first of the points at the position.
    vtkIdType first = 0;
    Position p;
    Position q;
    lines->GetPoint(i, p.data());
    for (soup->GetPoint(first, q.data()); q != p; soup->GetPoint(++first, q.data()))
    {
    }
    ok = passed->GetTuple1(i) == static_cast<double>(first);
  }
  Check(ok, "point data are those of the first point at each position");
}

//------------------------------------------------------------------------------
void TestLights()
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  vtkPolyData* data = cube->GetOutput();
  vtkNew<vtkSilhouetteEdgesFilter> filter;
  filter->SetInputData(data);
  const auto find = [&] {
    filter->Update();
    return Read(filter->GetOutput(), data, "lights");
  };
  filter->SetLightPosition(5, 4, 3);
  const EdgeWeights point = find();
  filter->SetLightDirection(-3, 0.1, 0.2);
  const EdgeWeights sun = find();
  vtkNew<vtkLight> light;
  light->SetPositional(true);
  light->SetPosition(0.1, 0.2, 7);
  filter->SetLight(light);
  const EdgeWeights lamp = find();
  Check(point == FindWeights(data, { 5, 4, 3, 1 }, "point"), "LightPosition alone");
  Check(sun == FindWeights(data, { 3, -0.1, -0.2, 0 }, "sun"), "LightDirection before it");
  Check(lamp == FindWeights(data, { 0.1, 0.2, 7, 1 }, "lamp"), "a vtkLight before both");
  light->SetPosition(5, 4, 3);
  Check(find() == point, "a vtkLight that moves");
  light->PositionalOff();
  light->SetFocalPoint(2, 4.1, 3.2);
  Check(find() == sun, "a directional vtkLight");
  vtkNew<vtkMatrix4x4> matrix; // swaps x and z
  const double rows[16] = { 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1 };
  matrix->DeepCopy(rows);
  light->SetTransformMatrix(matrix);
  Check(find() == FindWeights(data, { -0.2, -0.1, 3, 0 }, "matrix"), "a vtkLight's matrix");
  matrix->Identity();
  Check(find() == sun, "a matrix that changes");
  filter->SetLight(nullptr);
  filter->SetLightDirection(0, 0, 0);
  Check(find() == point, "the numbers count again where there is no light");
}
}

//------------------------------------------------------------------------------
int TestSilhouetteEdges(int, char*[])
{
  TestCube();
  TestSheets();
  TestNonManifold();
  TestSoups();
  TestPointData();
  TestLights();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
