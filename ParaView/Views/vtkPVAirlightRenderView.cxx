// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVAirlightRenderView.h"

#include "AirlightDataGathering.h"
#include "AirlightFarPass.h"
#include "AirlightMediumSources.h"
#include "AirlightRemoteDepths.h"
#include "AirlightRemoteSilhouettes.h"
#include "AirlightViewLamp.h"
#include "vtkAirlightLight.h"
#include "vtkAirlightPass.h"
#include "vtkCallbackCommand.h"
#include "vtkCommunicator.h"
#include "vtkHenyeyGreensteinPhaseFunction.h"
#include "vtkImageProcessingPass.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVCenterAxesActor.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVGridAxes3DActor.h"
#include "vtkPVMediumRepresentation.h"
#include "vtkPVParticipatingMedium.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderer.h"
#include "vtkToneMappingPass.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkPVAirlightRenderView);

namespace
{
// Axes stand in the scene to be read, not to shade it.
void KeepFromCasting(vtkProp* prop)
{
  if (!prop)
  {
    return;
  }
  vtkNew<vtkInformation> keys;
  if (vtkInformation* own = prop->GetPropertyKeys())
  {
    keys->Copy(own);
  }
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
  prop->SetPropertyKeys(keys);
}

// The visible representations of data as media.
std::vector<vtkPVMediumRepresentation*> FindMedia(vtkPVAirlightRenderView* view)
{
  std::vector<vtkPVMediumRepresentation*> found;
  for (int i = 0; i < view->GetNumberOfRepresentations(); ++i)
  {
    auto* shown = vtkPVMediumRepresentation::SafeDownCast(view->GetRepresentation(i));
    if (shown && shown->GetVisibility() && shown->GetMedium())
    {
      found.push_back(shown);
    }
  }
  return found;
}

// The pass is left alone while its media stay.
void SetMedia(vtkAirlightPass* pass, const std::vector<vtkParticipatingMedium*>& media)
{
  bool isSame = pass->GetNumberOfMedia() == static_cast<int>(media.size());
  for (int i = 0; isSame && i < pass->GetNumberOfMedia(); ++i)
  {
    isSame = pass->GetMedium(i) == media[i];
  }
  if (isSame)
  {
    return;
  }
  pass->RemoveAllMedia();
  for (vtkParticipatingMedium* medium : media)
  {
    pass->AddMedium(medium);
  }
}

bool IsClear(vtkParticipatingMedium* medium)
{
  double extinction[3];
  medium->GetExtinction(extinction);
  return std::all_of(extinction, extinction + 3, [](double c) { return c == 0.0; });
}

bool IsWithoutEffect(vtkParticipatingMedium* medium)
{
  const double* emission = medium->GetEmission();
  return IsClear(medium) && std::all_of(emission, emission + 3, [](double c) { return c == 0.0; });
}
}

//------------------------------------------------------------------------------
vtkPVAirlightRenderView::vtkPVAirlightRenderView()
  : FarPass(vtkSmartPointer<AirlightFarPass>::New())
  , Remote(new airlight::RemoteSilhouettes)
  , Depths(new airlight::RemoteDepths)
  , Lamp(new airlight::ViewLamp)
  , Sources(new airlight::MediumSources)
{
  this->FarPass->SetDelegate(this->Pass);
  this->FarPass->SetRendered([this] { this->EndFrame(); });
  KeepFromCasting(this->CenterAxes);
  // After ParaView's own observer, which brings the camera to all ranks.
  vtkNew<vtkCallbackCommand> start;
  start->SetClientData(this);
  start->SetCallback([](vtkObject*, unsigned long, void* view, void*) {
    static_cast<vtkPVAirlightRenderView*>(view)->StartFrame();
  });
  this->StartTag = this->GetRenderer()->AddObserver(vtkCommand::StartEvent, start, -1.0f);
}

