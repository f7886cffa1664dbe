// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// From radiance to the screen: each step against its formula on the recorded radiance, which is
// decoded again from what the window shows; tone mapping against vtkToneMappingPass; glows have no
// rings of 8-bit steps; exposure that follows the picture.

#include "AirlightTestErrors.h"
#include "AirlightTestWindowScene.h"
#include "Frame/AirlightExposureMeter.h"

#include "vtkLightCollection.h"
#include "vtkToneMappingPass.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

using namespace airlight_test;

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

// IEC 61966-2-1, from the screen to radiance.
double DecodeSRGB(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double DecodeLinear(double value) { return value; }

double DecodeGamma(double value) { return std::pow(std::max(value, 0.0), 2.2); }

// A picture of the recorded radiance: how far beyond half a step of 8 bits it is at most, in steps,
// and how many values are neither black nor white.
void CheckDecoded(const std::string& name, Scene& scene, double (*decode)(double), double exposure)
{
  const Picture picture = Capture(scene.Window);
  const double allowed = scene.Pass->GetDithering() ? 1.0 : 0.5;
  double worst = 0.0;
  int middle = 0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const glm::dvec3 radiance =
      exposure * GetColour(scene.GetBuffer("Radiance"), i % scene.Width, i / scene.Width);
    for (int k = 0; k < 3; ++k)
    {
      const double shown = picture[3 * i + k];
      // The radiances that round to this value, with the rounding of single precision.
      const double least = shown > 0.0 ? decode((shown - allowed) / 255.0) : -1.0;
      const double most = shown < 255.0 ? decode((shown + allowed) / 255.0) : 1e30;
      const double step = (decode((shown + 0.5) / 255.0) - decode((shown - 0.5) / 255.0));
      worst = std::max({ worst, (least - radiance[k]) / step, (radiance[k] - most) / step });
      middle += shown > 0.0 && shown < 255.0 ? 1 : 0;
    }
  }
  std::cout << name << ": " << worst << " steps beyond, " << middle << " values\n";
  Check(worst < 1e-2, name + ": a pixel decodes to its radiance");
  Check(middle > scene.Width * scene.Height, name + ": enough values are between black and white");
}

void TestColorSpaces()
{
  WindowScene scene(Width, Height, 2);
  for (const bool dithering : { false, true })
  {
    scene.Pass->SetDithering(dithering);
    const std::string suffix = dithering ? ", dithered" : "";
    scene.Pass->SetOutputColorSpaceToSRGB();
    CheckDecoded("sRGB" + suffix, scene, DecodeSRGB, 1.0);
    scene.Pass->SetExposure(3.0);
    CheckDecoded("sRGB, three times as bright" + suffix, scene, DecodeSRGB, 3.0);
    scene.Pass->SetOutputColorSpaceToLinear();
    CheckDecoded("linear, three times as bright" + suffix, scene, DecodeLinear, 3.0);
    Check(scene.Pass->GetEffectiveExposure() == 3.0, "the exposure that was set");
    scene.Pass->SetSubpixelFrames(2);
    CheckDecoded("linear, three times as bright, mean" + suffix, scene, DecodeLinear, 3.0);
    Check(scene.Pass->GetEffectiveExposure() == 3.0, "the exposure of a mean");
    scene.Pass->SetSubpixelFrames(1);
    scene.Pass->SetExposure(1.0);
    scene.Pass->SetOutputColorSpaceToGamma22();
    CheckDecoded("gamma" + suffix, scene, DecodeGamma, 1.0);
    scene.Ball->GetProperty()->SetOpacity(0.5);
    CheckDecoded("gamma, translucent" + suffix, scene, DecodeGamma, 1.0);
    scene.Pass->SetSubpixelFrames(4);
    CheckDecoded("gamma, mean" + suffix, scene, DecodeGamma, 1.0);
    scene.Pass->SetSubpixelFrames(1);
    scene.Ball->GetProperty()->SetOpacity(1.0);
  }
}

