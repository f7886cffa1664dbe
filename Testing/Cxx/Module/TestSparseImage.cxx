// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Optical depths through images that are mostly empty, whose empty blocks of cells are left in one
// step: along random rays, rays along the axes, and rays on the faces of blocks, against the sum of
// many samples of VTK's trilinear function.

#include "AirlightTestCheck.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPointData.h"
#include "vtkVoxel.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr int Steps = 40000;

// Puts random densities at the points of some small boxes, others stay 0, as those at the image's
// faces, where the density would jump.
void AddPuffs(vtkImageData* image, Random& random, int count)
{
  int size[3];
  image->GetDimensions(size);
  for (int n = 0; n < count; ++n)
  {
    int low[3];
    int high[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = 1 + random.Index(size[axis] - 2);
      high[axis] = std::min(low[axis] + 1 + random.Index(6), size[axis] - 1);
    }
    for (int k = low[2]; k < high[2]; ++k)
    {
      for (int j = low[1]; j < high[1]; ++j)
      {
        for (int i = low[0]; i < high[0]; ++i)
        {
          image->SetScalarComponentFromDouble(i, j, k, 0, random.Uniform(0.0, 2.0));
        }
      }
    }
  }
}

double GetDensity(vtkImageData* image, const glm::dvec3& point)
{
  int cell[3];
  double place[3];
  if (!image->ComputeStructuredCoordinates(&point.x, cell, place))
  {
    return 0.0;
  }
  double shares[8];
  vtkVoxel::InterpolationFunctions(place, shares);
  double density = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    density += shares[corner] == 0.0 ? 0.0
                                     : shares[corner] *
        image->GetScalarComponentAsDouble(
          cell[0] + (corner & 1), cell[1] + ((corner >> 1) & 1), cell[2] + (corner >> 2), 0);
  }
  return density;
}

double SumDepth(vtkImageData* image, const glm::dvec3& a, const glm::dvec3& b)
{
  double sum = 0.0;
  for (int i = 0; i < Steps; ++i)
  {
    sum += GetDensity(image, a + (i + 0.5) / Steps * (b - a));
  }
  return sum / Steps * glm::length(b - a);
}

// Every fourth ray is along an axis, and every other one of them in faces of blocks: the image's
// spacing is 1.
void FindRay(Random& random, const glm::dvec3& size, int number, glm::dvec3& a, glm::dvec3& b)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = random.Uniform(-5.0, size[axis] + 5.0);
    b[axis] = random.Uniform(-5.0, size[axis] + 5.0);
  }
  if (number % 4 == 0)
  {
    a = number % 8 == 0 ? 8.0 * glm::round(a / 8.0) : a;
    const int axis = random.Index(3);
    const double end = b[axis];
    b = a;
    a[axis] = end < 0.5 * size[axis] ? -3.0 : size[axis] + 2.0;
    b[axis] = end;
  }
}

bool CompareImage(std::uint64_t seed, const glm::ivec3& size, int puffs)
{
  Random random(seed);
  vtkNew<vtkImageData> image;
  image->SetDimensions(&size.x);
  image->AllocateScalars(VTK_DOUBLE, 1);
  image->GetPointData()->GetScalars()->Fill(0.0);
  AddPuffs(image, random, puffs);
  // Blocks begin at the first point.
  image->SetScalarComponentFromDouble(1, 1, 1, 0, 1.0);
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.0, 0.0, 0.0);
  medium->SetAbsorption(0.1, 0.1, 0.1);
  medium->SetDensityImage(image);
  medium->SetDensityToImage();
  Comparison depth(Text("optical depth, ", size.x, " x ", size.y, " x ", size.z, " samples"));
  int filled = 0;
  for (int i = 0; i < 120; ++i)
  {
    glm::dvec3 a;
    glm::dvec3 b;
    FindRay(random, size, i, a, b);
    const double expected = SumDepth(image, a, b);
    filled += expected > 0.0 ? 1 : 0;
    double passes[3];
    vtkAirlight::Transmittance(medium, &a.x, &b.x, passes);
    depth.Add(std::abs(-std::log(passes[0]) / 0.1 - expected), 1e-5 * expected + 1e-6, [&] {
      return Text("ray ", i, " from ", a.x, " ", a.y, " ", a.z, " to ", b.x, " ", b.y, " ", b.z,
        " of depth ", expected);
    });
  }
  const bool met = Check(filled > 20, Text(filled, " of 120 rays meet something"));
  return depth.Report() && met;
}

// A way in the last face of an image, along which a block is empty and the next one is not.
bool CompareLastFace()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(21, 21, 21);
  image->AllocateScalars(VTK_DOUBLE, 1);
  image->GetPointData()->GetScalars()->Fill(0.0);
  image->SetScalarComponentFromDouble(20, 5, 12, 0, 3.0);
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetAbsorption(0.1, 0.1, 0.1);
  medium->SetDensityImage(image);
  medium->SetDensityToImage();
  const double a[3] = { 20.0, 5.0, -1.0 };
  const double b[3] = { 20.0, 5.0, 21.0 };
  double passes[3];
  vtkAirlight::Transmittance(medium, a, b, passes);
  const double depth = -std::log(passes[0]) / 0.1;
  return Check(std::abs(depth - 3.0) < 1e-9, Text("in the last face, the depth is ", depth));
}
}

//------------------------------------------------------------------------------
int TestSparseImage(int, char*[])
{
  const bool sparse = CompareImage(8101, glm::ivec3(61, 27, 43), 60);
  const bool even = CompareImage(8102, glm::ivec3(33, 33, 33), 30);
  const bool narrow = CompareImage(8103, glm::ivec3(9, 80, 10), 15);
  const bool face = CompareLastFace();
  return sparse && even && narrow && face ? EXIT_SUCCESS : EXIT_FAILURE;
}
