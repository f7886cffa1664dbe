// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Contents of other props and mappers. The item has a mesh and an actor that shows it, which most
// use.

#include "FrameParts.h"

#include "RandomParts.h"

#include "Scene/AirlightVTKVersions.h"
#include "vtkAppendFilter.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataSetMapper.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLODActor.h"
#include "vtkLODProp3D.h"
#include "vtkLineSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkUnstructuredGrid.h"

namespace airlight_test
{
namespace
{
vtkSmartPointer<vtkActor> MakeActor(vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> MakeOther(Random& random)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeFrameMesh(FRAME_CONE, random));
  vtkSmartPointer<vtkActor> actor = MakeActor(mapper);
  const glm::dvec3 place = RandomPoint(random, 1.0);
  actor->SetPosition(place.x, place.y, place.z);
  return actor;
}

// Its parts are in the item's list, so that they change, too.
template <typename Assembly>
void Assemble(FrameItem& item, Random& random)
{
  vtkNew<Assembly> assembly;
  item.Actors.emplace_back(MakeOther(random));
  item.Actors.back()->GetProperty()->SetOpacity(random.Index(3) ? 1.0 : 0.5);
  for (vtkActor* part : item.Actors)
  {
    assembly->AddPart(part);
  }
  item.Prop = assembly;
}

void MakeLodProp(FrameItem& item, Random& random)
{
  vtkNew<vtkLODProp3D> prop;
  vtkMapper* mapper = item.Actors[0]->GetMapper();
  const int first = prop->AddLOD(mapper, item.Actors[0]->GetProperty(), 0.0);
  vtkNew<vtkPolyDataMapper> coarse;
  coarse->SetInputData(MakeFrameMesh(FRAME_CONE, random));
  const int second = prop->AddLOD(coarse, 0.0);
  // Levels must not follow from the time that frames take.
  prop->AutomaticLODSelectionOff();
  prop->SetSelectedLODID(random.Index(2) ? first : second);
  item.Actors.clear();
  item.Prop = prop;
}

void MakeLodActor(FrameItem& item)
{
  vtkNew<vtkLODActor> actor;
  actor->SetMapper(item.Actors[0]->GetMapper());
  actor->GetProperty()->DeepCopy(item.Actors[0]->GetProperty());
  actor->SetNumberOfCloudPoints(20);
  item.Actors[0] = actor;
  item.Prop = actor;
}

void MakeFollower(FrameItem& item, vtkCamera* camera)
{
  vtkNew<vtkFollower> follower;
  follower->SetMapper(item.Actors[0]->GetMapper());
  follower->SetCamera(camera);
  item.Actors[0] = follower;
  item.Prop = follower;
}

void UseMapper(FrameItem& item, vtkMapper* mapper)
{
  mapper->ScalarVisibilityOff();
  item.Actors[0]->SetMapper(mapper);
}

void MakeGlyphs(FrameItem& item, Random& random)
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(item.Mesh);
  mapper->SetSourceData(MakeFrameMesh(random.Index(2) ? FRAME_CONE : FRAME_SPHERE, random));
  mapper->SetScaleFactor(random.Uniform(0.05, 0.4));
  mapper->OrientOff();
  UseMapper(item, mapper);
}

void MakeGaussians(FrameItem& item, Random& random)
{
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(item.Mesh);
  mapper->SetScaleFactor(random.Uniform(0.05, 0.3));
  // Not both: VTK's emissive splats of an opacity below 1 take light away.
  const int look = random.Index(3);
  mapper->SetEmissive(look == 1);
  item.Actors[0]->GetProperty()->SetOpacity(look == 2 ? 0.6 : 1.0);
  UseMapper(item, mapper);
}

void MakeLines(FrameItem& item, Random& random)
{
  vtkNew<vtkLineSource> line;
  const glm::dvec3 from = RandomPoint(random, 1.0);
  const glm::dvec3 to = RandomPoint(random, 1.0);
  line->SetPoint1(from.x, from.y, from.z);
  line->SetPoint2(to.x, to.y, to.z);
  line->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(line->GetOutput());
  item.Actors[0]->GetProperty()->SetLineWidth(1.0f + static_cast<float>(random.Index(4)));
  item.Actors[0]->GetProperty()->SetRenderLinesAsTubes(random.Index(3) == 0);
  UseMapper(item, mapper);
}

void MakeComposite(FrameItem& item, Random& random)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, item.Mesh);
  vtkNew<vtkPolyData> empty;
  blocks->SetBlock(1, empty);
  blocks->SetBlock(2, MakeFrameMesh(FRAME_CONE, random));
  vtkNew<airlight::BlocksMapper> mapper;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetInputDataObject(blocks);
  if (random.Index(2))
  {
    attributes->SetBlockOpacity(blocks->GetBlock(2), random.Uniform(0.2, 0.8));
  }
  attributes->SetBlockVisibility(blocks->GetBlock(0), random.Index(3) != 0);
  UseMapper(item, mapper);
}

void MakeGrid(FrameItem& item)
{
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(item.Mesh);
  append->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->DeepCopy(append->GetOutput());
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(grid);
  item.Mesh = nullptr;
  UseMapper(item, mapper);
}

void MakeNothing(FrameItem& item, Random& random)
{
  switch (random.Index(3))
  {
    case 0:
      item.Actors[0]->SetMapper(nullptr);
      item.Mesh = nullptr;
      break;
    case 1:
      item.Mesh->Initialize();
      item.Mesh = nullptr;
      break;
    default:
      item.Mesh->SetPolys(nullptr);
      item.Mesh->SetStrips(nullptr);
      item.Mesh->SetVerts(nullptr);
      item.Mesh->SetLines(nullptr);
  }
}
}

//------------------------------------------------------------------------------
void MakeFrameProp(FrameItem& item, Random& random, vtkCamera* camera)
{
  switch (item.Kind)
  {
    case FRAME_ASSEMBLY:
      Assemble<vtkAssembly>(item, random);
      break;
    case FRAME_PROP_ASSEMBLY:
      Assemble<vtkPropAssembly>(item, random);
      break;
    case FRAME_FOLLOWER:
      MakeFollower(item, camera);
      break;
    case FRAME_LOD_ACTOR:
      MakeLodActor(item);
      break;
    case FRAME_LOD_PROP:
      MakeLodProp(item, random);
      break;
    case FRAME_GLYPHS:
      MakeGlyphs(item, random);
      break;
    case FRAME_GAUSSIANS:
      MakeGaussians(item, random);
      break;
    case FRAME_LINES:
      MakeLines(item, random);
      break;
    case FRAME_COMPOSITE:
      MakeComposite(item, random);
      break;
    case FRAME_GRID:
      MakeGrid(item);
      break;
    case FRAME_NOTHING:
      MakeNothing(item, random);
      break;
    default:
      MakeFrameScenery(item, random, camera);
  }
}
}
