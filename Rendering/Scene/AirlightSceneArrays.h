// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The surfaces, images and tables of media and lights on the graphics card.
 */

#ifndef AirlightSceneArrays_h
#define AirlightSceneArrays_h

#include "Scene/AirlightLightGrids.h"
#include "Scene/AirlightSceneData.h"
#include "Scene/AirlightSceneLights.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkParticipatingMedium;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
// What a frame's media were converted from.
struct SceneSources
{
  std::vector<vtkParticipatingMedium*> Media;
  std::vector<std::shared_ptr<const DensityGrid>> Volumes; // that cast shadows
};

class SceneArrays
{
public:
  // Brings them up to date, and puts their positions there into `converted` and `sceneLights`.
  // False with a reason in GetError() where the card has no room.
  bool Upload(vtkOpenGLRenderWindow* window, const SceneSources& sources,
    f64::AirlightMedia& converted, std::vector<SceneLight>& sceneLights);

  const std::string& GetError() const { return this->Data.GetError(); }

  // Null without arrays.
  vtkTextureObject* GetTexture() { return this->Data.GetTexture(); }
  // The same buffer as whole numbers; null where no array has such.
  vtkTextureObject* GetWholeNumbers() { return this->Data.GetWholeNumbers(); }

  void Release(vtkWindow* window) { this->Data.Release(window); }

private:
  // Notes an array and where its position is to be put.
  using Add = std::function<void(const SceneArray&, int&)>;
  // An image, and the closed surface that it fills, or null.
  struct DensitySource
  {
    std::shared_ptr<const DensityGrid> Image;
    std::shared_ptr<const SurfaceTree> Surface;
  };
  void AddDensity(const Add& add, int index, const DensitySource& source,
    f64::AirlightMedia& converted, std::vector<SceneLight>& sceneLights, double seconds);
  static void AddColours(
    const Add& add, const std::shared_ptr<const ImageColours>& colours, int& first);
  void ForgetGrids();

  SceneData Data;
  std::map<std::shared_ptr<const DensityGrid>, LightGrids> Grids;
};
}

#endif
