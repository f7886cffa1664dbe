// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/AirlightShadowMap.h"

#include "AirlightShadowMapFS.h"
#include "AirlightShadowMapVS.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace airlight
{
namespace
{
// Six faces, three in a row.
constexpr int FacesInRow = 3;
// Triangles that are sent to the graphics card at a time.
constexpr size_t Batch = 1 << 15;
// Of the largest distance: nearer to the light nothing is drawn.
constexpr double RelativeNear = 1e-6;
// What no caster is beyond.
constexpr float Nothing = 1e30f;
}

//------------------------------------------------------------------------------
bool ShadowMap::Update(const std::vector<Caster>& casters,
  const std::vector<NonPolygonalCaster>& nonPolygonal, const SceneLight& sceneLight, int resolution)
{
  // Whether the others changed, nobody says.
  const bool same = this->Drawn && nonPolygonal.empty() && this->NonPolygonal.empty() &&
    this->Casters == casters && this->Light == sceneLight.World &&
    this->Axis == sceneLight.Values.axis && this->CosCone == sceneLight.Values.cosCone &&
    this->Resolution == resolution;
  if (same)
  {
    return false;
  }
  this->Casters = casters;
  this->NonPolygonal = nonPolygonal;
  this->Light = sceneLight.World;
  this->Axis = sceneLight.Values.axis;
  this->CosCone = sceneLight.Values.cosCone;
  this->Resolution = resolution;
  this->SetProjection();
  this->Drawn = this->Kind == Projection::None;
  return !this->Drawn;
}

//------------------------------------------------------------------------------
// Of six, face 2 k looks along axis k, face 2 k + 1 against it.
glm::dmat3 ShadowMap::GetFrame(int face) const
{
  if (this->Kind != Projection::Cube)
  {
    return this->Frame;
  }
  const int k = face / 2;
  glm::dmat3 frame(0.0);
  frame[0][(k + 1) % 3] = 1.0;
  frame[1][(k + 2) % 3] = 1.0;
  frame[2][k] = face % 2 == 0 ? 1.0 : -1.0;
  return frame;
}

//------------------------------------------------------------------------------
glm::ivec2 ShadowMap::GetTile(int face) const
{
  return { face % FacesInRow * this->Side, face / FacesInRow * this->Side };
}

//------------------------------------------------------------------------------
bool ShadowMap::Prepare(vtkOpenGLRenderWindow* window)
{
  const bool cube = this->Kind == Projection::Cube;
  this->Width = (cube ? FacesInRow : 1) * this->Side;
  this->Height = (cube ? 6 / FacesInRow : 1) * this->Side;
  const int most = vtkTextureObject::GetMaximumTextureSize(window);
  if (this->Width > most)
  {
    this->Error = "a shadow map of " + std::to_string(this->Width) +
      " texels exceeds the largest texture of " + std::to_string(most) +
      ": call SetShadowMapResolution() with at most " + std::to_string(most / FacesInRow);
    return false;
  }
  return this->Allocate(window, this->Texture) &&
    (this->NonPolygonal.empty() || this->Allocate(window, this->NonPolygonalTexture));
}

//------------------------------------------------------------------------------
bool ShadowMap::Allocate(vtkOpenGLRenderWindow* window, vtkTextureObject* texture)
{
  ForgetErrors();
  if (texture->GetHandle() != 0)
  {
    texture->Resize(this->Width, this->Height);
    return !IsOutOfMemory() || this->FailAllocation();
  }
  texture->SetContext(window);
  texture->SetFormat(GL_RED);
  texture->SetInternalFormat(GL_R32F);
  texture->SetDataType(GL_FLOAT);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  return (texture->Allocate2D(this->Width, this->Height, 1, VTK_FLOAT) && !IsOutOfMemory()) ||
    this->FailAllocation();
}

//------------------------------------------------------------------------------
bool ShadowMap::FailAllocation()
{
  this->Error = "no memory on the graphics card for a shadow map of " +
    std::to_string(this->Width) + " x " + std::to_string(this->Height) +
    " texels: lower SetShadowMapResolution()";
  return false;
}

//------------------------------------------------------------------------------
// The nearest distance of each texel comes from blending: no depth buffer rounds it, and no near or
// far plane cuts it off.
void ShadowMap::BeginNearest(vtkOpenGLRenderWindow* window, bool clear)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglScissor(0, 0, this->Width, this->Height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (clear)
  {
    state->vtkglClearColor(Nothing, Nothing, Nothing, Nothing);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_MIN);
}

//------------------------------------------------------------------------------
void ShadowMap::EndNearest(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglDisable(GL_BLEND);
}

//------------------------------------------------------------------------------
bool ShadowMap::Draw(vtkOpenGLRenderWindow* window, ProgramMaker& programs)
{
  std::string text = AirlightShadowMapFS;
  vtkShaderProgram* program = programs.GetOrCompile(window, AirlightShadowMapVS, text);
  if (!program)
  {
    this->Error = std::string("the shadow map's shader") + ProgramMaker::GetReason();
    return false;
  }
  this->BeginNearest(window, true);
  const glm::vec2 scale(this->Scale);
  program->SetUniform2f("scale", &scale.x);
  program->SetUniformi("resolution", this->Side);
  program->SetUniformi("parallel", this->Kind == Projection::Parallel ? 1 : 0);
  program->SetUniformf("nearest", static_cast<float>(RelativeNear * this->Farthest));
  this->Refused = false;
  glGenVertexArrays(1, &this->VertexArray);
  glGenBuffers(1, &this->Buffer);
  this->DrawCasters(program);
  glDeleteBuffers(1, &this->Buffer);
  glDeleteVertexArrays(1, &this->VertexArray);
  this->EndNearest(window);
  this->Drawn = !this->Refused;
  this->Error = this->Refused
    ? "no memory on the graphics card for the triangles of a shadow map: use "
      "coarser meshes"
    : "";
  return this->Drawn;
}

//------------------------------------------------------------------------------
void ShadowMap::AddTriangle(const glm::dvec3 (&points)[3], std::vector<Corner>& corners) const
{
  const bool parallel = this->Kind == Projection::Parallel;
  glm::dvec3 normal = glm::cross(points[1] - points[0], points[2] - points[0]);
  const double length = glm::length(normal);
  normal /= length > 0.0 ? length : 1.0;
  const double away = glm::dot(normal, parallel ? this->Frame[2] : points[0]);
  normal *= away < 0.0 ? -1.0 : 1.0;
  double limit = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : points)
  {
    limit = std::max(limit, parallel ? glm::dot(point, this->Frame[2]) : glm::length(point));
  }
  const glm::vec4 plane(glm::vec3(normal), static_cast<float>(glm::dot(normal, points[0])));
  for (const glm::dvec3& point : points)
  {
    corners.push_back({ glm::vec3(point), plane, static_cast<float>(limit) });
  }
}

