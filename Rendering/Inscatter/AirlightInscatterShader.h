// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shader of one light's airlight: the source that it is put together from, and its uniforms.
 */

#ifndef AirlightInscatterShader_h
#define AirlightInscatterShader_h

#include "Inscatter/AirlightLightShadow.h"
#include "Scene/AirlightFrameScene.h"

#include <string>
#include <vector>

class vtkShaderProgram;

namespace airlight
{
class LightShadows;
class TranslucentFragments;

// What the pass states of the airlight's relative error, beside the phase function's (see
// Documentation/accuracy.md).
constexpr float ClosedFormError = 1e-4f;
constexpr float QuadratureError = 1e-3f;
// In an image that its medium's region cuts: where the way to the light begins to leave the region
// instead of the image there is a kink, at which cells are not cut. 6e-3 measured.
constexpr float CutImageError = 1e-2f;

struct InscatterOptions
{
  bool Record = false;                     // of what GetBuffer() gives
  double PhaseErrorBound = 0.0;            // relative; recorded
  double MultipleErrorBound = 0.0;         // of what is scattered more than once; likewise
  TranslucentFragments* Records = nullptr; // null: translucent fragments have no records
};

// What of rays a draw computes the airlight for.
enum class RayPart
{
  Surface,   // to the opaque surface
  Both,      // and to translucent fragments
  Fragments, // to these alone
};

class InscatterShader
{
public:
  InscatterShader(const FrameScene& scene, const InscatterOptions& options,
    const LightShadows& shadows, LightShadow& shadow, int light);

  // Whether rays take equiangular quadrature instead of the closed form.
  bool IsEquiangular() const { return this->Equiangular; }

  // Translucent fragments do without equiangular quadrature.
  std::string GetSource(const InscatterDraw& draw, RayPart part) const;
  void SetUniforms(vtkShaderProgram* program, const InscatterDraw& draw, RayPart part) const;

  // The rays, and the scattering of lights of this kind, for all shaders of airlight.
  static std::string GetRaySource(const FrameScene& scene, int kind, bool photometry, bool cones);

  // Of several lights without shadows, see InscatterPass::DrawUnshadowed().
  static std::string GetUnshadowedSource(const FrameScene& scene, const std::vector<int>& lights);
  static void SetUnshadowedUniforms(
    vtkShaderProgram* program, const FrameScene& scene, const std::vector<int>& lights);

private:
  std::string GetHead(bool storage, int kind, bool ownMedia) const;
  std::string GetEquiangularSource(const InscatterDraw& draw) const;
  std::string GetEquiangularRaySource() const;
  void SetLight(vtkShaderProgram* program, bool equiangular) const;
  double GetIntegralError() const;

  const FrameScene& Scene;
  const InscatterOptions& Options;
  const LightShadows& Shadows;
  LightShadow& Shadow;
  int Light;
  bool Equiangular;
};
}

#endif
