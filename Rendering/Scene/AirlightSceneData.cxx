// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightSceneData.h"

#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Room for a lamp's next grid, which may be finer: a share of the whole, and no more texels.
constexpr double Spare = 0.125;
constexpr size_t MostSpare = 700000;

size_t AddSpare(size_t texels)
{
  return texels + std::min(static_cast<size_t>(Spare * static_cast<double>(texels)), MostSpare);
}

GLsizeiptr GetBytes(size_t texels) { return static_cast<GLsizeiptr>(texels * sizeof(glm::vec4)); }

size_t GetLargestView()
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return static_cast<size_t>(most);
}

// Of the arrays of whole numbers; 0: there are none.
int GetWholeBits(const std::vector<SceneArray>& arrays)
{
  const auto it = std::find_if(
    arrays.begin(), arrays.end(), [](const SceneArray& array) { return array.Bits < 32; });
  return it == arrays.end() ? 0 : it->Bits;
}

// An array may be there more than once.
size_t CountAll(const std::vector<SceneArray>& arrays)
{
  size_t sum = 0;
  for (auto array = arrays.begin(); array != arrays.end(); ++array)
  {
    const bool counted = std::any_of(
      arrays.begin(), array, [&array](const SceneArray& other) { return other.Key == array->Key; });
    sum += counted ? 0 : array->Size;
  }
  return sum;
}

void CopyTexels(vtkOpenGLBufferObject* source, size_t from, size_t to, size_t count)
{
  glBindBuffer(GL_COPY_READ_BUFFER, source->GetHandle());
  glCopyBufferSubData(
    GL_COPY_READ_BUFFER, GL_TEXTURE_BUFFER, GetBytes(from), GetBytes(to), GetBytes(count));
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
}
}

//------------------------------------------------------------------------------
SceneData::SceneData() = default;
SceneData::~SceneData() = default;

//------------------------------------------------------------------------------
bool SceneData::Update(vtkOpenGLRenderWindow* window, const std::vector<SceneArray>& arrays)
{
  this->KeepOnly(arrays);
  if (!this->Add(window, arrays) || !this->ViewWholeNumbers(window, GetWholeBits(arrays)))
  {
    this->Places.clear();
    return false;
  }
  this->First.clear();
  for (const SceneArray& array : arrays)
  {
    this->First.push_back(this->Find(array)->First * (32 / array.Bits) + array.Begin);
  }
  return true;
}

//------------------------------------------------------------------------------
const SceneData::Place* SceneData::Find(const SceneArray& array) const
{
  const auto it = std::find_if(this->Places.begin(), this->Places.end(),
    [&array](const Place& place) { return place.Key == array.Key && place.Bits == array.Bits; });
  return it == this->Places.end() ? nullptr : &*it;
}

//------------------------------------------------------------------------------
void SceneData::KeepOnly(const std::vector<SceneArray>& arrays)
{
  const auto isGone = [&arrays](const Place& place) {
    return std::none_of(arrays.begin(), arrays.end(), [&place](const SceneArray& array) {
      return array.Key == place.Key && array.Bits == place.Bits;
    });
  };
  this->Places.erase(
    std::remove_if(this->Places.begin(), this->Places.end(), isGone), this->Places.end());
}

//------------------------------------------------------------------------------
bool SceneData::FindGap(size_t size, size_t& first) const
{
  first = 0;
  for (const Place& place : this->Places)
  {
    if (place.First >= first + size)
    {
      return true;
    }
    first = place.First + place.Size;
  }
  return first + size <= this->Capacity;
}

