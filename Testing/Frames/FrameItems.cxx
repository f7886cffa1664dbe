// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Contents that are a mesh with properties.

#include "FrameParts.h"

#include "RandomParts.h"

#include "vtkAirlightPass.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

namespace airlight_test
{
namespace
{
// Other points and other cells, which are made before the mesh's own: what a cache that knows times
// alone may take for what it has.
void MakeOlder(FrameItem& item, Random& random)
{
  const glm::dvec3 shift = RandomPoint(random, 0.8);
  item.Points = vtkSmartPointer<vtkPoints>::New();
  item.Points->DeepCopy(item.Mesh->GetPoints());
  for (vtkIdType i = 0; i < item.Points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    item.Points->GetPoint(i, p);
    item.Points->SetPoint(i, p[0] + shift.x, 0.6 * p[1] + shift.y, p[2] + shift.z);
  }
  item.Cells = vtkSmartPointer<vtkPolyData>::New();
  item.Cells->DeepCopy(item.Mesh);
  for (vtkCellArray* cells : { item.Cells->GetPolys(), item.Cells->GetStrips() })
  {
    if (cells->GetNumberOfCells() > 1) // all but the first cell
    {
      vtkNew<vtkCellArray> fewer;
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      for (vtkIdType i = 1; i < cells->GetNumberOfCells(); ++i)
      {
        cells->GetCellAtId(i, size, ids);
        fewer->InsertNextCell(size, ids);
      }
      cells->DeepCopy(fewer);
    }
  }
  for (vtkCellArray* cells : { item.Mesh->GetPolys(), item.Mesh->GetStrips() })
  {
    if (cells->GetNumberOfCells() > 0) // else it is VTK's own, which all meshes share
    {
      cells->Modified();
    }
  }
}

void SetCellOpacities(vtkPolyData* mesh, Random& random)
{
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    const int alpha = random.Index(4);
    colours->InsertNextTuple4(200, random.Index(256), 90, alpha == 3 ? 255 : 80 * alpha);
  }
  mesh->GetCellData()->SetScalars(colours);
}

void SetTable(vtkPolyData* mesh, vtkMapper* mapper)
{
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    values->InsertNextValue(static_cast<float>(i % 5));
  }
  mesh->GetCellData()->SetScalars(values);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(5);
  table->SetTableRange(0.0, 4.0);
  table->Build();
  table->SetTableValue(1, 0.2, 0.9, 0.1, 0.3);
  mapper->SetLookupTable(table);
  mapper->UseLookupTableScalarRangeOn();
}

vtkSmartPointer<vtkTexture> MakePattern(Random& random)
{
  const int components = 3 + random.Index(2);
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < components * 64; ++i)
  {
    texel[i] = static_cast<unsigned char>(random.Index(256));
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

void SetShading(vtkProperty* property, Random& random)
{
  const double green = random.Uniform(0.0, 1.0);
  const double red = random.Index(6) ? 0.9 : 0.0;
  property->SetColor(red, green, random.Uniform(0.0, 1.0));
  property->SetInterpolation(random.Index(2));
  if (random.Index(6) == 0)
  {
    property->SetAmbient(0.2);
    property->SetSpecular(0.5);
    property->SetSpecularPower(random.Index(2) ? 1.0 : 30.0);
  }
}

void SetKind(FrameItem& item, Random& random)
{
  vtkActor* actor = item.Actors[0];
  vtkProperty* property = actor->GetProperty();
  switch (item.Kind)
  {
    case FRAME_TRANSLUCENT:
      property->SetOpacity(random.Index(6) ? random.Uniform(0.05, 0.95) : random.Index(2));
      break;
    case FRAME_GLASS:
    {
      vtkNew<vtkInformation> keys;
      const double red = random.Index(3) / 2.0;
      const double green = random.Uniform(0.0, 1.0);
      keys->Set(vtkAirlightPass::SHADOW_OPACITY(), red, green, random.Uniform(0.0, 1.0));
      actor->SetPropertyKeys(keys);
      property->SetOpacity(random.Index(2) ? 1.0 : 0.5);
      break;
    }
    case FRAME_CELL_OPACITY:
      SetCellOpacities(item.Mesh, random);
      actor->GetMapper()->ScalarVisibilityOn();
      break;
    case FRAME_TABLE_OPACITY:
      SetTable(item.Mesh, actor->GetMapper());
      actor->GetMapper()->ScalarVisibilityOn();
      break;
    case FRAME_WIREFRAME:
      property->SetRepresentationToWireframe();
      property->SetLineWidth(1.0f + static_cast<float>(random.Index(3)));
      break;
    case FRAME_POINTS:
      property->SetRepresentationToPoints();
      property->SetPointSize(1.0f + static_cast<float>(random.Index(5)));
      property->SetRenderPointsAsSpheres(random.Index(3) == 0);
      break;
    case FRAME_EDGES:
      property->EdgeVisibilityOn();
      property->SetVertexVisibility(random.Index(2));
      break;
    case FRAME_CLIPPED:
      item.Clip = vtkSmartPointer<vtkPlane>::New();
      item.Clip->SetNormal(-0.3, random.Uniform(-1.0, 1.0), -1.0);
      actor->GetMapper()->AddClippingPlane(item.Clip);
      break;
    case FRAME_CULLED:
      property->SetFrontfaceCulling(random.Index(2));
      property->SetBackfaceCulling(random.Index(2));
      break;
    case FRAME_BACKFACE:
    {
      vtkNew<vtkProperty> back;
      back->SetColor(0.1, 0.8, 0.3);
      actor->SetBackfaceProperty(back);
      break;
    }
    case FRAME_TEXTURED:
      actor->SetTexture(MakePattern(random));
      break;
    case FRAME_UNLIT:
      property->LightingOff();
      break;
    default:
      break;
  }
}
}

//------------------------------------------------------------------------------
FrameItem MakeFrameItem(int kind, Random& random, vtkCamera* camera)
{
  FrameItem item;
  item.Kind = kind;
  const bool textured = kind == FRAME_TEXTURED; // planes have coordinates
  const int mesh = kind < FRAME_MESH_KINDS ? kind
    : textured                             ? FRAME_PLANE
                                           : random.Index(FRAME_GROUND);
  item.Mesh = MakeFrameMesh(mesh, random);
  MakeOlder(item, random);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(item.Mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  SetShading(actor->GetProperty(), random);
  item.Actors.emplace_back(actor);
  item.Prop = actor;
  SetKind(item, random);
  MakeFrameProp(item, random, camera);
  return item;
}
}
