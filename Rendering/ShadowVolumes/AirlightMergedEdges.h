// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A mesh that is cut into parts, one in each process, has silhouette edges along the cut in both
 * parts: their planes are the same and do nothing together, but take their time.
 */

#ifndef AirlightMergedEdges_h
#define AirlightMergedEdges_h

#include "ShadowVolumes/AirlightShadowRecords.h"

#include <vector>

namespace airlight
{
// Edges with the same two ends and layer become one of the sum of their weights, a reversed edge
// having the opposite weight, or none. The first of them stands for all; the order stays.
std::vector<ShadowEdge> MergeEdges(const std::vector<ShadowEdge>& edges);
}

#endif
