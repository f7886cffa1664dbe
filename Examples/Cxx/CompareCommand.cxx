// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "ImageMetrics.h"
#include "Pfm.h"
#include "UserError.h"

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
  bool Json = false;
};

void PrintJson(const ImageMetrics& metrics)
{
  nlohmann::ordered_json json;
  for (const auto& [name, value] : metrics.GetNamed())
  {
    std::visit([&json, &key = name](auto number) { json[key] = number; }, value);
  }
  std::cout << json.dump(1) << std::endl;
}

std::string Format(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", number);
  return text;
}

std::string Format(long long number) { return std::to_string(number); }

void PrintLine(const ImageMetrics& metrics)
{
  std::string line;
  for (const auto& [name, value] : metrics.GetNamed())
  {
    line += (line.empty() ? "" : " ") + name + "=";
    line += std::visit([](auto number) { return Format(number); }, value);
  }
  std::cout << line << std::endl;
}

void Compare(const CompareOptions& options)
{
  const auto picture = ReadPfm(options.Picture);
  const auto reference = ReadPfm(options.Reference);
  const auto mask = options.Mask.empty() ? nullptr : ReadPfm(options.Mask);
  ImageMetrics metrics;
  try
  {
    metrics = CompareImages(picture, reference, mask);
  }
  catch (const UserError& error)
  {
    throw UserError(options.Picture + " and " + options.Reference + ": " + error.what());
  }
  options.Json ? PrintJson(metrics) : PrintLine(metrics);
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
  command->footer(R"(With floor = 1e-3 of B's 99th percentile and eps = 1e-2 of its mean:
  relMSE         mean of (A-B)^2/(B^2+eps^2); relMSE_trim without the worst 0.1 % of the pixels
  median ... max of |A-B|/max(|B|, floor) where B > floor (lit); median_signed keeps the sign
  dark_max_abs   largest |A-B| where B <= floor
  bias           sum of A-B over sum of B, lit
  fit            least-squares gain, A ~ fit*B
  lit_frac       fraction of lit samples; pixels compared; values of A that are not finite)");
  command->callback([options] { Compare(*options); });
}

}
