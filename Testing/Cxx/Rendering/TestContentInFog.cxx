// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Every kind of content in fog: in each pixel C T(t) + L(0, t), with C what the same pixel shows in
// clear air, t its recorded distance, and T and L from vtkAirlight in double precision.

#include "AirlightTestContentFog.h"

#include "Scene/AirlightVTKVersions.h"
#include "vtkAxesActor.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkPropCollection.h"
#include "vtkSkybox.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
struct Content
{
  const char* Name;
  std::function<void(Fog&)> Add;
  double Plane = Far; // z of all that is seen, where it has one
};

void AddEmissive(Fog& fog, const std::function<void(Scene&)>& add)
{
  add(fog);
  vtkActorCollection* actors = fog.Renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    MakeEmissive(actor);
  }
}

const std::vector<Content> Contents = {
  { "lit", [](Fog& f) { AddActor(f, MakeSquare(1.0, -0.5)); }, -0.5 },
  { "physically based",
    [](Fog& f) {
      vtkProperty* property = AddActor(f, MakeSquare(1.0, 0.5))->GetProperty();
      property->SetInterpolationToPBR();
      property->SetRoughness(0.4);
    },
    0.5 },
  { "unlit", [](Fog& f) { AddActor(f, MakeSquare(1.0, 1.0))->GetProperty()->LightingOff(); }, 1.0 },
  { "texture",
    [](Fog& f) {
      vtkActor* actor = AddActor(f, MakeSquare(1.0));
      actor->SetTexture(MakeTexture(3));
      MakeEmissive(actor);
    },
    0.0 },
  { "lines and points",
    [](Fog& f) {
      for (int i = 0; i < 3; ++i)
      {
        vtkActor* actor = AddActor(f, MakeSquare(1.2 - 0.3 * i, 0.7));
        MakeEmissive(actor);
        actor->GetProperty()->SetRepresentation(i == 0 ? VTK_POINTS : VTK_WIREFRAME);
        actor->GetProperty()->SetPointSize(7.0f);
        actor->GetProperty()->SetLineWidth(1.0f + 3.0f * static_cast<float>(i));
      }
    },
    0.7 },
  { "lines and tubes", [](Fog& f) { AddEmissive(f, AddLines); } },
  { "composite",
    [](Fog& f) {
      AddEmissive(f, [](Scene& t) {
        AddComposite(t);
        auto* mapper = airlight::BlocksMapper::SafeDownCast(
          t.Renderer->GetActors()->GetLastActor()->GetMapper());
        mapper->GetCompositeDataDisplayAttributes()->RemoveBlockOpacities();
      });
    } },
  { "glyphs", [](Fog& f) { AddEmissive(f, [](Scene& t) { AddGlyphs(t, 1.0); }); } },
  { "scalars", [](Fog& f) { AddEmissive(f, AddScalars); } },
  { "skybox",
    [](Fog& f) {
      vtkNew<vtkSkybox> box;
      box->SetTexture(MakeCubeMap());
      f.Renderer->AddActor(box);
      AddActor(f, MakeSphere(1.0))->GetProperty()->LightingOff();
    } },
  { "axes, followers",
    [](Fog& f) {
      vtkNew<vtkAxesActor> axes;
      vtkNew<vtkPropCollection> arrows;
      axes->GetActors(arrows);
      for (int i = 0; i < arrows->GetNumberOfItems(); ++i)
      {
        MakeEmissive(vtkActor::SafeDownCast(arrows->GetItemAsObject(i)));
      }
      f.Renderer->AddActor(axes);
      AddFollower(f);
      MakeEmissive(vtkActor::SafeDownCast(f.Renderer->GetActors()->GetLastActor()));
    } },
};

//------------------------------------------------------------------------------
struct Comparisons
{
  explicit Comparisons(const std::string& name)
    : Radiance(name + ": Radiance, relative")
    , Airlight(name + ": Airlight, relative")
    , Transmittance(name + ": Transmittance, absolute")
    , Range(name + ": Depth, among the contents (0) or not (1)")
    , Depth(name + ": Depth of the plane, relative")
  {
  }
  Comparison Radiance;
  Comparison Airlight;
  Comparison Transmittance;
  Comparison Range;
  Comparison Depth;
};

void ComparePixel(Fog& fog, const Content& content, const Buffers& clear, const Buffers& foggy,
  int i, int j, Comparisons& comparisons)
{
  const double depth = GetValue(foggy.at("Depth"), i, j);
  const glm::dvec3 direction = Fog::GetDirection(i, j);
  const Fog::Part part = fog.GetPart(direction, depth >= 0.0 ? depth : Far);
  const auto describe = [&] { return Text("pixel ", i, ", ", j, ", distance ", depth); };
  const glm::dvec3 colour = GetColour(clear.at("Radiance"), i, j);
  const glm::dvec3 radiance = GetColour(foggy.at("Radiance"), i, j);
  for (int k = 0; k < 3; ++k)
  {
    const double expected = colour[k] * part.Transmittance[k] + part.Airlight[k];
    comparisons.Radiance.Add(std::abs(radiance[k] - expected) / expected, 1e-4, describe);
    comparisons.Airlight.Add(
      std::abs(GetValue(foggy.at("Airlight"), i, j, k) - part.Airlight[k]) / part.Airlight[k], 1e-4,
      describe);
    comparisons.Transmittance.Add(
      std::abs(GetValue(foggy.at("Transmittance"), i, j, k) - part.Transmittance[k]), 2e-6,
      describe);
  }
  comparisons.Range.Add(depth == -1.0 || (depth > 5.0 && depth < 15.0) ? 0.0 : 1.0, 0.5, describe);
  if (depth >= 0.0 && content.Plane < Far)
  {
    const double expected = (content.Plane - Fog::Eye.z) / direction.z;
    comparisons.Depth.Add(std::abs(depth - expected) / expected, 1e-5, describe);
  }
}

void CheckContent(Fog& fog, const Content& content)
{
  fog.Begin();
  content.Add(fog);
  const Buffers clear = fog.Render(false);
  const Buffers foggy = fog.Render(true);
  Check(AreSame(clear.at("Depth"), foggy.at("Depth")),
    std::string(content.Name) + ": the medium moves nothing");
  Comparisons comparisons(content.Name);
  for (int j = 0; j < Fog::PictureHeight; j += 2)
  {
    for (int i = 0; i < Fog::PictureWidth; ++i)
    {
      ComparePixel(fog, content, clear, foggy, i, j, comparisons);
    }
  }
  Check(AllOk({ &comparisons.Radiance, &comparisons.Airlight, &comparisons.Transmittance,
          &comparisons.Range }),
    std::string(content.Name) + ": as the formula says");
  if (content.Plane < Far)
  {
    Check(comparisons.Depth.Report(), std::string(content.Name) + ": where it is");
  }
}
}

//------------------------------------------------------------------------------
int TestContentInFog(int, char*[])
{
  Fog fog;
  for (const Content& content : Contents)
  {
    CheckContent(fog, content);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
