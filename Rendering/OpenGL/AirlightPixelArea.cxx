// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/AirlightPixelArea.h"

#include <algorithm>
#include <cstddef>

namespace airlight
{
namespace
{
constexpr size_t MostAreas = 64;

// A run in the row below that has the same ends grows instead.
void AddRun(std::vector<PixelArea>& areas, const PixelArea& run)
{
  const auto below = std::find_if(areas.begin(), areas.end(), [&run](const PixelArea& area) {
    return area.X == run.X && area.Width == run.Width && area.Y + area.Height == run.Y;
  });
  if (below != areas.end())
  {
    below->Height += run.Height;
  }
  else
  {
    areas.push_back(run);
  }
}

// Runs of tiles, row by row, until there are too many.
std::vector<PixelArea> Cover(
  const std::vector<unsigned int>& marks, bool marked, int side, int width, int height)
{
  const int across = (width - 1) / side + 1;
  const auto isWanted = [&](int column, int row) {
    return column < across && (marks[row * across + column] != 0) == marked;
  };
  std::vector<PixelArea> areas;
  for (int row = 0; row * side < height && areas.size() <= MostAreas; ++row)
  {
    const int y = row * side;
    const int rows = std::min(side, height - y);
    for (int column = 0; column < across && areas.size() <= MostAreas; ++column)
    {
      const int first = column;
      while (isWanted(column, row))
      {
        ++column;
      }
      if (column > first)
      {
        AddRun(areas, { first * side, y, std::min(column * side, width) - first * side, rows });
      }
    }
  }
  return areas;
}
}

//------------------------------------------------------------------------------
std::vector<PixelArea> CutRows(const std::vector<PixelArea>& areas, int row, int rows)
{
  std::vector<PixelArea> cut;
  for (const PixelArea& area : areas)
  {
    const int first = std::max(area.Y, row);
    const int end = std::min(area.Y + area.Height, row + rows);
    if (first < end)
    {
      cut.push_back({ area.X, first, area.Width, end - first });
    }
  }
  return cut;
}

//------------------------------------------------------------------------------
PixelAreas CoverTiles(const std::vector<unsigned int>& marks, int side, int width, int height)
{
  PixelAreas areas{ Cover(marks, true, side, width, height),
    Cover(marks, false, side, width, height) };
  if (areas.Marked.size() + areas.Others.size() > MostAreas)
  {
    areas = { { { 0, 0, width, height } }, {} };
  }
  return areas;
}
}
