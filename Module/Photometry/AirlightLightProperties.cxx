// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Photometry/AirlightLightProperties.h"

#include "Medium/AirlightConvert.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <sstream>

namespace airlight
{
namespace
{
class PropertiesHolder : public vtkObject
{
public:
  static PropertiesHolder* New();
  vtkTypeMacro(PropertiesHolder, vtkObject);

  LightProperties Values;
};
vtkStandardNewMacro(PropertiesHolder);

vtkInformationObjectBaseKey* GetKey()
{
  static vtkInformationObjectBaseKey* key =
    vtkInformationObjectBaseKey::MakeKey("PROPERTIES", "vtkAirlightLight");
  return key;
}

PropertiesHolder* FindHolder(vtkLight* light)
{
  vtkInformation* information = light ? light->GetInformation() : nullptr;
  return information ? PropertiesHolder::SafeDownCast(information->Get(GetKey())) : nullptr;
}

// Copies of a light share the old holder.
LightProperties& ChangeProperties(vtkLight* light)
{
  if (!light->GetInformation())
  {
    vtkNew<vtkInformation> information;
    light->SetInformation(information);
  }
  vtkNew<PropertiesHolder> holder;
  holder->Values = GetProperties(light);
  light->GetInformation()->Set(GetKey(), holder);
  light->Modified();
  return holder->Values; // the light holds it
}
}

//------------------------------------------------------------------------------
const LightProperties& GetProperties(vtkLight* light)
{
  static const LightProperties defaults;
  const PropertiesHolder* holder = FindHolder(light);
  return holder ? holder->Values : defaults;
}

//------------------------------------------------------------------------------
void SetScatters(vtkLight* light, bool scatters)
{
  const LightProperties& old = GetProperties(light);
  if (!old.ScattersIsSet || old.Scatters != scatters)
  {
    LightProperties& properties = ChangeProperties(light);
    properties.ScattersIsSet = true;
    properties.Scatters = scatters;
  }
}

//------------------------------------------------------------------------------
std::string SetPhotometry(vtkLight* light, const char* file)
{
  const std::string name = file ? file : "";
  std::shared_ptr<const Photometry> photometry;
  std::string error;
  if (!name.empty() && !(photometry = Photometry::Read(name, error)))
  {
    return "The light keeps its photometry: " + error;
  }
  LightProperties& properties = ChangeProperties(light);
  properties.PhotometryFile = name;
  properties.Goniometry = photometry;
  properties.Table =
    photometry ? std::make_shared<std::vector<glm::dvec4>>(photometry->Pack()) : nullptr;
  return "";
}

//------------------------------------------------------------------------------
std::string SetPhotometryUp(vtkLight* light, const glm::dvec3& up)
{
  if (!IsModerate(up) || up == glm::dvec3(0.0))
  {
    std::ostringstream text;
    text << "The up direction of a photometric file must be finite and not 0; it got (" << up.x
         << ", " << up.y << ", " << up.z << ").";
    return text.str();
  }
  ChangeProperties(light).PhotometryUp = up;
  return "";
}

//------------------------------------------------------------------------------
void SetVisible(vtkLight* light, bool visible)
{
  if (GetProperties(light).Visible != visible)
  {
    ChangeProperties(light).Visible = visible;
  }
}

//------------------------------------------------------------------------------
std::string SetExtent(vtkLight* light, const LampExtent& extent)
{
  const glm::dvec4 values(extent.Radius, extent.Size, extent.AngularDiameter);
  const bool valid = glm::all(glm::greaterThanEqual(values, glm::dvec4(0.0))) &&
    IsModerate(glm::dvec3(values)) && extent.AngularDiameter < 180.0;
  if (!valid)
  {
    std::ostringstream text;
    text << "The extent of a lamp must be finite and at least 0, and an angle below 180: the light "
            "keeps its own. It got radius "
         << values.x << ", size " << values.y << " x " << values.z << ", angular diameter "
         << values.w << ".";
    return text.str();
  }
  const LampExtent& old = GetProperties(light).Extent;
  if (values != glm::dvec4(old.Radius, old.Size, old.AngularDiameter))
  {
    ChangeProperties(light).Extent = extent;
  }
  return "";
}

//------------------------------------------------------------------------------
std::string GetCameraLightsText(int count, bool dark)
{
  const std::string lights = count == 1 ? "1 light is" : std::to_string(count) + " lights are";
  return lights +
    " fixed to the camera (headlight or camera light): such lights light surfaces, but the medium "
    "does not scatter them, and they cast no shadows. Call "
    "vtkAirlightLight::SetScatters(light, true) for each that shall do both, or with false to "
    "silence this." +
    (dark ? " The medium scatters no other light: add a vtkLight that stays in the scene "
            "(SetLightTypeToSceneLight(), its default)."
          : "");
}
}
