// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightRemoteCasters.h"

#include "AirlightCasterNumbers.h"
#include "vtkActor.h"
#include "vtkAirlightPass.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
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

#include <algorithm>
#include <numeric>

namespace
{
//------------------------------------------------------------------------------
// Casts, but draws nothing. Without a mapper it casts nothing either, and is everywhere.
class AirlightStandIn : public vtkActor
{
public:
  static AirlightStandIn* New();
  vtkTypeMacro(AirlightStandIn, vtkActor);

  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  vtkTypeBool HasOpaqueGeometry() override { return this->Mapper ? 1 : 0; }

  double* GetBounds() override { return this->Mapper ? this->Superclass::GetBounds() : this->Box; }
  void SetBox(const double box[6]) { std::copy(box, box + 6, this->Box); }

private:
  AirlightStandIn() = default;
  ~AirlightStandIn() override = default;

  double Box[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
};

vtkStandardNewMacro(AirlightStandIn);

//------------------------------------------------------------------------------
// Opaque actors alone: ParaView sorts translucent ones by ranks, without depth.
bool Casts(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || actor->IsA("AirlightStandIn") || !actor->GetVisibility() || !actor->GetMapper() ||
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
// All ranks' values on all ranks; those of rank k from offsets[k] on, the last one is their number.
template <typename T>
std::vector<T> Gather(
  vtkMultiProcessController* controller, const std::vector<T>& own, std::vector<vtkIdType>& offsets)
{
  const int ranks = controller->GetNumberOfProcesses();
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(ranks);
  controller->AllGather(&length, lengths.data(), 1);
  offsets.assign(ranks + 1, 0);
  std::partial_sum(lengths.begin(), lengths.end(), offsets.begin() + 1);
  std::vector<T> all(offsets.back());
  controller->AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data());
  return all;
}
}

namespace airlight
{
//------------------------------------------------------------------------------
RemoteCasters::RemoteCasters()
  : Everywhere(vtkSmartPointer<AirlightStandIn>::New())
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
  const int ranks = controller->GetNumberOfProcesses();
  const int own = this->HasChanged(renderer) ? 1 : 0;
  std::vector<int> changed(ranks);
  controller->AllGather(&own, changed.data(), 1);
  this->StandIns.resize(ranks);
  this->Polygons.resize(ranks);
  if (std::count(changed.begin(), changed.end(), 0) == ranks)
  {
    return;
  }
  this->Sent = true;
  CasterNumbers mesh;
  if (own)
  {
    ForEachMesh(
      renderer, [&mesh](vtkActor* actor, vtkPolyData* data) { AppendCaster(actor, data, mesh); });
  }
  std::vector<vtkIdType> pointOffsets;
  std::vector<vtkIdType> polygonOffsets;
  const std::vector<double> points = Gather(controller, mesh.Points, pointOffsets);
  const std::vector<int> polygons = Gather(controller, mesh.Polygons, polygonOffsets);
  this->Bytes =
    static_cast<vtkTypeInt64>(points.size() * sizeof(double) + polygons.size() * sizeof(int));
  for (int rank = 0; rank < ranks; ++rank)
  {
    if (changed[rank])
    {
      const auto data = MakePolyData(points.data() + pointOffsets[rank],
        (pointOffsets[rank + 1] - pointOffsets[rank]) / 3, polygons.data() + polygonOffsets[rank],
        polygonOffsets[rank + 1] - polygonOffsets[rank]);
      this->Polygons[rank] = data->GetNumberOfPolys();
      this->Replace(renderer, rank, rank == controller->GetLocalProcessId() ? nullptr : data.Get());
    }
  }
}

//------------------------------------------------------------------------------
void RemoteCasters::Replace(vtkRenderer* renderer, int rank, vtkPolyData* data)
{
  renderer->RemoveViewProp(this->StandIns[rank]);
  this->StandIns[rank] = nullptr;
  if (data && data->GetNumberOfPolys() > 0)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    this->StandIns[rank] = vtkSmartPointer<AirlightStandIn>::New();
    this->StandIns[rank]->SetMapper(mapper);
    this->StandIns[rank]->UseBoundsOff();
    renderer->AddViewProp(this->StandIns[rank]);
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 RemoteCasters::GetPolygons() const
{
  return std::accumulate(this->Polygons.begin(), this->Polygons.end(), vtkTypeInt64(0));
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
  static_cast<AirlightStandIn*>(this->Everywhere.Get())->SetBox(box);
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
  this->Polygons.clear();
  this->Bytes = 0;
  this->Known.clear();
  this->Sent = false;
}
}
