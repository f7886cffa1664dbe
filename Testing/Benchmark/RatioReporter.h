// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Google Benchmark's runs as medians and as ratios to the plain frame of the same scene. The names
 * of benchmarks are "scene|way", one of the ways being "plain".
 */

#ifndef RatioReporter_h
#define RatioReporter_h

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace benchmarks
{
// One way of drawing one scene.
struct Row
{
  std::string Scene;
  std::string Way;
  std::vector<double> Seconds;
  std::vector<double> ProcessorSeconds;
  std::map<std::string, double> Counters;
};

class RatioReporter : public benchmark::ConsoleReporter
{
public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

  // A table for each scene.
  std::string GetMarkdown() const;
  std::string GetCsv() const;

private:
  const Row* FindPlain(const std::string& scene) const;

  std::vector<Row> Rows;
};
}

#endif
