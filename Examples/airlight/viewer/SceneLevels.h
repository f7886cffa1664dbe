// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneLevels_h
#define SceneLevels_h

#include "scene/SceneBuilder.h"

#include <functional>
#include <string>
#include <vector>

namespace airlight
{

/**
 * A number of a scene that a slider changes, in the slider's own unit.
 */
struct Level
{
  double Minimum = 0.0;
  double Maximum = 1.0;
  std::function<double()> Get; ///< may lie outside the range
  std::function<void(double)> Set;
  std::function<std::string(int)> GetText; ///< name and value, with so many digits
};

/**
 * Visibility, anisotropy and exposure of a rendered scene.
 *
 * The visibility's level is its logarithm, from 1/30 to 30 times the first visibility. In clear air
 * the range begins at the distance that the camera looks at, and its end is clear air again.
 *
 * The anisotropy is the phase function's parameter g or k, -0.99 to 0.99. It makes an isotropic
 * medium one of Henyey and Greenstein; media whose phase function has no such parameter do not have
 * this level.
 *
 * The exposure's level is in stops, from -6 to 6, around the last automatic exposure, which it
 * switches off. Without a medium there is only the exposure.
 */
class SceneLevels
{
public:
  /**
   * The pass may be null: there is then no level.
   */
  SceneLevels(const RenderedScene& rendered, vtkAirlightPass* pass);

  SceneLevels(const SceneLevels&) = delete;
  void operator=(const SceneLevels&) = delete;

  const std::vector<Level>& GetLevels() const { return this->Levels; }

  /**
   * Let the exposure follow the picture again, as at first. False without a pass.
   */
  bool ResetExposure();

  /**
   * All levels, a line each.
   */
  std::string GetText() const;

private:
  void AddVisibility(double distance);
  void AddAnisotropy();
  void AddExposure();
  void SetExposure(double stops);

  vtkSmartPointer<vtkAirlightPass> Pass;
  double Brightness; // of the scene: the exposure's factor while it follows the picture
  vtkParticipatingMedium* Medium = nullptr;
  std::vector<Level> Levels;
  double BaseExposure = 1.0; // at 0 stops
};

}

#endif
