// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A light's shadow map: how far its rays go before they meet a caster. Redrawn when the light or a
 * caster changes. Needs OpenGL 3.2.
 *
 * Memory: 4 bytes a texel.
 */

#ifndef AirlightShadowMap_h
#define AirlightShadowMap_h

#include "Casters/AirlightCasters.h"
#include "OpenGL/AirlightQuad.h"
#include "Scene/AirlightSceneLights.h"
#include "ShadowMaps/AirlightShadowMapProjection.h"

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

  // Where a point is in the texture.
  const ShadowMapProjection& GetProjection() const { return this->Projection; }

  bool HasCasters() const { return this->Projection.HasCasters(); }
  vtkTextureObject* GetTexture() { return this->Texture; }
  const std::string& GetError() const { return this->Error; }

  void Release(vtkWindow* window);

private:
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
  void AddTriangle(const glm::dvec3 (&points)[3], std::vector<Corner>& corners) const;
  void DrawCasters(vtkShaderProgram* program);
  void DrawCorners(vtkShaderProgram* program, const std::vector<Corner>& corners);

  std::vector<Caster> Casters;
  std::vector<NonPolygonalCaster> NonPolygonal;
  glm::dvec4 Light{ 0.0 };
  glm::dvec3 Axis{ 0.0 }; // of a spot
  double CosCone = -1.0;
  int Resolution = 0; // of one of six faces
  bool Drawn = false; // all of it

  ShadowMapProjection Projection;
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
