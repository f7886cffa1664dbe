// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightCasterBlocks.h"

#include "Scene/AirlightVTKVersions.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace airlight
{
namespace
{
// The visible polygonal blocks below a node of a composite data set. A hidden node hides what is
// below it, unless that is made visible of its own; so with opacity.
void AddBlocks(vtkDataObject* node, vtkCompositeDataDisplayAttributes* attributes, bool visible,
  double opacity, std::vector<CasterBlock>& blocks)
{
  if (attributes && attributes->HasBlockVisibility(node))
  {
    visible = attributes->GetBlockVisibility(node);
  }
  if (attributes && attributes->HasBlockOpacity(node))
  {
    opacity = std::clamp(attributes->GetBlockOpacity(node), 0.0, 1.0);
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(node))
  {
    auto it = vtk::TakeSmartPointer(tree->NewTreeIterator());
    it->VisitOnlyLeavesOff();
    it->TraverseSubTreeOff();
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      AddBlocks(it->GetCurrentDataObject(), attributes, visible, opacity, blocks);
    }
  }
  else if (auto* data = vtkPolyData::SafeDownCast(node))
  {
    if (visible)
    {
      blocks.push_back({ data, opacity });
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<CasterBlock> GetBlocks(vtkCompositeDataSet* composite, vtkMapper* mapper)
{
  auto* drawing = BlocksMapper::SafeDownCast(mapper);
  std::vector<CasterBlock> blocks;
  AddBlocks(composite, drawing ? drawing->GetCompositeDataDisplayAttributes() : nullptr, true, -1.0,
    blocks);
  return blocks;
}
}
