// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TextPLY.h"

#include "Files.h"
#include "UserError.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <vector>

namespace airlight
{

namespace
{
struct Element
{
  std::string Name;
  long long Count = 0;
  std::vector<bool> Lists; // whether each property is a list
};

// The elements that the header of a text file describes, none for a binary file. Leaves the stream
// behind the header.
std::vector<Element> ReadHeader(std::istream& stream)
{
  std::vector<Element> elements;
  bool text = false;
  for (std::string line; std::getline(stream, line) && line.rfind("end_header", 0) != 0;)
  {
    std::istringstream words(line);
    std::string key;
    std::string value;
    words >> key >> value;
    if (key == "format")
    {
      text = value == "ascii";
    }
    else if (key == "element")
    {
      Element element;
      element.Name = value;
      words >> element.Count;
      elements.push_back(element);
    }
    else if (key == "property" && !elements.empty())
    {
      elements.back().Lists.push_back(value == "list");
    }
  }
  return text ? elements : std::vector<Element>();
}

// The numbers behind the header, one after the other.
class Numbers
{
public:
  Numbers(const std::string& fileName, const std::string& bytes, std::size_t start)
    : FileName(fileName)
    , Begin(bytes.c_str())
    , At(bytes.c_str() + start)
  {
  }

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

private:
  [[noreturn]] void Fail(const Element& element, long long index) const
  {
    const std::string place = element.Name + " " + std::to_string(index);
    std::istringstream rest(this->At);
    std::string word;
    rest >> word;
    if (word.empty())
    {
      throw UserError(this->FileName + ": the file ends before the last number of " + place +
        " of " + std::to_string(element.Count));
    }
    const char* end = this->At + std::strspn(this->At, " \t\r\n");
    throw UserError(this->FileName + ":" + std::to_string(1 + std::count(this->Begin, end, '\n')) +
      ": '" + word + "' of " + place + " is no number, or not finite");
  }

  std::string FileName;
  const char* Begin;
  const char* At;
};
}

//------------------------------------------------------------------------------
void CheckTextPLY(const std::string& fileName)
{
  const std::string bytes = ReadTextFile(fileName);
  std::istringstream stream(bytes);
  const std::vector<Element> elements = ReadHeader(stream);
  if (elements.empty() || !stream)
  {
    return; // binary, or no header, which VTK reports
  }
  Numbers numbers(fileName, bytes, static_cast<std::size_t>(stream.tellg()));
  for (const Element& element : elements)
  {
    for (long long i = 0; i < element.Count; ++i)
    {
      for (const bool list : element.Lists)
      {
        const double number = numbers.Next(element, i);
        for (double j = 0.0; list && j < number; ++j)
        {
          numbers.Next(element, i);
        }
      }
    }
  }
}

}
