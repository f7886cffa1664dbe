// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What casts shadows on the other ranks of a parallel ParaView. Each rank draws its own surfaces in
 * the medium, and IceT takes the nearest of all ranks for each pixel: that is the serial picture if
 * each rank knows all that casts shadows. Here the polygons that cast come from all ranks to all
 * ranks, and stand in the renderer as actors that draw nothing.
 */

#ifndef AirlightRemoteCasters_h
#define AirlightRemoteCasters_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkActor;
class vtkMultiProcessController;
class vtkPolyData;
class vtkRenderer;

namespace airlight
{
class RemoteCasters
{
public:
  RemoteCasters();
  ~RemoteCasters();

  // Brings the casters of the other ranks into the renderer. All ranks must call it together. Ranks
  // on which nothing changed send nothing.
  void Update(vtkRenderer* renderer, vtkMultiProcessController* controller);

  // Makes the renderer's box so large that IceT takes all of this rank's picture, not only the box
  // around its surfaces; on while a frame is drawn.
  void Spread(vtkRenderer* renderer, bool on);

  // Takes them away.
  void Clear(vtkRenderer* renderer);

  // What the last Update() with changes received, of this rank, too; and how many polygons of all
  // ranks there are.
  vtkTypeInt64 GetBytes() const { return this->Bytes; }
  vtkTypeInt64 GetPolygons() const;

private:
  bool HasChanged(vtkRenderer* renderer);
  void Replace(vtkRenderer* renderer, int rank, vtkPolyData* data);

  std::vector<vtkTypeUInt64> Known;                // props, meshes and their times
  std::vector<vtkSmartPointer<vtkActor>> StandIns; // by rank
  std::vector<vtkTypeInt64> Polygons;              // by rank
  vtkSmartPointer<vtkActor> Everywhere;
  vtkTypeInt64 Bytes = 0;
  bool Sent = false;
};
}

#endif
