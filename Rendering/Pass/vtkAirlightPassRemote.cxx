// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What casts shadows in other processes.

#include "vtkAirlightPass.h"

#include "Medium/AirlightConvert.h"
#include "Pass/vtkAirlightPassInternals.h"
#include "Scene/AirlightCameraUniforms.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

using namespace airlight;

namespace
{
LightSilhouettes Describe(const ShadowVolumes& volumes, const glm::dvec4& light)
{
  LightSilhouettes shadow;
  shadow.Light = light;
  shadow.Anchor = volumes.GetAnchor();
  shadow.StartCount = volumes.GetStartCount();
  shadow.Edges = volumes.GetEdges();
  // Who takes them finds out by itself which of their planes the eye lies on.
  for (const NearEdge& near : volumes.GetNearEdges())
  {
    shadow.Edges.push_back(near.Edge);
    shadow.Edges.back().B.w = 0.0f;
  }
  shadow.Caps = volumes.GetCaps();
  return shadow;
}
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::CollectSilhouettes(
  vtkRenderer* renderer, std::vector<unsigned char>& bytes)
{
  const int* size = renderer->GetRenderWindow()->GetSize();
  renderer->UpdateLightsGeometryToFollowCamera();
  const CameraUniforms view(renderer, std::max(size[0], 1), std::max(size[1], 1));
  if (!view.IsValid())
  {
    this->Error = "the camera's matrices are not finite or cannot be inverted";
    return false;
  }
  const std::vector<vtkParticipatingMedium*> media = this->Media.GetAll();
  const std::vector<Lamp> lamps = CollectLamps(renderer, ConvertMedia(media, view.GetEye()), view,
    this->Self->LightRadius, this->Switches, this->Lights);
  this->CurrentFrame.FindCasters(renderer, false);
  std::vector<LightSilhouettes> shadows(lamps.size());
  this->OwnShadows.resize(lamps.size());
  for (size_t k = 0; k < lamps.size(); ++k)
  {
    shadows[k].Light = lamps[k].World;
    if (lamps[k].Scatters() && lamps[k].CastsShadows)
    {
      this->OwnShadows[k].Update(
        this->CurrentFrame.GetCasters().GetCasters(), lamps[k].World, view, true);
      shadows[k] = Describe(this->OwnShadows[k], lamps[k].World);
    }
  }
  bytes = WriteSilhouettes(shadows);
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::GetSilhouettes(vtkRenderer* renderer, vtkUnsignedCharArray* silhouettes)
{
  if (silhouettes)
  {
    silhouettes->Initialize();
  }
  if (!renderer || !renderer->GetRenderWindow() || !silhouettes)
  {
    vtkErrorMacro("GetSilhouettes() needs a renderer in a window, and an array; it got "
      << (renderer ? "a renderer" : "null")
      << (renderer && !renderer->GetRenderWindow() ? " without a window" : "") << " and "
      << (silhouettes ? "an array." : "null."));
    return false;
  }
  std::vector<unsigned char> bytes;
  if (!this->Impl->CollectSilhouettes(renderer, bytes))
  {
    vtkErrorMacro("GetSilhouettes() found none: " << this->Impl->Error << ". Set another camera.");
    return false;
  }
  silhouettes->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), silhouettes->GetPointer(0));
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::AddRemoteSilhouettes(vtkUnsignedCharArray* silhouettes)
{
  if (!silhouettes)
  {
    vtkErrorMacro("AddRemoteSilhouettes() needs an array that GetSilhouettes() has filled; it got "
                  "null.");
    return false;
  }
  const auto size = static_cast<size_t>(silhouettes->GetNumberOfValues());
  ProcessSilhouettes shadows;
  std::string error;
  if (!ReadSilhouettes(size > 0 ? silhouettes->GetPointer(0) : nullptr, size, shadows, error))
  {
    vtkErrorMacro("AddRemoteSilhouettes() does not take these "
      << size << " bytes: " << error
      << ". Send what GetSilhouettes() makes, whole, to a process of the same kind of machine.");
    return false;
  }
  this->Impl->CurrentFrame.AddRemoteSilhouettes(shadows);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkAirlightPass::RemoveAllRemoteSilhouettes()
{
  if (this->Impl->CurrentFrame.HasRemoteSilhouettes())
  {
    this->Impl->CurrentFrame.RemoveAllRemoteSilhouettes();
    this->Modified();
  }
}
