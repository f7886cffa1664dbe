// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/SceneOptions.h"

#include "commands/MediumText.h"
#include "commands/OptionText.h"
#include "formats/Files.h"
#include "formats/ModelReader.h"
#include "formats/UserError.h"
#include "scene/MediumFile.h"
#include "scene/ModelLights.h"
#include "scene/ModelView.h"
#include "scene/Mood.h"
#include "scene/PhaseName.h"

#include <vtkParticipatingMedium.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace airlight
{

namespace
{
constexpr double Largest = std::numeric_limits<double>::max();
constexpr double Smallest = std::numeric_limits<double>::min();

const char* const Description = R"(Lengths are in world units, colours linear.
A model stands on its own. Its camera and lamps are those of its file (.gltf, .glb, .3ds; .wrl has
directional lights), or else the camera sees all of it, and would as it turns, from the front, the
right and above, a point lamp hangs behind it, above and to the left, and a dimmer light falls on
its surfaces alone. With the mood mist the medium is unbounded, scatters forward and does not
absorb, with a visibility of 20 times the diagonal of the box around the model. The options change
all of that. Lines are drawn as tubes, points as beads.
Over a scene file, --point, --spot and --sun replace all of its lamps and add up with each other,
and the options --ies, --ies-aim, --ies-up, --lamp-radius, --lamp-size and --sun-diameter change
the lamp before them on the command line; any other option replaces what it names and leaves the
rest as the file has it.)";

// An option with one value, which leaves the words after it to others.
CLI::Option* AddText(
  CLI::App* command, const char* name, std::vector<std::string>& texts, const std::string& help)
{
  return command->add_option(name, texts, help)->expected(1)->allow_extra_args(false);
}

const std::map<std::string, int> Techniques = {
  { "Automatic", vtkAirlightPass::AUTOMATIC },
  { "ShadowPlanes", vtkAirlightPass::SHADOW_PLANES },
  { "ShadowMap", vtkAirlightPass::SHADOW_MAP },
  { "RayMarch", vtkAirlightPass::RAY_MARCH },
  { "None", vtkAirlightPass::NONE },
};

std::vector<std::string> GetTechniqueNames()
{
  std::vector<std::string> names;
  names.reserve(Techniques.size());
  for (const auto& technique : Techniques)
  {
    names.push_back(technique.first);
  }
  return names;
}

// To what is wrong with a file, add the option that names it.
template <typename Task>
void UseFile(const char* option, const std::string& file, const Task& task)
{
  try
  {
    task(file);
  }
  catch (const UserError& error)
  {
    throw UserError(std::string(option) + " " + error.what());
  }
}
}

//------------------------------------------------------------------------------
const std::string& GetTechniqueName(int technique)
{
  static const std::string froxels = "Froxels"; // which nobody requests
  if (technique == vtkAirlightPass::FROXELS)
  {
    return froxels;
  }
  return std::find_if(Techniques.begin(), Techniques.end(), [technique](const auto& entry) {
    return entry.second == technique;
  })->first;
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
  this->AddModelOptions(command);
  this->Lights.AddTo(command);
  for (const char* lamp : { "--point", "--spot", "--sun" })
  {
    command->get_option("--light-from")->excludes(command->get_option(lamp));
  }
  this->AddMediumOptions(command);
}

//------------------------------------------------------------------------------
void SceneOptions::AddModelOptions(CLI::App* command)
{
  this->ModelOptions = {
    command
      ->add_option("--light-from", this->Choices.LightFrom,
        "Where the lamp of a model on its own is; inside is for models with openings (default: the "
        "lamps of the file, in proportion, or else behind)")
      ->check(CLI::IsMember(GetLampPlaces())),
    command
      ->add_option("--mood", this->Choices.Mood,
        "Air and colours of a model on its own; other options change parts of them")
      ->check(CLI::IsMember(GetMoodNames()))
      ->capture_default_str(),
    command->add_flag("--facets", this->Choices.KeepFacets,
      "Keep the triangles of a coarse model on its own as they are: .ply, .stl, .vtp, .vtk, .vtu "
      "and "
      ".obj without materials are curved as their normals say otherwise, and .gltf, .glb, .3ds and "
      ".obj with materials get smooth normals where they have none"),
    command
      ->add_option("--up", this->Choices.Up,
        "Direction that is up in a model on its own whose file has no camera (default: z of .stl "
        "and .3ds, y of all others)")
      ->check(CLI::IsMember(GetUpNames())),
  };
}

