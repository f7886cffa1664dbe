// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Media under a sky in vtkAirlightPass: pixel by pixel against quadrature over all directions; in
// several media, height fog and images of density against vtkAirlightReference. The renderer's
// environment: its texels by direction against VTK's own lighting of a ball, and in the picture;
// errors. What compiles other shaders.

#include "AirlightTestDensity.h"
#include "AirlightTestErrors.h"
#include "AirlightTestPhase.h"
#include "AirlightTestPixelScene.h"
#include "AirlightTestSky.h"

#include "Medium/AirlightConvert.h"
#include "OpenGL/AirlightShaderLibrary.h"
#include "vtkAirlight.h"

#include "vtkOpenGLRenderer.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkTexture.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
SkyRadiance MakeSky(Random& random)
{
  SkyRadiance sky;
  sky.Above = glm::dvec3(0.4, 0.7, 1.2);
  sky.Below = glm::dvec3(0.2, 0.15, 0.0);
  sky.Up = RandomUnit(random);
  for (int i = 0; i < 27; ++i)
  {
    sky.Harmonics[i] = i < 3 ? 1.0 : random.Uniform(-0.1, 0.1);
  }
  return sky;
}

void SetSky(vtkParticipatingMedium* medium, const SkyRadiance& sky)
{
  medium->SetSkyRadiance(&sky.Above.x);
  medium->SetGroundRadiance(&sky.Below.x);
  medium->SetUp(&sky.Up.x);
  medium->SetSkyHarmonics(sky.Harmonics.data());
}

// Some pixels of a frame of one uniform medium, of which rays leave nothing, against the sky that
// the medium should scatter: relative to the sky's largest radiance.
void ComparePixels(PixelScene& scene, const SkyRadiance& sky, double limit, const std::string& what)
{
  const glm::dvec3 sigmaS(2.0, 1.0, 0.5);
  const glm::dvec3 sigmaT(2.5, 1.0, 1.5);
  const glm::dvec3 sigmaA = sigmaT - sigmaS;
  scene.Medium->SetScattering(&sigmaS.x);
  scene.Medium->SetAbsorption(&sigmaA.x);
  scene.Window->Render();
  Comparison comparison(what);
  for (int j = 5; j < PixelScene::Height; j += 12)
  {
    for (int i = 3; i < PixelScene::Width; i += 19)
    {
      const glm::dvec3 expected = sigmaS / sigmaT *
        glm::max(ScatterSky(ReferencePhase(scene.Medium), sky, scene.GetRay(i, j).Direction),
          glm::dvec3(0.0));
      const float* seen = scene.GetPixel("Airlight", i, j);
      for (int c = 0; c < 3; ++c)
      {
        comparison.Add(std::abs(seen[c] - expected[c]), limit,
          [&] { return Text("pixel ", i, " ", j, ": ", seen[c], ", not ", expected[c]); });
      }
    }
  }
  Check(comparison.Report(), what);
}

void TestPixels()
{
  Random random(4301);
  PixelScene scene;
  scene.Renderer->GetActiveCamera()->SetViewAngle(110.0);
  for (const double g : { 0.0, 0.5, 0.85 })
  {
    const SkyRadiance sky = MakeSky(random);
    SetSky(scene.Medium, sky);
    scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
    scene.Medium->SetAnisotropy(g);
    ComparePixels(scene, sky, 2e-5, Text("uniform, g ", g));
  }
  const SkyRadiance sky = MakeSky(random);
  SetSky(scene.Medium, sky);
  scene.Medium->SetPhaseTable(MakeTable(TABLE_SMOOTH));
  scene.Medium->SetPhaseFunctionToTabulated();
  ComparePixels(scene, sky, 2e-5, "uniform, a table");
}

