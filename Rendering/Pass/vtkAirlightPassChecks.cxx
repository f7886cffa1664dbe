// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAirlightPass says of media, lights, graphics cards and other passes that it cannot do.

#include "Pass/vtkAirlightPassInternals.h"

#include "MapperShaders/AirlightVolumeShader.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>

using namespace airlight;

namespace
{
// Their mappers' classes, each once.
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
  const std::string text = this->Media.Check();
  if (!text.empty() && !this->WarnedMedia)
  {
    this->WarnedMedia = true;
    vtkErrorWithObjectMacro(this->Self, << text);
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::CheckLamps(const std::vector<Lamp>& lamps, bool scattered)
{
  if (scattered && std::any_of(lamps.begin(), lamps.end(), IsLeftOut))
  {
    this->WarnOnce(this->WarnedCameraLights, DescribeLeftOut(lamps));
  }
  for (const Lamp& lamp : lamps)
  {
    if (lamp.Support == LightSupport::Invalid)
    {
      this->WarnOnce(this->WarnedLights, InvalidLampText);
    }
  }
  for (const Lamp& lamp : lamps)
  {
    const LightOptions* options = this->FindOptions(lamp.Light);
    if (options && options->Table && lamp.Scatters() && !lamp.Table)
    {
      this->WarnOnce(this->WarnedPhotometry,
        "A light's photometric file " + options->PhotometryFile +
          " is not used: it needs a positional light whose focal point, at which it aims, is apart "
          "from its position.");
    }
  }
  if (static_cast<int>(lamps.size()) > MaximumShadowingLights)
  {
    this->WarnOnce(this->WarnedLightCount,
      "There are " + std::to_string(lamps.size()) + " lights; those after the first " +
        std::to_string(MaximumShadowingLights) + " cast no shadows on surfaces.");
  }
  const auto glowing =
    std::count_if(lamps.begin(), lamps.end(), [](const Lamp& lamp) { return lamp.Glows(); });
  if (this->Self->ScatteredSurfaceLight && glowing > MaximumGlowLights)
  {
    this->WarnOnce(this->WarnedGlowCount,
      "The medium scatters " + std::to_string(glowing) + " lights; those after the first " +
        std::to_string(MaximumGlowLights) + " light surfaces directly only.");
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::NoteVolume(vtkVolume* volume, bool through)
{
  this->NotedVolumes.insert(volume);
  if (!through && this->Stage == SurfaceStage::Translucent && !this->CurrentFrame.IsClear())
  {
    this->WarnOnce(this->WarnedVolumes,
      std::string("A volume of the mapper ") + volume->GetMapper()->GetClassName() +
        " is drawn without the medium before it: only samples that are blended over each other "
        "by VTK's own shader go through it. Use the blend mode composite, isosurface or slice, and "
        "no shader code of your own for the whole.");
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::CheckVolumes(const vtkRenderState* s)
{
  if (this->CurrentFrame.IsClear())
  {
    return;
  }
  for (vtkVolume* volume : GetVolumes(s->GetPropArray(), s->GetPropArrayCount()))
  {
    const double* bounds = volume->GetBounds();
    if (this->NotedVolumes.count(volume) == 0 && bounds && vtkMath::AreBoundsInitialized(bounds))
    {
      this->WarnOnce(this->WarnedVolumes,
        std::string("A volume is drawn without the medium before it: its mapper ") +
          volume->GetMapper()->GetClassName() +
          " does not draw it with the graphics card's ray casting. Use "
          "vtkGPUVolumeRayCastMapper, or vtkSmartVolumeMapper with "
          "SetRequestedRenderModeToGPU(), for image data.");
    }
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::CheckCasters()
{
  const CasterCache& casters = this->CurrentFrame.GetCasters();
  const std::string& error = casters.GetError();
  if (error != this->ReportedCasterError)
  {
    this->ReportedCasterError = error;
    if (!error.empty())
    {
      vtkErrorWithObjectMacro(this->Self, << error << ".");
    }
  }
  if (!casters.GetUnsupportedProp().empty() && this->EffectiveTechnique != NONE)
  {
    this->WarnOnce(this->WarnedLevels,
      "A prop of the class " + casters.GetUnsupportedProp() +
        " casts no shadow: the level of detail that it shows is a volume or an image. Add one with "
        "a vtkMapper, or set vtkAirlightPass::CASTS_SHADOW() to 0 in its property keys.");
  }
  if (casters.MetTranslucent() && this->Self->TranslucentShadows &&
    (this->EffectiveTechnique == SHADOW_MAP || this->EffectiveTechnique == RAY_MARCH))
  {
    this->WarnOnce(this->WarnedTranslucent,
      "Shadow maps know of light and dark only: what lets light through casts no shadow in them. "
      "Call SetShadowTechniqueToShadowPlanes(), or SetTranslucentShadows(false) to cast none "
      "anyway.");
  }
}

//------------------------------------------------------------------------------
int vtkAirlightPass::Internals::ChooseTechnique(
  vtkRenderer* renderer, const std::vector<Lamp>& lamps, bool clear)
{
  const int technique = this->Self->ShadowTechnique;
  if (technique != NONE)
  {
    this->CurrentFrame.FindCasters(renderer, this->Self->TranslucentShadows);
  }
  if (technique != SHADOW_PLANES && technique != AUTOMATIC)
  {
    return technique;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!ShadowLists::IsSupported(window))
  {
    const std::string text =
      "Shadow planes need OpenGL 4.3 with storage buffers, which this window "
      "lacks: shadows come from "
      "shadow maps, which are less exact. Update the graphics driver, or call "
      "SetShadowTechniqueToShadowMap().";
    if (technique == SHADOW_PLANES && !this->WarnedOpenGL)
    {
      this->WarnedOpenGL = true;
      vtkErrorWithObjectMacro(this->Self, << text);
    }
    this->WarnOnce(this->WarnedOpenGL, text);
    return SHADOW_MAP;
  }
  const std::vector<NonPolygonalCaster>& nonPolygonal = this->CurrentFrame.GetNonPolygonalCasters();
  const bool casts = (!clear || this->Self->SurfaceShadows) &&
    std::any_of(lamps.begin(), lamps.end(),
      [](const Lamp& lamp) { return lamp.Scatters() && lamp.CastsShadows; });
  if (!nonPolygonal.empty() && casts)
  {
    const std::string keep = " Set vtkAirlightPass::CASTS_SHADOW() to 0 in the property keys of "
                             "those that shall not cast";
    this->WarnOnce(this->WarnedCasters,
      "No shadow planes can be drawn from what the mappers " + GetMapperNames(nonPolygonal) +
        " draw: " +
        (technique == AUTOMATIC
            ? "shadows come from shadow maps, which are less exact." + keep + " for exact shadows."
            : "it casts none." + keep + ", or call SetShadowTechniqueToShadowMap()."));
    return technique == AUTOMATIC ? SHADOW_MAP : SHADOW_PLANES;
  }
  return this->TooManyPlanes ? SHADOW_MAP : SHADOW_PLANES;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::ChangesNothing(const std::vector<Lamp>& lamps, bool clear)
{
  const bool shadows = this->EffectiveTechnique != NONE && this->Self->SurfaceShadows;
  return clear && this->Self->DebugView == SHADED && !this->Self->RecordBuffers &&
    !(this->Self->EncodedOutput && this->Self->LinearInput) && this->Self->Annotations &&
    std::none_of(lamps.begin(), lamps.end(), [&](const Lamp& lamp) {
      return lamp.Values.goniometric != 0 || (shadows && lamp.Scatters() && lamp.CastsShadows);
    });
}

//------------------------------------------------------------------------------
// Passes that take part in the mappers' shaders are named in the props' keys while they draw.
void vtkAirlightPass::Internals::CheckOutside(const vtkRenderState* s)
{
  vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkInformation* keys = s->GetPropArray()[i]->GetPropertyKeys();
    for (int k = 0; keys && keys->Has(key) && k < key->Length(keys); ++k)
    {
      if (key->Get(keys, k)->IsA("vtkSSAOPass"))
      {
        this->WarnOnce(this->WarnedOcclusion,
          "A vtkSSAOPass draws this pass, which gives it no positions and normals of surfaces: "
          "what "
          "it darkens is arbitrary. Make it the delegate: pass->SetDelegatePass(ssao).");
        return;
      }
    }
  }
}

//------------------------------------------------------------------------------
// VTK's FXAA takes the renderer's part of the window, in 8 bits. A delegate stands for a renderer
// with passes, which does without.
bool vtkAirlightPass::Internals::MayAntialias(const vtkRenderState* s)
{
  if (!s->GetRenderer()->GetUseFXAA() || this->Self->DelegatePass)
  {
    return false;
  }
  vtkFrameBufferObjectBase* target = s->GetFrameBuffer();
  if (!target)
  {
    return true;
  }
  int given[2];
  int own[2];
  int origin[2];
  target->GetLastSize(given);
  s->GetRenderer()->GetTiledSizeAndOrigin(&own[0], &own[1], &origin[0], &origin[1]);
  GLint type = GL_NONE;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
  if (given[0] == own[0] && given[1] == own[1] && origin[0] == 0 && origin[1] == 0 &&
    type != GL_FLOAT)
  {
    return true;
  }
  this->WarnOnce(this->WarnedAntialiasing,
    "The renderer's FXAA is left out: the pass draws into a target of another pass, of " +
      std::to_string(given[0]) + " x " + std::to_string(given[1]) +
      (type == GL_FLOAT ? " pixels of floating point" : " pixels") +
      ", which VTK's FXAA cannot do. Make a vtkOpenGLFXAAPass the outermost pass instead.");
  return false;
}
