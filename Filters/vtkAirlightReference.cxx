// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightReference.h"

#include "AirlightMediaList.h"
#include "AirlightReferenceTracer.h"
#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkWeakPointer.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cmath>

using namespace airlight;

namespace
{
constexpr int MostPixels = 32768; // along a side

// The output's arrays.
class Buffers
{
public:
  explicit Buffers(vtkImageData* image)
    : Radiance(Add(image, "Radiance", 3))
    , Airlight(Add(image, "Airlight", 3))
    , Surface(Add(image, "Surface", 3))
    , Transmittance(Add(image, "Transmittance", 3))
    , Depth(Add(image, "Depth", 1))
    , LitLength(Add(image, "LitLength", 1))
  {
    image->GetPointData()->SetActiveScalars("Radiance");
  }

  void Set(vtkIdType index, const ReferencePixel& pixel) const
  {
    std::copy_n(&pixel.Radiance.x, 3, this->Radiance + 3 * index);
    std::copy_n(&pixel.Airlight.x, 3, this->Airlight + 3 * index);
    std::copy_n(&pixel.Surface.x, 3, this->Surface + 3 * index);
    std::copy_n(&pixel.Transmittance.x, 3, this->Transmittance + 3 * index);
    this->Depth[index] = pixel.Depth;
    this->LitLength[index] = pixel.LitLength;
  }

private:
  static double* Add(vtkImageData* image, const char* name, int components)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(image->GetNumberOfPoints());
    array->Fill(0.0);
    image->GetPointData()->AddArray(array);
    return array->GetPointer(0);
  }

  double* Radiance;
  double* Airlight;
  double* Surface;
  double* Transmittance;
  double* Depth;
  double* LitLength;
};
}

class vtkAirlightReference::Internals
{
public:
  // Forgets lights that are gone.
  std::vector<vtkWeakPointer<vtkLight>>& GetQuiet()
  {
    this->Quiet.erase(std::remove_if(this->Quiet.begin(), this->Quiet.end(),
                        [](const vtkWeakPointer<vtkLight>& light) { return !light; }),
      this->Quiet.end());
    return this->Quiet;
  }

  MediaList Media;
  vtkNew<vtkParticipatingMedium> Vacuum;
  vtkSmartPointer<vtkRenderer> Renderer;

private:
  std::vector<vtkWeakPointer<vtkLight>> Quiet; // those that the medium does not scatter
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
void vtkAirlightReference::AddMedium(vtkParticipatingMedium* medium)
{
  if (this->Impl->Media.Add(medium))
  {
    this->Modified();
  }
}

void vtkAirlightReference::RemoveMedium(vtkParticipatingMedium* medium)
{
  if (this->Impl->Media.Remove(medium))
  {
    this->Modified();
  }
}

void vtkAirlightReference::RemoveAllMedia()
{
  if (this->Impl->Media.Clear())
  {
    this->Modified();
  }
}

void vtkAirlightReference::SetMedium(vtkParticipatingMedium* medium)
{
  if (this->Impl->Media.Set(medium))
  {
    this->Modified();
  }
}

int vtkAirlightReference::GetNumberOfMedia() { return this->Impl->Media.GetSize(); }

vtkParticipatingMedium* vtkAirlightReference::GetMedium(int index)
{
  if (!this->Impl->Media.Has(index))
  {
    vtkErrorMacro(<< "Medium " << index << " does not exist: there are " << this->GetNumberOfMedia()
                  << ".");
    return nullptr;
  }
  return this->Impl->Media.Get(index);
}

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
void vtkAirlightReference::SetLightRadius(double radius)
{
  if (!std::isfinite(radius) || radius < 0.0)
  {
    vtkErrorMacro(<< "LightRadius " << radius << " must be finite and at least 0; it stays "
                  << this->LightRadius << ".");
    return;
  }
  if (this->LightRadius != radius)
  {
    this->LightRadius = radius;
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
  if (this->GetLightScatters(light) == scatters)
  {
    return;
  }
  std::vector<vtkWeakPointer<vtkLight>>& quiet = this->Impl->GetQuiet();
  if (scatters)
  {
    quiet.erase(std::find(quiet.begin(), quiet.end(), light));
  }
  else
  {
    quiet.emplace_back(light);
  }
  this->Modified();
}

bool vtkAirlightReference::GetLightScatters(vtkLight* light)
{
  const std::vector<vtkWeakPointer<vtkLight>>& quiet = this->Impl->GetQuiet();
  return std::find(quiet.begin(), quiet.end(), light) == quiet.end();
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
  settings.SurfaceShadows = this->SurfaceShadows;
  settings.Scatters = [this](vtkLight* light) { return this->GetLightScatters(light); };
  std::vector<vtkParticipatingMedium*> media = this->Impl->Media.GetAll();
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
  if (tracer.GetLights().HasInvalid())
  {
    vtkWarningMacro(<< InvalidLampText);
  }

  image->SetExtent(extent);
  image->SetSpacing(1.0, 1.0, 1.0);
  image->SetOrigin(0.0, 0.0, 0.0);
  const Buffers buffers(image);
  // Some rows at a time: progress is for this thread to tell.
  const int step = std::max(1, settings.Height / 50);
  for (int row = 0; row < settings.Height && !this->GetAbortExecute(); row += step)
  {
    const vtkIdType first = static_cast<vtkIdType>(row) * settings.Width;
    const vtkIdType last =
      static_cast<vtkIdType>(std::min(row + step, settings.Height)) * settings.Width;
    vtkSMPTools::For(first, last, 16, [&](vtkIdType from, vtkIdType to) {
      for (vtkIdType i = from; i < to; ++i)
      {
        buffers.Set(i,
          tracer.Trace(static_cast<int>(i % settings.Width), static_cast<int>(i / settings.Width)));
      }
    });
    this->UpdateProgress(static_cast<double>(last) / image->GetNumberOfPoints());
  }
  return 1;
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
