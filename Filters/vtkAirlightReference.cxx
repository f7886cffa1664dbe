// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightReference.h"

#include "Medium/AirlightMediaMethods.h"
#include "Reference/vtkAirlightReferenceInternals.h"
#include "vtkCamera.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"

#include <algorithm>

namespace
{
constexpr int MostPixels = 32768; // along a side
}

vtkStandardNewMacro(vtkAirlightReference);

//------------------------------------------------------------------------------
vtkAirlightReference::vtkAirlightReference()
  : Impl(new Internals)
{
  this->SetNumberOfInputPorts(0);
}

vtkAirlightReference::~vtkAirlightReference() = default;

//------------------------------------------------------------------------------
void vtkAirlightReference::SetRenderer(vtkRenderer* renderer)
{
  if (this->Impl->Renderer != renderer)
  {
    this->Impl->Renderer = renderer;
    this->Modified();
  }
}

vtkRenderer* vtkAirlightReference::GetRenderer() { return this->Impl->Renderer; }

//------------------------------------------------------------------------------
AirlightMediaMethodsMacro(vtkAirlightReference);

//------------------------------------------------------------------------------
void vtkAirlightReference::SetSize(int width, int height)
{
  const bool own = width == 0 && height == 0;
  if (!own && (width < 1 || height < 1 || width > MostPixels || height > MostPixels))
  {
    vtkErrorMacro(<< "Size " << width << " x " << height << " must be from 1 to " << MostPixels
                  << " each, or 0 x 0 for the renderer's own; it stays " << this->Size[0] << " x "
                  << this->Size[1] << ".");
    return;
  }
  if (this->Size[0] != width || this->Size[1] != height)
  {
    this->Size[0] = width;
    this->Size[1] = height;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightReference::SetLightScatters(vtkLight* light, bool scatters)
{
  if (!light)
  {
    vtkErrorMacro("SetLightScatters() needs a light; it got null.");
    return;
  }
  if (this->Impl->Switches.Set(light, scatters))
  {
    this->Modified();
  }
}

bool vtkAirlightReference::GetLightScatters(vtkLight* light)
{
  return this->Impl->Switches.Scatters(light);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAirlightReference::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkParticipatingMedium* medium : this->Impl->Media.GetAll())
  {
    time = std::max(time, medium->GetMTime());
  }
  vtkRenderer* renderer = this->Impl->Renderer;
  if (!renderer)
  {
    return time;
  }
  time = std::max(time, renderer->GetMTime());
  if (renderer->IsActiveCameraCreated())
  {
    time = std::max(time, renderer->GetActiveCamera()->GetMTime());
  }
  vtkCollectionSimpleIterator it = nullptr;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    time = std::max(time, light->GetMTime());
  }
  renderer->GetViewProps()->InitTraversal(it);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
  {
    time = std::max(time, prop->GetRedrawMTime());
  }
  return std::max(
    { time, renderer->GetLights()->GetMTime(), renderer->GetViewProps()->GetMTime() });
}

//------------------------------------------------------------------------------
void vtkAirlightReference::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Impl->Renderer.Get() << "\n";
  os << indent << "NumberOfMedia: " << this->GetNumberOfMedia() << "\n";
  for (vtkParticipatingMedium* medium : this->Impl->Media.GetAll())
  {
    medium->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n";
  os << indent << "LightRadius: " << this->LightRadius << "\n";
  os << indent << "SurfaceShadows: " << this->SurfaceShadows << "\n";
}