//------------------------------------------------------------------------------
void SceneOptions::AddMediumOptions(CLI::App* command)
{
  std::vector<CLI::Option*> options = this->Lights.GetPassOptions();
  const auto add = [command, &options](const char* name, Text& text, const char* help) {
    options.push_back(AddText(command, name, text, help));
  };
  add("--scattering", this->Scattering, "r,g,b: scattering coefficient per world unit");
  add("--absorption", this->Absorption, "r,g,b: absorption coefficient per world unit");
  add("--visibility", this->Visibility,
    "Distance in world units at which a black object's contrast falls to 2 %; scales the "
    "coefficients");
  this->AddPhaseOptions(command, options);
  add("--ambient", this->Ambient,
    "r,g,b: ambient radiance in W/(m^2 sr) that the medium scatters (default that of the scene or "
    "the mood)");
  options.push_back(command->add_flag("--multiple-scattering", this->MultipleScattering,
    "Compute light that is scattered more than once, too, of point lamps inside a uniform medium, "
    "instead of the ambient radiance"));
  this->AddRegionOptions(command, options);
  add("--height-fog", this->HeightFog,
    "REFERENCE:SCALE[:ux,uy,uz]: the medium thins out with height and has its coefficients at the "
    "height REFERENCE, 1/e of them SCALE above it; heights are along ux,uy,uz from the origin "
    "(default 0,1,0)");
  options.push_back(command->add_flag("--glow", this->Glow,
    "Light surfaces also by the light that the medium scatters onto them; slow without a graphics "
    "card"));
  options.push_back(command->add_option("--technique", this->Technique, "Shadow technique")
                      ->check(CLI::IsMember(GetTechniqueNames()))
                      ->capture_default_str());
  options.push_back(command
                      ->add_option("--steps", this->Steps,
                        "Steps along each ray of the techniques ShadowMap and RayMarch")
                      ->check(CLI::Range(1, 2048))
                      ->capture_default_str());
  CLI::Option* noMedium = command->add_flag(
    "--no-medium", this->NoMedium, "VTK's plain lighting: no medium and no shadows");
  for (CLI::Option* option : options)
  {
    noMedium->excludes(option);
  }
}

//------------------------------------------------------------------------------
void SceneOptions::AddPhaseOptions(CLI::App* command, std::vector<CLI::Option*>& options)
{
  CLI::Option* anisotropy = AddText(command, "--anisotropy", this->Anisotropy,
    "Mean cosine g of the Henyey-Greenstein phase function, -0.99 to 0.99, above 0 forward; 0 is "
    "isotropic");
  CLI::Option* phase = AddText(command, "--phase", this->Phase,
    "Phase function, one of " + ListPhaseForms() +
      "; g and k are from -0.99 to 0.99, above 0 forward");
  CLI::Option* table = AddText(command, "--phase-table", this->PhaseTable,
    "FILE: measured phase function, lines of angle,value: the scattering angle in degrees, "
    "ascending from 0 (forward) to 180, and a value above 0 in any unit");
  anisotropy->excludes(phase)->excludes(table);
  phase->excludes(table);
  options.insert(options.end(), { anisotropy, phase, table });
}

//------------------------------------------------------------------------------
void SceneOptions::AddRegionOptions(CLI::App* command, std::vector<CLI::Option*>& options)
{
  CLI::Option* box = AddText(command, "--box", this->Box,
    "xmin,xmax,ymin,ymax,zmin,zmax: the medium fills this box, with vacuum around it");
  CLI::Option* sphere = AddText(command, "--sphere", this->Sphere,
    "x,y,z:R: the medium fills this sphere of centre x,y,z and radius R, with vacuum around it");
  CLI::Option* cylinder = AddText(command, "--cylinder", this->Cylinder,
    "x,y,z:R:H[:ax,ay,az]: the medium fills this cylinder of centre x,y,z, radius R, height H and "
    "axis ax,ay,az (default 0,1,0), with vacuum around it");
  CLI::Option* surface = AddText(command, "--surface", this->Surface,
    "FILE: the medium fills this closed mesh, any kind of model, with vacuum around it");
  box->excludes(sphere)->excludes(cylinder)->excludes(surface);
  sphere->excludes(cylinder)->excludes(surface);
  cylinder->excludes(surface);
  options.insert(options.end(), { box, sphere, cylinder, surface });
}

