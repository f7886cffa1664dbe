// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What was measured: one row for each way of drawing each scene.
 */

#ifndef FrameRows_h
#define FrameRows_h

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace benchmarks
{
//------------------------------------------------------------------------------
// Times of the frames of one row, seconds.
struct Times
{
  std::vector<double> Seconds;

  double GetQuantile(double share) const; // linear between the frames' times
  double GetMedian() const { return this->GetQuantile(0.5); }
};

//------------------------------------------------------------------------------
struct Row
{
  std::string Scene;
  std::string Way;
  std::map<std::string, double> Counters;
  Times Clock;
  Times Processors; // all threads together

  // NaN where it was not measured.
  double GetCounter(const std::string& name) const;
};

//------------------------------------------------------------------------------
class Rows
{
public:
  // Rows are in the order in which they are first requested.
  Row& Get(const std::string& scene, const std::string& way);

  // Null where there is none.
  const Row* Find(const std::string& scene, const std::string& way) const;

  // Those of scenes of this name, or with it before the slash.
  std::vector<const Row*> FindAll(const std::string& scenes, const std::string& way) const;

  const std::vector<Row>& GetAll() const { return this->All; }

private:
  std::vector<Row> All;
};

// Whether the scene's name is `wanted`, or begins with it and a slash.
bool IsOneOf(const std::string& scene, const std::string& wanted);

//------------------------------------------------------------------------------
// Collects Google Benchmark's runs, whose names are "scene|way".
class RowReporter : public benchmark::ConsoleReporter
{
public:
  explicit RowReporter(Rows& rows)
    : Target(rows)
  {
  }
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;

private:
  Rows& Target;
};
}

#endif
