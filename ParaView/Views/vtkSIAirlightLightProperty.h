// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSIAirlightLightProperty
 * @brief   a property of ParaView's lights that is a function of vtkAirlightLight
 *
 * ParaView sets properties by methods of the object behind a proxy. What vtkAirlightLight says of a
 * light is no method of it. The attribute `command` of such a property in XML names the function,
 * which is called with the light and the values:
 *
 *     <DoubleVectorProperty name="LampRadius" si_class="vtkSIAirlightLightProperty"
 *                           command="SetRadius" ... />
 *
 * SetPhotometry, SetPhotometryUp, SetRadius, SetSize, SetAngularDiameter and SetVisible. Another
 * command, another number of values, or a proxy that is no light is an error.
 *
 * @sa vtkAirlightLight
 */

#ifndef vtkSIAirlightLightProperty_h
#define vtkSIAirlightLightProperty_h

#include "vtkAirlightParaViewViewsModule.h" // for export macro
#include "vtkSIProperty.h"

class VTKAIRLIGHTPARAVIEWVIEWS_EXPORT vtkSIAirlightLightProperty : public vtkSIProperty
{
public:
  static vtkSIAirlightLightProperty* New();
  vtkTypeMacro(vtkSIAirlightLightProperty, vtkSIProperty);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSIAirlightLightProperty() = default;
  ~vtkSIAirlightLightProperty() override = default;

  bool Push(vtkSMMessage* message, int offset) override;

private:
  vtkSIAirlightLightProperty(const vtkSIAirlightLightProperty&) = delete;
  void operator=(const vtkSIAirlightLightProperty&) = delete;
};

#endif
