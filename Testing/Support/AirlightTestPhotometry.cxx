// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestPhotometry.h"

#include "vtkTestUtilities.h"

#include <fstream>

namespace airlight_test
{
//------------------------------------------------------------------------------
std::string GetPhotometricFile(int argc, char* argv[], const std::string& name)
{
  const std::unique_ptr<char[]> path(
    vtkTestUtilities::ExpandDataFileName(argc, argv, ("Photometry/" + name).c_str()));
  return path.get();
}

//------------------------------------------------------------------------------
std::string GetTemporaryFile(int argc, char* argv[], const std::string& name)
{
  const std::unique_ptr<char[]> folder(
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary"));
  return std::string(folder.get()) + "/" + name;
}

//------------------------------------------------------------------------------
std::string Join(const std::vector<double>& numbers, const std::string& separator)
{
  std::string text;
  for (const double number : numbers)
  {
    text += Text(number) + separator;
  }
  return text;
}

//------------------------------------------------------------------------------
std::string TableNumbers(
  const LampTable& table, const std::string& separator, const char* lampFactor)
{
  const std::vector<double> head = { 1, 1000, 2, static_cast<double>(table.Vertical.size()),
    static_cast<double>(table.Horizontal.size()), static_cast<double>(table.Type), 2, 0.1, 0.2, 0,
    0.75 };
  return Join(head, separator) + lampFactor + separator + "40" + separator +
    Join(table.Vertical, separator) + Join(table.Horizontal, separator) +
    Join(table.Candela, separator);
}

//------------------------------------------------------------------------------
std::string TableText(const LampTable& table)
{
  return "IESNA:LM-63-2002\n[TEST] made up\nTILT=NONE\n" + TableNumbers(table, "\n");
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::Photometry> ReadOrTell(const std::string& file)
{
  std::string error;
  const auto photometry = airlight::Photometry::Read(file, error);
  if (!photometry)
  {
    std::cerr << "FAILED: " << error << "\n";
  }
  return photometry;
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::Photometry> ParseOrTell(const LampTable& table)
{
  std::string error;
  auto photometry = airlight::Photometry::Parse(TableText(table), "table", error);
  if (!photometry)
  {
    std::cerr << "FAILED: " << error << "\n";
  }
  return photometry;
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::Photometry> WriteAndRead(
  const std::string& file, const std::string& text)
{
  std::ofstream(file, std::ios::binary) << text;
  return ReadOrTell(file);
}

//------------------------------------------------------------------------------
bool FindPlace(const std::vector<double>& angles, double x, size_t& index, double& share)
{
  for (index = 0; index + 1 < angles.size(); ++index)
  {
    if (x >= angles[index] && x <= angles[index + 1])
    {
      share = (x - angles[index]) / (angles[index + 1] - angles[index]);
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
double FoldHorizontal(const LampTable& table, double h)
{
  const double last = table.Horizontal.back();
  h -= 360.0 * std::floor(h / 360.0);
  if (table.Horizontal.front() == 90.0)
  {
    return h < 90.0 ? 180.0 - h : (h > 270.0 ? 540.0 - h : h);
  }
  if (last <= 180.0 && h > 180.0)
  {
    h = 360.0 - h;
  }
  return last == 90.0 && h > 90.0 ? 180.0 - h : h;
}

//------------------------------------------------------------------------------
double TableValue(LampTable table, double v, double h)
{
  const size_t rows = table.Vertical.size();
  if (table.Type == 1)
  {
    h = FoldHorizontal(table, h);
    if (table.Horizontal.back() == 0.0)
    {
      h = 0.0;
    }
    if (table.Horizontal.back() < 360.0)
    {
      // Behind the last angle comes the first one again. Folded angles do not get there.
      table.Horizontal.push_back(360.0);
      const std::vector<double> again(table.Candela.begin(), table.Candela.begin() + rows);
      table.Candela.insert(table.Candela.end(), again.begin(), again.end());
    }
  }
  else if (table.Horizontal.front() == 0.0)
  {
    h = std::abs(h);
  }
  size_t i = 0;
  size_t j = 0;
  double s = 0.0;
  double t = 0.0;
  if (!FindPlace(table.Vertical, v, i, s) || !FindPlace(table.Horizontal, h, j, t))
  {
    return 0.0;
  }
  const double* c = table.Candela.data() + j * rows + i;
  return (1 - t) * ((1 - s) * c[0] + s * c[1]) + t * ((1 - s) * c[rows] + s * c[rows + 1]);
}

//------------------------------------------------------------------------------
std::vector<double> RandomAngles(Random& random, double first, double last)
{
  std::vector<double> ends = { 0.0 };
  const int count = 1 + random.Index(12);
  for (int i = 0; i < count; ++i)
  {
    ends.push_back(ends.back() + random.Uniform(0.3, 1.0));
  }
  std::vector<double> angles;
  for (const double end : ends)
  {
    angles.push_back(first + (last - first) * end / ends.back());
  }
  angles.back() = last;
  return angles;
}

//------------------------------------------------------------------------------
LampTable RandomTable(Random& random, int kind)
{
  constexpr double TypeC[7][2] = { { 0, 0 }, { 0, 90 }, { 0, 180 }, { 0, 360 }, { 0, 345 },
    { 0, 200 }, { 90, 270 } };
  constexpr double VerticalC[3][2] = { { 0, 90 }, { 90, 180 }, { 0, 180 } };
  constexpr double Front[5][2] = { { -90, 90 }, { 0, 90 }, { -90, 90 }, { 0, 90 }, { -30, 41 } };
  LampTable table;
  if (kind < 7)
  {
    const double* vertical = VerticalC[random.Index(3)];
    table.Type = 1;
    table.Vertical = RandomAngles(random, vertical[0], vertical[1]);
    table.Horizontal = RandomAngles(random, TypeC[kind][0], TypeC[kind][1]);
    if (kind == 0)
    {
      table.Horizontal = { 0.0 };
    }
  }
  else
  {
    const double* vertical = Front[random.Index(5)];
    const double* horizontal = Front[kind - 7];
    table.Type = 2 + random.Index(2);
    table.Vertical = RandomAngles(random, vertical[0], vertical[1]);
    table.Horizontal = RandomAngles(random, horizontal[0], horizontal[1]);
  }
  for (size_t i = 0; i < table.Vertical.size() * table.Horizontal.size(); ++i)
  {
    table.Candela.push_back(random.Uniform(0.0, 1000.0));
  }
  return table;
}

//------------------------------------------------------------------------------
void RandomFrame(Random& random, glm::dvec3& axis, glm::dvec3& up)
{
  const auto number = [&] { return random.Uniform(-1.0, 1.0); };
  axis = glm::normalize(glm::dvec3(number(), number(), number() + 1.5));
  up = glm::normalize(glm::cross(axis, glm::dvec3(1.5 + number(), number(), number())));
}
}
