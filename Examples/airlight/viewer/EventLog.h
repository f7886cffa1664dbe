// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef EventLog_h
#define EventLog_h

#include <string>

namespace airlight
{

/**
 * The text of a log of vtkInteractorEventRecorder, version 1.1 or 1.2: lines of event, x, y,
 * modifiers (shift 1, control 2, alt 4), key code, repeat count, key's name; # begins a comment.
 * Throws UserError with file and line where VTK would skip a line or read nonsense from it.
 */
std::string ReadEventLog(const std::string& fileName);

}

#endif
