// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a camera's clipping range cuts rays off.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightClippedRegions_h
#define AirlightClippedRegions_h

#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace airlight
{
class CameraRays;
struct Caster;

// Which parts of casters rays of the picture may meet before the near clipping plane or behind the
// far one, where nothing of them is drawn.
class VTKAIRLIGHT_EXPORT ClippedRegions
{
public:
  // `anyPicture`: of any width and height, for other processes, whose windows are not known.
  explicit ClippedRegions(const CameraRays& rays, bool anyPicture = false);

  // Whether there may be such parts of it: where its box and one of the two regions are not apart
  // for certain.
  bool MayCutOff(const Caster& caster) const;

private:
  // A convex region, from the eye.
  struct Region
  {
    std::vector<glm::dvec4> Corners; // or directions in which it has no end, w = 0
    glm::dvec4 End{ 0.0 };           // the clipping plane, positive outside
  };
  using Box = std::array<glm::dvec4, 8>; // corners from the eye, as GetCorners() numbers them

  bool IsOutside(const Box& box, const Region& region) const;

  glm::dvec3 Eye{ 0.0 };
  bool AnyPicture = false;
  std::array<glm::dvec4, 4> Sides; // of the view, positive inside
  Region InFront;
  Region Beyond;
};
}

#endif