//------------------------------------------------------------------------------
// Smoke of an image, height fog and a box, each with a sky and a phase function of its own.
void TestSeveral()
{
  Random random(4302);
  const vtkSmartPointer<vtkImageData> image =
    MakeDensity(glm::ivec3(16), glm::dvec3(-3, -2, -3), glm::dvec3(3, 3, 3));
  FillCloud(image, 4303);
  DensityScene scene(image);
  scene.Medium->SetScattering(0.5, 0.6, 0.7);
  scene.Medium->SetAbsorption(0.3, 0.3, 0.3);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.7);
  SetSky(scene.Medium, MakeSky(random));
  scene.AddBodies();
  scene.Look({ 0, -1, 9 }, { 0, 0, 0 });
  scene.Compare("smoke alone", 1e-4, 1e-3, false);
  vtkNew<vtkParticipatingMedium> fog;
  fog->SetDensityToExponentialHeight();
  fog->SetScaleHeight(1.5);
  fog->SetReferenceHeight(-2.5);
  fog->SetScattering(0.1, 0.1, 0.1);
  fog->SetPhaseFunctionToRayleigh();
  SetSky(fog, MakeSky(random));
  fog->SetUp(0, 1, 0);
  scene.Pass->AddMedium(fog);
  scene.Reference->AddMedium(fog);
  scene.Compare("smoke in height fog", 1e-4, 1e-3, false);
  vtkNew<vtkParticipatingMedium> box;
  box->SetRegionToBox();
  box->SetBounds(-2, 4, -2.4, 1.0, -3, 3);
  box->SetScattering(0.05, 0.08, 0.12);
  box->SetSkyRadiance(1.0, 0.0, 2.0);
  box->SetPhaseFunctionToMieHazy();
  scene.Pass->SetMedium(fog);
  scene.Pass->AddMedium(box);
  scene.Reference->SetMedium(fog);
  scene.Reference->AddMedium(box);
  scene.AddPointLight({ 0.5, 2.2, -1.5 });
  scene.Compare("height fog and a box, with a lamp", 2e-4, 1e-2, false);
}

//------------------------------------------------------------------------------
// Dark, but for a quadrant that is red and a texel that is green.
vtkSmartPointer<vtkTexture> MakeTexture(bool bytes)
{
  constexpr int width = 8;
  constexpr int height = 4;
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(bytes ? VTK_UNSIGNED_CHAR : VTK_FLOAT, 3);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const double unit = bytes ? 255.0 : 1.0;
  values->Fill(0.0);
  for (int i = 0; i < height * width; ++i)
  {
    const int x = i % width;
    const int y = i / width;
    values->SetComponent(i, 0, unit * (x >= 4 && x < 6 && y >= 2 ? 0.8 : 0.2));
    values->SetComponent(i, 1, x == 1 && y == 1 ? unit : 0.0);
    values->SetComponent(i, 2, unit * 0.4);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn();
  return texture;
}

double DecodeSRGB(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// Its harmonics, by looking texels up for directions in the world, as VTK's shaders do.
SkyRadiance LookUp(vtkTexture* texture, const glm::dvec3& up, const glm::dvec3& right, bool decode)
{
  SkyRadiance sky;
  const glm::dvec3 front = glm::cross(right, up);
  vtkImageData* image = texture->GetInput();
  const int* size = image->GetDimensions();
  SkyRadiance unit;
  constexpr int rows = 400;
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < 2 * rows; ++j)
    {
      const double z = 2.0 * (i + 0.5) / rows - 1.0; // equal areas
      const double azimuth = Pi * (j + 0.5) / rows;
      const double c = std::sqrt(1.0 - z * z);
      const glm::dvec3 w(c * std::cos(azimuth), c * std::sin(azimuth), z);
      const glm::dvec3 own(glm::dot(w, right), glm::dot(w, up), glm::dot(w, front));
      const double u = std::atan2(own.z, own.x) / (2.0 * Pi) + 0.5;
      const double v = std::asin(own.y) / Pi + 0.5;
      const int x = std::min(static_cast<int>(u * size[0]), size[0] - 1);
      const int y = std::min(static_cast<int>(v * size[1]), size[1] - 1);
      for (int k = 0; k < 27; ++k)
      {
        const double value = image->GetScalarComponentAsDouble(x, y, 0, k % 3);
        unit.Harmonics.fill(0.0);
        unit.Harmonics[k] = 1.0;
        sky.Harmonics[k] += 4.0 * Pi / (2.0 * rows * rows) * unit.GetRadiance(w)[k % 3] *
          (decode ? DecodeSRGB(value / 255.0) : value);
      }
    }
  }
  return sky;
}

void TestHarmonics()
{
  Random random(4304);
  const glm::dmat3 axes = RandomAxes(random);
  for (const bool bytes : { false, true })
  {
    const vtkSmartPointer<vtkTexture> texture = MakeTexture(bytes);
    texture->SetUseSRGBColorSpace(bytes);
    const SkyRadiance expected = LookUp(texture, axes[1], axes[0], bytes);
    double found[27];
    // Of other lengths and not at right angles.
    const glm::dvec3 up = 3.0 * axes[1];
    const glm::dvec3 right = 0.5 * axes[0] + 0.2 * axes[1];
    Check(vtkAirlight::EnvironmentHarmonics(texture, &up.x, &right.x, found), "it is computed");
    double worst = 0.0;
    for (int k = 0; k < 27; ++k)
    {
      worst = std::max(worst, std::abs(found[k] - expected.Harmonics[k]));
    }
    std::cout << "harmonics of a texture: worst error " << worst << "\n";
    Check(worst < 1e-3, Text("the harmonics of a texture are off by ", worst));
  }
}

