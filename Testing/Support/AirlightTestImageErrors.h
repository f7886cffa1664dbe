// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far the buffers of one picture are from those of another, over all pixels.
 */

#ifndef AirlightTestImageErrors_h
#define AirlightTestImageErrors_h

#include "AirlightTestBuffers.h"

#include <string>

namespace airlight_test
{
// Of the first component.
double GetMean(vtkImageData* image);

// Root mean square of the first component's error, over the mean.
double GetError(const Buffers& picture, const Buffers& exact, const std::string& name);
}

#endif
