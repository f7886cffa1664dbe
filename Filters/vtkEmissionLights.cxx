// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEmissionLights.h"

#include "Emission/AirlightEmissionClusters.h"
#include "Medium/AirlightConvert.h"
#include "vtkAirlightLight.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace airlight;

// The renderers that were given the lights.
class vtkEmissionLights::Renderers
{
public:
  std::vector<vtkWeakPointer<vtkRenderer>> All;
};

vtkStandardNewMacro(vtkEmissionLights);

namespace
{
vtkLight* GetLight(vtkLightCollection* lights, int index)
{
  return vtkLight::SafeDownCast(lights->GetItemAsObject(index));
}

// Empty, or why no lights can be fitted.
std::string FindProblem(vtkParticipatingMedium* medium)
{
  if (!medium)
  {
    return "the medium is null: call SetMedium()";
  }
  if (medium->GetRegion() == vtkParticipatingMedium::SURFACE)
  {
    return "the region of the medium is a closed surface, which is not sampled: use another "
           "region, or a density image that is 0 outside the surface";
  }
  if (medium->GetRegion() == vtkParticipatingMedium::UNBOUNDED &&
    medium->GetDensity() != vtkParticipatingMedium::IMAGE)
  {
    return "the medium is unbounded and would take infinitely many: call SetRegion() of the "
           "medium, "
           "or use a density image";
  }
  if (medium->GetDensity() == vtkParticipatingMedium::IMAGE && !medium->GetDensityGrid())
  {
    return "the density image of the medium cannot be used";
  }
  return "";
}
}

//------------------------------------------------------------------------------
vtkEmissionLights::vtkEmissionLights()
  : Followers(new Renderers)
{
}

//------------------------------------------------------------------------------
vtkEmissionLights::~vtkEmissionLights() = default;

//------------------------------------------------------------------------------
void vtkEmissionLights::SetMedium(vtkParticipatingMedium* medium)
{
  if (this->Medium != medium)
  {
    this->Medium = medium;
    this->Placed = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkParticipatingMedium* vtkEmissionLights::GetMedium() { return this->Medium; }

//------------------------------------------------------------------------------
vtkLightCollection* vtkEmissionLights::GetLights() { return this->Lights; }

//------------------------------------------------------------------------------
// As many as there are to be: the others leave the renderers.
void vtkEmissionLights::MakeLights()
{
  while (this->Lights->GetNumberOfItems() > this->NumberOfLights)
  {
    const vtkSmartPointer<vtkLight> last =
      GetLight(this->Lights, this->Lights->GetNumberOfItems() - 1);
    for (vtkRenderer* renderer : this->Followers->All)
    {
      if (renderer)
      {
        renderer->RemoveLight(last);
      }
    }
    this->Lights->RemoveItem(last);
  }
  while (this->Lights->GetNumberOfItems() < this->NumberOfLights)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->PositionalOn();
    light->SetConeAngle(180.0);
    light->SetAttenuationValues(0.0, 0.0, 1.0);
    light->SwitchOff();
    this->Lights->AddItem(light);
    for (vtkRenderer* renderer : this->Followers->All)
    {
      if (renderer)
      {
        renderer->AddLight(light);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkEmissionLights::SwitchOff()
{
  for (int i = 0; i < this->Lights->GetNumberOfItems(); ++i)
  {
    GetLight(this->Lights, i)->SwitchOff();
  }
  this->Placed = false;
}

//------------------------------------------------------------------------------
bool vtkEmissionLights::Update()
{
  this->MakeLights();
  const std::string problem = FindProblem(this->Medium);
  if (!problem.empty())
  {
    this->SwitchOff();
    vtkErrorMacro(<< problem << ". There are no lights.");
    return false;
  }
  const f64::AirlightMedia media = ConvertMedia({ this->Medium }, glm::dvec3(0.0));
  const glm::dvec3 emission = media.item[0].emission;
  std::vector<glm::dvec3> centres;
  for (int i = 0; i < this->NumberOfLights && this->Placed; ++i)
  {
    vtkLight* light = GetLight(this->Lights, i);
    if (light->GetSwitch())
    {
      const double* place = light->GetPosition();
      centres.emplace_back(place[0], place[1], place[2]);
    }
  }
  const std::vector<EmissionCluster> clusters = emission == glm::dvec3(0.0)
    ? std::vector<EmissionCluster>()
    : FindClusters(SampleEmission(media.item[0]), this->NumberOfLights, centres);
  this->SwitchOff();
  for (size_t i = 0; i < clusters.size(); ++i)
  {
    vtkLight* light = GetLight(this->Lights, static_cast<int>(i));
    const glm::dvec3& intensity = clusters[i].Power;
    light->SetPosition(clusters[i].Centre.x, clusters[i].Centre.y, clusters[i].Centre.z);
    vtkAirlightLight::SetRadiantIntensity(light, &intensity.x);
    vtkAirlightLight::SetRadius(light, clusters[i].Radius);
    light->SwitchOn();
  }
  this->Placed = true;
  return true;
}

//------------------------------------------------------------------------------
void vtkEmissionLights::AddLights(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("AddLights() needs a renderer, not null.");
    return;
  }
  std::vector<vtkWeakPointer<vtkRenderer>>& all = this->Followers->All;
  if (std::find(all.begin(), all.end(), renderer) == all.end())
  {
    all.emplace_back(renderer);
    for (int i = 0; i < this->Lights->GetNumberOfItems(); ++i)
    {
      renderer->AddLight(GetLight(this->Lights, i));
    }
  }
}

//------------------------------------------------------------------------------
void vtkEmissionLights::RemoveLights(vtkRenderer* renderer)
{
  std::vector<vtkWeakPointer<vtkRenderer>>& all = this->Followers->All;
  const auto found = std::find(all.begin(), all.end(), renderer);
  if (renderer && found != all.end())
  {
    all.erase(found);
    for (int i = 0; i < this->Lights->GetNumberOfItems(); ++i)
    {
      renderer->RemoveLight(GetLight(this->Lights, i));
    }
  }
}

//------------------------------------------------------------------------------
void vtkEmissionLights::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Medium: " << this->Medium.GetPointer() << "\n";
  os << indent << "NumberOfLights: " << this->NumberOfLights << "\n";
}
