// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the load tests measure: memory, OpenGL's objects, time, and whether bytes are the same.
 */

#ifndef LoadTools_h
#define LoadTools_h

#include "AirlightTestWindowScene.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace airlightload
{
using airlight_test::Check;

struct Options
{
  int Frames = 10000;
  int Lights = 64;
  int Actors = 2000;
  double Triangles = 10e6;
  std::vector<int> Size;
  int Scale = 0;
  bool Plain = false;
  std::string Scene;
};

// The process's resident set, MiB; 0 where the system does not tell.
double GetResident();

// The largest it has been, MiB.
double GetPeak();

// Textures, buffers, renderbuffers, framebuffers and vertex arrays of a window.
int CountObjects(vtkRenderWindow* window);

class Clock
{
public:
  double GetSeconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

// A number that other bytes most likely do not have (FNV-1a).
class Digest
{
public:
  void Add(const void* bytes, size_t count);
  void Add(vtkImageData* image);
  void Add(const airlight_test::Picture& picture);
  std::string GetText() const;

private:
  std::uint64_t Value = 14695981039346656037ull;
};

// The subcommands.
void RunFrames(const Options& options);
void RunLights(const Options& options);
void RunActors(const Options& options);
void RunTriangles(const Options& options);
void RunTiles(const Options& options);
void RunDigests(const Options& options);
void RunProcesses(const Options& options, const std::string& program);
}

#endif
