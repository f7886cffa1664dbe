// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Preloaded by tests under AddressSanitizer: libraries stay in the process until it ends. Mesa unloads
// its driver before, and LeakSanitizer, which looks for leaks last, could no longer tell whose they are.
int dlclose(void* handle)
{
  return handle ? 0 : 1;
}
