// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Scenes that vtkAirlightPass draws once, distances and colours together, look as those that it
// draws twice: the same scenes with an actor of a class that it does not know, which draws nothing.

#include "AirlightTestScene.h"

#include "vtkAxesActor.h"
#include "vtkCommand.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkPointData.h"
#include "vtkTexture.h"

#include <cmath>
#include <cstdlib>

using namespace airlight_test;

namespace
{
class Stranger : public vtkOpenGLActor
{
public:
  static Stranger* New();
  vtkTypeMacro(Stranger, vtkOpenGLActor);

  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  double* GetBounds() override { return this->Box; }

private:
  double Box[6] = { -1, 1, -1, 1, -1, 1 }; // or it would be culled
};
vtkStandardNewMacro(Stranger);

struct Stage : Scene
{
  Stage()
    : Scene(160, 120)
  {
    this->Body = this->Add(MakeSphere(1.0));
    vtkNew<vtkCubeSource> floor;
    floor->SetBounds(-6, 6, -2.1, -2, -6, 6);
    this->Add(floor);
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    this->Medium->SetAmbientRadiance(0.02, 0.03, 0.04);
    this->Renderer->AddActor(this->Unknown);
    this->Unknown->VisibilityOff();
    this->Body->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, this, &Stage::Count);
  }

  void Count() { ++this->Draws; }

  // How often the sphere is drawn in one frame.
  int CountDraws()
  {
    this->Window->Render();
    this->Draws = 0;
    this->Window->Render();
    return this->Draws;
  }

  vtkActor* Body;
  vtkNew<Stranger> Unknown;
  int Draws = 0;
};

// The largest difference in units of the largest value. Compilers round the same expression another
// way in another shader: a distance by its last bits, what depends on it by somewhat more. Edges of
// shadows, where that decides, are a few pixels, which may differ.
bool AreAlike(vtkImageData* a, vtkImageData* b)
{
  vtkDataArray* p = a->GetPointData()->GetScalars();
  vtkDataArray* q = b->GetPointData()->GetScalars();
  double largest = 0.0;
  for (vtkIdType i = 0; i < p->GetNumberOfValues(); ++i)
  {
    largest = std::max(largest, std::abs(p->GetVariantValue(i).ToDouble()));
  }
  vtkIdType apart = 0;
  for (vtkIdType i = 0; i < p->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < p->GetNumberOfComponents(); ++c)
    {
      const double difference = std::abs(p->GetComponent(i, c) - q->GetComponent(i, c));
      apart += difference <= 2e-6 * largest ? 0 : 1;
    }
  }
  return apart <= p->GetNumberOfTuples() / 2000;
}

//------------------------------------------------------------------------------
// In the recorded buffers, which take the way by recorded airlight, and in the picture, which may
// do without.
void CheckSameTwice(Stage& stage, const std::string& what)
{
  const Buffers once = stage.Render();
  Check(stage.CountDraws() == 1, what + ": is drawn once");
  stage.Pass->RecordBuffersOff();
  const Picture picture = Capture(stage.Window);
  Check(stage.CountDraws() == 1, what + ": is drawn once, without buffers");
  stage.Unknown->VisibilityOn();
  const Picture expected = Capture(stage.Window);
  Check(stage.CountDraws() == 2, what + ": is drawn twice beside what is not known");
  stage.Pass->RecordBuffersOn();
  const Buffers twice = stage.Render();
  stage.Unknown->VisibilityOff();
  for (const char* name : { "Radiance", "Airlight", "Surface", "Transmittance", "Depth" })
  {
    Check(AreAlike(once.at(name), twice.at(name)), what + ": the same " + name);
  }
  Check(Compare(picture, expected) <= 1, what + ": the same picture");
}

