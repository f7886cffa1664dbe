// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameOutput.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <limits>

namespace benchmarks
{
namespace
{
using Json = nlohmann::ordered_json;

// What rows may have counted, in the order of columns.
const char* const Counters[] = { "width", "height", "triangles", "edges", "steps", "target",
  "error" };

// `missing` for what is not finite.
std::string Format(const char* format, double value, const char* missing = "–")
{
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return std::isfinite(value) ? text : missing;
}

// Median and quartiles. Not every row has times: another technique may have been drawn.
std::string FormatMilliseconds(const Times& times)
{
  if (times.Seconds.empty())
  {
    return "– | –";
  }
  return Format("%.2f", 1e3 * times.GetMedian()) + " | " +
    Format("%.2f", 1e3 * times.GetQuantile(0.25)) + "–" +
    Format("%.2f", 1e3 * times.GetQuantile(0.75));
}

Json MakeNumber(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json MakeTimes(const Times& times, double ratio)
{
  return { { "median", MakeNumber(times.GetMedian()) },
    { "lower_quartile", MakeNumber(times.GetQuantile(0.25)) },
    { "upper_quartile", MakeNumber(times.GetQuantile(0.75)) }, { "ratio", MakeNumber(ratio) },
    { "seconds", times.Seconds } };
}
}

//------------------------------------------------------------------------------
FrameOutput::FrameOutput(const Machine& machine, const Rows& rows)
  : Where(machine)
  , Measured(rows)
{
}

//------------------------------------------------------------------------------
double FrameOutput::GetRatio(const Row& row, Times Row::*kind) const
{
  const Row* plain = this->Measured.Find(row.Scene, "plain");
  return plain ? (row.*kind).GetMedian() / (plain->*kind).GetMedian()
               : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
std::string FrameOutput::GetMarkdownHead() const
{
  const OpenGLNames& opengl = this->Where.OpenGL;
  return "OpenGL by " + opengl.Vendor + ": " + opengl.Renderer + ", " + opengl.Version + " (" +
    (opengl.IsSoftware ? "**software: it draws on the processors**" : "a graphics card") +
    "). VTK " + this->Where.VTKVersion + ". " + std::to_string(this->Where.Processors) +
    " processors, load " + Format("%.2f", this->Where.LoadBefore) + " before and " +
    Format("%.2f", this->Where.LoadAfter) + " after.\n";
}

//------------------------------------------------------------------------------
std::string FrameOutput::GetMarkdownRow(const Row& row) const
{
  const double target = row.GetCounter("target"); // its way's name does not tell the steps
  const std::string steps =
    std::isfinite(target) ? Format(", %.0f steps", row.GetCounter("steps")) : std::string();
  return "| " + row.Way + steps + " | " + FormatMilliseconds(row.Clock) + " | " +
    Format("%.2f", this->GetRatio(row, &Row::Clock)) + " | " + FormatMilliseconds(row.Processors) +
    " | " + Format("%.2f", this->GetRatio(row, &Row::Processors)) + " | " +
    Format("%.2g", row.GetCounter("error")) + " |\n";
}

//------------------------------------------------------------------------------
std::string FrameOutput::GetMarkdownFigures() const
{
  std::string text;
  for (const Figure& figure : DeriveFigures(this->Measured))
  {
    text += "| " + figure.Name + " | " + Format("%.3g", figure.Clock) + " | " +
      Format("%.3g", figure.Processors) + " |\n";
  }
  return text.empty()
    ? text
    : "\n**What follows from these medians** (*extra*: beyond plain; *shadows*: planes beyond no "
      "shadows)\n\n| figure | clock | processors |\n|---|---|---|\n" +
      text;
}

//------------------------------------------------------------------------------
std::string FrameOutput::GetMarkdown() const
{
  std::string text = this->GetMarkdownHead();
  std::string scene;
  for (const Row& row : this->Measured.GetAll())
  {
    if (row.Scene != scene)
    {
      scene = row.Scene;
      text += "\n**" + scene + "**: " + Format("%.0f", row.GetCounter("triangles")) +
        " triangles, " + Format("%.0f", row.GetCounter("edges")) + " silhouette edges, " +
        Format("%.0f", row.GetCounter("width")) + " x " + Format("%.0f", row.GetCounter("height")) +
        " pixels, " + std::to_string(row.Clock.Seconds.size()) +
        " frames\n\n| technique | frame, ms | quartiles | / plain | processors, ms | quartiles | "
        "/ plain | error |\n|---|---|---|---|---|---|---|---|\n";
    }
    text += this->GetMarkdownRow(row);
  }
  return text + this->GetMarkdownFigures();
}

//------------------------------------------------------------------------------
std::string FrameOutput::GetCsv() const
{
  std::string text = "renderer,scene,technique";
  for (const char* counter : Counters)
  {
    text += std::string(",") + counter;
  }
  text += ",frames,median_s,lower_quartile_s,upper_quartile_s,ratio,processors_s,"
          "processors_lower_quartile_s,processors_upper_quartile_s,processors_ratio\n";
  for (const Row& row : this->Measured.GetAll())
  {
    text += "\"" + this->Where.OpenGL.Renderer + "\"," + row.Scene + ",\"" + row.Way + "\"";
    for (const char* counter : Counters)
    {
      text += "," + Format("%.9g", row.GetCounter(counter), "");
    }
    text += "," + std::to_string(row.Clock.Seconds.size());
    for (Times Row::*kind : { &Row::Clock, &Row::Processors })
    {
      for (double value : { (row.*kind).GetMedian(), (row.*kind).GetQuantile(0.25),
             (row.*kind).GetQuantile(0.75), this->GetRatio(row, kind) })
      {
        text += "," + Format("%.6g", value, "");
      }
    }
    text += "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string FrameOutput::GetJson() const
{
  Json rows = Json::array();
  for (const Row& row : this->Measured.GetAll())
  {
    Json entry = { { "scene", row.Scene }, { "technique", row.Way } };
    for (const char* counter : Counters)
    {
      entry[counter] = MakeNumber(row.GetCounter(counter));
    }
    entry["clock"] = MakeTimes(row.Clock, this->GetRatio(row, &Row::Clock));
    entry["processors"] = MakeTimes(row.Processors, this->GetRatio(row, &Row::Processors));
    rows.push_back(entry);
  }
  Json figures = Json::array();
  for (const Figure& figure : DeriveFigures(this->Measured))
  {
    figures.push_back({ { "name", figure.Name }, { "clock", MakeNumber(figure.Clock) },
      { "processors", MakeNumber(figure.Processors) } });
  }
  const OpenGLNames& opengl = this->Where.OpenGL;
  const Json all = { { "machine",
                       { { "opengl_vendor", opengl.Vendor }, { "opengl_renderer", opengl.Renderer },
                         { "opengl_version", opengl.Version }, { "software", opengl.IsSoftware },
                         { "vtk", this->Where.VTKVersion },
                         { "processors", this->Where.Processors },
                         { "load_before", MakeNumber(this->Where.LoadBefore) },
                         { "load_after", MakeNumber(this->Where.LoadAfter) } } },
    { "rows", rows }, { "figures", figures } };
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}
}
