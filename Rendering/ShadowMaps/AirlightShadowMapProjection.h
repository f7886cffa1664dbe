// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a shadow map's faces are, and how shaders and cameras find a point in them: six square
 * faces around a light at a place, one before a narrow spot (up to 60 degrees), and one across the
 * casters for a light at infinity.
 */

#ifndef AirlightShadowMapProjection_h
#define AirlightShadowMapProjection_h

#include "Casters/AirlightCasters.h"
#include "Scene/AirlightSceneLights.h"

#include <glm/glm.hpp>

#include <vector>

class vtkCamera;
class vtkShaderProgram;

namespace airlight
{
class CameraUniforms;

class ShadowMapProjection
{
public:
  // For a light and all that casts. `resolution`: texels along the side of one of six faces; a face
  // on its own has as many texels as six together.
  void Set(const std::vector<Caster>& casters, const std::vector<NonPolygonalCaster>& nonPolygonal,
    const SceneLight& light, int resolution);

  bool HasCasters() const { return this->Kind != Kinds::None; }
  bool IsParallel() const { return this->Kind == Kinds::Parallel; }

  // The map in texels, and the side and the corner of a face in it.
  int GetWidth() const;
  int GetHeight() const;
  int GetFacesInRow() const;
  int GetSide() const { return this->Side; }
  int GetFaceCount() const { return this->Kind == Kinds::Cube ? 6 : 1; }
  glm::ivec2 GetTile(int face) const;

  // Columns: two directions across, and the one away from the light.
  glm::dmat3 GetFrame(int face) const;

  // The light, or for one at infinity the casters' middle.
  const glm::dvec3& GetAnchor() const { return this->Anchor; }

  // From tangents, for a light at infinity from lengths, to -1..1.
  const glm::dvec2& GetScale() const { return this->Scale; }

  // The casters' size, for a light at a place their largest distance from it.
  double GetExtent() const { return this->Extent; }
  double GetFarthest() const { return this->Farthest; }

  // Within such a distance of the anchor are all that the map holds; of a light at infinity, along
  // its light.
  double GetReach() const { return this->Reach; }

  // What roundings of the map and of points from the eye may add to a distance; of a light at a
  // place besides a share of it.
  double GetSlack(const CameraUniforms& view) const;

  // A cone from a light at a place that holds all of the map in which there may be casters.
  struct Cover
  {
    glm::dvec3 Axis{ 0.0, 0.0, 1.0 }; // unit
    double Angle = 0.0;               // from it, in radians
  };
  const Cover& GetCover() const { return this->Covered; }

  // The camera of a face. That of a light at infinity stands so far before the casters' middle.
  void SetCamera(vtkCamera* camera, int face) const;
  double GetCameraOffset() const;

  // Those of glsl/AirlightMapLookup.glsl, but for the texture.
  void SetUniforms(vtkShaderProgram* program, const CameraUniforms& view) const;

private:
  // As glsl/AirlightMapLookup.glsl numbers them.
  enum class Kinds
  {
    None = 0, // no casters
    Cube = 1,
    Cone = 2,
    Parallel = 3
  };

  void SetCover(const std::vector<glm::dvec3>& corners, double cosCone, bool polygonal);
  void SetParallel(const std::vector<Caster>& casters,
    const std::vector<NonPolygonalCaster>& nonPolygonal, const glm::dvec3& toLight);

  Kinds Kind = Kinds::None;
  int Side = 0;
  glm::dvec3 Anchor{ 0.0 };
  glm::dmat3 Frame{ 1.0 }; // not for six faces
  glm::dvec2 Scale{ 1.0 };
  double Extent = 0.0;
  double Farthest = 0.0;
  double Reach = 0.0;
  Cover Covered;
};
}

#endif