//------------------------------------------------------------------------------
Scene SceneOptions::Load() const
{
  for (const std::string& file : this->Surface) // before the first file is read
  {
    UseFile("--surface", file, CheckModelFile);
  }
  for (const CLI::Option* option : this->ModelOptions)
  {
    if (option->count() > 0 && GetExtension(this->FileName) == "json")
    {
      throw UserError(option->get_name() + ": expected a model, not a scene file (" +
        this->FileName + "), which has lamps and a medium of its own");
    }
  }
  if (this->Choices.KeepFacets && GetExtension(this->FileName) == "wrl")
  {
    throw UserError("--facets: " + this->FileName + " is drawn as it is: leave out --facets");
  }
  ModelChoices choices = this->Choices;
  for (const std::string& text : this->Size)
  {
    const auto [width, height] = ParseSize("--size", text);
    choices.Aspect = static_cast<double>(width) / height;
  }
  Scene scene = ReadSceneOrModel(this->FileName, choices);
  for (const std::string& text : this->Size)
  {
    std::tie(scene.Width, scene.Height) = ParseSize("--size", text);
  }
  for (const std::string& text : this->Camera)
  {
    scene.Camera = ParseCamera("--camera", text, scene.Camera);
  }
  std::vector<LightSource> lights = this->Lights.Read();
  if (!lights.empty())
  {
    scene.Lights = std::move(lights);
  }
  this->ChangeMedium(scene.Medium);
  scene.ScatteredSurfaceLight = scene.ScatteredSurfaceLight || this->Glow;
  return scene;
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
  this->ChangePhase(medium);
  for (const std::string& text : this->Ambient)
  {
    medium->SetAmbientRadiance(ParseColor("--ambient", text).data());
  }
  medium->SetMultipleScattering(medium->GetMultipleScattering() || this->MultipleScattering);
  this->ChangeRegion(medium);
  for (const std::string& text : this->HeightFog)
  {
    ParseHeightFog("--height-fog", text, medium);
  }
}

//------------------------------------------------------------------------------
void SceneOptions::ChangePhase(vtkParticipatingMedium* medium) const
{
  for (const std::string& text : this->Anisotropy)
  {
    medium->SetPhaseFunctionToHenyeyGreenstein();
    medium->SetAnisotropy(ParseNumber("--anisotropy", text, -MaximumAnisotropy, MaximumAnisotropy));
  }
  for (const std::string& text : this->Phase)
  {
    ParsePhase("--phase", text, medium);
  }
  for (const std::string& file : this->PhaseTable)
  {
    UseFile("--phase-table", file, [medium](const auto& name) { ReadPhaseTable(name, medium); });
  }
}

//------------------------------------------------------------------------------
void SceneOptions::ChangeRegion(vtkParticipatingMedium* medium) const
{
  for (const std::string& text : this->Box)
  {
    ParseBox("--box", text, medium);
  }
  for (const std::string& text : this->Sphere)
  {
    ParseSphere("--sphere", text, medium);
  }
  for (const std::string& text : this->Cylinder)
  {
    ParseCylinder("--cylinder", text, medium);
  }
  for (const std::string& file : this->Surface)
  {
    UseFile("--surface", file, [medium](const auto& name) { ReadMediumSurface(name, medium); });
  }
}

//------------------------------------------------------------------------------
RenderSettings SceneOptions::GetSettings() const
{
  RenderSettings settings;
  settings.UseMedium = !this->NoMedium;
  settings.ShadowTechnique = Techniques.at(this->Technique);
  settings.Steps = this->Steps;
  return settings;
}

}
