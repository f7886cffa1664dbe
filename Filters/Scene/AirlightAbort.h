// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a filter was requested to stop.
 */

#ifndef AirlightAbort_h
#define AirlightAbort_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace airlight
{
// From VTK 9.3 on a filter also stops if one upstream was requested to.
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
