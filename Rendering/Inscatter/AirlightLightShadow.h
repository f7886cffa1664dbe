// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One light's shadow in a frame: it makes the boundaries (t, +-) at which rays enter and leave the
 * shadow, and gives the inscatter shader a source that reads them. This class is the light without
 * a shadow; subclasses add shadow volumes and shadow maps.
 *
 * A shadow technique is a subclass here and a value of ShadowMethod.
 */

#ifndef AirlightLightShadow_h
#define AirlightLightShadow_h

#include "Casters/AirlightCasters.h"
#include "OpenGL/AirlightPixelArea.h"
#include "Scene/AirlightFrameScene.h"
#include "ShadowMaps/AirlightShadowMap.h"
#include "ShadowVolumes/AirlightPlanarOccluders.h"
#include "ShadowVolumes/AirlightShadowVolumes.h"
#include "ShadowVolumes/AirlightSilhouetteExchange.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
// The textures of a frame that the shadows and the airlight are drawn into and read.
struct InscatterTargets
{
  // Binds a framebuffer over the colours and the depth, which may be null. Returns a reason where
  // that fails, else an empty text.
  std::function<std::string(const std::vector<vtkTextureObject*>&, vtkTextureObject*)> Bind;
  std::vector<vtkTextureObject*> Scattered; // the airlight of all lights is added up here
  vtkTextureObject* Distances = nullptr;    // of the opaque surfaces
  vtkTextureObject* Depth = nullptr;
  vtkTextureObject* Mask = nullptr; // as depth: the pixels to be drawn; null for all
  PixelArea Area{ 0, 0, 0, 0 };     // outside of which no pixel is drawn
};

// What casts shadows in a frame.
struct ShadowCasters
{
  const std::vector<Caster>& Polygonal;
  const std::vector<NonPolygonalCaster>& NonPolygonal;
  const std::vector<PlanarOccluder>& Faces;      // behind which no shadow planes are drawn
  const std::vector<ProcessSilhouettes>& Remote; // of other processes, by process
  const DrawActors& DrawNonPolygonal;
  int MapResolution;
};

// Which pixels a draw of the inscatter shader does.
enum class BoundaryPixels
{
  All,
  Short,   // those with few boundaries, which the shader sorts itself
  Long,    // the others, sorted beforehand
  LongRest // what the draw before left of them
};

struct InscatterDraw
{
  BoundaryPixels Pixels = BoundaryPixels::All;
  int Row = 0;
  int Rows = 0;
};

class LightShadow
{
public:
  LightShadow() = default;
  virtual ~LightShadow() = default;
  LightShadow(const LightShadow&) = delete;
  void operator=(const LightShadow&) = delete;

  // Brings the shadow up to date for the frame's light of a number. Here and below false with a
  // reason in GetError() where OpenGL refuses.
  virtual bool Update(const FrameScene& scene, int light, const ShadowCasters& casters,
    const InscatterTargets& targets);

  // Whether the light has a shadow in this frame. Where it has none, it is drawn without.
  virtual bool HasShadow() const { return false; }

  // Makes the boundaries, row by row as memory allows, and calls `draw` for each draw of the
  // inscatter shader. `counted`: the draws count boundaries.
  using Draw = std::function<bool(const InscatterDraw&)>;
  virtual bool ForEachDraw(const FrameScene& scene, int light, const InscatterTargets& targets,
    bool counted, const Draw& draw);

  // Whether the program needs storage buffers.
  virtual bool UsesStorage() const { return false; }

  // Whether a pixel's boundaries can be counted before they are read, as equiangular quadrature
  // needs them.
  virtual bool CountsBoundaries() const { return true; }

  // The source that reads the boundaries (glsl/AirlightBoundaryReader.glsl). `counted`: by a reader
  // that counts. A ray march has its integrator instead (ShadowMaps/glsl/AirlightRayMarch.glsl).
  virtual std::string GetBoundarySource(const InscatterDraw& draw, bool counted) const;

  // The number of silhouette edges, by which boundaries get their room.
  virtual size_t GetEdgeCount() const { return 0; }

  // Sets what this source reads.
  virtual void Bind(vtkShaderProgram* program, const FrameScene& scene, const InscatterDraw& draw);

  // The textures that this source reads, by their names; null for one of floats that is of
  // no use.
  using Textures = std::vector<std::pair<const char*, vtkTextureObject*>>;
  virtual Textures GetTextures() { return {}; }

  // What stands between the light and the start of the rays: a count, or where casters let light
  // through their optical thickness.
  virtual int GetStartCount() const { return 0; }
  virtual CasterOpticalThickness GetStartThickness() const { return {}; }

  // The relative error of the light that casters let through.
  virtual double GetThicknessError() const { return 0.0; }

  const std::string& GetError() const { return this->Error; }

protected:
  bool Fail(const std::string& reason);

private:
  std::string Error;
};
}

#endif
