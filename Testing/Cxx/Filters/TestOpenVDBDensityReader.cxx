// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Grids that OpenVDB wrote, as images: every value in its place, and the sums of large ones.

#ifdef AIRLIGHT_HAS_OPENVDB
#include "AirlightTestReader.h"

#include "vtkMath.h"

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
// All values of noise.vdb are exact, also in half precision; around them is one point of 0.
void CheckNoise(vtkImageData* image, const std::string& name)
{
  Check(HasSize(image, 22, 18, 14), name + ": a point per voxel, and one more on each side");
  Check(std::string(image->GetPointData()->GetScalars()->GetName()) == "noise",
    name + ": the array has the grid's name");
  int different = 0;
  for (int k = NoiseLow[2] - 1; k <= NoiseHigh[2] + 1; ++k)
  {
    for (int j = NoiseLow[1] - 1; j <= NoiseHigh[1] + 1; ++j)
    {
      for (int i = NoiseLow[0] - 1; i <= NoiseHigh[0] + 1; ++i)
      {
        const bool inside = i >= NoiseLow[0] && i <= NoiseHigh[0] && j >= NoiseLow[1] &&
          j <= NoiseHigh[1] && k >= NoiseLow[2] && k <= NoiseHigh[2];
        const double world[3] = { 0.25 * i, 0.25 * j, 0.25 * k };
        different += GetValueAt(image, world) == (inside ? Noise(i, j, k) : 0.0) ? 0 : 1;
      }
    }
  }
  Check(different == 0, Text(name, ": ", different, " values differ"));
}

void TestValues()
{
  CheckNoise(Reader(Folder + "noise.vdb").Read(), "float");
  CheckNoise(Reader(Folder + "half.vdb").Read(), "half");
  Reader stream(Folder + "stream.vdb");
  vtkImageData* first = stream.Read();
  const double world[3] = { 3.0, 2.0, 0.0 };
  Check(GetValueAt(first, world) == 203.0, "the first scalar grid is the default; double");
  stream->SetGridName("noise");
  CheckNoise(stream.Read(), "a file without offsets");
  stream->SetFileName((Folder + "noise.vdb").c_str());
  CheckNoise(stream.Read(), "another file");
}

//------------------------------------------------------------------------------
// The integral through the image by the trapezoidal rule is the sum of the voxels times their size:
// nothing is lost at the rim.
void TestOpticalDepth()
{
  vtkNew<vtkImageData> image;
  image->DeepCopy(Reader(Folder + "noise.vdb").Read());
  double expected = 0.0;
  for (int i = NoiseLow[0]; i <= NoiseHigh[0]; ++i)
  {
    expected += 0.25 * Noise(i, 10, 5);
  }
  double depth = 0.0;
  for (int i = 0; i + 1 < 22; ++i)
  {
    const int j = 10 - NoiseLow[1] + 1;
    const int k = 5 - NoiseLow[2] + 1;
    depth += 0.125 * image->GetScalarComponentAsDouble(i, j, k, 0);
    depth += 0.125 * image->GetScalarComponentAsDouble(i + 1, j, k, 0);
  }
  Check(IsNear(depth, expected, 1e-12), Text("optical depth ", depth, ", expected ", expected));
}

// Means of blocks of factor^3 voxels, the last ones partly outside, of any value by index.
template <typename Value>
void CheckMeans(vtkImageData* image, const int low[3], int factor, double size, const Value& value)
{
  const int* points = image->GetDimensions();
  double worst = 0.0;
  for (int id = 0; id < points[0] * points[1] * points[2]; ++id)
  {
    const int point[3] = { id % points[0], id / points[0] % points[1], id / points[0] / points[1] };
    double mean = 0.0;
    double world[3] = { 0.0, 0.0, 0.0 };
    for (int voxel = 0; voxel < factor * factor * factor; ++voxel)
    {
      const int offset[3] = { voxel % factor, voxel / factor % factor, voxel / factor / factor };
      int index[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        index[axis] = low[axis] + (point[axis] - 1) * factor + offset[axis];
        world[axis] += size * index[axis] / (factor * factor * factor);
      }
      mean += value(index) / (factor * factor * factor);
    }
    worst = std::max(worst, std::abs(GetValueAt(image, world) - mean));
  }
  Check(worst <= 1e-6, Text("mean values differ by ", worst));
}

void TestReduced()
{
  Reader noise(Folder + "noise.vdb");
  noise->SetMaximumDimension(10); // 20 voxels in 8 points of 3
  vtkImageData* image = noise.Read(1);
  Check(noise->GetReductionFactor() == 3 && HasSize(image, 9, 8, 6), "noise is read at a third");
  for (const char* word : { "noise.vdb", "20x16x12", "1/3", "MaximumDimension is 10" })
  {
    Check(noise.Warnings.GetText().find(word) != std::string::npos,
      std::string("the warning says ") + word + ": " + noise.Warnings.GetText());
  }
  CheckMeans(image, NoiseLow, 3, 0.25, [](const int v[3]) {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      inside = inside && v[axis] >= NoiseLow[axis] && v[axis] <= NoiseHigh[axis];
    }
    return inside ? Noise(v[0], v[1], v[2]) : 0.0;
  });
  // Large boxes of one value, which are stored as such.
  Reader tiles(Folder + "tiles.vdb");
  const auto tile = [](const int v[3]) {
    const bool inside = v[0] >= 0 && v[0] < 64 && v[1] >= 0 && v[1] < 32 && v[2] >= 0 && v[2] < 16;
    return inside ? 2.0 : v[0] == 64 && v[1] == 0 && v[2] == 0 ? 1.0 : 0.0;
  };
  const int zero[3] = { 0, 0, 0 };
  CheckMeans(tiles.Read(), zero, 1, 1.0, tile);
  tiles->SetMaximumDimension(16); // 65 voxels in 13 points of 5
  CheckMeans(tiles.Read(1), zero, 5, 1.0, tile);
}

