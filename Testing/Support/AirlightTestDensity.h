// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Images of density in a scene, and the comparison of what the pass draws with
 * vtkAirlightReference.
 */

#ifndef AirlightTestDensity_h
#define AirlightTestDensity_h

#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkAirlightReference.h"
#include "vtkDataArray.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"

#include <string>

namespace airlight_test
{
// An image of so many points that fills the box.
vtkSmartPointer<vtkImageData> MakeDensity(
  const glm::ivec3& size, const glm::dvec3& low, const glm::dvec3& high);

// Rotates it about y, then about x, about the middle of its box.
void Rotate(vtkImageData* image, double aboutY, double aboutX);

// Puffs: random Gaussians, so that the image is smooth and falls to nothing at its rim.
void FillCloud(vtkImageData* image, std::uint64_t seed);

// A point array of colours from 0 to `most`.
void AddColours(vtkImageData* image, const char* name, double most, Random& random);

//------------------------------------------------------------------------------
struct Quantiles
{
  double Median;
  double P99;
};

void CheckErrors(
  const std::string& name, vtkImageData* drawn, vtkDataArray* expected, double median, double p99);

// The same against the mean of the pixels that have any: techniques without exact edges are wrong
// by a share of that, also where nearly all of a pixel's light is in shadow.
void CheckErrorsOfMean(
  const std::string& name, vtkImageData* drawn, vtkDataArray* expected, double p99);

// Airlight is as close to what is expected as its bound says, but for pixels at edges of shadows.
void CheckBound(
  const std::string& name, vtkImageData* drawn, vtkImageData* bound, vtkDataArray* expected);

// A scene whose medium is an image of density.
class DensityScene : public Scene
{
public:
  explicit DensityScene(vtkImageData* image, int width = 80, int height = 60)
    : Scene(width, height)
    , Image(image)
  {
    this->Medium->SetDensityImage(image);
    this->Medium->SetDensityToImage();
    this->Pass->SetShadowTechniqueToShadowPlanes();
    this->Reference->SetRenderer(this->Renderer);
    this->Reference->SetMedium(this->Medium);
  }

  // A ground and two balls.
  void AddBodies()
  {
    vtkNew<vtkPlaneSource> ground;
    ground->SetOrigin(-8, -2.5, 8);
    ground->SetPoint1(8, -2.5, 8);
    ground->SetPoint2(-8, -2.5, -8);
    this->Add(ground);
    this->Add(MakeSphere(0.6), [](vtkActor* ball) { ball->SetPosition(-1.2, 1.0, 0.3); });
    this->Add(MakeSphere(0.4), [](vtkActor* ball) { ball->SetPosition(1.4, 0.2, 0.8); });
  }

  // Draws, and compares with the reference.
  void Compare(const std::string& name, double median, double p99, bool bound = true)
  {
    std::cout << name << "\n";
    this->Window->Render();
    this->Reference->SetSize(this->Width, this->Height);
    this->Reference->Modified();
    this->Reference->Update();
    const auto expected = [this](const char* array) {
      return this->Reference->GetOutput()->GetPointData()->GetArray(array);
    };
    CheckErrors(
      name + ", Airlight", this->GetBuffer("Airlight"), expected("Airlight"), median, p99);
    if (bound)
    {
      CheckBound(
        name, this->GetBuffer("Airlight"), this->GetBuffer("ErrorBound"), expected("Airlight"));
    }
    CheckErrors(name + ", Transmittance", this->GetBuffer("Transmittance"),
      expected("Transmittance"), 1e-5, 1e-3);
  }

  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkAirlightReference> Reference;
};
}

#endif
