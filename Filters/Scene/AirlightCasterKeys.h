// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The property keys that say whether a prop casts a shadow, how opaque the shadow is, and which
 * volumes are media. The renderer and the CPU reference read them here; users know them as keys of
 * vtkAirlightPass.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightCasterKeys_h
#define AirlightCasterKeys_h

#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <string>

class vtkInformationDoubleVectorKey;
class vtkInformationIntegerKey;
class vtkInformationObjectBaseKey;
class vtkPhaseFunction;
class vtkProp;

namespace airlight
{
// vtkAirlightPass::CASTS_SHADOW(), VOLUME_SCATTERS(), VOLUME_PHASE_FUNCTION(), SHADOW_OPACITY().
vtkInformationIntegerKey* GetCastsShadowKey();
vtkInformationIntegerKey* GetVolumeScattersKey();
vtkInformationObjectBaseKey* GetVolumePhaseFunctionKey();
vtkInformationDoubleVectorKey* GetShadowOpacityKey();

// False only if the key is 0.
bool CastsShadow(vtkProp* prop);

// Whether a part of a prop is a volume with the key, and the prop itself. Only those are media.
bool IsMedium(vtkProp* part, vtkProp* prop);

// Null without the key, and where its object is of another class.
vtkPhaseFunction* GetVolumePhaseFunction(vtkProp* volume);

// Reads the opacity of a prop's shadow. Returns false and leaves `opacity` alone if the key is not
// set or not valid; an invalid key also gives a text in `error`.
bool ReadShadowOpacity(vtkProp* prop, glm::dvec3& opacity, std::string& error);

// Set the keys of a prop and keep its other keys. Props may share their keys; the others keep
// theirs. SetShadowOpacity() changes nothing and returns a text if a value is not valid.
VTKAIRLIGHT_EXPORT void SetCastsShadow(vtkProp* prop, bool casts);
void SetVolumeScatters(vtkProp* volume, bool scatters);
void SetVolumePhaseFunction(vtkProp* volume, vtkPhaseFunction* function);
std::string SetShadowOpacity(vtkProp* prop, const glm::dvec3& opacity);
}

#endif
