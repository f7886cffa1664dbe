// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSIAirlightLightProperty.h"

#include "vtkAirlightLight.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkSMMessage.h"

#include <string>

namespace
{
/**
 * Calls a function of vtkAirlightLight; false if there is none of this name for such values.
 */
bool Call(const std::string& name, vtkLight* light, const Variant& values)
{
  const auto& numbers = values.float64();
  if (name == "SetPhotometry" && values.txt_size() == 1)
  {
    vtkAirlightLight::SetPhotometry(light, values.txt(0).c_str());
  }
  else if (name == "SetPhotometryUp" && numbers.size() == 3)
  {
    vtkAirlightLight::SetPhotometryUp(light, numbers[0], numbers[1], numbers[2]);
  }
  else if (name == "SetRadius" && numbers.size() == 1)
  {
    vtkAirlightLight::SetRadius(light, numbers[0]);
  }
  else if (name == "SetSize" && numbers.size() == 2)
  {
    vtkAirlightLight::SetSize(light, numbers[0], numbers[1]);
  }
  else if (name == "SetAngularDiameter" && numbers.size() == 1)
  {
    vtkAirlightLight::SetAngularDiameter(light, numbers[0]);
  }
  else if (name == "SetVisible" && values.integer_size() == 1)
  {
    vtkAirlightLight::SetVisible(light, values.integer(0) != 0);
  }
  else
  {
    return false;
  }
  return true;
}
}

vtkStandardNewMacro(vtkSIAirlightLightProperty);

//------------------------------------------------------------------------------
bool vtkSIAirlightLightProperty::Push(vtkSMMessage* message, int offset)
{
  this->SaveValueToCache(message, offset); // for clients that ask for it
  if (!this->GetVTKObject())
  {
    return true; // this process has none
  }
  vtkLight* light = vtkLight::SafeDownCast(this->GetVTKObject());
  const std::string name = this->GetCommand() ? this->GetCommand() : "";
  if (light == nullptr)
  {
    vtkErrorMacro("The property " << this->GetXMLName() << " is of a proxy that is no light.");
    return false;
  }
  if (!Call(name, light, message->GetExtension(ProxyState::property, offset).value()))
  {
    vtkErrorMacro("The command " << name << " of the property " << this->GetXMLName()
                                 << " is no function of vtkAirlightLight for its values.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkSIAirlightLightProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