// A window with UseSRGBColorSpace: what VTK reads back from it is what the pass gives, encoded
// once, or not at all where VTK's windows encode.
void TestWindowsOfSRGB()
{
  for (const int samples : { 0, 8 })
  {
    WindowScene scene(Width, Height, 2);
    scene.Window->SetMultiSamples(samples);
    scene.Window->SetUseSRGBColorSpace(true);
    scene.Pass->SetOutputColorSpaceToLinear();
    CheckDecoded("linear in a window of sRGB", scene, DecodeLinear, 1.0);
    scene.Pass->SetOutputColorSpaceToSRGB();
    scene.Pass->SetExposure(2.0);
    CheckDecoded("sRGB in a window of sRGB", scene, DecodeSRGB, 2.0);
    scene.Pass->DitheringOff();
    scene.Pass->SetSubpixelFrames(2);
    CheckDecoded("sRGB in a window of sRGB, mean", scene, DecodeSRGB, 2.0);
  }
}

// Onto the screen, such a window encodes what it is given.
void TestEncodedTwice()
{
  for (const bool uses : { false, true })
  {
    WindowScene scene(Width, Height, 1);
    ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
    scene.Window->SetUseSRGBColorSpace(uses);
    scene.Pass->SetOutputColorSpaceToSRGB();
    scene.Render();
    Check(warnings.Take() == 0, "no warning off the screen");
    scene.Window->SetUseOffScreenBuffers(false); // as of a window on the screen
    scene.Pass->SetOutputColorSpaceToLinear();
    scene.Render();
    Check(warnings.Take() == 0, "no warning of a linear picture");
    scene.Pass->SetOutputColorSpaceToSRGB();
    scene.Render();
    scene.Render();
    const bool names =
      warnings.Take() == 1 && warnings.GetText().find("Linear") != std::string::npos;
    Check(names == uses, "one warning of colours that are encoded twice");
  }
}

//------------------------------------------------------------------------------
// VTK's pass reads what the pass has encoded, maps it in linear light, and encodes it again.
// VTK's pass leaves the background out, by its opacity.
int CompareSurfaces(Scene& scene, const Picture& a, const Picture& b)
{
  int worst = 0;
  for (int i = 0; i < 3 * scene.Width * scene.Height; ++i)
  {
    const bool surface =
      GetValue(scene.GetBuffer("Depth"), i / 3 % scene.Width, i / 3 / scene.Width) >= 0.0;
    worst = std::max(worst, surface ? std::abs(a[i] - b[i]) : 0);
  }
  return worst;
}

void TestToneMapping()
{
  WindowScene scene(Width, Height, 2);
  scene.Pass->DitheringOff();
  scene.Pass->SetOutputColorSpaceToGamma22();
  const std::pair<int, const char*> curves[] = { { vtkAirlightPass::CLAMP, "Clamp" },
    { vtkAirlightPass::REINHARD, "Reinhard" }, { vtkAirlightPass::EXPONENTIAL, "Exponential" },
    { vtkAirlightPass::GENERIC_FILMIC, "GenericFilmic" } };
  std::vector<Picture> pictures;
  for (const auto& curve : curves)
  {
    vtkNew<vtkToneMappingPass> tone;
    tone->SetToneMappingType(curve.first);
    tone->SetDelegatePass(scene.Pass);
    scene.Pass->SetToneMappingToClamp();
    const Picture expected = scene.ShowOnce(tone);
    scene.Pass->SetToneMapping(curve.first);
    pictures.push_back(scene.Show(scene.Pass));
    const int worst = CompareSurfaces(scene, expected, pictures.back());
    std::cout << curve.second << ": within " << worst << "/255 of VTK's\n";
    Check(worst <= 1, std::string(curve.second) + " is VTK's");
  }
  for (size_t i = 1; i < pictures.size(); ++i)
  {
    Check(Compare(pictures[0], pictures[i]) > 8, "the curves differ");
  }
}

