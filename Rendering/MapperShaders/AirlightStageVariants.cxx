// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightStageVariants.h"

#include "OpenGL/AirlightOpenGL.h"
#include "Scene/AirlightClassTraits.h"

#include "vtkCommand.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <array>
#include <string>

namespace airlight
{
namespace
{
// Outputs that VTK numbers.
constexpr GLuint MostOutputs = 8;

// The fragment shader without what shades; empty where all of it is needed.
std::string CutShading(const std::string& source, SurfaceStage stage)
{
  const size_t line = source.find('\n');
  const std::string macro = GetStageMacro(stage);
  return line == std::string::npos || source.find(macro) == std::string::npos
    ? std::string()
    : source.substr(0, line + 1) + "#define " + macro + "\n" + source.substr(line + 1);
}

// Whether a mapper draws with one program between one update of its uniforms and the next. Others,
// as those of composite data, set some for each part.
bool DrawsInOneCall(vtkAbstractMapper* mapper)
{
  return HasTrait(mapper, ClassTrait::OneProgram) ||
    std::string("vtkAirlightPolyDataMapper") == mapper->GetClassName();
}

// A uniform or an attribute that a program uses.
struct Active
{
  std::string Name;
  GLint Size = 0;
  GLenum Type = 0;
};

// `count` is the name of their number, `get` OpenGL's function that tells of one.
template <class Get>
std::vector<Active> ListActive(GLuint program, GLenum count, Get get)
{
  GLint number = 0;
  glGetProgramiv(program, count, &number);
  std::vector<Active> all(number);
  for (size_t i = 0; i < all.size(); ++i)
  {
    std::array<char, 256> name{}; // longer ones than any of VTK's
    get(program, static_cast<GLuint>(i), name.size(), nullptr, &all[i].Size, &all[i].Type,
      name.data());
    all[i].Name = name.data();
  }
  return all;
}

std::array<GLfloat, 16> GetReals(GLuint program, GLint location)
{
  std::array<GLfloat, 16> values{};
  glGetUniformfv(program, location, values.data());
  return values;
}

std::array<GLint, 4> GetIntegers(GLuint program, GLint location)
{
  std::array<GLint, 4> values{};
  glGetUniformiv(program, location, values.data());
  return values;
}

// How a uniform of this type is copied from a program to the current one; null: it is not.
CopyUniform FindCopy(GLenum type)
{
  switch (type)
  {
    case GL_FLOAT:
      return [](unsigned int program, int from, int to) {
        glUniform1fv(to, 1, GetReals(program, from).data());
      };
    case GL_FLOAT_VEC2:
      return [](unsigned int program, int from, int to) {
        glUniform2fv(to, 1, GetReals(program, from).data());
      };
    case GL_FLOAT_VEC3:
      return [](unsigned int program, int from, int to) {
        glUniform3fv(to, 1, GetReals(program, from).data());
      };
    case GL_FLOAT_VEC4:
      return [](unsigned int program, int from, int to) {
        glUniform4fv(to, 1, GetReals(program, from).data());
      };
    case GL_FLOAT_MAT3:
      return [](unsigned int program, int from, int to) {
        glUniformMatrix3fv(to, 1, GL_FALSE, GetReals(program, from).data());
      };
    case GL_FLOAT_MAT4:
      return [](unsigned int program, int from, int to) {
        glUniformMatrix4fv(to, 1, GL_FALSE, GetReals(program, from).data());
      };
    case GL_INT:
    case GL_BOOL:
    case GL_SAMPLER_2D:
    case GL_SAMPLER_BUFFER:
      return [](unsigned int program, int from, int to) {
        glUniform1iv(to, 1, GetIntegers(program, from).data());
      };
    case GL_INT_VEC2:
      return [](unsigned int program, int from, int to) {
        glUniform2iv(to, 1, GetIntegers(program, from).data());
      };
    default:
      return nullptr;
  }
}
}

//------------------------------------------------------------------------------
// The mapper's event is the last before it draws; the observers of others, who may set uniforms,
// come before this one.
void StageVariants::Observe(
  vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper, SurfaceStage stage)
{
  if (!DrawsInOneCall(mapper) || this->Observed.count(mapper) > 0)
  {
    return;
  }
  this->Window = window;
  this->Stage = stage;
  this->Command->SetClientData(this);
  this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* program) {
    static_cast<StageVariants*>(self)->Use(static_cast<vtkShaderProgram*>(program));
  });
  constexpr float last = -1000.0f;
  this->Observed[mapper] = mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->Command, last);
}

