// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The glyphs of vtkGlyph3DMapper cast shadows from where they are drawn.

#include "AirlightTestContentFog.h"

#include "vtkBitArray.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3D.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// The share of the pixels whose values differ by more than this share.
double CountDifferent(vtkImageData* a, vtkImageData* b, double limit)
{
  int count = 0;
  for (int j = 0; j < Fog::PictureHeight; ++j)
  {
    for (int i = 0; i < Fog::PictureWidth; ++i)
    {
      const double value = GetValue(a, i, j);
      count += std::abs(value - GetValue(b, i, j)) > limit * std::abs(value) ? 1 : 0;
    }
  }
  return count / double(Fog::PictureWidth * Fog::PictureHeight);
}

struct Frame
{
  vtkNew<vtkImageData> Depth;
  vtkNew<vtkImageData> LitLength;
};

void BeginWithLamp(Fog& fog, const glm::dvec3& place)
{
  fog.Begin();
  fog.Renderer->RemoveAllLights(); // LitLength is that of all lights
  fog.Lamp = AddLamp(fog, place);
}

void Render(Fog& fog, Frame& frame)
{
  fog.Pass->SetShadowTechniqueToAutomatic();
  fog.Render(true);
  frame.Depth->DeepCopy(fog.Pass->GetBuffer("Depth"));
  frame.LitLength->DeepCopy(fog.Pass->GetBuffer("LitLength"));
}

// The same glyphs made by vtkGlyph3D, polygons like any others.
void TestSameAsFilter(Fog& fog)
{
  Frame mapped, filtered, unshadowed;
  BeginWithLamp(fog, { 1.5, 3.0, 4.0 });
  AddActor(fog, MakeSquare(5.0, -1.0));
  const auto mapper = MakeGlyphs();
  vtkActor* actor = AddActor(fog, mapper);
  actor->RotateX(20.0);
  Render(fog, mapped);
  fog.Pass->SetShadowTechniqueToNone();
  fog.Render(true);
  unshadowed.LitLength->DeepCopy(fog.Pass->GetBuffer("LitLength"));
  auto* points = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  points->GetPointData()->SetActiveScalars("sizes");
  points->GetPointData()->SetActiveVectors("directions");
  vtkNew<vtkGlyph3D> filter;
  filter->SetInputData(points);
  filter->SetSourceData(mapper->GetSource());
  filter->SetVectorModeToUseVector();
  filter->SetScaleModeToScaleByScalar();
  BeginWithLamp(fog, { 1.5, 3.0, 4.0 });
  AddActor(fog, MakeSquare(5.0, -1.0));
  AddActor(fog, Make(filter))->RotateX(20.0);
  Render(fog, filtered);
  const double depths = CountDifferent(mapped.Depth, filtered.Depth, 1e-5);
  const double lit = CountDifferent(mapped.LitLength, filtered.LitLength, 1e-4);
  const double cast = CountDifferent(mapped.LitLength, unshadowed.LitLength, 1e-4);
  std::cout << "glyph mapper and filter: of the pixels differ in depth " << depths
            << ", in lit length " << lit << "; the glyphs shade " << cast << "\n";
  // Pixels at the very edge of a glyph or of a shadow.
  Check(depths < 0.002 && lit < 0.005, "the mapper's glyphs cast as those of the filter");
  Check(cast > 0.1, "glyphs cast");
}

// The same glyphs as actors of their own, turned and scaled by what VTK says of the
// mapper's modes.
using Place = std::function<void(int, vtkActor*)>;

void CheckSameAsActors(Fog& fog, const std::string& name,
  const std::function<void(vtkGlyph3DMapper*, vtkPointData*)>& set, const Place& place)
{
  Frame mapped, actors;
  BeginWithLamp(fog, { 1.5, 3.0, 4.0 });
  AddActor(fog, MakeSquare(5.0, -1.0));
  const auto mapper = MakeGlyphs();
  auto* points = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  set(mapper, points->GetPointData());
  AddActor(fog, mapper);
  Render(fog, mapped);
  BeginWithLamp(fog, { 1.5, 3.0, 4.0 });
  AddActor(fog, MakeSquare(5.0, -1.0));
  for (int i = 0; i < 9; ++i)
  {
    vtkActor* actor = AddActor(fog, mapper->GetSource());
    actor->SetPosition(points->GetPoint(i));
    place(i, actor);
  }
  Render(fog, actors);
  const double depths = CountDifferent(mapped.Depth, actors.Depth, 1e-5);
  const double lit = CountDifferent(mapped.LitLength, actors.LitLength, 1e-4);
  std::cout << name << ": of the pixels differ in depth " << depths << ", in lit length " << lit
            << "\n";
  Check(depths < 0.002, name + ": drawn at the same places");
  Check(lit < 0.005, name + ": casts from the same places");
}

