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
#undef AIRLIGHT_WIDE_ANGLE
#undef AIRLIGHT_REGION_KIND
#undef AIRLIGHT_DENSITY_KIND
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
#undef AIRLIGHT_IRRADIANCE_FEW
#undef AIRLIGHT_IRRADIANCE_FEW_STEP
#undef AIRLIGHT_IRRADIANCE_SOME
#undef AIRLIGHT_IRRADIANCE_SOME_STEP
#undef AIRLIGHT_IRRADIANCE_MANY
#undef AIRLIGHT_IRRADIANCE_MANY_STEP
#undef AIRLIGHT_PI
#undef AIRLIGHT_NEGLIGIBLE_DEPTH
#undef AIRLIGHT_DARK_HEIGHTS
#undef AIRLIGHT_THIN_HEIGHTS
#undef AIRLIGHT_CHECK_ENDS
#undef AIRLIGHT_AMBIENT_DEPTH
#undef AIRLIGHT_AMBIENT_HEIGHTS
#undef AIRLIGHT_AMBIENT_FALL
#undef AIRLIGHT_AMBIENT_PANELS

#include "Integrals/AirlightExponentialIntegral.glsl"
#include "Integrals/AirlightGauss.glsl"
#include "Light/AirlightGoniometric.glsl"
#include "Medium/AirlightPhase.glsl"
#include "Light/AirlightPointLight.glsl"
#include "Medium/AirlightRegion.glsl"
#include "Medium/AirlightMedium.glsl"
#include "Medium/AirlightClosedSurface.glsl"
#include "Medium/AirlightPath.glsl"
#include "Medium/AirlightHeightFog.glsl"
#include "Medium/AirlightMedia.glsl"
#include "Integrals/AirlightAmbient.glsl"
#include "Light/AirlightLight.glsl"
#include "Integrals/AirlightKinks.glsl"
#include "Integrals/AirlightQuadrature.glsl"
#include "Integrals/AirlightGoniometricRay.glsl"
#include "Medium/AirlightPieces.glsl"
#include "Integrals/AirlightScattering.glsl"
#include "Integrals/AirlightEquiangular.glsl"
#include "Integrals/AirlightEquiangularPanel.glsl"
#include "Integrals/AirlightHalfAngle.glsl"
#include "Integrals/AirlightIrradianceRay.glsl"
#include "Integrals/AirlightScatteredIrradiance.glsl"
