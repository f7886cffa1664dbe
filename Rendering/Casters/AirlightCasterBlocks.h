// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The polygonal blocks that a mapper shows of a composite data set.
 */

#ifndef AirlightCasterBlocks_h
#define AirlightCasterBlocks_h

#include <vector>

class vtkCompositeDataSet;
class vtkMapper;
class vtkPolyData;

namespace airlight
{
struct CasterBlock
{
  vtkPolyData* Data;
  double Opacity; // below 0: the actor's
};

// The visible ones.
std::vector<CasterBlock> GetBlocks(vtkCompositeDataSet* composite, vtkMapper* mapper);
}

#endif
