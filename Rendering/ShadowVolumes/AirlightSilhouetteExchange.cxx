// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightSilhouetteExchange.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace airlight
{
namespace
{
// Also tells machines apart that write numbers in another way.
constexpr std::uint64_t Magic = 0x31304c484c544941;

struct Header
{
  std::uint64_t Magic;
  std::uint64_t Lights;
};

// Before a light's edges and caps.
struct LightHeader
{
  glm::dvec4 Light;
  glm::dvec3 Anchor;
  std::int64_t StartCount;
  std::uint64_t Edges;
  std::uint64_t Caps;
};

template <typename T>
void Append(std::vector<unsigned char>& bytes, const T* values, size_t count)
{
  const auto* first = reinterpret_cast<const unsigned char*>(values);
  bytes.insert(bytes.end(), first, first + count * sizeof(T));
}

// Takes bytes from the front; false where there are too few.
struct Reader
{
  const unsigned char* Bytes;
  size_t Left;

  template <typename T>
  bool Take(T* values, std::uint64_t count)
  {
    if (count > this->Left / sizeof(T))
    {
      return false;
    }
    if (count > 0)
    {
      std::memcpy(values, this->Bytes, count * sizeof(T));
    }
    this->Bytes += count * sizeof(T);
    this->Left -= count * sizeof(T);
    return true;
  }

  template <typename T>
  bool Take(std::vector<T>& values, std::uint64_t count)
  {
    if (count > this->Left / sizeof(T))
    {
      return false;
    }
    values.resize(count);
    return this->Take(values.data(), count);
  }
};

template <typename V>
bool IsFinite(const V& v)
{
  for (int i = 0; i < V::length(); ++i)
  {
    if (!std::isfinite(v[i]))
    {
      return false;
    }
  }
  return true;
}

// Weights index slots of the graphics card's memory: those that no mesh has are refused.
bool IsSound(const LightSilhouettes& shadow)
{
  return IsFinite(shadow.Light) && IsFinite(shadow.Anchor) &&
    std::all_of(shadow.Edges.begin(), shadow.Edges.end(),
      [](const ShadowEdge& edge) {
        return IsFinite(edge.A) && IsFinite(edge.B) && IsFinite(edge.Normal) &&
          std::abs(edge.A.w) <= 2.0f;
      }) &&
    std::all_of(shadow.Caps.begin(), shadow.Caps.end(), [](const ShadowCap& cap) {
      return IsFinite(cap.A) && IsFinite(cap.B) && IsFinite(cap.C) && std::abs(cap.A.w) <= 1.0f;
    });
}
}

//------------------------------------------------------------------------------
LightSilhouettes DescribeSilhouettes(const ShadowVolumes& volumes, const glm::dvec4& light)
{
  LightSilhouettes shadow;
  shadow.Light = light;
  shadow.Anchor = volumes.GetAnchor();
  shadow.StartCount = volumes.GetStartCount();
  shadow.Edges = volumes.GetEdges();
  // Who takes them finds out by itself which of their planes the eye lies on.
  for (const NearEdge& near : volumes.GetNearEdges())
  {
    shadow.Edges.push_back(near.Edge);
    shadow.Edges.back().B.w = 0.0f;
  }
  shadow.Caps = volumes.GetCaps();
  return shadow;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> WriteSilhouettes(const std::vector<LightSilhouettes>& shadows)
{
  std::vector<unsigned char> bytes;
  const Header header{ Magic, shadows.size() };
  Append(bytes, &header, 1);
  for (const LightSilhouettes& shadow : shadows)
  {
    const LightHeader light{ shadow.Light, shadow.Anchor, shadow.StartCount, shadow.Edges.size(),
      shadow.Caps.size() };
    Append(bytes, &light, 1);
    Append(bytes, shadow.Edges.data(), shadow.Edges.size());
    Append(bytes, shadow.Caps.data(), shadow.Caps.size());
  }
  return bytes;
}

//------------------------------------------------------------------------------
bool ReadSilhouettes(
  const unsigned char* bytes, size_t size, ProcessSilhouettes& shadows, std::string& error)
{
  Reader reader{ bytes, size };
  Header header{};
  if (!reader.Take(&header, 1) || header.Magic != Magic)
  {
    error = "they do not begin as those of vtkAirlightPass::GetSilhouettes() do";
    return false;
  }
  ProcessSilhouettes found;
  for (std::uint64_t k = 0; k < header.Lights; ++k)
  {
    auto shadow = std::make_shared<LightSilhouettes>();
    LightHeader light{};
    if (!reader.Take(&light, 1) || !reader.Take(shadow->Edges, light.Edges) ||
      !reader.Take(shadow->Caps, light.Caps))
    {
      error = "they are cut short at light " + std::to_string(k);
      return false;
    }
    shadow->Light = light.Light;
    shadow->Anchor = light.Anchor;
    shadow->StartCount = static_cast<int>(light.StartCount);
    if (!IsSound(*shadow))
    {
      error = "those of light " + std::to_string(k) + " are not numbers of silhouettes";
      return false;
    }
    found.push_back(shadow);
  }
  shadows = std::move(found);
  return true;
}
}
