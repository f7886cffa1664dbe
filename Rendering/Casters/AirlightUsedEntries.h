// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Maps that keep what one walk over the casters asked for, until the next: their entries have a
 * member Used.
 */

#ifndef AirlightUsedEntries_h
#define AirlightUsedEntries_h

#include <iterator>

namespace airlight
{
template <typename Map>
void MarkUnused(Map& map)
{
  for (auto& entry : map)
  {
    entry.second.Used = false;
  }
}

template <typename Map>
void EraseUnused(Map& map)
{
  for (auto entry = map.begin(); entry != map.end();)
  {
    entry = entry->second.Used ? std::next(entry) : map.erase(entry);
  }
}
}

#endif
