// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightSceneStamp.h"

#include "Scene/AirlightCasterKeys.h"
#include "Scene/AirlightSceneProps.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPhaseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <cstring>
#include <string>

namespace airlight
{
//------------------------------------------------------------------------------
SceneStamp::SceneStamp(const vtkRenderState* s, vtkObject* pass, vtkObject* delegate)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->Add(pass);
  this->Add(delegate);
  this->Add(renderer, renderer->vtkViewport::GetMTime()); // without its camera's
  this->AddTexture(renderer->GetBackgroundTexture());
  this->AddTexture(renderer->GetLeftBackgroundTexture());
  this->AddTexture(renderer->GetEnvironmentTexture());
  // Cameras and lights by their values: passes move them, and move them back.
  vtkCamera* camera = renderer->GetActiveCamera();
  this->AddMatrix(camera->GetModelViewTransformMatrix());
  this->AddMatrix(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  this->AddLights(renderer);
  this->AddProps(s);
}

//------------------------------------------------------------------------------
void SceneStamp::Add(vtkObject* object) { this->Add(object, object ? object->GetMTime() : 0); }

void SceneStamp::Add(vtkObject* object, std::uint64_t time)
{
  this->Times.push_back(reinterpret_cast<std::uintptr_t>(object));
  this->Times.push_back(time);
}

//------------------------------------------------------------------------------
void SceneStamp::AddNumbers(const double* numbers, int count)
{
  for (int i = 0; i < count; ++i)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, numbers + i, sizeof(bits));
    this->Times.push_back(bits);
  }
}

//------------------------------------------------------------------------------
void SceneStamp::AddMatrix(vtkMatrix4x4* matrix)
{
  if (matrix)
  {
    this->AddNumbers(matrix->GetData(), 16);
  }
}

//------------------------------------------------------------------------------
void SceneStamp::AddTexture(vtkTexture* texture)
{
  this->Add(texture);
  if (texture)
  {
    this->Add(texture->GetLookupTable());
    this->Add(texture->GetTransform());
    this->AddInputs(texture);
  }
}

//------------------------------------------------------------------------------
void SceneStamp::AddLights(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    this->AddLight(light);
  }
}

//------------------------------------------------------------------------------
void SceneStamp::AddLight(vtkLight* light)
{
  this->Add(light, 0);
  this->Add(light->GetInformation());
  this->AddMatrix(light->GetTransformMatrix());
  for (const double* numbers :
    { light->GetPosition(), light->GetFocalPoint(), light->GetAmbientColor(),
      light->GetDiffuseColor(), light->GetSpecularColor(), light->GetAttenuationValues() })
  {
    this->AddNumbers(numbers, 3);
  }
  const double numbers[] = { light->GetIntensity(), light->GetConeAngle(), light->GetExponent(),
    1.0 * light->GetSwitch(), 1.0 * light->GetPositional(), 1.0 * light->GetLightType(),
    1.0 * light->GetShadowAttenuation() };
  this->AddNumbers(numbers, 7);
}

//------------------------------------------------------------------------------
// But for annotations, which are drawn over each picture.
void SceneStamp::AddProps(const vtkRenderState* s)
{
  const SceneProps props(s->GetRenderer(), s->GetPropArray(), s->GetPropArrayCount());
  for (const SceneProp& prop : props.GetProps())
  {
    if (prop.Prop->IsA("vtkActor2D"))
    {
      continue;
    }
    for (vtkActor* actor : prop.Actors)
    {
      this->AddActor(actor);
    }
    for (const ScenePart& part : prop.Parts)
    {
      if (!prop.InView || part.Actor != prop.Prop) // else it is among the actors
      {
        this->AddActor(part.Actor);
      }
      this->AddMatrix(part.ToWorld); // of this walk
    }
    for (vtkVolume* volume : prop.Volumes)
    {
      this->AddMapper(volume->GetMapper());
      this->Times.push_back(volume->GetRedrawMTime());
    }
    this->Add(prop.Prop);
    this->Times.push_back(prop.Prop->GetRedrawMTime());
    this->Times.push_back(prop.InView ? 1 : 0);
    this->AddKeys(prop.Prop);
  }
}

//------------------------------------------------------------------------------
// Passes write into the same information while they draw.
void SceneStamp::AddKeys(vtkProp* prop)
{
  glm::dvec3 opacity(-1.0); // none
  std::string error;
  ReadShadowOpacity(prop, opacity, error);
  this->Times.push_back((CastsShadow(prop) ? 1 : 0) + (IsMedium(prop, prop) ? 2 : 0));
  this->AddNumbers(&opacity.x, 3);
  this->Add(GetVolumePhaseFunction(prop));
}

//------------------------------------------------------------------------------
void SceneStamp::AddActor(vtkActor* actor)
{
  this->AddMapper(actor->GetMapper());
  this->Add(actor);
  this->Times.push_back(actor->GetRedrawMTime());
  this->Add(actor->GetShaderProperty());
  this->AddTexture(actor->GetTexture());
  for (const auto& texture : actor->GetProperty()->GetAllTextures())
  {
    this->AddTexture(texture.second);
  }
}

//------------------------------------------------------------------------------
// Neither mappers nor collections count the planes' own times.
void SceneStamp::AddMapper(vtkAbstractMapper* mapper)
{
  if (!mapper)
  {
    return;
  }
  this->Add(mapper);
  this->AddInputs(mapper);
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  vtkCollectionSimpleIterator it = nullptr;
  if (planes)
  {
    planes->InitTraversal(it);
  }
  while (vtkPlane* plane = planes ? planes->GetNextPlane(it) : nullptr)
  {
    this->Add(plane);
  }
}

//------------------------------------------------------------------------------
void SceneStamp::AddInputs(vtkAlgorithm* algorithm)
{
  if (algorithm->GetNumberOfInputPorts() > 0 && algorithm->GetNumberOfInputConnections(0) > 0)
  {
    algorithm->Update();
  }
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      this->AddData(algorithm->GetInputDataObject(port, i));
    }
  }
}

//------------------------------------------------------------------------------
// Composite data do not count the times of their leaves.
void SceneStamp::AddData(vtkDataObject* data)
{
  this->Add(data);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      this->Add(leaves->GetCurrentDataObject());
    }
  }
}
}
