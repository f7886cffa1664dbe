// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightDataGathering.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMPIMoveData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkProcessModule.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace airlight
{
namespace
{
bool IsMesh(vtkDataObject* data)
{
  return vtkPolyData::SafeDownCast(data) || vtkUnstructuredGrid::SafeDownCast(data);
}

bool AreAllMeshes(vtkCompositeDataSet* data)
{
  const auto leaf = vtk::TakeSmartPointer(data->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    if (!IsMesh(leaf->GetCurrentDataObject()))
    {
      return false;
    }
  }
  return true;
}

bool CanMergePiece(vtkDataObject* piece)
{
  if (auto* image = vtkImageData::SafeDownCast(piece))
  {
    return image->GetDirectionMatrix()->IsIdentity();
  }
  const bool collects = vtkMultiBlockDataSet::SafeDownCast(piece) ||
    vtkPartitionedDataSetCollection::SafeDownCast(piece);
  return !piece || IsMesh(piece) ||
    (collects && AreAllMeshes(vtkCompositeDataSet::SafeDownCast(piece)));
}
}

//------------------------------------------------------------------------------
bool DataGathering::IsOneOfSeveral()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 &&
    vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_DATA_SERVER;
}

//------------------------------------------------------------------------------
bool DataGathering::OnlyDraws()
{
  return vtkProcessModule::GetProcessType() == vtkProcessModule::PROCESS_RENDER_SERVER;
}

//------------------------------------------------------------------------------
// A client has no data of its own.
bool DataGathering::CanMerge(vtkPVRenderView* view)
{
  auto* delivery = vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  const bool isClient = vtkProcessModule::GetProcessType() == vtkProcessModule::PROCESS_CLIENT;
  for (int i = 0; delivery && !isClient && i < view->GetNumberOfRepresentations(); ++i)
  {
    auto* shown = vtkPVDataRepresentation::SafeDownCast(view->GetRepresentation(i));
    const int ports = shown && shown->GetVisibility() ? delivery->GetNumberOfPorts(shown) : 0;
    for (int port = 0; port < ports; ++port)
    {
      if (!CanMergePiece(delivery->GetPiece(shown, false, port)))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// A server that only draws gets nothing of what is collected.
void DataGathering::Begin(vtkPVRenderView* view, bool toRenderServer)
{
  vtkNew<vtkInformation> request;
  request->Set(vtkPVView::VIEW(), view);
  vtkPVRenderView::SetForceDataDistributionMode(
    request, toRenderServer ? vtkMPIMoveData::CLONE : vtkMPIMoveData::COLLECT);
  // What ParaView last redistributed is not asked for any more.
  auto* delivery = vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  if (delivery)
  {
    delivery->SetUseRedistributedDataAsDeliveredData(false);
  }
}
}
