// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The mathematics of the folder glsl as C++, through GLM: namespace airlight::f64 in double
 * precision for the CPU classes, airlight::f32 in the shaders' single precision for the tests. The
 * text of the functions is the shaders' own.
 */

#ifndef AirlightMath_h
#define AirlightMath_h

#include "Density/AirlightDensityGrid.h"
#include "Density/AirlightImageColours.h"

#include <glm/glm.hpp>

// More poles than any fit uses.
#define AIRLIGHT_MAX_POLES 8
// More media than any scene needs at once.
#define AIRLIGHT_MAX_MEDIA 8

#define AIRLIGHT_FN inline
#define AIRLIGHT_OUT(T) T&
#define AIRLIGHT_INOUT(T) T&
#define AIRLIGHT_IN(T) const T&
#define AIRLIGHT_PRECISE
#define AIRLIGHT_MEDIA_UNIFORM
#define AIRLIGHT_MEDIA_IN const AirlightMedia &airlightMedia,
#define AIRLIGHT_MEDIA_OUT airlightMedia,
// Multiple scattering is a member of the media.
#define AIRLIGHT_MULTIPLE_MEMBER AirlightMultiple multiple;
#define AIRLIGHT_MULTIPLE_UNIFORM
#define AIRLIGHT_MULTIPLE_IN const AirlightMultiple &airlightMultiple,
#define AIRLIGHT_MULTIPLE_OUT airlightMultiple,
#define AIRLIGHT_MULTIPLE_NODES 12
#define AIRLIGHT_MULTIPLE_LIGHTS airlightMultiple.count
#define AIRLIGHT_MULTIPLE_SUNS airlightMultiple.suns
#define AIRLIGHT_MULTIPLE_COLLISIONS true
#define AIRLIGHT_ROLLED(count) (count)
// Surfaces and tables lie in memory.
#define AIRLIGHT_DATA_MEMBER const real4* data;
#define AIRLIGHT_FETCH(owner, i) ((owner).data[(i)])
#define AIRLIGHT_HAS_SURFACE 1
#define AIRLIGHT_IS_SURFACE(i) (airlightMedia.item[(i)].region.kind == AIRLIGHT_REGION_SURFACE)
#define AIRLIGHT_MAY_TRY true
#define AIRLIGHT_FEW_ROUNDS true
#define AIRLIGHT_COUNT_ROUND
#define AIRLIGHT_HAS_TABLE 1
#define AIRLIGHT_HAS_PHOTOMETRY 1
#define AIRLIGHT_HAS_SKY
#define AIRLIGHT_SKY_MEMBER AirlightSky sky;
// So do images of density, in world coordinates.
#define AIRLIGHT_HAS_GRID 1
#define AIRLIGHT_GRID_MEMBER                                                \
  const DensityGrid* grid;                                                  \
  glm::dvec3 gridOrigin;      /* the origin of coordinates in the world */  \
  int gridFirst;              /* texel of the samples on a graphics card */ \
  const ImageColours* albedo; /* null without */                            \
  const ImageColours* glow;                                                 \
  int albedoFirst;                                                          \
  int glowFirst;
#define AIRLIGHT_LIGHT_GRID_MEMBERS   \
  int gridFirst[AIRLIGHT_MAX_MEDIA];  \
  real3 gridSize[AIRLIGHT_MAX_MEDIA]; \
  real4x4 gridCells[AIRLIGHT_MAX_MEDIA];
#define AIRLIGHT_GRID_DENSITY(medium, point) \
  real((medium).grid->GetDensity((medium).gridOrigin + glm::dvec3(point)))
#define AIRLIGHT_GRID_COLOUR(medium, colours, point)                                               \
  ((colours)                                                                                       \
      ? real3((colours)->GetAt((medium).grid->ToSamples((medium).gridOrigin + glm::dvec3(point)))) \
      : real3(real(1.0)))
#define AIRLIGHT_HAS_COLOURS(medium) ((medium).albedo || (medium).glow)
#define AIRLIGHT_GRID_DEPTH(medium, origin, direction, from, to) \
  real((medium).grid->Integrate(                                 \
    (medium).gridOrigin + glm::dvec3(origin), glm::dvec3(direction), from, to))

namespace airlight
{
namespace f64
{
using real = double;
using real2 = glm::dvec2;
using real3 = glm::dvec3;
using real4 = glm::dvec4;
using real4x4 = glm::dmat4;
using bool3 = glm::bvec3;
using namespace glm;
#define AIRLIGHT_DOUBLE
#include "Integration/AirlightFunctions.inl"
#undef AIRLIGHT_DOUBLE
}

namespace f32
{
using real = float;
using real2 = glm::vec2;
using real3 = glm::vec3;
using real4 = glm::vec4;
using real4x4 = glm::mat4;
using bool3 = glm::bvec3;
using namespace glm;
#include "Integration/AirlightFunctions.inl"
}
}

#undef AIRLIGHT_FN
#undef AIRLIGHT_OUT
#undef AIRLIGHT_INOUT
#undef AIRLIGHT_IN
#undef AIRLIGHT_PRECISE
#undef AIRLIGHT_MULTIPLE_MEMBER
#undef AIRLIGHT_MEDIA_UNIFORM
#undef AIRLIGHT_MEDIA_IN
#undef AIRLIGHT_MEDIA_OUT
#undef AIRLIGHT_MULTIPLE_UNIFORM
#undef AIRLIGHT_MULTIPLE_IN
#undef AIRLIGHT_MULTIPLE_OUT
#undef AIRLIGHT_DATA_MEMBER
#undef AIRLIGHT_FETCH
#undef AIRLIGHT_HAS_SKY
#undef AIRLIGHT_SKY_MEMBER
#undef AIRLIGHT_GRID_MEMBER
#undef AIRLIGHT_LIGHT_GRID_MEMBERS
#undef AIRLIGHT_GRID_DENSITY
#undef AIRLIGHT_GRID_COLOUR
#undef AIRLIGHT_HAS_COLOURS
#undef AIRLIGHT_GRID_DEPTH

#endif
