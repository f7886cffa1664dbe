// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightPass.h"

#include "Frame/AirlightExposureMeter.h"
#include "Medium/AirlightMediaMethods.h"
#include "Pass/AirlightPassRenderer.h"
#include "Photometry/AirlightLightProperties.h"
#include "Scene/AirlightCasterKeys.h"
#include "vtkAirlightLight.h"

#include "vtkCommand.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace airlight;

vtkStandardNewMacro(vtkAirlightPass);

//------------------------------------------------------------------------------
vtkAirlightPass::vtkAirlightPass()
  : Impl(std::make_unique<PassRenderer>(this,
      SceneStages::RenderHooks{ [this](const vtkRenderState* s) { this->PreRender(s); },
        [this](const vtkRenderState* s) { this->PostRender(s); } }))
{
  // Into which VTK draws volumes of lower resolution.
  this->ActiveDrawBuffers = 1;
}

vtkAirlightPass::~vtkAirlightPass() = default;

//------------------------------------------------------------------------------
AirlightMediaMethodsMacro(vtkAirlightPass);

namespace
{
bool HasInput(vtkRenderWindow* window)
{
  return window->GetInteractor() && !window->GetOffScreenRendering() && window->GetEventPending();
}

// Sets a property that has values from 0 to `last`; an error names them for any other.
void SetChoice(
  vtkObject* self, const char* property, int& member, int value, int last, const char* choices)
{
  if (value < 0 || value > last)
  {
    vtkErrorWithObjectMacro(
      self, << property << " " << value << " is none of its values: use " << choices << ".");
    return;
  }
  if (member != value)
  {
    member = value;
    self->Modified();
  }
}
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetShadowTechnique(int technique)
{
  SetChoice(this, "ShadowTechnique", this->ShadowTechnique, technique, RAY_MARCH,
    "NONE, SHADOW_PLANES, SHADOW_MAP, RAY_MARCH or AUTOMATIC");
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetDebugView(int view)
{
  SetChoice(this, "DebugView", this->DebugView, view, OUTLINES,
    "SHADED, AIRLIGHT_ONLY, BOUNDARY_COUNT or OUTLINES");
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetToneMapping(int curve)
{
  SetChoice(this, "ToneMapping", this->ToneMapping, curve, NEUTRAL_PBR,
    "CLAMP, REINHARD, EXPONENTIAL, GENERIC_FILMIC or NEUTRAL_PBR");
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetOutputColorSpace(int space)
{
  SetChoice(
    this, "OutputColorSpace", this->OutputColorSpace, space, SRGB, "LINEAR, GAMMA_2_2 or SRGB");
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetEncodedOutput(bool encoded)
{
  this->SetOutputColorSpace(encoded ? GAMMA_2_2 : LINEAR);
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetExposure(double exposure)
{
  if (!(exposure >= 1e-30) || !(exposure <= 1e30))
  {
    vtkErrorMacro(<< "Exposure " << exposure << " must be from 1e-30 to 1e30; it stays "
                  << this->Exposure << ".");
    return;
  }
  if (this->Exposure != exposure)
  {
    this->Exposure = exposure;
    this->Modified();
  }
}

double vtkAirlightPass::GetEffectiveExposure() { return this->Impl->GetEffectiveExposure(); }

//------------------------------------------------------------------------------
void vtkAirlightPass::SetShadowMapResolution(int resolution)
{
  if (resolution < 16 || resolution > 8192)
  {
    vtkErrorMacro(<< "ShadowMapResolution " << resolution << " must be from 16 to 8192; it stays "
                  << this->ShadowMapResolution << ".");
    return;
  }
  if (this->ShadowMapResolution != resolution)
  {
    this->ShadowMapResolution = resolution;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetMaximumBoundariesPerPixel(double boundaries)
{
  if (!(boundaries >= 0.0))
  {
    vtkErrorMacro(<< "MaximumBoundariesPerPixel " << boundaries << " must not be below 0; it stays "
                  << this->MaximumBoundariesPerPixel << ".");
    return;
  }
  if (this->MaximumBoundariesPerPixel != boundaries)
  {
    this->MaximumBoundariesPerPixel = boundaries;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetNumberOfSteps(int steps)
{
  if (steps < 1 || steps > 2048)
  {
    vtkErrorMacro(<< "NumberOfSteps " << steps << " must be from 1 to 2048; it stays "
                  << this->NumberOfSteps << ".");
    return;
  }
  if (this->NumberOfSteps != steps)
  {
    this->NumberOfSteps = steps;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkAirlightPass::CASTS_SHADOW() { return GetCastsShadowKey(); }

vtkInformationIntegerKey* vtkAirlightPass::VOLUME_SCATTERS() { return GetVolumeScattersKey(); }

vtkInformationObjectBaseKey* vtkAirlightPass::VOLUME_PHASE_FUNCTION()
{
  return GetVolumePhaseFunctionKey();
}

vtkInformationDoubleVectorKey* vtkAirlightPass::SHADOW_OPACITY() { return GetShadowOpacityKey(); }

//------------------------------------------------------------------------------
void vtkAirlightPass::SetCastsShadow(vtkProp* prop, bool casts)
{
  if (!prop)
  {
    vtkErrorWithObjectMacro(nullptr, "SetCastsShadow() needs a prop; it got null.");
    return;
  }
  airlight::SetCastsShadow(prop, casts);
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetVolumeScatters(vtkVolume* volume, bool scatters)
{
  if (!volume)
  {
    vtkErrorWithObjectMacro(nullptr, "SetVolumeScatters() needs a volume; it got null.");
    return;
  }
  airlight::SetVolumeScatters(volume, scatters);
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetVolumePhaseFunction(vtkVolume* volume, vtkPhaseFunction* function)
{
  if (!volume)
  {
    vtkErrorWithObjectMacro(nullptr, "SetVolumePhaseFunction() needs a volume; it got null.");
    return;
  }
  airlight::SetVolumePhaseFunction(volume, function);
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetShadowOpacity(vtkProp* prop, double red, double green, double blue)
{
  if (!prop)
  {
    vtkErrorWithObjectMacro(nullptr, "SetShadowOpacity() needs a prop; it got null.");
    return;
  }
  const std::string error = airlight::SetShadowOpacity(prop, { red, green, blue });
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(prop, << error);
  }
}

//------------------------------------------------------------------------------
int vtkAirlightPass::GetEffectiveShadowTechnique()
{
  return static_cast<int>(this->Impl->GetFrame().GetTechnique());
}

int vtkAirlightPass::GetEffectiveShadowTechnique(vtkLight* light)
{
  return static_cast<int>(this->Impl->GetFrame().GetTechnique(light));
}

//------------------------------------------------------------------------------
int vtkAirlightPass::GetAccumulatedFrames() { return this->Impl->GetAccumulatedFrames(); }

//------------------------------------------------------------------------------
vtkImageData* vtkAirlightPass::GetBuffer(const char* name)
{
  return name ? this->Impl->GetFrame().GetBuffer(name) : nullptr;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAirlightPass::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkParticipatingMedium* medium : this->Impl->Media.GetAll())
  {
    time = std::max(time, medium->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  PassRenderer::Viewport viewport;
  if (vtkFrameBufferObjectBase* target = s->GetFrameBuffer())
  {
    target->GetLastSize(viewport.Width, viewport.Height);
  }
  else
  {
    s->GetRenderer()->GetTiledSizeAndOrigin(
      &viewport.Width, &viewport.Height, &viewport.X, &viewport.Y);
  }
  if (viewport.Width < 1 || viewport.Height < 1)
  {
    return;
  }
  PassRenderer::Settings settings;
  settings.LightRadius = this->LightRadius;
  vtkRenderWindow* window = s->GetRenderer()->GetRenderWindow();
  settings.SubpixelFrames = IsMoving(window) ? 1 : this->SubpixelFrames;
  settings.Multisampling = this->Multisampling && window->GetMultiSamples() > 1;
  settings.Progressive = this->ProgressiveRefinement;
  vtkRenderWindowInteractor* interactor = window->GetInteractor();
  const bool hasTimers = interactor && interactor->GetInitialized();
  settings.Requested = this->Impl->GetIdle().TakeRinging() || !hasTimers;
  settings.Progress = [this, window](double done) {
    this->InvokeEvent(vtkCommand::ProgressEvent, &done);
    return window->CheckAbortStatus() == 0 && !HasInput(window);
  };
  settings.Environment = this->UseEnvironmentTexture;
  settings.Delegate = this->DelegatePass;
  settings.ChoosePixels = this->ChoosePixels;
  PassProperties& properties = settings.Properties;
  properties.Technique = static_cast<airlight::ShadowTechnique>(this->ShadowTechnique);
  properties.View = static_cast<airlight::DebugView>(this->DebugView);
  properties.MapResolution = this->ShadowMapResolution;
  properties.MaximumBoundaries = this->MaximumBoundariesPerPixel;
  properties.Steps = this->NumberOfSteps;
  properties.SurfaceShadows = this->SurfaceShadows;
  properties.TranslucentShadows = this->TranslucentShadows;
  properties.VolumeShadows = this->VolumeShadows;
  properties.ScatteredSurfaceLight = this->ScatteredSurfaceLight;
  properties.LinearInput = this->LinearInput;
  properties.Display = this->GetDisplay(s);
  properties.AutomaticExposure = this->AutomaticExposure;
  properties.Annotations = this->Annotations;
  properties.RecordBuffers = this->RecordBuffers;
  properties.MemoryLimit = static_cast<std::uint64_t>(this->MemoryLimit) << 20;
  this->Impl->Render(s, settings, viewport);
  this->NumberOfRenderedProps = this->Impl->GetStages().GetPasses().GetNumberOfRenderedProps();
  if (interactor && this->Impl->IsUnfinished())
  {
    this->Impl->GetIdle().Request(interactor);
  }
  else
  {
    this->Impl->GetIdle().Cancel();
  }
}

//------------------------------------------------------------------------------
// A pass outside reads colours as numbers, to which nothing is to be added. The pattern begins at
// the renderer's corner, which in tiles may be outside of what is drawn.
DisplayStage vtkAirlightPass::GetDisplay(const vtkRenderState* s) const
{
  DisplayStage display;
  display.Exposure = this->Exposure;
  display.Curve = static_cast<airlight::ToneMapping>(this->ToneMapping);
  display.Space = static_cast<airlight::ColorSpace>(this->OutputColorSpace);
  display.Dithering = this->Dithering && !s->GetFrameBuffer();
  vtkRenderWindow* window = s->GetRenderer()->GetRenderWindow();
  int corner[2];
  for (int i = 0; i < 2; ++i)
  {
    const double size = window->GetTileScale()[i] * window->GetActualSize()[i];
    corner[i] = static_cast<int>(std::lround(s->GetRenderer()->GetViewport()[i] * size) -
      std::lround(window->GetTileViewport()[i] * size));
  }
  display.X = corner[0];
  display.Y = corner[1];
  return display;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  MapperHooks::MarkShader(fragmentShader, prop);
  return true;
}

bool vtkAirlightPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  this->Impl->GetMappers().ChangeShader(vertexShader, geometryShader, fragmentShader, mapper, prop);
  return true;
}

bool vtkAirlightPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  this->Impl->GetStages().SetUniforms(program, mapper, prop);
  return true;
}

vtkMTimeType vtkAirlightPass::GetShaderStageMTime() { return this->Impl->GetMappers().GetTime(); }

//------------------------------------------------------------------------------
void vtkAirlightPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Superclass::ReleaseGraphicsResources(w);
  // In whichever window they are.
  this->Impl->Release();
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetLightScatters(vtkLight* light, bool scatters)
{
  if (!light)
  {
    vtkErrorMacro("SetLightScatters() needs a light; it got null.");
    return;
  }
  const vtkMTimeType time = light->GetMTime();
  vtkAirlightLight::SetScatters(light, scatters);
  if (light->GetMTime() != time)
  {
    this->Modified();
  }
}

bool vtkAirlightPass::GetLightScatters(vtkLight* light)
{
  return vtkAirlightLight::GetScatters(light);
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::SetLightPhotometry(vtkLight* light, const char* file)
{
  if (!light)
  {
    vtkErrorMacro("SetLightPhotometry() needs a light; it got null.");
    return false;
  }
  const std::string error = airlight::SetPhotometry(light, file);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return false;
  }
  this->Modified();
  return true;
}

const char* vtkAirlightPass::GetLightPhotometry(vtkLight* light)
{
  return vtkAirlightLight::GetPhotometry(light);
}

double vtkAirlightPass::GetLightPhotometryMaximum(vtkLight* light)
{
  return vtkAirlightLight::GetPhotometryMaximum(light);
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetLightPhotometryUp(vtkLight* light, double x, double y, double z)
{
  if (!light)
  {
    vtkErrorMacro("SetLightPhotometryUp() needs a light; it got null.");
    return;
  }
  const std::string error = airlight::SetPhotometryUp(light, { x, y, z });
  if (!error.empty())
  {
    vtkErrorMacro(<< "SetLightPhotometryUp(): " << error);
    return;
  }
  this->Modified();
}

void vtkAirlightPass::GetLightPhotometryUp(vtkLight* light, double up[3])
{
  vtkAirlightLight::GetPhotometryUp(light, up);
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::GetSilhouettes(vtkRenderer* renderer, vtkUnsignedCharArray* silhouettes)
{
  if (silhouettes)
  {
    silhouettes->Initialize();
  }
  if (!renderer || !renderer->GetRenderWindow() || !silhouettes)
  {
    vtkErrorMacro("GetSilhouettes() needs a renderer in a window, and an array; it got "
      << (renderer ? "a renderer" : "null")
      << (renderer && !renderer->GetRenderWindow() ? " without a window" : "") << " and "
      << (silhouettes ? "an array." : "null."));
    return false;
  }
  std::vector<unsigned char> bytes;
  std::string error;
  if (!this->Impl->CollectSilhouettes(renderer, this->LightRadius, bytes, error))
  {
    vtkErrorMacro("GetSilhouettes() found none: " << error << ". Set another camera.");
    return false;
  }
  silhouettes->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), silhouettes->GetPointer(0));
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::AddRemoteSilhouettes(vtkUnsignedCharArray* silhouettes)
{
  if (!silhouettes)
  {
    vtkErrorMacro("AddRemoteSilhouettes() needs an array that GetSilhouettes() has filled; it got "
                  "null.");
    return false;
  }
  const auto size = static_cast<size_t>(silhouettes->GetNumberOfValues());
  ProcessSilhouettes shadows;
  std::string error;
  if (!ReadSilhouettes(size > 0 ? silhouettes->GetPointer(0) : nullptr, size, shadows, error))
  {
    vtkErrorMacro("AddRemoteSilhouettes() does not take these "
      << size << " bytes: " << error
      << ". Send what GetSilhouettes() makes, whole, to a process of the same kind of machine.");
    return false;
  }
  this->Impl->GetFrame().AddRemoteSilhouettes(shadows);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkAirlightPass::RemoveAllRemoteSilhouettes()
{
  if (this->Impl->GetFrame().HasRemoteSilhouettes())
  {
    this->Impl->GetFrame().RemoveAllRemoteSilhouettes();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetPixelChooser(const PixelChooser& chooser)
{
  this->ChoosePixels = chooser;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkAirlightPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMedia: " << this->GetNumberOfMedia() << "\n";
  for (vtkParticipatingMedium* medium : this->Impl->Media.GetAll())
  {
    medium->PrintSelf(os, indent.GetNextIndent());
  }
  const char* techniques[] = { "None", "ShadowPlanes", "Automatic", "ShadowMap", "RayMarch",
    "Froxels" };
  os << indent << "ShadowTechnique: " << techniques[this->ShadowTechnique] << "\n";
  os << indent << "EffectiveShadowTechnique: " << techniques[this->GetEffectiveShadowTechnique()]
     << "\n";
  os << indent << "ShadowMapResolution: " << this->ShadowMapResolution << "\n";
  os << indent << "MaximumBoundariesPerPixel: " << this->MaximumBoundariesPerPixel << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "SurfaceShadows: " << this->SurfaceShadows << "\n";
  os << indent << "TranslucentShadows: " << this->TranslucentShadows << "\n";
  os << indent << "VolumeShadows: " << this->VolumeShadows << "\n";
  os << indent << "ScatteredSurfaceLight: " << this->ScatteredSurfaceLight << "\n";
  os << indent << "UseEnvironmentTexture: " << this->UseEnvironmentTexture << "\n";
  os << indent << "LinearInput: " << this->LinearInput << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "AutomaticExposure: " << this->AutomaticExposure << "\n";
  const char* curves[] = { "Clamp", "Reinhard", "Exponential", "GenericFilmic", "NeutralPBR" };
  os << indent << "ToneMapping: " << curves[this->ToneMapping] << "\n";
  const char* spaces[] = { "Linear", "Gamma22", "SRGB" };
  os << indent << "OutputColorSpace: " << spaces[this->OutputColorSpace] << "\n";
  os << indent << "Dithering: " << this->Dithering << "\n";
  os << indent << "Annotations: " << this->Annotations << "\n";
  const char* views[] = { "Shaded", "AirlightOnly", "BoundaryCount", "ShadowPlaneOutlines" };
  os << indent << "DebugView: " << views[this->DebugView] << "\n";
  os << indent << "LightRadius: " << this->LightRadius << "\n";
  os << indent << "SubpixelFrames: " << this->SubpixelFrames << "\n";
  os << indent << "Multisampling: " << this->Multisampling << "\n";
  os << indent << "ProgressiveRefinement: " << this->ProgressiveRefinement << "\n";
  os << indent << "AccumulatedFrames: " << this->GetAccumulatedFrames() << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "RecordBuffers: " << this->RecordBuffers << "\n";
}
