// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightRemoteSilhouettes.h"

#include "vtkActor.h"
#include "vtkAirlightPass.h"
#include "vtkCamera.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>

namespace
{
// Draws nothing, in a box of any size.
class AirlightEverywhere : public vtkActor
{
public:
  static AirlightEverywhere* New();
  vtkTypeMacro(AirlightEverywhere, vtkActor);

  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  vtkTypeBool HasOpaqueGeometry() override { return 0; }

  double* GetBounds() override { return this->Box; }
  void SetBox(const double box[6]) { std::copy(box, box + 6, this->Box); }

private:
  AirlightEverywhere() = default;
  ~AirlightEverywhere() override = default;

  double Box[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
};

vtkStandardNewMacro(AirlightEverywhere);
}

namespace airlight
{
//------------------------------------------------------------------------------
RemoteSilhouettes::RemoteSilhouettes()
  : Everywhere(vtkSmartPointer<AirlightEverywhere>::New())
{
}

RemoteSilhouettes::~RemoteSilhouettes() = default;

//------------------------------------------------------------------------------
void RemoteSilhouettes::Update(
  vtkRenderer* renderer, vtkAirlightPass* pass, vtkMultiProcessController* controller)
{
  // A rank without any has no bytes, and the pass has said why.
  vtkNew<vtkUnsignedCharArray> own;
  pass->GetSilhouettes(renderer, own);
  const unsigned char* first = own->GetPointer(0);
  const vtkIdType length = own->GetNumberOfValues();
  const bool same = !this->Received.empty() && this->Own.size() == static_cast<size_t>(length) &&
    std::equal(this->Own.begin(), this->Own.end(), first);
  const int changed = same ? 0 : 1;
  int any = 0;
  controller->AllReduce(&changed, &any, 1, vtkCommunicator::MAX_OP);
  if (!any)
  {
    return;
  }
  this->Own.assign(first, first + length);

  const int ranks = controller->GetNumberOfProcesses();
  std::vector<vtkIdType> lengths(ranks);
  std::vector<vtkIdType> offsets(ranks, 0);
  controller->AllGather(&length, lengths.data(), 1);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  this->Received.resize(offsets.back() + lengths.back());
  controller->AllGatherV(
    this->Own.data(), this->Received.data(), length, lengths.data(), offsets.data());

  pass->RemoveAllRemoteSilhouettes();
  for (int rank = 0; rank < ranks; ++rank)
  {
    if (rank != controller->GetLocalProcessId() && lengths[rank] > 0)
    {
      vtkNew<vtkUnsignedCharArray> remote;
      remote->SetArray(this->Received.data() + offsets[rank], lengths[rank], 1);
      pass->AddRemoteSilhouettes(remote);
    }
  }
}

//------------------------------------------------------------------------------
void RemoteSilhouettes::Spread(vtkRenderer* renderer, bool on)
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
  static_cast<AirlightEverywhere*>(this->Everywhere.Get())->SetBox(box);
  renderer->AddViewProp(this->Everywhere);
}

//------------------------------------------------------------------------------
void RemoteSilhouettes::Clear(vtkAirlightPass* pass)
{
  pass->RemoveAllRemoteSilhouettes();
  this->Own.clear();
  this->Received.clear();
}
}
