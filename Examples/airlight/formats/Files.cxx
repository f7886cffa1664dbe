// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/Files.h"

#include "formats/UserError.h"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace airlight
{

//------------------------------------------------------------------------------
void CheckInputFile(const std::string& fileName)
{
  std::error_code error;
  const auto status = std::filesystem::status(fileName, error);
  if (!std::filesystem::exists(status))
  {
    throw UserError(fileName + ": no such file");
  }
  if (std::filesystem::is_directory(status))
  {
    throw UserError(fileName + ": is a folder, not a file");
  }
  if (!std::ifstream(fileName, std::ios::binary))
  {
    throw UserError(fileName + ": cannot be opened for reading");
  }
  if (std::filesystem::is_regular_file(status) && std::filesystem::file_size(fileName, error) == 0)
  {
    throw UserError(fileName + ": the file is empty");
  }
}

//------------------------------------------------------------------------------
std::string ReadTextFile(const std::string& fileName)
{
  CheckInputFile(fileName);
  std::ifstream file(fileName, std::ios::binary);
  std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (file.bad() || text.empty())
  {
    throw UserError(fileName + ": cannot be read");
  }
  return text;
}

//------------------------------------------------------------------------------
void CheckOutputFile(const std::string& fileName)
{
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::path(fileName).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, error))
  {
    throw UserError(fileName + ": the folder " + folder.string() + " does not exist");
  }
  if (std::filesystem::is_directory(fileName, error))
  {
    throw UserError(fileName + ": is a folder, not a file");
  }
}

//------------------------------------------------------------------------------
std::string GetExtension(const std::string& fileName)
{
  std::string extension = std::filesystem::path(fileName).extension().string();
  if (!extension.empty())
  {
    extension.erase(0, 1);
  }
  for (char& c : extension)
  {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return extension;
}

}
