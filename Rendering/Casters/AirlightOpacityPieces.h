// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cuts a mesh whose opacity varies, by the alpha of a texture or of scalars, into pieces of one
 * opacity each, so that each can cast as any other mesh: holes become geometry.
 *
 * What VTK draws as opaque, and a mesh of which less than a tenth is neither opaque nor clear, is
 * cut once, at an opacity of 1/2. Others are cut midway between the opacities 0, 1/8, ... 1 and are
 * off by at most 1/16; triangles of a single opacity keep it. A mesh under a texture is divided as
 * finely as its texels, up to a number of triangles.
 */

#ifndef AirlightOpacityPieces_h
#define AirlightOpacityPieces_h

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

class vtkActor;
class vtkPolyData;

namespace airlight
{
struct OpacityPiece
{
  vtkSmartPointer<vtkPolyData> Data;
  double Opacity = 1.0;
};

// The pieces of the meshes that actors show, kept until one of the two changes.
class OpacityPieces
{
public:
  // Whether the opacity of an actor's mesh varies; if so, its pieces, without those of opacity 0.
  bool Find(vtkActor* actor, vtkPolyData* data, const std::vector<OpacityPiece>*& pieces);

  // To be called before and after a walk over all actors: forgets those that nobody asked for.
  void BeginWalk();
  void EndWalk();

  void Clear() { this->Entries.clear(); }

private:
  // When data, mapper, colours' table, texture and its image changed; how the actor is drawn.
  using Stamp = std::array<vtkMTimeType, 6>;

  struct Entry
  {
    vtkWeakPointer<vtkPolyData> Data;
    Stamp Times{};
    double ActorOpacity = 0.0;
    bool Varies = false;
    std::vector<OpacityPiece> Pieces;
    bool Used = false;
  };

  static Stamp GetStamp(vtkActor* actor, vtkPolyData* data);

  std::map<std::pair<vtkActor*, vtkPolyData*>, Entry> Entries;
};
}

#endif
