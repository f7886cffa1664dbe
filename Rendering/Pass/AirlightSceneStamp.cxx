// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightSceneStamp.h"

#include "Scene/AirlightSceneProps.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <cstring>

namespace airlight
{
//------------------------------------------------------------------------------
SceneStamp::SceneStamp(const vtkRenderState* s, vtkObject* pass)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->Add(pass);
  this->Add(renderer);
  this->Add(renderer->GetActiveCamera());
  this->Add(renderer->GetBackgroundTexture());
  this->Add(renderer->GetEnvironmentTexture());
  this->AddLights(renderer);
  this->AddProps(s);
}

//------------------------------------------------------------------------------
void SceneStamp::Add(vtkObject* object)
{
  this->Times.push_back(reinterpret_cast<std::uintptr_t>(object));
  this->Times.push_back(object ? object->GetMTime() : 0);
}

//------------------------------------------------------------------------------
void SceneStamp::AddLights(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    this->Add(light);
    this->Times.push_back(light->GetInformation()->GetMTime());
  }
}

//------------------------------------------------------------------------------
void SceneStamp::AddProps(const vtkRenderState* s)
{
  const SceneProps props(s->GetRenderer(), s->GetPropArray(), s->GetPropArrayCount());
  for (const SceneProp& prop : props.GetProps())
  {
    if (!prop.Prop->GetBounds()) // an annotation, which is drawn over each picture
    {
      continue;
    }
    for (const ScenePart& part : prop.Parts)
    {
      this->AddActor(part.Actor);
      this->AddMatrix(part.ToWorld);
    }
    for (vtkVolume* volume : prop.Volumes)
    {
      this->AddPipeline(volume->GetMapper());
      this->Times.push_back(volume->GetRedrawMTime());
    }
    this->Add(prop.Prop);
    this->Times.push_back(prop.Prop->GetRedrawMTime());
    this->Times.push_back(prop.InView ? 1 : 0);
    if (vtkInformation* keys = prop.Prop->GetPropertyKeys())
    {
      this->Times.push_back(keys->GetMTime());
    }
  }
}

//------------------------------------------------------------------------------
// Parts get a matrix in each walk.
void SceneStamp::AddMatrix(vtkMatrix4x4* matrix)
{
  for (int i = 0; i < 16; ++i)
  {
    const double element = matrix->GetElement(i / 4, i % 4);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &element, sizeof(bits));
    this->Times.push_back(bits);
  }
}

//------------------------------------------------------------------------------
void SceneStamp::AddActor(vtkActor* actor)
{
  this->AddPipeline(actor->GetMapper());
  this->Add(actor);
  this->Times.push_back(actor->GetRedrawMTime());
  this->Add(actor->GetShaderProperty());
  vtkPlaneCollection* planes =
    actor->GetMapper() ? actor->GetMapper()->GetClippingPlanes() : nullptr;
  if (planes)
  {
    vtkCollectionSimpleIterator it = nullptr;
    planes->InitTraversal(it);
    while (vtkPlane* plane = planes->GetNextPlane(it))
    {
      this->Add(plane);
    }
  }
}

//------------------------------------------------------------------------------
void SceneStamp::AddPipeline(vtkAlgorithm* mapper)
{
  if (!mapper)
  {
    return;
  }
  mapper->Update();
  for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(port); ++i)
    {
      this->Add(mapper->GetInputDataObject(port, i));
    }
  }
}
}
