// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene that a seed makes: camera, lights, media, regions and surfaces.
 *
 * What shaders are compiled for is the same in the 50 scenes of a group: the kinds of lights, of
 * regions, densities and phase functions, the projection. Each of these goes round all its kinds in
 * turn, in an order of its own that changes from round to round, so that a few groups have all kinds
 * and many have all pairs of them.
 *
 * The kept seeds mean the scenes of this generator: whoever changes it makes tests of their own of
 * what they show first.
 */

#ifndef RandomScene_h
#define RandomScene_h

#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include <string>
#include <vector>

namespace airlight_test
{
constexpr std::uint64_t GroupSize = 50;

enum RandomLight
{
  LIGHT_POINT,
  LIGHT_SPOT,
  LIGHT_SOFT_SPOT,  // with an exponent
  LIGHT_ATTENUATED, // otherwise than by the inverse square
  LIGHT_SUN,
  LIGHT_HEADLIGHT, // directional, as VTK's first light
  LIGHT_HEADLAMP,  // a positional headlight
  LIGHT_CAMERA,    // a point light fixed to the camera
  LIGHT_CAMERA_SUN,
  LIGHT_KINDS
};

struct RandomGroup
{
  explicit RandomGroup(std::uint64_t number);

  std::uint64_t Number;
  int Phase; // vtkParticipatingMedium::PhaseFunctionType
  double Anisotropy;
  int Density;
  bool Grey;
  bool Parallel;
  std::vector<int> Regions; // one for each medium
  std::vector<int> Lights;

  std::string Describe() const;
};

class RandomScene
{
public:
  // Empties the scene and fills it anew. The reference has to be given the same media and the
  // pass's settings.
  RandomScene(std::uint64_t seed, airlighttest::Scene& scene);

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
  airlighttest::Scene& Scene;
  double Unit = 1.0; // length of what is 1 below
  glm::dvec3 Eye{ 0.0 };
  glm::dvec3 Focus{ 0.0 };
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> Media;
  std::string Text;
};
}

#endif
