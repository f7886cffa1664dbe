// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameChecks.h"

#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace airlight_test
{
namespace
{
// Of single precision, after some operations.
constexpr double Rounding = 1e-5;

// Two roundings to half precision, in which VTK blends translucent surfaces without depth peeling:
// of normal numbers, relative, and of the least ones.
constexpr double HalfPrecision = 1.0 / 1024.0;
constexpr double LeastHalf = 1.0 / 8388608.0;

struct Values
{
  const float* First = nullptr;
  size_t Count = 0;
  int Components = 1;

  double At(size_t pixel, int component) const
  {
    return this->First[pixel * static_cast<size_t>(this->Components) +
      static_cast<size_t>(std::min(component, this->Components - 1))];
  }
  size_t Pixels() const { return this->Count / static_cast<size_t>(this->Components); }
};

Values GetValues(const FrameRecord& frame, const std::string& name)
{
  Values values;
  const auto found = frame.Buffers.find(name);
  if (found != frame.Buffers.end())
  {
    values.First = static_cast<const float*>(found->second->GetScalarPointer());
    values.Components = found->second->GetNumberOfScalarComponents();
    values.Count = static_cast<size_t>(found->second->GetNumberOfPoints()) *
      static_cast<size_t>(values.Components);
  }
  return values;
}

void CheckRange(
  const FrameRecord& frame, const std::string& name, double low, double high, Problems& problems)
{
  const Values values = GetValues(frame, name);
  size_t undefined = 0;
  size_t outside = 0;
  double worst = 0.0;
  for (size_t i = 0; i < values.Count; ++i)
  {
    const double value = values.First[i];
    undefined += std::isfinite(value) ? 0 : 1;
    if (std::isfinite(value) && (value < low || value > high))
    {
      ++outside;
      worst = value;
    }
  }
  if (undefined > 0)
  {
    problems.push_back(Text(name, ": ", undefined, " values are not finite"));
  }
  if (outside > 0)
  {
    problems.push_back(Text(name, ": ", outside, " values out of range, as ", worst));
  }
}

// Counts values for which `wrong` is true and says how many there are.
template <typename Wrong>
void CheckPixels(
  const Values& values, const std::string& what, Problems& problems, const Wrong& wrong)
{
  size_t count = 0;
  std::string example;
  for (size_t pixel = 0; pixel < values.Pixels(); ++pixel)
  {
    for (int c = 0; c < values.Components; ++c)
    {
      const std::string text = wrong(pixel, c);
      if (!text.empty())
      {
        ++count;
        example = Text("pixel ", pixel, " channel ", c, ": ", text);
      }
    }
  }
  if (count > 0)
  {
    problems.push_back(Text(what, ": ", count, " of ", values.Count, ", as ", example));
  }
}

void CheckSums(const FrameScene& scene, const FrameRecord& frame, Problems& problems)
{
  const Values radiance = GetValues(frame, "Radiance");
  const Values airlight = GetValues(frame, "Airlight");
  const Values surface = GetValues(frame, "Surface");
  const Values depth = GetValues(frame, "Depth");
  // Translucent surfaces hide what is behind them.
  const double share = scene.MayBlend() ? 0.0 : 1.0 - Rounding;
  CheckPixels(radiance, "Radiance is less than its parts", problems, [&](size_t i, int c) {
    const double parts = airlight.At(i, c) + surface.At(i, c);
    return radiance.At(i, c) < parts * share - 1e-30 ? Text(radiance.At(i, c), " and ", parts)
                                                     : std::string();
  });
  CheckPixels(depth, "Depth is neither -1 nor above 0", problems, [&](size_t i, int) {
    return depth.At(i, 0) == -1.0 || depth.At(i, 0) > 0.0 ? std::string() : Text(depth.At(i, 0));
  });
  CheckPixels(surface, "Surface without a surface", problems, [&](size_t i, int c) {
    return depth.At(i, 0) < 0.0 && surface.At(i, c) != 0.0 ? Text(surface.At(i, c)) : std::string();
  });
  std::vector<Values> lights;
  for (size_t i = 0; i < scene.Lights.size(); ++i)
  {
    const Values light = GetValues(frame, "Airlight:" + std::to_string(i));
    if (light.First)
    {
      lights.push_back(light);
    }
  }
  const auto on = std::count_if(scene.Lights.begin(), scene.Lights.end(),
    [](vtkLight* light) { return light->GetSwitch() != 0; });
  if (static_cast<long>(lights.size()) != on)
  {
    problems.push_back(Text("there are buffers of ", lights.size(), " lights of ", on));
  }
  CheckPixels(
    airlight, "Airlight is less than the lights' together", problems, [&](size_t i, int c) {
      double sum = 0.0;
      for (const Values& light : lights)
      {
        sum += light.At(i, c);
      }
      return airlight.At(i, c) < sum * (1.0 - Rounding) - 1e-30
        ? Text(airlight.At(i, c), " and ", sum)
        : std::string();
    });
}

// As far as the buffers say what the picture shows.
void CheckPicture(const FrameScene& scene, const FrameRecord& frame, Problems& problems)
{
  const Values radiance = GetValues(frame, "Radiance");
  if (radiance.Count != frame.Picture.size())
  {
    problems.push_back(
      Text("the picture has ", frame.Picture.size(), " values, the buffer ", radiance.Count));
    return;
  }
  if (!scene.MayBlend())
  {
    CheckPixels(radiance, "the picture is not the radiance", problems, [&](size_t i, int c) {
      const double expected = 255.0 * std::min(std::max(radiance.At(i, c), 0.0), 1.0);
      const int shown = frame.Picture[3 * i + static_cast<size_t>(c)];
      return std::abs(expected - shown) > 0.51 ? Text(shown, " for ", expected) : std::string();
    });
    return;
  }
  double mean = 0.0;
  for (size_t i = 0; i < radiance.Count; ++i)
  {
    mean +=
      std::min(static_cast<double>(radiance.First[i]), 1.0) / static_cast<double>(radiance.Count);
  }
  const auto shown = std::max_element(frame.Picture.begin(), frame.Picture.end());
  if (mean > 0.05 && *shown == 0)
  {
    problems.push_back(Text("the picture is black, the mean radiance ", mean));
  }
}
}

//------------------------------------------------------------------------------
void CheckFrame(const FrameScene& scene, const FrameRecord& frame, Problems& problems)
{
  if (frame.Buffers.size() < 8)
  {
    problems.push_back(Text("there are ", frame.Buffers.size(), " buffers"));
    return;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& entry : frame.Buffers)
  {
    const std::string& name = entry.first;
    const double low = name == "Depth" ? -1.0 : 0.0;
    CheckRange(frame, name, low, name == "Transmittance" ? 1.0 + Rounding : infinity, problems);
  }
  if (problems.empty())
  {
    CheckSums(scene, frame, problems);
    CheckPicture(scene, frame, problems);
  }
}

//------------------------------------------------------------------------------
void CheckSameFrame(const std::string& what, const FrameRecord& a, const FrameRecord& b,
  const FrameRounding& rounding, Problems& problems)
{
  for (const auto& entry : a.Buffers)
  {
    const Values p = GetValues(a, entry.first);
    const Values q = GetValues(b, entry.first);
    if (p.Count != q.Count)
    {
      problems.push_back(
        Text(what, ": ", entry.first, " has ", p.Count, " and ", q.Count, " values"));
      continue;
    }
    const bool half = rounding.Blends && entry.first == "Radiance";
    const double relative = half ? HalfPrecision : rounding.Relative;
    const double absolute = half ? LeastHalf : 0.0;
    CheckPixels(p, what + ": another " + entry.first, problems, [&](size_t i, int c) {
      const double x = p.At(i, c);
      const double y = q.At(i, c);
      const bool same = (std::isnan(x) && std::isnan(y)) ||
        std::abs(x - y) <= relative * std::max(std::abs(x), std::abs(y)) + absolute;
      return same ? std::string() : Text(x, " and ", y);
    });
  }
  size_t count = 0;
  int largest = 0;
  for (size_t i = 0; i < std::min(a.Picture.size(), b.Picture.size()); ++i)
  {
    const int difference =
      std::abs(static_cast<int>(a.Picture[i]) - static_cast<int>(b.Picture[i]));
    count += difference > rounding.Levels ? 1 : 0;
    largest = std::max(largest, difference);
  }
  if (a.Picture.size() != b.Picture.size() || count > 0)
  {
    problems.push_back(Text(
      what, ": another picture: ", count, " of ", a.Picture.size(), " values, by up to ", largest));
  }
}

//------------------------------------------------------------------------------
void CheckNotBrighter(
  const std::string& what, const FrameRecord& less, const FrameRecord& more, Problems& problems)
{
  const Values a = GetValues(less, "Airlight");
  const Values b = GetValues(more, "Airlight");
  const Values errorA = GetValues(less, "ErrorBound");
  const Values errorB = GetValues(more, "ErrorBound");
  if (a.Count != b.Count || errorA.Count != errorB.Count)
  {
    problems.push_back(what + ": buffers of other sizes");
    return;
  }
  CheckPixels(a, what + ": brighter", problems, [&](size_t i, int c) {
    const double limit = b.At(i, c) * (1.0 + Rounding) + errorA.At(i, c) + errorB.At(i, c) + 1e-30;
    return a.At(i, c) > limit ? Text(a.At(i, c), " and ", b.At(i, c), ", bounds ", errorA.At(i, c),
                                  " and ", errorB.At(i, c))
                              : std::string();
  });
  const Values p = GetValues(less, "LitLength");
  const Values q = GetValues(more, "LitLength");
  CheckPixels(p, what + ": longer lit", problems, [&](size_t i, int c) {
    return p.At(i, c) > q.At(i, c) * (1.0 + 1e-3) + 1e-30 ? Text(p.At(i, c), " and ", q.At(i, c))
                                                          : std::string();
  });
}
}
