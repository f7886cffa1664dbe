// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
// The shader texts in the order in which they need one another; AirlightMath.h includes this once
// for each precision, so the macros that depend on precision are undone first.

#undef AIRLIGHT_GAUSS_COUNT
#undef AIRLIGHT_G_NEAR
#undef AIRLIGHT_NARROW
#undef AIRLIGHT_NARROWEST
#undef AIRLIGHT_PANEL_TOLERANCE
#undef AIRLIGHT_POLE_COUNT
#undef AIRLIGHT_POLE_ORDER
#undef AIRLIGHT_WIDE_TURN
#undef AIRLIGHT_REGION_KIND
#undef AIRLIGHT_DENSITY_KIND
#undef AIRLIGHT_REGION_UNBOUNDED
#undef AIRLIGHT_REGION_BOX
#undef AIRLIGHT_REGION_SPHERE
#undef AIRLIGHT_REGION_SURFACE
#undef AIRLIGHT_FAR
#undef AIRLIGHT_DENSITY_UNIFORM
#undef AIRLIGHT_DENSITY_HEIGHT
#undef AIRLIGHT_DENSITY_GRID
#undef AIRLIGHT_MEDIUM_COUNT
#undef AIRLIGHT_POINT_CLOSED
#undef AIRLIGHT_POINT_QUADRATURE
#undef AIRLIGHT_DIRECTIONAL_CLOSED
#undef AIRLIGHT_DIRECTIONAL_HEIGHT
#undef AIRLIGHT_DIRECTIONAL_QUADRATURE
#undef AIRLIGHT_LIGHT_KIND
#undef AIRLIGHT_LAMP_DEPTH
#undef AIRLIGHT_SUN_DEPTH
#undef AIRLIGHT_GLOW_FEW
#undef AIRLIGHT_GLOW_FEW_STEP
#undef AIRLIGHT_GLOW_SOME
#undef AIRLIGHT_GLOW_SOME_STEP
#undef AIRLIGHT_GLOW_MANY
#undef AIRLIGHT_GLOW_MANY_STEP
#undef AIRLIGHT_PI
#undef AIRLIGHT_TURN_FADED
#undef AIRLIGHT_DARK_HEIGHTS
#undef AIRLIGHT_THIN_HEIGHTS

#include "AirlightExponentialIntegral.glsl"
#include "AirlightGauss.glsl"
#include "AirlightGoniometric.glsl"
#include "AirlightPhase.glsl"
#include "AirlightPointLight.glsl"
#include "AirlightRegion.glsl"
#include "AirlightMedium.glsl"
#include "AirlightClosedSurface.glsl"
#include "AirlightPath.glsl"
#include "AirlightHeightFog.glsl"
#include "AirlightMedia.glsl"
#include "AirlightLight.glsl"
#include "AirlightKinks.glsl"
#include "AirlightQuadrature.glsl"
#include "AirlightGoniometricRay.glsl"
#include "AirlightPieces.glsl"
#include "AirlightScattering.glsl"
#include "AirlightTurn.glsl"
#include "AirlightTurnPart.glsl"
#include "AirlightTurnWhole.glsl"
#include "AirlightGlowRay.glsl"
#include "AirlightGlow.glsl"
