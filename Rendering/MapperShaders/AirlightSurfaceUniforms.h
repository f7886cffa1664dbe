// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The uniforms of the text that is added to the shaders of VTK's mappers.
 */

#ifndef AirlightSurfaceUniforms_h
#define AirlightSurfaceUniforms_h

#include "MapperShaders/AirlightSurfaceShader.h"

#include <glm/glm.hpp>

#include <vector>

class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkVolume;

namespace airlight
{
class CameraUniforms;
class FroxelNodes;
class ShadowTransmittance;
class TranslucentFragments;

// The state that the added text reads.
struct SurfaceUniforms
{
  SurfaceStage Stage = SurfaceStage::Distance;
  const CameraUniforms* Rays = nullptr;
  int ViewportX = 0; // lower left corner of the viewport in the target
  int ViewportY = 0;
  glm::vec4 Pixels{ 1.0f, 1.0f, 0.0f, 0.0f }; // of the target (CameraUniforms::SetUniforms())
  const f64::AirlightMedia* Media = nullptr;
  const std::vector<vtkVolume*>* CastingVolumes = nullptr; // those after the media, or null
  const std::vector<SceneLight>* SceneLights = nullptr;
  vtkTextureObject* Lit = nullptr;       // in the pass, an active texture in any case
  vtkTextureObject* MoreLit = nullptr;   // likewise; the same where there are few lights
  vtkTextureObject* LightWays = nullptr; // see AirlightLightWaysPass.h; null without layers
  std::vector<int> LightLayers;          // of each light, -1: it has none
  vtkTextureObject* Data = nullptr;      // an active texture, or null where the shaders read none
  vtkTextureObject* Samples = nullptr;   // likewise, see AirlightFrameScene.h
  const TranslucentFragments* Records = nullptr; // null: there are none
  const ShadowTransmittance* Transmittances =
    nullptr;                            // what casters leave of lights on opaque surfaces
  const FroxelNodes* Froxels = nullptr; // null: there is no grid
  bool UseLit = false;                  // false: all surfaces are lit
  bool ScatteredIrradiance = false;     // the shaders were rewritten for scattered light
  bool Hides = false;                   // the shader was rewritten to draw nothing on demand
  bool Hidden = false;                  // now it does
  int Width = 0;                        // of the viewport
  int Height = 0;
  int VolumeNodes = 2;   // on the rays through volumes
  bool Additive = false; // adds to what is behind, and the medium has done so already

  // Those that the shaders read: active while surfaces are drawn.
  std::vector<vtkTextureObject*> GetTextures() const;
};

// Brings them to the target that a delegate has bound, which may be of another size, and binds the
// textures again whose units it may have used.
void FitToTarget(SurfaceUniforms& values, vtkRenderer* renderer);

void SetSurfaceUniforms(vtkShaderProgram* program, const SurfaceUniforms& values);
}

#endif
