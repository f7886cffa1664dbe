// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Goniometric lights: how much a lamp shines in each direction, from a photometric file of IES
 * LM-63 (*.ies), for glsl/AirlightGoniometric.glsl.
 *
 * **Versions.** 1986 (without a header), 1991 (IESNA91), 1995 and 2002 (IESNA:LM-63-...), 2019
 * (IES:LM-63-2019). Labels and keywords are skipped. Numbers are separated by blanks, commas or
 * ends of lines and may stand on any lines. Lines end as on any system.
 *
 * **Units.** Angles are degrees. An intensity in candela is the file's value times candela
 * multiplier times ballast factor, and in versions 1986 and 1991 times the ballast-lamp photometric
 * factor, whose place is "future use" or a code in later ones. Candela weigh power by the eye's
 * sensitivity and are no W/sr: what is looked up is the intensity relative to the largest one, and
 * who has candela multiplies by GetMaximum().
 *
 * **Coordinates.** Seen from the lamp, with a unit vector `axis` where it aims, a unit vector `up`
 * perpendicular to it, and right = cross(axis, up):
 * - type C (rooms, streets): vertical 0 is `axis` (the nadir of a lamp that hangs), 180 opposite;
 *   horizontal 0 is towards `up`, 90 away from `right`: counter-clockwise for who looks along
 *   `axis`, from above at a lamp that hangs;
 * - type A (headlamps, signals): both 0 is `axis`; vertical is the elevation from the plane of
 *   `axis` and `right`, positive towards `up`; horizontal is the angle in that plane, positive
 *   towards `right`;
 * - type B (floodlights, headlamps): both 0 is `axis`; horizontal is the angle from the plane of
 *   `axis` and `up`, positive towards `right`; vertical is the angle in that plane, positive
 *   towards `up`.
 *
 * **Ranges and symmetry.** Vertical angles of type C go from 0 or 90 to 90 or 180. Its horizontal
 * angles are 0 alone (the same all around), 0 to 90 (all quadrants alike), 0 to 180 (mirrored at
 * the plane of 0 and 180), 90 to 270 (mirrored at the plane of 90 and 270), or 0 to more than 180
 * (no symmetry; the last angle is joined to the first one). Types A and B have at least two angles
 * of each kind between -90 and 90, not necessarily all that range; horizontal angles that begin at
 * 0 are mirrored. Between angles intensities are interpolated linearly in both; outside the file's
 * range of angles there is no light.
 *
 * **Ignored.** The lamp's tilt (TILT=INCLUDE is checked and skipped, the file of TILT=<file> is not
 * opened, so its name must only have a dot); number of lamps and lumens, units, width, length and
 * height of the opening (the light is a point), watts.
 *
 * **Limits.** 32 MiB, a million values, a million characters in a line; angles at least 0.0001
 * degrees apart. Values are 0 or more and not all 0. Anything else is an error that names file,
 * line and culprit.
 */

#ifndef AirlightPhotometry_h
#define AirlightPhotometry_h

#include "Photometry/AirlightPhotometricFile.h"
#include "vtkAirlightModule.h" // for the export macro

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace airlight
{
// Exported for the tests.
class VTKAIRLIGHT_EXPORT Photometry
{
public:
  // Null and an error "FILE:LINE: what is wrong; what was expected" for a bad file; without a line
  // where the file cannot be read at all.
  static std::shared_ptr<const Photometry> Read(const std::string& file, std::string& error);

  // The same for the text of a file. `name` stands in errors.
  static std::shared_ptr<const Photometry> Parse(
    const std::string& text, const std::string& name, std::string& error);

  // The largest intensity in candela.
  double GetMaximum() const { return this->Maximum; }

  // The texels that airlightPhotometry() looks up; glsl/AirlightGoniometric.glsl has the layout.
  std::vector<glm::dvec4> Pack() const;

private:
  // A horizontal angle in degrees after symmetry, and the file's horizontal angle that it shows.
  struct Column
  {
    double Angle;
    size_t Source;
  };

  explicit Photometry(PhotometricTable&& table);
  void ExpandSymmetry();
  void MirrorAtFirst();
  void MirrorAtLast();
  double GetValue(size_t column, size_t vertical) const;
  void PackPolar(std::vector<glm::dvec4>& texels) const;

  PhotometricTable Table; // candela divided by the largest
  double Maximum = 0.0;
  std::vector<Column> Columns;
};
}

#endif
