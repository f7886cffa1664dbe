// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightPass.h"

#include "AirlightFrame.h"
#include "AirlightOpenGL.h"
#include "AirlightScenePass.h"

#include "vtkCameraPass.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOverlayPass.h"
#include "vtkParticipatingMedium.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace airlight;

vtkStandardNewMacro(vtkAirlightPass);
vtkInformationKeyMacro(vtkAirlightPass, CASTS_SHADOW, Integer);

//------------------------------------------------------------------------------
class vtkAirlightPass::Internals
{
public:
  explicit Internals(vtkAirlightPass* self)
    : Self(self)
  {
  }

  // Draws the scene as if the pass were not there.
  void RenderPlain(const vtkRenderState* s);

  // The whole frame. False with a reason in Error where it could not be done.
  bool RenderFrame(const vtkRenderState* s, int x, int y, int width, int height);

  void WarnOnce(bool& warned, const std::string& text);
  void CheckMedia();
  void CheckLamps(const std::vector<Lamp>& lamps);
  int ChooseTechnique(vtkOpenGLRenderWindow* window);

  vtkAirlightPass* Self;
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> Media;
  Frame CurrentFrame;
  SurfaceStage Stage = SurfaceStage::Colour;
  int EffectiveTechnique = NONE;
  int LampCapacity = 4; // array size in the mappers' shaders
  std::string SurfaceSource;
  vtkTimeStamp ShaderTime;
  std::string Error;

  vtkNew<AirlightScenePass> ScenePass;
  vtkNew<vtkCameraPass> CameraPass;
  vtkNew<vtkOpaquePass> OpaquePass;
  vtkNew<vtkOverlayPass> OverlayPass;
  vtkNew<vtkParticipatingMedium> Vacuum;

  bool WarnedOpenGL = false;
  bool WarnedMedia = false;
  bool WarnedLights = false;
  bool WarnedLightCount = false;
  std::string ReportedError;

private:
  bool RenderSteps(const vtkRenderState* s);
  void UpdateSurfaceShader(const f64::AirlightMedia& media, int lampCount);
  vtkRenderPass* GetDelegate();
};

