// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightLight.h"

#include "Photometry/AirlightLightProperties.h"
#include "vtkAirlight.h"

#include "vtkLight.h"
#include "vtkObjectFactory.h"

#include <algorithm>

using namespace airlight;

namespace
{
bool CheckLight(const vtkLight* light, const char* function)
{
  if (!light)
  {
    vtkGenericWarningMacro("vtkAirlightLight::" << function << " needs a light; it got null.");
  }
  return light != nullptr;
}

void ChangeExtent(vtkLight* light, const LampExtent& extent)
{
  const std::string error = SetExtent(light, extent);
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(light, << error);
  }
}
}

vtkStandardNewMacro(vtkAirlightLight);

//------------------------------------------------------------------------------
void vtkAirlightLight::SetRadiantIntensity(vtkLight* light, const double rgb[3])
{
  if (CheckLight(light, "SetRadiantIntensity()"))
  {
    vtkAirlight::SetRadiantIntensity(light, rgb);
  }
}

void vtkAirlightLight::GetRadiantIntensity(vtkLight* light, double rgb[3])
{
  std::fill_n(rgb, 3, 0.0);
  if (CheckLight(light, "GetRadiantIntensity()"))
  {
    vtkAirlight::GetRadiantIntensity(light, rgb);
  }
}

void vtkAirlightLight::SetIrradiance(vtkLight* light, const double rgb[3])
{
  if (CheckLight(light, "SetIrradiance()"))
  {
    vtkAirlight::SetIrradiance(light, rgb);
  }
}

//------------------------------------------------------------------------------
void vtkAirlightLight::SetScatters(vtkLight* light, bool scatters)
{
  if (!CheckLight(light, "SetScatters()"))
  {
    return;
  }
  airlight::SetScatters(light, scatters);
}

bool vtkAirlightLight::GetScatters(vtkLight* light)
{
  const LightProperties& properties = GetProperties(light);
  return properties.ScattersIsSet ? properties.Scatters : light && !IsFixedToCamera(light);
}

//------------------------------------------------------------------------------
bool vtkAirlightLight::SetPhotometry(vtkLight* light, const char* file)
{
  if (!CheckLight(light, "SetPhotometry()"))
  {
    return false;
  }
  const std::string error = airlight::SetPhotometry(light, file);
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(light, << error);
  }
  return error.empty();
}

const char* vtkAirlightLight::GetPhotometry(vtkLight* light)
{
  const LightProperties& properties = GetProperties(light);
  return properties.Goniometry ? properties.PhotometryFile.c_str() : nullptr;
}

double vtkAirlightLight::GetPhotometryMaximum(vtkLight* light)
{
  const LightProperties& properties = GetProperties(light);
  return properties.Goniometry ? properties.Goniometry->GetMaximum() : 0.0;
}

//------------------------------------------------------------------------------
void vtkAirlightLight::SetPhotometryUp(vtkLight* light, double x, double y, double z)
{
  if (!CheckLight(light, "SetPhotometryUp()"))
  {
    return;
  }
  const std::string error = airlight::SetPhotometryUp(light, { x, y, z });
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(light, << error);
  }
}

void vtkAirlightLight::GetPhotometryUp(vtkLight* light, double up[3])
{
  std::copy_n(&GetProperties(light).PhotometryUp.x, 3, up);
}

//------------------------------------------------------------------------------
void vtkAirlightLight::SetRadius(vtkLight* light, double radius)
{
  if (CheckLight(light, "SetRadius()"))
  {
    LampExtent extent = GetProperties(light).Extent;
    extent.Radius = radius;
    ChangeExtent(light, extent);
  }
}

double vtkAirlightLight::GetRadius(vtkLight* light) { return GetProperties(light).Extent.Radius; }

//------------------------------------------------------------------------------
void vtkAirlightLight::SetSize(vtkLight* light, double width, double height)
{
  if (CheckLight(light, "SetSize()"))
  {
    LampExtent extent = GetProperties(light).Extent;
    extent.Size = { width, height };
    ChangeExtent(light, extent);
  }
}

void vtkAirlightLight::GetSize(vtkLight* light, double size[2])
{
  std::copy_n(&GetProperties(light).Extent.Size.x, 2, size);
}

//------------------------------------------------------------------------------
void vtkAirlightLight::SetAngularDiameter(vtkLight* light, double degrees)
{
  if (CheckLight(light, "SetAngularDiameter()"))
  {
    LampExtent extent = GetProperties(light).Extent;
    extent.AngularDiameter = degrees;
    ChangeExtent(light, extent);
  }
}

double vtkAirlightLight::GetAngularDiameter(vtkLight* light)
{
  return GetProperties(light).Extent.AngularDiameter;
}

//------------------------------------------------------------------------------
void vtkAirlightLight::SetVisible(vtkLight* light, bool visible)
{
  if (CheckLight(light, "SetVisible()"))
  {
    airlight::SetVisible(light, visible);
  }
}

bool vtkAirlightLight::GetVisible(vtkLight* light) { return GetProperties(light).Visible; }

//------------------------------------------------------------------------------
void vtkAirlightLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
