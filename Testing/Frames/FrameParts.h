// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The contents of a random scene: one prop of VTK's each, in a cube of about 2 units.
 */

#ifndef FrameParts_h
#define FrameParts_h

#include "FrameGroup.h"

#include "AirlightTestSoup.h"
#include "AirlightTestTools.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkCamera;
class vtkMapper;
class vtkPlane;

namespace airlight_test
{
struct FrameItem
{
  int Kind = FRAME_NOTHING;
  vtkSmartPointer<vtkProp> Prop;                 // as the renderer has it
  std::vector<vtkSmartPointer<vtkActor>> Actors; // of which it is made
  vtkSmartPointer<vtkPolyData> Mesh;             // what the actors show, if it is one mesh
  vtkSmartPointer<vtkPoints> Points;             // other points for it, older than its cells
  vtkSmartPointer<vtkPolyData> Cells;            // other cells for it, older than it
  vtkSmartPointer<vtkPlane> Clip;
};

FrameItem MakeFrameItem(int kind, Random& random, vtkCamera* camera);

// Of the kinds below FRAME_MESH_KINDS.
vtkSmartPointer<vtkPolyData> MakeFrameMesh(int kind, Random& random);

// Those that are more than a mesh with properties: the item is an actor with a mesh.
void MakeFrameProp(FrameItem& item, Random& random, vtkCamera* camera);

// Of these, those that need neither. Other items stay as they are.
void MakeFrameScenery(FrameItem& item, Random& random, vtkCamera* camera);
}

#endif
