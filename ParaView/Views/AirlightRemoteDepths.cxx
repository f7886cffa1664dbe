// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightRemoteDepths.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <vector>

namespace airlight
{
//------------------------------------------------------------------------------
void RemoteDepths::Begin(
  vtkMultiProcessController* controller, bool possible, const std::array<int, 2>& size)
{
  this->Controller = nullptr;
  this->Chosen = false;
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
bool RemoteDepths::Choose(int width, int height, const float* depths, unsigned char* drawn)
{
  if (!this->Controller || width != this->Width || height != this->Height)
  {
    return false;
  }
  const int count = width * height;
  std::vector<float> nearest(count);
  this->Controller->AllReduce(depths, nearest.data(), count, vtkCommunicator::MIN_OP);
  const bool isFirst = this->Controller->GetLocalProcessId() == 0;
  for (int i = 0; i < count; ++i)
  {
    drawn[i] = depths[i] <= nearest[i] && (depths[i] < 1.0f || isFirst) ? 1 : 0;
  }
  this->LeftOut = std::count(drawn, drawn + count, 0);
  this->Controller = nullptr;
  this->Chosen = true;
  return true;
}

//------------------------------------------------------------------------------
// A rank that draws all its pixels hides nothing of the others.
void RemoteDepths::End()
{
  if (!this->Controller)
  {
    return;
  }
  const int count = this->Width * this->Height;
  const std::vector<float> none(count, 2.0f);
  std::vector<float> nearest(count);
  this->Controller->AllReduce(none.data(), nearest.data(), count, vtkCommunicator::MIN_OP);
  this->Controller = nullptr;
}
}
