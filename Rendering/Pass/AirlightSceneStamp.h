// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The modification times of everything that a renderer's picture depends on.
 */

#ifndef AirlightSceneStamp_h
#define AirlightSceneStamp_h

#include <cstdint>
#include <vector>

class vtkActor;
class vtkAlgorithm;
class vtkMatrix4x4;
class vtkObject;
class vtkRenderState;
class vtkRenderer;

namespace airlight
{
class SceneStamp
{
public:
  SceneStamp() = default;
  // Of a state's renderer and props, and of a render pass. Brings the actors' pipelines up to date,
  // so that a change of any filter counts.
  SceneStamp(const vtkRenderState* s, vtkObject* pass);

  bool operator==(const SceneStamp& other) const { return this->Times == other.Times; }
  bool operator!=(const SceneStamp& other) const { return !(*this == other); }

private:
  void Add(vtkObject* object);
  void AddProps(const vtkRenderState* s);
  void AddMatrix(vtkMatrix4x4* matrix);
  void AddActor(vtkActor* actor);
  void AddPipeline(vtkAlgorithm* mapper);
  void AddLights(vtkRenderer* renderer);

  std::vector<std::uint64_t> Times; // objects' addresses, times and places
};
}

#endif
