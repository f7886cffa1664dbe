// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouette/AirlightMergedPoints.h"

#include "Silhouette/AirlightParallel.h"

#include "vtkPoints.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace airlight
{
namespace
{
// Points of a bucket: they fit a core's own cache.
constexpr size_t BucketSize = 8192;
constexpr size_t MaximumPointBuckets = 4096;

// With its position, so that points are compared inside the bucket.
struct BucketPoint
{
  glm::dvec3 Position;
  vtkIdType Point;
};

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::uint64_t Bits(double value)
{
  value += 0.0; // makes -0 and 0 one
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

// Equal for equal positions, and evenly spread. The factors are odd and without pattern.
std::uint64_t Hash(const glm::dvec3& p)
{
  std::uint64_t hash = Bits(p.x);
  for (const std::uint64_t bits : { Bits(p.y), Bits(p.z), std::uint64_t{ 0 } })
  {
    hash *= 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
    hash += bits;
  }
  hash *= 0xd6e8feb86659fd93u;
  return hash ^ hash >> 32;
}

std::vector<glm::dvec3> GetPositions(vtkPoints* points)
{
  std::vector<glm::dvec3> positions(points->GetNumberOfPoints());
  ForEachChunk(positions.size(), [&](size_t, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
    {
      points->GetPoint(static_cast<vtkIdType>(i), &positions[i].x);
    }
  });
  return positions;
}

// Looks the points up in a table, one after the other: the first at a position is there first.
void MergeBucket(const BucketPoint* begin, const BucketPoint* end, std::vector<vtkIdType>& first)
{
  size_t mask = 1;
  while (mask < 2 * static_cast<size_t>(end - begin))
  {
    mask *= 2;
  }
  std::vector<const BucketPoint*> table(mask, nullptr);
  --mask;
  for (const BucketPoint* p = begin; p != end; ++p)
  {
    size_t slot = Hash(p->Position) & mask;
    while (table[slot] && table[slot]->Position != p->Position)
    {
      slot = (slot + 1) & mask;
    }
    if (!table[slot])
    {
      table[slot] = p;
    }
    first[p->Point] = table[slot]->Point;
  }
}
}

//------------------------------------------------------------------------------
MergedPoints MergeByPosition(vtkPoints* points)
{
  MergedPoints merged;
  merged.Positions = GetPositions(points);
  const size_t count = merged.Positions.size();
  merged.First.resize(count, -1);
  const size_t bucketCount = std::min(count / BucketSize + 1, MaximumPointBuckets);
  const Buckets<BucketPoint> buckets =
    FillBuckets<BucketPoint>(count, bucketCount, [&](size_t i, const auto& put) {
      const glm::dvec3& p = merged.Positions[i];
      if (IsFinite(p))
      {
        put((Hash(p) >> 32) * bucketCount >> 32, { p, static_cast<vtkIdType>(i) });
      }
    });
  ForEachTask(
    bucketCount, [&](size_t i) { MergeBucket(buckets.Begin(i), buckets.End(i), merged.First); });
  return merged;
}
}
