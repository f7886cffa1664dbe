// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A light's shadow from both shadow volumes and a shadow map, each of other casters: the boundaries
 * of both in order.
 */

#ifndef AirlightMixedShadow_h
#define AirlightMixedShadow_h

#include "Inscatter/AirlightMapShadow.h"
#include "Inscatter/AirlightPlanesShadow.h"

namespace airlight
{
class MixedShadow : public LightShadow
{
public:
  // Both are updated by the caller.
  MixedShadow(PlanesShadow& planes, MapShadow& map)
    : Planes(planes)
    , Map(map)
  {
  }

  bool HasShadow() const override { return true; }
  bool ForEachDraw(const FrameScene& scene, int light, const InscatterTargets& targets,
    bool counted, const Draw& draw) override;
  bool UsesStorage() const override { return true; }
  bool CountsBoundaries() const override { return this->Planes.CountsBoundaries(); }
  std::string GetBoundarySource(const InscatterDraw& draw, bool counted) const override;
  void Bind(vtkShaderProgram* program, const FrameScene& scene, const InscatterDraw& draw) override;
  Textures GetTextures() override { return this->Map.GetTextures(); }
  int GetStartCount() const override { return this->Planes.GetStartCount(); }

private:
  PlanesShadow& Planes;
  MapShadow& Map;
};
}

#endif
