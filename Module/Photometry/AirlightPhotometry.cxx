// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Photometry/AirlightPhotometry.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

namespace airlight
{
namespace
{
// 90 degrees give the very number that the arctangent gives.
double Radians(double degrees) { return degrees / 180.0 * 3.14159265358979323846; }

// The file's text, or its first piece that is too long for a photometric file.
bool ReadText(const std::string& file, std::string& text)
{
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> piece(65536);
  while (stream && text.size() <= MaximumPhotometricText)
  {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece.data(), static_cast<size_t>(stream.gcount()));
  }
  return stream.is_open() && !stream.bad();
}

// An interval from the pole on: its start, 1/length, and where rays leave it. At the pole and
// opposite, in degrees 0 and 180, none does.
glm::dvec4 Cone(double from, double to)
{
  const double start = from > 0.0 ? std::cos(Radians(from)) : 2.0;
  const double end = to < 180.0 ? std::cos(Radians(to)) : -2.0;
  return { Radians(from), 1.0 / (Radians(to) - Radians(from)), start, end };
}

// An interval around the pole.
void AddPlane(double from, double to, bool dark, std::vector<glm::dvec4>& texels)
{
  const double middle = 0.5 * Radians(from + to);
  texels.emplace_back(std::sin(Radians(from)), std::cos(Radians(from)), 0.0, 0.0);
  texels.emplace_back(std::sin(middle), std::cos(middle),
    dark ? 0.0 : 1.0 / (Radians(to) - Radians(from)), to - from >= 180.0 ? 1.0 : 0.0);
}

// The start of an interval, its end, and 1/length.
glm::dvec4 Interval(double from, double to)
{
  return { Radians(from), Radians(to), 1.0 / (Radians(to) - Radians(from)), 0.0 };
}
}

//------------------------------------------------------------------------------
std::shared_ptr<const Photometry> Photometry::Read(const std::string& file, std::string& error)
{
  std::string text;
  if (!ReadText(file, text))
  {
    error = file + ": the file cannot be read; expected a photometric file (IES LM-63)";
    return nullptr;
  }
  return Photometry::Parse(text, file, error);
}

//------------------------------------------------------------------------------
std::shared_ptr<const Photometry> Photometry::Parse(
  const std::string& text, const std::string& name, std::string& error)
{
  PhotometricTable table;
  if (!ParsePhotometricText(text, name, table, error))
  {
    return nullptr;
  }
  return std::shared_ptr<const Photometry>(new Photometry(std::move(table)));
}

//------------------------------------------------------------------------------
Photometry::Photometry(PhotometricTable&& table)
  : Table(std::move(table))
{
  std::vector<double>& values = this->Table.Candela;
  this->Maximum = *std::max_element(values.begin(), values.end());
  for (double& value : values)
  {
    value /= this->Maximum;
  }
  for (const double angle : this->Table.Horizontal)
  {
    this->Columns.push_back({ angle, this->Columns.size() });
  }
  this->ExpandSymmetry();
}

//------------------------------------------------------------------------------
void Photometry::ExpandSymmetry()
{
  const double first = this->Table.Horizontal.front();
  const double last = this->Table.Horizontal.back();
  if (this->Table.Type != PhotometricType::C)
  {
    if (first == 0.0)
    {
      this->MirrorAtFirst();
    }
    return;
  }
  if (last == 90.0)
  {
    this->MirrorAtLast();
  }
  if (last == 90.0 || last == 180.0 || first == 90.0)
  {
    this->MirrorAtLast();
  }
  if (this->Columns.back().Angle < first + 360.0)
  {
    this->Columns.push_back({ first + 360.0, 0 });
  }
}

//------------------------------------------------------------------------------
void Photometry::MirrorAtFirst()
{
  std::vector<Column> mirrored;
  for (size_t i = this->Columns.size(); i > 1; --i)
  {
    const Column& column = this->Columns[i - 1];
    mirrored.push_back({ 2.0 * this->Columns.front().Angle - column.Angle, column.Source });
  }
  this->Columns.insert(this->Columns.begin(), mirrored.begin(), mirrored.end());
}

//------------------------------------------------------------------------------
void Photometry::MirrorAtLast()
{
  const Column last = this->Columns.back();
  for (size_t i = this->Columns.size() - 1; i > 0; --i)
  {
    const Column column = this->Columns[i - 1];
    this->Columns.push_back({ 2.0 * last.Angle - column.Angle, column.Source });
  }
}

//------------------------------------------------------------------------------
double Photometry::GetValue(size_t column, size_t vertical) const
{
  return this->Table.Candela[this->Columns[column].Source * this->Table.Vertical.size() + vertical];
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> Photometry::Pack() const
{
  const std::vector<double>& vertical = this->Table.Vertical;
  const size_t rows = vertical.size() - 1;
  const size_t columns = this->Columns.size() - 1;
  std::vector<glm::dvec4> texels;
  texels.reserve(1 + rows + columns + rows * columns);
  texels.emplace_back(static_cast<double>(rows), static_cast<double>(columns),
    static_cast<double>(this->Table.Type), 0.0);
  for (size_t i = 0; i < rows; ++i)
  {
    texels.push_back(Interval(vertical[i], vertical[i + 1]));
  }
  for (size_t j = 0; j < columns; ++j)
  {
    texels.push_back(Interval(this->Columns[j].Angle, this->Columns[j + 1].Angle));
  }
  for (size_t j = 0; j < columns; ++j)
  {
    for (size_t i = 0; i < rows; ++i)
    {
      texels.emplace_back(this->GetValue(j, i), this->GetValue(j, i + 1), this->GetValue(j + 1, i),
        this->GetValue(j + 1, i + 1));
    }
  }
  this->PackPolar(texels);
  return texels;
}

//------------------------------------------------------------------------------
void Photometry::PackPolar(std::vector<glm::dvec4>& texels) const
{
  std::vector<double> horizontal;
  for (const Column& column : this->Columns)
  {
    horizontal.push_back(column.Angle);
  }
  const bool isB = this->Table.Type == PhotometricType::B;
  const bool isC = this->Table.Type == PhotometricType::C;
  const std::vector<double>& planes = isB ? this->Table.Vertical : horizontal;
  std::vector<double> cones = isB ? horizontal : this->Table.Vertical;
  for (double& angle : cones)
  {
    angle += isC ? 0.0 : 90.0; // from the pole, not from the plane across it
  }
  texels.emplace_back(0.0, 0.0, 2.0, cones.front() > 0.0 ? std::cos(Radians(cones.front())) : -2.0);
  for (size_t i = 0; i + 1 < cones.size(); ++i)
  {
    texels.push_back(Cone(cones[i], cones[i + 1]));
  }
  const bool open = cones.back() < 180.0;
  texels.emplace_back(
    open ? Radians(cones.back()) : 4.0, 0.0, open ? std::cos(Radians(cones.back())) : 2.0, -2.0);
  for (size_t j = 0; j + 1 < planes.size(); ++j)
  {
    AddPlane(planes[j], planes[j + 1], false, texels);
  }
  if (!isC)
  {
    AddPlane(planes.back(), planes.front() + 360.0, true, texels);
  }
}
}
