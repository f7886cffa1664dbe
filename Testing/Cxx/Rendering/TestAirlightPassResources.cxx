// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The OpenGL objects of vtkAirlightPass: their number does not grow from frame to frame, and after
// ReleaseGraphicsResources() none is left, whatever made the pass need them.

#include "AirlightTestVolume.h"
#include "AirlightTestWindowScene.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"

#include <array>

using namespace airlight_test;

namespace
{
// Textures, buffers, renderbuffers, framebuffers, vertex arrays.
using Counts = std::array<int, 5>;

std::string Print(const Counts& c)
{
  return std::to_string(c[0]) + " textures, " + std::to_string(c[1]) + " buffers, " +
    std::to_string(c[2]) + " renderbuffers, " + std::to_string(c[3]) + " framebuffers, " +
    std::to_string(c[4]) + " vertex arrays";
}

int Sum(const Counts& c) { return c[0] + c[1] + c[2] + c[3] + c[4]; }

// OpenGL gives the smallest numbers that are free.
Counts CountObjects(vtkRenderWindow* window)
{
  window->MakeCurrent();
  Counts counts{};
  for (GLuint id = 1; id < 20000; ++id)
  {
    counts[0] += glIsTexture(id) != 0;
    counts[1] += glIsBuffer(id) != 0;
    counts[2] += glIsRenderbuffer(id) != 0;
    counts[3] += glIsFramebuffer(id) != 0;
    counts[4] += glIsVertexArray(id) != 0;
  }
  return counts;
}

// Few triangles, so that the rest takes the time.
vtkSmartPointer<vtkPolyData> MakeBox()
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(-7, 7, -3, 5, -7, 7);
  return Make(box);
}

//------------------------------------------------------------------------------
// What makes objects of the pass; recorded buffers and shadows all contents do.
struct Content
{
  std::string Name;
  std::function<void(WindowScene&)> Fill;
  std::function<void(vtkAirlightPass*)> Set;
  int Least; // objects
};

// FXAA and a surface around the medium.
void AddSurface(WindowScene& scene)
{
  scene.Renderer->UseFXAAOn();
  scene.Medium->SetRegionToSurface();
  scene.Medium->SetSurface(MakeBox());
}

// Records of translucent fragments, and what they leave of the light on surfaces.
void AddGlassAndVolume(WindowScene& scene)
{
  scene.Cube->GetProperty()->SetOpacity(0.5);
  AddSlab(scene, Slab());
}

// A texture for each light, and another for casters without polygons: glyphs on blocks.
void AddBlocksOfGlyphs(WindowScene& scene)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeSphere(2.0));
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetSourceData(MakeSphere(0.1));
  scene.Renderer->AddActor(Scene::MakeActor(mapper));
}

// Samples, and a grid for each light.
void AddDensityImage(WindowScene& scene)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 4, 5);
  image->SetOrigin(-4, -2, -4);
  image->SetSpacing(4, 2, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i, 0, 0.2 + 0.1 * static_cast<double>(i % 7));
  }
  scene.Medium->SetDensityToImage();
  scene.Medium->SetDensityImage(image);
}

std::vector<Content> MakeContents()
{
  const auto nothing = [](vtkAirlightPass*) {};
  const auto map = [](vtkAirlightPass* pass) {
    pass->SetShadowTechniqueToShadowMap();
    pass->TranslucentShadowsOff(); // which maps know nothing of
    pass->SetShadowMapResolution(64);
  };
  const auto all = [](WindowScene& scene) {
    AddGlassAndVolume(scene);
    AddDensityImage(scene);
  };
  return { { "surface", AddSurface, nothing, 20 },
    { "glass and volume", AddGlassAndVolume, nothing, 25 },
    { "shadow maps", AddBlocksOfGlyphs, map, 15 },
    { "density image", AddDensityImage, nothing, 20 },
    { "glass, volume and density image", all, nothing, 25 },
    { "glass, volume and density image with shadow maps", all, map, 20 } };
}

