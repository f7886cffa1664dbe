// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestOpenVDB.h"

#include "AirlightTestPlume.h"

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>

#include <fstream>
#include <limits>

namespace airlight_test
{
namespace
{
using openvdb::Coord;
using openvdb::FloatGrid;
using openvdb::Mat4d;
using openvdb::Vec3d;
using openvdb::math::Transform;
constexpr double Degree = 0.017453292519943295;

class Writer
{
public:
  explicit Writer(const std::string& folder)
    : Folder(folder)
  {
  }

  void Write(const std::string& name, const openvdb::GridPtrVec& grids) const
  {
    openvdb::io::File file(this->Folder + name);
    file.write(grids);
    file.close();
  }

  void WriteStream(const std::string& name, const openvdb::GridPtrVec& grids) const
  {
    std::ofstream file(this->Folder + name, std::ios::binary);
    openvdb::io::Stream(file).write(grids);
  }

private:
  std::string Folder;
};

// A linear transform by the steps from voxel to voxel.
Transform::Ptr MakeTransform(const Vec3d& x, const Vec3d& y, const Vec3d& z)
{
  Mat4d matrix = Mat4d::identity();
  int row = 0;
  for (const Vec3d& step : { x, y, z })
  {
    matrix.setRow(row++, openvdb::Vec4d(step[0], step[1], step[2], 0.0));
  }
  return Transform::createLinearTransform(matrix);
}

FloatGrid::Ptr MakeGrid(const std::string& name, float background = 0.0f)
{
  const FloatGrid::Ptr grid = FloatGrid::create(background);
  grid->setName(name);
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  return grid;
}

FloatGrid::Ptr MakeVoxel(const std::string& name, const Coord& voxel, float value)
{
  const FloatGrid::Ptr grid = MakeGrid(name);
  grid->tree().setValue(voxel, value);
  return grid;
}

FloatGrid::Ptr MakeNoise()
{
  const FloatGrid::Ptr grid = MakeGrid("noise");
  grid->setTransform(Transform::createLinearTransform(0.25));
  for (int k = NoiseLow[2]; k <= NoiseHigh[2]; ++k)
  {
    for (int j = NoiseLow[1]; j <= NoiseHigh[1]; ++j)
    {
      for (int i = NoiseLow[0]; i <= NoiseHigh[0]; ++i)
      {
        grid->tree().setValue(Coord(i, j, k), static_cast<float>(Noise(i, j, k)));
      }
    }
  }
  return grid;
}

openvdb::GridBase::Ptr MakeDouble()
{
  const openvdb::DoubleGrid::Ptr grid = openvdb::DoubleGrid::create();
  grid->setName("first");
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      grid->tree().setValue(Coord(i, j, 0), i + 100.0 * j);
    }
  }
  return grid;
}

openvdb::GridBase::Ptr MakeVectors()
{
  const openvdb::Vec3SGrid::Ptr grid = openvdb::Vec3SGrid::create();
  grid->setName("velocity");
  grid->tree().setValue(Coord(1, 2, 3), openvdb::Vec3s(1, 2, 3));
  return grid;
}

openvdb::GridBase::Ptr MakePoints()
{
  const openvdb::GridBase::Ptr grid = openvdb::GridBase::createGrid("Tree_ptdataidx32_5_4_3");
  grid->setName("points");
  return grid;
}

FloatGrid::Ptr MakeFogSphere()
{
  const auto grid =
    openvdb::tools::createLevelSetSphere<FloatGrid>(1.5f, openvdb::Vec3f(1, 2, 3), 0.1f, 3.0f);
  openvdb::tools::sdfToFogVolume(*grid);
  grid->setName("fog");
  return grid;
}

// Scale, then rotate about x, then about z, then move: as the test says it in words of its own.
FloatGrid::Ptr MakeRotated(const std::string& name, const Vec3d& scale, double x, double z)
{
  const FloatGrid::Ptr grid = MakeGrid(name);
  const Transform::Ptr transform = Transform::createLinearTransform(1.0);
  transform->postScale(scale);
  transform->postRotate(x * Degree, openvdb::math::X_AXIS);
  transform->postRotate(z * Degree, openvdb::math::Z_AXIS);
  transform->postTranslate(Vec3d(10, -20, 30));
  grid->setTransform(transform);
  return grid;
}

openvdb::GridPtrVec MakeRotated()
{
  const FloatGrid::Ptr red = MakeRotated("red", Vec3d(0.2, 0.3, 0.5), 40.0, 30.0);
  red->tree().setValue(Coord(-3, 4, 5), 2.0f);
  red->tree().setValue(Coord(8, -2, 1), 3.0f);
  const FloatGrid::Ptr green = MakeRotated("green", Vec3d(0.1), -70.0, 200.0);
  green->tree().setValue(Coord(0, 0, 0), 5.0f);
  green->tree().setValue(Coord(20, 10, -30), 7.0f);
  return { red, green };
}

FloatGrid::Ptr MakeMirrored()
{
  const FloatGrid::Ptr grid = MakeGrid("mirrored");
  grid->setTransform(MakeTransform(Vec3d(-0.5, 0, 0), Vec3d(0, 0, 1), Vec3d(0, 1, 0)));
  grid->tree().setValue(Coord(1, 2, 3), 5.0f);
  grid->tree().setValue(Coord(4, 2, 3), 7.0f);
  return grid;
}

// Samples the cloud where the transform has the voxels of a box.
FloatGrid::Ptr MakeCloud(const Transform::Ptr& transform, const openvdb::CoordBBox& box)
{
  const FloatGrid::Ptr grid = MakeGrid("cloud");
  grid->setTransform(transform);
  for (const Coord& voxel : box)
  {
    const Vec3d world = transform->indexToWorld(voxel);
    const double value = Cloud(world.asPointer(), CloudCentre, CloudWidth);
    grid->tree().setValue(voxel, static_cast<float>(value));
  }
  return grid;
}

