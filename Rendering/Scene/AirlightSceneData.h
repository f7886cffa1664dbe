// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The arrays that the shaders read beside their uniforms (surfaces of media, images, tables), in
 * one buffer on the graphics card. An array that stays keeps its place: what changes beside it, the
 * grid of a lamp that moves, is all that is written again.
 */

#ifndef AirlightSceneData_h
#define AirlightSceneData_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
// An array of texels of four floats or, of few bits, of four whole numbers.
struct SceneArray
{
  // What it is made of, which tells it from others and does not change.
  std::shared_ptr<const void> Key;
  // In texels of four floats, at least one.
  size_t Size;
  std::function<void(void*)> Write;
  // The texel, of its own kind, at which shaders begin to count.
  size_t Begin = 0;
  int Bits = 32; // of a number; all arrays of whole numbers have the same, 8 or 16
};

class SceneData
{
public:
  SceneData();
  ~SceneData();

  // Puts those arrays on the card that are not there, and says where each begins, in texels of its
  // own kind. False with a reason in GetError() where the card has no room.
  bool Update(vtkOpenGLRenderWindow* window, const std::vector<SceneArray>& arrays);
  int GetFirst(size_t array) const { return static_cast<int>(this->First[array]); }
  const std::string& GetError() const { return this->Error; }

  // Null without arrays.
  vtkTextureObject* GetTexture();
  // The same buffer in shares of the largest whole number; null without arrays of such.
  vtkTextureObject* GetWholeNumbers();

  void Release(vtkWindow* window);

private:
  struct Place
  {
    std::shared_ptr<const void> Key;
    size_t First;
    size_t Size;
    int Bits;
  };

  const Place* Find(const SceneArray& array) const;
  void KeepOnly(const std::vector<SceneArray>& arrays);
  bool FindGap(size_t size, size_t& first) const;
  bool Add(vtkOpenGLRenderWindow* window, const std::vector<SceneArray>& arrays);
  bool Write(const SceneArray& array, size_t first);
  bool Allocate(vtkOpenGLRenderWindow* window, size_t texels);
  size_t GetWholeEnd() const;
  bool PutWholeNumbersFirst(vtkOpenGLRenderWindow* window);
  bool ViewWholeNumbers(vtkOpenGLRenderWindow* window, int bits);
  bool FailFit(size_t texels, size_t most);

  std::vector<Place> Places; // in the order of their beginnings
  std::vector<size_t> First;
  size_t Capacity = 0; // texels
  vtkSmartPointer<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkTextureObject> WholeNumbers;
  int WholeBits = 0; // that it shows; 0: none
  std::string Error;
};
}

#endif
