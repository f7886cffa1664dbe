// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightShadowLists.h"

#include "AirlightCameraShader.h"
#include "AirlightOutlineFS.h"
#include "AirlightPlanesFS.h"
#include "AirlightPlanesVS.h"
#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightStorageBinding.h"
#include "Scene/AirlightCameraUniforms.h"
#include "Translucency/AirlightFroxelNodes.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
bool ShadowLists::IsSupported(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  GLint vertexBlocks = 0;
  if (major > 4 || (major == 4 && minor >= 3))
  {
    glGetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &vertexBlocks);
  }
  return vertexBlocks >= 2 && HasStorageBindings();
}

//------------------------------------------------------------------------------
std::string ShadowLists::GetBoundarySource(bool sorted, bool counted) const
{
  return this->Sorting.GetBoundarySource(sorted, counted);
}

//------------------------------------------------------------------------------
bool ShadowLists::SetVolumes(int light, const ShadowVolumes& volumes)
{
  const bool ok = this->Planes.SetVolumes(light, volumes);
  this->Error = ok ? this->Error : this->Planes.GetError();
  return ok;
}

bool ShadowLists::SetTruncationPlanes(const Source& source)
{
  const bool ok = this->Planes.SetTruncationPlanes(source.TruncationPlanes);
  this->Error = ok ? this->Error : this->Planes.GetError();
  return ok;
}

//------------------------------------------------------------------------------
bool ShadowLists::Prepare(vtkOpenGLRenderWindow* window, int width, int height,
  bool transmitsShadows, size_t edges, std::uint64_t memoryLimit, bool budgeted)
{
  this->Window = window;
  this->Width = width;
  this->Height = height;
  this->Budgeted = budgeted;
  this->OverBudget = false;
  if (!this->Store.Prepare(width, height, transmitsShadows, edges, memoryLimit))
  {
    this->Error = this->Store.GetError();
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
vtkShaderProgram* ShadowLists::GetPlanesProgram(
  PlaneKind kind, const std::string& fragment, const Source& source)
{
  const std::string head = GetShaderVersion(true) + "#define AIRLIGHT_NEAR_PLANES " +
    std::to_string(kind == PlaneKind::Near) + "\n#define AIRLIGHT_CAPS " +
    std::to_string(kind == PlaneKind::Cap) + "\n";
  std::string text = head + fragment;
  vtkShaderProgram* program =
    this->PlanePrograms.GetOrCompile(this->Window, head + AirlightPlanesVS, text);
  if (!program)
  {
    this->Error = std::string("the shader of shadow planes") + ProgramMaker::GetReason();
    return nullptr;
  }
  const CameraUniforms& view = source.Rays;
  view.SetUniforms(program, 0, 0);
  glm::mat4 clip = view.GetClipMatrix(source.Volumes.GetAnchor());
  const glm::vec3 anchor(source.Volumes.GetAnchor() - view.GetEye());
  const glm::dvec4& light = source.Volumes.GetLight();
  const glm::vec4 fromLight =
    light.w != 0.0 ? glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) : glm::vec4(-glm::vec3(light), 0.0f);
  program->SetUniformMatrix4x4("anchorToClip", &clip[0][0]);
  program->SetUniform3f("anchor", &anchor.x);
  program->SetUniform4f("fromLight", &fromLight.x);
  program->SetUniformi("againstView", source.Volumes.IsAgainstView() ? 1 : 0);
  return program;
}

//------------------------------------------------------------------------------
std::string ShadowLists::GetPlanesSource(const CameraUniforms& view) const
{
  // The near planes' fragments need all of the view, the others little.
  return BoundaryBuffer::DefineNodes(this->Store.HasShadowTransmittance()) +
    "#define AIRLIGHT_LIST_LAYOUT_IN\n" + this->Store.GetSource() + "#define AIRLIGHT_PARALLEL " +
    std::to_string(view.IsParallel()) + "\n#define AIRLIGHT_FRAGMENT_IS_PIXEL\n" +
    AirlightCameraShader + AirlightPlanesFS;
}

//------------------------------------------------------------------------------
bool ShadowLists::DrawFragments(const Source& source, PlaneKind kind, int row, int rows)
{
  if (this->Planes.IsEmpty(kind, source.LightNumber))
  {
    return true;
  }
  vtkShaderProgram* program =
    this->GetPlanesProgram(kind, this->GetPlanesSource(source.Rays), source);
  if (!program)
  {
    return false;
  }
  program->SetUniformi("distances", source.Distances->GetTextureUnit());
  program->SetUniformi("inParallel", source.Rays.IsParallel() ? 1 : 0);
  const int first = std::max(row, this->Area.Y);
  const int last = std::min(row + rows, this->Area.Y + this->Area.Height);
  this->Window->GetState()->vtkglScissor(
    this->Area.X, first, this->Area.Width, std::max(last - first, 0));
  this->Store.Use(program);
  this->Planes.Draw(kind, source.LightNumber);
  return true;
}

//------------------------------------------------------------------------------
// Draws all planes and caps, clipped to some rows.
bool ShadowLists::TryDraw(const Source& source, int row, int rows, BoundaryBuffer::Counts& counts)
{
  this->Store.Clear(row);
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  const bool ok = this->DrawFragments(source, PlaneKind::Plane, row, rows) &&
    this->DrawFragments(source, PlaneKind::Cap, row, rows) &&
    this->DrawFragments(source, PlaneKind::Near, row, rows);
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  counts = this->Store.ReadCounts();
  if (!ok || counts.Boundaries == 0 || !this->HasKBuffer())
  {
    return ok;
  }
  const bool spilled = this->Sorting.MergeOverflow({ this->Window, this->Width, row, rows });
  this->Error = spilled ? this->Error : this->Sorting.GetError();
  counts = this->Store.ReadCounts();
  return spilled;
}

//------------------------------------------------------------------------------
int ShadowLists::DrawRows(const Source& source, int row, int rows)
{
  const std::uint64_t most = this->Store.GetMost();
  rows = this->Store.LimitRows(rows);
  while (rows > 0)
  {
    BoundaryBuffer::Counts counts;
    if (!this->TryDraw(source, row, rows, counts))
    {
      return 0;
    }
    const std::uint64_t needed = counts.Boundaries + 1; // the first is not used
    if (needed <= this->Store.GetCapacity())
    {
      this->Longest = counts.Longest;
      this->Filled = { this->Window, this->Width, row, rows };
      return rows;
    }
    if (this->Budgeted && needed > MostBands * most)
    {
      break;
    }
    // A quarter more than needed, so that a scene in motion does not grow it each frame.
    if (needed <= most && this->Store.Reserve(std::min(needed + needed / 4, most)))
    {
      continue;
    }
    if (this->Store.GetCapacity() == 0 && !this->Store.ReserveSome())
    {
      this->Error = this->Store.GetError();
      return 0;
    }
    rows /= 2;
  }
  this->OverBudget = true;
  this->Error = "one row of pixels crosses more shadow boundaries than the memory limit allows";
  return 0;
}

//------------------------------------------------------------------------------
int ShadowLists::Fill(const Source& source, const PixelArea& area, int row, int rows)
{
  this->Area = area;
  if (!this->SetTruncationPlanes(source))
  {
    return 0;
  }
  source.Distances->Activate();
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_CLAMP);
  // Lenient: what the depth buffer's rounding leaves open, the shader's own test decides.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-2.0f, -8.0f);
  const int done = this->DrawRows(source, row, rows);
  glPolygonOffset(0.0f, 0.0f);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
  state->vtkglDepthMask(GL_TRUE);
  source.Distances->Deactivate();
  return done;
}

