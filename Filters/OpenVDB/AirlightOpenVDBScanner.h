// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Looks through what OpenVDB is about to read. OpenVDB trusts its files: where one is damaged it
 * may write beyond a node's values, delete children that it has not read yet, leak a tree, or ask
 * for any amount of memory. So sizes are compared with what they have to be, what stands in the
 * tree's upper levels is unpacked once to see whether it can be, and all of it has to be there.
 * What passes costs no more memory than in proportion to the file.
 *
 * Sizes, transforms and metadata here, trees in AirlightOpenVDBTreeCheck.h. For
 * AirlightOpenVDBFile.cxx alone. Everything throws std::runtime_error, or what the stream throws
 * at its end.
 */

#ifndef AirlightOpenVDBScanner_h
#define AirlightOpenVDBScanner_h

#include <openvdb/io/Compression.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <cstdint>
#include <istream>
#include <stdexcept>
#include <string>

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
}

#endif
