// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightDelegateProps.h"

#include "Scene/AirlightClassTraits.h"

#include "vtkActor.h"
#include "vtkCameraPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"

#include <algorithm>
#include <iterator>

namespace
{
//------------------------------------------------------------------------------
// The opaque geometry of a prop, or of none.
class ProxyProp : public vtkProp
{
public:
  static ProxyProp* New();
  vtkTypeMacro(ProxyProp, vtkProp);

  void SetProp(vtkProp* prop, bool* drawn)
  {
    this->Prop = prop;
    this->Drawn = drawn;
    this->SetPropertyKeys(prop ? prop->GetPropertyKeys() : nullptr);
  }

  double* GetBounds() override { return this->Prop ? this->Prop->GetBounds() : nullptr; }
  vtkMatrix4x4* GetMatrix() override { return this->Prop ? this->Prop->GetMatrix() : nullptr; }
  vtkTypeBool HasOpaqueGeometry() override { return this->Prop && this->Prop->HasOpaqueGeometry(); }
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    *this->Drawn = true;
    return this->Prop ? this->Prop->RenderOpaqueGeometry(viewport) : 0;
  }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return this->Nothing(); }
  int RenderVolumetricGeometry(vtkViewport*) override { return this->Nothing(); }
  int RenderOverlay(vtkViewport*) override { return this->Nothing(); }

private:
  ProxyProp() = default;
  ~ProxyProp() override = default;

  int Nothing()
  {
    *this->Drawn = true;
    return 0;
  }

  vtkProp* Prop = nullptr;
  bool* Drawn = nullptr;
};

vtkStandardNewMacro(ProxyProp);

//------------------------------------------------------------------------------
// Subclasses may draw with other actors of theirs.
bool IsPlain(vtkProp* prop)
{
  return airlight::HasTrait(prop, airlight::ClassTrait::DrawsItself) &&
    !prop->HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
// The first such pass in one and those that it holds.
template <typename Is>
vtkRenderPass* Find(vtkRenderPass* pass, const Is& is)
{
  if (!pass || is(pass))
  {
    return pass;
  }
  if (auto* steps = vtkRenderStepsPass::SafeDownCast(pass))
  {
    vtkRenderPass* opaque = Find(steps->GetOpaquePass(), is);
    return opaque ? opaque : Find(steps->GetTranslucentPass(), is);
  }
  if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    return Find(camera->GetDelegatePass(), is);
  }
  if (auto* image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    return Find(image->GetDelegatePass(), is);
  }
  if (auto* supersampling = vtkSSAAPass::SafeDownCast(pass))
  {
    return Find(supersampling->GetDelegatePass(), is);
  }
  auto* sequence = vtkSequencePass::SafeDownCast(pass);
  vtkRenderPassCollection* passes = sequence ? sequence->GetPasses() : nullptr;
  vtkRenderPass* found = nullptr;
  for (int i = 0; passes && !found && i < passes->GetNumberOfItems(); ++i)
  {
    found = Find(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)), is);
  }
  return found;
}
}

namespace airlight
{
DelegateProps::DelegateProps() = default;
DelegateProps::~DelegateProps() = default;

//------------------------------------------------------------------------------
void DelegateProps::Show(const vtkRenderState* from, vtkRenderState& to)
{
  this->Clear();
  this->Add(nullptr); // so that there is one by which to tell
  for (int i = 0; i < from->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = from->GetPropArray()[i];
    if (IsPlain(prop))
    {
      this->Props.push_back(prop);
    }
    else
    {
      this->Add(prop);
    }
  }
  to.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
}

//------------------------------------------------------------------------------
void DelegateProps::Add(vtkProp* prop)
{
  auto proxyProp = vtkSmartPointer<ProxyProp>::New();
  proxyProp->SetProp(prop, &this->Drawn);
  this->ProxyProps.push_back(proxyProp);
  this->Props.emplace_back(proxyProp);
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> DelegateProps::GetHidden(const vtkRenderState* s) const
{
  std::vector<vtkProp*> hidden;
  std::copy_if(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount(),
    std::back_inserter(hidden), [this](vtkProp* prop) { return this->Hidden.count(prop) > 0; });
  return hidden;
}

//------------------------------------------------------------------------------
void DelegateProps::Clear()
{
  this->Props.clear();
  this->ProxyProps.clear();
  this->Hidden.clear();
  this->Drawn = false;
}

//------------------------------------------------------------------------------
vtkRenderPass* FindTranslucentPass(vtkRenderPass* delegate)
{
  return Find(delegate, [](vtkRenderPass* pass) {
    return vtkTranslucentPass::SafeDownCast(pass) ||
      vtkOrderIndependentTranslucentPass::SafeDownCast(pass) ||
      vtkDepthPeelingPass::SafeDownCast(pass);
  });
}

//------------------------------------------------------------------------------
bool HasOpaquePass(vtkRenderPass* delegate)
{
  return Find(delegate, [](vtkRenderPass* pass) {
    return vtkOpaquePass::SafeDownCast(pass) || HasTrait(pass, ClassTrait::OpaqueSurfaces);
  });
}
}
