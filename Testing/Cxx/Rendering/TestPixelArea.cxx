// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Marked tiles and all others: each pixel of the viewport is in one rectangle of the right part,
// whatever the marks and however the tiles are cut by the viewport's edges.

#include "AirlightTestCheck.h"
#include "AirlightTestTools.h"
#include "OpenGL/AirlightPixelArea.h"

#include <algorithm>
#include <cstdlib>

using namespace airlight_test;
using airlight::CoverTiles;
using airlight::CutRows;
using airlight::PixelArea;
using airlight::PixelAreas;

namespace
{
constexpr int Side = 16;

int CountTiles(int width, int height)
{
  return ((width + Side - 1) / Side) * ((height + Side - 1) / Side);
}

// How many of the areas each pixel is in.
std::vector<int> Count(const std::vector<PixelArea>& areas, int width, int height)
{
  std::vector<int> counts(width * height, 0);
  for (const PixelArea& area : areas)
  {
    for (int y = area.Y; y < area.Y + area.Height; ++y)
    {
      for (int x = area.X; x < area.X + area.Width; ++x)
      {
        Check(x >= 0 && y >= 0 && x < width && y < height, Text("pixel ", x, " ", y, " is inside"));
        ++counts.at(y * width + x);
      }
    }
  }
  return counts;
}

// Whether the two parts are those of the marks.
bool IsCovered(
  const PixelAreas& areas, const std::vector<unsigned int>& marks, int width, int height)
{
  const std::vector<int> marked = Count(areas.Marked, width, height);
  const std::vector<int> others = Count(areas.Others, width, height);
  const int across = (width + Side - 1) / Side;
  for (int i = 0; i < width * height; ++i)
  {
    const bool isMarked = marks[(i / width / Side) * across + i % width / Side] != 0;
    if (marked[i] != (isMarked ? 1 : 0) || others[i] != (isMarked ? 0 : 1))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void TestRandom()
{
  Random random(5);
  for (int i = 0; i < 200; ++i)
  {
    const int width = 1 + random.Index(150);
    const int height = 1 + random.Index(120);
    const double share = random.Uniform(0.0, 0.2);
    std::vector<unsigned int> marks(CountTiles(width, height));
    std::generate(
      marks.begin(), marks.end(), [&] { return random.Uniform(0.0, 1.0) < share ? 1u : 0u; });
    const PixelAreas areas = CoverTiles(marks, Side, width, height);
    Check(IsCovered(areas, marks, width, height), Text("marks ", i, ", ", width, " x ", height));
  }
}

void TestFew()
{
  std::vector<unsigned int> marks(CountTiles(200, 100), 0u);
  Check(CoverTiles(marks, Side, 200, 100).Marked.empty(), "nothing is marked");
  Check(CoverTiles(marks, Side, 200, 100).Others == std::vector<PixelArea>{ { 0, 0, 200, 100 } },
    "all is one rectangle");
  for (int row = 2; row < 5; ++row)
  {
    for (int column = 3; column < 7; ++column)
    {
      marks[row * 13 + column] = 1u;
    }
  }
  Check(CoverTiles(marks, Side, 200, 100).Marked == std::vector<PixelArea>{ { 48, 32, 64, 48 } },
    "a block of tiles is one rectangle");
}

// Draws cost more than what they spare.
void TestMany()
{
  std::vector<unsigned int> marks(CountTiles(640, 480));
  for (size_t i = 0; i < marks.size(); ++i)
  {
    marks[i] = (i + i / 40) % 2;
  }
  const PixelAreas areas = CoverTiles(marks, Side, 640, 480);
  Check(areas.Marked == std::vector<PixelArea>{ { 0, 0, 640, 480 } } && areas.Others.empty(),
    "a chessboard is taken as a whole");
}

void TestRows()
{
  const std::vector<PixelArea> areas{ { 0, 0, 10, 20 }, { 10, 15, 5, 30 }, { 0, 50, 9, 9 } };
  Check(CutRows(areas, 10, 10) == std::vector<PixelArea>{ { 0, 10, 10, 10 }, { 10, 15, 5, 5 } },
    "what of the areas is in ten rows");
}
}

//------------------------------------------------------------------------------
int TestPixelArea(int, char*[])
{
  TestRandom();
  TestFew();
  TestMany();
  TestRows();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
