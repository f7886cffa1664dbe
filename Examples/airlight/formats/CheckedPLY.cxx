// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/CheckedPLY.h"

#include "formats/Files.h"
#include "formats/UserError.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <vector>

namespace airlight
{

namespace
{
struct Property
{
  std::size_t CountBytes = 0; // of a list's length; 0: no list
  std::size_t Bytes = 0;      // of each number
};

struct Element
{
  std::string Name;
  long long Count = 0;
  std::vector<Property> Properties;
};

struct Header
{
  std::string Format;
  std::vector<Element> Elements;
  bool Known = true; // whether all of it is understood
};

// In binary files; 0 where there is no such type, or one that is no `integer`.
std::size_t GetBytes(const std::string& type, bool integer)
{
  static const std::map<std::string, std::size_t> integers = { { "char", 1 }, { "uchar", 1 },
    { "int8", 1 }, { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 },
    { "int", 4 }, { "uint", 4 }, { "int32", 4 }, { "uint32", 4 } };
  static const std::map<std::string, std::size_t> others = { { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  const auto found = integers.find(type);
  if (found != integers.end())
  {
    return found->second;
  }
  const auto other = others.find(type);
  return !integer && other != others.end() ? other->second : 0;
}

// Of the rest of a line that says "property"; false where it is not understood.
bool ReadProperty(std::istream& words, Property& property)
{
  std::string type;
  words >> type;
  const bool list = type == "list";
  if (list)
  {
    words >> type;
    property.CountBytes = GetBytes(type, true);
    words >> type;
  }
  property.Bytes = GetBytes(type, false);
  return property.Bytes > 0 && (!list || property.CountBytes > 0);
}

Header ReadHeader(const std::string& text)
{
  Header header;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "format")
    {
      words >> header.Format;
    }
    else if (key == "element")
    {
      header.Elements.emplace_back();
      words >> header.Elements.back().Name >> header.Elements.back().Count;
    }
    else if (key == "property" && !header.Elements.empty())
    {
      Property property;
      header.Known = ReadProperty(words, property) && header.Known;
      header.Elements.back().Properties.push_back(property);
    }
  }
  return header;
}

[[noreturn]] void FailAtEnd(const std::string& fileName, const Element& element, long long index)
{
  throw UserError(fileName + ": the file ends before the last number of " + element.Name + " " +
    std::to_string(index) + " of " + std::to_string(element.Count));
}

// The numbers behind the header of a file in text, one after the other.
class TextNumbers
{
public:
  TextNumbers(const std::string& fileName, const std::string& bytes, std::size_t start)
    : FileName(fileName)
    , Begin(bytes.c_str())
    , At(bytes.c_str() + start)
  {
  }

  double TakeCount(const Property&, const Element& element, long long index)
  {
    return this->Next(element, index);
  }

  void Pass(double count, const Property&, const Element& element, long long index)
  {
    for (long long i = 0; static_cast<double>(i) < count; ++i)
    {
      this->Next(element, index);
    }
  }

private:
  double Next(const Element& element, long long index)
  {
    char* end = nullptr;
    const double number = std::strtod(this->At, &end);
    if (end == this->At || !std::isfinite(number))
    {
      this->Fail(element, index);
    }
    this->At = end;
    return number;
  }

  [[noreturn]] void Fail(const Element& element, long long index) const
  {
    const std::string place = element.Name + " " + std::to_string(index);
    std::istringstream rest(this->At);
    std::string word;
    rest >> word;
    if (word.empty())
    {
      FailAtEnd(this->FileName, element, index);
    }
    const char* end = this->At + std::strspn(this->At, " \t\r\n");
    throw UserError(this->FileName + ":" + std::to_string(1 + std::count(this->Begin, end, '\n')) +
      ": '" + word + "' of " + place + " is no number, or not finite");
  }

  std::string FileName;
  const char* Begin;
  const char* At;
};

// The same of a binary file, in which any bytes are numbers: of those that are no lengths it is
// enough that they are there.
class BinaryNumbers
{
public:
  BinaryNumbers(
    const std::string& fileName, const std::string& bytes, std::size_t start, bool bigEndian)
    : FileName(fileName)
    , Bytes(bytes)
    , At(start)
    , BigEndian(bigEndian)
  {
  }

  double TakeCount(const Property& property, const Element& element, long long index)
  {
    const std::size_t size = property.CountBytes;
    const std::size_t first = this->At;
    this->Pass(static_cast<double>(size), element, index);
    double number = 0.0;
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::size_t place = first + (this->BigEndian ? i : size - 1 - i);
      number = 256.0 * number + static_cast<unsigned char>(this->Bytes[place]);
    }
    return number;
  }

  void Pass(double count, const Property& property, const Element& element, long long index)
  {
    this->Pass(count * static_cast<double>(property.Bytes), element, index);
  }

private:
  void Pass(double bytes, const Element& element, long long index)
  {
    if (static_cast<double>(this->Bytes.size() - this->At) < bytes)
    {
      FailAtEnd(this->FileName, element, index);
    }
    this->At += static_cast<std::size_t>(bytes);
  }

  std::string FileName;
  const std::string& Bytes;
  std::size_t At;
  bool BigEndian;
};

template <typename Numbers>
void ReadAll(const Header& header, Numbers numbers)
{
  for (const Element& element : header.Elements)
  {
    // Without a property there is nothing to miss, however large the count.
    for (long long i = 0; i < element.Count && !element.Properties.empty(); ++i)
    {
      for (const Property& property : element.Properties)
      {
        const bool list = property.CountBytes > 0;
        const double count = list ? numbers.TakeCount(property, element, i) : 1.0;
        numbers.Pass(count, property, element, i);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
void CheckPLY(const std::string& fileName)
{
  const std::string bytes = ReadTextFile(fileName);
  const std::size_t last = bytes.find("\nend_header");
  if (last == std::string::npos)
  {
    return;
  }
  const Header header = ReadHeader(bytes.substr(0, last));
  if (!header.Known)
  {
    return;
  }
  const std::size_t start = std::min(bytes.find('\n', last + 1), bytes.size() - 1) + 1;
  if (header.Format == "ascii")
  {
    ReadAll(header, TextNumbers(fileName, bytes, start));
  }
  else if (header.Format == "binary_little_endian" || header.Format == "binary_big_endian")
  {
    ReadAll(header, BinaryNumbers(fileName, bytes, start, header.Format == "binary_big_endian"));
  }
}

}
