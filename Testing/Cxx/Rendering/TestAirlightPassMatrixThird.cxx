// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass for every kind of light in every kind of region, density and phase function: a quarter of
// the phase functions (AirlightTestPassMatrix.h).

#include "AirlightTestPassMatrix.h"

int TestAirlightPassMatrixThird(int, char*[]) { return airlight_test::RunPassMatrix(2); }