void AddArray(vtkPointData* data, const char* name, int components,
  const std::function<double(int, int)>& value)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(9);
  for (int i = 0; i < 9 * components; ++i)
  {
    array->SetComponent(i / components, i % components, value(i / components, i % components));
  }
  data->AddArray(array);
}

void TestModes(Fog& fog)
{
  const auto angle = [](int i, int k) { return 20.0 * i - 30.0 * k + 10.0 * i * k; };
  CheckSameAsActors(
    fog, "rotation",
    [&](vtkGlyph3DMapper* mapper, vtkPointData* data) {
      AddArray(data, "angles", 3, angle);
      mapper->SetOrientationArray("angles");
      mapper->SetOrientationModeToRotation();
      mapper->ScalingOff();
    },
    [&](int i, vtkActor* a) { a->SetOrientation(angle(i, 0), angle(i, 1), angle(i, 2)); });
  CheckSameAsActors(
    fog, "quaternion",
    [](vtkGlyph3DMapper* mapper, vtkPointData* data) {
      // Turns by 35 i degrees about (0.6, 0, 0.8).
      AddArray(data, "turns", 4, [](int i, int k) {
        const double axis[4] = { 0.0, 0.6, 0.0, 0.8 };
        const double half = glm::radians(17.5 * i);
        return k == 0 ? std::cos(half) : axis[k] * std::sin(half);
      });
      mapper->SetOrientationArray("turns");
      mapper->SetOrientationModeToQuaternion();
      mapper->ScalingOff();
    },
    [](int i, vtkActor* a) { a->RotateWXYZ(35.0 * i, 0.6, 0.0, 0.8); });
  CheckSameAsActors(
    fog, "clamped, masked",
    [](vtkGlyph3DMapper* mapper, vtkPointData* data) {
      vtkNew<vtkBitArray> mask;
      mask->SetName("mask");
      for (int i = 0; i < 9; ++i)
      {
        mask->InsertNextValue(i % 4 != 0);
      }
      data->AddArray(mask);
      mapper->SetMaskArray("mask");
      mapper->MaskingOn();
      mapper->OrientOff();
      mapper->ClampingOn();
      mapper->SetRange(0.45, 1.05);
      mapper->SetScaleFactor(1.5);
    },
    [](int i, vtkActor* a) {
      a->SetVisibility(i % 4 != 0);
      a->SetScale(1.5 * (std::min(0.5 + 0.1 * i, 1.05) - 0.45) / 0.6);
    });
  CheckSameAsActors(
    fog, "by components",
    [](vtkGlyph3DMapper* mapper, vtkPointData* data) {
      AddArray(data, "scales", 3, [](int i, int k) { return 0.5 + 0.1 * i + 0.2 * k; });
      mapper->SetScaleArray("scales");
      mapper->SetScaleModeToScaleByVectorComponents();
      mapper->OrientOff();
    },
    [](int i, vtkActor* a) { a->SetScale(0.5 + 0.1 * i, 0.7 + 0.1 * i, 0.9 + 0.1 * i); });
  const auto ball = MakeSphere(0.3);
  CheckSameAsActors(
    fog, "indexed sources",
    [&](vtkGlyph3DMapper* mapper, vtkPointData* data) {
      // From -1 to 2. The mapper takes a number's size, and the last source beyond the last.
      AddArray(data, "which", 1, [](int i, int) { return i % 4 - 1; });
      mapper->SetSourceData(1, ball);
      mapper->SetSourceIndexArray("which");
      mapper->SourceIndexingOn();
      mapper->OrientOff();
      mapper->ScalingOff();
    },
    [&](int i, vtkActor* a) {
      if (i % 4 != 1)
      {
        vtkPolyDataMapper::SafeDownCast(a->GetMapper())->SetInputData(ball);
      }
    });
}
}

//------------------------------------------------------------------------------
int TestGlyphShadows(int, char*[])
{
  Fog fog;
  TestSameAsFilter(fog);
  TestModes(fog);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
