// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestContent.h"

#include "Scene/AirlightVTKVersions.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkFloatArray.h"
#include "vtkLineSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkSphereSource.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
void AddShadings(Scene& scene)
{
  const auto data = MakeSphere(0.7);
  for (int i = 0; i < 6; ++i)
  {
    vtkProperty* property =
      AddActor(scene, data, { 1.5 * (i % 3 - 1), i < 3 ? 0.9 : -0.9, 0.0 })->GetProperty();
    property->SetInterpolation(std::min(i, 2));
    property->SetRepresentation(i == 4 ? VTK_WIREFRAME : i == 5 ? VTK_POINTS : VTK_SURFACE);
    property->SetEdgeVisibility(i == 3);
    property->SetPointSize(3.0f);
    property->SetAmbient(0.1);
    property->SetSpecular(0.6);
    property->SetSpecularPower(20.0);
  }
}

//------------------------------------------------------------------------------
void AddVertices(Scene& scene)
{
  vtkProperty* property = AddActor(scene, MakeSphere(1.5))->GetProperty();
  property->SetVertexVisibility(true);
  property->SetEdgeVisibility(true);
  property->SetPointSize(5.0f);
  property->SetLineWidth(2.0f);
}

//------------------------------------------------------------------------------
void AddLines(Scene& scene)
{
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkLineSource> line;
    line->SetPoint1(-1.8, i - 1.5, 0.0);
    line->SetPoint2(1.8, i - 1.0, -1.0 * i);
    vtkProperty* property = AddActor(scene, Make(line))->GetProperty();
    property->SetLineWidth(1.0f + 3.0f * static_cast<float>(i));
    property->SetRenderLinesAsTubes(i == 3);
    property->SetLighting(i != 1);
  }
}

//------------------------------------------------------------------------------
void AddPoints(Scene& scene, bool spheres)
{
  vtkProperty* property = AddActor(scene, MakePoints(5))->GetProperty();
  property->SetPointSize(spheres ? 9.0f : 5.0f);
  property->SetRenderPointsAsSpheres(spheres);
}

//------------------------------------------------------------------------------
void AddBackfaces(Scene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(-0.3, 0.0, -1.0);
  plane->SetOrigin(0.0, 0.0, 0.5);
  vtkActor* actor = AddActor(scene, MakeSphere(1.6));
  actor->GetMapper()->AddClippingPlane(plane);
  vtkNew<vtkProperty> back;
  back->SetColor(0.1, 0.8, 0.3);
  actor->SetBackfaceProperty(back);
  AddActor(scene, MakeSphere(0.8), { 1.4, 1.0, 0.0 })->GetProperty()->FrontfaceCullingOn();
}

//------------------------------------------------------------------------------
void AddUnlit(Scene& scene) { AddActor(scene, MakeSphere(1.5))->GetProperty()->LightingOff(); }

//------------------------------------------------------------------------------
void AddPhysical(Scene& scene, bool environment)
{
  for (int i = 0; i < 2; ++i)
  {
    vtkProperty* property =
      AddActor(scene, MakeSphere(0.9), { 2.0 * i - 1.0, 0.0, 0.0 })->GetProperty();
    property->SetInterpolationToPBR();
    property->SetMetallic(i);
    property->SetRoughness(0.3);
  }
  if (environment)
  {
    scene.Renderer->UseImageBasedLightingOn();
    scene.Renderer->SetEnvironmentTexture(MakeCubeMap());
    // Small tables: VTK fills them on the graphics card, which may be a software one.
    auto* renderer = vtkOpenGLRenderer::SafeDownCast(scene.Renderer);
    renderer->UseSphericalHarmonicsOff();
    renderer->GetEnvMapLookupTable()->SetLUTSize(16);
    renderer->GetEnvMapLookupTable()->SetLUTSamples(16);
    renderer->GetEnvMapIrradiance()->SetIrradianceSize(8);
    renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.5f);
    renderer->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
    renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(16);
  }
}

