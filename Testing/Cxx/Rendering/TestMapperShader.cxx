// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The text that AirlightMapperShader.h searches for is in the shaders that the installed VTK makes:
// one check for each pattern, in all kinds of content that have it. TestMapperShaderText has the
// rewriting.

#include "AirlightTestContent.h"
#include "AirlightTestShaderCapture.h"
#include "AirlightTestTools.h"
#include "MapperShaders/AirlightMapperShader.h"

#include "vtkCameraPass.h"
#include "vtkContourValues.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPlane.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <cstdlib>
#include <map>
#include <set>

using namespace airlight_test;
using airlight::CountText;
using airlight::MapperPattern;
using airlight::MapperText;

namespace
{
//------------------------------------------------------------------------------
using Fill = std::function<void(Scene&)>;

vtkProperty* AddBall(Scene& scene) { return AddActor(scene, MakeSphere(1.0))->GetProperty(); }

void AddHeadlight(Scene& scene)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  scene.Renderer->AddLight(light);
}

// Two, so that a second number is there.
void AddLamps(Scene& scene)
{
  AddLamp(scene);
  AddLamp(scene, { -2.0, 1.0, 3.0 });
}

vtkVolume* AddDensity(Scene& scene, bool shade = false)
{
  AddVolume<vtkGPUVolumeRayCastMapper>(scene, shade);
  return vtkVolume::SafeDownCast(scene.Renderer->GetVolumes()->GetItemAsObject(0));
}

void AddIsosurface(Scene& scene)
{
  vtkVolume* volume = AddDensity(scene);
  vtkVolumeMapper::SafeDownCast(volume->GetMapper())->SetBlendModeToIsoSurface();
  volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 100.0);
}

void AddSlice(Scene& scene)
{
  vtkVolume* volume = AddDensity(scene);
  vtkVolumeMapper::SafeDownCast(volume->GetMapper())->SetBlendModeToSlice();
  vtkNew<vtkPlane> plane;
  volume->GetProperty()->SetSliceFunction(plane);
}

struct Content
{
  const char* Name;
  Fill Add;
  Fill Light = AddLamps;
};

// What is to be seen is drawn last.
const std::vector<Content> Surfaces = {
  { "polygons", [](Scene& s) { AddBall(s); } },
  { "headlight", [](Scene& s) { AddBall(s); }, AddHeadlight },
  { "directional light", [](Scene& s) { AddBall(s); },
    [](Scene& s) {
      s.AddDirectionalLight({ 1.0, 1.0, 1.0 });
    } },
  { "specular", [](Scene& s) { AddBall(s)->SetSpecular(0.5); } },
  { "translucent", [](Scene& s) { AddBall(s)->SetOpacity(0.5); } },
  { "wireframe", [](Scene& s) { AddBall(s)->SetRepresentationToWireframe(); } },
  { "composite data", AddComposite },
  { "glyphs", [](Scene& s) { AddGlyphs(s, 1.0); } },
};
const std::vector<Content> OtherSurfaces = {
  { "physically based", [](Scene& s) { AddPhysical(s, false); } },
  { "unlit", AddUnlit },
  { "points", [](Scene& s) { AddPoints(s, false); } },
  { "scalars by a texture", AddScalars },
  { "textured", [](Scene& s) { AddTexture(s, 3); } },
  { "spheres", [](Scene& s) { AddPoints(s, true); } },
  { "tubes", AddLines },
  { "point Gaussians", [](Scene& s) { AddGaussians(s, false, 1.0); } },
};
const std::vector<Content> Volumes = {
  { "volume", [](Scene& s) { AddDensity(s); } },
  { "shaded volume", [](Scene& s) { AddDensity(s, true); } },
  { "volume in a headlight", [](Scene& s) { AddDensity(s, true); }, AddHeadlight },
  { "isosurface", AddIsosurface },
  { "slice", AddSlice },
};

// By content.
std::map<std::string, FragmentShader> MakeShaders(const std::vector<Content>& contents)
{
  std::map<std::string, FragmentShader> shaders;
  Scene scene(60, 45);
  for (const Content& content : contents)
  {
    Open(scene);
    content.Light(scene);
    content.Add(scene);
    vtkNew<ShaderCapture> capture;
    vtkNew<vtkCameraPass> pass;
    pass->SetDelegatePass(capture);
    scene.ShowOnce(pass);
    shaders[content.Name] = capture->Last;
  }
  return shaders;
}

//------------------------------------------------------------------------------
std::string GetName(MapperText text)
{
  return airlight::GetMapperPatterns()[static_cast<size_t>(text)].Pattern;
}

std::string GetBody(const std::string& shader)
{
  const auto split = airlight::SplitAtMain(shader);
  return split ? airlight::RemoveComments(split->Body) : "";
}

class Checker
{
public:
  void Check(const std::string& content, MapperText text, const std::string& shader, int wanted,
    size_t light = 0)
  {
    const int found = CountText(shader, text, light);
    airlight_test::Check(found == wanted,
      Text(content, ": ", GetName(text), " is there ", wanted, " times, not ", found));
    this->Checked.insert(text);
  }

  void CheckSome(const std::string& content, MapperText text, const std::string& shader)
  {
    airlight_test::Check(
      airlight::HasText(shader, text), Text(content, ": ", GetName(text), " is there"));
    this->Checked.insert(text);
  }