//------------------------------------------------------------------------------
void TestTechniques()
{
  Stage stage;
  vtkLight* lamp = stage.AddPointLight({ 1.5, 4, 1 });
  for (int technique : { vtkAirlightPass::NONE, vtkAirlightPass::SHADOW_PLANES,
         vtkAirlightPass::SHADOW_MAP, vtkAirlightPass::RAY_MARCH })
  {
    stage.Pass->SetShadowTechnique(technique);
    CheckSameTwice(stage, "technique " + std::to_string(technique));
  }
  stage.Pass->SetShadowTechniqueToShadowPlanes();
  stage.Pass->SurfaceShadowsOff();
  CheckSameTwice(stage, "no shadows on surfaces");
  stage.Pass->SurfaceShadowsOn();
  stage.Pass->LinearInputOn();
  CheckSameTwice(stage, "linear");
  lamp->SetPositional(true);
  lamp->SetFocalPoint(0, 0, 0);
  lamp->SetConeAngle(20.0);
  lamp->SetExponent(0.0);
  CheckSameTwice(stage, "spot");
  stage.Pass->SetShadowTechniqueToNone();
  CheckSameTwice(stage, "spot without shadows");
}

//------------------------------------------------------------------------------
// The light whose shadows fall on surfaces need not be the first, nor alone.
void TestLights()
{
  Stage stage;
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  stage.AddLight(headlight);
  stage.Pass->SetLightScatters(headlight, true);
  stage.Pass->SetShadowTechniqueToShadowPlanes();
  CheckSameTwice(stage, "headlight");
  stage.AddDirectionalLight({ 1, 2, 0.5 });
  CheckSameTwice(stage, "headlight and sun");
  stage.Medium->SetScattering(0.08, 0.08, 0.08);
  stage.Medium->SetAbsorption(0.02, 0.02, 0.02);
  CheckSameTwice(stage, "grey");
  stage.AddPointLight({ -2, 3, 2 });
  Check(stage.CountDraws() == 2, "two lights' shadows: drawn twice");
  stage.Pass->SetShadowTechniqueToNone();
  CheckSameTwice(stage, "three lights without shadows");
}

//------------------------------------------------------------------------------
// What may let the background through is drawn twice where its shadows matter.
void TestSurfaces()
{
  Stage stage;
  stage.AddPointLight({ 1.5, 4, 1 });
  stage.Pass->SetShadowTechniqueToShadowPlanes();
  Check(stage.CountDraws() == 1, "a plain surface: drawn once");
  vtkNew<vtkTexture> texture;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  image->GetPointData()->GetScalars()->Fill(255);
  texture->SetInputData(image);
  stage.Body->SetTexture(texture);
  Check(stage.CountDraws() == 1, "an opaque texture: drawn once");
  CheckSameTwice(stage, "an opaque texture");
  texture->SetWrap(vtkTexture::ClampToBorder);
  Check(stage.CountDraws() == 2, "a texture with a border: drawn twice");
  stage.Pass->SetShadowTechniqueToNone();
  Check(stage.CountDraws() == 1, "a texture without shadows: drawn once");
  stage.Body->SetTexture(nullptr);
  vtkNew<vtkAxesActor> axes;
  axes->AxisLabelsOff();
  axes->SetTotalLength(2.5, 2.5, 2.5); // out of the sphere
  stage.Renderer->AddActor(axes);
  Check(stage.CountDraws() == 1, "axes: drawn once");
  CheckSameTwice(stage, "axes");
  stage.Renderer->RemoveActor(axes);
  stage.Renderer->SetBackground2(0.6, 0.5, 0.2);
  stage.Renderer->GradientBackgroundOn();
  CheckSameTwice(stage, "gradient");
  stage.Renderer->SetViewport(0.25, 0.1, 0.9, 0.8);
  CheckSameTwice(stage, "viewport");
}
}

//------------------------------------------------------------------------------
int TestSingleGeometryPass(int, char*[])
{
  TestTechniques();
  TestLights();
  TestSurfaces();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
