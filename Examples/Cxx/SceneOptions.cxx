// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneOptions.h"

#include "LightText.h"
#include "MediumText.h"
#include "ModelScene.h"
#include "OptionText.h"

#include <limits>
#include <utility>

namespace airlight
{

namespace
{
constexpr double Largest = std::numeric_limits<double>::max();
constexpr double Smallest = std::numeric_limits<double>::min();

const char* const Description = R"(Lengths are in world units, colours linear.
A model stands on its own: its camera looks along -z and sees all of it; a point lamp hangs above,
to the left and in front; the medium is unbounded, isotropic and purely scattering, with a
visibility of 10 times the diagonal of the box around the model. The options change all of that.
Over a scene file, --point, --spot and --sun replace all of its lamps and add up with each other;
any other option replaces what it names and leaves the rest as the file has it.)";

// An option with one value, which leaves the words after it to others.
CLI::Option* AddText(
  CLI::App* command, const char* name, std::vector<std::string>& texts, const char* help)
{
  return command->add_option(name, texts, help)->expected(1)->allow_extra_args(false);
}
}

//------------------------------------------------------------------------------
void SceneOptions::AddTo(CLI::App* command)
{
  command->footer(Description);
  command
    ->add_option("SCENE", this->FileName,
      "Scene (.json) or model (.gltf .glb .obj .ply .stl .vtp .vtk .vtu .wrl .3ds)")
    ->required();
  AddText(command, "--size", this->Size, "Size of the picture, WxH pixels");
  AddText(command, "--camera", this->Camera,
    "px,py,pz:fx,fy,fz[:angle]: position, point looked at, vertical view angle in degrees");
  this->AddLightOptions(command);
  this->AddMediumOptions(command);
}

//------------------------------------------------------------------------------
void SceneOptions::AddLightOptions(CLI::App* command)
{
  const auto add = [command](const char* name, std::vector<std::string>& texts, const char* help) {
    command->add_option(name, texts, help)->take_all()->allow_extra_args(false);
  };
  add("--point", this->Points,
    "x,y,z:I: a point lamp, in place of the scene's lamps; I is its radiant intensity in W/sr, a "
    "number or r,g,b. Repeat it for more lamps");
  add("--spot", this->Spots,
    "x,y,z:tx,ty,tz:ANGLE:I[:EXPONENT]: a spot at x,y,z that aims at tx,ty,tz, in place of the "
    "scene's lamps. ANGLE is the half angle of its cone in degrees, above 0 and below 90; I is the "
    "radiant intensity on its axis in W/sr, a number or r,g,b; off the axis it falls with the "
    "cosine to the power of EXPONENT, 0 to 128 (default 0: even up to a hard edge). Repeat it for "
    "more");
  add("--sun", this->Suns,
    "dx,dy,dz:E: a sun that stands in the direction dx,dy,dz, in place of the scene's lamps; E is "
    "the irradiance in W/m^2 of a surface that faces it, a number or r,g,b. Repeat it for more");
}

//------------------------------------------------------------------------------
void SceneOptions::AddMediumOptions(CLI::App* command)
{
  std::vector<CLI::Option*> options;
  const auto add = [command, &options](const char* name, Text& text, const char* help) {
    options.push_back(AddText(command, name, text, help));
    return options.back();
  };
  add("--scattering", this->Scattering, "r,g,b: scattering coefficient per world unit");
  add("--absorption", this->Absorption, "r,g,b: absorption coefficient per world unit");
  add("--visibility", this->Visibility,
    "Distance in world units at which a black object's contrast falls to 2 %; scales the "
    "coefficients");
  add("--anisotropy", this->Anisotropy,
    "Mean cosine g of the Henyey-Greenstein phase function, -0.99 to 0.99, above 0 forward; 0 is "
    "isotropic");
  add("--ambient", this->Ambient,
    "r,g,b: ambient radiance in W/(m^2 sr) that the medium scatters (default 0,0,0)");
  CLI::Option* box = add("--box", this->Box,
    "xmin,xmax,ymin,ymax,zmin,zmax: the medium fills this box, with vacuum around it");
  CLI::Option* sphere = add("--sphere", this->Sphere,
    "x,y,z:R: the medium fills this sphere of centre x,y,z and radius R, with vacuum around it");
  box->excludes(sphere);
  add("--height-fog", this->HeightFog,
    "REFERENCE:SCALE[:ux,uy,uz]: the medium thins out with height and has its coefficients at the "
    "height REFERENCE, 1/e of them SCALE above it; heights are along ux,uy,uz from the origin "
    "(default 0,1,0)");
  options.push_back(command->add_option("--technique", this->Technique, "Shadow technique")
                      ->check(CLI::IsMember({ "Automatic", "ShadowPlanes", "None" }))
                      ->capture_default_str());
  CLI::Option* noMedium = command->add_flag(
    "--no-medium", this->NoMedium, "VTK's plain lighting: no medium and no shadows");
  for (CLI::Option* option : options)
  {
    noMedium->excludes(option);
  }
}

//------------------------------------------------------------------------------
Scene SceneOptions::Load() const
{
  Scene scene = ReadSceneOrModel(this->FileName);
  for (const std::string& text : this->Size)
  {
    std::tie(scene.Width, scene.Height) = ParseSize("--size", text);
  }
  for (const std::string& text : this->Camera)
  {
    scene.Camera = ParseCamera("--camera", text, scene.Camera);
  }
  this->ChangeLights(scene.Lights);
  this->ChangeMedium(scene.Medium);
  return scene;
}

//------------------------------------------------------------------------------
void SceneOptions::ChangeLights(std::vector<LightSource>& lights) const
{
  std::vector<LightSource> wanted;
  for (const std::string& point : this->Points)
  {
    wanted.push_back(ParsePoint("--point", point));
  }
  for (const std::string& spot : this->Spots)
  {
    wanted.push_back(ParseSpot("--spot", spot));
  }
  for (const std::string& sun : this->Suns)
  {
    wanted.push_back(ParseSun("--sun", sun));
  }
  if (!wanted.empty())
  {
    lights = std::move(wanted);
  }
}

//------------------------------------------------------------------------------
void SceneOptions::ChangeMedium(vtkParticipatingMedium* medium) const
{
  for (const std::string& text : this->Scattering)
  {
    medium->SetScattering(ParseColor("--scattering", text).data());
  }
  for (const std::string& text : this->Absorption)
  {
    medium->SetAbsorption(ParseColor("--absorption", text).data());
  }
  for (const std::string& text : this->Visibility) // last, because it scales the coefficients
  {
    medium->SetVisibility(ParseNumber("--visibility", text, Smallest, Largest));
  }
  for (const std::string& text : this->Anisotropy)
  {
    const double g = ParseNumber("--anisotropy", text, -0.99, 0.99);
    medium->SetPhaseFunction(
      g == 0.0 ? vtkParticipatingMedium::ISOTROPIC : vtkParticipatingMedium::HENYEY_GREENSTEIN);
    medium->SetAnisotropy(g);
  }
  for (const std::string& text : this->Ambient)
  {
    medium->SetAmbientRadiance(ParseColor("--ambient", text).data());
  }
  for (const std::string& text : this->Box)
  {
    ParseBox("--box", text, medium);
  }
  for (const std::string& text : this->Sphere)
  {
    ParseSphere("--sphere", text, medium);
  }
  for (const std::string& text : this->HeightFog)
  {
    ParseHeightFog("--height-fog", text, medium);
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
