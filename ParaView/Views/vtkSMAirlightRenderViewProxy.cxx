// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMAirlightRenderViewProxy.h"

#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"

vtkStandardNewMacro(vtkSMAirlightRenderViewProxy);

//------------------------------------------------------------------------------
vtkTypeUInt32 vtkSMAirlightRenderViewProxy::PreRender(bool interactive)
{
  vtkSMPropertyHelper(this, "KeepsBackground").Set(GetTransparentBackground() ? 1 : 0);
  this->UpdateProperty("KeepsBackground");
  return this->Superclass::PreRender(interactive);
}

//------------------------------------------------------------------------------
void vtkSMAirlightRenderViewProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
