// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Grids of OpenVDB with transforms: every value in its place in the world.

#ifdef AIRLIGHT_HAS_OPENVDB
#include "AirlightTestReader.h"

#include "vtkMath.h"
#include "vtkMatrix3x3.h"

#include <algorithm>
#endif

#include <cstdlib>
#include <iostream>

#ifdef AIRLIGHT_HAS_OPENVDB
using namespace airlight_test;

namespace
{
std::string Folder;

//------------------------------------------------------------------------------
// Scaled, turned about x, turned about z, moved by (10, -20, 30).
void Place(const int voxel[3], const double scale[3], double x, double z, double world[3])
{
  double p[3] = { voxel[0] * scale[0], voxel[1] * scale[1], voxel[2] * scale[2] };
  const auto turn = [](double& a, double& b, double degrees) {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    const double turned = a * std::cos(angle) - b * std::sin(angle);
    b = a * std::sin(angle) + b * std::cos(angle);
    a = turned;
  };
  turn(p[1], p[2], x);
  turn(p[0], p[1], z);
  world[0] = p[0] + 10.0;
  world[1] = p[1] - 20.0;
  world[2] = p[2] + 30.0;
}

struct Blob
{
  int Voxel[3];
  double Value;
};

void CheckBlobs(const char* grid, const double scale[3], double x, double z,
  const std::initializer_list<Blob>& blobs)
{
  Reader reader(Folder + "rotated.vdb", grid);
  vtkImageData* image = reader.Read();
  double sum = 0.0;
  for (const Blob& blob : blobs)
  {
    double world[3];
    Place(blob.Voxel, scale, x, z, world);
    Check(GetValueAt(image, world) == blob.Value,
      Text(grid, ": ", blob.Value, " is at ", Text3(world), ", not ", GetValueAt(image, world)));
    sum += blob.Value;
  }
  Check(GetSum(image) == sum, Text(grid, ": all else is empty"));
  for (int axis = 0; axis < 3; ++axis)
  {
    Check(IsNear(image->GetSpacing()[axis], scale[axis], 1e-15), Text(grid, ": spacing"));
  }
}

void TestTransforms()
{
  const double red[3] = { 0.2, 0.3, 0.5 };
  CheckBlobs("red", red, 40.0, 30.0, { { { -3, 4, 5 }, 2.0 }, { { 8, -2, 1 }, 3.0 } });
  const double green[3] = { 0.1, 0.1, 0.1 };
  CheckBlobs("green", green, -70.0, 200.0, { { { 0, 0, 0 }, 5.0 }, { { 20, 10, -30 }, 7.0 } });
  Reader mirrored(Folder + "mirrored.vdb");
  const double one[3] = { -0.5, 3.0, 2.0 };
  const double two[3] = { -2.0, 3.0, 2.0 };
  vtkImageData* image = mirrored.Read();
  Check(GetValueAt(image, one) == 5.0 && GetValueAt(image, two) == 7.0 && GetSum(image) == 12.0,
    "a mirrored grid");
}

//------------------------------------------------------------------------------
// A grid without right angles is sampled. Linear interpolation of a function whose second
// derivatives are up to 1/width^2 is in error by at most the sum of step^2/(8 width^2) over the
// three steps, its integral (2 pi)^(3/2) width^3 by far less: `massLimit` is five times what it is.
void CheckCloud(const std::string& file, double steps2, double massLimit, int maximum, int warnings)
{
  Reader reader(Folder + file);
  reader->SetMaximumDimension(maximum);
  vtkImageData* image = reader.Read(warnings);
  double worst = 0.0;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    const double expected = Cloud(image->GetPoint(id), CloudCentre, CloudWidth);
    const double value = image->GetPointData()->GetScalars()->GetComponent(id, 0);
    worst = std::max(worst, std::abs(value - expected));
  }
  const double limit = steps2 / (8.0 * CloudWidth * CloudWidth);
  std::cout << file << ": " << image->GetDimensions()[0] << "x" << image->GetDimensions()[1] << "x"
            << image->GetDimensions()[2] << " points of " << image->GetSpacing()[0]
            << ", values within " << worst << ", limit " << limit << "\n";
  Check(worst <= limit, file + ": values of the cloud");
  const double* spacing = image->GetSpacing();
  const double mass = GetSum(image) * spacing[0] * spacing[1] * spacing[2];
  const double expected = std::pow(2.0 * vtkMath::Pi() * CloudWidth * CloudWidth, 1.5);
  std::cout << file << ": mass is in error by " << mass / expected - 1.0 << "\n";
  Check(std::abs(mass / expected - 1.0) <= massLimit, file + ": mass of the cloud");
  Check(image->GetDirectionMatrix()->IsIdentity(), file + ": along the axes of the world");
}

void TestResampled()
{
  // Steps of (0.1, 0, 0), (0.05, 0.1, 0), (0, 0, 0.1).
  CheckCloud("sheared.vdb", 0.01 + 0.0125 + 0.01, 3e-7, 512, 0);
  // The frustum is 4 (1 + z/4) wide: up to two widths of the cloud, voxels are 0.3 x 0.3 x 0.203,
  // and along the last one's edge x and y change by up to a third of the change of z.
  const double steps2 = 2.0 * 0.3 * 0.3 + 1.3 * 0.203 * 0.203;
  CheckCloud("frustum.vdb", steps2, 1.8e-4, 512, 0);
  // Steps twice as large, and means of two voxels half a step away: as much as one more step2.
  CheckCloud("frustum.vdb", 5.0 * steps2, 3.4e-4, 100, 1);
}
}
#endif

//------------------------------------------------------------------------------
int TestOpenVDBDensityReaderTransforms(int argc, char* argv[])
{
#ifdef AIRLIGHT_HAS_OPENVDB
  Folder = WriteFiles("TestOpenVDBDensityReaderTransforms", argc, argv);
  TestTransforms();
  TestResampled();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
#else
  (void)argc;
  (void)argv;
  std::cout << "skipped: built without OpenVDB\n";
  return 125;
#endif
}
