// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass where OpenGL is too old for it, has smaller textures than the picture needs, or
// has lost its context.

#include "FaultTrial.h"

#include "AirlightTestCloudVolume.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>

using namespace airlight_test;

namespace
{
struct Expected
{
  Picture Plain;
  Picture Good;
};

// Where nothing is wrong.
Expected Draw(WindowScene& scene)
{
  Expected pictures;
  pictures.Good = Capture(scene.Window);
  scene.Renderer->SetPass(nullptr);
  pictures.Plain = Capture(scene.Window);
  return pictures;
}

Expected Draw(int width, int height)
{
  WindowScene scene(width, height, 1);
  return Draw(scene);
}

void CheckFrames(
  WindowScene& scene, const Expected& expected, const std::string& words, const std::string& what)
{
  airlight_test::ErrorListener errors(scene.Pass);
  Check(Compare(expected.Plain, Capture(scene.Window)) == 0, what + ": without the medium");
  Check(errors.Take() == 1, what + ": one error");
  Check(errors.GetText().find(words) != std::string::npos,
    what + ": the error names the cause, not: " + errors.GetText());
  std::cout << what << ": " << errors.GetText();
  Check(Compare(expected.Plain, Capture(scene.Window)) == 0, what + ": again without the medium");
  Check(errors.Take() == 0, what + ": no second error");
}

void CheckRecovered(WindowScene& scene, const Expected& expected, const std::string& what)
{
  airlight_test::ErrorListener errors(scene.Pass);
  Check(Compare(expected.Good, Capture(scene.Window)) == 0, what + ": the medium is there");
  Check(errors.Take() == 0, what + ": no error");
}

//------------------------------------------------------------------------------
// A window larger than the largest texture.
void TestTextureSize(const Expected& small, const Expected& large)
{
  ClaimTextureSize(100);
  WindowScene scene(120, 90, 1);
  CheckFrames(scene, large, "120 x 90 pixels exceeds the largest texture of 100", "texture size");
  ClaimTextureSize(0);
  scene.Window->SetSize(80, 60);
  CheckRecovered(scene, small, "a smaller window");
}

// A medium's surface takes more texels than there can be.
void TestTextureBufferSize(const Expected& small)
{
  WindowScene scene(80, 60, 1);
  scene.Window->Render();
  ClaimTextureBufferSize(8);
  scene.Medium->SetRegionToSurface();
  scene.Medium->SetSurface(MakeSphere(5.0));
  CheckFrames(scene, small, "the graphics card has room for 8", "texture buffer size");
  scene.Medium->SetRegionToBox();
  CheckRecovered(scene, small, "without the surface");
  ClaimTextureBufferSize(0);
}

// So does a volume that is a medium itself: VTK's picture has it.
void AddVolume(WindowScene& scene)
{
  const auto image = MakeDensity(glm::ivec3(12), glm::dvec3(-1.5), glm::dvec3(1.5));
  FillCloud(image, 81027);
  const auto volume = MakeCloudVolume(image, 0.8, 0.7);
  scene.Renderer->AddVolume(volume);
  vtkAirlightPass::SetVolumeScatters(volume, true);
}

void TestVolume(const Expected& small)
{
  WindowScene other(80, 60, 1);
  AddVolume(other);
  const Expected expected = Draw(other);
  Check(Compare(expected.Plain, small.Plain) != 0, "the volume is seen");
  WindowScene scene(80, 60, 1);
  AddVolume(scene);
  ClaimTextureBufferSize(8);
  CheckFrames(scene, expected, "the graphics card has room for 8", "a volume as a medium");
  ClaimTextureBufferSize(0);
  CheckRecovered(scene, expected, "a volume as a medium, with room");
}

// A cloud of numbers of this type from 0 to 200 in the scene's medium.
void AddCloud(WindowScene& scene, int type)
{
  const auto image = MakeDensity(glm::ivec3(12), glm::dvec3(-1.5), glm::dvec3(1.5));
  FillCloud(image, 81028);
  vtkDataArray* cloud = image->GetPointData()->GetScalars();
  auto numbers = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  numbers->SetNumberOfTuples(cloud->GetNumberOfTuples());
  for (vtkIdType i = 0; i < cloud->GetNumberOfTuples(); ++i)
  {
    numbers->SetComponent(
      i, 0, std::round(200.0 * cloud->GetComponent(i, 0) / cloud->GetRange()[1]));
  }
  image->GetPointData()->SetScalars(numbers);
  vtkNew<vtkParticipatingMedium> smoke;
  smoke->SetDensityImage(image);
  smoke->SetScattering(0.01, 0.01, 0.01);
  scene.Pass->AddMedium(smoke);
}

// The least power of 2 of texels with which a scene of two such clouds is as it is with all room.
int FindLeastRoom(int type)
{
  WindowScene scene(80, 60, 1);
  AddCloud(scene, type);
  AddCloud(scene, type);
  const Picture good = Capture(scene.Window);
  airlight_test::ErrorListener errors(scene.Pass);
  int most = 64;
  for (; most < (1 << 24); most *= 2)
  {
    scene.Pass->ReleaseGraphicsResources(scene.Window);
    ClaimTextureBufferSize(most);
    if (Compare(good, Capture(scene.Window)) == 0)
    {
      break;
    }
  }
  ClaimTextureBufferSize(0);
  return most;
}

// Samples of 8 bits have smaller texels, of which a texture shows no more: a scene of such images
// fits wherever one of floats does.
void TestWholeNumbers()
{
  const int bytes = FindLeastRoom(VTK_UNSIGNED_CHAR);
  const int floats = FindLeastRoom(VTK_FLOAT);
  std::cout << "texels for bytes " << bytes << ", for floats " << floats << "\n";
  Check(bytes <= floats && floats < (1 << 24), "bytes need no more texels than floats");
}

// The pass goes to a window whose OpenGL is newer.
void TestVersion(const Expected& small)
{
  ClaimVersion(3, 2);
  WindowScene scene(80, 60, 1);
  CheckFrames(scene, small, "needs OpenGL 3.3 and this window has 3.2", "version");
  ClaimVersion(0, 0);
  WindowScene other(80, 60, 1);
  scene.Renderer->SetPass(nullptr);
  other.Renderer->SetPass(scene.Pass);
  CheckRecovered(other, small, "another window");
}

//------------------------------------------------------------------------------
// Every answer is an error, for ever; the pass must not wait for the last one. (VTK does where it
// reads pixels: the picture is read when the context is back.)
void TestLostContext(const Expected& small)
{
  WindowScene scene(80, 60, 1);
  CheckRecovered(scene, small, "before the loss");
  scene.Pass->ReleaseGraphicsResources(scene.Window);
  airlight_test::ErrorListener errors(scene.Pass);
  LoseContext(true);
  scene.Window->Render();
  scene.Window->Render();
  LoseContext(false);
  Check(errors.Take() == 1, "lost context: one error in two frames");
  Check(
    errors.GetText().find("graphics card") != std::string::npos, "lost context: names the cause");
  Check(Compare(small.Plain, ReadPicture(scene.Window)) == 0, "lost context: without the medium");
  CheckRecovered(scene, small, "after the loss");
}
}

//------------------------------------------------------------------------------
int TestFaultsLimits(int, char*[])
{
  const Expected small = Draw(80, 60);
  const Expected large = Draw(120, 90);
  TestTextureSize(small, large);
  TestTextureBufferSize(small);
  TestVolume(small);
  TestWholeNumbers();
  TestVersion(small);
  TestLostContext(small);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
