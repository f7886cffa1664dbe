// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Large pictures of tiles: those of a window of that size, and no seam where tiles meet.

#include "LoadTools.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkPNGWriter.h"
#include "vtkWindowToImageFilter.h"

using namespace airlight_test;

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

// Roundings of the projection move edges by less than a pixel: each pixel of the tiles has a colour
// that lies between those around it in the direct picture. Returns how many values do not, by more
// than 1/255.
int CountForeign(const Picture& direct, const Picture& tiles, int width, int height)
{
  int count = 0;
  for (int i = 0; i < 3 * width * height; ++i)
  {
    if (std::abs(direct[i] - tiles[i]) <= 1)
    {
      continue;
    }
    int low = 255;
    int high = 0;
    const int x = i / 3 % width;
    const int y = i / 3 / width;
    for (int n = 0; n < 9; ++n)
    {
      const int column = std::clamp(x + n % 3 - 1, 0, width - 1);
      const int row = std::clamp(y + n / 3 - 1, 0, height - 1);
      const int value = direct[3 * (row * width + column) + i % 3];
      low = std::min(low, value);
      high = std::max(high, value);
    }
    count += tiles[i] < low - 1 || tiles[i] > high + 1 ? 1 : 0;
  }
  return count;
}

// Keeps the radiance of each tile that is drawn, at its place in the whole.
class TileReader
{
public:
  TileReader(WindowScene& scene, int scale)
    : Stage(scene)
    , Scale(scale)
    , Radiance(3 * static_cast<size_t>(scale * scale) * scene.Width * scene.Height, -1.0f)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*) { static_cast<TileReader*>(data)->Read(); });
    this->Tag = scene.Window->AddObserver(vtkCommand::EndEvent, command);
  }
  ~TileReader() { this->Stage.Window->RemoveObserver(this->Tag); }
  TileReader(const TileReader&) = delete;
  void operator=(const TileReader&) = delete;

  // With a window of the whole's size.
  void Compare(vtkImageData* direct) const
  {
    const auto* expected = static_cast<const float*>(direct->GetScalarPointer());
    const double largest = *std::max_element(expected, expected + this->Radiance.size());
    std::vector<double> off;
    size_t same = 0;
    for (size_t i = 0; i < this->Radiance.size(); ++i)
    {
      off.push_back(std::abs(this->Radiance[i] - expected[i]) / largest);
      same += this->Radiance[i] == expected[i] ? 1 : 0;
    }
    std::sort(off.begin(), off.end());
    const auto part = [&](double share) {
      return off[static_cast<size_t>(share * static_cast<double>(off.size() - 1))];
    };
    std::cout << "radiance: " << 100.0 * static_cast<double>(same) / static_cast<double>(off.size())
              << " % the same to the last bit; off by " << part(0.5) << " in the median, "
              << part(0.99) << " at 99 %, " << off.back() << " at most, of the largest value\n";
    Check(part(0.99) < 1e-5, "radiance of tiles is that of a large window");
  }

private:
  void Read()
  {
    vtkImageData* tile = this->Stage.GetBuffer("Radiance");
    double view[4];
    this->Stage.Window->GetTileViewport(view);
    const int column = static_cast<int>(std::lround(view[0] * this->Scale));
    const int row = static_cast<int>(std::lround(view[1] * this->Scale));
    const int width = this->Stage.Width;
    for (int y = 0; tile && y < this->Stage.Height; ++y)
    {
      const auto* values = static_cast<const float*>(tile->GetScalarPointer(0, y, 0));
      const size_t at = static_cast<size_t>(row * this->Stage.Height + y) * this->Scale + column;
      std::copy(values, values + 3 * width, &this->Radiance[3 * width * at]);
    }
  }

  WindowScene& Stage;
  int Scale;
  unsigned long Tag;
  std::vector<float> Radiance;
};

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
namespace
{
// Of small tiles, in single precision.
void CompareRadiance()
{
  const int scale = 4;
  WindowScene small(96, 72, 2);
  TileReader reader(small, scale);
  Shoot(small.Window, scale, nullptr);
  WindowScene large(96 * scale, 72 * scale, 2);
  large.Window->Render();
  reader.Compare(large.GetBuffer("Radiance"));
  small.Renderer->SetPass(nullptr);
  large.Renderer->SetPass(nullptr);
  const Picture plain = Capture(large.Window);
  std::cout << "VTK alone: " << CountDifferent(plain, Shoot(small.Window, scale, nullptr), 0)
            << " of " << plain.size() / 3 << " pixels differ\n";
}
}

//------------------------------------------------------------------------------
void RunTiles(const Options& options)
{
  CompareRadiance();
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
  Check(
    different < static_cast<int>(direct.size() / 1500), "tiles make the picture of a large window");
  const int foreign = CountForeign(direct, tiles, scale * width, scale * height);
  std::cout << foreign << " values lie between none around them\n";
  // An outline's pixel can be covered by a triangle that its middle is beside, where the surface
  // shadows itself, in one of the pictures: one in ten millions.
  Check(foreign <= static_cast<int>(direct.size() / 10000000), "and differ at edges only");
  Check(seams <= 1, "no seams");
}
}
