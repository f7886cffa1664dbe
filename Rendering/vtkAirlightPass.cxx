// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightPass.h"

#include "vtkAirlightPassInternals.h"

#include "vtkFrameBufferObjectBase.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

using namespace airlight;

vtkStandardNewMacro(vtkAirlightPass);
vtkInformationKeyMacro(vtkAirlightPass, CASTS_SHADOW, Integer);

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
  if (technique < NONE || technique > RAY_MARCH)
  {
    vtkErrorMacro(<< "ShadowTechnique " << technique
                  << " is not a technique: use NONE, SHADOW_PLANES, SHADOW_MAP, RAY_MARCH or "
                     "AUTOMATIC.");
    return;
  }
  if (this->ShadowTechnique != technique)
  {
    this->ShadowTechnique = technique;
    this->Modified();
  }
}

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
  this->Impl->ScenePass->ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  InjectSurfaceShader(fragmentShader, this->Impl->MapperText);
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  SurfaceUniforms values = this->Impl->CurrentFrame.GetSurfaceUniforms(this->Impl->Stage);
  // A delegate may draw translucent surfaces in any stage.
  values.UseLit = values.UseLit && !prop->IsRenderingTranslucentPolygonalGeometry();
  SetSurfaceUniforms(program, values);
  if (this->Impl->DrawsMap)
  {
    this->Impl->MapPrograms.insert(program);
  }
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
  const char* techniques[] = { "None", "ShadowPlanes", "Automatic", "ShadowMap", "RayMarch" };
  os << indent << "ShadowTechnique: " << techniques[this->ShadowTechnique] << "\n";
  os << indent << "EffectiveShadowTechnique: " << techniques[this->GetEffectiveShadowTechnique()]
     << "\n";
  os << indent << "ShadowMapResolution: " << this->ShadowMapResolution << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "SurfaceShadows: " << this->SurfaceShadows << "\n";
  os << indent << "ScatteredSurfaceLight: " << this->ScatteredSurfaceLight << "\n";
  os << indent << "LightRadius: " << this->LightRadius << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "RecordBuffers: " << this->RecordBuffers << "\n";
}
