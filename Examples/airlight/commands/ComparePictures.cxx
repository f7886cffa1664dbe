// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/ComparePictures.h"

#include "formats/ImageFile.h"
#include "formats/UserError.h"
#include "scene/Display.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace airlight
{

namespace
{
const char* const ChannelNames[3] = { " red", " green", " blue" };
constexpr unsigned char ChannelColours[3][3] = { { 200, 40, 40 }, { 30, 140, 50 },
  { 40, 70, 200 } };

float GetValue(vtkImageData* image, int x, int row, int channel)
{
  return image->GetScalarComponentAsFloat(x, row, 0, channel);
}

// Whether light is white along the row, so that one line stands for all channels.
bool IsGrey(vtkImageData* image, int row)
{
  for (int x = 0; x < image->GetDimensions()[0]; ++x)
  {
    for (int c = 1; c < image->GetNumberOfScalarComponents(); ++c)
    {
      if (GetValue(image, x, row, c) != GetValue(image, x, row, 0))
      {
        return false;
      }
    }
  }
  return true;
}

vtkSmartPointer<vtkFloatArray> AddColumn(vtkTable* table, const std::string& name, vtkIdType count)
{
  auto column = vtkSmartPointer<vtkFloatArray>::New();
  column->SetName(name.c_str());
  column->SetNumberOfValues(count);
  table->AddColumn(column);
  return column;
}

// The table's first column are the places; another one per line. Not a number leaves a gap.
void FillTable(vtkTable* table, vtkImageData* image, int row, int channel, const std::string& name)
{
  const int width = image->GetDimensions()[0];
  const auto column = AddColumn(table, name, width);
  for (int x = 0; x < width; ++x)
  {
    const float value = GetValue(image, x, row, channel);
    column->SetValue(x, std::isfinite(value) ? value : std::nanf(""));
  }
}

void SetAxis(vtkChartXY* chart, int which, const char* title)
{
  vtkAxis* axis = chart->GetAxis(which);
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(16);
  axis->GetLabelProperties()->SetFontSize(14);
}

void AddLine(vtkChartXY* chart, vtkTable* table, const unsigned char colour[3], bool dashed)
{
  vtkPlot* line = chart->AddPlot(vtkChart::LINE);
  line->SetInputData(table, 0, table->GetNumberOfColumns() - 1);
  line->SetColor(colour[0], colour[1], colour[2], dashed ? 255 : 140);
  line->SetWidth(dashed ? 1.5f : 4.0f);
  line->GetPen()->SetLineType(dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
}

void AddLines(vtkChartXY* chart, vtkTable* table, const std::array<vtkImageData*, 2>& images,
  const std::array<std::string, 2>& names, int row)
{
  const bool grey = IsGrey(images[0], row) && IsGrey(images[1], row);
  const int channels = grey ? 1 : std::min(3, images[0]->GetNumberOfScalarComponents());
  constexpr unsigned char black[3] = { 60, 60, 60 };
  for (int i = 0; i < 2; ++i)
  {
    const std::string name = std::filesystem::path(names[i]).filename().string();
    for (int c = 0; c < channels; ++c)
    {
      const std::string label = (i == 0 ? "A " : "B ") + name + (grey ? "" : ChannelNames[c]);
      FillTable(table, images[i], row, c, label);
      AddLine(chart, table, grey ? black : ChannelColours[c], i == 1);
    }
  }
}

void WriteView(vtkContextView* view, const std::string& fileName)
{
  view->GetRenderWindow()->SetOffScreenRendering(1);
  view->GetRenderWindow()->SetSize(960, 600);
  view->GetRenderWindow()->SetMultiSamples(0);
  view->Render();
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(view->GetRenderWindow());
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  grabber->Update();
  WritePng(grabber->GetOutput(), fileName);
}
}

//------------------------------------------------------------------------------
void WriteDifference(vtkImageData* difference, const std::string& fileName)
{
  if (CheckImageFile(fileName) != ImageFormat::Png)
  {
    WriteFloatImage(difference, fileName);
    return;
  }
  vtkNew<vtkImageData> shown;
  shown->DeepCopy(difference);
  auto* values = static_cast<float*>(shown->GetScalarPointer());
  const vtkIdType count = shown->GetNumberOfPoints() * shown->GetNumberOfScalarComponents();
  float largest = 0.0f;
  std::for_each(values, values + count,
    [&largest](float value) { largest = std::max(largest, std::abs(value)); });
  const float scale = largest > 0.0f ? 0.5f / largest : 0.0f;
  std::transform(
    values, values + count, values, [scale](float value) { return 0.5f + scale * value; });
  WriteFloatImage(shown, fileName);
}

//------------------------------------------------------------------------------
void WriteProfile(const std::array<vtkImageData*, 2>& images,
  const std::array<std::string, 2>& names, int row, const std::string& fileName)
{
  const int* size = images[0]->GetDimensions();
  if (row < 0 || row >= size[1])
  {
    throw UserError("--profile " + std::to_string(row) + ": " + names[0] + " has the rows 0 to " +
      std::to_string(size[1] - 1));
  }
  CheckDisplay();
  vtkNew<vtkTable> table;
  const auto places = AddColumn(table, "x", size[0]);
  for (int x = 0; x < size[0]; ++x)
  {
    places->SetValue(x, static_cast<float>(x));
  }
  vtkNew<vtkContextView> view;
  vtkNew<vtkChartXY> chart;
  view->GetScene()->AddItem(chart);
  AddLines(chart, table, images, names, row);
  chart->SetShowLegend(true);
  chart->GetLegend()->SetLabelSize(14);
  chart->SetTitle("Row " + std::to_string(row));
  SetAxis(chart, vtkAxis::BOTTOM, "pixel");
  SetAxis(chart, vtkAxis::LEFT, "radiance");
  WriteView(view, fileName);
}

}
