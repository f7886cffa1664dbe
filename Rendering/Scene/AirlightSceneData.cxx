// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightSceneData.h"

#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

namespace airlight
{
SceneData::SceneData() = default;
SceneData::~SceneData() = default;

//------------------------------------------------------------------------------
bool SceneData::Update(vtkOpenGLRenderWindow* window, const std::vector<Texels>& arrays)
{
  if (arrays == this->Arrays)
  {
    return true;
  }
  this->Arrays.clear();
  this->First.clear();
  std::vector<glm::vec4> texels;
  for (const Texels& array : arrays)
  {
    this->First.push_back(static_cast<int>(texels.size()));
    std::visit(
      [&texels](const auto& all) { texels.insert(texels.end(), all->begin(), all->end()); }, array);
  }
  if (texels.empty())
  {
    return true;
  }
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (texels.size() > static_cast<size_t>(most))
  {
    this->Error = "surfaces, images and tables take " + std::to_string(texels.size()) +
      " texels and the graphics card has room for " + std::to_string(most) + "; use coarser ones";
    return false;
  }
  ForgetErrors();
  this->Texture->SetContext(window);
  this->Buffer->GenerateBuffer(vtkOpenGLBufferObject::TextureBuffer);
  if (!this->Buffer->Upload(texels, vtkOpenGLBufferObject::TextureBuffer) ||
    !this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(texels.size()), 4, VTK_FLOAT, this->Buffer) ||
    IsOutOfMemory())
  {
    this->Error = "no memory on the graphics card for the media's surfaces, images and tables: use "
                  "coarser ones";
    return false;
  }
  this->Arrays = arrays;
  return true;
}

//------------------------------------------------------------------------------
vtkTextureObject* SceneData::GetTexture()
{
  return this->Arrays.empty() ? nullptr : this->Texture.Get();
}

//------------------------------------------------------------------------------
void SceneData::Release(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
  this->Arrays.clear();
  this->First.clear();
}
}
