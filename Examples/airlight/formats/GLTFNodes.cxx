// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/GLTFNodes.h"

#include <vtkGLTFDocumentLoader.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <vector>

namespace airlight
{

namespace
{
template <typename Items, typename Index>
bool Holds(const Items& items, Index index)
{
  return index >= 0 && static_cast<std::size_t>(index) < items.size();
}

// A glTF camera is at the origin of its node and looks along -z.
CameraSettings PlaceByNode(vtkMatrix4x4* node, double viewAngle)
{
  CameraSettings camera;
  camera.ViewAngle = viewAngle;
  Vector3 back;
  for (int i = 0; i < 3; ++i)
  {
    camera.Position[i] = node->GetElement(i, 3);
    camera.ViewUp[i] = node->GetElement(i, 1);
    back[i] = node->GetElement(i, 2);
  }
  vtkMath::Normalize(camera.ViewUp.data());
  vtkMath::Normalize(back.data());
  vtkMath::Subtract(camera.Position.data(), back.data(), camera.FocalPoint.data());
  camera.Vertical = Vector3{ 0.0, 1.0, 0.0 };
  return camera;
}

}

vtkStandardNewMacro(GLTFNodes);

//------------------------------------------------------------------------------
void GLTFNodes::ImportActors(vtkRenderer* renderer)
{
  for (auto& material : this->Loader->GetInternalModel()->Materials)
  {
    material.PbrMetallicRoughness.MetallicRoughnessTexture.Index = -1;
    material.NormalTexture.Index = -1;
    material.OcclusionTexture.Index = -1;
    material.EmissiveTexture.Index = -1;
  }
  this->Superclass::ImportActors(renderer);
}

//------------------------------------------------------------------------------
bool IsSame(vtkMatrix4x4* a, vtkMatrix4x4* b)
{
  return a && b && std::equal(a->GetData(), a->GetData() + 16, b->GetData());
}

//------------------------------------------------------------------------------
std::optional<CameraSettings> GLTFNodes::FindCamera() const
{
  const auto model = this->Loader ? this->Loader->GetInternalModel() : nullptr;
  if (!model || !Holds(model->Scenes, model->DefaultScene))
  {
    return std::nullopt;
  }
  const auto& roots = model->Scenes[model->DefaultScene].Nodes;
  std::vector<int> nodes(roots.rbegin(), roots.rend()); // the next one is the last
  for (std::size_t i = 0; !nodes.empty() && i < model->Nodes.size(); ++i)
  {
    const int number = nodes.back();
    nodes.pop_back();
    if (!Holds(model->Nodes, number))
    {
      continue;
    }
    const auto& node = model->Nodes[number];
    if (Holds(model->Cameras, node.Camera) && model->Cameras[node.Camera].IsPerspective &&
      node.GlobalTransform)
    {
      return PlaceByNode(
        node.GlobalTransform, vtkMath::DegreesFromRadians(model->Cameras[node.Camera].Yfov));
    }
    nodes.insert(nodes.end(), node.Children.rbegin(), node.Children.rend());
  }
  return std::nullopt;
}

//------------------------------------------------------------------------------
// In the order in which VTK makes lights: of the nodes that are left, the last one first.
double GLTFNodes::GetInnerConeAngle(vtkLight* light, int before) const
{
  const auto model = this->Loader ? this->Loader->GetInternalModel() : nullptr;
  if (!model || !Holds(model->Scenes, model->DefaultScene))
  {
    return 0.0;
  }
  using Lamp = vtkGLTFDocumentLoader::Extensions::KHRLightsPunctual::Light;
  const auto& lamps = model->ExtensionMetaData.KHRLightsPunctualMetaData.Lights;
  const auto& roots = model->Scenes[model->DefaultScene].Nodes;
  std::vector<int> nodes(roots.begin(), roots.end());
  for (std::size_t i = 0; !nodes.empty() && i < model->Nodes.size(); ++i)
  {
    const int number = nodes.back();
    nodes.pop_back();
    if (!Holds(model->Nodes, number))
    {
      continue;
    }
    const auto& node = model->Nodes[number];
    const int lamp = node.ExtensionMetaData.KHRLightsPunctualMetaData.Light;
    if (Holds(lamps, lamp) && IsSame(node.GlobalTransform, light->GetTransformMatrix()) &&
      before-- == 0)
    {
      return lamps[lamp].Type == Lamp::LightType::SPOT
        ? vtkMath::DegreesFromRadians(lamps[lamp].SpotInnerConeAngle)
        : 0.0;
    }
    nodes.insert(nodes.end(), node.Children.begin(), node.Children.end());
  }
  return 0.0;
}

}
