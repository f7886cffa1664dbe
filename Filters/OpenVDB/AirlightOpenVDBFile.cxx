// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenVDB/AirlightOpenVDBFile.h"

#include "OpenVDB/AirlightOpenVDBArchive.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetUtil.h>

#include <algorithm>
#include <stdexcept>

namespace airlight
{
namespace
{
void Copy(const openvdb::Vec3d& from, double to[3]) { std::copy_n(from.asPointer(), 3, to); }

template <typename Grid>
class ScalarGrid : public OpenVDBGrid
{
public:
  explicit ScalarGrid(const typename Grid::Ptr& grid)
    : Values(grid)
  {
    if (grid->getGridClass() == openvdb::GRID_LEVEL_SET)
    {
      if (!(grid->background() > 0))
      {
        throw std::runtime_error("a level set's background has to be above 0");
      }
      openvdb::tools::sdfToFogVolume(*grid);
    }
  }

  bool GetBounds(std::int64_t lowest[3], std::int64_t highest[3]) const override
  {
    openvdb::CoordBBox box;
    const bool any = this->Values->constTree().evalActiveVoxelBoundingBox(box);
    std::copy_n(box.min().asPointer(), 3, lowest);
    std::copy_n(box.max().asPointer(), 3, highest);
    return any;
  }

  double GetBackground() const override { return static_cast<double>(this->Values->background()); }

  bool GetLinearTransform(double steps[3][3], double origin[3]) const override
  {
    if (!this->Values->constTransform().isLinear())
    {
      return false;
    }
    const openvdb::Mat4d matrix =
      this->Values->constTransform().baseMap()->getAffineMap()->getMat4();
    for (int row = 0; row < 3; ++row) // vectors are rows
    {
      std::copy_n(matrix[row], 3, steps[row]);
    }
    std::copy_n(matrix[3], 3, origin);
    return true;
  }

  void IndexToWorld(const double index[3], double world[3]) const override
  {
    Copy(this->Values->constTransform().indexToWorld(openvdb::Vec3d(index)), world);
  }

  void WorldToIndex(const double world[3], double index[3]) const override
  {
    Copy(this->Values->constTransform().worldToIndex(openvdb::Vec3d(world)), index);
  }

  void VisitActive(const Visitor& visit) const override
  {
    std::int64_t lowest[3];
    std::int64_t highest[3];
    openvdb::CoordBBox box;
    for (auto value = this->Values->constTree().cbeginValueOn(); value; ++value)
    {
      value.getBoundingBox(box);
      std::copy_n(box.min().asPointer(), 3, lowest);
      std::copy_n(box.max().asPointer(), 3, highest);
      visit(lowest, highest, static_cast<double>(*value));
    }
  }

private:
  typename Grid::Ptr Values;
};

//------------------------------------------------------------------------------
// Calls with the file's archive, and turns what OpenVDB may throw into one kind of error.
template <typename Function>
auto WithArchive(const std::string& fileName, const Function& function)
{
  try
  {
    openvdb::initialize();
    OpenVDBArchive archive(fileName);
    return function(archive);
  }
  catch (const std::ios_base::failure&)
  {
    throw std::runtime_error("ends too early: it is truncated or damaged");
  }
  catch (const std::length_error&)
  {
    throw std::runtime_error("is damaged: something in it has an impossible size");
  }
  catch (const std::bad_alloc&)
  {
    throw std::runtime_error("there is not enough memory for it, or it is damaged");
  }
  catch (const openvdb::Exception& error)
  {
    throw std::runtime_error(std::string("OpenVDB cannot read it: ") + error.what());
  }
}
}

//------------------------------------------------------------------------------
std::vector<OpenVDBGridInfo> ListOpenVDBGrids(const std::string& fileName)
{
  return WithArchive(fileName, [](const OpenVDBArchive& archive) { return archive.List(); });
}

//------------------------------------------------------------------------------
std::unique_ptr<OpenVDBGrid> ReadOpenVDBGrid(const std::string& fileName, std::size_t which)
{
  return WithArchive(fileName, [which](OpenVDBArchive& archive) -> std::unique_ptr<OpenVDBGrid> {
    const openvdb::GridBase::Ptr grid = archive.Read(which);
    if (const auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid))
    {
      return std::make_unique<ScalarGrid<openvdb::FloatGrid>>(floats);
    }
    return std::make_unique<ScalarGrid<openvdb::DoubleGrid>>(
      openvdb::gridPtrCast<openvdb::DoubleGrid>(grid));
  });
}
}
