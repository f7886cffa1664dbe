// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The prepared meshes of a filter's inputs, kept from one execution to the next.
 */

#ifndef AirlightMeshCache_h
#define AirlightMeshCache_h

#include "Scene/AirlightGeometryTimes.h"
#include "Silhouette/AirlightCasterMesh.h"

#include <map>
#include <memory>

namespace airlight
{
class MeshCache
{
public:
  // The data's mesh; null where the progress stopped its making.
  std::shared_ptr<const CasterMesh> Get(vtkPolyData* data, const CasterMesh::Progress& progress)
  {
    // Blocks of composite data arrive as copies that share their arrays.
    const GeometryTimes times = GetGeometryTimes(data);
    const auto found = this->Entries.find(times);
    if (found != this->Entries.end())
    {
      found->second.Used = true;
      return found->second.Mesh;
    }
    bool stopped = false;
    auto mesh = std::make_shared<const CasterMesh>(data, [&](double value) {
      stopped = !progress(value);
      return !stopped;
    });
    if (stopped)
    {
      return nullptr;
    }
    this->Entries[times] = { mesh, true };
    return mesh;
  }

  void MarkUnused()
  {
    for (auto& entry : this->Entries)
    {
      entry.second.Used = false;
    }
  }

  // Erases what was not got since MarkUnused().
  void EraseUnused()
  {
    for (auto entry = this->Entries.begin(); entry != this->Entries.end();)
    {
      entry = entry->second.Used ? std::next(entry) : this->Entries.erase(entry);
    }
  }

private:
  struct Entry
  {
    std::shared_ptr<const CasterMesh> Mesh;
    bool Used;
  };
  std::map<GeometryTimes, Entry> Entries;
};
}

#endif
