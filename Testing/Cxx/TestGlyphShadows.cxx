// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The glyphs of vtkGlyph3DMapper cast shadows from where they are drawn.

#include "AirlightTestContentFog.h"

#include "vtkGlyph3D.h"

#include <cstdlib>

using namespace airlighttest;

namespace
{
// The share of the pixels whose values differ by more than this share.
double CountDifferent(vtkImageData* a, vtkImageData* b, double limit)
{
  int count = 0;
  for (int j = 0; j < Theatre::Height; ++j)
  {
    for (int i = 0; i < Theatre::Width; ++i)
    {
      const double value = GetValue(a, i, j);
      count += std::abs(value - GetValue(b, i, j)) > limit * std::abs(value) ? 1 : 0;
    }
  }
  return count / double(Theatre::Width * Theatre::Height);
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
  fog.Lamp = fog.AddLamp(place);
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
  fog.Add(MakeSquare(5.0, -1.0));
  const auto mapper = MakeGlyphs();
  vtkActor* actor = fog.Add(mapper);
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
  fog.Add(MakeSquare(5.0, -1.0));
  fog.Add(Make(filter))->RotateX(20.0);
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

// A lamp beside the eye sees what the eye sees: nothing that is seen is in shadow, nor what is before
// it, but for what the little distance between the two opens. Where glyphs cast from places
// at which they are not drawn, there is shadow in the air.
void CheckInPlace(Fog& fog, const std::string& name,
  const std::function<void(vtkGlyph3DMapper*)>& set, vtkPolyData* second = nullptr)
{
  BeginWithLamp(fog, { 0.02, 0.02, 8.0 });
  fog.Add(MakeSquare(5.0, -1.0));
  const auto mapper = MakeGlyphs();
  if (second)
  {
    mapper->SetSourceData(1, second);
  }
  set(mapper);
  fog.Add(mapper);
  Frame frame;
  Render(fog, frame);
  const double dark = CountDifferent(frame.Depth, frame.LitLength, 0.01);
  std::cout << name << ": in shadow " << dark << " of the pixels\n";
  Check(dark < 0.005, name + ": glyphs cast from where they are drawn");
}
}

//------------------------------------------------------------------------------
int TestGlyphShadows(int, char*[])
{
  Fog fog;
  TestSameAsFilter(fog);
  CheckInPlace(fog, "direction", [](vtkGlyph3DMapper*) {});
  CheckInPlace(fog, "rotation", [](vtkGlyph3DMapper* mapper) {
    auto* data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
    vtkDataArray* angles = data->GetPointData()->GetArray("directions");
    for (vtkIdType i = 0; i < 9; ++i)
    {
      angles->SetTuple3(i, 20.0 * i, 100.0 - 30.0 * i, 50.0 * i);
    }
    mapper->SetOrientationModeToRotation();
  });
  CheckInPlace(fog, "quaternion", [](vtkGlyph3DMapper* mapper) {
    auto* data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
    vtkNew<vtkFloatArray> turns;
    turns->SetName("turns");
    turns->SetNumberOfComponents(4);
    for (int i = 0; i < 9; ++i)
    {
      const glm::dvec4 q = glm::normalize(glm::dvec4(1.0, 0.3 * i - 1.0, 0.2 * i, 0.5 - 0.1 * i));
      turns->InsertNextTuple(&q.x);
    }
    data->GetPointData()->AddArray(turns);
    mapper->SetOrientationArray("turns");
    mapper->SetOrientationModeToQuaternion();
  });
  CheckInPlace(fog, "clamped", [](vtkGlyph3DMapper* mapper) {
    mapper->ClampingOn();
    mapper->SetRange(0.6, 1.2);
    mapper->SetScaleFactor(1.3);
  });
  CheckInPlace(fog, "by components", [](vtkGlyph3DMapper* mapper) {
    mapper->SetScaleArray("directions");
    mapper->SetScaleModeToScaleByVectorComponents();
    mapper->OrientOff();
  });
  CheckInPlace(
    fog, "indexed, masked",
    [](vtkGlyph3DMapper* mapper) {
      auto* data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
      for (const char* name : { "index", "mask" })
      {
        vtkNew<vtkFloatArray> values;
        values->SetName(name);
        for (int i = 0; i < 9; ++i)
        {
          values->InsertNextValue(static_cast<float>(name[0] == 'i' ? i % 3 : i % 4));
        }
        data->GetPointData()->AddArray(values);
      }
      mapper->SetSourceIndexArray("index");
      mapper->SourceIndexingOn();
      mapper->SetMaskArray("mask");
      mapper->MaskingOn();
    },
    MakeSphere(0.3));
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
