// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightSceneArrays.h"

#include "OpenGL/AirlightShaderLibrary.h"
#include "Phase/AirlightPhaseShape.h"
#include "Region/AirlightSurfaceTree.h"
#include "Scene/AirlightPackedSamples.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkParticipatingMedium.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdint>
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

// From positions relative to `origin` to shares of the image's sides.
glm::dmat4 GetMatrixToPlaces(const DensityGrid& grid, const glm::dvec3& origin)
{
  glm::dmat4 matrix(grid.GetAxes());
  matrix[3] = glm::dvec4(grid.ToSamples(origin), 1.0);
  return glm::scale(glm::dmat4(1.0), 1.0 / grid.GetLast()) * matrix;
}

// The samples of an image, and before them its blocks (airlightIsEmptyBlock()).
template <typename Texel>
SceneArray MakeArray(const std::shared_ptr<const DensityGrid>& image)
{
  const std::vector<std::uint8_t>& blocks = image->GetBlocks().GetFilled();
  const auto write = [&grid = *image](void* to) {
    const std::vector<std::uint8_t>& filled = grid.GetBlocks().GetFilled();
    Texel* first = std::transform(filled.rbegin(), filled.rend(), static_cast<Texel*>(to),
      [](std::uint8_t block) { return Texel(block); });
    PackSamples(grid.GetSamples(), grid.GetSize(), first);
  };
  const size_t bytes = sizeof(Texel) * (blocks.size() + CountTexels(image->GetSize()));
  return { image, (bytes + sizeof(glm::vec4) - 1) / sizeof(glm::vec4), write, blocks.size(),
    8 * static_cast<int>(sizeof(typename Texel::value_type)) };
}

SceneArray MakeArray(const std::shared_ptr<const DensityGrid>& image, int bits)
{
  return bits == 8 ? MakeArray<glm::u8vec4>(image)
    : bits == 16   ? MakeArray<glm::u16vec4>(image)
                   : MakeArray<glm::vec4>(image);
}

// Numbers that a shared object holds.
template <typename Vector>
SceneArray MakeArray(const std::shared_ptr<const void>& owner, const std::vector<Vector>& texels)
{
  const auto write = [all = &texels](void* to) {
    std::copy(all->begin(), all->end(), static_cast<glm::vec4*>(to));
  };
  return { owner, texels.size(), write };
}
}

//------------------------------------------------------------------------------
// The image of density and, for each light, the grid of depths from there to it.
void SceneArrays::AddDensity(const Add& add, int index, const DensitySource& source,
  f64::AirlightMedia& converted, std::vector<SceneLight>& sceneLights, double seconds)
{
  LightGrids& grids = this->Grids[source.Image];
  const bool everywhere = converted.count + converted.volumes > 1;
  f64::AirlightMedium& item = converted.item[index];
  add(MakeArray(source.Image, GetSampleBits(converted)), item.gridFirst);
  const glm::dmat4 toPlaces = GetMatrixToPlaces(*source.Image, item.gridOrigin);
  for (SceneLight& sceneLight : sceneLights)
  {
    if (sceneLight.Scatters())
    {
      const LightGrid& grid = sceneLight.HasPower()
        ? grids.GetLight(
            item, source.Surface, sceneLight.Values, item.gridOrigin, everywhere, seconds)
        : LightGrid::GetDark();
      sceneLight.Values.gridSize[index] = grid.Cells;
      sceneLight.Values.gridCells[index] = grid.ToCells * toPlaces;
      sceneLight.GridError += grid.Error;
      add(MakeArray(grid.Means, *grid.Means), sceneLight.Values.gridFirst[index]);
    }
  }
}

//------------------------------------------------------------------------------
void SceneArrays::AddColours(
  const Add& add, const std::shared_ptr<const ImageColours>& colours, int& first)
{
  if (colours)
  {
    add(MakeArray(colours, colours->GetTexels()), first);
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
  std::vector<SceneArray> arrays;
  std::vector<int*> first;
  const Add add = [&](const SceneArray& array, int& position) {
    arrays.push_back(array);
    first.push_back(&position);
  };
  for (int i = 0; i < converted.count; ++i)
  {
    f64::AirlightMedium& medium = converted.item[i];
    if (medium.region.kind == AIRLIGHT_REGION_SURFACE)
    {
      const std::shared_ptr<const SurfaceTree> tree = media[i]->GetSurfaceTree();
      add(MakeArray(tree, tree->GetTexels()), medium.region.first);
    }
    if (medium.phase.rows > 0)
    {
      const std::shared_ptr<const PhaseShape> shape = media[i]->GetPhaseShape();
      add(MakeArray(shape, shape->Rows), medium.phase.first);
    }
  }
  const double seconds = GetTimeForGrid(window, converted, sceneLights);
  for (int i = 0; i < converted.count; ++i)
  {
    if (converted.item[i].density == AIRLIGHT_DENSITY_GRID)
    {
      const bool isSurface = converted.item[i].region.kind == AIRLIGHT_REGION_SURFACE;
      const DensitySource source = { media[i]->GetDensityGrid(),
        isSurface ? media[i]->GetSurfaceTree() : nullptr };
      this->AddDensity(add, i, source, converted, sceneLights, seconds);
      AddColours(add, media[i]->GetAlbedoColours(), converted.item[i].albedoFirst);
      AddColours(add, media[i]->GetEmissionColours(), converted.item[i].glowFirst);
    }
  }
  for (int i = 0; i < converted.volumes; ++i)
  {
    this->AddDensity(
      add, converted.count + i, { sources.Volumes[i], nullptr }, converted, sceneLights, seconds);
  }
  this->ForgetGrids();
  for (SceneLight& sceneLight : sceneLights)
  {
    if (sceneLight.Table)
    {
      add(MakeArray(sceneLight.Table, *sceneLight.Table), sceneLight.Values.photometry.first);
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
