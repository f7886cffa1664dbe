// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Vector3_h
#define Vector3_h

#include <array>

namespace airlight
{

using Vector3 = std::array<double, 3>; ///< a position, a direction or an RGB triple

}

#endif
