// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How many fragments of point Gaussians a pixel will have, before any is drawn. Opaque surfaces
 * hide some of them, so that it is rather too large.
 */

#ifndef AirlightGaussianFragments_h
#define AirlightGaussianFragments_h

namespace airlight
{
class CameraUniforms;
class SceneProps;

// The area that they cover in the picture, over the picture's. Up to some thousand points of each
// actor are looked at. Those with an array of sizes count as if all had size 1.
double EstimateGaussianFragments(const SceneProps& props, const CameraUniforms& view);
}

#endif
