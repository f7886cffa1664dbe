// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Looks through what OpenVDB is about to read. OpenVDB trusts its files: where one is damaged it may
 * write beyond a node's values, delete children that it has not read yet, leak a tree, or ask for
 * any amount of memory. So sizes are compared with what they have to be, what stands in the tree's
 * upper levels is unpacked once to see whether it can be, and all of it has to be there. What passes
 * costs no more memory than in proportion to the file.
 *
 * For AirlightOpenVDBFile.cxx alone. Everything throws std::runtime_error, or what the stream throws
 * at its end.
 */

#ifndef AirlightOpenVDBCheck_h
#define AirlightOpenVDBCheck_h

#include <openvdb/io/Compression.h>
#include <openvdb/io/io.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <istream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace airlight
{
// Steps over parts of a stream of OpenVDB's.
class OpenVDBScanner
{
public:
  OpenVDBScanner(std::istream& stream, const std::int64_t& size)
    : Stream(stream)
    , Size(size)
  {
  }

  [[noreturn]] static void Fail(const std::string& what)
  {
    throw std::runtime_error("is damaged: " + what);
  }

  template <typename T>
  T Get()
  {
    T value{};
    this->Stream.read(reinterpret_cast<char*>(&value), sizeof(T));
    return value;
  }

  // Fails where so many bytes are not left.
  void Require(std::uint64_t bytes)
  {
    const std::int64_t left = this->Size - static_cast<std::int64_t>(this->Stream.tellg());
    if (bytes > static_cast<std::uint64_t>(std::max<std::int64_t>(left, 0)))
    {
      throw std::ios_base::failure("end");
    }
  }

  // Reads rather than seeks, to find the end, and because a seek empties the stream's buffer.
  void Skip(std::uint64_t bytes)
  {
    while (bytes > 0)
    {
      const std::uint64_t part = std::min<std::uint64_t>(bytes, sizeof(this->Scratch));
      this->Stream.read(this->Scratch, static_cast<std::streamsize>(part));
      bytes -= part;
    }
  }

  std::string GetString()
  {
    std::string text(this->CheckedSize(), ' ');
    this->Stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    return text;
  }

  // Strings that OpenVDB reads next, from where the stream is and comes back to.
  void CheckStrings(int count)
  {
    const auto here = this->Stream.tellg();
    for (; count > 0; --count)
    {
      this->Skip(this->CheckedSize());
    }
    this->Stream.seekg(here);
  }

  void ReadMetadata(openvdb::MetaMap& map);
  void CheckTransform();

  // A block of values, packed or not, that has so many bytes when unpacked.
  void SkipBlock(std::uint64_t bytes);

private:
  std::uint32_t CheckedSize()
  {
    const auto size = this->Get<std::uint32_t>();
    this->Require(size);
    return size;
  }

  std::istream& Stream;
  const std::int64_t& Size; // known once the file is open
  char Scratch[4096] = {};
};

//------------------------------------------------------------------------------
// As openvdb::MetaMap::readMeta(), but for hints for reading parts of the file, which are skipped.
inline void OpenVDBScanner::ReadMetadata(openvdb::MetaMap& map)
{
  map.clearMetadata();
  for (auto count = this->Get<std::uint32_t>(); count > 0; --count)
  {
    const std::string name = this->GetString();
    const std::string type = this->GetString();
    const auto start = this->Stream.tellg();
    const std::uint32_t bytes = this->CheckedSize();
    const bool known = openvdb::Metadata::isRegisteredType(type) && type.compare(0, 2, "__") != 0;
    if (!known)
    {
      this->Skip(bytes);
      continue;
    }
    this->Stream.seekg(start);
    const openvdb::Metadata::Ptr item = openvdb::Metadata::createMetadata(type);
    item->read(this->Stream);
    if (this->Stream.tellg() != start + std::streamoff(sizeof(bytes) + bytes))
    {
      Fail("'" + name + "' of type " + type + " has " + std::to_string(bytes) + " bytes");
    }
    map.insertMeta(name, *item);
  }
}

//------------------------------------------------------------------------------
inline void OpenVDBScanner::CheckTransform()
{
  const auto here = this->Stream.tellg();
  if (this->GetString() == openvdb::math::NonlinearFrustumMap::mapType())
  {
    this->Skip(8 * sizeof(double)); // its box, taper and depth
    if (this->GetString() == openvdb::math::NonlinearFrustumMap::mapType())
    {
      Fail("its transform is a frustum in a frustum");
    }
  }
  this->Stream.seekg(here);
}

//------------------------------------------------------------------------------
inline void OpenVDBScanner::SkipBlock(std::uint64_t bytes)
{
  const std::uint32_t compression = openvdb::io::getDataCompression(this->Stream);
  const bool blosc = (compression & openvdb::io::COMPRESS_BLOSC) != 0;
  if (!blosc && (compression & openvdb::io::COMPRESS_ZIP) == 0)
  {
    this->Skip(bytes);
    return;
  }
  // Negative sizes are of values that are not packed, because packing makes them no smaller.
  const auto size = this->Get<std::int64_t>();
  const auto most = static_cast<std::int64_t>(2 * bytes + 1024);
  if (size <= 0 ? size < -most || static_cast<std::uint64_t>(-size) != bytes : size > most)
  {
    Fail("a block of " + std::to_string(bytes) + " bytes of values has the size " +
      std::to_string(size));
  }
  std::uint64_t packed = static_cast<std::uint64_t>(size <= 0 ? -size : size);
  if (size > 0 && blosc)
  {
    // Blosc's own head: four bytes and the sizes unpacked, of its parts, and packed.
    std::uint32_t head[4] = {};
    packed -= std::min<std::uint64_t>(packed, sizeof(head));
    this->Stream.read(reinterpret_cast<char*>(head), sizeof(head));
    if (head[1] != bytes || static_cast<std::int64_t>(head[3]) != size)
    {
      Fail("a block of " + std::to_string(bytes) + " bytes of values, packed to " +
        std::to_string(size) + ", says of itself that it has " + std::to_string(head[1]) +
        ", packed to " + std::to_string(head[3]));
    }
  }
  this->Skip(packed);
}

//------------------------------------------------------------------------------
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
      this->AddPlace();
      this->Scanner.template Get<Value>();
      if (this->Scanner.template Get<std::uint8_t>() > 1)
      {
        OpenVDBScanner::Fail("a tile is neither active nor inactive");
      }
    }
    for (std::uint32_t i = 0; i < children; ++i)
    {
      this->CheckNode<typename Root::ChildNodeType>(this->AddPlace());
    }
    this->CheckLeaves();
    openvdb::io::setGridBackgroundValuePtr(this->Stream, nullptr);
  }

