// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightSceneSupport.h"

#include "Pass/AirlightScenePass.h"
#include "Scene/AirlightClassTraits.h"
#include "Scene/AirlightSceneProps.h"

#include "vtkActor.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkVolume.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>

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
  if (!prop->HasOpaqueGeometry() || prop->IsA("vtkActor2D") ||
    HasTrait(prop, ClassTrait::NothingOpaque))
  {
    return true;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  return HasTrait(actor, ClassTrait::DrawsItsMapper) &&
    HasTrait(actor->GetMapper(), ClassTrait::InjectableShaders);
}

// Whether a texture lets nothing through: its image has no translucent texel, nor has its border.
bool IsOpaque(vtkTexture* texture)
{
  return !texture || (!texture->IsTranslucent() && texture->GetWrap() != vtkTexture::ClampToBorder);
}

bool HasOpaqueTextures(vtkActor* actor)
{
  std::map<std::string, vtkTexture*>& textures = actor->GetProperty()->GetAllTextures();
  return IsOpaque(actor->GetTexture()) &&
    std::all_of(textures.begin(), textures.end(),
      [](const auto& texture) { return IsOpaque(texture.second); });
}

// Whether each fragment of a known prop hides all that is behind it.
bool IsSolidProp(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || !prop->HasOpaqueGeometry())
  {
    return true;
  }
  vtkShaderProperty* shader = actor->GetShaderProperty();
  return !actor->GetForceOpaque() && HasOpaqueTextures(actor) && !shader->HasFragmentShaderCode() &&
    shader->GetNumberOfShaderReplacements() == 0;
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

// Whether an assembly draws the actors that it gives and nothing else: no volume, and no level of
// detail. Annotations among its parts are drawn over the frame.
bool HasActorsOnly(const SceneProp& item)
{
  return item.Volumes.empty() &&
    std::all_of(item.Parts.begin(), item.Parts.end(),
      [&item](const ScenePart& part) {
        return std::find(item.Actors.begin(), item.Actors.end(), part.Actor) != item.Actors.end();
      }) &&
    std::all_of(item.OtherParts.begin(), item.OtherParts.end(),
      [&item](vtkProp* part) { return part == item.Prop || part->IsA("vtkActor2D"); });
}

// Passes that take part in the mappers' shaders are named in the props' keys while they draw.
bool HasOcclusionPass(vtkProp* prop)
{
  vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
  vtkInformation* keys = prop->GetPropertyKeys();
  for (int k = 0; keys && keys->Has(key) && k < key->Length(keys); ++k)
  {
    if (key->Get(keys, k)->IsA("vtkSSAOPass"))
    {
      return true;
    }
  }
  return false;
}

// As far as that does not depend on single props.
bool MayHideAllBehind(vtkRenderer* renderer, const vtkRenderPass* delegate)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  return !delegate && !window->GetLineSmoothing() && !window->GetPointSmoothing() &&
    !window->GetPolygonSmoothing();
}
}

//------------------------------------------------------------------------------
SceneSupport::SceneSupport(
  const SceneProps& props, vtkRenderer* renderer, const vtkRenderPass* delegate)
{
  for (const SceneProp& item : props.GetProps())
  {
    if (item.InView)
    {
      this->AddProp(item);
      this->AddVolumes(item);
      this->Actors.insert(this->Actors.end(), item.Actors.begin(), item.Actors.end());
      this->KeyHolders.push_back(item.Prop);
      if (HasTrait(item.Prop, ClassTrait::KeepsItsKeys))
      {
        this->KeyHolders.insert(this->KeyHolders.end(), item.Actors.begin(), item.Actors.end());
      }
    }
  }
  const bool removesLines = renderer->GetUseHiddenLineRemoval() != 0;
  this->HidesLines = this->HidesLines && removesLines;
  this->AllShadersInjectable =
    this->AllShadersInjectable && !delegate && !renderer->GetUseSSAO() && !this->HidesLines;
  const bool mayHide = MayHideAllBehind(renderer, delegate);
  this->AllOpaque = this->AllOpaque && mayHide;
  if (!mayHide || removesLines)
  {
    this->Solids.clear();
  }
  std::sort(this->Solids.begin(), this->Solids.end(), std::less<const vtkProp*>());
}

//------------------------------------------------------------------------------
void SceneSupport::AddProp(const SceneProp& item)
{
  vtkProp* prop = item.Prop;
  if (HasTrait(prop, ClassTrait::DrawsItsParts) && HasActorsOnly(item))
  {
    for (vtkActor* actor : item.Actors)
    {
      this->AddGeometry(actor);
    }
  }
  else if (AirlightScenePass::IsPointGaussians(prop))
  {
    this->PointGaussians = true;
  }
  else
  {
    this->AddGeometry(prop);
  }
  this->DrawsOverMedium =
    this->DrawsOverMedium || this->PointGaussians || prop->HasTranslucentPolygonalGeometry();
  this->AllShadersInjectable = this->AllShadersInjectable && !HasForeignPass(prop);
  this->HidesLines = this->HidesLines || vtkHiddenLineRemovalPass::WireframePropsExist(&prop, 1);
  this->OcclusionOutside = this->OcclusionOutside || HasOcclusionPass(prop);
  if (DrawsAllOfIt(prop))
  {
    this->Solids.push_back(prop);
  }
}

//------------------------------------------------------------------------------
// What a prop, or a part of one, draws as it is.
void SceneSupport::AddGeometry(vtkProp* prop)
{
  const bool gaussians = AirlightScenePass::IsPointGaussians(prop);
  const bool supported = HasSupportedMapper(prop) && !gaussians;
  this->AllShadersInjectable = this->AllShadersInjectable && supported && !HasForeignPass(prop);
  this->AllOpaque = this->AllOpaque && supported && IsSolidProp(prop);
  this->DrawsOverMedium = this->DrawsOverMedium || gaussians ||
    prop->HasTranslucentPolygonalGeometry() || !(prop->IsA("vtkActor") || prop->IsA("vtkActor2D"));
}

//------------------------------------------------------------------------------
void SceneSupport::AddVolumes(const SceneProp& prop)
{
  this->Volumes.insert(this->Volumes.end(), prop.Volumes.begin(), prop.Volumes.end());
  if (std::any_of(prop.Volumes.begin(), prop.Volumes.end(),
        [](vtkVolume* volume) { return MayCastRays(volume->GetMapper()); }))
  {
    this->RayCast.push_back(prop.Prop);
  }
}
}
