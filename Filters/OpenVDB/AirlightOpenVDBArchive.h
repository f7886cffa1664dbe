// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An OpenVDB file that is looked through before it is read. For AirlightOpenVDBFile.cxx alone, so
 * that OpenVDB's headers are compiled once.
 */

#ifndef AirlightOpenVDBArchive_h
#define AirlightOpenVDBArchive_h

#include "OpenVDB/AirlightOpenVDBFile.h"
#include "OpenVDB/AirlightOpenVDBTreeCheck.h"

#include <openvdb/io/Archive.h>
#include <openvdb/io/GridDescriptor.h>
#include <openvdb/io/io.h>
#include <openvdb/openvdb.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace airlight
{
// Calls visit(<a grid's tree>::RootNodeType*) for those grids of the default shape whose trees can
// be looked through. False for other grids: masks, bits, strings, points.
template <typename Visit>
bool VisitTree(const openvdb::GridBase& grid, const Visit& visit)
{
  bool found = false;
  const auto test = [&](auto* null) {
    using Grid = std::remove_pointer_t<decltype(null)>;
    if (!found && grid.isType<Grid>())
    {
      found = true;
      visit(static_cast<typename Grid::TreeType::RootNodeType*>(nullptr));
    }
  };
  test(static_cast<openvdb::FloatGrid*>(nullptr));
  test(static_cast<openvdb::DoubleGrid*>(nullptr));
  test(static_cast<openvdb::Int32Grid*>(nullptr));
  test(static_cast<openvdb::Int64Grid*>(nullptr));
  test(static_cast<openvdb::Vec3SGrid*>(nullptr));
  test(static_cast<openvdb::Vec3DGrid*>(nullptr));
  test(static_cast<openvdb::Vec3IGrid*>(nullptr));
  return found;
}

// openvdb::io::File does not notice that a file ends early and hands out what was in memory. This
// one reads through a stream that throws at its end, and looks before it lets OpenVDB read.
class OpenVDBArchive : public openvdb::io::Archive
{
public:
  explicit OpenVDBArchive(const std::string& fileName)
  {
    this->Open(fileName);
    this->readHeader(this->Stream);
    this->State->setSeekable(true);
    openvdb::io::setStreamMetadataPtr(this->Stream, this->State, false);
    this->setFormatVersion(this->Stream);
    this->setLibraryVersion(this->Stream);
    this->setDataCompression(this->Stream);
    const std::uint32_t version = openvdb::io::getFormatVersion(this->Stream);
    if (version < openvdb::OPENVDB_FILE_VERSION_NODE_MASK_COMPRESSION)
    {
      throw std::runtime_error("is of OpenVDB's format " + std::to_string(version) +
        ", from before 2013: write it again with a later OpenVDB");
    }
    openvdb::MetaMap ignored;
    this->Scanner.ReadMetadata(ignored);
    this->ReadDescriptors();
  }

  std::vector<OpenVDBGridInfo> List() const
  {
    std::vector<OpenVDBGridInfo> list;
    for (std::size_t i = 0; i < this->Grids.size(); ++i)
    {
      const std::string name =
        openvdb::io::GridDescriptor::nameAsString(this->Descriptors[i].uniqueName());
      const openvdb::GridBase& grid = *this->Grids[i];
      list.push_back({ name, grid.valueType(),
        grid.isType<openvdb::FloatGrid>() || grid.isType<openvdb::DoubleGrid>() });
    }
    return list;
  }

  openvdb::GridBase::Ptr Read(std::size_t which)
  {
    const openvdb::GridBase::Ptr& grid = this->Grids.at(which);
    this->Load(which);
    if (this->Descriptors[which].isInstance()) // the tree is another grid's
    {
      const std::size_t parent = this->FindParent(this->Descriptors[which]);
      if (this->Grids[parent]->type() != grid->type())
      {
        throw std::runtime_error("two grids share voxels, but their types differ");
      }
      this->Load(parent);
      grid->setTree(this->Grids[parent]->baseTreePtr());
    }
    return grid;
  }

private:
  void Open(const std::string& fileName)
  {
    std::error_code problem;
    const std::filesystem::path path(fileName);
    if (!std::filesystem::is_regular_file(path, problem))
    {
      throw std::runtime_error(
        std::filesystem::exists(path, problem) ? "is not a file" : "does not exist");
    }
    this->Size = static_cast<std::int64_t>(std::filesystem::file_size(path));
    this->Stream.open(path, std::ios::binary);
    if (!this->Stream)
    {
      throw std::runtime_error("cannot be opened");
    }
    if (this->Size == 0)
    {
      throw std::runtime_error("is empty");
    }
    std::int64_t magic = 0; // in the byte order of the machine, as OpenVDB has it
    this->Stream.read(reinterpret_cast<char*>(&magic), sizeof(magic));
    if (magic != openvdb::OPENVDB_MAGIC)
    {
      throw std::runtime_error("is not an OpenVDB file");
    }
    this->Stream.seekg(0);
    this->Stream.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
  }

  // Files written to a stream have no offsets: there each grid has to be read to find the next.
  void ReadDescriptors()
  {
    const std::int32_t count = openvdb::io::Archive::readGridCount(this->Stream);
    for (std::size_t i = 0; static_cast<std::int64_t>(i) < count; ++i)
    {
      openvdb::io::GridDescriptor descriptor;
      this->Scanner.CheckStrings(3);
      this->Grids.push_back(descriptor.read(this->Stream));
      this->Descriptors.push_back(descriptor);
      if (!this->inputHasGridOffsets())
      {
        this->Positions.push_back(static_cast<std::int64_t>(this->Stream.tellg()));
        this->ReadHead(i);
        this->CheckTree(i);
        continue;
      }
      this->Positions.push_back(descriptor.getGridPos());
      if (descriptor.getGridPos() < 0 || descriptor.getGridPos() > descriptor.getEndPos() ||
        descriptor.getEndPos() > this->Size)
      {
        throw std::ios_base::failure("offset");
      }
      descriptor.seekToEnd(this->Stream);
    }
  }

  // What stands before the grid's tree.
  void ReadHead(std::size_t which)
  {
    openvdb::GridBase& grid = *this->Grids[which];
    this->Stream.seekg(this->Positions[which]);
    openvdb::io::Archive::readGridCompression(this->Stream);
    this->Scanner.ReadMetadata(grid);
    this->Scanner.CheckTransform();
    grid.readTransform(this->Stream);
    openvdb::io::setGridClass(this->Stream, grid.getGridClass());
    openvdb::io::setGridBackgroundValuePtr(this->Stream, nullptr);
  }

  // Leaves the stream behind the tree.
  void CheckTree(std::size_t which)
  {
    const openvdb::GridBase& grid = *this->Grids[which];
    if (this->Descriptors[which].isInstance()) // the tree is another grid's
    {
      return;
    }
    const auto check = [&](auto* root) {
      using Root = std::remove_pointer_t<decltype(root)>;
      OpenVDBTreeCheck<Root>(this->Stream, this->Size, grid.saveFloatAsHalf()).Check();
    };
    if (!VisitTree(grid, check))
    {
      throw std::runtime_error("has no offsets and a grid of " + grid.type() +
        ", which cannot be stepped over: write it to a file rather than a stream, or leave out "
        "that grid");
    }
  }

  void Load(std::size_t which)
  {
    if (!this->Loaded[which])
    {
      this->ReadHead(which);
      if (!this->Descriptors[which].isInstance())
      {
        openvdb::GridBase& grid = *this->Grids[which];
        const auto tree = this->Stream.tellg();
        this->CheckTree(which);
        this->Stream.seekg(tree);
        this->State->setHalfFloat(grid.saveFloatAsHalf());
        grid.readTopology(this->Stream);
        grid.readBuffers(this->Stream);
        openvdb::io::setGridBackgroundValuePtr(this->Stream, nullptr);
      }
      this->Loaded[which] = true;
    }
  }

  std::size_t FindParent(const openvdb::io::GridDescriptor& child) const
  {
    const auto found = std::find_if(this->Descriptors.begin(), this->Descriptors.end(),
      [&child](const openvdb::io::GridDescriptor& other) {
        return other.uniqueName() == child.instanceParentName() && !other.isInstance();
      });
    if (found == this->Descriptors.end())
    {
      throw std::runtime_error("a grid's voxels are those of another, which is missing");
    }
    return static_cast<std::size_t>(found - this->Descriptors.begin());
  }

  openvdb::io::StreamMetadata::Ptr State{ new openvdb::io::StreamMetadata }; // the stream's
  std::ifstream Stream;
  std::int64_t Size = 0;
  OpenVDBScanner Scanner{ this->Stream, this->Size };
  std::vector<openvdb::io::GridDescriptor> Descriptors;
  std::vector<openvdb::GridBase::Ptr> Grids; // of one type each, without voxels until loaded
  std::vector<std::int64_t> Positions;       // of what follows the descriptors
  std::map<std::size_t, bool> Loaded;
};
}

#endif