private:
  // For each leaf, in the order of the file, how many of its voxels are active.
  using Leaves = std::vector<std::uint16_t>;

  // Where one of the root's tiles or children is, each elsewhere.
  Leaves& AddPlace()
  {
    openvdb::Coord place;
    this->Stream.read(reinterpret_cast<char*>(place.asPointer()), 3 * sizeof(openvdb::Int32));
    constexpr auto Last = static_cast<openvdb::Int32>(Root::ChildNodeType::DIM - 1);
    const auto added = this->Places.emplace(place, Leaves());
    if (((place[0] | place[1] | place[2]) & Last) != 0 || !added.second)
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

  // Buffers come in the order of places.
  void CheckLeaves()
  {
    using Leaf = typename Root::LeafNodeType;
    constexpr std::uint64_t MaskBytes = Leaf::NUM_VALUES / 8;
    for (const auto& place : this->Places)
    {
      for (const std::uint16_t active : place.second)
      {
        this->Scanner.Skip(MaskBytes);
        this->SkipValues(Leaf::NUM_VALUES, active, MaskBytes);
      }
    }
  }

  std::istream& Stream;
  OpenVDBScanner Scanner;
  bool Half;
  std::map<openvdb::Coord, Leaves> Places;
  std::vector<Value> Values;
};
}

#endif
