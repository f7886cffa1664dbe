// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The edges of a caster mesh. The uses of edges are sorted by their lower ends, first into buckets
 * and then within each, and those of one lower end, which are few, by comparison.
 */

#ifndef AirlightCasterEdges_h
#define AirlightCasterEdges_h

namespace airlight
{
class CasterMesh;

// Fills the lists of edges from the triangles. Edges are in the order of their ends, and an edge's
// uses in the order of their numbers.
void BuildEdges(CasterMesh& mesh);
}

#endif