// In the picture: as the same harmonics of the medium's own, and as the texels say.
void TestEnvironment()
{
  Random random(4305);
  const glm::dmat3 axes = RandomAxes(random);
  PixelScene scene;
  const vtkSmartPointer<vtkTexture> texture = MakeTexture(false);
  scene.Renderer->SetEnvironmentTexture(texture);
  scene.Renderer->SetEnvironmentUp(&axes[1].x);
  scene.Renderer->SetEnvironmentRight(&axes[0].x);
  scene.Renderer->GetActiveCamera()->SetViewAngle(110.0);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.6);
  scene.Medium->SetScattering(1.0, 1.0, 1.0);
  scene.Window->Render();
  Check(scene.GetPixel("Airlight", 3, 5)[0] == 0.0f, "without the property nothing is scattered");
  scene.Pass->UseEnvironmentTextureOn();
  SkyRadiance sky = LookUp(texture, axes[1], axes[0], false);
  ComparePixels(scene, sky, 2e-4, "environment");
  const glm::dvec3 up = -axes[0];
  scene.Renderer->SetEnvironmentUp(&up.x);
  scene.Renderer->SetEnvironmentRight(&axes[1].x);
  sky = LookUp(texture, up, axes[1], false);
  ComparePixels(scene, sky, 2e-4, "environment that is turned");
  vtkImageData* image = texture->GetInput();
  image->SetScalarComponentFromDouble(6, 0, 0, 1, 3.0);
  image->Modified();
  sky = LookUp(texture, up, axes[1], false);
  ComparePixels(scene, sky, 2e-4, "environment that has changed");
  // Of the renderer and of the medium add.
  scene.Medium->SetSkyHarmonics(sky.Harmonics.data());
  for (double& harmonic : sky.Harmonics)
  {
    harmonic *= 2.0;
  }
  ComparePixels(scene, sky, 4e-4, "both");
}

//------------------------------------------------------------------------------
// The irradiance by the harmonics (Ramamoorthi and Hanrahan 2001) over a white ball that VTK lights
// with the environment: correlated, since VTK adds a highlight.
void TestOrientation()
{
  Random random(4306);
  const glm::dmat3 axes = RandomAxes(random);
  PixelScene scene;
  scene.Renderer->SetPass(nullptr);
  const vtkSmartPointer<vtkTexture> texture = MakeTexture(false);
  scene.Renderer->SetEnvironmentTexture(texture);
  scene.Renderer->SetEnvironmentUp(&axes[1].x);
  scene.Renderer->SetEnvironmentRight(&axes[0].x);
  scene.Renderer->UseImageBasedLightingOn();
  scene.Renderer->AutomaticLightCreationOff();
  // Highlights that VTK 9.1 fails to draw into smaller faces of the map.
  vtkOpenGLRenderer::SafeDownCast(scene.Renderer)->GetEnvMapPrefiltered()->SetPrefilterLevels(1);
  vtkNew<vtkPolyDataMapper> mapper;
  const vtkSmartPointer<vtkPolyData> ball = MakeSphere(1.0);
  mapper->SetInputData(ball);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetRoughness(1.0);
  actor->GetProperty()->SetMetallic(0.0);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  scene.Renderer->AddActor(actor);
  double c[27];
  vtkAirlight::EnvironmentHarmonics(texture, &axes[1].x, &axes[0].x, c);
  const double weights[9] = { 1.0, 2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 0.25, 0.25, 0.25, 0.25, 0.25 };
  SkyRadiance irradiance;
  for (int i = 0; i < 27; ++i)
  {
    irradiance.Harmonics[i] = weights[i / 3] * c[i];
  }
  std::vector<glm::dvec3> drawn;
  std::vector<glm::dvec3> expected;
  for (const glm::dvec3& from : { axes[0], axes[1], axes[2], -axes[0], -axes[1], -axes[2] })
  {
    const glm::dvec3 eye = 4.0 * glm::normalize(from + 0.1 * RandomUnit(random));
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(&eye.x);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0.3, 0.5, 0.8);
    scene.Renderer->ResetCameraClippingRange();
    const Picture picture = Capture(scene.Window);
    const int pixel = 3 * (PixelScene::Height / 2 * PixelScene::Width + PixelScene::Width / 2);
    const glm::dvec3 colour(picture[pixel], picture[pixel + 1], picture[pixel + 2]);
    drawn.push_back(glm::pow(colour / 255.0, glm::dvec3(2.2)));
    expected.push_back(irradiance.GetRadiance(glm::normalize(eye)));
    std::cout << "lit " << drawn.back().x << " " << drawn.back().y << ", irradiance "
              << expected.back().x << " " << expected.back().y << "\n";
  }
  for (int k = 0; k < 2; ++k)
  {
    double xy = 0.0, xx = 0.0, yy = 0.0, x = 0.0, y = 0.0;
    const double n = static_cast<double>(drawn.size());
    for (size_t i = 0; i < drawn.size(); ++i)
    {
      xy += drawn[i][k] * expected[i][k] / n;
      xx += drawn[i][k] * drawn[i][k] / n;
      yy += expected[i][k] * expected[i][k] / n;
      x += drawn[i][k] / n;
      y += expected[i][k] / n;
    }
    const double correlation = (xy - x * y) / std::sqrt((xx - x * x) * (yy - y * y));
    std::cout << "correlation with VTK's lighting " << correlation << "\n";
    Check(correlation > 0.99, Text("it is oriented as in VTK: correlation ", correlation));
  }
}

