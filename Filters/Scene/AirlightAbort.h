// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a filter was told to stop.
 */

#ifndef AirlightAbort_h
#define AirlightAbort_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace airlight
{
// From VTK 9.3 on a filter also stops where one that it gets its input from was told to.
inline bool IsAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}
}

#endif
