// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightFuzzScene.h"

#include "vtkActor.h"
#include "vtkAirlight.h"
#include "vtkAirlightPass.h"
#include "vtkDrainePhaseFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTable.h"

namespace airlight_fuzz
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeActor(Input& input)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeMesh(input));
  actor->SetMapper(mapper);
  actor->SetVisibility(input.Integer(0, 7) != 0);
  actor->SetPosition(input.ModestVector().data());
  actor->SetScale(input.Integer(0, 3) == 0 ? input.Modest() : 1.0);
  actor->RotateX(45.0 * input.Integer(0, 7));
  actor->GetProperty()->SetOpacity(input.Integer(0, 3) == 0 ? 0.5 : 1.0);
  actor->GetProperty()->SetRepresentation(input.Integer(0, 5) == 0 ? VTK_WIREFRAME : VTK_SURFACE);
  actor->GetProperty()->SetBackfaceCulling(input.Integer(0, 3) == 0);
  return actor;
}

//------------------------------------------------------------------------------
void ChangeMedium(Input& input, vtkParticipatingMedium* medium)
{
  switch (input.Integer(0, 25))
  {
    case 0:
      return medium->SetScattering(input.Numbers().data());
    case 1:
      return medium->SetAbsorption(input.Numbers().data());
    case 2:
      return medium->SetVisibility(input.Number());
    case 3:
      return medium->SetMeanFreePath(input.Number());
    case 4:
      return medium->SetPhaseFunction(input.Integer(-1, 9));
    case 5:
      return medium->SetAnisotropy(input.Number());
    case 6:
      return medium->SetPhaseTable(input.Flag() ? MakeTable(input) : nullptr);
    case 7:
      return medium->SetPhaseTolerance(input.Number());
    case 8:
      return medium->SetAmbientRadiance(input.Numbers().data());
    case 9:
      return medium->SetRegion(input.Integer(-1, 5));
    case 10:
    {
      const Vector low = input.Numbers();
      const Vector high = input.Numbers();
      return medium->SetBounds(low[0], high[0], low[1], high[1], low[2], high[2]);
    }
    case 11:
      return medium->SetCenter(input.Numbers().data());
    case 12:
      return medium->SetRadius(input.Number());
    case 13:
      return medium->SetSurface(input.Flag() ? MakeMesh(input) : nullptr);
    case 14:
      return medium->SetDensity(input.Integer(-1, 4));
    case 15:
      return medium->SetScaleHeight(input.Number());
    case 16:
      return medium->SetReferenceHeight(input.Number());
    case 17:
      return medium->SetUp(input.Numbers().data());
    case 18:
      return medium->SetDensityImage(input.Flag() ? MakeImage(input) : nullptr);
    case 19:
    {
      Vector rgb = input.ModestVector();
      for (double& c : rgb)
      {
        c = 0.1 * (c + 4.0);
      }
      return medium->SetScattering(rgb.data());
    }
    case 20:
      return medium->SetBounds(-2.0, 2.0, -2.0, 3.0, -2.0, 2.0);
    case 21:
    case 22:
      return medium->SetPhaseFunction(input.Integer(0, 7));
    case 23:
      return medium->SetHeight(input.Number());
    case 24:
      return medium->SetAxis(input.Numbers().data());
    default:
    {
      vtkNew<vtkDrainePhaseFunction> draine;
      draine->SetAnisotropy(input.Number());
      draine->SetAlpha(input.Number());
      return medium->SetPhaseFunction(draine);
    }
  }
}

//------------------------------------------------------------------------------
void ChangeLight(Input& input, vtkLight* light)
{
  switch (input.Integer(0, 13))
  {
    case 0:
      return light->SetPositional(input.Flag());
    case 1:
      return light->SetPosition(input.Numbers().data());
    case 2:
      return light->SetFocalPoint(input.Numbers().data());
    case 3:
      return light->SetConeAngle(input.Number());
    case 4:
      return light->SetExponent(input.Number());
    case 5:
      return light->SetAttenuationValues(input.Numbers().data());
    case 6:
      return light->SetColor(input.Numbers().data());
    case 7:
      return light->SetIntensity(input.Number());
    case 8:
      return light->SetSwitch(input.Integer(0, 3) != 0);
    case 9:
      return light->SetLightType(input.Integer(1, 3));
    case 10:
    {
      vtkNew<vtkMatrix4x4> matrix;
      for (int i = input.Integer(0, 4); i > 0; --i)
      {
        matrix->SetElement(input.Integer(0, 3), input.Integer(0, 3), input.Number());
      }
      return light->SetTransformMatrix(input.Flag() ? matrix : nullptr);
    }
    case 11:
      return vtkAirlight::SetRadiantIntensity(light, input.Numbers().data());
    case 12:
      return vtkAirlight::SetIrradiance(light, input.Numbers().data());
    default:
      return vtkAirlight::SetRadiantIntensity(light, Vector{ 3.0, 2.0, 1.0 }.data());
  }
}

//------------------------------------------------------------------------------
void ChangeDisplay(Input& input, vtkAirlightPass* pass)
{
  switch (input.Integer(0, 5))
  {
    case 0:
      return pass->SetExposure(input.Number());
    case 1:
      return pass->SetAutomaticExposure(input.Flag());
    case 2:
      return pass->SetToneMapping(input.Integer(-1, 6));
    case 3:
      return pass->SetSubpixelFrames(input.Integer(0, 3));
    case 4:
      return pass->SetEncodedOutput(input.Flag());
    default:
      return pass->SetOutputColorSpace(input.Integer(-1, 4));
  }
}

//------------------------------------------------------------------------------
void ChangePass(
  Input& input, vtkAirlightPass* pass, vtkParticipatingMedium* medium, vtkLight* light)
{
  switch (input.Integer(0, 20))
  {
    case 0:
      return pass->AddMedium(input.Flag() ? medium : nullptr);
    case 1:
      return pass->RemoveMedium(medium);
    case 2:
      return pass->RemoveAllMedia();
    case 3:
      return pass->SetShadowTechnique(input.Integer(-1, 5));
    case 4:
      return pass->SetShadowMapResolution(input.Integer(-1, 70));
    case 5:
      return pass->SetNumberOfSteps(input.Integer(-1, 70));
    case 6:
      return pass->SetSurfaceShadows(input.Flag());
    case 7:
      return pass->SetTranslucentShadows(input.Flag());
    case 8:
      return pass->SetScatteredSurfaceLight(input.Flag());
    case 9:
      return pass->SetLinearInput(input.Flag());
    case 10:
      return ChangeDisplay(input, pass);
    case 11:
      return pass->SetAnnotations(input.Flag());
    case 12:
      return pass->SetDebugView(input.Integer(-1, 6));
    case 13:
      return pass->SetLightRadius(input.Number());
    case 14:
      return pass->SetMemoryLimit(input.Integer(-1, 64));
    case 15:
      return pass->SetRecordBuffers(input.Flag());
    case 16:
      return pass->SetLightScatters(input.Flag() ? light : nullptr, input.Flag());
    case 17:
    {
      const Vector up = input.Numbers();
      return pass->SetLightPhotometryUp(input.Integer(0, 7) ? light : nullptr, up[0], up[1], up[2]);
    }
    case 18:
      pass->SetLightPhotometry(
        input.Integer(0, 7) ? light : nullptr, input.Flag() ? "none.ies" : nullptr);
      return;
    case 19:
      return pass->RemoveAllRemoteSilhouettes();
    default:
      return pass->SetMedium(medium);
  }
}
}
