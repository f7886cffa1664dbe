// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneFile.h"

#include "formats/UserError.h"

#include <filesystem>
#include <system_error>

namespace airlight
{

//------------------------------------------------------------------------------
// The reference keeps scenes/ and meshes/ side by side, others may keep a mesh beside its scene.
std::string FindSceneFile(const LocatedJson& json, const std::string& sceneFile)
{
  const std::string name = json.GetString();
  const std::filesystem::path folder = std::filesystem::absolute(sceneFile).parent_path();
  for (const auto& candidate : { folder / name, folder.parent_path() / name })
  {
    std::error_code error;
    if (std::filesystem::is_regular_file(candidate, error))
    {
      return candidate.string();
    }
  }
  json.Fail("names a file that does not exist: \"" + name + "\" (looked in " + folder.string() +
    " and in " + folder.parent_path().string() + ")");
}

//------------------------------------------------------------------------------
void UseSceneFile(const LocatedJson& json, const std::function<void()>& task)
{
  try
  {
    task();
  }
  catch (const UserError& error)
  {
    json.Fail(std::string("cannot be used: ") + error.what());
  }
}

}
