// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightMediumSource.h"

#include "AirlightMediumData.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataObjectTypes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMPIMoveData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace airlight
{
namespace
{
//------------------------------------------------------------------------------
// This rank's part, at a time.
vtkDataObject* UpdatePort(vtkAlgorithmOutput* connection, double time)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int port = connection->GetIndex();
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(port + 1);
  vtkInformation* request = requests->GetInformationObject(port);
  request->Set(Pipeline::UPDATE_PIECE_NUMBER(), controller ? controller->GetLocalProcessId() : 0);
  request->Set(
    Pipeline::UPDATE_NUMBER_OF_PIECES(), controller ? controller->GetNumberOfProcesses() : 1);
  request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  request->Set(Pipeline::UPDATE_TIME_STEP(), time);
  vtkAlgorithm* producer = connection->GetProducer();
  producer->Update(port, requests);
  return producer->GetOutputDataObject(port);
}
}

//------------------------------------------------------------------------------
MediumSource::MediumSource(int type)
  : Data(vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(type)))
{
}

MediumSource::~MediumSource() = default;

//------------------------------------------------------------------------------
void MediumSource::SetConnection(vtkAlgorithmOutput* connection)
{
  if (this->Connection != connection)
  {
    this->Connection = connection;
    this->Dirty = true;
  }
}

//------------------------------------------------------------------------------
void MediumSource::SetArray(std::string& array, const char* name)
{
  const std::string given = name ? name : "";
  this->Dirty = this->Dirty || array != given;
  array = given;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 MediumSource::Update(double time)
{
  if (!this->Connection)
  {
    return this->Dirty ? REMOVED : UNCHANGED;
  }
  vtkDataObject* data = UpdatePort(this->Connection, time);
  const vtkMTimeType changed = data ? data->GetMTime() : 0;
  const bool isSame = !this->Dirty && this->Time == changed;
  this->Time = changed;
  return isSame ? UNCHANGED : CHANGED;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> MediumSource::MakePiece() const
{
  vtkDataObject* data = nullptr;
  if (this->Connection)
  {
    data = this->Connection->GetProducer()->GetOutputDataObject(this->Connection->GetIndex());
  }
  if (this->GetSurface())
  {
    return MakeMediumSurface(data);
  }
  return MakeMediumImage(data, this->Arrays);
}

//------------------------------------------------------------------------------
void MediumSource::Deliver(vtkTypeUInt64 state)
{
  this->Dirty = false;
  this->Data->Initialize();
  if (state == CHANGED)
  {
    vtkNew<vtkMPIMoveData> mover;
    mover->InitializeForCommunicationForParaView();
    mover->SetOutputDataType(this->Data->GetDataObjectType());
    mover->SetMoveModeToClone();
    mover->SetInputData(this->MakePiece());
    mover->Update();
    if (mover->GetOutputGeneratedOnProcess())
    {
      this->Data->ShallowCopy(mover->GetOutputDataObject(0));
    }
  }
  this->Data->Modified();
}

//------------------------------------------------------------------------------
vtkPolyData* MediumSource::GetSurface() const { return vtkPolyData::SafeDownCast(this->Data); }

//------------------------------------------------------------------------------
vtkImageData* MediumSource::GetImage() const { return vtkImageData::SafeDownCast(this->Data); }
}
