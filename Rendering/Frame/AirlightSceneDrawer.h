// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Who draws the parts of a scene when a frame asks for them, each into the targets that are bound.
 */

#ifndef AirlightSceneDrawer_h
#define AirlightSceneDrawer_h

namespace airlight
{
class SceneDrawer
{
public:
  virtual ~SceneDrawer() = default;

  // Distances and depths of the opaque geometry.
  virtual void DrawDistances() = 0;

  // Its colours; and its distances, where the plan has a single geometry pass.
  virtual void DrawColours() = 0;

  // The casters are known: before anything is drawn that depends on them.
  virtual void UpdateCasters() = 0;

  // Translucent fragments for their records.
  virtual void CollectFragments() = 0;

  // Translucent surfaces, volumes and point Gaussians, over the medium.
  virtual void DrawTranslucent() = 0;
};
}

#endif
