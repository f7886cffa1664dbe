// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Programs from VTK's shader cache, and what becomes of those that do not compile.
 *
 * The cache keeps a text that failed and never compiles it again. So another attempt is made with a
 * comment at the text's end. As compilers take their time, and as VTK prints the whole text each
 * time, the first attempt comes at once and further ones after 1, 3, 7, ... calls.
 */

#ifndef AirlightProgram_h
#define AirlightProgram_h

#include <string>

class vtkObjectBase;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkShaderProgram;

namespace airlight
{
// First lines of a shader; `storage`: it has storage buffers.
std::string GetShaderVersion(bool storage);

// A line that defines a macro.
std::string Define(const std::string& name, int value);

// Whether `pass` is the last that changes a prop's shaders; null: whether no pass does. Where
// others do later, or the user's replacements, what is compiled is known to the mapper alone.
bool IsLastToChange(const vtkObjectBase* pass, vtkProp* prop);

class ProgramMaker
{
public:
  // Null where it does not compile or link, or where it is too early for another attempt. The
  // fragment shader may get the comment.
  vtkShaderProgram* GetOrCompile(vtkOpenGLRenderWindow* window, const std::string& vertex,
    std::string& fragment, const std::string& geometry = "");

  // For error messages, after what did not compile.
  static const char* GetReason()
  {
    return " did not compile; VTK's message before this one has the compiler's words. Update the "
           "graphics driver, or use another; with dozens of lights, switch some off";
  }

private:
  std::string Failed; // the last text that did
  int Failures = 0;
  int Waits = 0; // calls until it is tried again
};
}

#endif
