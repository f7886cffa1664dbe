// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the shadow boundaries of a frame come from.
 */

#ifndef AirlightShadowMethod_h
#define AirlightShadowMethod_h

namespace airlight
{
enum class ShadowMethod
{
  None,
  Planes,
  Map,  // boundaries from shadow maps
  March // shadow maps and a ray march
};
}

#endif
