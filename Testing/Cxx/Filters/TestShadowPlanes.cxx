// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadow planes as polygons: along random lines, crossing them counts the shadow volumes, which are
// the triangles between a point and the light; with caps they close exactly.

#include "AirlightTestCheck.h"
#include "AirlightTestSoup.h"

#include "vtkCellData.h"
#include "vtkCylinderSource.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkShadowPlanesFilter.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <cstdlib>
#include <string>

using namespace airlight_test;

namespace
{
constexpr double Far = 60.0;  // far enough for the random points
constexpr double Size = 2.5;  // of the region of these points
constexpr double Away = 40.0; // to leave all triangles behind
struct Case
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Data;
  glm::dvec4 Light; // w = 0: the direction towards it
};

std::vector<Case> MakeCases()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.9);
  sphere->SetThetaResolution(11);
  sphere->SetPhiResolution(9);
  sphere->Update();
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->CappingOff();
  cylinder->SetResolution(13);
  cylinder->SetHeight(1.7);
  cylinder->SetRadius(0.9);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cylinder->GetOutputPort());
  triangles->Update();
  Random random(17);
  const glm::dvec4 point(3.1, 2.3, 1.7, 1.0);
  const glm::dvec4 sun(0.31, 0.83, 0.447, 0.0); // sees no triangle of a lattice edge-on
  return { { "sphere", sphere->GetOutput(), point },
    { "sphere in the sun", sphere->GetOutput(), sun },
    { "open cylinder", triangles->GetOutput(), point },
    { "open cylinder in the sun", triangles->GetOutput(), sun },
    { "soup", MakeSoup(MakeLatticeSoup(random, 40)), point },
    { "soup in the sun", MakeSoup(MakeLatticeSoup(random, 40)), sun } };
}

void SetLight(vtkShadowPlanesFilter* filter, const glm::dvec4& light)
{
  filter->SetLightPosition(light.x, light.y, light.z);
  const glm::dvec3 direction = light.w != 0.0 ? glm::dvec3(0.0) : -glm::dvec3(light);
  filter->SetLightDirection(&direction.x);
}

vtkSmartPointer<vtkPolyData> MakePlanes(const Case& item, bool inBounds, bool lightCap, bool farCap)
{
  vtkNew<vtkShadowPlanesFilter> filter;
  filter->SetInputData(item.Data);
  SetLight(filter, item.Light);
  filter->SetFarDistance(Far);
  filter->SetBounds(-Size, Size, -Size, Size, -Size, Size);
  filter->SetExtent(inBounds ? vtkShadowPlanesFilter::BOUNDS : vtkShadowPlanesFilter::FAR_DISTANCE);
  filter->SetLightCap(lightCap);
  filter->SetFarCap(farCap);
  filter->Update();
  return filter->GetOutput();
}

glm::dvec3 RandomPoint(Random& random)
{
  const double x = random.Uniform(-Size, Size);
  const double y = random.Uniform(-Size, Size);
  return { x, y, random.Uniform(-Size, Size) };
}

//------------------------------------------------------------------------------
// From p to q the number of triangles between the point and the light changes by what is crossed.
void TestCrossings(const Case& item, bool inBounds, bool lightCap)
{
  const vtkSmartPointer<vtkPolyData> planes = MakePlanes(item, inBounds, lightCap, false);
  auto* weights = vtkIntArray::SafeDownCast(planes->GetCellData()->GetArray("Weight"));
  std::vector<vtkIdType> cells;
  const TriangleList pieces = GetFans(planes, &cells);
  const TriangleList casters = GetFans(item.Data);
  Random random(23);
  int wrong = 0;
  int changes = 0;
  for (int i = 0; i < 400; ++i)
  {
    const glm::dvec3 p = RandomPoint(random);
    const glm::dvec3 way = RandomPoint(random) - p;
    int crossed = 0;
    for (size_t k = 0; k < pieces.size(); ++k)
    {
      crossed += weights->GetValue(cells[k]) * Crosses(pieces[k], p, way);
    }
    // Without caps: who goes through a triangle from its lit side enters its volume.
    for (size_t k = 0; !lightCap && k < casters.size(); ++k)
    {
      const double facing = Facing(casters[k], item.Light);
      crossed += Crosses(casters[k], p, way) * (facing > 0.0 ? 1 : -1);
    }
    const int change =
      CountShadows(casters, item.Light, p + way, Away) - CountShadows(casters, item.Light, p, Away);
    wrong += crossed != change ? 1 : 0;
    changes += change != 0 ? 1 : 0;
  }
  const std::string name = Text(item.Name, inBounds ? ", cut" : "", lightCap ? ", capped" : "");
  Check(wrong == 0, Text(name, ": ", wrong, " lines cross other weights than shadows"));
  Check(changes > 50, name + ": the lines go into and out of shadows");
}

