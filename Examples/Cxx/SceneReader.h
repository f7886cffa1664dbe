// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneReader_h
#define SceneReader_h

#include "Scene.h"

#include <string>

namespace airlight
{

/**
 * Read a scene file (JSON, the format of the reference scenes) and the meshes it names, which are
 * looked for beside the scene file and in the folder above it.
 *
 * Keys: `image` {width, height}; `camera` {position, focal_point, view_up, view_angle_deg};
 * `medium` {sigma_s, sigma_a, phase {type: isotropic or henyey_greenstein, g}} with optional
 * `bounds` {type: box, min, max} or {type: sphere, center, radius}, `density`
 * {type: exponential_height, reference_height, scale_height, up} (up may be left out: 0, 1, 0) and
 * `ambient_radiance`; `lights`, a list of {type: point, position, intensity},
 * {type: spot, position, direction, cone_half_angle_deg, exponent, intensity} or
 * {type: directional, direction, irradiance}; `surfaces`, a list of {mesh, albedo}; and for people
 * `name` and `description`.
 *
 * Throws UserError that names file, line and key for whatever is missing, unknown, of the wrong
 * type or out of range.
 */
Scene ReadScene(const std::string& fileName);

}

#endif
