// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightRemoteDepths.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <cstddef>

namespace airlight
{
//------------------------------------------------------------------------------
void RemoteDepths::Begin(
  vtkMultiProcessController* controller, bool possible, const std::array<int, 2>& size)
{
  this->Controller = nullptr;
  this->BackgroundLeft = false;
  this->LeftOut = 0;
  if (!possible)
  {
    return;
  }
  const int own[4] = { size[0], -size[0], size[1], -size[1] };
  int least[4];
  controller->AllReduce(own, least, 4, vtkCommunicator::MIN_OP);
  if (least[0] == -least[1] && least[2] == -least[3] && size[0] > 0 && size[1] > 0)
  {
    this->Controller = controller;
    this->Width = size[0];
    this->Height = size[1];
  }
}

//------------------------------------------------------------------------------
// Of all ranks: the exchange of a frame.
std::vector<float> RemoteDepths::FindNearest(const float* depths)
{
  std::vector<float> nearest(static_cast<size_t>(this->Width) * this->Height);
  this->Controller->AllReduce(
    depths, nearest.data(), static_cast<vtkIdType>(nearest.size()), vtkCommunicator::MIN_OP);
  this->Controller = nullptr;
  return nearest;
}

//------------------------------------------------------------------------------
bool RemoteDepths::Choose(int width, int height, const float* depths, unsigned char* drawn)
{
  if (!this->Controller || width != this->Width || height != this->Height)
  {
    return false;
  }
  this->BackgroundLeft = this->Controller->GetLocalProcessId() != 0;
  const std::vector<float> nearest = this->FindNearest(depths);
  for (size_t i = 0; i < nearest.size(); ++i)
  {
    const bool isLeft = depths[i] > nearest[i] || (depths[i] >= 1.0f && this->BackgroundLeft);
    drawn[i] = isLeft ? 0 : 1;
  }
  this->LeftOut = std::count(drawn, drawn + nearest.size(), 0);
  return true;
}

//------------------------------------------------------------------------------
// A rank that draws all its pixels hides nothing of the others.
void RemoteDepths::End()
{
  if (this->Controller)
  {
    const std::vector<float> none(static_cast<size_t>(this->Width) * this->Height, 2.0f);
    this->FindNearest(none.data());
  }
}
}