//------------------------------------------------------------------------------
void ShadowMap::DrawCasters(vtkShaderProgram* program)
{
  std::vector<Corner> corners;
  for (const Caster& caster : this->Casters)
  {
    for (const std::array<int, 3>& t : caster.Mesh->Triangles)
    {
      const glm::dvec3 points[3] = { caster.GetPoint(t[0]) - this->Anchor,
        caster.GetPoint(t[1]) - this->Anchor, caster.GetPoint(t[2]) - this->Anchor };
      this->AddTriangle(points, corners);
      if (corners.size() >= 3 * Batch)
      {
        this->DrawCorners(program, corners);
        corners.clear();
      }
    }
  }
  this->DrawCorners(program, corners);
}

//------------------------------------------------------------------------------
void ShadowMap::DrawCorners(vtkShaderProgram* program, const std::vector<Corner>& corners)
{
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
  ForgetErrors();
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)),
    corners.data(), GL_STREAM_DRAW);
  if (glGetError() != GL_NO_ERROR)
  {
    this->Refused = true;
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
    return;
  }
  const auto attribute = [program](const char* name, int components, size_t offset) {
    const GLint location = glGetAttribLocation(program->GetHandle(), name);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(Corner),
      reinterpret_cast<const void*>(offset)); // NOLINT: OpenGL's way to give an offset
  };
  attribute("position", 3, offsetof(Corner, Position));
  attribute("plane", 4, offsetof(Corner, Plane));
  attribute("limit", 1, offsetof(Corner, Limit));
  for (int face = 0; face < this->GetFaceCount(); ++face)
  {
    const glm::ivec2 tile = this->GetTile(face);
    const glm::mat3 frame(this->GetFrame(face));
    // Not through VTK's record, which is told where it ends.
    glViewport(tile.x, tile.y, this->Side, this->Side);
    glScissor(tile.x, tile.y, this->Side, this->Side);
    program->SetUniform2i("tile", &tile.x);
    program->SetUniform3fv("frame", 3, &frame[0].x);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
  }
  glViewport(0, 0, this->Width, this->Height);
  glScissor(0, 0, this->Width, this->Height);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void ShadowMap::Release(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->NonPolygonalTexture->ReleaseGraphicsResources(window);
  this->NonPolygonal.clear();
  this->Casters.clear();
  this->Drawn = false;
}
}
