// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameFigures.h"

#include "FrameChanges.h"
#include "FrameContent.h"
#include "FrameQuadrature.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace benchmarks
{
namespace
{
const char* const Planes = "shadow planes";
const char* const Unshadowed = "no shadows";
const char* const PlainWay = "plain";

// One of the two times of a row.
using Kind = Times Row::*;

constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

// What a row takes more than another way of drawing the same scene; NaN where there is none.
double GetExcess(const Rows& rows, const Row& row, const char* other, Kind kind)
{
  const Row* base = rows.Find(row.Scene, other);
  return base ? (row.*kind).GetMedian() - (base->*kind).GetMedian() : NoValue;
}

// NaN unless both are above 0.
double Divide(double a, double b) { return a > 0.0 && b > 0.0 ? a / b : NoValue; }

void Add(
  std::vector<Figure>& figures, const std::string& name, const std::function<double(Kind)>& compute)
{
  figures.push_back({ name, compute(&Row::Clock), compute(&Row::Processors) });
}

//------------------------------------------------------------------------------
// A straight line through points by least squares.
struct Line
{
  double Slope = NoValue;
  double Start = NoValue;
};

Line Fit(const std::vector<double>& x, const std::vector<double>& y)
{
  const auto n = static_cast<double>(x.size());
  double meanX = 0.0;
  double meanY = 0.0;
  for (size_t i = 0; i < x.size(); ++i)
  {
    meanX += x[i] / n;
    meanY += y[i] / n;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (size_t i = 0; i < x.size(); ++i)
  {
    xx += (x[i] - meanX) * (x[i] - meanX);
    xy += (x[i] - meanX) * (y[i] - meanY);
  }
  return xx > 0.0 ? Line{ xy / xx, meanY - xy / xx * meanX } : Line{};
}

// The b of c x^b; of times that are not above 0 the logarithm, and so b, is NaN.
double FitExponent(std::vector<double> x, std::vector<double> y)
{
  const auto logarithm = [](double value) { return value > 0.0 ? std::log(value) : NoValue; };
  std::transform(x.begin(), x.end(), x.begin(), logarithm);
  std::transform(y.begin(), y.end(), y.begin(), logarithm);
  return Fit(x, y).Slope;
}

//------------------------------------------------------------------------------
// The march that is as good as requested, beside the planes.
void AddMarch(const Rows& rows, std::vector<Figure>& figures)
{
  for (const Row& march : rows.GetAll())
  {
    const Row* planes = rows.Find(march.Scene, Planes);
    if (!(march.GetCounter("target") > 0.0) || !planes)
    {
      continue;
    }
    const std::string name = march.Scene + ": " + march.Way + " / " + Planes;
    Add(figures, name + ", frame",
      [&](Kind kind) { return Divide((march.*kind).GetMedian(), (planes->*kind).GetMedian()); });
    Add(figures, name + ", extra", [&](Kind kind) {
      return Divide(
        GetExcess(rows, march, PlainWay, kind), GetExcess(rows, *planes, PlainWay, kind));
    });
    Add(figures, name + ", beyond no shadows", [&](Kind kind) {
      return Divide(
        GetExcess(rows, march, Unshadowed, kind), GetExcess(rows, *planes, Unshadowed, kind));
    });
  }
}

void AddLights(const Rows& rows, std::vector<Figure>& figures)
{
  for (const char* way : { Unshadowed, Planes })
  {
    const Row* one = rows.Find("lights/1", way);
    for (const Row* many : rows.FindAll("lights", way))
    {
      if (one && many != one)
      {
        Add(figures, many->Scene + ": extra / that of one light, " + way, [&](Kind kind) {
          return Divide(
            GetExcess(rows, *many, PlainWay, kind), GetExcess(rows, *one, PlainWay, kind));
        });
      }
    }
  }
}

//------------------------------------------------------------------------------
// Milliseconds per million pixels.
double GetTimePerPixels(const Rows& rows, const Row& row, Kind kind)
{
  const double pixels = row.GetCounter("width") * row.GetCounter("height");
  return 1e9 * GetExcess(rows, row, PlainWay, kind) / pixels;
}

void AddSizes(const Rows& rows, std::vector<Figure>& figures)
{
  for (const char* way : { Unshadowed, Planes })
  {
    const std::vector<const Row*> sizes = rows.FindAll("sizes", way);
    const auto compare = [&](const std::function<double(double, double, double)>& function) {
      return [&rows, &sizes, function](Kind kind) {
        double least = std::numeric_limits<double>::infinity();
        double most = -least;
        double mean = 0.0;
        for (const Row* row : sizes)
        {
          const double time = GetTimePerPixels(rows, *row, kind);
          least = std::min(least, time);
          most = std::max(most, time);
          mean += time / static_cast<double>(sizes.size());
        }
        return std::isfinite(mean) ? function(least, most, mean) : NoValue;
      };
    };
    for (const Row* row : sizes)
    {
      Add(figures, row->Scene + ": extra, ms per megapixel, " + way,
        [&](Kind kind) { return GetTimePerPixels(rows, *row, kind); });
    }
    if (sizes.size() > 1)
    {
      Add(figures, std::string("sizes: largest / smallest of these, ") + way,
        compare([](double least, double most, double) { return Divide(most, least); }));
      Add(figures, std::string("sizes: largest deviation from their mean, percent, ") + way,
        compare([](double least, double most, double mean) {
          return 100.0 * Divide(std::max(most - mean, mean - least), mean);
        }));
    }
  }
}

//------------------------------------------------------------------------------
// How times grow with what `counter` counts over these scenes.
void AddGrowth(const Rows& rows, const std::string& scenes, const std::string& counter,
  std::vector<Figure>& figures)
{
  const std::vector<const Row*> found = rows.FindAll(scenes, Planes);
  if (found.size() < 2)
  {
    return;
  }
  std::vector<double> counts;
  for (const Row* row : found)
  {
    counts.push_back(row->GetCounter(counter));
  }
  const auto times = [&](const char* other, Kind kind) {
    std::vector<double> result;
    for (const Row* row : found)
    {
      result.push_back(GetExcess(rows, *row, other, kind));
    }
    return result;
  };
  Add(figures, scenes + ": exponent of extra in " + counter,
    [&](Kind kind) { return FitExponent(counts, times(PlainWay, kind)); });
  Add(figures, scenes + ": exponent of shadows in " + counter,
    [&](Kind kind) { return FitExponent(counts, times(Unshadowed, kind)); });
  Add(figures, scenes + ": shadows, ns for each of " + counter + " (straight line)",
    [&](Kind kind) { return 1e9 * Fit(counts, times(Unshadowed, kind)).Slope; });
  Add(figures, scenes + ": shadows, ms for none of " + counter + " (straight line)",
    [&](Kind kind) { return 1e3 * Fit(counts, times(Unshadowed, kind)).Start; });
}

void AddMoving(const Rows& rows, std::vector<Figure>& figures)
{
  const Row* rest = rows.Find("moving", Planes);
  const Row* moving = rows.Find("moving", std::string(Planes) + ", moving");
  if (rest && moving)
  {
    Add(figures, "moving: lamp and an actor move / only the camera moves, frame",
      [&](Kind kind) { return Divide((moving->*kind).GetMedian(), (rest->*kind).GetMedian()); });
  }
}
}

// Extra of a scene in units of that of its base: the ball and floor, or a neighbour.
double GetCost(const Rows& rows, const Row& row, const std::string& baseName, Kind kind)
{
  const Row* plain = rows.Find(row.Scene, baseName + PlainWay);
  const Row* base = rows.Find(row.Scene, baseName + row.Way);
  return plain && base ? Divide(GetExcess(rows, row, PlainWay, kind),
                           (base->*kind).GetMedian() - (plain->*kind).GetMedian())
                       : NoValue;
}

void AddQuadrature(const Rows& rows, std::vector<Figure>& figures)
{
  for (const char* way : { Unshadowed, Planes })
  {
    for (const Row* row : rows.FindAll("quadrature", way))
    {
      Add(figures, row->Scene + ": extra / that of the closed form, " + way,
        [&](Kind kind) { return GetCost(rows, *row, Neighbour, kind); });
    }
  }
}

// How much longer the first frame after a change takes than the second one, beyond VTK's own.
void AddChanges(const Rows& rows, std::vector<Figure>& figures)
{
  for (const Row* row : rows.FindAll("changes", "automatic"))
  {
    const auto stall = [&rows, row](const std::string& way, Kind kind) {
      const Row* first = rows.Find(row->Scene, way + FirstFrame);
      const Row* second = rows.Find(row->Scene, way + SecondFrame);
      return first && second ? (first->*kind).GetMedian() - (second->*kind).GetMedian() : NoValue;
    };
    Add(figures, row->Scene + ": first frame beyond the second, automatic beyond plain, s",
      [&](Kind kind) { return stall(row->Way, kind) - stall(PlainWay, kind); });
  }
}

//------------------------------------------------------------------------------
bool IsContent(const Row& row)
{
  return row.Scene.compare(0, 7, "content") == 0 && row.Way.compare(0, 4, "ball") != 0 &&
    row.Way != PlainWay && row.Scene.find("/nothing") == std::string::npos;
}

// The worst first, then the median.
void AddContent(const Rows& rows, const std::string& way, std::vector<Figure>& figures)
{
  std::vector<Figure> costs;
  for (const Row& row : rows.GetAll())
  {
    if (IsContent(row) && row.Way == way)
    {
      Add(costs, row.Scene + ": extra / that of the ball and floor, " + way,
        [&](Kind kind) { return GetCost(rows, row, BallAndFloor, kind); });
    }
  }
  const auto known = [](double value) { return value > 0.0 ? value : 0.0; };
  std::sort(costs.begin(), costs.end(), [known](const Figure& a, const Figure& b) {
    return known(a.Processors) > known(b.Processors);
  });
  Times clock;
  Times processors;
  for (const Figure& figure : costs)
  {
    clock.Seconds.push_back(known(figure.Clock));
    processors.Seconds.push_back(known(figure.Processors));
  }
  figures.insert(figures.end(), costs.begin(), costs.end());
  if (costs.size() > 1)
  {
    figures.push_back(
      { "content: median of these, " + way, clock.GetMedian(), processors.GetMedian() });
  }
}

//------------------------------------------------------------------------------
std::vector<Figure> DeriveFigures(const Rows& rows)
{
  std::vector<Figure> figures;
  AddMarch(rows, figures);
  AddLights(rows, figures);
  AddSizes(rows, figures);
  AddGrowth(rows, "mesh", "triangles", figures);
  AddGrowth(rows, "mesh", "edges", figures);
  AddGrowth(rows, "triangles", "triangles", figures);
  AddGrowth(rows, "edges", "edges", figures);
  AddMoving(rows, figures);
  AddChanges(rows, figures);
  AddQuadrature(rows, figures);
  AddContent(rows, Unshadowed, figures);
  AddContent(rows, "automatic", figures);
  return figures;
}
}