//------------------------------------------------------------------------------
bool SceneData::Add(vtkOpenGLRenderWindow* window, const std::vector<SceneArray>& arrays)
{
  const size_t sum = CountAll(arrays);
  // A large buffer is given back.
  if ((sum > this->Capacity || sum < this->Capacity / 2) && !this->Allocate(window, sum))
  {
    return false;
  }
  for (const SceneArray& array : arrays)
  {
    size_t first = 0;
    if (this->Find(array))
    {
      continue;
    }
    if (!this->FindGap(array.Size, first))
    {
      if (!this->Allocate(window, sum))
      {
        return false;
      }
      this->FindGap(array.Size, first);
    }
    if (!this->Write(array, first))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool SceneData::Write(const SceneArray& array, size_t first)
{
  this->Buffer->Bind();
  void* texels = glMapBufferRange(GL_TEXTURE_BUFFER, GetBytes(first), GetBytes(array.Size),
    GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT);
  if (texels)
  {
    array.Write(texels);
  }
  const bool ok = texels && glUnmapBuffer(GL_TEXTURE_BUFFER) == GL_TRUE;
  this->Buffer->Release();
  if (!ok)
  {
    this->Error = "the graphics card did not take the media's surfaces, images and tables: draw "
                  "again, or use coarser ones";
    return false;
  }
  const Place place = { array.Key, first, array.Size, array.Bits };
  this->Places.insert(std::upper_bound(this->Places.begin(), this->Places.end(), place,
                        [](const Place& a, const Place& b) { return a.First < b.First; }),
    place);
  return true;
}

//------------------------------------------------------------------------------
// Another buffer, to which the arrays move one after the other.
bool SceneData::Allocate(vtkOpenGLRenderWindow* window, size_t texels)
{
  const size_t most = GetLargestView();
  if (texels > most)
  {
    return this->FailFit(texels, most);
  }
  vtkSmartPointer<vtkOpenGLBufferObject> before = this->Buffer;
  this->Buffer = nullptr;
  this->Capacity = 0;
  this->WholeNumbers->ReleaseGraphicsResources(window);
  this->WholeBits = 0;
  if (this->Places.empty())
  {
    // There is nothing to keep, and a card may not have room for both. The texture holds it, too.
    this->Texture->ReleaseGraphicsResources(window);
    before = nullptr;
  }
  if (texels == 0)
  {
    return true;
  }
  const size_t capacity = std::min(AddSpare(texels), most);
  ForgetErrors();
  auto buffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
  buffer->GenerateBuffer(vtkOpenGLBufferObject::TextureBuffer);
  buffer->Bind();
  glBufferData(GL_TEXTURE_BUFFER, GetBytes(capacity), nullptr, GL_STATIC_DRAW);
  bool ok = !IsOutOfMemory();
  size_t end = 0;
  for (Place& place : this->Places)
  {
    if (ok)
    {
      CopyTexels(before, place.First, end, place.Size);
    }
    place.First = end;
    end += place.Size;
  }
  buffer->Release();
  this->Texture->SetContext(window);
  ok = ok &&
    this->Texture->CreateTextureBuffer(static_cast<unsigned int>(capacity), 4, VTK_FLOAT, buffer) &&
    !IsOutOfMemory();
  if (!ok)
  {
    this->Error = "no memory on the graphics card for the media's surfaces, images and tables: use "
                  "coarser ones";
    return false;
  }
  this->Buffer = buffer;
  this->Capacity = capacity;
  return true;
}

//------------------------------------------------------------------------------
// Of the arrays of whole numbers, in texels of their own.
size_t SceneData::GetWholeEnd() const
{
  size_t end = 0;
  for (const Place& place : this->Places)
  {
    end = place.Bits < 32 ? (place.First + place.Size) * (32 / place.Bits) : end;
  }
  return end;
}

//------------------------------------------------------------------------------
// A texture shows a part of a large buffer alone, of which small texels take less.
bool SceneData::PutWholeNumbersFirst(vtkOpenGLRenderWindow* window)
{
  std::stable_sort(this->Places.begin(), this->Places.end(),
    [](const Place& a, const Place& b) { return a.Bits < 32 && b.Bits == 32; });
  size_t sum = 0;
  for (const Place& place : this->Places)
  {
    sum += place.Size;
  }
  return this->Allocate(window, sum) &&
    (this->GetWholeEnd() <= GetLargestView() ||
      this->FailFit(this->GetWholeEnd(), GetLargestView()));
}

//------------------------------------------------------------------------------
bool SceneData::ViewWholeNumbers(vtkOpenGLRenderWindow* window, int bits)
{
  if (this->GetWholeEnd() > GetLargestView() && !this->PutWholeNumbersFirst(window))
  {
    return false;
  }
  if (bits == this->WholeBits)
  {
    return true;
  }
  this->WholeNumbers->ReleaseGraphicsResources(window);
  this->WholeBits = 0;
  if (bits == 0)
  {
    return true;
  }
  const size_t texels = std::min(this->Capacity * (32 / bits), GetLargestView());
  this->WholeNumbers->SetContext(window);
  this->WholeNumbers->SetInternalFormat(bits == 8 ? GL_RGBA8 : GL_RGBA16);
  const int type = bits == 8 ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT;
  ForgetErrors();
  if (!this->WholeNumbers->CreateTextureBuffer(
        static_cast<unsigned int>(texels), 4, type, this->Buffer) ||
    IsOutOfMemory())
  {
    this->Error = "no memory on the graphics card for the media's images: use coarser ones";
    return false;
  }
  this->WholeBits = bits;
  return true;
}

//------------------------------------------------------------------------------
bool SceneData::FailFit(size_t texels, size_t most)
{
  this->Error = "surfaces, images and tables take " + std::to_string(texels) +
    " texels and the graphics card has room for " + std::to_string(most) + "; use coarser ones";
  return false;
}

//------------------------------------------------------------------------------
vtkTextureObject* SceneData::GetTexture()
{
  return this->Places.empty() ? nullptr : this->Texture.Get();
}

//------------------------------------------------------------------------------
vtkTextureObject* SceneData::GetWholeNumbers()
{
  return this->WholeBits == 0 ? nullptr : this->WholeNumbers.Get();
}

//------------------------------------------------------------------------------
void SceneData::Release(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->WholeNumbers->ReleaseGraphicsResources(window);
  this->WholeBits = 0;
  if (this->Buffer)
  {
    this->Buffer->ReleaseGraphicsResources();
  }
  this->Buffer = nullptr;
  this->Capacity = 0;
  this->Places.clear();
  this->First.clear();
}
}
