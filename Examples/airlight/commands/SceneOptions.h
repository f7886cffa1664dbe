// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneOptions_h
#define SceneOptions_h

#include "commands/LightOptions.h"
#include "scene/ModelScene.h"
#include "scene/Scene.h"
#include "scene/SceneBuilder.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace airlight
{

/**
 * What --technique calls a vtkAirlightPass::ShadowTechniqueType.
 */
const std::string& GetTechniqueName(int technique);

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
  void AddModelOptions(CLI::App* command);
  void AddMediumOptions(CLI::App* command);
  void AddPhaseOptions(CLI::App* command, std::vector<CLI::Option*>& options);
  void AddRegionOptions(CLI::App* command, std::vector<CLI::Option*>& options);
  void ChangePhase(vtkParticipatingMedium* medium) const;
  void ChangeRegion(vtkParticipatingMedium* medium) const;
  void ChangeMedium(vtkParticipatingMedium* medium) const;

  std::string FileName;

  /// None or one: a plain std::string would not tell an empty value from none.
  using Text = std::vector<std::string>;

  ModelChoices Choices;
  std::vector<CLI::Option*> ModelOptions;
  Text Size;
  Text Camera;
  LightOptions Lights;
  Text Scattering;
  Text Absorption;
  Text Visibility;
  Text Anisotropy;
  Text Phase;
  Text PhaseTable;
  Text Ambient;
  Text Box;
  Text Sphere;
  Text Cylinder;
  Text Surface;
  Text HeightFog;
  std::string Technique = "Automatic";
  int Steps = 64;
  bool MultipleScattering = false;
  bool Glow = false;
  bool NoMedium = false;
};

}

#endif
