// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightPolyDataMapperShader.h"

#include "Integration/AirlightMembers.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Shaders that are too large do not link, and VTK's mappers do not survive that. Counts, from
// above, what members of structures take where each has a register of four components.
bool HasRoom(const SurfaceShaderOptions& options, const f64::AirlightMedia& media)
{
  const int perMedium = HasSky(media) ? 128 + 60 : 128;
  GLint fragment = 0;
  GLint vertex = 0;
  glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &fragment);
  glGetIntegerv(GL_MAX_VERTEX_UNIFORM_COMPONENTS, &vertex);
  return 256 + perMedium * media.count + 72 * options.SceneLightCount <= std::min(fragment, vertex);
}
}

//------------------------------------------------------------------------------
void PolyDataMapperShader::SetWindow(vtkOpenGLRenderWindow* window)
{
  if (this->Window && this->Window != window)
  {
    this->Window->PushContext();
    this->Arrays.Release(this->Window);
    this->Window->PopContext();
  }
  this->Window = window;
}

//------------------------------------------------------------------------------
bool PolyDataMapperShader::Prepare(vtkRenderer* renderer, double radius)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  // The target may be a texture, in which the viewport begins elsewhere than in the window.
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport);
  this->Rays.emplace(renderer, this->Viewport[2], this->Viewport[3]);
  if (!this->Rays->IsValid())
  {
    this->Error = "the camera's matrices are not finite or cannot be inverted";
    return false;
  }
  this->Error = this->Media.CheckDensities();
  if (!this->Error.empty())
  {
    return false;
  }
  const std::vector<vtkParticipatingMedium*> media = this->Media.GetAll();
  this->Converted = ConvertMedia(media, this->Rays->GetEye());
  this->SceneLights = CollectSceneLights(renderer, this->Converted, *this->Rays, radius, false);
  this->ScatteredOnce = AddMultipleLamps(this->SceneLights, this->Converted);
  if (!this->Arrays.Upload(window, { media, {} }, this->Converted, this->SceneLights))
  {
    this->Error = this->Arrays.GetError();
    return false;
  }
  if (UpdateSurfaceShaderOptions(this->Options, this->Converted, this->SceneLights, false, true))
  {
    ++this->OptionsVersion;
  }
  if (!HasRoom(this->Options, this->Converted))
  {
    this->Error = "the graphics card's shaders have no room for " +
      std::to_string(this->SceneLights.size()) + " lights and " +
      std::to_string(this->Converted.count) + " media; switch lights off or use a vtkAirlightPass";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool PolyDataMapperShader::Compiles(
  vtkActor* actor, const std::string& vertex, std::string& fragment, const std::string& geometry)
{
  const bool ok = !IsLastToChange(nullptr, actor) ||
    this->Programs.GetOrCompile(this->Window, vertex, fragment, geometry);
  this->NotCompiled = this->NotCompiled || !ok;
  return ok;
}

//------------------------------------------------------------------------------
void PolyDataMapperShader::CheckShaders(vtkObject* mapper)
{
  if (this->NotCompiled && !this->ReportedShaders)
  {
    vtkErrorWithObjectMacro(mapper,
      << "The surface is drawn without the medium: its shader" << ProgramMaker::GetReason() << ".");
  }
  this->ReportedShaders = this->NotCompiled;
}

//------------------------------------------------------------------------------
void PolyDataMapperShader::Check(vtkObject* mapper)
{
  const std::string tooMany = this->Media.Check();
  if (!tooMany.empty() && !this->WarnedMedia)
  {
    this->WarnedMedia = true;
    vtkErrorWithObjectMacro(mapper, << tooMany);
  }
  if (!this->Shades && this->ReportedError != this->Error)
  {
    vtkErrorWithObjectMacro(
      mapper, << "The surface is drawn without the medium: " << this->Error << ".");
  }
  this->ReportedError = this->Shades ? "" : this->Error;
  const bool invalid = this->Shades &&
    std::any_of(this->SceneLights.begin(), this->SceneLights.end(),
      [](const SceneLight& sceneLight) { return sceneLight.Support == LightSupport::Invalid; });
  if (invalid && !this->WarnedLights)
  {
    this->WarnedLights = true;
    vtkWarningWithObjectMacro(mapper, << InvalidLightText);
  }
  if (this->Shades && HasScattering(this->Converted) && !this->WarnedCameraLights &&
    std::any_of(this->SceneLights.begin(), this->SceneLights.end(), IsLeftOut))
  {
    this->WarnedCameraLights = true;
    vtkWarningWithObjectMacro(mapper, << DescribeLeftOut(this->SceneLights));
  }
  if (this->Shades && this->ScatteredOnce > 0 && !this->WarnedScatteredOnce)
  {
    this->WarnedScatteredOnce = true;
    vtkWarningWithObjectMacro(mapper, << GetScatteredOnceText(this->ScatteredOnce));
  }
}
}