//------------------------------------------------------------------------------
// With both caps, every edge of the polygons is run along as often one way as the other, and the
// area vectors sum up to zero (Gauss).
void TestClosed(const Case& item, bool inBounds)
{
  const vtkSmartPointer<vtkPolyData> planes = MakePlanes(item, inBounds, true, true);
  auto* weights = vtkIntArray::SafeDownCast(planes->GetCellData()->GetArray("Weight"));
  std::map<std::pair<vtkIdType, vtkIdType>, int> runs;
  glm::dvec3 sum(0.0);
  double total = 0.0;
  std::vector<vtkIdType> cells;
  const TriangleList pieces = GetFans(planes, &cells);
  for (size_t k = 0; k < pieces.size(); ++k)
  {
    const glm::dvec3 area = 0.5 * weights->GetValue(cells[k]) *
      glm::cross(pieces[k][1] - pieces[k][0], pieces[k][2] - pieces[k][0]);
    sum += area;
    total += glm::length(area);
  }
  const std::string name = item.Name + (inBounds ? ", in bounds" : "");
  Check(total > 0.0 && glm::length(sum) < 1e-13 * total,
    Text(name, ": the area vectors sum up to ", glm::length(sum) / total, " of their lengths"));
  if (inBounds)
  {
    const double* bounds = planes->GetBounds();
    bool inside = true;
    for (int i = 0; i < 6; ++i)
    {
      inside = inside && std::abs(bounds[i]) <= Size * (1.0 + 1e-14);
    }
    Check(inside, name + ": nothing is outside the bounds");
    return;
  }
  for (vtkIdType cell = 0; cell < planes->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    planes->GetCellPoints(cell, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      runs[{ ids[k], ids[(k + 1) % size] }] += weights->GetValue(cell);
      runs[{ ids[(k + 1) % size], ids[k] }] -= weights->GetValue(cell);
    }
  }
  bool closed = true;
  for (const auto& run : runs)
  {
    closed = closed && run.second == 0;
  }
  Check(closed, name + ": planes and caps share all their edges");
}

//------------------------------------------------------------------------------
// The data of a point are those of the place on the mesh that its ray from the light meets.
void TestPointData(const Case& item, bool inBounds)
{
  vtkNew<vtkDoubleArray> places;
  places->SetName("places");
  places->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < item.Data->GetNumberOfPoints(); ++i)
  {
    places->InsertNextTuple(item.Data->GetPoint(i));
  }
  Case named = item;
  named.Data = vtkSmartPointer<vtkPolyData>::New();
  named.Data->ShallowCopy(item.Data);
  named.Data->GetPointData()->AddArray(places);
  const vtkSmartPointer<vtkPolyData> planes = MakePlanes(named, inBounds, true, true);
  vtkDataArray* passed = planes->GetPointData()->GetArray("places");
  double worst = passed && passed->GetNumberOfTuples() == planes->GetNumberOfPoints() ? 0.0 : 1.0;
  for (vtkIdType i = 0; worst == 0.0 && i < planes->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    glm::dvec3 place;
    planes->GetPoint(i, &p.x);
    passed->GetTuple(i, &place.x);
    const glm::dvec3 toPlace = glm::dvec3(item.Light) - item.Light.w * place;
    const double along = glm::dot(p - place, toPlace);
    const double aside = glm::length(glm::cross(p - place, toPlace)) / glm::length(toPlace);
    if (!(along <= 1e-11 && aside <= 1e-11))
    {
      worst = std::max(aside, along);
    }
  }
  Check(worst == 0.0,
    Text(item.Name, inBounds ? ", in bounds" : "", ": point data come along the rays, ", worst));
}

