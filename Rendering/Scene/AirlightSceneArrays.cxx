// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightSceneArrays.h"

#include "Phase/AirlightPhaseShape.h"
#include "Region/AirlightSurfaceTree.h"

#include "vtkParticipatingMedium.h"

namespace airlight
{
//------------------------------------------------------------------------------
// The image of density and, for each light, the grid of depths from there to it.
void SceneArrays::AddDensity(const Add& add, vtkParticipatingMedium* medium,
  f64::AirlightMedium& converted, std::vector<SceneLight>& sceneLights)
{
  add(this->Grids.GetSamples(medium->GetDensityGrid()), converted.gridFirst);
  for (SceneLight& sceneLight : sceneLights)
  {
    if (sceneLight.Scatters())
    {
      const LightGrid& grid =
        this->Grids.GetLight(converted, sceneLight.Values, converted.gridOrigin);
      sceneLight.Values.gridSize = grid.Cells;
      sceneLight.GridError = grid.Error;
      add(grid.Means, sceneLight.Values.gridFirst);
    }
  }
  this->Grids.Forget();
}

//------------------------------------------------------------------------------
bool SceneArrays::Upload(vtkOpenGLRenderWindow* window,
  const std::vector<vtkParticipatingMedium*>& media, f64::AirlightMedia& converted,
  std::vector<SceneLight>& sceneLights)
{
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
      add(Texels(tree, &tree->GetTexels()), medium.region.first);
    }
    if (medium.phase.rows > 0)
    {
      const std::shared_ptr<const PhaseShape> shape = media[i]->GetPhaseShape();
      add(Texels(shape, &shape->Rows), medium.phase.first);
    }
  }
  if (converted.count == 1 && converted.item[0].density == AIRLIGHT_DENSITY_GRID)
  {
    this->AddDensity(add, media[0], converted.item[0], sceneLights);
  }
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
