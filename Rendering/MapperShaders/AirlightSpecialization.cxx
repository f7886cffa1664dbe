// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightSpecialization.h"

#include "MapperShaders/AirlightMapperShader.h"

#include "vtkLight.h"

namespace airlight
{
//------------------------------------------------------------------------------
bool operator==(const LightSpecialization& a, const LightSpecialization& b)
{
  return a.Scatters == b.Scatters && a.Sun == b.Sun && a.Goniometric == b.Goniometric &&
    a.Positional == b.Positional && a.Spot == b.Spot && a.InverseSquare == b.InverseSquare;
}

//------------------------------------------------------------------------------
std::vector<LightSpecialization> SpecializeLights(const std::vector<SceneLight>& sceneLights)
{
  std::vector<LightSpecialization> lights;
  if (sceneLights.size() > MaximumSpecializedLights)
  {
    return lights;
  }
  for (const SceneLight& sceneLight : sceneLights)
  {
    const double* fading = sceneLight.Light->GetAttenuationValues();
    // VTK compares in single precision.
    lights.push_back({ sceneLight.Scatters(), f64::airlightIsDirectional(sceneLight.Values),
      sceneLight.Values.goniometric != 0, sceneLight.Light->GetPositional() != 0,
      static_cast<float>(sceneLight.Light->GetConeAngle()) < 90.0f,
      fading[0] == 0.0 && fading[1] == 0.0 && fading[2] == 1.0 });
  }
  return lights;
}

namespace
{
using Key = SpecializationKey;

// A uniform of VTK's, and its value if the key says so. Those of lights stand for each light.
struct Constant
{
  MapperText Uniform;
  const char* Value;
  bool (*IsKnown)(const Key& key, size_t light);
};

const Constant Constants[] = {
  { MapperText::Ambient, "0.0", [](const Key& key, size_t) { return key.Material.NoAmbient; } },
  { MapperText::Diffuse, "1.0", [](const Key& key, size_t) { return key.Material.FullDiffuse; } },
  { MapperText::Specular, "0.0", [](const Key& key, size_t) { return key.Material.NoSpecular; } },
  { MapperText::Opacity, "1.0", [](const Key& key, size_t) { return key.Material.Opaque; } },
  { MapperText::LightPositional, "0",
    [](const Key& key, size_t k) { return !key.Lights[k].Positional; } },
  { MapperText::LightPositional, "1",
    [](const Key& key, size_t k) { return key.Lights[k].Positional; } },
  { MapperText::LightConeAngle, "90.0",
    [](const Key& key, size_t k) { return !key.Lights[k].Spot; } },
  { MapperText::LightAttenuation, "vec3(0.0, 0.0, 1.0)",
    [](const Key& key, size_t k) { return key.Lights[k].InverseSquare; } },
};
}

//------------------------------------------------------------------------------
void SpecializeShader(std::string& fragmentShader, const SpecializationKey& key)
{
  for (const Constant& constant : Constants)
  {
    const size_t count = IsOfLight(constant.Uniform) ? key.Lights.size() : 1;
    for (size_t k = 0; k < count; ++k)
    {
      if (constant.IsKnown(key, k))
      {
        MakeConstant(fragmentShader, constant.Uniform, constant.Value, k);
      }
    }
  }
}
}
