// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RatioReporter.h"

#include <algorithm>
#include <cstdio>

namespace benchmarks
{
namespace
{
double GetQuantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  const double place = share * (values.size() - 1.0);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - below) * (values[above] - values[below]);
}

double GetMedian(const std::vector<double>& values) { return GetQuantile(values, 0.5); }

// Half the way between the quartiles, as a share of the median: how far to trust it.
double GetSpread(const std::vector<double>& values)
{
  return 0.5 * (GetQuantile(values, 0.75) - GetQuantile(values, 0.25)) / GetMedian(values);
}

std::string Format(const char* format, double value)
{
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string FormatCounter(const Row& row, const char* name)
{
  const auto counter = row.Counters.find(name);
  return counter != row.Counters.end() ? Format("%.3g", counter->second) : std::string("–");
}
}

//------------------------------------------------------------------------------
bool RatioReporter::ReportContext(const Context&) { return true; }

//------------------------------------------------------------------------------
void RatioReporter::ReportRuns(const std::vector<Run>& runs)
{
  for (const Run& run : runs)
  {
    if (run.run_type != Run::RT_Iteration || run.error_occurred)
    {
      continue;
    }
    const std::string& name = run.run_name.function_name;
    const size_t bar = name.find('|');
    const std::string scene = name.substr(0, bar);
    const std::string way = name.substr(bar + 1);
    auto row = std::find_if(this->Rows.begin(), this->Rows.end(),
      [&](const Row& known) { return known.Scene == scene && known.Way == way; });
    if (row == this->Rows.end())
    {
      row = this->Rows.insert(this->Rows.end(), { scene, way, {}, {}, {} });
    }
    row->Seconds.push_back(run.real_accumulated_time / static_cast<double>(run.iterations));
    for (const auto& counter : run.counters)
    {
      row->Counters[counter.first] = counter.second;
      if (counter.first == "processor")
      {
        row->ProcessorSeconds.push_back(counter.second);
      }
    }
  }
}

//------------------------------------------------------------------------------
const Row* RatioReporter::FindPlain(const std::string& scene) const
{
  const auto row = std::find_if(this->Rows.begin(), this->Rows.end(),
    [&](const Row& known) { return known.Scene == scene && known.Way == "plain"; });
  return row != this->Rows.end() ? &*row : nullptr;
}

//------------------------------------------------------------------------------
std::string RatioReporter::GetMarkdown() const
{
  std::string text;
  std::string scene;
  for (const Row& row : this->Rows)
  {
    if (row.Scene != scene)
    {
      scene = row.Scene;
      text += "\n**" + scene + "**: " + FormatCounter(row, "triangles") + " triangles, " +
        FormatCounter(row, "width") + " x " + FormatCounter(row, "height") + " pixels\n\n" +
        "| technique | frame, ms | spread | / plain | processors, ms | / plain | error |\n"
        "|---|---|---|---|---|---|---|\n";
    }
    const Row* plain = this->FindPlain(scene);
    const auto ratio = [&](std::vector<double> Row::*times) {
      return plain ? Format("%.2f", GetMedian(row.*times) / GetMedian(plain->*times))
                   : std::string("–");
    };
    text += "| " + row.Way + " | " + Format("%.1f", 1e3 * GetMedian(row.Seconds)) + " | " +
      Format("%.0f %%", 100.0 * GetSpread(row.Seconds)) + " | " + ratio(&Row::Seconds) + " | " +
      Format("%.1f", 1e3 * GetMedian(row.ProcessorSeconds)) + " | " +
      ratio(&Row::ProcessorSeconds) + " | " + FormatCounter(row, "error") + " |\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string RatioReporter::GetCsv() const
{
  std::string text = "scene,technique,width,height,triangles,frames,median_s,spread,ratio,"
                     "processors_s,processors_ratio,error\n";
  for (const Row& row : this->Rows)
  {
    const Row* plain = this->FindPlain(row.Scene);
    const auto counter = [&row](const char* name) {
      const auto found = row.Counters.find(name);
      return found != row.Counters.end() ? Format("%.6g", found->second) : std::string();
    };
    const auto ratio = [&](std::vector<double> Row::*times) {
      return plain ? Format("%.4g", GetMedian(row.*times) / GetMedian(plain->*times))
                   : std::string();
    };
    text += row.Scene + ",\"" + row.Way + "\"," + counter("width") + "," + counter("height") + "," +
      counter("triangles") + "," + std::to_string(row.Seconds.size()) + "," +
      Format("%.6g", GetMedian(row.Seconds)) + "," + Format("%.3g", GetSpread(row.Seconds)) + "," +
      ratio(&Row::Seconds) + "," + Format("%.6g", GetMedian(row.ProcessorSeconds)) + "," +
      ratio(&Row::ProcessorSeconds) + "," + counter("error") + "\n";
  }
  return text;
}
}
