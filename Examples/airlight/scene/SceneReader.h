// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneReader_h
#define SceneReader_h

#include "scene/Scene.h"

#include <string>

namespace airlight
{

/**
 * Read a scene file (JSON, the format of the reference scenes) and the files it names, which are
 * looked for beside the scene file and in the folder above it.
 *
 * Keys:
 *  - `image` {width, height}; `camera` {position, focal_point, view_up, view_angle_deg};
 *  - `medium` {sigma_s, sigma_a, phase} with `phase` one of {type: isotropic}, {type: rayleigh},
 *    {type: henyey_greenstein, g}, {type: schlick, k}, {type: cornette_shanks, g},
 *    {type: mie_hazy}, {type: mie_murky}, {type: draine, g, alpha} or
 *    {type: tabulated, table: a file, see ReadPhaseTable()};
 *    optional in `medium`: `bounds` {type: box, min, max}, {type: sphere, center, radius},
 *    {type: cylinder, center, radius, height, axis} (axis may be left out: 0, 1, 0) or
 *    {type: surface, mesh: a file of a closed mesh}, `density`
 *    {type: exponential_height, reference_height, scale_height, up} (up may be left out: 0, 1, 0;
 *    and with multiple scattering of suns may go `ground_height` and `ground_albedo`, r, g, b, see
 *    vtkParticipatingMedium::SetGround()),
 *    `ambient_radiance`, `sky` {radiance, ground_radiance, up} (0, 0, 0 and, if the density does
 *    not fall with height, 0, 1, 0), see vtkParticipatingMedium::SetSkyRadiance(), `emission`, and
 *    `multiple_scattering`, true or false (false), see
 *    vtkParticipatingMedium::SetMultipleScattering();
 *  - `lights`, a list of {type: point, position, intensity},
 *    {type: spot, position, direction, cone_half_angle_deg, exponent, intensity} and
 *    {type: directional, direction, irradiance}. Point and spot may have `photometry`, a file of
 *    IES LM-63 (*.ies); `intensity` is that of its brightest direction. With it go `photometry_up`
 *    (0, 1, 0), see vtkAirlightLight::SetPhotometryUp(), and a point's `direction` (0, -1, 0),
 *    where the lamp's axis aims. Lamps may have an extent, see vtkAirlightLight::SetRadius(): point
 *    and spot `radius` or `size` [width, height] in world units (with `size` go `photometry_up` and
 *    a point's `direction`, too), directional `angular_diameter_deg`. It shows in pictures of
 *    several frames (`airlight render --antialiasing`). With `visible` true (false) the lamp itself
 *    is seen, too, see vtkAirlightLight::SetVisible();
 *  - `surfaces`, a list of {mesh, albedo};
 *  - optional: `scattered_surface_light`, true or false (false), see
 *    vtkAirlightPass::SetScatteredSurfaceLight(); and for people `name` and `description`.
 *
 * Throws UserError that names file, line and key for whatever is missing, unknown, of the wrong
 * type or out of range.
 */
Scene ReadScene(const std::string& fileName);

}

#endif
