// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightContext.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(AirlightContext);

//------------------------------------------------------------------------------
AirlightContext::AirlightContext() = default;
AirlightContext::~AirlightContext() = default;

//------------------------------------------------------------------------------
void AirlightContext::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Free)
  {
    this->Free(window);
  }
}
