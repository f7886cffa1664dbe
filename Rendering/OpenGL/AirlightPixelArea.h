// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rectangles of pixels, for draws of which a part of the viewport has no need.
 */

#ifndef AirlightPixelArea_h
#define AirlightPixelArea_h

#include "vtkAirlightModule.h" // for export macro

#include <vector>

namespace airlight
{
struct PixelArea
{
  int X; // lower left corner
  int Y;
  int Width;
  int Height;

  bool operator==(const PixelArea& other) const
  {
    return this->X == other.X && this->Y == other.Y && this->Width == other.Width &&
      this->Height == other.Height;
  }
};

// What of the areas is in some rows.
VTKAIRLIGHT_EXPORT std::vector<PixelArea> CutRows(
  const std::vector<PixelArea>& areas, int row, int rows);

// The viewport in two parts, as few rectangles as are found fast: tiles that are marked, and all
// others. Of too many small ones the first part is everything: each takes a draw.
struct PixelAreas
{
  std::vector<PixelArea> Marked;
  std::vector<PixelArea> Others;
};

// `marks`: a number for each tile of so many pixels a side, row by row from the lower left one on.
VTKAIRLIGHT_EXPORT PixelAreas CoverTiles(
  const std::vector<unsigned int>& marks, int side, int width, int height);
}

#endif
