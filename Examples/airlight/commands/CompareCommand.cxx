// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"

#include "commands/ComparePictures.h"
#include "formats/ImageFile.h"
#include "formats/Pfm.h"
#include "formats/UserError.h"
#include "formats/VTKMessages.h"

#include <vtkAirlightComparison.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkTable.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

namespace airlight
{

namespace
{
struct CompareOptions
{
  std::string Picture;
  std::string Reference;
  std::string Mask;
  std::string Difference;
  std::string Plot;
  int Row = 0;
  bool HasRow = false;
  bool Json = false;
};

// A column of whole numbers holds a count.
vtkIdTypeArray* AsCounts(vtkTable* table, vtkIdType column)
{
  return vtkIdTypeArray::SafeDownCast(table->GetColumn(column));
}

void PrintJson(vtkTable* metrics)
{
  nlohmann::ordered_json json;
  for (vtkIdType i = 0; i < metrics->GetNumberOfColumns(); ++i)
  {
    const std::string name = metrics->GetColumnName(i);
    if (vtkIdTypeArray* counts = AsCounts(metrics, i))
    {
      json[name] = counts->GetValue(0);
    }
    else
    {
      json[name] = metrics->GetValue(0, i).ToDouble();
    }
  }
  std::cout << json.dump(1) << std::endl;
}

void PrintLine(vtkTable* metrics)
{
  for (vtkIdType i = 0; i < metrics->GetNumberOfColumns(); ++i)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", metrics->GetValue(0, i).ToDouble());
    vtkIdTypeArray* counts = AsCounts(metrics, i);
    std::cout << (i == 0 ? "" : " ") << metrics->GetColumnName(i) << "="
              << (counts ? std::to_string(counts->GetValue(0)) : text);
  }
  std::cout << std::endl;
}

void CheckOptions(const CompareOptions& options)
{
  if (options.HasRow == options.Plot.empty())
  {
    throw UserError("--profile ROW and -o PLOT.png belong together");
  }
  if (!options.Plot.empty() && CheckImageFile(options.Plot) != ImageFormat::Png)
  {
    throw UserError(options.Plot + ": a plot is written as .png");
  }
  if (!options.Difference.empty())
  {
    CheckImageFile(options.Difference);
  }
}

void RunComparison(vtkAirlightComparison* comparison, const CompareOptions& options)
{
  comparison->SetImageData(ReadPfm(options.Picture));
  comparison->SetReferenceData(ReadPfm(options.Reference));
  comparison->SetMaskData(options.Mask.empty() ? nullptr : ReadPfm(options.Mask).Get());
  comparison->SkipNonFiniteOn();
  const VTKMessages messages;
  comparison->Update();
  if (!messages.GetFirstError().empty())
  {
    throw UserError(
      options.Picture + " and " + options.Reference + ": " + messages.GetFirstError());
  }
}

void Compare(const CompareOptions& options)
{
  CheckOptions(options);
  vtkNew<vtkAirlightComparison> comparison;
  RunComparison(comparison, options);
  if (!options.Difference.empty())
  {
    WriteDifference(comparison->GetDifference(), options.Difference);
  }
  if (options.HasRow)
  {
    WriteProfile({ vtkImageData::SafeDownCast(comparison->GetInputDataObject(0, 0)),
                   vtkImageData::SafeDownCast(comparison->GetInputDataObject(1, 0)) },
      { options.Picture, options.Reference }, options.Row, options.Plot);
  }
  options.Json ? PrintJson(comparison->GetMetrics()) : PrintLine(comparison->GetMetrics());
}
}

//------------------------------------------------------------------------------
void AddCompareCommand(CLI::App& program)
{
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
    program.add_subcommand("compare", "How far a linear picture (.pfm) is from its reference");
  command->add_option("A", options->Picture, "Picture to judge, .pfm")->required();
  command->add_option("B", options->Reference, "Reference, .pfm")->required();
  command->add_option("--mask", options->Mask, "Compare only pixels where this .pfm is above 0.5");
  command->add_flag("--json", options->Json, "Print all digits, as JSON");
  command->add_option("--difference", options->Difference,
    "Write the image A-B: .pfm, .tiff and .exr hold it as it is; in a .png grey is 0, black and "
    "white "
    "are "
    "the largest difference");
  CLI::Option* row = command->add_option(
    "--profile", options->Row, "Plot the radiance of A and B along this row, 0 is the bottom");
  command->add_option("-o,--output", options->Plot, "The plot to write, .png");
  command->footer(R"(With floor = 1e-3 of B's 99th percentile and eps = 1e-2 of its mean:
  relMSE         mean of (A-B)^2/(B^2+eps^2); relMSE_trim without the worst 0.1 % of the pixels
  median ... max of |A-B|/max(|B|, floor) where B > floor (lit); median_signed keeps the sign
  dark_max_abs   largest |A-B| where B <= floor
  bias           sum of A-B over sum of B, lit
  fit            least-squares gain, A ~ fit*B
  lit_frac       fraction of lit samples; pixels compared; values of A that are not finite
  PSNR           10 log10(max(B)^2/mean of (A-B)^2), dB; null in JSON where it is infinite)");
  command->callback([options, row] {
    options->HasRow = row->count() > 0;
    Compare(*options);
  });
}

}
