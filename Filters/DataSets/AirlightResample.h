// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Densities of data sets of any kind on the points of an image. Behind vtkAirlightDensityImage.
 */

#ifndef AirlightResample_h
#define AirlightResample_h

#include "DataSets/AirlightDensityBlocks.h"

#include <vector>

class vtkImageData;

namespace airlight
{
// Whether the block is an image whose points can be those of the result: none is hidden.
bool IsWholeImage(const DensityBlock& block);

// The image's own points. An array of one component and factor 1 is shared, not copied. Its other
// point arrays pass; `cells`: those of cells, too, averaged at the points.
void CopyImage(const DensityBlock& block, double factor, bool cells, vtkImageData* output);

// So many points, from end to end of the blocks' bounds; 0 outside their cells. Later blocks cover
// earlier ones. `all`: the other arrays are sampled, too. Throws std::runtime_error that continues
// "The input ..." where the bounds are flat or an array is not of one kind in all blocks.
void ResampleBlocks(const std::vector<DensityBlock>& blocks, double factor, bool all,
  const int dimensions[3], vtkImageData* output);
}

#endif
