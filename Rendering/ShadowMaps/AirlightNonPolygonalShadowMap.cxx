// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What VTK's mappers draw in place of polygons, in a shadow map.

#include "ShadowMaps/AirlightShadowMap.h"

#include "AirlightMergeCastersFS.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Of the largest distance: what is nearer to the light is cut off.
constexpr double RelativeNear = 1e-4;
}

//------------------------------------------------------------------------------
// A directional light's camera stands before all casters.
double ShadowMap::GetCameraOffset() const
{
  return this->Kind == Projection::Parallel ? 2.0 * this->Extent : 0.0;
}

//------------------------------------------------------------------------------
void ShadowMap::SetFaceCamera(vtkCamera* camera, int face) const
{
  const bool parallel = this->Kind == Projection::Parallel;
  const glm::dmat3 frame = this->GetFrame(face);
  const double offset = this->GetCameraOffset();
  const glm::dvec3 position = this->Anchor - offset * frame[2];
  const glm::dvec3 focus = position + std::max(this->Extent, 1e-30) * frame[2];
  const double nearest = parallel ? offset - this->Extent : RelativeNear * this->Farthest;
  const double farthest = parallel ? offset + this->Extent : 2.0 * this->Farthest;
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(frame[1].x, frame[1].y, frame[1].z);
  camera->SetParallelProjection(parallel);
  camera->SetClippingRange(nearest, farthest);
  // A camera's right hand is where the face's first direction is, or opposite.
  const double hand = glm::dot(glm::cross(frame[2], frame[1]), frame[0]);
  vtkNew<vtkMatrix4x4> projection;
  projection->Zero();
  projection->SetElement(0, 0, hand * this->Scale.x);
  projection->SetElement(1, 1, this->Scale.y);
  projection->SetElement(2, 2, (parallel ? -2.0 : -farthest - nearest) / (farthest - nearest));
  projection->SetElement(
    2, 3, (parallel ? -farthest - nearest : -2.0 * farthest * nearest) / (farthest - nearest));
  projection->SetElement(3, parallel ? 3 : 2, parallel ? 1.0 : -1.0);
  camera->SetExplicitProjectionTransformMatrix(projection);
  camera->UseExplicitProjectionTransformMatrixOn();
}

//------------------------------------------------------------------------------
void ShadowMap::DrawNonPolygonal(vtkOpenGLRenderWindow* window, const DrawActors& draw)
{
  this->BeginNearest(window, true);
  vtkOpenGLState* state = window->GetState();
  for (int face = 0; face < this->GetFaceCount(); ++face)
  {
    auto camera = vtk::TakeSmartPointer(vtkCamera::New());
    this->SetFaceCamera(camera, face);
    const glm::ivec2 tile = this->GetTile(face);
    state->vtkglViewport(tile.x, tile.y, this->Side, this->Side);
    state->vtkglScissor(tile.x, tile.y, this->Side, this->Side);
    draw(this->NonPolygonal, camera, tile.x, tile.y, this->Side);
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
  const glm::vec2 scale(this->Scale);
  program->SetUniformi("resolution", this->Side);
  program->SetUniformi("parallel", this->Kind == Projection::Parallel ? 1 : 0);
  program->SetUniform2f("scale", &scale.x);
  program->SetUniformf("offset", static_cast<float>(this->GetCameraOffset()));
  quad.Draw({ { "drawn", this->NonPolygonalTexture } });
  this->EndNearest(window);
  return true;
}
}