//------------------------------------------------------------------------------
void StageVariants::StopObserving()
{
  for (const auto& observed : this->Observed)
  {
    observed.first->RemoveObserver(observed.second);
  }
  this->Observed.clear();
}

//------------------------------------------------------------------------------
// Programs are deleted, and made again at the same place, when the window's resources are.
bool StageVariants::IsCurrent(const Variant& variant)
{
  return variant.Original && variant.Original->GetHandle() == variant.OriginalHandle &&
    (variant.Handle == 0 || (variant.Program && variant.Program->GetHandle() == variant.Handle));
}

//------------------------------------------------------------------------------
void StageVariants::Use(vtkShaderProgram* program)
{
  Variant& variant = this->Variants[{ program, this->Stage }];
  if (!IsCurrent(variant))
  {
    variant = Make(this->Window, program, this->Stage);
  }
  vtkOpenGLShaderCache* cache = this->Window->GetShaderCache();
  if (!variant.Program)
  {
    cache->ReadyShaderProgram(program);
    return;
  }
  // The cache is to know what is bound: the mapper's next update binds its own again.
  cache->ReadyShaderProgram(variant.Program);
  for (const Uniform& uniform : variant.Uniforms)
  {
    uniform.Copy(static_cast<GLuint>(variant.OriginalHandle), uniform.From, uniform.To);
  }
}

//------------------------------------------------------------------------------
StageVariants::Variant StageVariants::Make(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program, SurfaceStage stage)
{
  Variant none;
  none.Original = program;
  none.OriginalHandle = program->GetHandle();
  const std::string fragment = CutShading(program->GetFragmentShader()->GetSource(), stage);
  if (fragment.empty() || !program->GetGeometryShader()->GetSource().empty())
  {
    return none;
  }
  Variant variant = none;
  variant.Program = window->GetShaderCache()->ReadyShaderProgram(
    program->GetVertexShader()->GetSource().c_str(), fragment.c_str(), "");
  if (!variant.Program || !variant.Program->GetCompiled())
  {
    return none;
  }
  variant.Handle = variant.Program->GetHandle();
  return Link(variant) && FindUniforms(variant) ? variant : none;
}

//------------------------------------------------------------------------------
// Once more, with the mapper's attributes where its vertex arrays have them, and outputs as VTK
// numbers them.
bool StageVariants::Link(Variant& variant)
{
  const auto from = static_cast<GLuint>(variant.OriginalHandle);
  const auto to = static_cast<GLuint>(variant.Handle);
  for (const Active& attribute : ListActive(from, GL_ACTIVE_ATTRIBUTES, glGetActiveAttrib))
  {
    const GLint location = glGetAttribLocation(from, attribute.Name.c_str());
    if (location >= 0) // not of gl_VertexID and the like
    {
      glBindAttribLocation(to, static_cast<GLuint>(location), attribute.Name.c_str());
    }
  }
  for (GLuint i = 0; i < MostOutputs; ++i)
  {
    glBindFragDataLocation(to, i, ("fragOutput" + std::to_string(i)).c_str());
  }
  glLinkProgram(to);
  GLint linked = 0;
  glGetProgramiv(to, GL_LINK_STATUS, &linked);
  return linked != 0;
}

//------------------------------------------------------------------------------
// False where one is of a kind that cannot be copied.
bool StageVariants::FindUniforms(Variant& variant)
{
  const auto from = static_cast<GLuint>(variant.OriginalHandle);
  const auto to = static_cast<GLuint>(variant.Handle);
  for (const Active& active : ListActive(to, GL_ACTIVE_UNIFORMS, glGetActiveUniform))
  {
    const std::string base = active.Name.substr(0, active.Name.find("[0]"));
    for (GLint element = 0; element < active.Size; ++element)
    {
      const std::string one =
        active.Size > 1 ? base + "[" + std::to_string(element) + "]" : active.Name;
      const Uniform uniform = { glGetUniformLocation(from, one.c_str()),
        glGetUniformLocation(to, one.c_str()), FindCopy(active.Type) };
      if (uniform.From < 0 || uniform.To < 0 || !uniform.Copy)
      {
        return false;
      }
      variant.Uniforms.push_back(uniform);
    }
  }
  return true;
}
}
