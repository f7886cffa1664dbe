// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What casts shadows on the other ranks of a parallel ParaView. Each rank draws its own surfaces in the
 * medium, and IceT takes the nearest of all ranks for each pixel: that is the serial picture if each
 * rank knows all shadows. Here the silhouettes of what casts go from all ranks to all ranks.
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

  // Brings the silhouettes of the other ranks into the pass. All ranks must call it together. They
  // are sent where those of any rank have changed.
  void Update(vtkRenderer* renderer, vtkAirlightPass* pass, vtkMultiProcessController* controller);

  // Makes the renderer's box so large that IceT takes all of this rank's picture, not only the box
  // around its surfaces; on while a frame is drawn.
  void Spread(vtkRenderer* renderer, bool on);

  // Takes them away.
  void Clear(vtkAirlightPass* pass);

  // What the last Update() that sent anything received, of all ranks, its own included.
  vtkTypeInt64 GetBytes() const { return static_cast<vtkTypeInt64>(this->Received.size()); }

private:
  std::vector<unsigned char> Own; // as sent
  std::vector<unsigned char> Received;
  vtkSmartPointer<vtkActor> Everywhere;
};
}

#endif
