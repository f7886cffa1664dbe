// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The last steps of a frame: the medium before the scene, the recorded buffers, and the picture into
// the caller's framebuffer.

#include "Frame/AirlightFrame.h"

#include "AirlightCameraShader.h"
#include "AirlightCompositeFS.h"
#include "AirlightCopyFS.h"
#include "AirlightDisplay.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
namespace
{
std::string Define(const char* name, int value)
{
  return std::string("#define AIRLIGHT_") + name + " " + std::to_string(value) + "\n";
}

bool HasAmbient(const f64::AirlightMedia& media)
{
  return std::any_of(media.item, media.item + media.count,
    [](const f64::AirlightMedium& medium) { return medium.ambient != glm::dvec3(0.0); });
}
}

//------------------------------------------------------------------------------
std::vector<std::pair<const char*, vtkTextureObject*>> Frame::GetCompositeTextures()
{
  std::vector<std::pair<const char*, vtkTextureObject*>> textures = { { "distances",
                                                                        this->Textures.Distances },
    { "scene", this->Textures.Scene }, { "airlightData", this->Data.GetTexture() } };
  if (!this->Plan.UnshadowedInComposite)
  {
    textures.emplace_back("scattered", this->Textures.Scattered);
  }
  if (this->Plan.ShadowingLight >= 0)
  {
    textures.emplace_back("dark", this->Textures.Dark);
    if (this->Plan.ShadowingLight >= BitsPerChannel)
    {
      textures.emplace_back("lit", this->Textures.Lit);
    }
  }
  return textures;
}

//------------------------------------------------------------------------------
vtkShaderProgram* Frame::ReadyComposite(bool layers, int x, int y)
{
  const std::vector<int> whole =
    this->Plan.UnshadowedInComposite ? FindScattering(this->Lamps) : std::vector<int>();
  const int kind = whole.empty() ? AIRLIGHT_POINT_CLOSED : this->Lamps[whole[0]].Values.kind;
  const bool cones = std::any_of(
    whole.begin(), whole.end(), [this](int k) { return this->Lamps[k].Values.cosCone > 0.0; });
  const bool turned = this->AreTurned(whole);
  const std::string source = GetShaderVersion(false) + (cones ? "" : "#define AIRLIGHT_NO_CONE\n") +
    Define("TURNED", turned) + (layers ? "#define AIRLIGHT_TRANSLUCENT\n" : "") +
    (layers && this->Plan.Record ? RecordDefinition : "") +
    Define("DEBUG_VIEW", layers ? 0 : static_cast<int>(this->Plan.View)) +
    Define("APART", this->Plan.ShadowingLight) + Define("BITS", BitsPerChannel) +
    Define("AMBIENT", HasAmbient(this->Media)) + Define("ENCODED_INPUT", this->Plan.EncodedInput) +
    Define("ENCODED_OUTPUT", this->Plan.EncodedOutput) +
    Define("PARALLEL", this->Rays->IsParallel()) + "#define AIRLIGHT_FULL_SCREEN\n" +
    GetScatteringSource(this->Media, kind, false) + AirlightCameraShader +
    (turned ? GetTurnSource() : "uniform AirlightMedia media;\n") +
    this->GetWholeRaysSource(whole) + AirlightDisplay + AirlightCompositeFS;
  Quad& quad = layers ? this->TranslucentQuad : this->CompositeQuad;
  vtkShaderProgram* program = quad.Ready(this->Window, source);
  if (!program)
  {
    this->Fail(std::string("the composite shader") + ProgramMaker::GetReason());
    return nullptr;
  }
  this->SetWholeRaysUniforms(program, whole);
  SetMediaUniforms(program, turned ? "givenMedia" : "media", this->Media);
  // Where the target's viewport does not begin at 0, gl_FragCoord does not either.
  this->Rays->SetUniforms(program, x, y);
  if (layers && this->Plan.Record)
  {
    program->SetUniformf("error", ClosedFormError);
  }
  return program;
}

//------------------------------------------------------------------------------
vtkShaderProgram* Frame::ReadyCopy(int x, int y)
{
  vtkShaderProgram* program = this->CopyQuad.Ready(
    this->Window, std::string("#version 330\n") + AirlightDisplay + AirlightCopyFS);
  if (!program)
  {
    this->Fail(std::string("the shader of the last step") + ProgramMaker::GetReason());
    return nullptr;
  }
  const int corner[2] = { x, y };
  program->SetUniform2i("airlightViewport", corner);
  program->SetUniformi("encodedOutput", this->Plan.EncodedOutput ? 1 : 0);
  return program;
}

