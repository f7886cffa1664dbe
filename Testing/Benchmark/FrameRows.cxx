// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameRows.h"

#include <algorithm>
#include <iostream>
#include <limits>

namespace benchmarks
{
//------------------------------------------------------------------------------
double Times::GetQuantile(double share) const
{
  if (this->Seconds.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::vector<double> sorted = this->Seconds;
  std::sort(sorted.begin(), sorted.end());
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

//------------------------------------------------------------------------------
double Row::GetCounter(const std::string& name) const
{
  const auto counter = this->Counters.find(name);
  return counter != this->Counters.end() ? counter->second
                                         : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
Row& Rows::Get(const std::string& scene, const std::string& way)
{
  const auto row = std::find_if(this->All.begin(), this->All.end(),
    [&](const Row& known) { return known.Scene == scene && known.Way == way; });
  if (row != this->All.end())
  {
    return *row;
  }
  this->All.push_back({ scene, way, {}, {}, {} });
  return this->All.back();
}

//------------------------------------------------------------------------------
const Row* Rows::Find(const std::string& scene, const std::string& way) const
{
  for (const Row& row : this->All)
  {
    if (row.Scene == scene && row.Way == way)
    {
      return &row;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::vector<const Row*> Rows::FindAll(const std::string& scenes, const std::string& way) const
{
  std::vector<const Row*> found;
  for (const Row& row : this->All)
  {
    if (IsOneOf(row.Scene, scenes) && row.Way == way)
    {
      found.push_back(&row);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
bool IsOneOf(const std::string& scene, const std::string& wanted)
{
  return scene == wanted || scene.compare(0, wanted.size() + 1, wanted + "/") == 0;
}

namespace
{
//------------------------------------------------------------------------------
// What went wrong with a run, or null. Google Benchmark names it otherwise from version 1.8 on.
template <class Run>
auto FindError(const Run& run, int) -> decltype(&run.error_message)
{
  return run.error_occurred ? &run.error_message : nullptr;
}

template <class Run>
auto FindError(const Run& run, long) -> decltype(&run.skip_message)
{
  return run.skipped ? &run.skip_message : nullptr;
}
}

//------------------------------------------------------------------------------
void RowReporter::ReportRuns(const std::vector<Run>& runs)
{
  for (const Run& run : runs)
  {
    const std::string* error = FindError(run, 0);
    if (error)
    {
      std::cerr << "warning: " << run.run_name.function_name << ": " << *error << "\n";
    }
    if (run.run_type != Run::RT_Iteration || error)
    {
      continue;
    }
    const std::string& name = run.run_name.function_name;
    const size_t bar = name.find('|');
    Row& row = this->Target.Get(name.substr(0, bar), name.substr(bar + 1));
    row.Clock.Seconds.push_back(run.real_accumulated_time / static_cast<double>(run.iterations));
    const auto processor = run.counters.find("processor");
    if (processor != run.counters.end())
    {
      row.Processors.Seconds.push_back(processor->second);
    }
  }
}
}
