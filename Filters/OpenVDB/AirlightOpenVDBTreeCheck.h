// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Looks through a tree of voxels that OpenVDB is about to read; see AirlightOpenVDBScanner.h. For
 * AirlightOpenVDBFile.cxx alone.
 */

#ifndef AirlightOpenVDBTreeCheck_h
#define AirlightOpenVDBTreeCheck_h

#include "OpenVDB/AirlightOpenVDBScanner.h"

#include <openvdb/io/Compression.h>
#include <openvdb/openvdb.h>

#include <cstdint>
#include <istream>
#include <map>
#include <string>
#include <vector>

namespace airlight
{
// Walks through a tree as openvdb::tree::Tree's readTopology() and readBuffers() do.
template <typename Root>
class OpenVDBTreeCheck
{
public:
  using Value = typename Root::ValueType;

  OpenVDBTreeCheck(std::istream& stream, const std::int64_t& size, bool half)
    : Stream(stream)
    , Scanner(stream, size)
    , Half(half && openvdb::io::RealToHalf<Value>::isReal)
  {
  }

  // Leaves the stream behind the tree.
  void Check()
  {
    const auto buffers = this->Scanner.template Get<std::int32_t>();
    if (buffers != 1)
    {
      OpenVDBScanner::Fail("its tree has " + std::to_string(buffers) + " buffers");
    }
    const auto background = this->Scanner.template Get<Value>();
    openvdb::io::setGridBackgroundValuePtr(this->Stream, &background);
    const auto tiles = this->Scanner.template Get<std::uint32_t>();
    const auto children = this->Scanner.template Get<std::uint32_t>();
    for (std::uint32_t i = 0; i < tiles; ++i)
    {
      this->AddNode();
      this->Scanner.template Get<Value>();
      if (this->Scanner.template Get<std::uint8_t>() > 1)
      {
        OpenVDBScanner::Fail("a tile is neither active nor inactive");
      }
    }
    for (std::uint32_t i = 0; i < children; ++i)
    {
      this->CheckNode<typename Root::ChildNodeType>(this->AddNode());
    }
    this->CheckLeaves();
    openvdb::io::setGridBackgroundValuePtr(this->Stream, nullptr);
  }

private:
  // For each leaf, in the order of the file, how many of its voxels are active.
  using Leaves = std::vector<std::uint16_t>;

  // Where one of the root's tiles or children is, each elsewhere.
  Leaves& AddNode()
  {
    openvdb::Coord origin;
    this->Stream.read(reinterpret_cast<char*>(origin.asPointer()), 3 * sizeof(openvdb::Int32));
    constexpr auto Last = static_cast<openvdb::Int32>(Root::ChildNodeType::DIM - 1);
    const auto added = this->Nodes.emplace(origin, Leaves());
    if (((origin[0] | origin[1] | origin[2]) & Last) != 0 || !added.second)
    {
      OpenVDBScanner::Fail("a node of its tree is where none can be");
    }
    return added.first->second;
  }

  template <typename Node>
  void CheckNode(Leaves& leaves)
  {
    typename Node::NodeMaskType children;
    children.load(this->Stream);
    if constexpr (Node::LEVEL == 0)
    {
      leaves.push_back(static_cast<std::uint16_t>(children.countOn()));
    }
    else
    {
      typename Node::NodeMaskType active;
      active.load(this->Stream);
      const auto here = this->Stream.tellg();
      this->SkipValues(Node::NUM_VALUES, active.countOn(), active.memUsage());
      this->Stream.seekg(here);
      this->Values.resize(Node::NUM_VALUES);
      openvdb::io::readCompressedValues(
        this->Stream, this->Values.data(), Node::NUM_VALUES, active, this->Half);
      for (openvdb::Index32 child = children.countOn(); child > 0; --child)
      {
        this->CheckNode<typename Node::ChildNodeType>(leaves);
      }
    }
  }

  // As openvdb::io::readCompressedValues().
  void SkipValues(std::uint64_t all, std::uint64_t active, std::uint64_t maskBytes)
  {
    using namespace openvdb::io;
    const auto kind = this->Scanner.template Get<std::int8_t>();
    switch (kind)
    {
      case NO_MASK_OR_INACTIVE_VALS:
      case NO_MASK_AND_MINUS_BG:
      case NO_MASK_AND_ALL_VALS:
        break;
      case NO_MASK_AND_ONE_INACTIVE_VAL:
        this->Scanner.Skip(sizeof(Value));
        break;
      case MASK_AND_NO_INACTIVE_VALS:
        this->Scanner.Skip(maskBytes);
        break;
      case MASK_AND_ONE_INACTIVE_VAL:
        this->Scanner.Skip(sizeof(Value) + maskBytes);
        break;
      case MASK_AND_TWO_INACTIVE_VALS:
        this->Scanner.Skip(2 * sizeof(Value) + maskBytes);
        break;
      default:
        OpenVDBScanner::Fail("a node's values are of kind " + std::to_string(kind));
    }
    const bool masked = (getDataCompression(this->Stream) & COMPRESS_ACTIVE_MASK) != 0;
    const std::uint64_t count = masked && kind != NO_MASK_AND_ALL_VALS ? active : all;
    const std::uint64_t bytes =
      this->Half ? sizeof(typename openvdb::io::RealToHalf<Value>::HalfT) : sizeof(Value);
    if (count > 0 || !this->Half)
    {
      this->Scanner.SkipBlock(count * bytes);
    }
  }

  // Buffers come in the order of the nodes.
  void CheckLeaves()
  {
    using Leaf = typename Root::LeafNodeType;
    constexpr std::uint64_t MaskBytes = Leaf::NUM_VALUES / 8;
    for (const auto& node : this->Nodes)
    {
      for (const std::uint16_t active : node.second)
      {
        this->Scanner.Skip(MaskBytes);
        this->SkipValues(Leaf::NUM_VALUES, active, MaskBytes);
      }
    }
  }

  std::istream& Stream;
  OpenVDBScanner Scanner;
  bool Half;
  std::map<openvdb::Coord, Leaves> Nodes;
  std::vector<Value> Values;
};
}

#endif
