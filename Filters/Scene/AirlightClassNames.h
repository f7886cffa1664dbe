// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Objects of certain classes and of none that is derived from these, which may do anything else.
 */

#ifndef AirlightClassNames_h
#define AirlightClassNames_h

#include "vtkObject.h"

#include <algorithm>
#include <cstring>
#include <initializer_list>

namespace airlight
{
// False of null.
inline bool IsAnyOf(vtkObject* object, std::initializer_list<const char*> names)
{
  return object && std::any_of(names.begin(), names.end(), [object](const char* name) {
    return std::strcmp(object->GetClassName(), name) == 0;
  });
}
}

#endif
