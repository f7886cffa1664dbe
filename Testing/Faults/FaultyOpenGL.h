// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An OpenGL that refuses what a test asks it to refuse, as a graphics card does that is old or
 * whose memory is full. This program's functions stand before OpenGL's, for VTK and the pass, too:
 * those that VTK is linked with by name, the others where its loader (GLEW, glad) asks for their
 * addresses (FaultyLoader.cxx).
 */

#ifndef FaultyOpenGL_h
#define FaultyOpenGL_h

#include <string>

namespace airlight_test
{
enum class Refusal
{
  None,
  Buffers,     // glBufferData() has no memory
  Textures,    // glTexImage2D() has no memory
  Framebuffers // glCheckFramebufferStatus() says no
};

// This program's function of that name, which calls OpenGL's own, `real`; `real` for any other
// name.
using Function = void (*)();
Function ReplaceFunction(const char* name, Function real);

// From now on the call of this number, counted from 1, is refused; with 0 none is, and they are
// only counted.
void Refuse(Refusal what, int number);
int CountCalls();

// Shaders whose text has this word do not compile; none if it is empty. Returns how many met that
// since the last call.
int RefuseShaders(const std::string& word);

// What OpenGL says of itself; 0: the truth. VTK asks for the version and the size of textures once
// for each window.
void ClaimVersion(int major, int minor);
void ClaimTextureSize(int most);
void ClaimTextureBufferSize(int most);

// All of OpenGL's answers are that the context is lost.
void LoseContext(bool lost);
}

#endif