vtkPVAirlightRenderView::~vtkPVAirlightRenderView()
{
  this->GetRenderer()->RemoveObserver(this->StartTag);
  this->FarPass->SetRendered(nullptr);
  this->Pass->SetPixelChooser(nullptr);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetMedium(vtkParticipatingMedium* medium)
{
  this->Pass->RemoveAllMedia();
  this->Pass->SetMedium(medium);
  this->Medium = medium;
  this->OwnMedium = vtkPVParticipatingMedium::SafeDownCast(medium);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetRegionSurfaceConnection(vtkAlgorithmOutput* connection)
{
  this->Sources->GetSurface().SetConnection(connection);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetDensityImageConnection(vtkAlgorithmOutput* connection)
{
  this->Sources->GetImage().SetConnection(connection);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetDensityArray(int, int, int, int, const char* name)
{
  this->Sources->GetImage().SetDensityArray(name);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetAlbedoArrayName(const char* name)
{
  this->Sources->GetImage().SetAlbedoArray(name);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetEmissionArrayName(const char* name)
{
  this->Sources->GetImage().SetEmissionArray(name);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetShadowTechnique(int technique)
{
  this->Pass->SetShadowTechnique(technique);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetShadowMapResolution(int resolution)
{
  this->Pass->SetShadowMapResolution(resolution);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetMaximumBoundariesPerPixel(double boundaries)
{
  this->Pass->SetMaximumBoundariesPerPixel(boundaries);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetNumberOfSteps(int steps) { this->Pass->SetNumberOfSteps(steps); }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetSurfaceShadows(bool on) { this->Pass->SetSurfaceShadows(on); }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetTranslucentShadows(bool on)
{
  this->Pass->SetTranslucentShadows(on);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetVolumeShadows(bool on) { this->Pass->SetVolumeShadows(on); }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetScatteredSurfaceLight(bool on)
{
  this->Pass->SetScatteredSurfaceLight(on);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetLinearInput(bool on) { this->Pass->SetLinearInput(on); }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetRadianceExposure(double exposure)
{
  this->Pass->SetExposure(exposure);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetAutomaticExposure(bool on)
{
  this->Pass->SetAutomaticExposure(on);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetOutputColorSpace(int space)
{
  this->Pass->SetOutputColorSpace(space);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetMultisampling(bool on) { this->Pass->SetMultisampling(on); }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetToneMapping(int curve)
{
  if (curve != -1)
  {
    this->Pass->SetToneMapping(curve); // which refuses others
    curve = this->Pass->GetToneMapping();
  }
  this->ToneMapping = curve;
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetLamp(bool on) { this->Lamp->On = on; }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetLampColor(double r, double g, double b)
{
  const double color[3] = { r, g, b };
  if (!std::all_of(color, color + 3, [](double c) { return c >= 0.0 && c <= 1.0; }))
  {
    vtkErrorMacro(<< "LampColor (" << r << ", " << g << ", " << b
                  << ") must be from 0 to 1 in each channel; the old one stays.");
    return;
  }
  std::copy(color, color + 3, this->Lamp->Color);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetLampBrightness(double brightness)
{
  if (!std::isfinite(brightness) || brightness < 0.0)
  {
    vtkErrorMacro(<< "LampBrightness " << brightness << " must be finite and at least 0; it stays "
                  << this->Lamp->Brightness << ".");
    return;
  }
  this->Lamp->Brightness = brightness;
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetVolumesAnisotropy(double anisotropy)
{
  this->VolumeFunction->SetAnisotropy(anisotropy);
}

double vtkPVAirlightRenderView::GetVolumesAnisotropy()
{
  return this->VolumeFunction->GetAnisotropy();
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetLampRadius(double radius)
{
  if (!std::isfinite(radius) || radius < 0.0)
  {
    vtkErrorMacro(<< "LampRadius " << radius << " must be finite and at least 0; it stays "
                  << this->Lamp->Radius << ".");
    return;
  }
  this->Lamp->Radius = radius;
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetLampVisible(bool visible) { this->Lamp->Visible = visible; }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetLampPhotometry(const char* file)
{
  vtkAirlightLight::SetPhotometry(this->Lamp->GetLight(), file);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetLampPhotometryUp(double x, double y, double z)
{
  vtkAirlightLight::SetPhotometryUp(this->Lamp->GetLight(), x, y, z);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetDithering(bool on) { this->Pass->SetDithering(on); }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetSubpixelFrames(int frames)
{
  this->Pass->SetSubpixelFrames(frames);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetDebugView(int view) { this->Pass->SetDebugView(view); }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetLightRadius(double radius) { this->Pass->SetLightRadius(radius); }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetMemoryLimit(int limit) { this->Pass->SetMemoryLimit(limit); }

//------------------------------------------------------------------------------
int vtkPVAirlightRenderView::GetAccumulatedFrames() { return this->Pass->GetAccumulatedFrames(); }

//------------------------------------------------------------------------------
vtkAirlightPass* vtkPVAirlightRenderView::GetAirlightPass() { return this->Pass; }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::SetGridAxes3DActor(vtkPVGridAxes3DActor* axes)
{
  KeepFromCasting(axes);
  this->Superclass::SetGridAxes3DActor(axes);
}

//------------------------------------------------------------------------------
// Passes of ParaView's own, for ray tracing and for values in place of colours, stay while they are
// there.
void vtkPVAirlightRenderView::Render(bool interactive, bool skip_rendering)
{
  vtkRenderPass* current = this->SynchronizedRenderers->GetRenderPass();
  vtkRenderPass* own = this->Airlight ? this->FarPass.Get() : nullptr;
  if (!current || current == this->FarPass)
  {
    this->SynchronizedRenderers->SetRenderPass(own);
  }
  // ParaView's tone mapping decodes its input.
  const int space = this->Pass->GetOutputColorSpace();
  if (vtkToneMappingPass::SafeDownCast(this->SynchronizedRenderers->GetImageProcessingPass()))
  {
    this->Pass->SetOutputColorSpaceToGamma22();
  }
  this->Pass->SetProgressiveRefinement(
    this->ProgressiveRefinement && this->GetInteractor() && !this->GetInCaptureScreenshot());
  const int frames = this->Pass->GetSubpixelFrames();
  const bool multisampling = this->Pass->GetMultisampling();
  this->Superclass::Render(interactive, skip_rendering);
  this->InFrame = false;
  this->Pass->SetSubpixelFrames(frames);
  this->Pass->SetMultisampling(multisampling);
  this->Pass->SetOutputColorSpace(space);
  this->Remote->Spread(this->GetRenderer(), false);
}

//------------------------------------------------------------------------------
// Those whose automatic values the view gives: its own one, and those of visible data.
std::vector<vtkPVParticipatingMedium*> vtkPVAirlightRenderView::FindOwnMedia()
{
  std::vector<vtkPVParticipatingMedium*> media;
  if (this->OwnMedium)
  {
    media.push_back(this->OwnMedium);
  }
  for (vtkPVMediumRepresentation* shown : FindMedia(this))
  {
    media.push_back(shown->GetMedium());
  }
  return media;
}

//------------------------------------------------------------------------------
// All processes come here, with the same representations.
void vtkPVAirlightRenderView::UpdateMedia()
{
  const double time = this->GetViewTime();
  const auto findLargest = [this](vtkTypeUInt64 number) {
    vtkTypeUInt64 largest = 0;
    this->AllReduce(number, largest, vtkCommunicator::MAX_OP);
    return largest;
  };
  std::vector<vtkParticipatingMedium*> media;
  if (this->Medium &&
    (!this->OwnMedium || this->Sources->Update(this->OwnMedium, time, findLargest)))
  {
    media.push_back(this->Medium);
  }
  for (vtkPVMediumRepresentation* shown : FindMedia(this))
  {
    if (shown->UpdateMedium(time, findLargest))
    {
      media.push_back(shown->GetMedium());
    }
  }
  // Clear air beside other media would take their rays some times as long.
  const auto clear = std::remove_if(media.begin(), media.end(), IsWithoutEffect);
  if (clear != media.begin())
  {
    media.erase(clear, media.end());
  }
  SetMedia(this->Pass, media);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::Update()
{
  this->Superclass::Update();
  this->ChooseGathering();
  this->MeasureData();
  this->UpdateMedia();
}

//------------------------------------------------------------------------------
// Whether ParaView's view has pictures of several ranks put together. Walls and caves have not.
bool vtkPVAirlightRenderView::IsInParts()
{
  return this->Airlight && !this->GetEnableOSPRay() && !this->InTileDisplayMode() &&
    !this->InCaveDisplayMode() && this->GetUseDistributedRenderingForRender();
}

//------------------------------------------------------------------------------
// Where they cannot be.
bool vtkPVAirlightRenderView::NeedsAllData()
{
  return this->IsInParts() &&
    (this->GetUseOrderedCompositing() || this->Pass->GetSubpixelFrames() > 1 ||
      this->Pass->GetAutomaticExposure());
}

//------------------------------------------------------------------------------
// All processes must come to the same decision, as they send and receive data together. Most views
// need nothing of it.
void vtkPVAirlightRenderView::ChooseGathering()
{
  using airlight::DataGathering;
  this->FirstDraws = false;
  vtkTypeUInt64 needed = 0;
  this->AllReduce(DataGathering::IsOneOfSeveral() && this->NeedsAllData() ? 1 : 0, needed,
    vtkCommunicator::MAX_OP);
  if (needed == 0)
  {
    return;
  }
  vtkTypeUInt64 refused = 0;
  this->AllReduce(DataGathering::CanMerge(this) ? 0 : 1, refused, vtkCommunicator::MAX_OP);
  vtkTypeUInt64 renderServer = 0;
  this->AllReduce(DataGathering::OnlyDraws() ? 1 : 0, renderServer, vtkCommunicator::MAX_OP);
  vtkTypeUInt64 size = 0; // KiB
  this->AllReduce(
    this->GetDeliveryManager()->GetVisibleDataSize(false), size, vtkCommunicator::SUM_OP);
  this->FirstDraws = refused == 0 && size <= 1024 * static_cast<vtkTypeUInt64>(this->GatherLimit);
  if (this->FirstDraws)
  {
    DataGathering::Begin(this, renderServer != 0);
  }
}

//------------------------------------------------------------------------------
// One by one, so that the pass has nothing to say about them.
void vtkPVAirlightRenderView::SwitchCameraLights()
{
  vtkLightCollection* lights = this->GetRenderer()->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (!light->LightTypeIsSceneLight())
    {
      this->Pass->SetLightScatters(light, this->CameraLightsScatter);
    }
  }
}

//------------------------------------------------------------------------------
// Volumes that a script has made media stay so while the view's switch is off.
void vtkPVAirlightRenderView::SwitchVolumes()
{
  if (!this->VolumesScatter && !this->VolumesScattered)
  {
    return;
  }
  vtkPhaseFunction* wanted = this->VolumesScatter && this->GetVolumesAnisotropy() != 0.0
    ? this->VolumeFunction.Get()
    : nullptr;
  vtkVolumeCollection* volumes = this->GetRenderer()->GetVolumes();
  vtkCollectionSimpleIterator it = nullptr;
  volumes->InitTraversal(it);
  while (vtkVolume* volume = volumes->GetNextVolume(it))
  {
    vtkInformation* keys = volume->GetPropertyKeys();
    if (!keys || (keys->Get(vtkAirlightPass::VOLUME_SCATTERS()) == 1) != this->VolumesScatter)
    {
      vtkAirlightPass::SetVolumeScatters(volume, this->VolumesScatter);
    }
    // Each change of keys is one of the scene. A script's own function stays.
    vtkObjectBase* function = keys ? keys->Get(vtkAirlightPass::VOLUME_PHASE_FUNCTION()) : nullptr;
    if (wanted != function && (wanted || function == this->VolumeFunction))
    {
      vtkAirlightPass::SetVolumePhaseFunction(volume, wanted);
    }
  }
  this->VolumesScattered = this->VolumesScatter;
}

//------------------------------------------------------------------------------
// ParaView's own bounds also have those of props, which are still the former ones at this time:
// data that shrink would not count before the next update.
void vtkPVAirlightRenderView::MeasureData()
{
  vtkBoundingBox own;
  auto* delivery = vtkPVRenderViewDataDeliveryManager::SafeDownCast(this->GetDeliveryManager());
  for (int i = 0; delivery && i < this->GetNumberOfRepresentations(); ++i)
  {
    auto* shown = vtkPVDataRepresentation::SafeDownCast(this->GetRepresentation(i));
    const int ports = shown && shown->GetVisibility() ? delivery->GetNumberOfPorts(shown) : 0;
    for (int port = 0; port < ports; ++port)
    {
      own.AddBox(delivery->GetTransformedGeometryBounds(shown, port));
    }
  }
  this->DataBounds.Reset();
  this->AllReduce(own, this->DataBounds);
  if (!this->DataBounds.IsValid())
  {
    this->DataBounds = this->GeometryBounds;
  }
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::FollowData()
{
  this->Lamp->Update(this->GetRenderer(), this->DataBounds);
  if (this->OwnMedium)
  {
    double bounds[6]; // of no size where there are no data
    this->DataBounds.GetBounds(bounds);
    this->OwnMedium->SetSceneBounds(bounds);
  }
}

//------------------------------------------------------------------------------
// For transparent screenshots, ParaView draws before white and before black, which do not count.
void vtkPVAirlightRenderView::UpdateBackground(vtkRenderer* other)
{
  this->Superclass::UpdateBackground(other);
  vtkRenderer* renderer = this->GetRenderer();
  if ((other && other != renderer) || this->KeepsBackground)
  {
    return;
  }
  double background[3];
  renderer->GetBackground(background);
  if (renderer->GetGradientBackground())
  {
    double top[3];
    renderer->GetBackground2(top);
    std::transform(background, background + 3, top, background,
      [](double low, double high) { return 0.5 * (low + high); });
  }
  for (vtkPVParticipatingMedium* medium : this->FindOwnMedia())
  {
    medium->SetBackground(background);
  }
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::ChooseToneMapping()
{
  if (this->ToneMapping >= 0)
  {
    this->Pass->SetToneMapping(this->ToneMapping);
    return;
  }
  bool isClear = true;
  for (int i = 0; i < this->Pass->GetNumberOfMedia(); ++i)
  {
    isClear = isClear && IsClear(this->Pass->GetMedium(i));
  }
  this->Pass->SetToneMapping(isClear ? vtkAirlightPass::CLAMP : vtkAirlightPass::NEUTRAL_PBR);
}

//------------------------------------------------------------------------------
bool vtkPVAirlightRenderView::IsParallel()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 && !this->InCaveDisplayMode() &&
    this->SynchronizedRenderers->GetParallelSynchronizer() &&
    this->SynchronizedRenderers->GetEnabled();
}

//------------------------------------------------------------------------------
// All ranks that draw come here together, with the same camera and lights.
void vtkPVAirlightRenderView::StartFrame()
{
  if (!this->Parallel)
  {
    return;
  }
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  this->Remote->Update(this->GetRenderer(), this->Pass, controller);
  int size[2];
  int corner[2];
  this->GetRenderer()->GetTiledSizeAndOrigin(&size[0], &size[1], &corner[0], &corner[1]);
  // The parts of a tiled display are drawn one by one, what is translucent has no depth, and while
  // something is selected IceT may leave out ranks that have nothing in view.
  const bool possible =
    this->InFrame && !this->InTileDisplayMode() && !this->GetUseOrderedCompositing();
  this->Depths->Begin(controller, possible, { size[0], size[1] });
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::EndFrame()
{
  if (!this->Parallel)
  {
    return;
  }
  this->Depths->End();
  this->FarPass->SetMoves(!this->Depths->LeavesBackground());
}

//------------------------------------------------------------------------------
// ParaView puts a background of its own behind what is composited in order, on walls, and behind a
// reduced picture, of which a gradient would be a part.
bool vtkPVAirlightRenderView::DrawsBackground(bool interactive)
{
  vtkRenderer* renderer = this->GetRenderer();
  const int factor = interactive ? this->GetInteractiveRenderImageReductionFactor()
                                 : this->GetStillRenderImageReductionFactor();
  return !this->GetUseOrderedCompositing() && !this->InTileDisplayMode() &&
    (factor == 1 || !(renderer->GetGradientBackground() || renderer->GetTexturedBackground()));
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::AboutToRenderOnLocalProcess(bool interactive)
{
  this->Superclass::AboutToRenderOnLocalProcess(interactive);
  this->SwitchCameraLights();
  this->SwitchVolumes();
  this->FollowData();
  this->ChooseToneMapping();
  const bool several = this->Airlight && this->IsParallel();
  const bool parallel = several && !this->FirstDraws;
  if (parallel != this->Parallel)
  {
    this->Parallel = parallel;
    this->Pass->SetPixelChooser(!parallel
        ? vtkAirlightPass::PixelChooser()
        : [this](int width, int height, const float* depths, unsigned char* drawn) {
            return this->Depths->Choose(width, height, depths, drawn);
          });
  }
  this->FarPass->SetMoves(several);
  this->FarPass->SetDraws(!several || parallel ||
    vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() == 0);
  this->FarPass->SetBackground(
    several && this->DrawsBackground(interactive) ? this->GetRenderer() : nullptr);
  this->InFrame = true;
  if (several)
  {
    this->Remote->Spread(this->GetRenderer(), true);
  }
  if (!this->Parallel)
  {
    this->Remote->Clear(this->Pass);
    return;
  }
  this->WarnOfParts();
  // Means at the edges of a rank's part would be without the others. Render() undoes it.
  this->Pass->SetSubpixelFrames(1);
  this->Pass->SetMultisampling(false);
}

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::WarnOfParts()
{
  if (this->NeedsAllData() && !this->WarnedOfParts)
  {
    this->WarnedOfParts = true;
    vtkWarningMacro(
      << "Each rank draws its own part, as the visible data have more than the "
         "GatherLimit of "
      << this->GatherLimit
      << " MiB, or ParaView cannot merge them: the medium before translucent surfaces "
         "and volumes counts for each rank that draws them, SubpixelFrames do nothing, "
         "and an automatic exposure is that of each part. Raise the limit, make all "
         "opaque and these off, or use one rank.");
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkPVAirlightRenderView::GetGatheredBytes() { return this->Remote->GetBytes(); }

vtkTypeInt64 vtkPVAirlightRenderView::GetPixelsLeftOut() { return this->Depths->GetLeftOut(); }

//------------------------------------------------------------------------------
void vtkPVAirlightRenderView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Airlight: " << this->Airlight << "\n";
  os << indent << "CameraLightsScatter: " << this->CameraLightsScatter << "\n";
  os << indent << "ToneMapping: " << this->ToneMapping << "\n";
  os << indent << "Lamp: " << this->Lamp->On << "\n";
  os << indent << "VolumesScatter: " << this->VolumesScatter << "\n";
  os << indent << "VolumesAnisotropy: " << this->VolumeFunction->GetAnisotropy() << "\n";
  os << indent << "ProgressiveRefinement: " << this->ProgressiveRefinement << "\n";
  os << indent << "GatherLimit: " << this->GatherLimit << "\n";
  os << indent << "AirlightPass:\n";
  this->Pass->PrintSelf(os, indent.GetNextIndent());
}
