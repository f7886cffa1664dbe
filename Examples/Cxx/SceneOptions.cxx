// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneOptions.h"

#include "ModelScene.h"
#include "OptionText.h"

#include <limits>

namespace airlight
{

namespace
{
constexpr double Largest = std::numeric_limits<double>::max();
constexpr double Smallest = std::numeric_limits<double>::min();

const char* const Description = R"(Lengths are in world units, colours linear.
A model stands on its own: its camera looks along -z and sees all of it; a point lamp hangs above,
to the left and in front; the medium is unbounded, isotropic and purely scattering, with a
visibility of 10 times the diagonal of the box around the model. The options change all of that.)";
}

//------------------------------------------------------------------------------
void SceneOptions::AddTo(CLI::App* command)
{
  command->footer(Description);
  command
    ->add_option("SCENE", this->FileName,
      "Scene (.json) or model (.gltf .glb .obj .ply .stl .vtp .vtk .vtu .wrl .3ds)")
    ->required();
  command->add_option("--size", this->Size, "Size of the picture, WxH pixels");
  command->add_option("--camera", this->Camera,
    "px,py,pz:fx,fy,fz[:angle]: position, point looked at, vertical view angle in degrees");
  command
    ->add_option("--point", this->Points,
      "x,y,z:I or x,y,z:r,g,b: a point lamp of this radiant intensity in W/sr, in place of the "
      "scene's lamps; repeat it for more")
    ->take_all()
    ->allow_extra_args(false);
  std::vector<CLI::Option*> mediumOptions;
  mediumOptions.push_back(command->add_option(
    "--scattering", this->Scattering, "r,g,b: scattering coefficient per world unit"));
  mediumOptions.push_back(command->add_option(
    "--absorption", this->Absorption, "r,g,b: absorption coefficient per world unit"));
  mediumOptions.push_back(command->add_option("--visibility", this->Visibility,
    "Distance at which a black object's contrast falls to 2 %; scales the coefficients"));
  mediumOptions.push_back(command->add_option("--anisotropy", this->Anisotropy,
    "Mean cosine g of the Henyey-Greenstein phase function, -0.99 to 0.99, above 0 forward; 0 is "
    "isotropic"));
  mediumOptions.push_back(command->add_option(
    "--ambient", this->Ambient, "r,g,b: ambient radiance that the medium scatters"));
  mediumOptions.push_back(command->add_option("--technique", this->Technique, "Shadow technique")
                            ->check(CLI::IsMember({ "Automatic", "ShadowPlanes", "None" }))
                            ->capture_default_str());
  CLI::Option* noMedium = command->add_flag(
    "--no-medium", this->NoMedium, "VTK's plain lighting: no medium and no shadows");
  for (CLI::Option* option : mediumOptions)
  {
    noMedium->excludes(option);
  }
}

//------------------------------------------------------------------------------
Scene SceneOptions::Load() const
{
  Scene scene = ReadSceneOrModel(this->FileName);
  if (!this->Size.empty())
  {
    std::tie(scene.Width, scene.Height) = ParseSize("--size", this->Size);
  }
  if (!this->Camera.empty())
  {
    scene.Camera = ParseCamera("--camera", this->Camera, scene.Camera);
  }
  if (!this->Points.empty())
  {
    scene.Lights.clear();
    for (const std::string& point : this->Points)
    {
      scene.Lights.push_back(ParsePoint("--point", point));
    }
  }
  this->ChangeMedium(scene.Medium);
  return scene;
}

//------------------------------------------------------------------------------
void SceneOptions::ChangeMedium(vtkParticipatingMedium* medium) const
{
  if (!this->Scattering.empty())
  {
    medium->SetScattering(ParseColor("--scattering", this->Scattering).data());
  }
  if (!this->Absorption.empty())
  {
    medium->SetAbsorption(ParseColor("--absorption", this->Absorption).data());
  }
  if (!this->Visibility.empty()) // last, because it scales the coefficients
  {
    medium->SetVisibility(ParseNumber("--visibility", this->Visibility, Smallest, Largest));
  }
  if (!this->Anisotropy.empty())
  {
    const double g = ParseNumber("--anisotropy", this->Anisotropy, -0.99, 0.99);
    medium->SetPhaseFunction(
      g == 0.0 ? vtkParticipatingMedium::ISOTROPIC : vtkParticipatingMedium::HENYEY_GREENSTEIN);
    medium->SetAnisotropy(g);
  }
  if (!this->Ambient.empty())
  {
    medium->SetAmbientRadiance(ParseColor("--ambient", this->Ambient).data());
  }
}

//------------------------------------------------------------------------------
RenderSettings SceneOptions::GetSettings() const
{
  RenderSettings settings;
  settings.UseMedium = !this->NoMedium;
  if (this->Technique == "ShadowPlanes")
  {
    settings.ShadowTechnique = vtkAirlightPass::SHADOW_PLANES;
  }
  else if (this->Technique == "None")
  {
    settings.ShadowTechnique = vtkAirlightPass::NONE;
  }
  return settings;
}

}
