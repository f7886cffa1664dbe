// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/Pfm.h"

#include "formats/Files.h"
#include "formats/UserError.h"

#include <vtkByteSwap.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <locale>
#include <sstream>
#include <vector>

namespace airlight
{

namespace
{
constexpr int MaximumSize = 1 << 20; // pixels in a row or column

struct Header
{
  int Channels = 0;
  int Width = 0;
  int Height = 0;
  bool LittleEndian = true;
  std::size_t Size = 0; // bytes before the first pixel

  std::uint64_t GetNumberOfValues() const
  {
    return static_cast<std::uint64_t>(this->Width) * static_cast<std::uint64_t>(this->Height) *
      static_cast<std::uint64_t>(this->Channels);
  }
};

Header ReadHeader(const std::string& bytes, const std::string& fileName)
{
  // Three lines of text. Longer ones belong to some other kind of file.
  std::istringstream stream(bytes.substr(0, 256));
  stream.imbue(std::locale::classic());
  std::string magic;
  double scale = 0.0;
  Header header;
  stream >> magic;
  if (magic != "PF" && magic != "Pf")
  {
    throw UserError(fileName + ": is not a PFM file: it does not begin with PF or Pf");
  }
  stream >> header.Width >> header.Height >> scale;
  if (!stream || header.Width < 1 || header.Height < 1 || header.Width > MaximumSize ||
    header.Height > MaximumSize || scale == 0.0 || !std::isfinite(scale))
  {
    throw UserError(fileName + ": malformed PFM header: expected width, height and scale");
  }
  header.Channels = magic == "PF" ? 3 : 1;
  header.LittleEndian = scale < 0.0;
  header.Size = static_cast<std::size_t>(stream.tellg()) + 1; // one blank ends it
  return header;
}

void SwapIfNeeded(float* values, std::uint64_t count, bool littleEndian)
{
  if (littleEndian)
  {
    vtkByteSwap::Swap4LERange(values, static_cast<std::size_t>(count));
  }
  else
  {
    vtkByteSwap::Swap4BERange(values, static_cast<std::size_t>(count));
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadPfm(const std::string& fileName)
{
  const std::string bytes = ReadTextFile(fileName);
  const Header header = ReadHeader(bytes, fileName);
  const std::uint64_t count = header.GetNumberOfValues();
  const std::uint64_t expected = header.Size + count * sizeof(float);
  if (bytes.size() != expected)
  {
    throw UserError(fileName + ": should hold " + std::to_string(expected) + " bytes and holds " +
      std::to_string(bytes.size()));
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(header.Width, header.Height, 1);
  image->AllocateScalars(VTK_FLOAT, header.Channels);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  std::memcpy(values, bytes.data() + header.Size, static_cast<std::size_t>(count) * sizeof(float));
  SwapIfNeeded(values, count, header.LittleEndian);
  return image;
}

//------------------------------------------------------------------------------
void WritePfm(vtkImageData* image, const std::string& fileName)
{
  int size[3];
  image->GetDimensions(size);
  Header header;
  header.Channels = image->GetNumberOfScalarComponents();
  header.Width = size[0];
  header.Height = size[1];
  const std::uint64_t count = header.GetNumberOfValues();
  const auto* first = static_cast<const float*>(image->GetScalarPointer());
  std::vector<float> values(first, first + count);
  SwapIfNeeded(values.data(), count, true);

  CheckOutputFile(fileName);
  std::ofstream file(fileName, std::ios::binary);
  file << (header.Channels == 3 ? "PF" : "Pf") << '\n'
       << std::to_string(size[0]) << ' ' << std::to_string(size[1]) << "\n-1.0\n";
  file.write(reinterpret_cast<const char*>(values.data()),
    static_cast<std::streamsize>(count * sizeof(float)));
  file.close();
  if (!file)
  {
    throw UserError(fileName + ": cannot be written");
  }
}

}