// Khronos PBR Neutral, as its authors state it.
double MapNeutral(glm::dvec3 colour, int k)
{
  const double x = std::min({ colour.x, colour.y, colour.z });
  colour -= x < 0.08 ? x - 6.25 * x * x : 0.04;
  const double peak = std::max({ colour.x, colour.y, colour.z });
  if (peak < 0.76)
  {
    return colour[k];
  }
  const double newPeak = 1.0 - 0.24 * 0.24 / (peak + 0.24 - 0.76);
  const double grey = 1.0 - 1.0 / (0.15 * (peak - newPeak) + 1.0);
  return colour[k] * newPeak / peak * (1.0 - grey) + newPeak * grey;
}

void TestNeutral()
{
  WindowScene scene(Width, Height, 2);
  scene.Pass->DitheringOff();
  scene.Pass->SetExposure(2.0);
  scene.Pass->SetToneMappingToNeutralPBR();
  const Picture picture = Capture(scene.Window);
  double worst = 0.0;
  int bright = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const glm::dvec3 radiance = 2.0 * GetColour(scene.GetBuffer("Radiance"), i % Width, i / Width);
    bright += std::max({ radiance.x, radiance.y, radiance.z }) > 1.0 ? 1 : 0;
    for (int k = 0; k < 3; ++k)
    {
      worst = std::max(worst, std::abs(picture[3 * i + k] - 255.0 * MapNeutral(radiance, k)));
    }
  }
  std::cout << "NeutralPBR: " << worst << "/255, " << bright << " bright pixels\n";
  Check(worst < 0.51, "NeutralPBR is its formula");
  Check(bright > 100, "of radiances above 1, too");
}

//------------------------------------------------------------------------------
// A wide glow with nothing before it.
class Glow : public Scene
{
public:
  Glow()
    : Scene(480, 120)
  {
    this->AddPointLight({ 0, 0, -5 }, { 90.0, 70.0, 50.0 });
    this->Medium->SetScattering(0.02, 0.02, 0.02);
  }

  // The longest run of equal values along a row, away from the lamp.
  int GetLongestRun()
  {
    const Picture picture = Capture(this->Window);
    int longest = 0;
    for (int y = 0; y < this->Height; y += 7)
    {
      for (int k = 0; k < 3; ++k)
      {
        int run = 1;
        for (int x = 1; x < this->Width; ++x)
        {
          const size_t i = 3 * (static_cast<size_t>(y) * this->Width + x) + k;
          run = picture[i] == picture[i - 3] ? run + 1 : 1;
          longest = std::max(longest, run);
        }
      }
    }
    return longest;
  }

  // By how many steps the mean of some pixels is off at most, and the mean of all. A ring is a step
  // that many pixels beside each other are off by.
  std::pair<double, double> GetErrors()
  {
    constexpr int Block = 8;
    const Picture picture = Capture(this->Window);
    double largest = 0.0;
    double all = 0.0;
    for (int y = 0; y < this->Height; y += Block)
    {
      for (int x = 0; x < this->Width; x += Block)
      {
        double sum = 0.0;
        for (int i = 0; i < Block * Block; ++i)
        {
          const int px = x + i % Block;
          const int py = y + i / Block;
          const double radiance = std::min(GetColour(this->GetBuffer("Radiance"), px, py).x, 1.0);
          sum += picture[3 * (static_cast<size_t>(py) * this->Width + px)] - 255.0 * radiance;
        }
        largest = std::max(largest, std::abs(sum) / (Block * Block));
        all += sum / (this->Width * this->Height);
      }
    }
    return { largest, all };
  }
};

double GetMean(const Picture& picture)
{
  return std::accumulate(picture.begin(), picture.end(), 0.0) / static_cast<double>(picture.size());
}

