// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameContent.h"

#include "Scene/AirlightVTKVersions.h"
#include "vtkActor.h"
#include "vtkConeSource.h"
#include "vtkContourFilter.h"
#include "vtkCutter.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRTAnalyticSource.h"
#include "vtkShrinkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStreamTracer.h"
#include "vtkTriangleFilter.h"
#include "vtkTubeFilter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVertexGlyphFilter.h"

#include <cmath>

namespace benchmarks
{
namespace
{
vtkSmartPointer<vtkPolyData> Make(vtkPolyDataAlgorithm* source)
{
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeBall(double x, double y, double z, double radius, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, y, z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution + 1);
  return Make(sphere);
}

vtkActor* AddMapper(FrameScene& scene, vtkMapper* mapper)
{
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  return actor;
}

// So many points in the box of half width 2 above the floor.
vtkSmartPointer<vtkPolyData> MakeCloud(int count)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  const auto next = [&random](double low, double high) {
    random->Next();
    return random->GetRangeValue(low, high);
  };
  vtkNew<vtkPoints> points;
  for (int i = 0; i < count; ++i)
  {
    const double x = next(-2.0, 2.0);
    const double y = next(0.3, 3.0);
    points->InsertNextPoint(x, y, next(-2.0, 2.0));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

//------------------------------------------------------------------------------
void AddNothing(FrameScene&) {}

void AddUnlit(FrameScene& scene)
{
  scene.Add(MakeBall(-2.0, 1.0, 1.0, 0.7, 32))->GetProperty()->LightingOff();
}

void AddWireframe(FrameScene& scene)
{
  scene.Add(MakeBall(-2.0, 1.0, 1.0, 0.7, 32))->GetProperty()->SetRepresentationToWireframe();
}

void AddEdges(FrameScene& scene)
{
  scene.Add(MakeBall(-2.0, 1.0, 1.0, 0.7, 32))->GetProperty()->EdgeVisibilityOn();
}

void AddTranslucentBall(FrameScene& scene)
{
  scene.Add(MakeBall(-2.0, 1.0, 1.0, 0.7, 32))->GetProperty()->SetOpacity(0.05);
}

// Behind one another along z.
void AddSheets(FrameScene& scene)
{
  for (int i = 0; i < 50; ++i)
  {
    vtkNew<vtkPolyData> sheet;
    vtkNew<vtkPoints> points;
    const double z = -3.0 + 0.1 * i;
    for (int corner = 0; corner < 4; ++corner)
    {
      points->InsertNextPoint(corner == 1 || corner == 2 ? 2.0 : -2.0, corner > 1 ? 2.5 : 0.5, z);
    }
    const vtkIdType corners[4] = { 0, 1, 2, 3 };
    sheet->SetPoints(points);
    sheet->AllocateEstimate(1, 4);
    sheet->InsertNextCell(VTK_QUAD, 4, corners);
    scene.Add(sheet)->GetProperty()->SetOpacity(0.05);
  }
}

// Each triangle apart from its neighbours.
void AddShrunk(FrameScene& scene, int resolution)
{
  vtkNew<vtkShrinkPolyData> shrink;
  shrink->SetInputData(MakeBall(-2.0, 1.2, 0.5, 1.0, resolution));
  shrink->SetShrinkFactor(0.8);
  scene.Add(Make(shrink));
}

void AddShrunk2000(FrameScene& scene) { AddShrunk(scene, 32); }
void AddShrunk20000(FrameScene& scene) { AddShrunk(scene, 100); }

void AddCones(FrameScene& scene)
{
  vtkNew<vtkConeSource> cone;
  cone->SetRadius(0.03);
  cone->SetHeight(0.1);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(MakeCloud(5000));
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetScaleFactor(1.0);
  AddMapper(scene, mapper);
}

void AddGaussians(FrameScene& scene)
{
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(MakeCloud(3000));
  mapper->SetScaleFactor(0.05);
  mapper->EmissiveOff();
  AddMapper(scene, mapper);
}

void AddMolecule(FrameScene& scene)
{
  vtkNew<vtkVertexGlyphFilter> vertices; // points that no cell uses are not drawn
  vertices->SetInputData(MakeCloud(10000));
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputConnection(vertices->GetOutputPort());
  mapper->SetRadius(0.04);
  AddMapper(scene, mapper);
}

void AddMoleculeGlyphs(FrameScene& scene)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.04);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(MakeCloud(10000));
  mapper->SetSourceConnection(sphere->GetOutputPort());
  mapper->SetScaleFactor(1.0);
  AddMapper(scene, mapper);
}

//------------------------------------------------------------------------------
// A vortex that rises, on a grid over the floor.
vtkSmartPointer<vtkImageData> MakeFlow()
{
  constexpr int n = 20;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetOrigin(-2.0, 0.2, -2.0);
  image->SetSpacing(4.0 / (n - 1), 3.0 / (n - 1), 4.0 / (n - 1));
  image->AllocateScalars(VTK_DOUBLE, 3);
  image->GetPointData()->GetScalars()->SetName("velocity");
  image->GetPointData()->SetActiveVectors("velocity");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    image->GetPointData()->GetScalars()->SetTuple3(
      i, -p[2], 0.4 + 0.3 * std::sin(3.0 * p[0]), p[0]);
  }
  return image;
}