//------------------------------------------------------------------------------
void TestErrors()
{
  PixelScene scene;
  ErrorListener errors(scene.Pass);
  scene.Medium->SetScattering(1.0, 1.0, 1.0);
  scene.Pass->UseEnvironmentTextureOn();
  scene.Window->Render();
  Check(errors.Take() == 1 && errors.GetText().find("SetEnvironmentTexture") != std::string::npos,
    "no texture: " + errors.GetText());
  scene.Window->Render();
  Check(errors.Take() == 0, "it is said once");
  const vtkSmartPointer<vtkTexture> texture = MakeTexture(false);
  texture->CubeMapOn();
  for (int i = 1; i < 6; ++i)
  {
    texture->SetInputData(i, texture->GetInput());
  }
  scene.Renderer->SetEnvironmentTexture(texture);
  scene.Window->Render();
  Check(errors.Take() == 1 && errors.GetText().find("CubeMapOff()") != std::string::npos,
    "a cube map: " + errors.GetText());
  Check(scene.GetPixel("Airlight", 3, 5)[2] == 0.0f, "it lights nothing");
  texture->CubeMapOff();
  scene.Renderer->SetEnvironmentUp(0.0, 0.0, 0.0);
  scene.Window->Render();
  Check(errors.Take() == 1 && errors.GetText().find("up (0") != std::string::npos,
    "no axis: " + errors.GetText());
  scene.Renderer->SetEnvironmentUp(0.0, 1.0, 0.0);
  vtkDataArray* values = texture->GetInput()->GetPointData()->GetScalars();
  values->SetComponent(3, 0, std::nan(""));
  values->SetComponent(4, 0, -7.0);
  texture->GetInput()->Modified();
  scene.Window->Render();
  const float red = scene.GetPixel("Airlight", 3, 5)[0];
  Check(errors.Take() == 0 && red > 0.0f && red < 1.0f, Text("bad texels are dark: ", red));
}

//------------------------------------------------------------------------------
void TestShaders()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(1.0, 1.0, 1.0);
  medium->SetAmbientRadiance(1.0, 1.0, 1.0);
  const auto getText = [&medium] {
    return airlight::GetScatteringSource(
      airlight::ConvertMedia({ medium }, glm::dvec3(0.0)), -1, false);
  };
  const std::string without = getText();
  Check(without.find("AirlightSky sky") == std::string::npos ||
      without.find("#define AIRLIGHT_HAS_SKY") == std::string::npos,
    "without a sky there is none in shaders");
  medium->SetSkyRadiance(1.0, 2.0, 3.0);
  const std::string with = getText();
  Check(with != without, "a sky is another shader");
  medium->SetGroundRadiance(0.5, 0.2, 0.3);
  medium->SetSkyRadiance(0.9, 0.2, 0.3);
  Check(with == getText(), "another sky is not");
  medium->SetGroundRadiance(0.9, 0.2, 0.3);
  Check(without == getText(), "two equal colours are no sky");
}
}

//------------------------------------------------------------------------------
int TestSkyPass(int, char*[])
{
  TestPixels();
  TestSeveral();
  TestHarmonics();
  TestEnvironment();
  TestOrientation();
  TestErrors();
  TestShaders();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