FloatGrid::Ptr MakeSheared()
{
  const Transform::Ptr transform =
    MakeTransform(Vec3d(0.1, 0, 0), Vec3d(0.05, 0.1, 0), Vec3d(0, 0, 0.1));
  return MakeCloud(transform, { Coord(-50, -45, 15), Coord(58, 45, 105) });
}

// From 4 units wide near the eye to 16 far away, 12 deep.
FloatGrid::Ptr MakeFrustum()
{
  const openvdb::BBoxd box(Vec3d(0.0), Vec3d(39, 39, 59));
  const Transform::Ptr transform = Transform::createFrustumTransform(box, 0.25, 3.0, 4.0);
  return MakeCloud(transform, { Coord(0), Coord(39, 39, 59) });
}

FloatGrid::Ptr MakeTiles()
{
  const FloatGrid::Ptr grid = MakeVoxel("tiles", Coord(64, 0, 0), 1.0f);
  grid->fill({ Coord(0), Coord(63, 31, 15) }, 2.0f);
  return grid;
}

// Smoke; where there is next to none, the background stays.
FloatGrid::Ptr MakePlume()
{
  const FloatGrid::Ptr grid = MakeGrid("density");
  const Transform::Ptr transform = Transform::createLinearTransform(PlumeVoxel);
  const Vec3d axis(0.5 * PlumeSize[0], 0.0, 0.5 * PlumeSize[2]);
  transform->postTranslate(PlumeVoxel * (Vec3d(0.5) - axis));
  grid->setTransform(transform);
  const openvdb::CoordBBox box(
    Coord(0), Coord(PlumeSize[0] - 1, PlumeSize[1] - 1, PlumeSize[2] - 1));
  FloatGrid::Accessor accessor = grid->getAccessor();
  for (const Coord& voxel : box)
  {
    const Vec3d place = voxel.asVec3d() + Vec3d(0.5) - axis;
    const double value =
      Plume(place[0] / PlumeSize[0], place[1] / PlumeSize[1], place[2] / PlumeSize[2]);
    if (value > 0.002)
    {
      accessor.setValue(voxel, static_cast<float>(value));
    }
  }
  return grid;
}

FloatGrid::Ptr MakeSparse()
{
  constexpr int far = 2000000000;
  const FloatGrid::Ptr grid = MakeVoxel("specks", Coord(-far), 3.0f);
  grid->tree().setValue(Coord(far), 5.0f);
  for (int i = 0; i < 8; ++i)
  {
    grid->tree().setValue(Coord(far - i, 0, 0), 7.0f);
  }
  return grid;
}

FloatGrid::Ptr MakeBad()
{
  const FloatGrid::Ptr grid = MakeVoxel("bad", Coord(0, 0, 0), 1.0f);
  grid->tree().setValue(Coord(1, 0, 0), std::numeric_limits<float>::quiet_NaN());
  grid->tree().setValue(Coord(2, 0, 0), std::numeric_limits<float>::infinity());
  grid->tree().setValue(Coord(3, 0, 0), 4.0f);
  return grid;
}

openvdb::GridPtrVec MakeNames()
{
  const FloatGrid::Ptr first = MakeVoxel("twin", Coord(1, 0, 0), 1.0f);
  const FloatGrid::Ptr shared = FloatGrid::create(first->treePtr());
  shared->setName("shared");
  shared->setTransform(Transform::createLinearTransform(10.0));
  return { first, MakeVoxel("twin", Coord(2, 0, 0), 2.0f), MakeVoxel("", Coord(3, 0, 0), 3.0f),
    shared };
}
}

//------------------------------------------------------------------------------
void WriteOpenVDBFiles(const std::string& folder)
{
  openvdb::initialize();
  const Writer writer(folder);
  const FloatGrid::Ptr noise = MakeNoise();
  writer.Write("noise.vdb", { noise });
  const FloatGrid::Ptr half = noise->deepCopy();
  half->setSaveFloatAsHalf(true);
  writer.Write("half.vdb", { half });
  writer.WriteStream("stream.vdb", { MakeDouble(), noise });
  writer.Write("types.vdb", { MakeVectors(), MakePoints(), MakeFogSphere() });
  const auto ball =
    openvdb::tools::createLevelSetSphere<FloatGrid>(2.0f, openvdb::Vec3f(0.3f, 0, 0), 0.1f, 3.0f);
  ball->setName("ball");
  writer.Write("levelset.vdb", { ball });
  writer.Write("rotated.vdb", MakeRotated());
  writer.Write("mirrored.vdb", { MakeMirrored() });
  writer.Write("sheared.vdb", { MakeSheared() });
  writer.Write("frustum.vdb", { MakeFrustum() });
  const FloatGrid::Ptr haze = MakeGrid("haze", 0.25f);
  haze->tree().setValue(Coord(0, 0, 0), 1.0f);
  haze->tree().setValue(Coord(3, 0, 0), 2.0f);
  writer.Write("background.vdb", { haze });
  writer.Write("tiles.vdb", { MakeTiles() });
  writer.Write("sparse.vdb", { MakeSparse() });
  writer.Write("names.vdb", MakeNames());
  writer.Write("nan.vdb", { MakeBad() });
  writer.Write("empty.vdb", { MakeGrid("nothing") });
  writer.Write("nogrids.vdb", {});
  writer.Write("vectors.vdb", { MakeVectors() });
  writer.Write("onlypoints.vdb", { MakePoints() });
  writer.Write("plume.vdb", { MakePlume() });
}
}
