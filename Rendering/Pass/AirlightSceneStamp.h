// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The modification times of everything that a renderer's picture depends on.
 */

#ifndef AirlightSceneStamp_h
#define AirlightSceneStamp_h

#include <cstdint>
#include <vector>

class vtkAbstractMapper;
class vtkActor;
class vtkAlgorithm;
class vtkDataObject;
class vtkLight;
class vtkMatrix4x4;
class vtkObject;
class vtkProp;
class vtkRenderState;
class vtkRenderer;
class vtkTexture;

namespace airlight
{
class SceneStamp
{
public:
  SceneStamp() = default;
  // Of a state's renderer and props, of a render pass and of the one below it. Brings the pipelines
  // of actors and textures up to date, so that a change of any filter counts.
  SceneStamp(const vtkRenderState* s, vtkObject* pass, vtkObject* delegate);

  bool operator==(const SceneStamp& other) const { return this->Times == other.Times; }
  bool operator!=(const SceneStamp& other) const { return !(*this == other); }

private:
  void Add(vtkObject* object);
  void Add(vtkObject* object, std::uint64_t time);
  void AddNumbers(const double* numbers, int count);
  void AddMatrix(vtkMatrix4x4* matrix);
  void AddTexture(vtkTexture* texture);
  void AddLights(vtkRenderer* renderer);
  void AddLight(vtkLight* light);
  void AddProps(const vtkRenderState* s);
  void AddKeys(vtkProp* prop);
  void AddActor(vtkActor* actor);
  void AddMapper(vtkAbstractMapper* mapper);
  void AddInputs(vtkAlgorithm* algorithm);
  void AddData(vtkDataObject* data);

  std::vector<std::uint64_t> Times; // and addresses and values
};
}

#endif
