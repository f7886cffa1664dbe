// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightCasterKeys.h"

#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkPhaseFunction.h"
#include "vtkProp.h"

#include <algorithm>
#include <sstream>

namespace airlight
{
namespace
{
// The class whose static methods give the keys: vtkInformationKeyLookup::Find() takes its name.
constexpr const char* Location = "vtkAirlightPass";

// False also for NaN.
bool AreOpacities(const double* values, int length)
{
  return length == 3 &&
    std::all_of(values, values + length, [](double a) { return a >= 0.0 && a <= 1.0; });
}

std::string Describe(const char* what, vtkProp* prop, int length, const double* values)
{
  std::ostringstream text;
  text << what << " of the " << prop->GetClassName() << " (" << prop << ") is (";
  for (int i = 0; i < length; ++i)
  {
    text << (i > 0 ? ", " : "") << values[i];
  }
  text << "): give three opacities from 0 to 1, red, green and blue.";
  return text.str();
}

template <typename Set>
void ChangeKeys(vtkProp* prop, const Set& set)
{
  vtkNew<vtkInformation> keys;
  if (vtkInformation* own = prop->GetPropertyKeys())
  {
    keys->Copy(own);
  }
  set(keys.Get());
  prop->SetPropertyKeys(keys);
}
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* GetCastsShadowKey()
{
  static vtkInformationIntegerKey* key =
    vtkInformationIntegerKey::MakeKey("CASTS_SHADOW", Location);
  return key;
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* GetVolumeScattersKey()
{
  static vtkInformationIntegerKey* key =
    vtkInformationIntegerKey::MakeKey("VOLUME_SCATTERS", Location);
  return key;
}

//------------------------------------------------------------------------------
vtkInformationObjectBaseKey* GetVolumePhaseFunctionKey()
{
  static vtkInformationObjectBaseKey* key =
    vtkInformationObjectBaseKey::MakeKey("VOLUME_PHASE_FUNCTION", Location);
  return key;
}

//------------------------------------------------------------------------------
vtkInformationDoubleVectorKey* GetShadowOpacityKey()
{
  static vtkInformationDoubleVectorKey* key =
    vtkInformationDoubleVectorKey::MakeKey("SHADOW_OPACITY", Location);
  return key;
}

//------------------------------------------------------------------------------
bool CastsShadow(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationIntegerKey* key = GetCastsShadowKey();
  return !(keys && keys->Has(key) && keys->Get(key) == 0);
}

//------------------------------------------------------------------------------
bool IsMedium(vtkProp* part, vtkProp* prop)
{
  vtkInformation* keys = part->GetPropertyKeys();
  vtkInformationIntegerKey* key = GetVolumeScattersKey();
  return part == prop && part->IsA("vtkVolume") && keys && keys->Has(key) && keys->Get(key) != 0;
}

//------------------------------------------------------------------------------
vtkPhaseFunction* GetVolumePhaseFunction(vtkProp* volume)
{
  vtkInformation* keys = volume->GetPropertyKeys();
  return keys ? vtkPhaseFunction::SafeDownCast(keys->Get(GetVolumePhaseFunctionKey())) : nullptr;
}

//------------------------------------------------------------------------------
bool ReadShadowOpacity(vtkProp* prop, glm::dvec3& opacity, std::string& error)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationDoubleVectorKey* key = GetShadowOpacityKey();
  if (!keys || !keys->Has(key))
  {
    return false;
  }
  const int length = keys->Length(key);
  const double* values = keys->Get(key);
  if (!AreOpacities(values, length))
  {
    error = Describe("SHADOW_OPACITY", prop, length, values) +
      " Without them its shadow has the opacity of its vtkProperty";
    return false;
  }
  opacity = { values[0], values[1], values[2] };
  return true;
}

//------------------------------------------------------------------------------
void SetCastsShadow(vtkProp* prop, bool casts)
{
  ChangeKeys(prop, [&](vtkInformation* keys) { keys->Set(GetCastsShadowKey(), casts ? 1 : 0); });
}

//------------------------------------------------------------------------------
void SetVolumeScatters(vtkProp* volume, bool scatters)
{
  ChangeKeys(
    volume, [&](vtkInformation* keys) { keys->Set(GetVolumeScattersKey(), scatters ? 1 : 0); });
}

//------------------------------------------------------------------------------
void SetVolumePhaseFunction(vtkProp* volume, vtkPhaseFunction* function)
{
  ChangeKeys(
    volume, [&](vtkInformation* keys) { keys->Set(GetVolumePhaseFunctionKey(), function); });
}

//------------------------------------------------------------------------------
std::string SetShadowOpacity(vtkProp* prop, const glm::dvec3& opacity)
{
  if (!AreOpacities(&opacity.x, 3))
  {
    return Describe("The new shadow opacity", prop, 3, &opacity.x) + " It is unchanged.";
  }
  ChangeKeys(prop, [&](vtkInformation* keys) { keys->Set(GetShadowOpacityKey(), &opacity.x, 3); });
  return std::string();
}
}
