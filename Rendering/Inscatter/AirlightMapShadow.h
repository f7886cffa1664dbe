// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A light's shadow from a shadow map: boundaries found in its epipolar slices, or a ray march that
 * looks into it at each step.
 */

#ifndef AirlightMapShadow_h
#define AirlightMapShadow_h

#include "Inscatter/AirlightLightShadow.h"
#include "ShadowMaps/AirlightEpipolarMap.h"

namespace airlight
{
// The programs that draw maps, shared by all of them.
struct MapPrograms
{
  Quad Merge;
  ProgramMaker Casters;
  EpipolarMap::Programs Slices;
};

class MapShadow : public LightShadow
{
public:
  // `march`: by a ray march of so many steps.
  MapShadow(MapPrograms& programs, bool march);
  void SetSteps(int steps) { this->Steps = steps; }

  bool Update(const FrameScene& scene, int light, const ShadowCasters& casters,
    const InscatterTargets& targets) override;
  bool HasShadow() const override { return this->March || this->Map.HasCasters(); }
  bool CountsBoundaries() const override { return !this->March; }
  std::string GetBoundarySource(const InscatterDraw& draw, bool counted) const override;
  void Bind(vtkShaderProgram* program, const FrameScene& scene, const InscatterDraw& draw) override;
  Textures GetTextures() override;

  // For shaders that look single points up: AirlightMapLookup.glsl, its uniforms and its texture.
  static std::string GetLookupSource();
  void SetLookup(vtkShaderProgram* program, const FrameScene& scene) const;
  vtkTextureObject* GetTexture() { return this->Map.GetTexture(); }

  void Release(vtkWindow* window);

private:
  bool DrawMap(
    vtkOpenGLRenderWindow* window, const ShadowCasters& casters, const InscatterTargets& targets);
  bool DrawSlices(const FrameScene& scene, const InscatterTargets& targets);
  bool BindTarget(const InscatterTargets& targets, vtkTextureObject* texture);

  MapPrograms& Programs;
  ShadowMap Map;
  EpipolarMap Slices;
  bool March;
  int Steps = 64;
};
}

#endif
