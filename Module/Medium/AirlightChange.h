// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The result of a setter of a class that is no vtkObject: its owner reports the error, or is
 * modified.
 */

#ifndef AirlightChange_h
#define AirlightChange_h

#include <string>

namespace airlight
{
struct Change
{
  bool Changed = false;
  std::string Error; // then nothing has changed
};
}

#endif
