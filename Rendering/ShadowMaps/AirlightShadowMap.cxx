// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/AirlightShadowMap.h"

#include "AirlightMergeCastersFS.h"
#include "AirlightShadowMapFS.h"
#include "AirlightShadowMapVS.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace airlight
{
namespace
{
// Triangles that are sent to the graphics card at a time.
constexpr size_t Batch = 1 << 15;
// Of the largest distance: nearer to the light nothing is drawn.
constexpr double RelativeNearest = 1e-6;
// What no caster is beyond.
constexpr float Nothing = 1e30f;
}

//------------------------------------------------------------------------------
bool ShadowMap::Update(const std::vector<Caster>& casters,
  const std::vector<NonPolygonalCaster>& nonPolygonal, const SceneLight& sceneLight, int resolution)
{
  const auto drawsAs = [](const NonPolygonalCaster& caster, const NonPolygonalCaster& last) {
    return caster.DrawsAs(last);
  };
  const bool same = this->Drawn && this->Casters == casters &&
    std::equal(nonPolygonal.begin(), nonPolygonal.end(), this->NonPolygonal.begin(),
      this->NonPolygonal.end(), drawsAs) &&
    this->Light == sceneLight.World && this->Axis == sceneLight.Values.axis &&
    this->CosCone == sceneLight.Values.cosCone && this->Resolution == resolution;
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
  this->Projection.Set(casters, nonPolygonal, sceneLight, resolution);
  this->Drawn = !this->Projection.HasCasters();
  return !this->Drawn;
}

//------------------------------------------------------------------------------
bool ShadowMap::Prepare(vtkOpenGLRenderWindow* window)
{
  this->Width = this->Projection.GetWidth();
  this->Height = this->Projection.GetHeight();
  const int most = vtkTextureObject::GetMaximumTextureSize(window);
  if (this->Width > most)
  {
    this->Error = "a shadow map of " + std::to_string(this->Width) +
      " texels exceeds the largest texture of " + std::to_string(most) +
      ": call SetShadowMapResolution() with at most " +
      std::to_string(most / this->Projection.GetFacesInRow());
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
  const glm::vec2 scale(this->Projection.GetScale());
  program->SetUniform2f("scale", &scale.x);
  program->SetUniformi("resolution", this->Projection.GetSide());
  program->SetUniformi("parallel", this->Projection.IsParallel() ? 1 : 0);
  program->SetUniformf(
    "nearest", static_cast<float>(RelativeNearest * this->Projection.GetFarthest()));
  this->Refused = false;
  glGenVertexArrays(1, &this->VertexArray);
  glGenBuffers(1, &this->Buffer);
  this->DrawCasters(program);
  glDeleteBuffers(1, &this->Buffer);
  glDeleteVertexArrays(1, &this->VertexArray);
  this->EndNearest(window);
  this->Drawn = !this->Refused && !this->HasNonPolygonal();
  this->Error = this->Refused
    ? "no memory on the graphics card for the triangles of a shadow map: use "
      "coarser meshes"
    : "";
  return !this->Refused;
}

//------------------------------------------------------------------------------
void ShadowMap::AddTriangle(const glm::dvec3 (&points)[3], std::vector<Corner>& corners) const
{
  const bool parallel = this->Projection.IsParallel();
  const glm::dvec3 away = this->Projection.GetFrame(0)[2];
  glm::dvec3 normal = glm::cross(points[1] - points[0], points[2] - points[0]);
  const double length = glm::length(normal);
  normal /= length > 0.0 ? length : 1.0;
  normal *= glm::dot(normal, parallel ? away : points[0]) < 0.0 ? -1.0 : 1.0;
  double limit = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : points)
  {
    limit = std::max(limit, parallel ? glm::dot(point, away) : glm::length(point));
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
  const glm::dvec3& anchor = this->Projection.GetAnchor();
  std::vector<Corner> corners;
  for (const Caster& caster : this->Casters)
  {
    for (const std::array<int, 3>& t : caster.Mesh->Triangles)
    {
      const glm::dvec3 points[3] = { caster.GetPoint(t[0]) - anchor, caster.GetPoint(t[1]) - anchor,
        caster.GetPoint(t[2]) - anchor };
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
  const int side = this->Projection.GetSide();
  for (int face = 0; face < this->Projection.GetFaceCount(); ++face)
  {
    const glm::ivec2 tile = this->Projection.GetTile(face);
    const glm::mat3 frame(this->Projection.GetFrame(face));
    // Not through VTK's record, which learns where it ends.
    glViewport(tile.x, tile.y, side, side);
    glScissor(tile.x, tile.y, side, side);
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
void ShadowMap::DrawNonPolygonal(vtkOpenGLRenderWindow* window, const DrawActors& draw)
{
  this->BeginNearest(window, true);
  vtkOpenGLState* state = window->GetState();
  const int side = this->Projection.GetSide();
  for (int face = 0; face < this->Projection.GetFaceCount(); ++face)
  {
    auto camera = vtk::TakeSmartPointer(vtkCamera::New());
    this->Projection.SetCamera(camera, face);
    const glm::ivec2 tile = this->Projection.GetTile(face);
    state->vtkglViewport(tile.x, tile.y, side, side);
    state->vtkglScissor(tile.x, tile.y, side, side);
    draw(this->NonPolygonal, camera, tile.x, tile.y, side);
  }
  this->EndNearest(window);
}

//------------------------------------------------------------------------------
bool ShadowMap::MergeNonPolygonal(vtkOpenGLRenderWindow* window, Quad& quad)
{
  vtkShaderProgram* program = quad.GetOrCompile(window, AirlightMergeCastersFS);
  if (!program)
  {
    this->Error = std::string("the shadow map's shader") + ProgramMaker::GetReason();
    return false;
  }
  this->BeginNearest(window, false);
  const glm::vec2 scale(this->Projection.GetScale());
  program->SetUniformi("resolution", this->Projection.GetSide());
  program->SetUniformi("parallel", this->Projection.IsParallel() ? 1 : 0);
  program->SetUniform2f("scale", &scale.x);
  program->SetUniformf("offset", static_cast<float>(this->Projection.GetCameraOffset()));
  quad.Draw({ { "drawn", this->NonPolygonalTexture } });
  this->EndNearest(window);
  this->Drawn = true;
  return true;
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
