// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The settings that shaders are compiled for. The 50 scenes of a group share them, so that they share
 * most of their shaders, too: compiling takes far longer than drawing.
 */

#ifndef FrameGroup_h
#define FrameGroup_h

#include "RandomSeeds.h"

#include <cstdint>
#include <string>
#include <vector>

namespace airlight_test
{
constexpr std::uint64_t FrameGroupSize = 50;
constexpr std::uint64_t FirstRecentFrameGroup = 2000; // and all after it

enum FrameLight
{
  FRAME_POINT,
  FRAME_SPOT,
  FRAME_SOFT_SPOT,  // with an exponent
  FRAME_ATTENUATED, // not by the inverse square alone
  FRAME_SUN,
  FRAME_HEADLIGHT, // directional
  FRAME_HEADLAMP,  // a positional headlight
  FRAME_CAMERA,    // a point light fixed to the camera
  FRAME_CAMERA_SUN,
  FRAME_PHOTOMETRIC, // with an IES file
  FRAME_LIGHT_KINDS
};

enum FramePart
{
  // Meshes, of which each group has one kind at least.
  FRAME_SPHERE,
  FRAME_CONE,
  FRAME_PLANE,
  FRAME_SOUP,
  FRAME_STRIPS,
  FRAME_MIXED, // vertices, lines, polygons and strips in one mesh
  FRAME_DEGENERATE,
  FRAME_GROUND,
  FRAME_MESH_KINDS,
  // Others.
  FRAME_TRANSLUCENT = FRAME_MESH_KINDS,
  FRAME_GLASS, // with a shadow of its own colours
  FRAME_CELL_OPACITY,
  FRAME_TABLE_OPACITY, // by a lookup table
  FRAME_ASSEMBLY,
  FRAME_PROP_ASSEMBLY,
  FRAME_FOLLOWER,
  FRAME_LOD_ACTOR,
  FRAME_LOD_PROP,
  FRAME_GLYPHS,
  FRAME_GAUSSIANS,
  FRAME_LINES,
  FRAME_WIREFRAME,
  FRAME_POINTS,
  FRAME_EDGES,
  FRAME_VOLUME,
  FRAME_COMPOSITE,
  FRAME_CLIPPED,
  FRAME_CULLED,
  FRAME_BACKFACE,
  FRAME_CUBE_AXES,
  FRAME_AXES,
  FRAME_TEXT,
  FRAME_TEXTURED,
  FRAME_GRID, // unstructured
  FRAME_UNLIT,
  FRAME_IMAGE,
  FRAME_NOTHING, // an actor without mapper, input or points
  FRAME_PART_KINDS
};

struct FrameGroup
{
  explicit FrameGroup(std::uint64_t number);

  std::uint64_t Number;
  int Phase; // vtkParticipatingMedium::PhaseFunctionType
  double Anisotropy;
  int Density;   // of the first medium; others are uniform or height fog
  int Technique; // vtkAirlightPass::ShadowTechniqueType
  bool Parallel;
  bool Grey;
  bool ScatteredSurfaceLight;
  bool LinearInput;
  bool Peeling;
  bool Fxaa;
  bool Layered;             // over another renderer
  bool Recent;              // see FrameRecent.cxx
  std::vector<int> Regions; // one for each medium
  std::vector<int> Lights;
  std::vector<int> Parts; // kinds to choose from

  std::string Describe() const;
};

const char* GetFrameLightName(int kind);
const char* GetFramePartName(int kind);
}

#endif
