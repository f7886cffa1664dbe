// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What is drawn over the fog: translucent planes and splats against the closed formula, each layer
// behind the fog that is before it; and annotations, which are before all fog.

#include "AirlightTestContentFog.h"

#include "vtkPointGaussianMapper.h"
#include "vtkRenderStepsPass.h"
#include "vtkVersionMacros.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// A layer of a known colour over a background, and of known opacity or one that the clear frame
// shows.
struct Layer
{
  glm::dvec3 Colour;
  glm::dvec3 Point; // of its plane
  double Opacity;
  glm::dvec3 Normal{ 0.0, 0.0, 1.0 };

  double GetDistance(const glm::dvec3& direction) const
  {
    return glm::dot(this->Point - Fog::Eye, this->Normal) / glm::dot(direction, this->Normal);
  }
};

const glm::dvec3 Background(0.1, 0.2, 0.3);

// From the background to the front.
glm::dvec3 Blend(Fog& fog, const glm::dvec3& direction, const std::vector<Layer>& layers)
{
  const Fog::Part all = fog.GetPart(direction, Far);
  glm::dvec3 sum = Background * all.Transmittance + all.Airlight;
  for (const Layer& layer : layers)
  {
    const Fog::Part part = fog.GetPart(direction, layer.GetDistance(direction));
    sum += layer.Opacity * (layer.Colour * part.Transmittance + part.Airlight - sum);
  }
  return sum;
}

// In the middle of the picture, which the layers cover.
void CheckLayers(Fog& fog, const std::string& name, double limit, const std::vector<Layer>& layers)
{
  for (const Layer& layer : layers)
  {
    vtkProperty* property = AddActor(fog, MakeSquare(3.0, layer.Point.z))->GetProperty();
    property->SetColor(layer.Colour.x, layer.Colour.y, layer.Colour.z);
    property->SetOpacity(layer.Opacity);
    property->LightingOff();
  }
  const Buffers foggy = fog.Render(true);
  Comparison comparison(name + ", absolute");
  for (int j = 20; j < Fog::PictureHeight - 20; j += 3)
  {
    for (int i = 20; i < Fog::PictureWidth - 20; ++i)
    {
      const glm::dvec3 expected = Blend(fog, Fog::GetDirection(i, j), layers);
      for (int k = 0; k < 3; ++k)
      {
        const double radiance = GetValue(foggy.at("Radiance"), i, j, k);
        comparison.Add(std::abs(radiance - expected[k]), limit,
          [&] { return Text("pixel ", i, ", ", j, ": ", radiance, " for ", expected[k]); });
      }
    }
  }
  Check(comparison.Report(), name);
}

void TestLayers(Fog& fog)
{
  fog.Begin();
  CheckLayers(fog, "translucent plane", 1e-6, { { { 0.9, 0.3, 0.1 }, { 0.0, 0.0, 0.0 }, 0.4 } });
  fog.Begin();
  fog.Renderer->UseDepthPeelingOn();
  // VTK peels into 8 bits: each of the layers and their sum are rounded to 1/255.
  CheckLayers(fog, "translucent planes, peeled", 5e-3,
    { { { 0.9, 0.3, 0.1 }, { 0.0, 0.0, 0.0 }, 0.4 },
      { { 0.1, 0.9, 0.3 }, { 0.0, 0.0, 1.0 }, 0.6 } });
}

//------------------------------------------------------------------------------
// Until 9.3 VTK makes a splat of a triangle that faces the eye. From 9.4 on it draws an ellipse on
// the screen, all of it at the depth of the splat's middle: a plane across where the camera looks.
glm::dvec3 GetSplatNormal(const glm::dvec3& place)
{
  return VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0) ? place - Fog::Eye
                                                         : glm::dvec3(0.0, 0.0, 1.0);
}

