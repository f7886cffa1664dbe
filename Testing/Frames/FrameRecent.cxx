// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What the pass learned after the first seeds were kept: skies, holes in casters, volumes that cast
// shadows or are media, images with colours, multiple scattering. Only recent groups have it, from
// random numbers of its own: so earlier seeds still mean the scenes that they meant.

#include "FrameScene.h"

#include "vtkFloatArray.h"
#include "vtkHenyeyGreensteinPhaseFunction.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTexture.h"
#include "vtkVolume.h"

#include <algorithm>

namespace airlight_test
{
namespace
{
// Holes with sharp edges, or all shades of grey.
void CutHoles(vtkTexture* texture, Random& random)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  const bool sharp = random.Index(3) != 0;
  for (int i = 0; i < 4 * 64; ++i)
  {
    const int value = random.Index(256);
    texel[i] = static_cast<unsigned char>(i % 4 == 3 && sharp ? (value < 128 ? 0 : 255) : value);
  }
  texture->SetInputData(image);
  texture->SetInterpolate(!sharp || random.Index(2));
}
}

//------------------------------------------------------------------------------
void FrameScene::SetSky(vtkParticipatingMedium* medium, Random& random)
{
  const int kind = random.Index(4);
  const double blue = random.LogUniform(1e-3, 1e3);
  const double bright[3] = { random.Index(2) ? 0.0 : 0.3 * blue, 0.5 * blue, blue };
  const double dark[3] = { 0.0, 0.0, 0.0 };
  medium->SetSkyRadiance(kind == 1 ? bright : dark);
  medium->SetGroundRadiance(kind == 2 ? bright : dark);
  medium->ClearSkyHarmonics();
  if (kind == 3)
  {
    double coefficients[27];
    for (int i = 0; i < 27; ++i)
    {
      coefficients[i] = i < 3 ? bright[i] : 0.5 * blue * random.Uniform(-1.0, 1.0);
    }
    medium->SetSkyHarmonics(coefficients);
  }
  this->Note("sky ", kind, " ", Text3(bright));
}

//------------------------------------------------------------------------------
// Colours of each sample, for the albedo, the emission or both; or none.
void FrameScene::SetColours(vtkParticipatingMedium* medium, Random& random)
{
  const int kind = random.Index(4);
  this->Note("colours ", kind);
  medium->SetAlbedoArrayName(kind & 1 ? "Colours" : "");
  medium->SetEmissionArrayName(kind & 2 ? "Colours" : "");
  vtkImageData* image = medium->GetDensityImage();
  if (!image || kind == 0)
  {
    return;
  }
  vtkNew<vtkFloatArray> colours;
  colours->SetName("Colours");
  colours->SetNumberOfComponents(random.Index(2) ? 3 : 1);
  colours->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < colours->GetNumberOfValues(); ++i)
  {
    colours->SetValue(i, static_cast<float>(std::max(random.Uniform(-0.5, 1.0), 0.0)));
  }
  image->GetPointData()->AddArray(colours);
  const double emission = 0.1 / this->Unit;
  medium->SetEmission(emission, 2.0 * emission, 0.0);
}

//------------------------------------------------------------------------------
void FrameScene::ScatterInVolumes(Random& random)
{
  for (const FrameItem& item : this->Items)
  {
    if (vtkVolume* volume = vtkVolume::SafeDownCast(item.Prop))
    {
      const bool scatters = random.Index(2) != 0;
      vtkAirlightPass::SetVolumeScatters(volume, scatters);
      vtkNew<vtkHenyeyGreensteinPhaseFunction> phase;
      phase->SetAnisotropy(random.Uniform(-0.9, 0.9));
      const bool even = random.Index(2) != 0;
      vtkAirlightPass::SetVolumePhaseFunction(volume, even ? nullptr : phase.Get());
      this->Note("volume scatters ", scatters, even ? "" : " with a phase function");
    }
  }
}

//------------------------------------------------------------------------------
void FrameScene::AddCutOut(Random& random)
{
  FrameItem item = MakeFrameItem(FRAME_TEXTURED, random, this->Renderer->GetActiveCamera());
  CutHoles(item.Actors[0]->GetTexture(), random);
  this->PlaceItem(item, random);
  this->Note("with holes");
  this->Renderer->AddViewProp(item.Prop);
  this->Items.push_back(item);
}

//------------------------------------------------------------------------------
void FrameScene::AddRecent(Random& random)
{
  this->Pass->SetVolumeShadows(random.Index(2) != 0);
  for (vtkParticipatingMedium* medium : this->Media)
  {
    this->SetSky(medium, random);
    medium->SetMultipleScattering(random.Index(3) == 0);
    if (medium->GetDensity() == vtkParticipatingMedium::IMAGE)
    {
      this->SetColours(medium, random);
    }
  }
  this->ScatterInVolumes(random);
  if (random.Index(2) == 0)
  {
    this->AddCutOut(random);
  }
  this->Note("volume shadows ", this->Pass->GetVolumeShadows());
}

//------------------------------------------------------------------------------
void FrameScene::ChangeRecent(Random& random)
{
  vtkParticipatingMedium* medium =
    this->Media[static_cast<size_t>(random.Index(static_cast<int>(this->Media.size())))];
  const int change = random.Index(8);
  this->Note("recent change ", change);
  switch (change)
  {
    case 0:
      this->SetSky(medium, random);
      break;
    case 1:
      this->Pass->SetVolumeShadows(!this->Pass->GetVolumeShadows());
      break;
    case 2:
      medium->SetMultipleScattering(!medium->GetMultipleScattering());
      break;
    case 3:
      this->AddCutOut(random);
      break;
    case 4: // holes in what has some
      for (const FrameItem& item : this->Items)
      {
        if (item.Kind == FRAME_TEXTURED)
        {
          CutHoles(item.Actors[0]->GetTexture(), random);
        }
      }
      break;
    case 5:
      this->ScatterInVolumes(random);
      break;
    case 6:
      if (medium->GetDensity() == vtkParticipatingMedium::IMAGE)
      {
        this->SetColours(medium, random);
      }
      break;
    default:
      break;
  }
}
}