void TestDithering()
{
  Glow scene;
  Check(scene.Pass->GetDithering(), "pictures are dithered by default");
  const Picture dithered = Capture(scene.Window);
  Check(Capture(scene.Window) == dithered, "the same each time");
  const int run = scene.GetLongestRun();
  const std::pair<double, double> errors = scene.GetErrors();
  scene.Pass->DitheringOff();
  const int ring = scene.GetLongestRun();
  const std::pair<double, double> plain = scene.GetErrors();
  std::cout << "glow: runs of " << ring << ", dithered " << run
            << "; means of 64 pixels are off by " << plain.first << " and " << errors.first
            << " steps, of all by " << plain.second << " and " << errors.second << "\n";
  Check(ring > 25 && plain.first > 0.4, "without dithering there are rings");
  Check(run < 0.6 * ring, "with it they are taken apart");
  Check(errors.first < 0.5 * plain.first, "and means of few pixels are right");
  Check(std::abs(errors.second) < 1e-3 * GetMean(dithered), "the mean of all stays");
  // A picture in tiles has the pattern of one window.
  scene.Pass->DitheringOn();
  vtkNew<vtkWindowToImageFilter> tiles;
  tiles->SetInput(scene.Window);
  tiles->SetScale(2);
  tiles->ReadFrontBufferOff();
  tiles->Update();
  scene.Window->SetSize(2 * scene.Width, 2 * scene.Height);
  const Picture whole = Capture(scene.Window);
  int different = 0;
  for (int i = 0; i < 4 * scene.Width * scene.Height; ++i)
  {
    const auto* pixel = static_cast<const unsigned char*>(
      tiles->GetOutput()->GetScalarPointer(i % (2 * scene.Width), i / (2 * scene.Width), 0));
    different += std::equal(pixel, pixel + 3, whole.begin() + 3 * i) ? 0 : 1;
  }
  std::cout << different << " pixels differ in tiles\n";
  Check(
    different <= 4 * scene.Width * scene.Height / 100, "tiles have the whole picture's pattern");
}

//------------------------------------------------------------------------------
// Clear air without any of the steps is VTK's own picture.
void TestClearAir()
{
  WindowScene scene(Width, Height, 1);
  scene.Medium->SetScattering(0.0, 0.0, 0.0);
  scene.Medium->SetAbsorption(0.0, 0.0, 0.0);
  scene.Pass->SetSurfaceShadows(false);
  const Picture shown = Capture(scene.Window);
  scene.Renderer->SetPass(nullptr);
  const Picture plain = Capture(scene.Window);
  scene.Renderer->SetPass(scene.Pass);
  std::cout << "clear air: " << Compare(shown, plain) << "/255\n";
  Check(Compare(shown, plain) == 0, "clear air is VTK's picture");
  scene.Pass->SetRecordBuffers(false);
  Check(Compare(Capture(scene.Window), plain) == 0, "without buffers, too");
  // A mean is not VTK's picture, but nothing is added to it.
  scene.Renderer->SetBackground(0.3101, 0.5213, 0.7399);
  const Picture one = Capture(scene.Window);
  scene.Pass->SetSubpixelFrames(2);
  const Picture mean = Capture(scene.Window);
  Check(
    std::equal(one.end() - 60, one.end(), mean.end() - 60), "a mean of clear air is not dithered");
  scene.Pass->SetSubpixelFrames(1);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Pass->SetOutputColorSpaceToSRGB();
  const Picture encoded = Capture(scene.Window);
  double worst = 0.0;
  for (size_t i = 0; i < plain.size(); ++i)
  {
    const double low = DecodeSRGB(std::max(encoded[i] - 1.0, 0.0) / 255.0);
    const double high = DecodeSRGB((encoded[i] + 1.0) / 255.0);
    worst = std::max({ worst, low - (plain[i] + 0.5) / 255.0, (plain[i] - 0.5) / 255.0 - high });
  }
  Check(worst < 1e-3, "clear air is encoded, if that is wanted: " + std::to_string(worst));
}

//------------------------------------------------------------------------------
void SetPower(Scene& scene, double power)
{
  vtkLight* light = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0));
  light->SetIntensity(power);
}

