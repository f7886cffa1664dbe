// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Exchanges the silhouettes of casters between the ranks of a parallel ParaView. Each rank renders
 * its own surfaces in the medium, and IceT composites the nearest surface of each pixel. This
 * equals the serial picture if each rank has all shadows.
 */

#ifndef AirlightRemoteSilhouettes_h
#define AirlightRemoteSilhouettes_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkActor;
class vtkAirlightPass;
class vtkMultiProcessController;
class vtkRenderer;

namespace airlight
{
class RemoteSilhouettes
{
public:
  RemoteSilhouettes();
  ~RemoteSilhouettes();

  // Adds the silhouettes of the other ranks to the pass. All ranks must call it together. Sends
  // silhouettes only if those of a rank have changed.
  void Update(vtkRenderer* renderer, vtkAirlightPass* pass, vtkMultiProcessController* controller);

  // Enlarges the renderer's bounds so that IceT uses this rank's whole picture, not only the box
  // around its surfaces; on while a frame is rendered.
  void Spread(vtkRenderer* renderer, bool on);

  // Removes them.
  void Clear(vtkAirlightPass* pass);

  // The bytes that the last sending Update() received from all ranks, its own included.
  vtkTypeInt64 GetBytes() const { return static_cast<vtkTypeInt64>(this->Received.size()); }

private:
  std::vector<unsigned char> Own; // as sent
  std::vector<unsigned char> Received;
  vtkSmartPointer<vtkActor> Everywhere;
};
}

#endif
