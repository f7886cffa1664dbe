// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightDistancePrograms.h"

#include "AirlightOpenGL.h"

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
// Longer ones than any of VTK's.
using Name = std::array<char, 256>;

// Outputs that VTK numbers.
constexpr GLuint MostOutputs = 8;

// The fragment shader without what shades; empty where all of it is needed.
std::string CutShading(const std::string& source)
{
  const size_t line = source.find('\n');
  return line == std::string::npos || source.find("AIRLIGHT_ONLY_DISTANCES") == std::string::npos
    ? std::string()
    : source.substr(0, line + 1) + "#define AIRLIGHT_ONLY_DISTANCES\n" + source.substr(line + 1);
}

// Whether a mapper draws with one program between one update of its uniforms and the next. Others, as
// those of composite data, set some for each part.
bool DrawsAtOnce(vtkAbstractMapper* mapper)
{
  const std::string name = mapper->GetClassName();
  return name == "vtkOpenGLPolyDataMapper" || name == "vtkAirlightPolyDataMapper";
}

bool IsInteger(GLenum type)
{
  return type == GL_INT || type == GL_INT_VEC2 || type == GL_BOOL || type == GL_SAMPLER_2D ||
    type == GL_SAMPLER_BUFFER;
}

bool IsFloat(GLenum type)
{
  return type == GL_FLOAT || type == GL_FLOAT_VEC2 || type == GL_FLOAT_VEC3 ||
    type == GL_FLOAT_VEC4 || type == GL_FLOAT_MAT3 || type == GL_FLOAT_MAT4;
}
}

//------------------------------------------------------------------------------
// The mapper's event is the last before it draws; the observers of others, who may set uniforms, come
// before this one.
void DistancePrograms::Watch(vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper)
{
  if (!DrawsAtOnce(mapper) || this->Watched.count(mapper) > 0)
  {
    return;
  }
  this->Window = window;
  this->Command->SetClientData(this);
  this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* program) {
    static_cast<DistancePrograms*>(self)->Use(static_cast<vtkShaderProgram*>(program));
  });
  constexpr float last = -1000.0f;
  this->Watched[mapper] = mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->Command, last);
}

//------------------------------------------------------------------------------
void DistancePrograms::Unwatch()
{
  for (const auto& watched : this->Watched)
  {
    watched.first->RemoveObserver(watched.second);
  }
  this->Watched.clear();
}

//------------------------------------------------------------------------------
// Programs are deleted, and made again at the same place, when the window's resources are.
bool DistancePrograms::IsCurrent(const Twin& twin)
{
  return twin.Original && twin.Original->GetHandle() == twin.OriginalHandle &&
    (twin.Handle == 0 || (twin.Program && twin.Program->GetHandle() == twin.Handle));
}

//------------------------------------------------------------------------------
void DistancePrograms::Use(vtkShaderProgram* program)
{
  Twin& twin = this->Twins[program];
  if (!IsCurrent(twin))
  {
    twin = Make(this->Window, program);
  }
  vtkOpenGLShaderCache* cache = this->Window->GetShaderCache();
  if (!twin.Program)
  {
    cache->ReadyShaderProgram(program);
    return;
  }
  // The cache is to know what is bound: the mapper's next update binds its own again.
  cache->ReadyShaderProgram(twin.Program);
  for (const Uniform& uniform : twin.Uniforms)
  {
    Copy(uniform, twin.OriginalHandle);
  }
}

//------------------------------------------------------------------------------
DistancePrograms::Twin DistancePrograms::Make(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
{
  Twin none;
  none.Original = program;
  none.OriginalHandle = program->GetHandle();
  const std::string fragment = CutShading(program->GetFragmentShader()->GetSource());
  if (fragment.empty() || !program->GetGeometryShader()->GetSource().empty())
  {
    return none;
  }
  Twin twin = none;
  twin.Program = window->GetShaderCache()->ReadyShaderProgram(
    program->GetVertexShader()->GetSource().c_str(), fragment.c_str(), "");
  if (!twin.Program || !twin.Program->GetCompiled())
  {
    return none;
  }
  twin.Handle = twin.Program->GetHandle();
  return Link(twin) && FindUniforms(twin) ? twin : none;
}

//------------------------------------------------------------------------------
// Once more, with the mapper's attributes where its vertex arrays have them, and outputs as VTK numbers
// them.
bool DistancePrograms::Link(Twin& twin)
{
  const auto from = static_cast<GLuint>(twin.OriginalHandle);
  const auto to = static_cast<GLuint>(twin.Handle);
  GLint count = 0;
  glGetProgramiv(from, GL_ACTIVE_ATTRIBUTES, &count);
  for (GLint i = 0; i < count; ++i)
  {
    Name name{};
    GLint size = 0;
    GLenum type = 0;
    glGetActiveAttrib(
      from, static_cast<GLuint>(i), name.size(), nullptr, &size, &type, name.data());
    const GLint place = glGetAttribLocation(from, name.data());
    if (place >= 0) // not of gl_VertexID and the like
    {
      glBindAttribLocation(to, static_cast<GLuint>(place), name.data());
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
bool DistancePrograms::FindUniforms(Twin& twin)
{
  const auto from = static_cast<GLuint>(twin.OriginalHandle);
  const auto to = static_cast<GLuint>(twin.Handle);
  GLint count = 0;
  glGetProgramiv(to, GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    Name name{};
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(to, static_cast<GLuint>(i), name.size(), nullptr, &size, &type, name.data());
    const std::string first = name.data();
    const std::string base = first.substr(0, first.find("[0]"));
    for (GLint element = 0; element < size; ++element)
    {
      const std::string one = size > 1 ? base + "[" + std::to_string(element) + "]" : first;
      const Uniform uniform = { glGetUniformLocation(from, one.c_str()),
        glGetUniformLocation(to, one.c_str()), type };
      if (uniform.From < 0 || uniform.To < 0 || !(IsInteger(type) || IsFloat(type)))
      {
        return false;
      }
      twin.Uniforms.push_back(uniform);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void DistancePrograms::Copy(const Uniform& uniform, int from)
{
  std::array<GLfloat, 16> reals{};
  std::array<GLint, 4> integers{};
  if (IsFloat(uniform.Type))
  {
    glGetUniformfv(static_cast<GLuint>(from), uniform.From, reals.data());
  }
  else
  {
    glGetUniformiv(static_cast<GLuint>(from), uniform.From, integers.data());
  }
  switch (uniform.Type)
  {
    case GL_FLOAT:
      glUniform1fv(uniform.To, 1, reals.data());
      break;
    case GL_FLOAT_VEC2:
      glUniform2fv(uniform.To, 1, reals.data());
      break;
    case GL_FLOAT_VEC3:
      glUniform3fv(uniform.To, 1, reals.data());
      break;
    case GL_FLOAT_VEC4:
      glUniform4fv(uniform.To, 1, reals.data());
      break;
    case GL_FLOAT_MAT3:
      glUniformMatrix3fv(uniform.To, 1, GL_FALSE, reals.data());
      break;
    case GL_FLOAT_MAT4:
      glUniformMatrix4fv(uniform.To, 1, GL_FALSE, reals.data());
      break;
    case GL_INT_VEC2:
      glUniform2iv(uniform.To, 1, integers.data());
      break;
    default:
      glUniform1iv(uniform.To, 1, integers.data());
      break;
  }
}
}