//------------------------------------------------------------------------------
bool ShadowLists::FillNodes(
  vtkOpenGLRenderWindow* window, const Source& source, const FroxelNodes& nodes)
{
  this->Window = window;
  if (!this->SetTruncationPlanes(source))
  {
    return false;
  }
  const std::string fragment =
    "#define AIRLIGHT_SHADOW_TRANSMITTANCE 1\n#define AIRLIGHT_FROXELS\n" +
    FroxelNodes::GetSource() + "#define AIRLIGHT_PARALLEL " +
    std::to_string(source.Rays.IsParallel()) + "\n#define AIRLIGHT_FRAGMENT_IS_PIXEL\n" +
    AirlightCameraShader + AirlightPlanesFS;
  source.Distances->Activate();
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_CLAMP);
  bool ok = true;
  for (PlaneKind kind : { PlaneKind::Plane, PlaneKind::Cap, PlaneKind::Near })
  {
    vtkShaderProgram* program = ok && !this->Planes.IsEmpty(kind, source.LightNumber)
      ? this->GetPlanesProgram(kind, fragment, source)
      : nullptr;
    ok = ok && (program || this->Planes.IsEmpty(kind, source.LightNumber));
    if (program)
    {
      program->SetUniformi("distances", source.Distances->GetTextureUnit());
      program->SetUniformi("inParallel", source.Rays.IsParallel() ? 1 : 0);
      nodes.Use(program, source.LightNumber);
      this->Planes.Draw(kind, source.LightNumber);
    }
  }
  glDisable(GL_DEPTH_CLAMP);
  source.Distances->Deactivate();
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return ok;
}

//------------------------------------------------------------------------------
bool ShadowLists::DrawWireframe(const Source& source)
{
  vtkShaderProgram* program = this->GetPlanesProgram(PlaneKind::Plane, AirlightOutlineFS, source);
  if (!program || !this->SetTruncationPlanes(source))
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  glEnable(GL_DEPTH_CLAMP);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  this->Planes.Draw(PlaneKind::Plane, source.LightNumber);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_DEPTH_CLAMP);
  state->vtkglDepthMask(GL_TRUE);
  return true;
}

//------------------------------------------------------------------------------
int ShadowLists::GetLongDraws()
{
  if (!this->HasKBuffer())
  {
    this->Longest = this->Store.ReadCounts().Longest;
  }
  return BoundarySort::CountLongDraws(this->Longest);
}

//------------------------------------------------------------------------------
bool ShadowLists::Sort()
{
  const bool ok = this->Sorting.Sort(this->Filled, this->Longest);
  this->Error = ok ? this->Error : this->Sorting.GetError();
  return ok;
}

//------------------------------------------------------------------------------
void ShadowLists::Release()
{
  this->Store.Release();
  this->Planes.Release();
  this->Sorting.Release();
}
}