  void CheckComplete() const
  {
    for (const MapperPattern& pattern : airlight::GetMapperPatterns())
    {
      airlight_test::Check(
        this->Checked.count(pattern.Text) == 1, GetName(pattern.Text) + " has a check");
    }
  }

private:
  std::set<MapperText> Checked;
};

// Every mention of lights' colours is replaced: none in another form.
void CheckLightColours(
  Checker& checker, const std::string& name, MapperText text, std::string shader, const char* plain)
{
  checker.CheckSome(name, text, shader);
  airlight::ReplaceText(shader, text, "");
  Check(shader.find(plain) == std::string::npos, name + ": all colours of lights are found");
}

//------------------------------------------------------------------------------
void CheckCommon(Checker& checker, const std::string& name, const FragmentShader& shader)
{
  checker.Check(name, MapperText::Version, shader.Filled, 1);
  checker.Check(name, MapperText::Main, shader.Filled, 1);
  Check(!GetBody(shader.Filled).empty(), name + ": main() has a body");
}

void CheckSurfaces(Checker& checker)
{
  for (const auto& [name, shader] : MakeShaders(Surfaces))
  {
    const std::string body = GetBody(shader.Filled);
    CheckCommon(checker, name, shader);
    CheckLightColours(checker, name, MapperText::LightColour, body, "lightColor");
    checker.Check(name, MapperText::PhongSum, body, 1);
    checker.Check(name, MapperText::Blending, shader.Filled, 1);
    checker.Check(name, MapperText::Discard, body, 1);
    checker.Check(name, MapperText::TextureLookup, body, 0);
    checker.Check(name, MapperText::FragmentDepth, body, 0);
    checker.Check(name, MapperText::FragmentPosition, shader.Filled, 1);
    for (const MapperText uniform :
      { MapperText::Ambient, MapperText::Diffuse, MapperText::Specular, MapperText::Opacity })
    {
      checker.Check(name, uniform, shader.Filled, 1);
    }
    const bool lamps = name != "headlight" && name != "directional light";
    for (const MapperText uniform : { MapperText::LightPosition, MapperText::LightPositional,
           MapperText::LightConeAngle, MapperText::LightAttenuation })
    {
      checker.Check(name, uniform, shader.Filled, lamps, 0);
      checker.Check(name, uniform, shader.Filled, lamps, 1);
    }
  }
}

//------------------------------------------------------------------------------
void CheckOtherSurfaces(Checker& checker)
{
  auto shaders = MakeShaders(OtherSurfaces);
  for (const auto& [name, shader] : shaders)
  {
    CheckCommon(checker, name, shader);
    checker.Check(name, MapperText::Blending, shader.Filled, 1);
  }
  const std::string physical = GetBody(shaders["physically based"].Filled);
  CheckLightColours(checker, "physically based", MapperText::LightColour, physical, "lightColor");
  checker.Check("physically based", MapperText::PhysicalSum, physical, 1);
  for (const char* name : { "unlit", "points" })
  {
    checker.Check(name, MapperText::LightColour, GetBody(shaders[name].Filled), 0);
    checker.Check(name, MapperText::Discard, GetBody(shaders[name].Filled), 1);
  }
  for (const char* name : { "textured", "scalars by a texture" })
  {
    checker.CheckSome(name, MapperText::TextureLookup, GetBody(shaders[name].Filled));
  }
  for (const char* name : { "spheres", "tubes" })
  {
    checker.CheckSome(name, MapperText::FragmentDepth, GetBody(shaders[name].Filled));
  }
}

//------------------------------------------------------------------------------
bool IsIn(const MapperPattern& pattern)
{
  return VTK_VERSION_NUMBER >= pattern.Since &&
    (pattern.Until == 0 || VTK_VERSION_NUMBER < pattern.Until);
}

void CheckVolumes(Checker& checker)
{
  auto shaders = MakeShaders(Volumes);
  for (const auto& [name, shader] : shaders)
  {
    CheckCommon(checker, name, shader);
    checker.Check(name, MapperText::VolumeDeclarations, shader.Template, 1);
    checker.Check(name, MapperText::VolumeStart, shader.Template, 1);
    checker.Check(name, MapperText::VolumeScale, shader.Filled, 3);
    checker.Check(name, MapperText::VolumeSlice, shader.Filled, name == "slice");
    if (name != "slice")
    {
      checker.CheckSome(name, MapperText::VolumeBlending, shader.Filled);
    }
  }
  const std::string& headlight = shaders["volume in a headlight"].Filled;
  checker.Check("headlight", MapperText::VolumeLighting, headlight, 1);
  checker.Check("headlight", MapperText::VolumeHeadlightColour, headlight, 2);
  const std::string& shaded = shaders["shaded volume"].Filled;
  checker.Check("shaded volume", MapperText::VolumeLighting, shaded, 1);
  for (const MapperText text :
    { MapperText::VolumeLightColour, MapperText::VolumeSortedLightColour })
  {
    const MapperPattern& pattern = airlight::GetMapperPatterns()[static_cast<size_t>(text)];
    Check(airlight::HasText(shaded, text) == IsIn(pattern),
      GetName(text) + " is in the versions of VTK that the table names");
    checker.Check("unlit volume", text, shaders["volume"].Filled, 0);
  }
}
}

//------------------------------------------------------------------------------
int TestMapperShader(int /*argc*/, char* /*argv*/[])
{
  Checker checker;
  CheckSurfaces(checker);
  CheckOtherSurfaces(checker);
  CheckVolumes(checker);
  checker.CheckComplete();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
