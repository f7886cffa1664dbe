// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightPass.h"

#include "Medium/AirlightMediaMethods.h"
#include "Pass/vtkAirlightPassInternals.h"
#include "Scene/AirlightCasterKeys.h"

#include "vtkFrameBufferObjectBase.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>

using namespace airlight;

vtkStandardNewMacro(vtkAirlightPass);

//------------------------------------------------------------------------------
vtkAirlightPass::vtkAirlightPass()
  : Impl(new Internals(this))
{
  // Into which VTK draws volumes of lower resolution.
  this->ActiveDrawBuffers = 1;
}

vtkAirlightPass::~vtkAirlightPass() = default;

//------------------------------------------------------------------------------
AirlightMediaMethodsMacro(vtkAirlightPass);

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
void vtkAirlightPass::SetDebugView(int view)
{
  if (view < SHADED || view > OUTLINES)
  {
    vtkErrorMacro(<< "DebugView " << view
                  << " is not a view: use SHADED, AIRLIGHT_ONLY, BOUNDARY_COUNT or "
                     "OUTLINES.");
    return;
  }
  if (this->DebugView != view)
  {
    this->DebugView = view;
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
vtkInformationIntegerKey* vtkAirlightPass::CASTS_SHADOW() { return GetCastsShadowKey(); }

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
int vtkAirlightPass::GetEffectiveShadowTechnique() { return this->Impl->EffectiveTechnique; }

//------------------------------------------------------------------------------
vtkImageData* vtkAirlightPass::GetBuffer(const char* name)
{
  return name ? this->Impl->CurrentFrame.GetBuffer(name) : nullptr;
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
  this->Impl->UpdateStereo(renderer);
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
  this->Impl->Recover();
  this->Impl->RenderPlain(s);
}

//------------------------------------------------------------------------------
void vtkAirlightPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Superclass::ReleaseGraphicsResources(w);
  // In whichever window they are.
  this->Impl->Context->SetContext(nullptr);
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
  const char* techniques[] = { "None", "ShadowPlanes", "Automatic", "ShadowMap", "RayMarch" };
  os << indent << "ShadowTechnique: " << techniques[this->ShadowTechnique] << "\n";
  os << indent << "EffectiveShadowTechnique: " << techniques[this->GetEffectiveShadowTechnique()]
     << "\n";
  os << indent << "ShadowMapResolution: " << this->ShadowMapResolution << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "SurfaceShadows: " << this->SurfaceShadows << "\n";
  os << indent << "TranslucentShadows: " << this->TranslucentShadows << "\n";
  os << indent << "ScatteredSurfaceLight: " << this->ScatteredSurfaceLight << "\n";
  os << indent << "LinearInput: " << this->LinearInput << "\n";
  os << indent << "EncodedOutput: " << this->EncodedOutput << "\n";
  os << indent << "Annotations: " << this->Annotations << "\n";
  const char* views[] = { "Shaded", "AirlightOnly", "BoundaryCount", "ShadowPlaneOutlines" };
  os << indent << "DebugView: " << views[this->DebugView] << "\n";
  os << indent << "LightRadius: " << this->LightRadius << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "RecordBuffers: " << this->RecordBuffers << "\n";
}