void TestAutomaticExposure()
{
  WindowScene scene(Width, Height, 1);
  scene.Pass->AutomaticExposureOn();
  const Picture first = Capture(scene.Window);
  const double exposure = scene.Pass->GetEffectiveExposure();
  // By sorting, of single pixels where the pass has blocks of them.
  std::vector<double> logarithms;
  for (int i = 0; i < Width * Height; ++i)
  {
    const glm::dvec3 c = GetColour(scene.GetBuffer("Radiance"), i % Width, i / Width);
    const double luminance = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
    if (luminance > 0.0)
    {
      logarithms.push_back(std::log(luminance));
    }
  }
  std::sort(logarithms.begin(), logarithms.end());
  double sum = 0.0;
  const size_t begin = logarithms.size() * 2 / 5;
  const size_t end = logarithms.size() * 19 / 20;
  for (size_t i = begin; i < end; ++i)
  {
    sum += logarithms[i];
  }
  const double expected = 0.18 / std::exp(sum / static_cast<double>(end - begin));
  std::cout << "exposure " << exposure << ", by sorting " << expected << "\n";
  Check(std::abs(exposure / expected - 1.0) < 0.05, "the exposure of the middle luminance");
  scene.Pass->DitheringOff();
  CheckDecoded("automatic exposure", scene, DecodeLinear, exposure);
  scene.Pass->DitheringOn();
  SetPower(scene, 100.0);
  const double darker = scene.Pass->GetEffectiveExposure();
  const int difference = Compare(Capture(scene.Window), first);
  std::cout << "a hundred times the light: within " << difference << "/255\n";
  Check(difference <= 2, "a hundred times the light looks the same");
  Check(std::abs(scene.Pass->GetEffectiveExposure() * 100.0 / darker - 1.0) < 1e-3,
    "by a hundredth of the exposure");
  SetPower(scene, 1.0);
  scene.Pass->SetExposure(2.0);
  Capture(scene.Window);
  Check(std::abs(scene.Pass->GetEffectiveExposure() / exposure - 2.0) < 1e-3,
    "Exposure multiplies what is measured");
  scene.Pass->SetSubpixelFrames(4);
  Capture(scene.Window);
  Check(std::abs(scene.Pass->GetEffectiveExposure() / exposure - 2.0) < 0.02,
    "the mean of frames has nearly the exposure of one");
  scene.Pass->SetSubpixelFrames(1);
  // Pictures are the same each time, whatever was before; what moves follows.
  Capture(scene.Window);
  const double rest = scene.Pass->GetEffectiveExposure();
  SetPower(scene, 1e4);
  scene.Window->SetDesiredUpdateRate(15.0);
  Capture(scene.Window);
  const double moving = scene.Pass->GetEffectiveExposure();
  Check(moving < rest && moving > 1.01 * rest / 1e4, "while something moves, the exposure follows");
  scene.Window->SetDesiredUpdateRate(0.0001);
  Capture(scene.Window);
  Check(std::abs(scene.Pass->GetEffectiveExposure() * 1e4 / rest - 1.0) < 1e-2,
    "at rest it has arrived");
  // Tiles have the exposure of the whole picture before them.
  const double whole = scene.Pass->GetEffectiveExposure();
  vtkNew<vtkWindowToImageFilter> tiles;
  tiles->SetInput(scene.Window);
  tiles->SetScale(2);
  tiles->ReadFrontBufferOff();
  tiles->Update();
  Check(scene.Pass->GetEffectiveExposure() == whole, "tiles have one exposure");
  Capture(scene.Window);
  const double before = scene.Pass->GetEffectiveExposure();
  SetPower(scene, 0.0);
  const Picture black = Capture(scene.Window);
  Check(*std::max_element(black.begin(), black.end()) == 0, "black stays black");
  Check(scene.Pass->GetEffectiveExposure() == before, "and says nothing of the exposure");
}

// A first frame without any light has the exposure that is set, in a mean, too.
void TestBlackFrame()
{
  for (const int frames : { 1, 4 })
  {
    Scene scene(Width, Height);
    scene.Add(MakeSphere(1.0));
    scene.AddPointLight({ 1, 3, 2 });
    SetPower(scene, 0.0);
    scene.Medium->SetScattering(0.1, 0.1, 0.1);
    scene.Pass->SetExposure(3.0);
    scene.Pass->AutomaticExposureOn();
    scene.Pass->SetSubpixelFrames(frames);
    const Picture black = Capture(scene.Window);
    Check(*std::max_element(black.begin(), black.end()) == 0, "a first black frame is black");
    Check(scene.Pass->GetEffectiveExposure() == 3.0, "with the exposure that is set");
    SetPower(scene, 1.0);
    const Picture lit = Capture(scene.Window);
    Check(*std::max_element(lit.begin(), lit.end()) > 100, "and the next one is exposed");
  }
}