//------------------------------------------------------------------------------
void TestGrowth()
{
  WindowScene scene(40, 30, 2);
  scene.Cube->GetProperty()->SetOpacity(0.5);
  const int sizes[][2] = { { 40, 30 }, { 30, 40 }, { 52, 22 } };
  const auto draw = [&](int frame) {
    const auto& size = sizes[frame % 3];
    scene.Window->SetSize(size[0], size[1]);
    scene.Renderer->SetPass(frame % 2 == 0 ? scene.Pass.Get() : nullptr);
    scene.Window->Render();
  };
  for (int frame = 0; frame < 12; ++frame)
  {
    draw(frame);
  }
  const Counts before = CountObjects(scene.Window);
  for (int frame = 0; frame < 1000; ++frame)
  {
    draw(frame);
  }
  const Counts after = CountObjects(scene.Window);
  std::cout << "resized and switched: " << Print(before) << "; 1000 frames later " << Print(after)
            << "\n";
  Check(before[0] > 8 && before[1] > 4, "there are objects to count");
  Check(before == after, "1000 frames make no objects that stay");
}

//------------------------------------------------------------------------------
// Lamps, casters and media that come and go.
void TestChanges()
{
  WindowScene scene(40, 30, 2);
  scene.Medium->SetSurface(MakeBox());
  const auto draw = [&](int frame) {
    scene.Lights[1]->SetSwitch(frame % 2);
    scene.Ball->SetVisibility(frame % 3 != 0);
    scene.Medium->SetRegion(
      frame % 4 < 2 ? vtkParticipatingMedium::BOX : vtkParticipatingMedium::SURFACE);
    scene.Medium->SetAbsorption(0.01 * (frame % 5), 0.0, 0.0);
    scene.Pass->SetRecordBuffers(frame % 7 < 3);
    scene.Window->Render();
  };
  int frame = 0;
  for (; frame < 60; ++frame)
  {
    draw(frame);
  }
  const Counts before = CountObjects(scene.Window);
  for (; frame < 180; ++frame)
  {
    draw(frame);
  }
  const Counts after = CountObjects(scene.Window);
  std::cout << "changed: " << Print(before) << "; 120 frames later " << Print(after) << "\n";
  Check(before == after, "changes make no objects that stay");
}

//------------------------------------------------------------------------------
enum class Way
{
  Release, // ReleaseGraphicsResources()
  Other,   // the pass draws in another window
  Deleted  // the pass is deleted
};

void TestRelease(Way way, const std::string& ending, const Content& content)
{
  const std::string what = content.Name + ", " + ending;
  WindowScene scene(40, 30, 2);
  content.Fill(scene);
  // The pass of the scene stays unused.
  scene.Renderer->SetPass(nullptr);
  scene.Window->Render();
  scene.Window->Render();
  const Counts without = CountObjects(scene.Window);
  WindowScene other(40, 30, 2);
  auto pass = vtkSmartPointer<vtkAirlightPass>::New();
  pass->SetMedium(scene.Medium);
  pass->RecordBuffersOn();
  content.Set(pass);
  scene.Renderer->SetPass(pass);
  scene.Window->Render();
  scene.Window->Render();
  const Counts with = CountObjects(scene.Window);
  scene.Renderer->SetPass(nullptr);
  if (way == Way::Release)
  {
    pass->ReleaseGraphicsResources(scene.Window);
  }
  else if (way == Way::Other)
  {
    other.Renderer->SetPass(pass);
    other.Window->Render();
  }
  // The mappers keep what the pass has added to their shaders until they are drawn without it.
  scene.Window->Render();
  pass = nullptr;
  const Counts after = CountObjects(scene.Window);
  std::cout << what << ": without pass " << Print(without) << "; with it " << Print(with)
            << "; afterwards " << Print(after) << "\n";
  Check(Sum(with) > Sum(without) + content.Least, what + ": the pass has objects");
  Check(after == without, what + ": none is left");
}
}

//------------------------------------------------------------------------------
int TestAirlightPassResources(int, char*[])
{
  TestGrowth();
  TestChanges();
  for (const Content& content : MakeContents())
  {
    TestRelease(Way::Release, "released", content);
    TestRelease(Way::Other, "drawn in another window", content);
    TestRelease(Way::Deleted, "deleted", content);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