void AddStreamtubes(FrameScene& scene)
{
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputData(MakeFlow());
  tracer->SetSourceData(MakeCloud(60));
  tracer->SetMaximumPropagation(12.0);
  tracer->SetInitialIntegrationStep(0.1);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(tracer->GetOutputPort());
  tubes->SetRadius(0.02);
  tubes->SetNumberOfSides(8);
  vtkNew<vtkTriangleFilter> triangles; // strips are not counted
  triangles->SetInputConnection(tubes->GetOutputPort());
  scene.Add(Make(triangles));
}

void AddCutAway(FrameScene& scene)
{
  vtkActor* actor = scene.Add(MakeBall(-2.0, 1.2, 0.5, 1.0, 64));
  for (double sign : { -1.0, 1.0 })
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(-2.0, 1.2, 0.5);
    plane->SetNormal(sign < 0.0 ? 1.0 : 0.0, 0.3, -1.0);
    actor->GetMapper()->AddClippingPlane(plane);
  }
}

void AddBlocks(FrameScene& scene)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 200; ++i)
  {
    blocks->SetBlock(
      i, MakeBall(0.4 * (i % 10) - 1.8, 0.2 + 0.4 * (i / 10 % 5), 0.5 * (i / 50) - 2.0, 0.12, 12));
  }
  vtkNew<airlight::BlocksMapper> mapper;
  mapper->SetInputDataObject(blocks);
  AddMapper(scene, mapper);
}

void AddUnstructuredGrid(FrameScene& scene)
{
  constexpr int n = 14;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < n * n * n; ++i)
  {
    const double x = i % n;
    const double y = i / n % n;
    points->InsertNextPoint(
      -3.0 + 0.14 * x + 0.05 * std::sin(0.9 * y), 0.2 + 0.14 * y, 0.14 * (i / n / n) - 0.5);
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  for (int i = 0; i < n * n * n; ++i)
  {
    if (i % n + 1 < n && i / n % n + 1 < n && i / n / n + 1 < n)
    {
      const vtkIdType a = i;
      const vtkIdType corners[8] = { a, a + 1, a + 1 + n, a + n, a + n * n, a + 1 + n * n,
        a + 1 + n + n * n, a + n + n * n };
      grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
    }
  }
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(grid);
  AddMapper(scene, mapper)->GetProperty()->EdgeVisibilityOn();
}

// Lines of equal value on a slice through VTK's wavelet.
void AddContourLines(FrameScene& scene)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, 1.0);
  vtkNew<vtkCutter> cut;
  cut->SetInputConnection(wavelet->GetOutputPort());
  cut->SetCutFunction(plane);
  vtkNew<vtkContourFilter> contours;
  contours->SetInputConnection(cut->GetOutputPort());
  contours->GenerateValues(20, 60.0, 260.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(contours->GetOutputPort());
  vtkActor* actor = AddMapper(scene, mapper);
  actor->SetScale(0.2);
  actor->SetPosition(0.0, 2.2, -1.5);
}
}

//------------------------------------------------------------------------------
std::vector<Content> GetMeshContent()
{
  return {
    { "nothing", AddNothing },
    { "unlit", AddUnlit },
    { "wireframe", AddWireframe },
    { "edges", AddEdges },
    { "translucent", AddTranslucentBall },
    { "50-sheets", AddSheets },
    { "shrunk-2000", AddShrunk2000 },
    { "shrunk-20000", AddShrunk20000 },
    { "5000-cones", AddCones },
    { "3000-gaussians", AddGaussians },
    { "10000-spheres", AddMolecule },
    { "10000-glyphs", AddMoleculeGlyphs },
    { "streamtubes", AddStreamtubes },
    { "cut-away", AddCutAway },
    { "200-blocks", AddBlocks },
    { "unstructured-grid", AddUnstructuredGrid },
    { "contour-lines", AddContourLines },
  };
}
}