// What is black but for roundings says nothing of the exposure of a narrow beam.
void TestResidues()
{
  std::vector<airlight::LuminanceBlock> blocks(100, { std::log2(1e-9), 100.0 });
  std::fill(blocks.begin(), blocks.begin() + 4, airlight::LuminanceBlock{ 1.0, 100.0 });
  Check(std::abs(airlight::ChooseExposure(blocks) - 0.09) < 1e-12, "the beam's exposure");
  std::fill(blocks.begin(), blocks.end(), airlight::LuminanceBlock{ 0.0, 0.0 });
  Check(airlight::ChooseExposure(blocks) == 0.0, "no exposure of black");
}

//------------------------------------------------------------------------------
// In a layer above others, a glow may be brighter than it is opaque.
void TestBlended()
{
  Scene scene(Width, Height);
  scene.AddPointLight({ 0, 0, -5 }, { 90.0, 70.0, 50.0 });
  scene.Medium->SetScattering(0.01, 0.01, 0.01);
  scene.Medium->SetRegionToSphere();
  scene.Medium->SetCenter(0.0, 0.0, -5.0);
  scene.Medium->SetRadius(3.0);
  vtkNew<vtkRenderer> other;
  other->DrawOff();
  scene.Window->AddRenderer(other);
  scene.Window->SetNumberOfLayers(2);
  other->SetLayer(1);
  scene.Pass->SetToneMappingToReinhard();
  scene.Pass->SetOutputColorSpaceToSRGB();
  const Picture alone = Capture(scene.Window);
  other->DrawOn();
  other->SetLayer(0);
  scene.Renderer->SetLayer(1);
  const Picture above = Capture(scene.Window);
  const int brightest = *std::max_element(alone.begin(), alone.end());
  const int blended = *std::max_element(above.begin(), above.end());
  std::cout << "glow of " << brightest << "/255, in a layer above " << blended << "\n";
  Check(brightest > 200 && blended > 0.9 * brightest, "a glow in a layer above is bright");
  Check(scene.Pass->GetDithering() && Capture(scene.Window) == above, "and the same each time");
}

//------------------------------------------------------------------------------
void TestErrors()
{
  Scene scene(40, 30);
  ErrorListener errors(scene.Pass);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double exposure :
    { 0.0, -1.0, 1e300, 1e-300, nan, std::numeric_limits<double>::infinity() })
  {
    scene.Pass->SetExposure(exposure);
    Check(errors.Take() == 1 && errors.GetText().find("Exposure") != std::string::npos,
      "an exposure out of range: " + std::to_string(exposure));
    Check(scene.Pass->GetExposure() == 1.0, "the old one stays");
  }
  scene.Pass->SetToneMapping(5);
  Check(errors.Take() == 1 && errors.GetText().find("NEUTRAL_PBR") != std::string::npos,
    "a curve that is none");
  scene.Pass->SetOutputColorSpace(-1);
  Check(errors.Take() == 1 && errors.GetText().find("SRGB") != std::string::npos,
    "a colour space that is none");
  Check(scene.Pass->GetToneMapping() == vtkAirlightPass::CLAMP &&
      scene.Pass->GetOutputColorSpace() == vtkAirlightPass::LINEAR,
    "the old values stay");
  scene.Pass->SetEncodedOutput(true);
  Check(
    scene.Pass->GetOutputColorSpace() == vtkAirlightPass::GAMMA_2_2, "EncodedOutput is a gamma");
}
}

//------------------------------------------------------------------------------
int TestDisplayStage(int, char*[])
{
  TestColorSpaces();
  TestWindowsOfSRGB();
  TestEncodedTwice();
  TestToneMapping();
  TestNeutral();
  TestDithering();
  TestClearAir();
  TestAutomaticExposure();
  TestBlackFrame();
  TestResidues();
  TestBlended();
  TestErrors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
