// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightReference.h"

#include "Medium/AirlightMediaList.h"
#include "Medium/AirlightMediaMethods.h"
#include "Reference/AirlightPathPicture.h"
#include "Reference/AirlightReferencePicture.h"
#include "Reference/AirlightReferenceTracer.h"
#include "Scene/AirlightCasterKeys.h"
#include "Scene/AirlightVTKVersions.h"
#include "Scene/AirlightVolumeMedia.h"
#include "vtkAirlightLight.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkParticipatingMedium.h"
#include "vtkPhaseFunction.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolume.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cmath>

using namespace airlight;

namespace
{
constexpr int MostPixels = 32768; // along a side

constexpr double SingleShare = 0.1; // of the progress, of light that is scattered once
}

// What it was given.
class vtkAirlightReference::Internals
{
public:
  MediaList Media;
  VolumeMedia Volumes;
  vtkNew<vtkParticipatingMedium> Vacuum;
  bool WarnedCameraLights = false;
  vtkSmartPointer<vtkRenderer> Renderer;
};

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
void vtkAirlightReference::SetScatteringOrders(int orders)
{
  if (orders < 0)
  {
    vtkErrorMacro(<< "ScatteringOrders " << orders << " must be 1 for single scattering, more, or "
                  << "0 for all orders; it stays " << this->ScatteringOrders << ".");
    return;
  }
  if (this->ScatteringOrders != orders)
  {
    this->ScatteringOrders = orders;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightReference::SetSamplesPerPixel(int samples)
{
  if (samples < 2)
  {
    vtkErrorMacro(<< "SamplesPerPixel " << samples << " must be at least 2, as one path has no "
                  << "standard error; it stays " << this->SamplesPerPixel << ".");
    return;
  }
  if (this->SamplesPerPixel != samples)
  {
    this->SamplesPerPixel = samples;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightReference::SetTargetError(double error)
{
  if (!std::isfinite(error) || error < 0.0)
  {
    vtkErrorMacro(<< "TargetError " << error << " must be finite and above 0, such as 0.01, or 0 "
                  << "for none; it stays " << this->TargetError << ".");
    return;
  }
  if (this->TargetError != error)
  {
    this->TargetError = error;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightReference::SetTimeLimit(double seconds)
{
  if (!std::isfinite(seconds) || seconds < 0.0)
  {
    vtkErrorMacro(<< "TimeLimit " << seconds << " must be a finite number of seconds above 0, or 0 "
                  << "for none; it stays " << this->TimeLimit << ".");
    return;
  }
  if (this->TimeLimit != seconds)
  {
    this->TimeLimit = seconds;
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
  vtkAirlightLight::SetScatters(light, scatters);
}

bool vtkAirlightReference::GetLightScatters(vtkLight* light)
{
  return vtkAirlightLight::GetScatters(light);
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
    if (vtkPhaseFunction* function = GetVolumePhaseFunction(prop))
    {
      time = std::max(time, function->GetMTime());
    }
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
  os << indent << "LampPoints: " << this->LampPoints << "\n";
  os << indent << "SurfaceShadows: " << this->SurfaceShadows << "\n";
  os << indent << "TranslucentShadows: " << this->TranslucentShadows << "\n";
  os << indent << "VolumeShadows: " << this->VolumeShadows << "\n";
  os << indent << "ScatteringOrders: " << this->ScatteringOrders << "\n";
  os << indent << "SamplesPerPixel: " << this->SamplesPerPixel << "\n";
  os << indent << "TargetError: " << this->TargetError << "\n";
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "ReachedError: " << this->ReachedError << "\n";
}

//------------------------------------------------------------------------------
// The size to compute. False, with an error, where nobody knows it.
bool vtkAirlightReference::FindSize(int size[2])
{
  std::copy_n(this->Size, 2, size);
  vtkRenderer* renderer = this->Impl->Renderer;
  if (size[0] == 0 && renderer && renderer->GetVTKWindow())
  {
    renderer->GetTiledSize(&size[0], &size[1]);
  }
  if (size[0] < 1 || size[1] < 1)
  {
    vtkErrorMacro("The renderer has no size, as it has no window or a closed one: call SetSize().");
    return false;
  }
  return true;
}

bool vtkAirlightReference::Check()
{
  if (!this->Impl->Renderer)
  {
    vtkErrorMacro("There is no renderer: call SetRenderer().");
    return false;
  }
  const std::string text = this->Impl->Media.Check();
  if (!text.empty())
  {
    vtkErrorMacro(<< text);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkAirlightReference::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  int size[2] = { 0, 0 };
  if (!this->Check() || !this->FindSize(size))
  {
    std::fill_n(size, 2, 0);
  }
  const int extent[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, 0 };
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 3);
  return size[0] > 0 ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkAirlightReference::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  image->Initialize();

  ReferenceSettings settings;
  settings.Width = extent[1] + 1;
  settings.Height = extent[3] + 1;
  settings.LightRadius = this->LightRadius;
  settings.LampPoints = this->LampPoints;
  settings.MultipleScattering = this->ScatteringOrders == 1;
  settings.SurfaceShadows = this->SurfaceShadows;
  settings.TranslucentShadows = this->TranslucentShadows;
  settings.VolumeShadows = this->VolumeShadows;
  std::vector<vtkParticipatingMedium*> media = this->Impl->Media.GetAll();
  for (const VolumeMedium& found : this->Impl->Volumes.Update(this->Impl->Renderer))
  {
    if (found.Medium && media.size() < AIRLIGHT_MAX_MEDIA)
    {
      media.push_back(found.Medium);
    }
    else if (found.Medium)
    {
      vtkWarningMacro(<< "The " << found.Volume->GetClassName() << " (" << found.Volume
                      << ") is left out: there are " << media.size()
                      << " media already. Call RemoveMedium() or SetVolumeScatters(volume, false) "
                         "for others.");
    }
    if (!found.Error.empty())
    {
      vtkWarningMacro(<< found.Error);
    }
  }
  if (media.empty())
  {
    media.push_back(this->Impl->Vacuum);
  }
  const ReferenceTracer tracer(this->Impl->Renderer, media, settings);
  if (!tracer.IsValid())
  {
    vtkErrorMacro("The camera's matrices are not finite or cannot be inverted: give it a position "
                  "apart from its focal point, and angles and a clipping range above 0.");
    return 0;
  }
  const std::string unsupported = tracer.GetScene().GetUnsupported();
  if (!unsupported.empty())
  {
    vtkWarningMacro(<< "Not computed, or not as VTK draws it: " << unsupported << ".");
  }
  for (const std::string& text : tracer.GetScene().GetVolumes().GetErrors())
  {
    vtkWarningMacro(<< text);
  }
  if (tracer.GetLights().HasInvalid())
  {
    vtkWarningMacro(<< InvalidLightText);
  }
  if (tracer.GetScatteredOnce() > 0)
  {
    vtkWarningMacro(<< GetScatteredOnceText(tracer.GetScatteredOnce()));
  }
  const std::string leftOut = tracer.DescribeLeftOut();
  if (!leftOut.empty() && !this->Impl->WarnedCameraLights)
  {
    this->Impl->WarnedCameraLights = true;
    vtkWarningMacro(<< leftOut);
  }

  image->SetExtent(extent);
  image->SetSpacing(1.0, 1.0, 1.0);
  image->SetOrigin(0.0, 0.0, 0.0);
  this->ReachedError = 0.0;
  if (this->ComputeSingle(image, tracer) && this->ScatteringOrders != 1)
  {
    this->AddPaths(image, tracer);
  }
  if (IsAborted(this))
  {
    image->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
// False if it was aborted.
bool vtkAirlightReference::ComputeSingle(vtkImageData* image, const ReferenceTracer& tracer)
{
  const double share = this->ScatteringOrders == 1 ? 1.0 : SingleShare;
  const int height = image->GetDimensions()[1];
  ReferencePicture picture(image);
  // Some rows at a time: progress is for this thread to tell.
  const int step = std::max(1, height / 50);
  for (int row = 0; row < height && !IsAborted(this); row += step)
  {
    const int rows = std::min(step, height - row);
    picture.Trace(tracer, row, rows);
    this->UpdateProgress(share * static_cast<double>(row + rows) / height);
  }
  return !IsAborted(this);
}

//------------------------------------------------------------------------------
void vtkAirlightReference::AddPaths(vtkImageData* image, const ReferenceTracer& tracer)
{
  PathSettings settings;
  settings.Orders = this->ScatteringOrders;
  settings.Samples = this->SamplesPerPixel;
  settings.TargetError = this->TargetError;
  settings.TimeLimit = this->TimeLimit;
  settings.Seed = this->Seed;
  PathPicture picture(image, tracer, settings);
  double most = 0.0;
  picture.Compute([&](double done) {
    most = std::max(most, done); // estimates may fall
    this->UpdateProgress(SingleShare + (1.0 - SingleShare) * most);
    return !IsAborted(this);
  });
  this->ReachedError = picture.GetRelativeError();
  if (!IsAborted(this))
  {
    this->UpdateProgress(1.0);
  }
}
