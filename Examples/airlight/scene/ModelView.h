// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelView_h
#define ModelView_h

#include "scene/Scene.h"

#include <string>
#include <vector>

namespace airlight
{

/**
 * How a model stands: three directions at right angles, of length 1.
 */
struct ModelAxes
{
  Vector3 Right = { 1.0, 0.0, 0.0 };
  Vector3 Up = { 0.0, 1.0, 0.0 };
  Vector3 Front = { 0.0, 0.0, 1.0 }; ///< towards who looks at it
};

/**
 * "x", "y", "z", "-x", "-y" and "-z".
 */
std::vector<std::string> GetUpNames();

/**
 * The axes of a model that stands with `up` upwards, one of GetUpNames(). Empty: as is usual for
 * files with the extension of `fileName`, z for .stl and .3ds and y for all others.
 *
 * Throws UserError for another name.
 */
ModelAxes GetModelAxes(const std::string& up, const std::string& fileName);

/**
 * The axes in which a camera sees a model stand.
 */
ModelAxes GetCameraAxes(const CameraSettings& camera);

/**
 * A vector for a model with y up and its front towards z, turned to these axes.
 */
Vector3 Turn(const Vector3& vector, const ModelAxes& axes);

/**
 * Moves a camera to the front of a model, to the right and above, so far away that all of the model
 * is in a picture of this aspect, width over height, however the model turns about the way up
 * through `center`.
 */
void SeeModel(CameraSettings& camera, const std::vector<Surface>& surfaces, const Vector3& center,
  const ModelAxes& axes, double aspect);

}

#endif
