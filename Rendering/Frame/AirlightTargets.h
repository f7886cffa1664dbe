// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The textures that the pass draws into, in single precision, and their framebuffers.
 */

#ifndef AirlightTargets_h
#define AirlightTargets_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
class Targets
{
public:
  Targets();
  ~Targets();

  // Makes or resizes what the next frame needs. False with a reason in GetError() where the size
  // is beyond the graphics card.
  struct Needs
  {
    size_t SceneLights = 0;
    bool Drawn = false;
    bool WithoutLight = false;
    bool Record = false;
    bool Several = false; // recorded: light that is scattered more than once
    bool Radiance = false;
    int LightLayers = 0;
  };
  bool Prepare(vtkOpenGLRenderWindow* window, int width, int height, const Needs& needs);
  const std::string& GetError() const { return this->Error; }
  void Release(vtkWindow* window);

  // Binds a framebuffer over these textures and sets viewport and scissor to all of it. False with
  // a reason in GetError() where the framebuffer is incomplete. Restore the bindings afterwards.
  bool Bind(const std::vector<vtkTextureObject*>& colours, vtkTextureObject* depth);

  // Draws into the first so many of the colours that the last Bind() bound.
  void DrawInto(int count);

  // Clears the colours that are bound, all channels of all of them; and the depth.
  void Clear(float value) { this->Clear(value, value); }
  void Clear(float colour, float alpha);
  void ClearDepth();

  // The framebuffer that the last Bind() made current.
  vtkOpenGLFramebufferObject* GetFramebuffer();

  // Reads components of a texture that the last Bind() bound as colour `attachment`.
  vtkSmartPointer<vtkImageData> Read(unsigned int attachment, int firstComponent, int components);

  // R: distance on the unit of airlightDirection() (AirlightCameraShader.glsl), -1 without surface
  vtkNew<vtkTextureObject> Distances;
  vtkNew<vtkTextureObject> Drawn; // R: the same as the mappers drew it; G: below 0 where they did
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkTextureObject> LightWays; // see AirlightLightWaysPass.h; only with layers
  vtkNew<vtkTextureObject> Scene;
  vtkNew<vtkTextureObject> WithoutLight; // the scene without the light that casts shadows on it
  vtkNew<vtkTextureObject> Scattered;    // RGB: airlight, A: bits of the first 24 lights (litBit)
  vtkNew<vtkTextureObject> Lit;    // RGB: those of others, 24 a channel; only where there are any
  vtkNew<vtkTextureObject> Counts; // recorded only: boundaries; error bound; lit length
  vtkNew<vtkTextureObject> Single; // recorded: one light's airlight
  vtkNew<vtkTextureObject> SeveralOfLights; // recorded: what lights scatter more than once
  vtkNew<vtkTextureObject> Several;         // and that with what collisions give
  vtkNew<vtkTextureObject> Radiance; // recorded, measured, or to draw translucent surfaces into
  vtkNew<vtkTextureObject> Airlight;
  vtkNew<vtkTextureObject> Surface;
  vtkNew<vtkTextureObject> Transmittance;

private:
  bool Allocate(vtkTextureObject* texture, int components, int layers = 1);

  vtkOpenGLRenderWindow* Window = nullptr;
  int Width = 0;
  int Height = 0;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  int ColourCount = 0;
  std::string Error;
};
}

#endif
