// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Mesa's software renderer frees what a draw took, and allocates it again for the next one. Whether that goes
 * back to the system, page by page, depends on what else lies in the heap: on a virtual machine a frame
 * of plain VTK took up to twice as long by that chance, one of the pass by a third.
 */

#ifndef KeepMemory_h
#define KeepMemory_h

namespace benchmarks
{
// Lets the process keep what it frees. Does nothing where the C library is not glibc.
void KeepMemory();
}

#endif
