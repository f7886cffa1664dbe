// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAirlightReference takes from a renderer: strips and data sets that are no polygons as VTK
// draws them, warnings of what it leaves out, and several media of which one is an image.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestTools.h"

#include "vtkActor.h"
#include "vtkAirlightReference.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkElevationFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLineSource.h"
#include "vtkParticipatingMedium.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTexture.h"

#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
class Stage
{
public:
  Stage()
  {
    this->Renderer->GetActiveCamera()->SetPosition(1.0, 2.0, 5.0);
    vtkNew<vtkLight> light;
    light->PositionalOn();
    light->SetConeAngle(180.0);
    light->SetPosition(2.0, 3.0, 1.0);
    this->Renderer->AddLight(light);
    this->Reference->SetRenderer(this->Renderer);
    this->Reference->SetSize(24, 18);
    this->Medium->SetScattering(0.2, 0.3, 0.4);
    this->Reference->AddMedium(this->Medium);
  }

  vtkActor* Add(vtkMapper* mapper)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }

  // All values of an array.
  std::vector<double> Compute(const char* name)
  {
    this->Reference->Modified();
    this->Reference->Update();
    vtkDataArray* array = this->Reference->GetOutput()->GetPointData()->GetArray(name);
    std::vector<double> values;
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    {
      values.push_back(array->GetVariantValue(i).ToDouble());
    }
    return values;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkParticipatingMedium> Medium; // everywhere
  vtkNew<vtkAirlightReference> Reference;
};

void CheckSame(const std::vector<double>& a, const std::vector<double>& b, const char* what)
{
  double largest = 0.0;
  double off = a.size() == b.size() && !a.empty() ? 0.0 : 1.0;
  for (size_t i = 0; i < a.size() && i < b.size(); ++i)
  {
    largest = std::max(largest, std::abs(a[i]));
    off = std::max(off, std::abs(a[i] - b[i]));
  }
  Check(largest > 0.0 && off <= 1e-6 * largest, Text(what, ": off by ", off, " of ", largest));
}

//------------------------------------------------------------------------------
void CheckStrips()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(sphere->GetOutputPort());
  stripper->Update();
  Check(stripper->GetOutput()->GetNumberOfStrips() > 0, "there are strips");
  Stage triangles;
  vtkNew<vtkPolyDataMapper> ofTriangles;
  ofTriangles->SetInputConnection(sphere->GetOutputPort());
  triangles.Add(ofTriangles);
  Stage strips;
  vtkNew<vtkPolyDataMapper> ofStrips;
  ofStrips->SetInputConnection(stripper->GetOutputPort());
  strips.Add(ofStrips);
  CheckSame(triangles.Compute("Radiance"), strips.Compute("Radiance"), "triangle strips");
}

// The faces of an image of two points a side are a box.
void CheckGrids()
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(2, 2, 2);
  grid->SetOrigin(-0.5, -0.5, -0.5);
  Stage ofGrid;
  vtkNew<vtkDataSetMapper> gridMapper;
  gridMapper->SetInputData(grid);
  ofGrid.Add(gridMapper)->GetProperty()->SetInterpolationToFlat();
  vtkNew<vtkCubeSource> cube;
  Stage ofCube;
  vtkNew<vtkPolyDataMapper> cubeMapper;
  cubeMapper->SetInputConnection(cube->GetOutputPort());
  ofCube.Add(cubeMapper)->GetProperty()->SetInterpolationToFlat();
  CheckSame(ofGrid.Compute("Radiance"), ofCube.Compute("Radiance"), "a grid");
}

//------------------------------------------------------------------------------
void CheckWarning(const char* part, const std::function<void(Stage&)>& fill)
{
  Stage stage;
  fill(stage);
  ErrorListener warnings(stage.Reference, vtkCommand::WarningEvent);
  stage.Compute("Radiance");
  Check(warnings.Take() == 1 && warnings.GetText().find(part) != std::string::npos,
    Text("a warning of ", part, "; got: ", warnings.GetText()));
}

void CheckWarnings()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  CheckWarning("textured background", [](Stage& stage) {
    stage.Renderer->SetBackgroundTexture(vtkNew<vtkTexture>());
    stage.Renderer->TexturedBackgroundOn();
  });
  CheckWarning("wireframe",
    [&](Stage& stage) { stage.Add(mapper)->GetProperty()->SetRepresentationToWireframe(); });
  CheckWarning("vtk", [&](Stage& stage) {
    vtkNew<vtkGlyph3DMapper> glyphs;
    glyphs->SetInputConnection(sphere->GetOutputPort());
    glyphs->SetSourceConnection(sphere->GetOutputPort());
    stage.Add(glyphs);
  });
  CheckWarning("points and lines", [](Stage& stage) {
    vtkNew<vtkLineSource> line;
    vtkNew<vtkPolyDataMapper> ofLine;
    ofLine->SetInputConnection(line->GetOutputPort());
    stage.Add(ofLine);
  });
  CheckWarning("interpolated before mapping", [&](Stage& stage) {
    vtkNew<vtkElevationFilter> elevation;
    elevation->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkPolyDataMapper> coloured;
    coloured->SetInputConnection(elevation->GetOutputPort());
    coloured->InterpolateScalarsBeforeMappingOn();
    // What VTK's mapper does when it draws.
    coloured->Update();
    coloured->MapScalars(1.0);
    stage.Add(coloured);
  });
}

void CheckActorsWithoutData()
{
  Stage empty;
  Stage bare;
  bare.Add(nullptr);
  bare.Add(vtkNew<vtkPolyDataMapper>());
  CheckSame(empty.Compute("Airlight"), bare.Compute("Airlight"), "actors without data");
}

//------------------------------------------------------------------------------
// Ambient light, with and without a lamp, in fog everywhere and in a box; once the box is an image
// of ones.
void CheckMedia(bool lamp)
{
  std::vector<double> values[2];
  for (const bool image : { false, true })
  {
    Stage stage;
    vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0))->SetSwitch(lamp);
    stage.Renderer->AutomaticLightCreationOff(); // or there is one all the same
    stage.Medium->SetAmbientRadiance(0.1, 0.3, 0.2);
    vtkNew<vtkParticipatingMedium> second;
    second->SetScattering(0.5, 0.6, 0.2);
    second->SetAbsorption(0.1, 0.0, 0.3);
    second->SetAmbientRadiance(1.0, 0.5, 0.2);
    const double bounds[6] = { -1.0, 1.0, -0.5, 1.5, -1.0, 1.0 };
    if (image)
    {
      vtkNew<vtkImageData> ones;
      ones->SetDimensions(5, 3, 4);
      ones->SetOrigin(bounds[0], bounds[2], bounds[4]);
      ones->SetSpacing(0.5, 1.0, 2.0 / 3.0);
      ones->AllocateScalars(VTK_FLOAT, 1);
      ones->GetPointData()->GetScalars()->Fill(1.0);
      second->SetDensityToImage();
      second->SetDensityImage(ones);
    }
    else
    {
      second->SetRegionToBox();
      second->SetBounds(bounds);
    }
    stage.Reference->AddMedium(second);
    values[image] = stage.Compute("Airlight");
  }
  CheckSame(values[0], values[1], "two media, one of them an image");
}
}

//------------------------------------------------------------------------------
int TestAirlightReferenceScenes(int, char*[])
{
  CheckStrips();
  CheckGrids();
  CheckWarnings();
  CheckActorsWithoutData();
  CheckMedia(false);
  CheckMedia(true);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
