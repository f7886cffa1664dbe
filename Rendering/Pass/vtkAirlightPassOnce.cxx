// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Which scenes vtkAirlightPass draws once: distances and colours of opaque surfaces together. Shadows on
// surfaces are known only after the distances; where one light casts them, colours are drawn with and
// without it.

#include "Pass/vtkAirlightPassInternals.h"

#include "Scene/AirlightClassNames.h"

#include "vtkActor.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <functional>
#include <iterator>

using namespace airlight;

namespace
{
// Whether another pass takes part in a prop's shaders.
bool HasForeignPass(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkOpenGLRenderPass::RenderPasses());
}

// Whether all that a prop draws as opaque is drawn by mappers whose shaders the pass adds to. Props may
// draw with actors of their own, and subclasses with anything.
bool IsKnown(vtkProp* prop)
{
  if (!prop->HasOpaqueGeometry() || prop->IsA("vtkActor2D"))
  {
    return true;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  // In ParaView: its actor draws its mapper with an actor of its own, to which it hands all that it
  // has; ParaView/ has actors that draw nothing, but cast.
  return IsAnyOf(actor, { "vtkOpenGLActor", "vtkActor", "vtkPVLODActor", "AirlightStandIn" }) &&
    IsAnyOf(actor->GetMapper(),
      { "vtkOpenGLPolyDataMapper", "vtkDataSetMapper", "vtkCompositePolyDataMapper2",
        "vtkOpenGLGlyph3DMapper" });
}

// Whether each fragment of a known prop hides all that is behind it.
bool IsSolidProp(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || !prop->HasOpaqueGeometry())
  {
    return true;
  }
  vtkProperty* property = actor->GetProperty();
  vtkShaderProperty* shader = actor->GetShaderProperty();
  return !actor->GetForceOpaque() && !actor->GetTexture() && property->GetNumberOfTextures() == 0 &&
    !shader->HasFragmentShaderCode() && shader->GetNumberOfShaderReplacements() == 0;
}

// Whether a prop's mapper draws its input where it is, of which nothing shines through. Not one that draws
// something coarser while the scene is turned.
bool DrawsAllOfIt(vtkProp* prop)
{
  if (!IsAnyOf(prop, { "vtkOpenGLActor", "vtkActor" }) || !IsKnown(prop) || !IsSolidProp(prop) ||
    HasForeignPass(prop))
  {
    return false;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkShaderProperty* shader = actor->GetShaderProperty();
  return IsAnyOf(actor->GetMapper(), { "vtkOpenGLPolyDataMapper", "vtkDataSetMapper" }) &&
    prop->HasOpaqueGeometry() && !shader->HasVertexShaderCode() && !shader->HasGeometryShaderCode();
}
}

//------------------------------------------------------------------------------
// As far as that does not depend on single props.
bool vtkAirlightPass::Internals::MayBeSolid(const vtkRenderState* s) const
{
  vtkRenderWindow* window = s->GetRenderer()->GetRenderWindow();
  return !this->Self->DelegatePass && !window->GetLineSmoothing() && !window->GetPointSmoothing() &&
    !window->GetPolygonSmoothing();
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::IsSolid(const vtkRenderState* s) const
{
  vtkProp** first = s->GetPropArray();
  return this->MayBeSolid(s) &&
    std::all_of(first, first + s->GetPropArrayCount(), [](vtkProp* prop) {
      return IsKnown(prop) && IsSolidProp(prop) && !AirlightScenePass::IsPointGaussians(prop);
    });
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkAirlightPass::Internals::FindSolids(const vtkRenderState* s) const
{
  std::vector<vtkProp*> solids;
  if (this->MayBeSolid(s) && !s->GetRenderer()->GetUseHiddenLineRemoval())
  {
    vtkProp** first = s->GetPropArray();
    std::copy_if(first, first + s->GetPropArrayCount(), std::back_inserter(solids), DrawsAllOfIt);
    std::sort(solids.begin(), solids.end(), std::less<const vtkProp*>());
  }
  return solids;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::KnowsAll(const vtkRenderState* s) const
{
  vtkRenderer* renderer = s->GetRenderer();
  vtkProp** first = s->GetPropArray();
  const int count = s->GetPropArrayCount();
  return !this->Self->DelegatePass && !renderer->GetUseSSAO() &&
    !(renderer->GetUseHiddenLineRemoval() &&
      vtkHiddenLineRemovalPass::WireframePropsExist(first, count)) &&
    std::all_of(first, first + count, [](vtkProp* prop) {
      return IsKnown(prop) && !HasForeignPass(prop) && !AirlightScenePass::IsPointGaussians(prop);
    });
}

//------------------------------------------------------------------------------
// Of a scene of which KnowsAll() is true.
bool vtkAirlightPass::Internals::MayDrawOnce(
  bool solid, const std::vector<Lamp>& lamps, int& apart) const
{
  if (this->EffectiveTechnique == NONE || !this->Self->SurfaceShadows)
  {
    return true;
  }
  const auto casts = [](const Lamp& lamp) { return lamp.Scatters() && lamp.CastsShadows; };
  const auto casting = std::count_if(lamps.begin(), lamps.end(), casts);
  if (casting == 0)
  {
    return true;
  }
  const bool dims = this->EffectiveTechnique == SHADOW_PLANES && this->Self->TranslucentShadows &&
    this->CurrentFrame.MetTranslucent();
  if (casting > 1 || lamps.size() > MaximumUnrolledLights || dims || !solid)
  {
    return false;
  }
  apart = static_cast<int>(std::find_if(lamps.begin(), lamps.end(), casts) - lamps.begin());
  return true;
}
