// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene whose picture is refined, for the tests of vtkAirlightPass::SetProgressiveRefinement().
 */

#ifndef RefinedScene_h
#define RefinedScene_h

#include "AirlightTestWindowScene.h"

#include "vtkCallbackCommand.h"
#include "vtkElevationFilter.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

namespace airlight_test
{
constexpr int Count = 6;

// With a ball whose size a filter of its pipeline sets, and a plane that cuts it.
class RefinedScene : public WindowScene
{
public:
  RefinedScene()
    : WindowScene(96, 72)
  {
    this->Source->SetThetaResolution(24);
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Filter->GetOutputPort());
    mapper->ScalarVisibilityOff();
    this->Plane->SetOrigin(0.0, 0.0, -5.0);
    this->Plane->SetNormal(0.0, 0.0, 1.0);
    mapper->AddClippingPlane(this->Plane);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(0.2, 1.3, 0.0);
    this->Renderer->AddActor(actor);
    this->Image->SetDimensions(2, 2, 1);
    this->Image->AllocateScalars(VTK_FLOAT, 1);
    this->Image->GetPointData()->GetScalars()->Fill(128.0);
    vtkNew<vtkTexture> texture;
    texture->SetInputData(this->Image);
    this->Table->SetRange(0.0, 255.0);
    this->Table->Build();
    texture->SetLookupTable(this->Table);
    this->Floor->SetTexture(texture);
    this->Lamp = vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
    this->Lamp->SetTransformMatrix(this->Matrix);
    this->Pass->SetSubpixelFrames(Count);
    this->Pass->ProgressiveRefinementOn();
  }

  void Finish()
  {
    for (int i = 0; i < Count; ++i)
    {
      this->Window->Render();
    }
  }

  Picture CaptureAtOnce()
  {
    this->Pass->ProgressiveRefinementOff();
    const Picture picture = Capture(this->Window);
    this->Pass->ProgressiveRefinementOn();
    return picture;
  }

  vtkNew<vtkImageData> Image;
  vtkNew<vtkLookupTable> Table;
  vtkNew<vtkMatrix4x4> Matrix; // of the lamp
  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkElevationFilter> Filter;
  vtkNew<vtkPlane> Plane;
  vtkLight* Lamp = nullptr;
};

inline void CountEvents(vtkObject* object, unsigned long event, int& count)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&count);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  object->AddObserver(event, command);
}
}

#endif
