// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Loops over many elements with vtkSMPTools whose results do not depend on the number of threads:
 * the elements come in chunks of fixed size, and what the chunks find is put together in their
 * order.
 */

#ifndef AirlightParallel_h
#define AirlightParallel_h

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace airlight
{
// Elements that a thread takes at a time: fewer are not worth waking another one.
constexpr size_t ChunkSize = 1 << 15;

inline size_t CountChunks(size_t count) { return (count + ChunkSize - 1) / ChunkSize; }

// Calls function(i) for 0 <= i < count, in any order.
template <typename Function>
void ForEachTask(size_t count, const Function& function)
{
  const auto run = [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      function(static_cast<size_t>(i));
    }
  };
  if (count < 2)
  {
    run(0, static_cast<vtkIdType>(count));
    return;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1, run);
}

// Calls function(chunk, begin, end) for the chunks of 0 <= i < count, in any order.
template <typename Function>
void ForEachChunk(size_t count, const Function& function)
{
  ForEachTask(CountChunks(count), [&](size_t chunk) {
    function(chunk, chunk * ChunkSize, std::min((chunk + 1) * ChunkSize, count));
  });
}

// The vectors one after the other.
template <typename Item>
std::vector<Item> Concatenate(std::vector<std::vector<Item>> parts)
{
  if (parts.size() == 1)
  {
    return std::move(parts[0]);
  }
  std::vector<size_t> first(parts.size() + 1);
  for (size_t i = 0; i < parts.size(); ++i)
  {
    first[i + 1] = first[i] + parts[i].size();
  }
  std::vector<Item> whole(first.back());
  ForEachTask(parts.size(), [&](size_t i) {
    std::copy(
      parts[i].begin(), parts[i].end(), whole.begin() + static_cast<std::ptrdiff_t>(first[i]));
  });
  return whole;
}

// Items sorted coarsely.
template <typename Item>
struct Buckets
{
  std::unique_ptr<Item[]> Items;
  std::vector<size_t> First; // bucket b is Items[First[b]] to before Items[First[b + 1]]

  const Item* Begin(size_t bucket) const { return this->Items.get() + this->First[bucket]; }
  const Item* End(size_t bucket) const { return this->Items.get() + this->First[bucket + 1]; }
};

// Calls visit(i, put) twice for 0 <= i < count; it calls put(bucket, item) for the items that
// belong to element i. Within a bucket items are in the order of their elements.
template <typename Item, typename Visit>
Buckets<Item> FillBuckets(size_t count, size_t bucketCount, const Visit& visit)
{
  const size_t chunks = CountChunks(count);
  std::vector<size_t> next(chunks * bucketCount);
  ForEachChunk(count, [&](size_t chunk, size_t begin, size_t end) {
    size_t* counts = &next[chunk * bucketCount];
    for (size_t i = begin; i < end; ++i)
    {
      visit(i, [counts](size_t bucket, const Item&) { ++counts[bucket]; });
    }
  });
  Buckets<Item> result;
  result.First.resize(bucketCount + 1);
  size_t total = 0;
  for (size_t bucket = 0; bucket < bucketCount; ++bucket)
  {
    result.First[bucket] = total;
    for (size_t chunk = 0; chunk < chunks; ++chunk)
    {
      size_t& slot = next[chunk * bucketCount + bucket];
      const size_t size = slot;
      slot = total;
      total += size;
    }
  }
  result.First[bucketCount] = total;
  result.Items.reset(new Item[total]); // not initialised, unlike with std::make_unique
  ForEachChunk(count, [&](size_t chunk, size_t begin, size_t end) {
    size_t* slots = &next[chunk * bucketCount];
    Item* items = result.Items.get();
    for (size_t i = begin; i < end; ++i)
    {
      visit(i, [slots, items](size_t bucket, const Item& item) { items[slots[bucket]++] = item; });
    }
  });
  return result;
}
}

#endif