//------------------------------------------------------------------------------
void AddTexture(Scene& scene, int components)
{
  AddActor(scene, MakeSphere(0.8), { 0.0, 0.0, -1.5 });
  vtkActor* actor = AddActor(scene, MakeSquare(1.5));
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->SetTexture(MakeTexture(components));
}

//------------------------------------------------------------------------------
void AddScalars(Scene& scene)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto data = MakeScalarSphere(0.8);
    vtkNew<vtkFloatArray> values;
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      values->InsertNextValue(0.01f * static_cast<float>(cell * 37 % 100));
    }
    data->GetCellData()->SetScalars(values);
    vtkMapper* mapper = AddActor(scene, data, { 1.4 * (i - 1), 0.5 * i - 0.5, 0.0 })->GetMapper();
    mapper->ScalarVisibilityOn();
    mapper->SetScalarMode(i == 1 ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
    mapper->SetInterpolateScalarsBeforeMapping(i == 2);
  }
}

//------------------------------------------------------------------------------
void AddTranslucent(Scene& scene)
{
  AddActor(scene, MakeSphere(0.7));
  const double z[3] = { 1.5, 1.0, -1.5 };
  for (int i = 0; i < 3; ++i)
  {
    vtkActor* actor = AddActor(scene, MakeSphere(0.8), { 0.7 * (i - 1), 0.3 * i, z[i] });
    actor->GetProperty()->SetOpacity(0.3 + 0.2 * i);
    actor->GetProperty()->SetColor(0.2, 0.4 * i, 0.9 - 0.3 * i);
  }
}

//------------------------------------------------------------------------------
void AddComposite(Scene& scene)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  const double places[4][3] = { { -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, { 1, 1, 0 } };
  for (unsigned int i = 0; i < 4; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.8);
    sphere->SetCenter(places[i]);
    blocks->SetBlock(i, Make(sphere));
  }
  const double green[3] = { 0.1, 0.9, 0.3 };
  vtkNew<airlight::BlocksMapper> mapper;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetInputDataObject(blocks);
  attributes->SetBlockColor(blocks->GetBlock(1), green);
  attributes->SetBlockOpacity(blocks->GetBlock(2), 0.4);
  attributes->SetBlockVisibility(blocks->GetBlock(3), false);
  AddActor(scene, mapper);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkGlyph3DMapper> MakeGlyphs()
{
  const auto points = MakePoints(3);
  vtkNew<vtkFloatArray> directions;
  directions->SetName("directions");
  directions->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("sizes");
  for (int i = 0; i < 9; ++i)
  {
    directions->InsertNextTuple3(1.0, 0.3 * i - 1.0, 0.2 * i);
    sizes->InsertNextValue(0.5f + 0.1f * static_cast<float>(i));
  }
  points->GetPointData()->AddArray(directions);
  points->GetPointData()->AddArray(sizes);
  vtkNew<vtkPlaneSource> board; // from edge to edge, so that it shows how it is turned
  board->SetOrigin(0.0, -0.2, -0.1);
  board->SetPoint1(0.9, -0.2, -0.1);
  board->SetPoint2(0.0, 0.3, 0.3);
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputData(points);
  mapper->SetSourceData(Make(board));
  mapper->SetOrientationArray("directions");
  mapper->SetOrientationModeToDirection();
  mapper->SetScaleArray("sizes");
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->ScalarVisibilityOff();
  return mapper;
}

//------------------------------------------------------------------------------
void AddGlyphs(Scene& scene, double opacity)
{
  AddActor(scene, MakeGlyphs())->GetProperty()->SetOpacity(opacity);
}

//------------------------------------------------------------------------------
void AddGaussians(Scene& scene, bool emissive, double opacity)
{
  AddActor(scene, MakeSphere(0.5));
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(MakePoints(4));
  mapper->SetScaleFactor(0.3);
  mapper->SetEmissive(emissive);
  AddActor(scene, mapper)->GetProperty()->SetOpacity(opacity);
}
}