// 4e9 voxels wide and empty: the means keep the sum.
void TestSparse()
{
  Reader sparse(Folder + "sparse.vdb");
  sparse->SetMaximumDimension(64);
  vtkImageData* image = sparse.Read(1);
  const auto factor = static_cast<double>(sparse->GetReductionFactor());
  Check(factor == std::ceil(4000000001.0 / 62.0), Text("sparse: factor ", factor));
  Check(image->GetDimensions()[0] <= 64, "sparse: the image is small");
  const double sum = GetSum(image) * factor * factor * factor;
  Check(IsNear(sum, 3.0 + 5.0 + 8 * 7.0, 1e-4), Text("sparse: the sum is ", sum));
  Check(IsNear(image->GetOrigin()[0], -2e9 - 0.5 - 0.5 * factor, 1e-3), "sparse: the origin");
}

//------------------------------------------------------------------------------
// A fog sphere: at the distance r from its centre min(1, max(0, (radius - r)/band)).
void CheckSphere(
  vtkImageData* image, const double centre[3], double radius, const std::string& name)
{
  double worst = 0.0;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    const double r = std::sqrt(vtkMath::Distance2BetweenPoints(image->GetPoint(id), centre));
    const double expected = std::min(1.0, std::max(0.0, (radius - r) / 0.3));
    const double value = image->GetPointData()->GetScalars()->GetComponent(id, 0);
    worst = std::max(worst, std::abs(value - expected));
  }
  Check(worst <= 2e-6, Text(name, ": values differ by ", worst));
  Check(IsNear(image->GetPointData()->GetScalars()->GetRange()[1], 1.0, 1e-6), name + ": full fog");
}

void TestSpheres()
{
  Reader types(Folder + "types.vdb");
  types->UpdateInformation();
  Check(types->GetNumberOfGrids() == 3 && std::string(types->GetGridName(0)) == "velocity" &&
      std::string(types->GetGridType(0)) == "vec3s" &&
      std::string(types->GetGridName(1)) == "points" &&
      std::string(types->GetGridType(1)) == "ptdataidx32" &&
      std::string(types->GetGridName(2)) == "fog" && std::string(types->GetGridType(2)) == "float",
    "the grids of a file are listed in its order");
  Check(std::string(types->GetGridName(3)).empty() && std::string(types->GetGridName(-1)).empty(),
    "a grid that is not there has no name");
  Check(types.Object->GetOutput()->GetNumberOfPoints() == 0, "the list needs no voxels");
  const double fog[3] = { 1.0, 2.0, 3.0 };
  CheckSphere(types.Read(), fog, 1.5, "fog sphere");
  const double ball[3] = { static_cast<double>(0.3f), 0.0, 0.0 };
  CheckSphere(Reader(Folder + "levelset.vdb").Read(), ball, 2.0, "level set");
}

//------------------------------------------------------------------------------
void TestSpecials()
{
  const double zero[3] = { 0.0, 0.0, 0.0 };
  const double next[3] = { 1.0, 0.0, 0.0 };
  const double third[3] = { 3.0, 0.0, 0.0 };
  const double ten[3] = { 10.0, 0.0, 0.0 };
  Reader haze(Folder + "background.vdb");
  vtkImageData* image = haze.Read();
  Check(GetValueAt(image, zero) == 1.0 && GetValueAt(image, next) == 0.25 &&
      GetValueAt(image, third) == 2.0 && GetSum(image) == 3.0 + 0.25 * (6 * 3 * 3 - 2),
    "a background that is not 0");

  Reader bad(Folder + "nan.vdb");
  image = bad.Read(1);
  Check(GetValueAt(image, zero) == 1.0 && GetValueAt(image, third) == 4.0 && GetSum(image) == 5.0,
    "values that are not finite count as background");
  Check(bad.Warnings.GetText().find("2 values") != std::string::npos, "how many there are");

  Reader names(Folder + "names.vdb", "twin[1]");
  const double two[3] = { 2.0, 0.0, 0.0 };
  image = names.Read();
  Check(GetValueAt(image, two) == 2.0 && GetSum(image) == 2.0, "the second of a name");
  names->SetGridName("shared");
  Check(GetValueAt(names.Read(), ten) == 1.0, "a grid that shares another's voxels");
  names->SetGridName(nullptr);
  Check(GetValueAt(names.Read(), next) == 1.0, "the first grid");
}
}
#endif

//------------------------------------------------------------------------------
int TestOpenVDBDensityReader(int argc, char* argv[])
{
#ifdef AIRLIGHT_HAS_OPENVDB
  Folder = WriteFiles("TestOpenVDBDensityReader", argc, argv);
  TestValues();
  TestOpticalDepth();
  TestReduced();
  TestSparse();
  TestSpheres();
  TestSpecials();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
#else
  (void)argc;
  (void)argv;
  std::cout << "skipped: built without OpenVDB\n";
  return 125;
#endif
}