//------------------------------------------------------------------------------
void TestExtent()
{
  // A square of diagonal sqrt(8) on the ground under a lamp and in the sun.
  const TriangleList square{ { { { -1, 0, -1 }, { -1, 0, 1 }, { 1, 0, 1 } } },
    { { { -1, 0, -1 }, { 1, 0, 1 }, { 1, 0, -1 } } } };
  const double diagonal = std::sqrt(8.0);
  for (const glm::dvec4& light : { glm::dvec4(0.2, 1.5, 0.1, 1.0), glm::dvec4(0, 1, 0, 0) })
  {
    for (const double distance : { 0.0, 0.75 })
    {
      vtkNew<vtkShadowPlanesFilter> filter;
      filter->SetInputData(MakeSoup(square));
      SetLight(filter, light);
      filter->SetFarDistance(distance);
      filter->Update();
      vtkPolyData* planes = filter->GetOutput();
      Check(planes->GetNumberOfPolys() == 4 && planes->GetNumberOfPoints() == 8,
        "a square has four planes with common points");
      const double expected = distance > 0.0 ? distance : 2.0 * diagonal;
      auto* ends = vtkIdTypeArray::SafeDownCast(planes->GetCellData()->GetArray("EdgePoints"));
      for (vtkIdType i = 0; i < planes->GetNumberOfCells(); ++i)
      {
        // The near points, then the far ones: near A, far A, far B, near B.
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        planes->GetCellPoints(i, size, ids);
        glm::dvec3 p[4];
        for (int k = 0; k < 4; ++k)
        {
          planes->GetPoint(ids[k], &p[k].x);
        }
        glm::dvec3 a;
        filter->GetPolyDataInput(0)->GetPoint(ends->GetTypedComponent(i, 0), &a.x);
        const glm::dvec3 away = glm::normalize(light.w * p[0] - glm::dvec3(light));
        Check(size == 4 && p[0] == a && glm::length(p[1] - p[0] - expected * away) < 1e-13,
          "planes end at the far distance along the light's rays");
        // Fronts look out of the shadow, whose middle is below the square's.
        const glm::dvec3 normal = glm::cross(p[1] - p[0], p[3] - p[0]);
        Check(glm::dot(normal, p[0]) > 0.0, "fronts of planes look out of the shadow");
      }
    }
  }
}

//------------------------------------------------------------------------------
// A lamp so close to a large triangle that its far points pass the box on both sides: in bounds the
// planes fill the box all the same.
void TestCloseLamp()
{
  const TriangleList large{ { { { -30, 0, -20 }, { 0, 0, 40 }, { 30, 0, -20 } } } };
  const Case item{ "close lamp", MakeSoup(large), { 0.1, 0.01, 0.2, 1.0 } };
  const TriangleList small{ { { { -1, 0, -1 }, { 0, 0, 1 }, { 1, 0, -1 } } } };
  TestCrossings({ "closer lamp", MakeSoup(small), { 0.05, 0.02, 0.03, 1.0 } }, true, true);
  TestClosed(item, true);
  vtkNew<vtkShadowPlanesFilter> filter;
  filter->SetInputData(item.Data);
  SetLight(filter, item.Light);
  filter->SetExtentToBounds();
  filter->SetBounds(-1, 1, -2, -1, -1, 1);
  filter->FarCapOn();
  filter->LightCapOn();
  filter->Update();
  // The box is all in shadow: no plane, no light cap, and all six faces.
  Check(filter->GetOutput()->GetNumberOfPolys() == 6, "a box all in shadow has its own boundary");
}
}

//------------------------------------------------------------------------------
int TestShadowPlanes(int, char*[])
{
  for (const Case& item : MakeCases())
  {
    for (const bool inBounds : { false, true })
    {
      TestCrossings(item, inBounds, false);
      TestCrossings(item, inBounds, true);
      TestClosed(item, inBounds);
      TestPointData(item, inBounds);
    }
  }
  TestExtent();
  TestCloseLamp();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
