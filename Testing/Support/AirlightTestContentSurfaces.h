// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Contents that are drawn as surfaces, lines and points, opaque and translucent.
 */

#ifndef AirlightTestContentSurfaces_h
#define AirlightTestContentSurfaces_h

#include "AirlightTestContent.h"

#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLineSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"

#include <utility>

namespace airlighttest
{
//------------------------------------------------------------------------------
// Shadings and representations of one sphere each.
inline void AddShadings(Theatre& theatre)
{
  const auto data = MakeSphere(0.7);
  for (int i = 0; i < 6; ++i)
  {
    vtkProperty* property =
      theatre.Add(data, 1.5 * (i % 3 - 1), i < 3 ? 0.9 : -0.9, 0.0)->GetProperty();
    property->SetInterpolation(std::min(i, 2));
    property->SetRepresentation(i == 4 ? VTK_WIREFRAME : i == 5 ? VTK_POINTS : VTK_SURFACE);
    property->SetEdgeVisibility(i == 3);
    property->SetPointSize(3.0f);
    property->SetAmbient(0.1);
    property->SetSpecular(0.6);
    property->SetSpecularPower(20.0);
  }
}

inline void AddVertices(Theatre& theatre)
{
  vtkProperty* property = theatre.Add(MakeSphere(1.5))->GetProperty();
  property->SetVertexVisibility(true);
  property->SetEdgeVisibility(true);
  property->SetPointSize(5.0f);
  property->SetLineWidth(2.0f);
}

inline void AddLines(Theatre& theatre)
{
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkLineSource> line;
    line->SetPoint1(-1.8, i - 1.5, 0.0);
    line->SetPoint2(1.8, i - 1.0, -1.0 * i);
    vtkProperty* property = theatre.Add(Make(line))->GetProperty();
    property->SetLineWidth(1.0f + 3.0f * static_cast<float>(i));
    property->SetRenderLinesAsTubes(i == 3);
    property->SetLighting(i != 1);
  }
}

inline void AddPoints(Theatre& theatre, bool spheres)
{
  vtkProperty* property = theatre.Add(MakePoints(5))->GetProperty();
  property->SetPointSize(spheres ? 9.0f : 5.0f);
  property->SetRenderPointsAsSpheres(spheres);
}

inline void AddBackfaces(Theatre& theatre)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(-0.3, 0.0, -1.0);
  plane->SetOrigin(0.0, 0.0, 0.5);
  vtkActor* actor = theatre.Add(MakeSphere(1.6));
  actor->GetMapper()->AddClippingPlane(plane);
  vtkNew<vtkProperty> back;
  back->SetColor(0.1, 0.8, 0.3);
  actor->SetBackfaceProperty(back);
  theatre.Add(MakeSphere(0.8), 1.4, 1.0, 0.0)->GetProperty()->FrontfaceCullingOn();
}

inline void AddUnlit(Theatre& theatre)
{
  theatre.Add(MakeSphere(1.5))->GetProperty()->LightingOff();
}

inline void AddPhysical(Theatre& theatre, bool environment)
{
  for (int i = 0; i < 2; ++i)
  {
    vtkProperty* property = theatre.Add(MakeSphere(0.9), 2.0 * i - 1.0, 0.0, 0.0)->GetProperty();
    property->SetInterpolationToPBR();
    property->SetMetallic(i);
    property->SetRoughness(0.3);
  }
  if (environment)
  {
    theatre.Renderer->UseImageBasedLightingOn();
    theatre.Renderer->SetEnvironmentTexture(MakeCubeMap());
    // Small tables: VTK fills them on the graphics card, which may be a software one.
    auto* renderer = vtkOpenGLRenderer::SafeDownCast(theatre.Renderer);
    renderer->UseSphericalHarmonicsOff();
    renderer->GetEnvMapLookupTable()->SetLUTSize(16);
    renderer->GetEnvMapLookupTable()->SetLUTSamples(16);
    renderer->GetEnvMapIrradiance()->SetIrradianceSize(8);
    renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.5f);
    renderer->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
    renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(16);
  }
}

inline void AddTexture(Theatre& theatre, int components)
{
  theatre.Add(MakeSphere(0.8), 0.0, 0.0, -1.5);
  vtkActor* actor = theatre.Add(MakeSquare(1.5));
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->SetTexture(MakeTexture(components));
}

// By point, by cell, and by point through a texture.
inline void AddScalars(Theatre& theatre)
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
    vtkMapper* mapper = theatre.Add(data, 1.4 * (i - 1), 0.5 * i - 0.5, 0.0)->GetMapper();
    mapper->ScalarVisibilityOn();
    mapper->SetScalarMode(i == 1 ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
    mapper->SetInterpolateScalarsBeforeMapping(i == 2);
  }
}

//------------------------------------------------------------------------------
// Translucent surfaces that cross each other, before and behind an opaque one.
inline void AddTranslucent(Theatre& theatre)
{
  theatre.Add(MakeSphere(0.7));
  const double z[3] = { 1.5, 1.0, -1.5 };
  for (int i = 0; i < 3; ++i)
  {
    vtkActor* actor = theatre.Add(MakeSphere(0.8), 0.7 * (i - 1), 0.3 * i, z[i]);
    actor->GetProperty()->SetOpacity(0.3 + 0.2 * i);
    actor->GetProperty()->SetColor(0.2, 0.4 * i, 0.9 - 0.3 * i);
  }
}

// Blocks of their own colour and opacity, one of them hidden.
inline void AddComposite(Theatre& theatre)
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
  vtkNew<vtkCompositePolyDataMapper2> mapper;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetInputDataObject(blocks);
  attributes->SetBlockColor(blocks->GetBlock(1), green);
  attributes->SetBlockOpacity(blocks->GetBlock(2), 0.4);
  attributes->SetBlockVisibility(blocks->GetBlock(3), false);
  theatre.Add(mapper);
}

// Glyphs turned and scaled by arrays.
inline vtkSmartPointer<vtkGlyph3DMapper> MakeGlyphs()
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

inline void AddGlyphs(Theatre& theatre, double opacity)
{
  theatre.Add(MakeGlyphs())->GetProperty()->SetOpacity(opacity);
}

inline void AddGaussians(Theatre& theatre, bool emissive, double opacity)
{
  theatre.Add(MakeSphere(0.5));
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(MakePoints(4));
  mapper->SetScaleFactor(0.3);
  mapper->SetEmissive(emissive);
  theatre.Add(mapper)->GetProperty()->SetOpacity(opacity);
}
}

#endif
