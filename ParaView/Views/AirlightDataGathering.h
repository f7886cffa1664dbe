// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Has ParaView send a view's data to the first of several ranks, which then draws all: where
 * something is translucent or a volume, depths do not tell which rank's picture is in front.
 */

#ifndef AirlightDataGathering_h
#define AirlightDataGathering_h

class vtkPVRenderView;

namespace airlight
{
class DataGathering
{
public:
  // Whether this process draws one of several parts of the picture.
  static bool IsOneOfSeveral();

  // Whether it is a server that only draws.
  static bool OnlyDraws();

  // Whether ParaView can merge this process's visible data with others. It has no way to do so
  // for rectilinear grids, nor for images in parts, and loses the directions of images.
  static bool CanMerge(vtkPVRenderView* view);

  // After the view's update, on all processes. Only the first rank draws then.
  static void Begin(vtkPVRenderView* view, bool toRenderServer);
};
}

#endif
