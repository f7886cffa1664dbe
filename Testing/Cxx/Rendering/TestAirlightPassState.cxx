// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// OpenGL's state after a frame of the pass is that after a frame without it, and what VTK keeps in
// mind of it is true. The pass leaves none of its storage buffers bound.

#include "AirlightTestCheck.h"
#include "AirlightTestWindowScene.h"

#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <cstdlib>
#include <map>

using namespace airlight_test;

namespace
{
using State = std::map<std::string, std::vector<GLint>>;

void Add(State& state, const char* name, GLenum what, int count = 1)
{
  std::vector<GLint> values(4, 0);
  glGetIntegerv(what, values.data());
  values.resize(count);
  state[name] = values;
}

State GetState()
{
  State state;
#define AIRLIGHT_ADD(name, ...) Add(state, #name, name, ##__VA_ARGS__)
  AIRLIGHT_ADD(GL_BLEND);
  AIRLIGHT_ADD(GL_BLEND_DST_ALPHA);
  AIRLIGHT_ADD(GL_BLEND_DST_RGB);
  AIRLIGHT_ADD(GL_BLEND_EQUATION_ALPHA);
  AIRLIGHT_ADD(GL_BLEND_EQUATION_RGB);
  AIRLIGHT_ADD(GL_BLEND_SRC_ALPHA);
  AIRLIGHT_ADD(GL_BLEND_SRC_RGB);
  AIRLIGHT_ADD(GL_COLOR_WRITEMASK, 4);
  AIRLIGHT_ADD(GL_CULL_FACE);
  AIRLIGHT_ADD(GL_CULL_FACE_MODE);
  AIRLIGHT_ADD(GL_DEPTH_CLAMP);
  AIRLIGHT_ADD(GL_DEPTH_FUNC);
  AIRLIGHT_ADD(GL_DEPTH_TEST);
  AIRLIGHT_ADD(GL_DEPTH_WRITEMASK);
  AIRLIGHT_ADD(GL_DRAW_FRAMEBUFFER_BINDING);
  AIRLIGHT_ADD(GL_FRONT_FACE);
  AIRLIGHT_ADD(GL_POLYGON_OFFSET_FACTOR);
  AIRLIGHT_ADD(GL_POLYGON_OFFSET_FILL);
  AIRLIGHT_ADD(GL_POLYGON_OFFSET_UNITS);
  AIRLIGHT_ADD(GL_READ_FRAMEBUFFER_BINDING);
  AIRLIGHT_ADD(GL_SCISSOR_BOX, 4);
  AIRLIGHT_ADD(GL_SCISSOR_TEST);
  AIRLIGHT_ADD(GL_STENCIL_TEST);
  AIRLIGHT_ADD(GL_VERTEX_ARRAY_BINDING);
  AIRLIGHT_ADD(GL_VIEWPORT, 4);
#undef AIRLIGHT_ADD
  return state;
}

std::string ToText(const std::vector<GLint>& values)
{
  std::string text;
  for (const GLint value : values)
  {
    text += " " + std::to_string(value);
  }
  return text;
}

void CheckStorage(const std::string& what)
{
  GLint count = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &count);
  for (GLint binding = 0; binding < count; ++binding)
  {
    GLint buffer = 0;
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, binding, &buffer);
    Check(buffer == 0, what + ": storage binding " + std::to_string(binding) + " is free");
  }
}

// Draws a frame without the pass and one with it.
void Compare(const std::string& what, WindowScene& scene)
{
  vtkAirlightPass* pass = scene.Pass;
  scene.Renderer->SetPass(nullptr);
  scene.Window->Render();
  const State plain = GetState();
  scene.Renderer->SetPass(pass);
  scene.Window->Render();
  const State drawn = GetState();
  for (const auto& entry : plain)
  {
    const std::vector<GLint>& now = drawn.at(entry.first);
    if (!Check(now == entry.second, what + ": " + entry.first + " is as without the pass"))
    {
      std::cout << "  without:" << ToText(entry.second) << ", with:" << ToText(now) << "\n";
    }
  }
  CheckStorage(what);
  // Reads back what is not as VTK's record has it.
  auto* window = static_cast<vtkOpenGLRenderWindow*>(scene.Window.Get());
  Check(
    ToText({ window->GetState()->GetEnumState(GL_DEPTH_TEST),
      window->GetState()->GetEnumState(GL_BLEND), window->GetState()->GetEnumState(GL_CULL_FACE),
      window->GetState()->GetEnumState(GL_SCISSOR_TEST) }) ==
      ToText({ drawn.at("GL_DEPTH_TEST")[0], drawn.at("GL_BLEND")[0], drawn.at("GL_CULL_FACE")[0],
        drawn.at("GL_SCISSOR_TEST")[0] }),
    what + ": VTK's record is true");
}
}

//------------------------------------------------------------------------------
int TestAirlightPassState(int, char*[])
{
  for (int technique = vtkAirlightPass::NONE; technique <= vtkAirlightPass::RAY_MARCH; ++technique)
  {
    for (const bool glass : { false, true })
    {
      WindowScene scene;
      scene.Pass->SetShadowTechnique(technique);
      scene.Ball->GetProperty()->SetOpacity(glass ? 0.5 : 1.0);
      Compare("technique " + std::to_string(technique) + (glass ? ", glass" : ""), scene);
    }
  }
  WindowScene wires;
  wires.Pass->SetDebugViewToShadowPlanes();
  Compare("view of shadow planes", wires);
  WindowScene scattered;
  scattered.Pass->SetScatteredSurfaceLight(true);
  Compare("scattered light on surfaces", scattered);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