//------------------------------------------------------------------------------
bool Frame::CompositeTranslucent()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  if (!this->ReadyComposite(true, 0, 0))
  {
    return false;
  }
  std::vector<vtkTextureObject*> targets = { this->Textures.Radiance };
  auto textures = this->GetCompositeTextures();
  if (this->Plan.Record)
  {
    targets.insert(targets.end(),
      { this->Textures.Airlight, this->Textures.Surface, this->Textures.Transmittance });
    textures.emplace_back("counts", this->Textures.Counts);
  }
  if (!this->Textures.Bind(targets, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->TranslucentQuad.Draw(textures);
  if (!this->Textures.Bind({ this->Textures.Radiance }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  return true;
}

//------------------------------------------------------------------------------
bool Frame::Record()
{
  if (!this->Textures.Bind({ this->Textures.Radiance, this->Textures.Airlight,
                             this->Textures.Surface, this->Textures.Transmittance },
        nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Buffers["Radiance"] = this->Textures.Read(0, 0, 3);
  this->Buffers["Airlight"] = this->Textures.Read(1, 0, 3);
  this->Buffers["Surface"] = this->Textures.Read(2, 0, 3);
  this->Buffers["Transmittance"] = this->Textures.Read(3, 0, 3);
  this->Buffers["Depth"] = this->Textures.Read(3, 3, 1);
  this->Buffers["ErrorBound"] = this->Textures.Read(1, 3, 1);
  if (!this->Textures.Bind({ this->Textures.Counts }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Buffers["BoundaryCount"] = this->Textures.Read(0, 0, 1);
  this->Buffers["LitLength"] = this->Textures.Read(0, 2, 1);
  return true;
}

//------------------------------------------------------------------------------
// Reads one light's airlight and clears its target for the next one.
bool Frame::RecordSingle(int index)
{
  if (!this->Textures.Bind({ this->Textures.Single }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Buffers["Airlight:" + std::to_string(index)] = this->Textures.Read(0, 0, 3);
  this->ClearTarget(0.0f);
  return true;
}

//------------------------------------------------------------------------------
vtkImageData* Frame::GetBuffer(const std::string& name)
{
  const auto it = this->Buffers.find(name);
  return it != this->Buffers.end() ? it->second.Get() : nullptr;
}

//------------------------------------------------------------------------------
bool Frame::Composite(int x, int y, bool blend)
{
  const bool copy = this->Plan.Translucent;
  vtkShaderProgram* program = copy ? this->ReadyCopy(x, y) : this->ReadyComposite(false, x, y);
  if (!program)
  {
    return false;
  }
  program->SetUniformi("blended", blend ? 1 : 0);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglViewport(x, y, this->Width, this->Height);
  state->vtkglScissor(x, y, this->Width, this->Height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  if (blend)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  else
  {
    state->vtkglDisable(GL_BLEND);
  }
  if (copy)
  {
    this->CopyQuad.Draw({ { "radiances", this->Textures.Radiance },
      { "sceneDepth", this->Textures.Depth }, { "scene", this->Textures.Scene } });
  }
  else
  {
    auto textures = this->GetCompositeTextures();
    textures.emplace_back("sceneDepth", this->Textures.Depth);
    if (this->Plan.Record)
    {
      textures.emplace_back("counts", this->Textures.Counts);
    }
    this->CompositeQuad.Draw(textures);
  }
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  return true;
}

//------------------------------------------------------------------------------
bool Frame::DrawPlanes()
{
  const bool planes = this->Plan.Shadows == ShadowMethod::Planes;
  for (size_t k = 0; k < this->Lamps.size() && planes; ++k)
  {
    const Lamp& lamp = this->Lamps[k];
    if (lamp.Scatters() && lamp.CastsShadows && this->Volumes[k].HasShadows() &&
      !this->Boundaries.DrawWireframe(this->GetPlanesSource(static_cast<int>(k))))
    {
      return this->Fail(this->Boundaries.GetError());
    }
  }
  return true;
}
}
