// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The arrays that the shaders read beside their uniforms (surfaces of media, tables), one after the
 * other in a buffer on the graphics card.
 */

#ifndef AirlightSceneData_h
#define AirlightSceneData_h

#include "vtkNew.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <variant>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
// Numbers that the CPU uses, too, or that only cards need.
using DoubleTexels = std::shared_ptr<const std::vector<glm::dvec4>>;
using FloatTexels = std::shared_ptr<const std::vector<glm::vec4>>;
using Texels = std::variant<DoubleTexels, FloatTexels>;

class SceneData
{
public:
  SceneData();
  ~SceneData();

  // Uploads the arrays unless they are there already, and says where each begins. Arrays must not
  // change once they are here. False with a reason in GetError() where the card has no room.
  bool Update(vtkOpenGLRenderWindow* window, const std::vector<Texels>& arrays);
  int GetFirst(size_t array) const { return this->First[array]; }
  const std::string& GetError() const { return this->Error; }

  // Null without arrays.
  vtkTextureObject* GetTexture();

  void Release(vtkWindow* window);

private:
  std::vector<Texels> Arrays;
  std::vector<int> First;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  std::string Error;
};
}

#endif