//------------------------------------------------------------------------------
vtkRenderPass* vtkAirlightPass::Internals::GetDelegate()
{
  if (this->Self->DelegatePass)
  {
    return this->Self->DelegatePass;
  }
  this->CameraPass->SetDelegatePass(this->ScenePass);
  return this->CameraPass;
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::RenderPlain(const vtkRenderState* s)
{
  vtkRenderPass* delegate = this->GetDelegate();
  delegate->Render(s);
  this->Self->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::WarnOnce(bool& warned, const std::string& text)
{
  if (!warned)
  {
    warned = true;
    vtkWarningWithObjectMacro(this->Self, << text);
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::CheckMedia()
{
  if (this->Media.size() > AIRLIGHT_MAX_MEDIA && !this->WarnedMedia)
  {
    this->WarnedMedia = true;
    vtkErrorWithObjectMacro(this->Self,
      "There are " << this->Media.size() << " media and at most " << AIRLIGHT_MAX_MEDIA
                   << " are drawn: the first ones are. Call RemoveMedium() for those not needed.");
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::CheckLamps(const std::vector<Lamp>& lamps)
{
  for (const Lamp& lamp : lamps)
  {
    if (lamp.Support == LightSupport::Invalid)
    {
      this->WarnOnce(this->WarnedLights,
        "A light is left out of the medium: its position, colour and attenuation must be finite, "
        "its attenuation at least 0 with one term above 0, its exponent at least 0, and the focal "
        "point of a spot or a directional light apart from its position.");
    }
  }
  if (static_cast<int>(lamps.size()) > MaximumShadowingLights)
  {
    this->WarnOnce(this->WarnedLightCount,
      "There are " + std::to_string(lamps.size()) + " lights; those after the first " +
        std::to_string(MaximumShadowingLights) + " cast no shadows on surfaces.");
  }
}

//------------------------------------------------------------------------------
int vtkAirlightPass::Internals::ChooseTechnique(vtkOpenGLRenderWindow* window)
{
  if (this->Self->ShadowTechnique == NONE)
  {
    return NONE;
  }
  if (ShadowLists::IsSupported(window))
  {
    return SHADOW_PLANES;
  }
  const std::string text =
    "Shadow planes need OpenGL 4.3 with storage buffers, which this window lacks: the picture has "
    "airlight and no shadows. Update the graphics driver, or call SetShadowTechniqueToNone().";
  if (this->Self->ShadowTechnique == SHADOW_PLANES && !this->WarnedOpenGL)
  {
    this->WarnedOpenGL = true;
    vtkErrorWithObjectMacro(this->Self, << text);
  }
  this->WarnOnce(this->WarnedOpenGL, text);
  return NONE;
}

//------------------------------------------------------------------------------
// The text added to the mappers' shaders depends on the numbers of lights and media.
void vtkAirlightPass::Internals::UpdateSurfaceShader(const f64::AirlightMedia& media, int lampCount)
{
  const std::string source = GetScatteringSource(media, AIRLIGHT_POINT_CLOSED);
  if (lampCount > this->LampCapacity || source != this->SurfaceSource)
  {
    this->LampCapacity = std::max(this->LampCapacity, 2 * lampCount);
    this->SurfaceSource = source;
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::RenderFrame(
  const vtkRenderState* s, int x, int y, int width, int height)
{
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  renderer->GetActiveCamera(); // makes one where there is none
  this->ScenePass->PrepareLights(renderer);

  const View view(renderer, width, height);
  if (!view.IsValid())
  {
    this->Error = "the camera's matrices are not finite or cannot be inverted";
    return false;
  }
  std::vector<vtkParticipatingMedium*> media(this->Media.begin(), this->Media.end());
  if (media.empty())
  {
    media.push_back(this->Vacuum);
  }
  const f64::AirlightMedia converted = ConvertMedia(media, view.GetEye());
  const std::vector<Lamp> lamps = CollectLamps(renderer, converted, view, this->Self->LightRadius);
  this->CheckLamps(lamps);
  this->UpdateSurfaceShader(converted, static_cast<int>(lamps.size()));

  this->EffectiveTechnique = this->ChooseTechnique(window);
  FrameSettings settings;
  settings.Shadows = this->EffectiveTechnique == SHADOW_PLANES;
  settings.SurfaceShadows = this->Self->SurfaceShadows;
  settings.Record = this->Self->RecordBuffers;
  settings.LightRadius = this->Self->LightRadius;
  settings.MemoryLimit = static_cast<std::uint64_t>(this->Self->MemoryLimit) << 20;

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewportSaver(state);
  vtkOpenGLState::ScopedglScissor scissorSaver(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthSaver(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullSaver(state, GL_CULL_FACE);
  state->PushFramebufferBindings();
  const bool ok =
    this->CurrentFrame.Begin(renderer, converted, lamps, view, settings, width, height) &&
    this->RenderSteps(s);
  state->PopFramebufferBindings();
  if (!ok)
  {
    this->Error = this->CurrentFrame.GetError();
    return false;
  }
  if (!this->CurrentFrame.Composite(
        x, y, renderer->GetPreserveColorBuffer() || renderer->Transparent()))
  {
    this->Error = this->CurrentFrame.GetError();
    return false;
  }
  // Annotations were drawn with the scene and fogged; drawn again they are not.
  this->OverlayPass->Render(s);
  return true;
}

//------------------------------------------------------------------------------
// The steps inside the pass's own framebuffer.
bool vtkAirlightPass::Internals::RenderSteps(const vtkRenderState* s)
{
  vtkRenderState inner(s->GetRenderer());
  inner.SetPropArrayAndCount(s->GetPropArray(), s->GetPropArrayCount());
  inner.SetFrameBuffer(this->CurrentFrame.GetFramebuffer());

  vtkTextureObject* lit = this->CurrentFrame.GetSurfaceUniforms(SurfaceStage::Colour).Lit;
  this->Self->PreRender(s);
  lit->Activate();
  this->Stage = SurfaceStage::Distance;
  bool ok = this->CurrentFrame.BindDistances();
  if (ok)
  {
    this->OpaquePass->Render(&inner);
  }
  lit->Deactivate();
  ok = ok && this->CurrentFrame.ScatterLights() && this->CurrentFrame.BindScene();
  this->Stage = SurfaceStage::Colour;
  if (ok)
  {
    lit->Activate();
    vtkRenderPass* delegate = this->GetDelegate();
    delegate->Render(&inner);
    this->Self->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
    lit->Deactivate();
  }
  this->Self->PostRender(s);
  return ok && (!this->Self->RecordBuffers || this->CurrentFrame.Record());
}

//------------------------------------------------------------------------------
vtkAirlightPass::vtkAirlightPass()
  : Impl(new Internals(this))
{
}

vtkAirlightPass::~vtkAirlightPass() = default;

//------------------------------------------------------------------------------
void vtkAirlightPass::AddMedium(vtkParticipatingMedium* medium)
{
  auto& media = this->Impl->Media;
  if (medium && std::find(media.begin(), media.end(), medium) == media.end())
  {
    media.emplace_back(medium);
    this->Modified();
  }
}

void vtkAirlightPass::RemoveMedium(vtkParticipatingMedium* medium)
{
  auto& media = this->Impl->Media;
  const auto it = std::find(media.begin(), media.end(), medium);
  if (it != media.end())
  {
    media.erase(it);
    this->Modified();
  }
}

void vtkAirlightPass::RemoveAllMedia()
{
  if (!this->Impl->Media.empty())
  {
    this->Impl->Media.clear();
    this->Modified();
  }
}

void vtkAirlightPass::SetMedium(vtkParticipatingMedium* medium)
{
  if (this->GetNumberOfMedia() == 1 && this->GetMedium(0) == medium)
  {
    return;
  }
  this->RemoveAllMedia();
  this->AddMedium(medium);
}

int vtkAirlightPass::GetNumberOfMedia() { return static_cast<int>(this->Impl->Media.size()); }

vtkParticipatingMedium* vtkAirlightPass::GetMedium(int index)
{
  if (index < 0 || index >= this->GetNumberOfMedia())
  {
    vtkErrorMacro(<< "Medium " << index << " does not exist: there are " << this->GetNumberOfMedia()
                  << ".");
    return nullptr;
  }
  return this->Impl->Media[index];
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetShadowTechnique(int technique)
{
  if (technique < NONE || technique > AUTOMATIC)
  {
    vtkErrorMacro(<< "ShadowTechnique " << technique
                  << " is not a technique: use NONE, SHADOW_PLANES or AUTOMATIC.");
    return;
  }
  if (this->ShadowTechnique != technique)
  {
    this->ShadowTechnique = technique;
    this->Modified();
  }
}

int vtkAirlightPass::GetEffectiveShadowTechnique() { return this->Impl->EffectiveTechnique; }

//------------------------------------------------------------------------------
void vtkAirlightPass::SetLightRadius(double radius)
{
  if (!std::isfinite(radius) || radius < 0.0)
  {
    vtkErrorMacro(<< "LightRadius " << radius << " must be finite and at least 0; it stays "
                  << this->LightRadius << ".");
    return;
  }
  if (this->LightRadius != radius)
  {
    this->LightRadius = radius;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkAirlightPass::GetBuffer(const char* name)
{
  return name ? this->Impl->CurrentFrame.GetBuffer(name) : nullptr;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAirlightPass::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& medium : this->Impl->Media)
  {
    time = std::max(time, medium->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  vtkRenderer* renderer = s->GetRenderer();
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  if (vtkFrameBufferObjectBase* target = s->GetFrameBuffer())
  {
    target->GetLastSize(width, height);
  }
  else
  {
    renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  }
  if (width < 1 || height < 1)
  {
    return;
  }
  // Picking reads colours as numbers: nothing may change them.
  if (renderer->GetSelector())
  {
    this->Impl->RenderPlain(s);
    return;
  }
  this->Impl->CheckMedia();
  if (this->Impl->RenderFrame(s, x, y, width, height))
  {
    this->Impl->ReportedError.clear();
    return;
  }
  if (this->Impl->ReportedError != this->Impl->Error)
  {
    this->Impl->ReportedError = this->Impl->Error;
    vtkErrorMacro(<< "The scene is drawn without the medium: " << this->Impl->Error << ".");
  }
  this->Impl->RenderPlain(s);
}

//------------------------------------------------------------------------------
void vtkAirlightPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Superclass::ReleaseGraphicsResources(w);
  this->Impl->CurrentFrame.Release(w);
  this->Impl->CameraPass->ReleaseGraphicsResources(w);
  this->Impl->OpaquePass->ReleaseGraphicsResources(w);
  this->Impl->OverlayPass->ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  InjectSurfaceShader(fragmentShader, this->Impl->LampCapacity, this->Impl->SurfaceSource);
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  SurfaceUniforms values = this->Impl->CurrentFrame.GetSurfaceUniforms(this->Impl->Stage);
  // The bits are those of the opaque surface, which lies behind a translucent one.
  values.UseLit = values.UseLit && !prop->HasTranslucentPolygonalGeometry();
  SetSurfaceUniforms(program, values);
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAirlightPass::GetShaderStageMTime() { return this->Impl->ShaderTime; }

//------------------------------------------------------------------------------
void vtkAirlightPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMedia: " << this->GetNumberOfMedia() << "\n";
  for (const auto& medium : this->Impl->Media)
  {
    medium->PrintSelf(os, indent.GetNextIndent());
  }
  const char* techniques[] = { "None", "ShadowPlanes", "Automatic" };
  os << indent << "ShadowTechnique: " << techniques[this->ShadowTechnique] << "\n";
  os << indent << "EffectiveShadowTechnique: " << techniques[this->GetEffectiveShadowTechnique()]
     << "\n";
  os << indent << "SurfaceShadows: " << this->SurfaceShadows << "\n";
  os << indent << "LightRadius: " << this->LightRadius << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "RecordBuffers: " << this->RecordBuffers << "\n";
}
