// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouette/AirlightCasterEdges.h"

#include "Silhouette/AirlightCasterMesh.h"
#include "Silhouette/AirlightParallel.h"

#include <cstdint>
#include <iterator>

namespace airlight
{
namespace
{
// Vertices of a bucket at least: what is sorted at a time stays in a core's own cache.
constexpr int BucketBits = 11;
constexpr size_t MaximumBuckets = 2048;
// Up to this many keys insertion is the fastest way to sort.
constexpr std::ptrdiff_t FewKeys = 24;

struct HalfEdge
{
  int Low;
  int High;
  CasterMesh::EdgeUse Use;
};

// The higher end and the use, to be compared as one number.
using Key = std::uint64_t;

Key MakeKey(const HalfEdge& edge)
{
  return static_cast<Key>(edge.High) << 32 | static_cast<Key>(edge.Use);
}
int GetHigh(Key key) { return static_cast<int>(key >> 32); }
CasterMesh::EdgeUse GetUse(Key key) { return static_cast<CasterMesh::EdgeUse>(key & 0xffffffffu); }

void Sort(Key* begin, Key* end)
{
  if (end - begin > FewKeys)
  {
    std::sort(begin, end);
    return;
  }
  for (Key* next = begin + 1; next < end; ++next)
  {
    const Key key = *next;
    Key* slot = next;
    for (; slot > begin && slot[-1] > key; --slot)
    {
      *slot = slot[-1];
    }
    *slot = key;
  }
}

// What a bucket adds to the mesh.
struct Part
{
  std::vector<CasterMesh::EdgeEnds> PairEnds;
  std::vector<std::array<CasterMesh::EdgeUse, 2>> PairUses;
  std::vector<CasterMesh::EdgeEnds> OtherEnds;
  std::vector<int> OtherSizes;
  std::vector<CasterMesh::EdgeUse> OtherUses;

  // The sorted keys of all edges with this lower end.
  void Add(int low, const Key* begin, const Key* end)
  {
    while (begin != end)
    {
      const int high = GetHigh(*begin);
      const Key* next = begin + 1;
      while (next != end && GetHigh(*next) == high)
      {
        ++next;
      }
      if (next - begin == 2)
      {
        this->PairEnds.push_back({ low, high });
        this->PairUses.push_back({ GetUse(begin[0]), GetUse(begin[1]) });
      }
      else
      {
        this->OtherEnds.push_back({ low, high });
        this->OtherSizes.push_back(static_cast<int>(next - begin));
        std::transform(begin, next, std::back_inserter(this->OtherUses), GetUse);
      }
      begin = next;
    }
  }
};

// The half edges of a bucket, whose lower ends are `vertexCount` from `firstVertex`.
Part SortBucket(const HalfEdge* begin, const HalfEdge* end, int firstVertex, int vertexCount)
{
  std::vector<size_t> ends(vertexCount + 1); // of each vertex's keys, once they are filled in
  for (const HalfEdge* edge = begin; edge != end; ++edge)
  {
    ++ends[edge->Low - firstVertex + 1];
  }
  for (int i = 0; i < vertexCount; ++i)
  {
    ends[i + 1] += ends[i];
  }
  const std::unique_ptr<Key[]> keys(new Key[end - begin]);
  for (const HalfEdge* edge = begin; edge != end; ++edge)
  {
    keys[ends[edge->Low - firstVertex]++] = MakeKey(*edge);
  }
  Part part;
  part.PairEnds.reserve((end - begin) / 2);
  part.PairUses.reserve((end - begin) / 2);
  size_t first = 0;
  for (int i = 0; i < vertexCount; ++i)
  {
    if (ends[i] == first)
    {
      continue; // no edge begins here
    }
    Sort(keys.get() + first, keys.get() + ends[i]);
    part.Add(firstVertex + i, keys.get() + first, keys.get() + ends[i]);
    first = ends[i];
  }
  return part;
}

// A list of all parts as one.
template <typename Item>
std::vector<Item> Join(std::vector<Part>& parts, std::vector<Item> Part::*list)
{
  std::vector<std::vector<Item>> lists(parts.size());
  for (size_t i = 0; i < parts.size(); ++i)
  {
    lists[i].swap(parts[i].*list);
  }
  return Concatenate(std::move(lists));
}
}

//------------------------------------------------------------------------------
void BuildEdges(CasterMesh& mesh)
{
  int bits = BucketBits;
  while (mesh.Points.size() >> bits >= MaximumBuckets)
  {
    ++bits;
  }
  const size_t bucketCount = (mesh.Points.size() >> bits) + 1;
  const Buckets<HalfEdge> buckets =
    FillBuckets<HalfEdge>(mesh.Triangles.size(), bucketCount, [&](size_t f, const auto& put) {
      const std::array<int, 3>& t = mesh.Triangles[f];
      for (int k = 0; k < 3; ++k)
      {
        const int a = t[k];
        const int b = t[k == 2 ? 0 : k + 1];
        const int low = std::min(a, b);
        const auto use = static_cast<CasterMesh::EdgeUse>(2 * f + (a < b ? 1 : 0));
        put(static_cast<size_t>(low) >> bits, { low, std::max(a, b), use });
      }
    });
  std::vector<Part> parts(bucketCount);
  ForEachTask(bucketCount, [&](size_t i) {
    const auto first = static_cast<int>(i << bits);
    const auto last = static_cast<int>(std::min((i + 1) << bits, mesh.Points.size()));
    parts[i] = SortBucket(buckets.Begin(i), buckets.End(i), first, last - first);
  });
  mesh.PairEnds = Join(parts, &Part::PairEnds);
  mesh.PairUses = Join(parts, &Part::PairUses);
  mesh.OtherEnds = Join(parts, &Part::OtherEnds);
  mesh.OtherUses = Join(parts, &Part::OtherUses);
  mesh.FirstUse = { 0 };
  for (const int size : Join(parts, &Part::OtherSizes))
  {
    mesh.FirstUse.push_back(mesh.FirstUse.back() + size);
  }
}
}
