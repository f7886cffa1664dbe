// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightSceneSupport.h"

#include "Pass/AirlightScenePass.h"
#include "Scene/AirlightClassTraits.h"

#include "vtkActor.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace airlight
{
namespace
{
// Whether another pass takes part in a prop's shaders.
bool HasForeignPass(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkOpenGLRenderPass::RenderPasses());
}

// Whether all that a prop draws as opaque is drawn by mappers whose shaders the pass adds to. Props
// may draw with actors of their own, and subclasses with anything.
bool HasSupportedMapper(vtkProp* prop)
{
  if (!prop->HasOpaqueGeometry() || prop->IsA("vtkActor2D"))
  {
    return true;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  return HasTrait(actor, ClassTrait::DrawsItsMapper) &&
    HasTrait(actor->GetMapper(), ClassTrait::InjectableShaders);
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

// Whether a prop's mapper draws its input where it is, of which nothing shines through. Not one
// that draws something coarser while the scene is turned.
bool DrawsAllOfIt(vtkProp* prop)
{
  if (!HasTrait(prop, ClassTrait::DrawsItself) || !HasSupportedMapper(prop) || !IsSolidProp(prop) ||
    HasForeignPass(prop))
  {
    return false;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkShaderProperty* shader = actor->GetShaderProperty();
  return HasTrait(actor->GetMapper(), ClassTrait::DrawsItsInput) && prop->HasOpaqueGeometry() &&
    !shader->HasVertexShaderCode() && !shader->HasGeometryShaderCode();
}

// As far as that does not depend on single props.
bool MayHideAllBehind(const vtkRenderState* s, const vtkRenderPass* delegate)
{
  vtkRenderWindow* window = s->GetRenderer()->GetRenderWindow();
  return !delegate && !window->GetLineSmoothing() && !window->GetPointSmoothing() &&
    !window->GetPolygonSmoothing();
}
}

//------------------------------------------------------------------------------
bool HidesAllBehind(const vtkRenderState* s, const vtkRenderPass* delegate)
{
  vtkProp** first = s->GetPropArray();
  return MayHideAllBehind(s, delegate) &&
    std::all_of(first, first + s->GetPropArrayCount(), [](vtkProp* prop) {
      return HasSupportedMapper(prop) && IsSolidProp(prop) &&
        !AirlightScenePass::IsPointGaussians(prop);
    });
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> FindSolidProps(const vtkRenderState* s, const vtkRenderPass* delegate)
{
  std::vector<vtkProp*> solids;
  if (MayHideAllBehind(s, delegate) && !s->GetRenderer()->GetUseHiddenLineRemoval())
  {
    vtkProp** first = s->GetPropArray();
    std::copy_if(first, first + s->GetPropArrayCount(), std::back_inserter(solids), DrawsAllOfIt);
    std::sort(solids.begin(), solids.end(), std::less<const vtkProp*>());
  }
  return solids;
}

//------------------------------------------------------------------------------
bool HasInjectableShaders(const vtkRenderState* s, const vtkRenderPass* delegate)
{
  vtkRenderer* renderer = s->GetRenderer();
  vtkProp** first = s->GetPropArray();
  const int count = s->GetPropArrayCount();
  return !delegate && !renderer->GetUseSSAO() &&
    !(renderer->GetUseHiddenLineRemoval() &&
      vtkHiddenLineRemovalPass::WireframePropsExist(first, count)) &&
    std::all_of(first, first + count, [](vtkProp* prop) {
      return HasSupportedMapper(prop) && !HasForeignPass(prop) &&
        !AirlightScenePass::IsPointGaussians(prop);
    });
}
}
