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
  void AddLightOptions(CLI::App* command);
  void AddMediumOptions(CLI::App* command);
  void ChangeLights(std::vector<LightSource>& lights) const;
  void ChangeMedium(vtkParticipatingMedium* medium) const;

  std::string FileName;

  /// None or one: a plain std::string would not tell an empty value from none.
  using Text = std::vector<std::string>;

  Text Size;
  Text Camera;
  std::vector<std::string> Points;
  std::vector<std::string> Spots;
  std::vector<std::string> Suns;
  Text Scattering;
  Text Absorption;
  Text Visibility;
  Text Anisotropy;
  Text Ambient;
  Text Box;
  Text Sphere;
  Text HeightFog;
  std::string Technique = "Automatic";
  bool NoMedium = false;
};

}

#endif
