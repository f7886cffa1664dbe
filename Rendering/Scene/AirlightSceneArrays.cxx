// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightSceneArrays.h"

#include "Phase/AirlightPhaseShape.h"
#include "Region/AirlightSurfaceTree.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace airlight
{
namespace
{
// For a light in an image: while something moves, of the time that the window wants a frame to take
// a share; at rest without limit.
double GetTimeForGrid(vtkOpenGLRenderWindow* window, const f64::AirlightMedia& media,
  const std::vector<SceneLight>& lights)
{
  const double rate = window->GetDesiredUpdateRate();
  const auto powerful = std::count_if(
    lights.begin(), lights.end(), [](const SceneLight& light) { return light.HasPower(); });
  return rate < 1.0
    ? std::numeric_limits<double>::infinity()
    : 0.3 / (rate * std::max<double>((media.count + media.volumes) * powerful, 1.0));
}
}

//------------------------------------------------------------------------------
// The image of density and, for each light, the grid of depths from there to it.
void SceneArrays::AddDensity(const Add& add, int index,
  const std::shared_ptr<const DensityGrid>& image, f64::AirlightMedia& converted,
  std::vector<SceneLight>& sceneLights, double seconds)
{
  LightGrids& grids = this->Grids[image];
  const bool everywhere = converted.count + converted.volumes > 1;
  f64::AirlightMedium& item = converted.item[index];
  add(grids.GetSamples(*image), item.gridFirst);
  for (SceneLight& sceneLight : sceneLights)
  {
    if (sceneLight.Scatters())
    {
      const LightGrid& grid = sceneLight.HasPower()
        ? grids.GetLight(item, sceneLight.Values, item.gridOrigin, everywhere, seconds)
        : LightGrid::GetDark();
      sceneLight.Values.gridSize[index] = grid.Cells;
      sceneLight.GridError += grid.Error;
      add(grid.Means, sceneLight.Values.gridFirst[index]);
    }
  }
}

//------------------------------------------------------------------------------
void SceneArrays::AddColours(
  const Add& add, const std::shared_ptr<const ImageColours>& colours, int& first)
{
  if (colours)
  {
    add(FloatTexels(colours, &colours->GetTexels()), first);
  }
}

//------------------------------------------------------------------------------
void SceneArrays::ForgetGrids()
{
  for (auto it = this->Grids.begin(); it != this->Grids.end();)
  {
    it = it->second.Forget() ? this->Grids.erase(it) : std::next(it);
  }
}

//------------------------------------------------------------------------------
bool SceneArrays::Upload(vtkOpenGLRenderWindow* window, const SceneSources& sources,
  f64::AirlightMedia& converted, std::vector<SceneLight>& sceneLights)
{
  const std::vector<vtkParticipatingMedium*>& media = sources.Media;
  std::vector<Texels> arrays;
  std::vector<int*> first;
  const Add add = [&](const Texels& array, int& position) {
    arrays.push_back(array);
    first.push_back(&position);
  };
  for (int i = 0; i < converted.count; ++i)
  {
    f64::AirlightMedium& medium = converted.item[i];
    if (medium.region.kind == AIRLIGHT_REGION_SURFACE)
    {
      const std::shared_ptr<const SurfaceTree> tree = media[i]->GetSurfaceTree();
      add(DoubleTexels(tree, &tree->GetTexels()), medium.region.first);
    }
    if (medium.phase.rows > 0)
    {
      const std::shared_ptr<const PhaseShape> shape = media[i]->GetPhaseShape();
      add(DoubleTexels(shape, &shape->Rows), medium.phase.first);
    }
  }
  const double seconds = GetTimeForGrid(window, converted, sceneLights);
  for (int i = 0; i < converted.count; ++i)
  {
    if (converted.item[i].density == AIRLIGHT_DENSITY_GRID)
    {
      this->AddDensity(add, i, media[i]->GetDensityGrid(), converted, sceneLights, seconds);
      AddColours(add, media[i]->GetAlbedoColours(), converted.item[i].albedoFirst);
      AddColours(add, media[i]->GetEmissionColours(), converted.item[i].glowFirst);
    }
  }
  for (int i = 0; i < converted.volumes; ++i)
  {
    this->AddDensity(add, converted.count + i, sources.Volumes[i], converted, sceneLights, seconds);
  }
  this->ForgetGrids();
  for (SceneLight& sceneLight : sceneLights)
  {
    if (sceneLight.Table)
    {
      add(sceneLight.Table, sceneLight.Values.photometry.first);
    }
  }
  const bool ok = this->Data.Update(window, arrays);
  for (size_t i = 0; i < first.size() && ok; ++i)
  {
    *first[i] = this->Data.GetFirst(i);
  }
  return ok;
}
}
