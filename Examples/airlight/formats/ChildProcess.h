// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChildProcess_h
#define ChildProcess_h

#include <functional>
#include <string>

namespace airlight
{

/**
 * Read a file in a child process and throw UserError, which names the file, if that goes wrong:
 * with the UserError of the task itself, or with a note that it crashed or ran out of memory, and
 * what it printed on the error stream.
 *
 * VTK 9.1's readers crash on some damaged files (a PLY file cut short corrupts the heap), and there
 * is no way back from that in the process where it happens. Call this before the process has
 * started threads or opened windows: check all files before the first one is read. On systems
 * without fork() the task is not run.
 */
void TryInChildProcess(const std::string& fileName, const std::function<void()>& task);

}

#endif
