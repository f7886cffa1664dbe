// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Makes a table of a phase function, for functions that poles do not follow closely enough.
 */

#ifndef AirlightPhaseSampler_h
#define AirlightPhaseSampler_h

#include "Phase/AirlightPhaseFunctions.h"

namespace airlight
{
// The rows as airlightPhaseTable() of glsl/AirlightPhase.glsl reads them, dense enough for a
// relative error of about 1e-6; `error` is the error found between them.
std::vector<glm::dvec4> SamplePhase(const PhaseFunction& function, double& error);
}

#endif
