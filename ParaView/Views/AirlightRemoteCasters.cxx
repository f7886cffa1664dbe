// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightRemoteCasters.h"

#include "vtkActor.h"
#include "vtkAirlightPass.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTriangleStrip.h"

#include <algorithm>
#include <numeric>

namespace
{
//------------------------------------------------------------------------------
// Casts, but draws nothing. Without a mapper it casts nothing either, and is everywhere.
class StandIn : public vtkActor
{
public:
  static StandIn* New();
  vtkTypeMacro(StandIn, vtkActor);

  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  vtkTypeBool HasOpaqueGeometry() override { return this->Mapper ? 1 : 0; }

  double* GetBounds() override { return this->Mapper ? this->Superclass::GetBounds() : this->Box; }
  void SetBox(const double box[6]) { std::copy(box, box + 6, this->Box); }

private:
  StandIn() = default;
  ~StandIn() override = default;

  double Box[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
};

vtkStandardNewMacro(StandIn);

//------------------------------------------------------------------------------
// Opaque actors alone: ParaView sorts translucent ones by ranks, without depth.
bool Casts(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || actor->IsA("StandIn") || !actor->GetVisibility() || !actor->GetMapper() ||
    actor->GetMapper()->GetNumberOfInputConnections(0) == 0 ||
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE || !actor->HasOpaqueGeometry())
  {
    return false;
  }
  vtkInformation* keys = actor->GetPropertyKeys();
  return !(keys && keys->Has(vtkAirlightPass::CASTS_SHADOW()) &&
    keys->Get(vtkAirlightPass::CASTS_SHADOW()) == 0);
}

//------------------------------------------------------------------------------
template <typename Action>
void ForEachMesh(vtkRenderer* renderer, const Action& action)
{
  vtkCollectionSimpleIterator it = nullptr;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (!Casts(prop))
    {
      continue;
    }
    auto* actor = static_cast<vtkActor*>(prop);
    actor->GetMapper()->Update();
    vtkDataObject* input = actor->GetMapper()->GetInputDataObject(0, 0);
    if (auto* data = vtkPolyData::SafeDownCast(input))
    {
      action(actor, data);
    }
    else if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
    {
      vtkSmartPointer<vtkCompositeDataIterator> block;
      block.TakeReference(composite->NewIterator());
      for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
      {
        if (auto* data = vtkPolyData::SafeDownCast(block->GetCurrentDataObject()))
        {
          action(actor, data);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// In world coordinates, which single precision need not hold.
void Append(vtkActor* actor, vtkPolyData* data, vtkPoints* points, vtkCellArray* triangles)
{
  if (data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0)
  {
    return;
  }
  const vtkIdType first = points->GetNumberOfPoints();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    data->GetPoint(i, point);
    actor->GetMatrix()->MultiplyPoint(point, point);
    points->InsertNextPoint(point);
  }
  vtkNew<vtkCellArray> polygons;
  auto strip = vtk::TakeSmartPointer(data->GetStrips()->NewIterator());
  for (strip->GoToFirstCell(); !strip->IsDoneWithTraversal(); strip->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    strip->GetCurrentCell(count, ids);
    vtkTriangleStrip::DecomposeStrip(static_cast<int>(count), ids, polygons);
  }
  polygons->Append(data->GetPolys());
  triangles->Append(polygons, first);
}
}

namespace airlight
{
//------------------------------------------------------------------------------
RemoteCasters::RemoteCasters()
  : Everywhere(vtkSmartPointer<StandIn>::New())
{
}

RemoteCasters::~RemoteCasters() = default;

//------------------------------------------------------------------------------
bool RemoteCasters::HasChanged(vtkRenderer* renderer)
{
  std::vector<vtkTypeUInt64> now;
  ForEachMesh(renderer, [&now](vtkActor* actor, vtkPolyData* data) {
    now.insert(now.end(),
      { reinterpret_cast<vtkTypeUInt64>(actor), actor->GetMatrix()->GetMTime(),
        reinterpret_cast<vtkTypeUInt64>(data),
        std::max({ data->GetPoints() ? data->GetPoints()->GetMTime() : 0,
          data->GetPolys()->GetMTime(), data->GetStrips()->GetMTime() }) });
  });
  const bool changed = now != this->Known || !this->Sent;
  this->Known = std::move(now);
  return changed;
}

//------------------------------------------------------------------------------
void RemoteCasters::Update(vtkRenderer* renderer, vtkMultiProcessController* controller)
{
  const int own = this->HasChanged(renderer) ? 1 : 0;
  int any = 0;
  controller->AllReduce(&own, &any, 1, vtkCommunicator::MAX_OP);
  if (!any)
  {
    return;
  }
  this->Sent = true;

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  ForEachMesh(
    renderer, [&](vtkActor* actor, vtkPolyData* data) { Append(actor, data, points, triangles); });
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  vtkNew<vtkCharArray> sent;
  vtkCommunicator::MarshalDataObject(mesh, sent);

  const int ranks = controller->GetNumberOfProcesses();
  const vtkIdType length = sent->GetNumberOfValues();
  std::vector<vtkIdType> lengths(ranks);
  std::vector<vtkIdType> offsets(ranks, 0);
  controller->AllGather(&length, lengths.data(), 1);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  this->Bytes = offsets.back() + lengths.back();
  std::vector<char> received(this->Bytes);
  controller->AllGatherV(
    sent->GetPointer(0), received.data(), length, lengths.data(), offsets.data());

  for (vtkActor* actor : this->StandIns)
  {
    renderer->RemoveViewProp(actor);
  }
  this->StandIns.clear();
  this->Triangles = 0;
  for (int rank = 0; rank < ranks; ++rank)
  {
    vtkNew<vtkCharArray> buffer;
    buffer->SetArray(received.data() + offsets[rank], lengths[rank], 1);
    const auto object = vtkCommunicator::UnMarshalDataObject(buffer);
    auto* data = vtkPolyData::SafeDownCast(object);
    this->Triangles += data ? data->GetNumberOfPolys() : 0;
    if (rank == controller->GetLocalProcessId() || !data || data->GetNumberOfPolys() == 0)
    {
      continue;
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<StandIn>::New();
    actor->SetMapper(mapper);
    actor->UseBoundsOff();
    renderer->AddViewProp(actor);
    this->StandIns.emplace_back(actor);
  }
}

//------------------------------------------------------------------------------
void RemoteCasters::Spread(vtkRenderer* renderer, bool on)
{
  if (!on)
  {
    renderer->RemoveViewProp(this->Everywhere);
    return;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  const double size = 2.0 * camera->GetClippingRange()[1];
  double box[6];
  for (int i = 0; i < 6; ++i)
  {
    box[i] = camera->GetPosition()[i / 2] + (i % 2 ? size : -size);
  }
  static_cast<StandIn*>(this->Everywhere.Get())->SetBox(box);
  renderer->AddViewProp(this->Everywhere);
}

//------------------------------------------------------------------------------
void RemoteCasters::Clear(vtkRenderer* renderer)
{
  for (vtkActor* actor : this->StandIns)
  {
    renderer->RemoveViewProp(actor);
  }
  this->StandIns.clear();
  this->Known.clear();
  this->Sent = false;
}
}
