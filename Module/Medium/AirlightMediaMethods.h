// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What every class that is given media defines alike: the methods of its list of media, which is
 * Impl->Media (AirlightMediaList.h), and of its LightRadius. The headers declare them class by
 * class, as users and Python's wrapping read them.
 */

#ifndef AirlightMediaMethods_h
#define AirlightMediaMethods_h

#include "Medium/AirlightMediaList.h"

#include <cmath>

#define AirlightMediaMethodsMacro(Class)                                                       \
  void Class::AddMedium(vtkParticipatingMedium* medium)                                        \
  {                                                                                            \
    if (this->Impl->Media.Add(medium))                                                         \
    {                                                                                          \
      this->Modified();                                                                        \
    }                                                                                          \
  }                                                                                            \
  void Class::RemoveMedium(vtkParticipatingMedium* medium)                                     \
  {                                                                                            \
    if (this->Impl->Media.Remove(medium))                                                      \
    {                                                                                          \
      this->Modified();                                                                        \
    }                                                                                          \
  }                                                                                            \
  void Class::RemoveAllMedia()                                                                 \
  {                                                                                            \
    if (this->Impl->Media.Clear())                                                             \
    {                                                                                          \
      this->Modified();                                                                        \
    }                                                                                          \
  }                                                                                            \
  void Class::SetMedium(vtkParticipatingMedium* medium)                                        \
  {                                                                                            \
    if (this->Impl->Media.Set(medium))                                                         \
    {                                                                                          \
      this->Modified();                                                                        \
    }                                                                                          \
  }                                                                                            \
  int Class::GetNumberOfMedia() { return this->Impl->Media.GetSize(); }                        \
  vtkParticipatingMedium* Class::GetMedium(int index)                                          \
  {                                                                                            \
    if (!this->Impl->Media.Has(index))                                                         \
    {                                                                                          \
      vtkErrorMacro(<< "Medium " << index << " does not exist: there are "                     \
                    << this->GetNumberOfMedia() << ".");                                       \
      return nullptr;                                                                          \
    }                                                                                          \
    return this->Impl->Media.Get(index);                                                       \
  }                                                                                            \
  void Class::SetLightRadius(double radius)                                                    \
  {                                                                                            \
    if (!std::isfinite(radius) || radius < 0.0)                                                \
    {                                                                                          \
      vtkErrorMacro(<< "LightRadius " << radius << " must be finite and at least 0; it stays " \
                    << this->LightRadius << ".");                                              \
      return;                                                                                  \
    }                                                                                          \
    if (this->LightRadius != radius)                                                           \
    {                                                                                          \
      this->LightRadius = radius;                                                              \
      this->Modified();                                                                        \
    }                                                                                          \
  }

#endif
