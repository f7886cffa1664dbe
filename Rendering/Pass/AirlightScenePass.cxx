// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightScenePass.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkPointGaussianMapper.h"
#include "vtkRenderState.h"
#include "vtkTranslucentPass.h"

#include <algorithm>

vtkStandardNewMacro(AirlightScenePass);

namespace
{
vtkPointGaussianMapper* GetGaussianMapper(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor ? vtkPointGaussianMapper::SafeDownCast(actor->GetMapper()) : nullptr;
}

void RenderPointGaussians(const vtkRenderState* s)
{
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    if (AirlightScenePass::IsPointGaussians(s->GetPropArray()[i]))
    {
      s->GetPropArray()[i]->RenderOpaqueGeometry(s->GetRenderer());
    }
  }
}

// Those at the end of the state's props that the renderer does not have: visible lamps.
void RenderAddedProps(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  for (int i = s->GetPropArrayCount() - 1; i >= 0; --i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    if (renderer->HasViewProp(prop))
    {
      return;
    }
    prop->RenderOpaqueGeometry(renderer);
  }
}

// The props of the state. VTK's way with hidden lines and ambient occlusion has the renderer's own.
void RenderOpaque(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (renderer->GetUseHiddenLineRemoval() || renderer->GetUseSSAO())
  {
    renderer->DeviceRenderOpaqueGeometry(s->GetFrameBuffer());
    RenderAddedProps(s);
    return;
  }
  std::for_each(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount(),
    [renderer](vtkProp* prop) { prop->RenderOpaqueGeometry(renderer); });
}

// Whether volumes are drawn with the translucent surfaces.
bool PeelsVolumes(vtkRenderer* renderer, vtkRenderPass* translucentPass)
{
  if (translucentPass)
  {
    auto* peeling = vtkDualDepthPeelingPass::SafeDownCast(translucentPass);
    return peeling && peeling->GetVolumetricPass();
  }
  return renderer->GetUseDepthPeeling() && renderer->GetUseDepthPeelingForVolumes();
}
}

//------------------------------------------------------------------------------
AirlightScenePass::AirlightScenePass()
{
  this->Unordered->SetTranslucentPass(this->Blending);
  this->Peeling->SetTranslucentPass(this->Blending);
}

AirlightScenePass::~AirlightScenePass() = default;

//------------------------------------------------------------------------------
void AirlightScenePass::PrepareLights(vtkRenderer* renderer)
{
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
}

//------------------------------------------------------------------------------
void AirlightScenePass::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->ClearLights(renderer);
  this->PrepareLights(renderer);
  if (this->OpaqueOnly)
  {
    this->BeforeOpaque();
    RenderOpaque(s);
    this->AfterOpaque();
  }
  else
  {
    this->UpdateGeometry(renderer, s->GetFrameBuffer());
  }
}

//------------------------------------------------------------------------------
// Without a scale they are plain points.
bool AirlightScenePass::IsPointGaussians(vtkProp* prop)
{
  vtkPointGaussianMapper* mapper = GetGaussianMapper(prop);
  return mapper && mapper->GetScaleFactor() != 0.0;
}

//------------------------------------------------------------------------------
bool AirlightScenePass::IsEmissive(vtkProp* prop)
{
  vtkPointGaussianMapper* mapper = GetGaussianMapper(prop);
  return mapper && mapper->GetEmissive();
}

//------------------------------------------------------------------------------
void AirlightScenePass::RenderFragments(
  const vtkRenderState* s, const std::vector<vtkProp*>& rayCast)
{
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    if (IsPointGaussians(prop))
    {
      prop->RenderOpaqueGeometry(s->GetRenderer());
    }
    prop->RenderTranslucentPolygonalGeometry(s->GetRenderer());
    if (std::find(rayCast.begin(), rayCast.end(), prop) != rayCast.end())
    {
      prop->RenderVolumetricGeometry(s->GetRenderer());
    }
  }
}

//------------------------------------------------------------------------------
void AirlightScenePass::RenderTransparentOf(const vtkRenderState* s)
{
  RenderPointGaussians(s);
  vtkRenderer* renderer = s->GetRenderer();
  if (renderer->GetUseDepthPeeling())
  {
    this->Peeling->SetMaximumNumberOfPeels(renderer->GetMaximumNumberOfPeels());
    this->Peeling->SetOcclusionRatio(renderer->GetOcclusionRatio());
    this->Peeling->Render(s);
  }
  else
  {
    this->Unordered->Render(s);
  }
}

//------------------------------------------------------------------------------
// In VTK's order; where translucent surfaces are peeled together with volumes, these are done.
void AirlightScenePass::RenderTransparent(const vtkRenderState* s, vtkRenderPass* translucentPass)
{
  vtkRenderer* renderer = s->GetRenderer();
  vtkProp** props = s->GetPropArray();
  const int count = s->GetPropArrayCount();
  RenderPointGaussians(s);
  const bool translucent = std::any_of(
    props, props + count, [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry(); });
  if (translucent && translucentPass)
  {
    translucentPass->Render(s);
  }
  else if (translucent)
  {
    renderer->DeviceRenderTranslucentPolygonalGeometry(s->GetFrameBuffer());
  }
  if (!translucent || !PeelsVolumes(renderer, translucentPass))
  {
    std::for_each(
      props, props + count, [&](vtkProp* prop) { prop->RenderVolumetricGeometry(renderer); });
  }
}

//------------------------------------------------------------------------------
void AirlightScenePass::Antialias(vtkRenderer* renderer)
{
  if (vtkFXAAOptions* options = renderer->GetFXAAOptions())
  {
    this->Antialiasing->UpdateConfiguration(options);
  }
  this->Antialiasing->Execute(vtkOpenGLRenderer::SafeDownCast(renderer));
}

//------------------------------------------------------------------------------
void AirlightScenePass::RenderOverlay(const vtkRenderState* s)
{
  vtkProp** props = s->GetPropArray();
  std::for_each(props, props + s->GetPropArrayCount(),
    [&](vtkProp* prop) { prop->RenderOverlay(s->GetRenderer()); });
}

//------------------------------------------------------------------------------
void AirlightScenePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Antialiasing->ReleaseGraphicsResources();
  this->Unordered->ReleaseGraphicsResources(window);
  this->Peeling->ReleaseGraphicsResources(window);
}