// One splat before the background; its opacity in each pixel is what the clear frame shows. A
// delegate draws all opaque geometry at once, splats too.
void CheckSplat(Fog& fog, bool emissive, vtkRenderPass* delegate)
{
  const std::string name = std::string(emissive ? "emissive point gaussian" : "point gaussian") +
    (delegate ? ", delegate" : "");
  fog.Begin();
  fog.Pass->SetDelegatePass(delegate);
  vtkNew<vtkPoints> points;
  const glm::dvec3 place(0.2, 0.1, 0.5);
  points->InsertNextPoint(&place.x);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleFactor(0.4);
  mapper->SetEmissive(emissive);
  vtkActor* actor = AddActor(fog, mapper);
  MakeEmissive(actor);
  glm::dvec3 colour;
  actor->GetProperty()->GetColor(&colour.x);
  const Buffers clear = fog.Render(false);
  const Buffers foggy = fog.Render(true);
  Comparison comparison(name + ", relative");
  double most = 0.0;
  for (int j = 0; j < Fog::PictureHeight; j += 2)
  {
    for (int i = 0; i < Fog::PictureWidth; ++i)
    {
      const glm::dvec3 direction = Fog::GetDirection(i, j);
      const glm::dvec3 added = GetColour(clear.at("Radiance"), i, j) - Background;
      const double opacity = emissive ? 0.0 : added.x / (colour.x - Background.x);
      const Layer layer{ colour, place, opacity, GetSplatNormal(place) };
      glm::dvec3 expected = Blend(fog, direction, { layer });
      if (emissive)
      {
        expected += added * fog.GetPart(direction, layer.GetDistance(direction)).Transmittance;
      }
      most = std::max(most, added.x);
      for (int k = 0; k < 3; ++k)
      {
        const double radiance = GetValue(foggy.at("Radiance"), i, j, k);
        comparison.Add(std::abs(radiance - expected[k]) / expected[k], 1e-4,
          [&] { return Text("pixel ", i, ", ", j, ": ", radiance, " for ", expected[k]); });
      }
    }
  }
  Check(most > 0.3, name + ": it is seen");
  Check(comparison.Report(), name + ": as the formula says");
}

//------------------------------------------------------------------------------
// Where annotations hide the background, be it black or white, they are in fog as they are without.
void TestAnnotations(Fog& fog)
{
  fog.Begin();
  AddAnnotations(fog);
  fog.Renderer->SetPass(nullptr);
  fog.Renderer->SetBackground(0.0, 0.0, 0.0);
  const Picture black = Capture(fog.Window);
  fog.Renderer->SetBackground(1.0, 1.0, 1.0);
  fog.Renderer->GetActors()->GetLastActor()->VisibilityOff(); // the sphere is no annotation
  const Picture white = Capture(fog.Window);
  fog.Renderer->SetPass(fog.Pass);
  fog.Render(true);
  const Picture foggy = Capture(fog.Window);
  int count = 0;
  int largest = 0;
  int changed = 0;
  for (size_t i = 0; i < black.size(); ++i)
  {
    changed += white[i] != foggy[i] ? 1 : 0;
    if (black[i] == white[i])
    {
      ++count;
      largest = std::max(largest, std::abs(white[i] - foggy[i]));
    }
  }
  std::cout << "annotations: " << count << " values, differ by " << largest << "\n";
  Check(count > 500 && changed > 5000, "annotations are seen before fog");
  Check(largest == 0, "annotations are not fogged");
}
}

//------------------------------------------------------------------------------
int TestContentInFogLayers(int, char*[])
{
  Fog fog;
  TestLayers(fog);
  vtkNew<vtkRenderStepsPass> delegate;
  for (bool emissive : { false, true })
  {
    CheckSplat(fog, emissive, nullptr);
    CheckSplat(fog, emissive, delegate);
  }
  fog.Pass->SetDelegatePass(nullptr);
  fog.Renderer->UseHiddenLineRemovalOn(); // for which VTK draws the renderer's own list of props
  CheckSplat(fog, false, nullptr);
  fog.Renderer->UseHiddenLineRemovalOff();
  TestAnnotations(fog);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
