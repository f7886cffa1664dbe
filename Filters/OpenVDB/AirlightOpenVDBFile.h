// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenVDB's files and grids, as far as a density needs them. The source file is the only one that
 * includes OpenVDB.
 */

#ifndef AirlightOpenVDBFile_h
#define AirlightOpenVDBFile_h

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace airlight
{
struct OpenVDBGridInfo
{
  std::string Name; // made unique by "[1]" and so on where a file has it twice
  std::string Type; // OpenVDB's name of the value type: float, double, vec3s, ...
  bool Scalar;      // whether ReadOpenVDBGrid() takes it
};

// A scalar grid in memory. Values belong to voxel centres, which have integral indices.
class OpenVDBGrid
{
public:
  virtual ~OpenVDBGrid() = default;

  // The lowest and the highest index of active voxels. False where there are none.
  virtual bool GetBounds(std::int64_t lowest[3], std::int64_t highest[3]) const = 0;

  // The value of all that is not active.
  virtual double GetBackground() const = 0;

  // A linear transform from index to world: the steps along the three index axes, and where index
  // (0, 0, 0) is. False where it is not linear.
  virtual bool GetLinearTransform(double steps[3][3], double origin[3]) const = 0;
  virtual void IndexToWorld(const double index[3], double world[3]) const = 0;
  virtual void WorldToIndex(const double world[3], double index[3]) const = 0;

  // Calls for every active voxel, and for every active box of voxels that share one value.
  using Visitor =
    std::function<void(const std::int64_t lowest[3], const std::int64_t highest[3], double value)>;
  virtual void VisitActive(const Visitor& visit) const = 0;
};

// The grids in the order of the file. Throws std::runtime_error with the reason, without the file's
// name, where it is missing, truncated or no OpenVDB file.
std::vector<OpenVDBGridInfo> ListOpenVDBGrids(const std::string& fileName);

// One of them, which has to be scalar; a level set comes as fog. Throws as above.
std::unique_ptr<OpenVDBGrid> ReadOpenVDBGrid(const std::string& fileName, std::size_t which);
}

#endif
