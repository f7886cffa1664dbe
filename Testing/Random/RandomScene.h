// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene that a seed makes: camera, lights, media, regions and surfaces.
 *
 * No two numbers are drawn in an order that C++ leaves open, so that a seed makes the same scene by
 * any compiler.
 *
 * The kept seeds mean the scenes of this generator: whoever changes it makes tests of their own of
 * what they show first.
 */

#ifndef RandomScene_h
#define RandomScene_h

#include "AirlightTestScene.h"
#include "AirlightTestTools.h"
#include "RandomGroup.h"

#include <string>
#include <vector>

namespace airlight_test
{
class RandomScene
{
public:
  // Empties the scene and fills it again. The reference has to be given the same media and the
  // pass's settings.
  RandomScene(std::uint64_t seed, airlight_test::Scene& scene);

  const std::vector<vtkSmartPointer<vtkParticipatingMedium>>& GetMedia() const
  {
    return this->Media;
  }
  bool HasImage() const { return this->Group.Density == vtkParticipatingMedium::IMAGE; }
  std::string Describe() const;

private:
  void PlaceCamera();
  void PlaceLights();
  glm::dvec3 ChooseLightPosition();
  void PlaceLight(vtkLight* light, int kind);
  void AddMedia();
  void ChoosePhase(vtkParticipatingMedium* medium);
  void ChooseRegion(vtkParticipatingMedium* medium, int region);
  void ChooseDensity(vtkParticipatingMedium* medium);
  void AddParts();
  void AddPart(int kind);

  RandomGroup Group;
  std::uint64_t Seed;
  Random Numbers;
  airlight_test::Scene& Scene;
  double Unit = 1.0; // length of what is 1 below
  glm::dvec3 Eye{ 0.0 };
  glm::dvec3 Focus{ 0.0 };
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> Media;
  std::string Text;
};
}

#endif
