// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A froxel grid as the shaders keep it (glsl/AirlightFroxelGrid.glsl): each light's resolve adds
 * what it scatters before each node, and whether and how much of it arrives there. Then the nodes
 * become a texture, which is read with interpolation (glsl/AirlightFroxelLookup.glsl).
 *
 * Memory: 28 bytes a node and 16 for each light that casts shadows; 32 and 16 for the texture.
 */

#ifndef AirlightFroxelNodes_h
#define AirlightFroxelNodes_h

#include "OpenGL/AirlightQuad.h"

#include "vtkNew.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
class FroxelNodes
{
public:
  FroxelNodes();
  ~FroxelNodes();

  // Nodes on a ray before and behind all that is visible.
  static constexpr int NearNodes = 6;
  static constexpr int FarNodes = 7;

  // What shaders that write nodes begin with, after DefineStorageBindings(), and those that read
  // the texture.
  static std::string GetSource();
  static std::string GetLookupSource();

  struct Layout
  {
    int Columns = 0;
    int Rows = 0;
    int Nodes = 0; // on a ray
    double FirstDepth = 0.0;
    double Step = 0.0;       // from one node to the next
    std::vector<int> Lights; // the place of light k in a node, -1 if it has none
    glm::vec2 PerPixel;      // columns and rows

    int GetLightCount() const;
  };
  // Whether OpenGL has buffers and textures of this size, within a limit of bytes.
  static bool IsPossible(
    vtkOpenGLRenderWindow* window, const Layout& layout, std::uint64_t memoryLimit);

  // Room for these nodes, all 0. False with a reason in GetError() if OpenGL refuses it.
  bool Prepare(vtkOpenGLRenderWindow* window, const Layout& layout);
  const Layout& GetLayout() const { return this->Current; }
  const std::string& GetError() const { return this->Error; }

  // For a program with that source: binds the nodes and sets its uniforms, of a light by number or
  // of none.
  void Use(vtkShaderProgram* program, int light = -1) const;

  // Draws kinds of values into the texture, over which a framebuffer is bound. False with a reason
  // in GetError() where the shader does not compile.
  bool DrawTexture(vtkOpenGLRenderWindow* window, int firstKind, int kinds);
  int GetKindCount() const { return 2 + this->Current.GetLightCount(); }
  vtkTextureObject* GetTexture() const { return this->Texture; }

  // For a program with GetLookupSource(); the texture is active.
  void UseTexture(vtkShaderProgram* program) const;

  void Release(vtkWindow* window);

private:
  static std::uint64_t GetBytes(const Layout& layout);
  void SetDepths(vtkShaderProgram* program) const;

  Layout Current;
  Quad TextureQuad;
  unsigned int Buffer = 0;
  std::uint64_t Bytes = 0;
  vtkNew<vtkTextureObject> Texture;
  std::string Error;
};
}

#endif
