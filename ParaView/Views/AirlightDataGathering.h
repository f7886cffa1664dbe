// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Has ParaView send a view's data to the first of several ranks, which then draws all: where
 * something is translucent or a volume, depths do not tell which rank's picture is in front.
 */

#ifndef AirlightDataGathering_h
#define AirlightDataGathering_h

#include "vtkType.h"

class vtkDataObject;
class vtkPVRenderView;

namespace airlight
{
class DataGathering
{
public:
  // What a process says; all of them must come to the same decision, as they send and receive
  // together. Reduced to its greatest number over all.
  struct Vote
  {
    vtkTypeUInt64 Needed = 0;       // it draws one of several parts, which are not enough
    vtkTypeUInt64 Refused = 0;      // ParaView cannot merge its data with those of others
    vtkTypeUInt64 RenderServer = 0; // it is a server that only draws
  };

  // `needed`: where there are several ranks.
  static Vote GetVote(vtkPVRenderView* view, bool needed);

  // ParaView has no way to merge pieces of rectilinear grids, nor of images in parts, and loses the
  // directions of images.
  static bool CanMerge(vtkDataObject* piece);

  // After the view's update, on all processes. Only the first rank draws then.
  static void Begin(vtkPVRenderView* view, bool toRenderServer);
};
}

#endif
