// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Scene files. Beside the scene lie a closed mesh (m.ply), a lamp (l.ies) and a phase table (p.csv),
// which it may name.

#include "AirlightFuzz.h"

#include "formats/UserError.h"
#include "scene/SceneReader.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace airlight_fuzz;

namespace
{
constexpr const char* Mesh = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                             "property float y\nproperty float z\nelement face 4\n"
                             "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n"
                             "0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
constexpr const char* Lamp = "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 10\n"
                             "0 90\n0\n100 50\n";
constexpr const char* Table = "0,3\n60,2\n180,1\n";

std::string MakeFolder()
{
  char name[] = "/tmp/airlight-fuzz-XXXXXX";
  Require(mkdtemp(name), "there is a place for the scene");
  const std::string folder = std::string(name) + "/";
  std::ofstream(folder + "m.ply") << Mesh;
  std::ofstream(folder + "l.ies") << Lamp;
  std::ofstream(folder + "p.csv") << Table;
  return folder;
}
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  static const std::string folder = MakeFolder();
  static const int atExit = std::atexit([] { std::filesystem::remove_all(folder); });
  Require(atExit == 0, "the folder will go");
  const std::string file = folder + "scene.json";
  std::ofstream(file, std::ios::binary)
    .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try
  {
    const airlight::Scene scene = airlight::ReadScene(file);
    Require(scene.Width > 0 && scene.Height > 0 && scene.Medium, "the scene is complete");
    RequireFinite(scene.Camera.Position.data(), 3, "the camera's position");
    double bounds[6] = {};
    scene.GetBounds(bounds);
    RequireFinite(bounds, 6, "the bounds");
  }
  catch (const airlight::UserError& error)
  {
    Require(std::string(error.what()).rfind(file, 0) == 0,
      std::string("the error names the scene: ") + error.what());
  }
  return 0;
}
