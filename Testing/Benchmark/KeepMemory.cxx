// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "KeepMemory.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <limits>
#include <malloc.h>
#endif

namespace benchmarks
{
//------------------------------------------------------------------------------
void KeepMemory()
{
#ifdef __GLIBC__
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_MMAP_THRESHOLD, 32 << 20); // glibc's largest; what is above comes and goes as pages
#endif
}
}
