// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A light's shadow map: how far its rays go before they meet a caster. Six square faces around a
 * light at a place, one before a narrow spot (up to 60 degrees) and one across the casters for a
 * light at infinity. Redrawn when the light or a caster changes. Needs OpenGL 3.2.
 *
 * Memory: 4 bytes a texel.
 */

#ifndef AirlightShadowMap_h
#define AirlightShadowMap_h

#include "Casters/AirlightCasters.h"
#include "OpenGL/AirlightQuad.h"
#include "Scene/AirlightSceneLights.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

class vtkCamera;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace airlight
{
class CameraUniforms;

// Draws actors with their mappers from the camera of a shadow map's face, into the bound
// framebuffer, where the face's lower left corner is at x, y and its side is so many pixels long.
using DrawActors = std::function<void(
  const std::vector<NonPolygonalCaster>& casters, vtkCamera* camera, int x, int y, int side)>;

class ShadowMap
{
public:
  // Takes the light and its casters. True if the map has to be drawn again, into GetTexture().
  bool Update(const std::vector<Caster>& casters,
    const std::vector<NonPolygonalCaster>& nonPolygonal, const SceneLight& sceneLight,
    int resolution);

  // Makes the texture. False with a reason in GetError() if OpenGL refuses it.
  bool Prepare(vtkOpenGLRenderWindow* window);

  // Draws the casters into the framebuffer that is bound over the texture. False with a reason in
  // GetError() where the shader does not compile; the next Update() then asks for it again.
  bool Draw(vtkOpenGLRenderWindow* window, ProgramMaker& programs);

  // Where there are others than polygons: draws them into the framebuffer that is bound over
  // GetNonPolygonalTexture(), then, with that over GetTexture(), joins the two.
  bool HasNonPolygonal() const { return !this->NonPolygonal.empty(); }
  vtkTextureObject* GetNonPolygonalTexture() { return this->NonPolygonalTexture; }
  void DrawNonPolygonal(vtkOpenGLRenderWindow* window, const DrawActors& draw);
  bool MergeNonPolygonal(vtkOpenGLRenderWindow* window, Quad& quad);

  // Those of glsl/AirlightMapMarch.glsl, but for the texture.
  void SetUniforms(vtkShaderProgram* program, const CameraUniforms& view) const;

  bool HasCasters() const { return this->Kind != Projection::None; }
  vtkTextureObject* GetTexture() { return this->Texture; }
  const std::string& GetError() const { return this->Error; }

  // Size of what casts: the distances over which a directional light's shadows change.
  double GetExtent() const { return this->Extent; }

  void Release(vtkWindow* window);

private:
  // As glsl/AirlightMapMarch.glsl numbers them.
  enum class Projection
  {
    None = 0, // no casters
    Cube = 1,
    Cone = 2,
    Parallel = 3
  };

  // A triangle's corner, relative to the anchor.
  struct Corner
  {
    glm::vec3 Position;
    glm::vec4 Plane; // normal away from the light, its product with any point of the triangle
    float Limit;     // the triangle's largest distance from the light
  };

  bool Allocate(vtkOpenGLRenderWindow* window, vtkTextureObject* texture);
  bool FailAllocation();
  void BeginNearest(vtkOpenGLRenderWindow* window, bool clear);
  void EndNearest(vtkOpenGLRenderWindow* window);
  void SetFaceCamera(vtkCamera* camera, int face) const;
  double GetCameraOffset() const;
  std::vector<glm::dvec3> GetBoxCorners() const;
  void SetProjection();
  void SetParallelProjection();
  glm::dmat3 FindParallelFrame() const;
  void AddTriangle(const glm::dvec3 (&points)[3], std::vector<Corner>& corners) const;
  void DrawCasters(vtkShaderProgram* program);
  void DrawCorners(vtkShaderProgram* program, const std::vector<Corner>& corners);
  int GetFaceCount() const { return this->Kind == Projection::Cube ? 6 : 1; }
  glm::dmat3 GetFrame(int face) const;
  glm::ivec2 GetTile(int face) const;

  std::vector<Caster> Casters;
  std::vector<NonPolygonalCaster> NonPolygonal;
  glm::dvec4 Light{ 0.0 };
  glm::dvec3 Axis{ 0.0 }; // of a spot
  double CosCone = -1.0;
  int Resolution = 0; // of one of six faces
  int Side = 0;       // texels along the side of each face
  bool Drawn = false;

  Projection Kind = Projection::None;
  glm::dvec3 Anchor{ 0.0 }; // the light, or where it is at infinity the casters' middle
  glm::dmat3 Frame{ 1.0 };  // columns: across, across, away from the light; not for six faces
  glm::dvec2 Scale{ 1.0 };  // from tangents, or lengths, to -1..1
  double Nearest = 0.0;     // of the casters, along the light
  double Extent = 0.0;
  double Farthest = 0.0;

  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkTextureObject> NonPolygonalTexture;
  bool Refused = false; // memory for what casts
  int Width = 0;
  int Height = 0;
  unsigned int VertexArray = 0;
  unsigned int Buffer = 0;
  std::string Error;
};
}

#endif
