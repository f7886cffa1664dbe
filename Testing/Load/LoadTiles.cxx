// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Large pictures of tiles: those of a window of that size, and no seam where tiles meet.

#include "LoadTools.h"

#include "vtkPNGWriter.h"
#include "vtkWindowToImageFilter.h"

using namespace airlighttest;

namespace airlightload
{
namespace
{
// Differences of neighbours across the seams may not exceed those of the direct picture.
int CompareSeams(
  const Picture& direct, const Picture& tiles, int width, int height, int tileWidth, int tileHeight)
{
  int largest = 0;
  const auto at = [&](const Picture& picture, int x, int y, int c) {
    return picture[3 * (static_cast<size_t>(width) * y + x) + c];
  };
  for (int y = 1; y < height; ++y)
  {
    for (int x = 1; x < width; ++x)
    {
      if (x % tileWidth != 0 && y % tileHeight != 0)
      {
        continue;
      }
      const int dx = x % tileWidth == 0 ? 1 : 0;
      const int dy = 1 - dx;
      for (int c = 0; c < 3; ++c)
      {
        const int step = at(tiles, x, y, c) - at(tiles, x - dx, y - dy, c);
        const int expected = at(direct, x, y, c) - at(direct, x - dx, y - dy, c);
        largest = std::max(largest, std::abs(step - expected));
      }
    }
  }
  return largest;
}

Picture Shoot(vtkRenderWindow* window, int scale, const char* file)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetScale(scale, scale);
  filter->SetFixBoundary(false);
  filter->ReadFrontBufferOff();
  filter->Update();
  if (file)
  {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(filter->GetOutputPort());
    writer->SetFileName(file);
    writer->Write();
  }
  vtkImageData* image = filter->GetOutput();
  const auto* first = static_cast<const unsigned char*>(image->GetScalarPointer());
  return Picture(first, first + 3 * image->GetNumberOfPoints());
}
}

//------------------------------------------------------------------------------
void RunTiles(const Options& options)
{
  const int scale = options.Scale > 0 ? options.Scale : 8;
  const int width = options.Size.empty() ? 960 : options.Size[0];
  const int height = options.Size.empty() ? 540 : options.Size[1];
  WindowScene small(width, height, 2);
  small.Pass->RecordBuffersOff();
  const Picture before = Capture(small.Window);
  Clock clock;
  const Picture tiles =
    Shoot(small.Window, scale, options.Scene.empty() ? nullptr : options.Scene.c_str());
  std::cout << width * scale << " x " << height * scale << " pixels in " << scale * scale
            << " tiles: " << clock.GetSeconds() << " s, " << GetPeak() << " MiB at most\n";
  Check(before == Capture(small.Window), "the window is as before");
  clock = Clock();
  WindowScene large(scale * width, scale * height, 2);
  large.Pass->RecordBuffersOff();
  const Picture direct = Capture(large.Window);
  std::cout << "in one frame: " << clock.GetSeconds() << " s, " << GetPeak() << " MiB at most\n";
  const int most = Compare(direct, tiles);
  const int different = CountDifferent(direct, tiles, 0);
  const int seams = CompareSeams(direct, tiles, scale * width, scale * height, width, height);
  std::cout << different << " of " << direct.size() / 3 << " pixels differ, by " << most
            << "/255 at most; steps across seams by " << seams << "/255 at most\n";
  Check(ShowsScene(direct), "something is seen");
  Check(most <= 1, "tiles make the picture of a large window");
  Check(seams <= 1, "no seams");
}
}
