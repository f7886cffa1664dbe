// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/Exr.h"

#include "formats/Files.h"
#include "formats/UserError.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

namespace airlight
{

namespace
{
constexpr std::uint32_t Magic = 20000630;
constexpr std::uint32_t Version = 2;   // of single scan line parts
constexpr std::uint32_t FloatType = 2; // of a channel
constexpr char NoCompression = 0;
constexpr char IncreasingY = 0;

// Little endian, whatever the machine.
template <typename Unsigned>
void Append(std::string& bytes, Unsigned value)
{
  for (std::size_t i = 0; i < sizeof(value); ++i)
  {
    bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xff));
  }
}

void AppendFloat(std::string& bytes, float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  Append(bytes, bits);
}

void AppendAttribute(
  std::string& bytes, const std::string& name, const std::string& type, const std::string& value)
{
  bytes += name + '\0' + type + '\0';
  Append(bytes, static_cast<std::uint32_t>(value.size()));
  bytes += value;
}

std::string MakeChannels(const std::string& names)
{
  std::string channels;
  for (const char name : names)
  {
    channels += std::string(1, name) + '\0';
    Append(channels, FloatType);
    Append(channels, std::uint32_t(0)); // for human eyes, and reserved bytes
    Append(channels, std::uint32_t(1)); // every column
    Append(channels, std::uint32_t(1)); // every row
  }
  return channels + '\0';
}

std::string MakeHeader(std::uint32_t width, std::uint32_t height, const std::string& names)
{
  std::string window;
  for (const std::uint32_t end : { 0U, 0U, width - 1, height - 1 })
  {
    Append(window, end);
  }
  std::string one;
  AppendFloat(one, 1.0f);
  std::string bytes;
  Append(bytes, Magic);
  Append(bytes, Version);
  AppendAttribute(bytes, "channels", "chlist", MakeChannels(names));
  AppendAttribute(bytes, "compression", "compression", std::string(1, NoCompression));
  AppendAttribute(bytes, "dataWindow", "box2i", window);
  AppendAttribute(bytes, "displayWindow", "box2i", window);
  AppendAttribute(bytes, "lineOrder", "lineOrder", std::string(1, IncreasingY));
  AppendAttribute(bytes, "pixelAspectRatio", "float", one);
  AppendAttribute(bytes, "screenWindowCenter", "v2f", std::string(8, '\0'));
  AppendAttribute(bytes, "screenWindowWidth", "float", one);
  return bytes + '\0';
}

// Channel after channel.
std::string MakeLine(const float* row, std::uint32_t width, const std::string& names)
{
  const std::size_t channels = names.size();
  std::string line;
  for (std::size_t channel = channels; channel-- > 0;) // B, G, R of an image R, G, B
  {
    for (std::size_t x = 0; x < width; ++x)
    {
      AppendFloat(line, row[x * channels + channel]);
    }
  }
  return line;
}
}

//------------------------------------------------------------------------------
void WriteExr(vtkImageData* image, const std::string& fileName)
{
  int size[3];
  image->GetDimensions(size);
  const auto width = static_cast<std::uint32_t>(size[0]);
  const auto height = static_cast<std::uint32_t>(size[1]);
  // In the order of the alphabet, as the format wants them.
  const std::string names = image->GetNumberOfScalarComponents() == 3 ? "BGR" : "Y";
  std::string bytes = MakeHeader(width, height, names);
  const std::uint64_t lineSize = names.size() * sizeof(float) * width;
  const std::uint64_t first = bytes.size() + 8 * static_cast<std::uint64_t>(height);
  for (std::uint32_t y = 0; y < height; ++y)
  {
    Append(bytes, first + y * (8 + lineSize));
  }
  const auto* values = static_cast<const float*>(image->GetScalarPointer());
  for (std::uint32_t y = 0; y < height; ++y)
  {
    Append(bytes, y);
    Append(bytes, static_cast<std::uint32_t>(lineSize));
    const std::size_t row = height - 1 - y; // VTK's are from the bottom
    bytes += MakeLine(values + row * width * names.size(), width, names);
  }
  CheckOutputFile(fileName);
  std::ofstream file(fileName, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file)
  {
    throw UserError(fileName + ": cannot be written");
  }
}

}
