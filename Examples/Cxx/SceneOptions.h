// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneOptions_h
#define SceneOptions_h

#include "Scene.h"
#include "SceneBuilder.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace airlight
{

/**
 * What `airlight render` and `airlight view` have in common: a scene or model, and options that
 * change its camera, medium and lamps.
 */
class SceneOptions
{
public:
  /**
   * Add the argument SCENE and the options to a command. Keep this object until it has run.
   */
  void AddTo(CLI::App* command);

  /**
   * Read the scene and apply the options. Throws UserError.
   */
  Scene Load() const;

  /**
   * Settings for BuildScene(), off screen.
   */
  RenderSettings GetSettings() const;

private:
  void ChangeMedium(vtkParticipatingMedium* medium) const;

  std::string FileName;
  std::string Size;
  std::string Camera;
  std::vector<std::string> Points;
  std::string Scattering;
  std::string Absorption;
  std::string Visibility;
  std::string Anisotropy;
  std::string Ambient;
  std::string Technique = "Automatic";
  bool NoMedium = false;
};

}

#endif
