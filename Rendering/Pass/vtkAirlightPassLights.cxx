// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAirlightPass lets its users say of single lights.

#include "vtkAirlightPass.h"

#include "Pass/vtkAirlightPassInternals.h"

#include "vtkLight.h"

#include <algorithm>

using namespace airlight;

//------------------------------------------------------------------------------
LightOptions& vtkAirlightPass::Internals::GetOptions(vtkLight* light)
{
  auto& lights = this->Lights;
  lights.erase(std::remove_if(lights.begin(), lights.end(),
                 [](const LightOptions& options) { return !options.Light; }),
    lights.end());
  const auto it = std::find_if(lights.begin(), lights.end(),
    [light](const LightOptions& options) { return options.Light == light; });
  if (it != lights.end())
  {
    return *it;
  }
  lights.emplace_back();
  lights.back().Light = light;
  return lights.back();
}

//------------------------------------------------------------------------------
const LightOptions* vtkAirlightPass::Internals::FindOptions(vtkLight* light) const
{
  const auto it = std::find_if(this->Lights.begin(), this->Lights.end(),
    [light](const LightOptions& options) { return options.Light == light; });
  return light && it != this->Lights.end() ? &*it : nullptr;
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetLightScatters(vtkLight* light, bool scatters)
{
  if (!light)
  {
    vtkErrorMacro("SetLightScatters() needs a light; it got null.");
    return;
  }
  if (this->Impl->Switches.Set(light, scatters))
  {
    this->Modified();
  }
}

bool vtkAirlightPass::GetLightScatters(vtkLight* light)
{
  return this->Impl->Switches.Scatters(light);
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::SetLightPhotometry(vtkLight* light, const char* file)
{
  if (!light)
  {
    vtkErrorMacro("SetLightPhotometry() needs a light; it got null.");
    return false;
  }
  const std::string name = file ? file : "";
  std::shared_ptr<const Photometry> photometry;
  std::string error;
  if (!name.empty() && !(photometry = Photometry::Read(name, error)))
  {
    vtkErrorMacro(<< "The light keeps its photometry: " << error);
    return false;
  }
  LightOptions& options = this->Impl->GetOptions(light);
  options.PhotometryFile = name;
  options.Goniometry = photometry;
  options.Table =
    photometry ? std::make_shared<std::vector<glm::dvec4>>(photometry->Pack()) : nullptr;
  this->Modified();
  return true;
}

const char* vtkAirlightPass::GetLightPhotometry(vtkLight* light)
{
  const LightOptions* options = this->Impl->FindOptions(light);
  return options && options->Goniometry ? options->PhotometryFile.c_str() : nullptr;
}

double vtkAirlightPass::GetLightPhotometryMaximum(vtkLight* light)
{
  const LightOptions* options = this->Impl->FindOptions(light);
  return options && options->Goniometry ? options->Goniometry->GetMaximum() : 0.0;
}

//------------------------------------------------------------------------------
void vtkAirlightPass::SetLightPhotometryUp(vtkLight* light, double x, double y, double z)
{
  const glm::dvec3 up(x, y, z);
  if (!light || !IsModerate(up) || up == glm::dvec3(0.0))
  {
    vtkErrorMacro(
      << "SetLightPhotometryUp() needs a light and a finite direction that is not 0; it "
         "got "
      << (light ? "(" : "null and (") << x << ", " << y << ", " << z << ").");
    return;
  }
  this->Impl->GetOptions(light).Up = up;
  this->Modified();
}

void vtkAirlightPass::GetLightPhotometryUp(vtkLight* light, double up[3])
{
  const LightOptions* options = this->Impl->FindOptions(light);
  const glm::dvec3 direction = options ? options->Up : LightOptions().Up;
  std::copy_n(&direction.x, 3, up);
}
