// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightPassMessages.h"

#include "Casters/AirlightCasters.h"
#include "MapperShaders/AirlightSurfaceShader.h"
#include "Medium/AirlightMediaList.h"
#include "Pass/AirlightSceneSupport.h"
#include "Photometry/AirlightLightProperties.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkVolume.h"

#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>

namespace airlight
{
namespace
{
// The classes of their mappers, each once.
std::string GetMapperNames(const std::vector<NonPolygonalCaster>& casters)
{
  std::set<std::string> names;
  for (const NonPolygonalCaster& caster : casters)
  {
    names.insert(caster.Actor->GetMapper()->GetClassName());
  }
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

std::string DescribeNonPolygonal(const CasterCache& casters, const FramePlan& plan, bool automatic)
{
  const std::string keep = " Call vtkAirlightPass::SetCastsShadow(prop, false) for props that "
                           "shall not cast";
  return "No shadow planes can be drawn from what the mappers " +
    GetMapperNames(casters.GetNonPolygonal()) + " draw: " +
    (automatic ? std::string(plan.MapNonPolygonal ? "their" : "all") +
          " shadows come from shadow maps, which are less exact." + keep + " to get exact shadows."
               : "it casts none." + keep + ", or call SetShadowTechniqueToShadowMap().");
}
}

//------------------------------------------------------------------------------
bool PassMessages::IsFirst(Message message)
{
  const bool first = !this->Given[message];
  this->Given[message] = true;
  return first;
}

void PassMessages::WarnOnce(Message message, const std::string& text)
{
  if (this->IsFirst(message))
  {
    vtkWarningWithObjectMacro(this->Pass, << text);
  }
}

void PassMessages::ErrorOnce(Message message, const std::string& text)
{
  if (this->IsFirst(message))
  {
    vtkErrorWithObjectMacro(this->Pass, << text);
  }
}

//------------------------------------------------------------------------------
void PassMessages::CheckEnvironment(const std::string& error)
{
  if (this->EnvironmentError != error)
  {
    this->EnvironmentError = error;
    if (!error.empty())
    {
      vtkErrorWithObjectMacro(
        this->Pass, << "The media scatter no light of the environment: " << error << ".");
    }
  }
}

//------------------------------------------------------------------------------
void PassMessages::CheckMedia(const MediaList& media)
{
  const std::string text = media.Check();
  if (!text.empty())
  {
    this->ErrorOnce(Media, text);
  }
}

//------------------------------------------------------------------------------
void PassMessages::CheckLights(
  const std::vector<SceneLight>& sceneLights, bool scattering, bool scatteredSurfaceLight)
{
  if (scattering && std::any_of(sceneLights.begin(), sceneLights.end(), IsLeftOut))
  {
    this->WarnOnce(CameraLights, DescribeLeftOut(sceneLights));
  }
  for (const SceneLight& sceneLight : sceneLights)
  {
    if (sceneLight.Support == LightSupport::Invalid)
    {
      this->WarnOnce(InvalidLights, InvalidLightText);
    }
  }
  for (const SceneLight& sceneLight : sceneLights)
  {
    const LightProperties& properties = GetProperties(sceneLight.Light);
    if (properties.Table && sceneLight.Scatters() && !sceneLight.Table)
    {
      this->WarnOnce(PhotometryUnused,
        "A light's photometric file " + properties.PhotometryFile +
          " is not used: it needs a positional light whose focal point, at which it aims, is apart "
          "from its position.");
    }
  }
  if (static_cast<int>(sceneLights.size()) > MaximumShadowingLights)
  {
    this->WarnOnce(ManyLights,
      "There are " + std::to_string(sceneLights.size()) + " lights; those after the first " +
        std::to_string(MaximumShadowingLights) + " cast no shadows on surfaces.");
  }
  const auto scattered = std::count_if(sceneLights.begin(), sceneLights.end(),
    [](const SceneLight& sceneLight) { return sceneLight.HasPower(); });
  if (scatteredSurfaceLight && scattered > MaximumScatteringLights)
  {
    this->WarnOnce(ManyScatteredLights,
      "The medium scatters " + std::to_string(scattered) + " lights; those after the first " +
        std::to_string(MaximumScatteringLights) + " light surfaces directly only.");
  }
}

//------------------------------------------------------------------------------
void PassMessages::CheckVisibleLights(const std::vector<SceneLight>& sceneLights, vtkCamera* camera,
  const std::vector<vtkParticipatingMedium*>& media)
{
  for (const UnseenLight& light : FindUnseenLights(sceneLights, camera, media))
  {
    if (this->UnseenGiven.insert(light.Reason).second)
    {
      vtkWarningWithObjectMacro(this->Pass, << light.Text);
    }
  }
}

//------------------------------------------------------------------------------
void PassMessages::CheckMultiple(int lightsLeftOut)
{
  if (lightsLeftOut > 0)
  {
    this->WarnOnce(LightsScatteredOnce, GetScatteredOnceText(lightsLeftOut));
  }
}

//------------------------------------------------------------------------------
// VTK's windows encode as they copy a picture onto the screen. What is read back from them, and
// what stays off-screen, is not encoded.
void PassMessages::CheckColorSpace(const DisplayStage& display, vtkOpenGLRenderWindow* window)
{
  if (display.Space != ColorSpace::Linear && window->GetUseSRGBColorSpace() &&
    !window->GetUseOffScreenBuffers())
  {
    this->WarnOnce(EncodedTwice,
      "The window has UseSRGBColorSpace and encodes colours on the screen, and OutputColorSpace "
      "has encoded them before: they look too bright. Call SetOutputColorSpaceToLinear(), or the "
      "window's UseSRGBColorSpaceOff() before it is first drawn.");
  }
}

//------------------------------------------------------------------------------
void PassMessages::CheckPlan(const FramePlan& plan, const PassProperties& properties,
  const CasterCache& casters, vtkOpenGLRenderWindow* window)
{
  const bool automatic = properties.Technique == ShadowTechnique::Automatic;
  if (plan.Reason == TechniqueReason::NoStorageBuffers)
  {
    int major = 0;
    int minor = 0;
    window->GetOpenGLVersion(major, minor);
    const std::string text = "Shadow planes need OpenGL 4.3 with storage buffers, and this " +
      std::string(window->GetClassName()) + " has OpenGL " + std::to_string(major) + "." +
      std::to_string(minor) +
      ": shadows come from shadow maps, which are less exact. Update the graphics driver; without "
      "a screen, draw in a vtkAirlightHeadlessWindow (Python: airlight.headless_window()), which "
      "asks for the newest OpenGL; or call SetShadowTechniqueToShadowMap().";
    automatic ? this->WarnOnce(OldOpenGL, text) : this->ErrorOnce(OldOpenGL, text);
  }
  if (plan.Reason == TechniqueReason::NonPolygonalCasters)
  {
    this->WarnOnce(NonPolygonalCasters, DescribeNonPolygonal(casters, plan, automatic));
  }
  if (plan.Reason == TechniqueReason::PlanesOverMemory)
  {
    this->WarnOnce(PlanesOverMemory,
      "The shadow planes have so many boundaries that the picture would be drawn in very many "
      "parts in the memory limit of " +
        std::to_string(properties.MemoryLimit >> 20) +
        " MiB: shadows come from shadow maps, which are less exact. Raise SetMemoryLimit(), or "
        "call SetShadowTechniqueToShadowMap().");
  }
  if (plan.RecordsOverMemory)
  {
    this->WarnOnce(RecordsOverMemory,
      "There are more translucent fragments than a buffer of the graphics card holds: they are "
      "drawn in the medium without its shadows. Make the window smaller, or fewer surfaces "
      "translucent.");
  }
  if (!plan.Plain && properties.ScatteredSurfaceLight && !plan.ScatteredSurfaceLight)
  {
    this->WarnOnce(ScatteredLightInImage,
      "ScatteredSurfaceLight has no effect: the medium's density comes from an image, or volumes "
      "cast shadows (SetVolumeShadows()). Surfaces are "
      "lit directly only.");
  }
}

//------------------------------------------------------------------------------
void PassMessages::CheckCostlyCasters(
  const LightShadows::CostlyCasters& casters, const FramePlan& plan)
{
  if (casters.Count > 0)
  {
    std::ostringstream text;
    text << std::setprecision(3) << "Shadow planes would give a pixel about " << casters.Boundaries
         << " boundaries, more than " << plan.MaximumBoundaries << ": the shadows of "
         << casters.Count << (casters.Count == 1 ? " caster come" : " casters come")
         << " from a shadow map, which is faster and less exact. Call "
            "SetMaximumBoundariesPerPixel() with more, or SetShadowTechniqueToShadowPlanes(), for "
            "exact shadows.";
    this->WarnOnce(CostlyCasters, text.str());
  }
  if (plan.CastersInFroxels && plan.TranslucentBoundaries > plan.MaximumBoundaries)
  {
    std::ostringstream text;
    text
      << std::setprecision(3) << "Translucent casters would give a pixel about "
      << plan.TranslucentBoundaries << " boundaries, more than " << plan.MaximumBoundaries
      << ": their shadows, and the airlight before what is translucent, come from a coarse grid, "
         "which is faster and less exact. Call SetMaximumBoundariesPerPixel() with more, or "
         "SetShadowTechniqueToShadowPlanes(), for exact shadows.";
    this->WarnOnce(CostlyTranslucency, text.str());
  }
  else if (plan.Froxels)
  {
    std::ostringstream text;
    text << std::setprecision(3) << "Point Gaussians would give a pixel about "
         << plan.GaussianFragments
         << " fragments: the airlight and the shadows before them, and the shadows of translucent "
            "casters, come from a coarse grid, which is faster and less exact. Call "
            "SetMaximumBoundariesPerPixel() with more, or SetShadowTechniqueToShadowPlanes(), for "
            "exact ones.";
    this->WarnOnce(CostlyGaussians, text.str());
  }
}

//------------------------------------------------------------------------------
void PassMessages::CheckCasters(const CasterCache& casters, const FramePlan& plan)
{
  const std::string& error = casters.GetError();
  if (error != this->CasterError)
  {
    this->CasterError = error;
    if (!error.empty())
    {
      vtkErrorWithObjectMacro(this->Pass, << error << ".");
    }
  }
  if (!casters.GetUnsupportedProp().empty() && plan.Shadows != ShadowMethod::None)
  {
    this->WarnOnce(LevelsOfDetail,
      "A prop of the class " + casters.GetUnsupportedProp() +
        " casts no shadow: the level of detail that it shows is a volume or an image. Add one with "
        "a vtkMapper, or call vtkAirlightPass::SetCastsShadow(prop, false).");
  }
  if (casters.MetTranslucent() && plan.TranslucentShadows &&
    (plan.Shadows == ShadowMethod::Map || plan.Shadows == ShadowMethod::March))
  {
    this->WarnOnce(TranslucentInMaps,
      "Shadow maps know of light and dark only: what lets light through casts no shadow in them. "
      "Call SetShadowTechniqueToShadowPlanes(), or SetTranslucentShadows(false) to cast none "
      "anyway.");
  }
}

//------------------------------------------------------------------------------
void PassMessages::ReportVolumeShader(vtkVolume* volume)
{
  this->WarnOnce(Volumes,
    std::string("A volume of the mapper ") + volume->GetMapper()->GetClassName() +
      " is drawn without the medium before it: only samples that are blended over each other by "
      "VTK's own shader go through it. Use the blend mode composite, isosurface or slice, and no "
      "shader code of your own for the whole.");
}

void PassMessages::ReportVolumeMapper(vtkVolume* volume)
{
  this->WarnOnce(Volumes,
    std::string("A volume is drawn without the medium before it: its mapper ") +
      volume->GetMapper()->GetClassName() +
      " does not draw it with the graphics card's ray casting. Use vtkGPUVolumeRayCastMapper, or "
      "vtkSmartVolumeMapper with SetRequestedRenderModeToGPU(), for image data.");
}

//------------------------------------------------------------------------------
void PassMessages::ReportVolume(const std::string& text)
{
  if (!text.empty() && this->VolumesGiven.insert(text).second)
  {
    vtkWarningWithObjectMacro(this->Pass, << text);
  }
}

//------------------------------------------------------------------------------
void PassMessages::CheckSupport(const SceneSupport& support)
{
  if (support.OcclusionOutside)
  {
    this->WarnOnce(OcclusionOutside,
      "A vtkSSAOPass draws this pass, which gives it no positions and normals of surfaces: "
      "what it darkens is arbitrary. Make it the delegate: pass->SetDelegatePass(ssao).");
  }
}

//------------------------------------------------------------------------------
void PassMessages::ReportAntialiasing(const int size[2], bool floatingPoint)
{
  this->WarnOnce(AntialiasingLeftOut,
    "The renderer's FXAA is left out: the pass draws into a target of another pass, of " +
      std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      (floatingPoint ? " pixels of floating point" : " pixels") +
      ", which VTK's FXAA cannot do. Make a vtkOpenGLFXAAPass the outermost pass instead.");
}

//------------------------------------------------------------------------------
void PassMessages::ReportFrame(const std::string& error)
{
  if (this->FrameError != error)
  {
    this->FrameError = error;
    vtkErrorWithObjectMacro(
      this->Pass, << "The scene is drawn without the medium: " << error << ".");
  }
}
}
