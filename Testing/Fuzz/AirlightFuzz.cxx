// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightFuzz.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <iterator>
#include <limits>

#include <sys/mman.h>
#include <unistd.h>

namespace
{
// Errors are composed, but not printed.
class SilentWindow : public vtkOutputWindow
{
public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
};
vtkStandardNewMacro(SilentWindow);
}

// Called by libFuzzer.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
int LLVMFuzzerInitialize(int*, char***)
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<SilentWindow> window;
  vtkOutputWindow::SetInstance(window);
  return 0;
}

namespace airlight_fuzz
{
//------------------------------------------------------------------------------
void Require(bool holds, const std::string& text)
{
  if (!holds)
  {
    std::cerr << "Not so: " << text << std::endl;
    std::abort();
  }
}

//------------------------------------------------------------------------------
void RequireFinite(const double* values, int count, const char* name)
{
  for (int i = 0; i < count; ++i)
  {
    Require(
      std::isfinite(values[i]), std::string(name) + " is finite, not " + std::to_string(values[i]));
  }
}

//------------------------------------------------------------------------------
void RequirePositive(const double* values, int count, const char* name)
{
  RequireFinite(values, count, name);
  for (int i = 0; i < count; ++i)
  {
    Require(
      values[i] >= 0.0, std::string(name) + " is at least 0, not " + std::to_string(values[i]));
  }
}

//------------------------------------------------------------------------------
const std::string& WriteInput(const uint8_t* data, size_t size, const char* extension)
{
  // A file in memory, and a name for it with the extension that readers look at.
  static const int file = memfd_create("input", 0);
  static const std::string folder = [] {
    char name[] = "/tmp/airlight-fuzz-XXXXXX";
    Require(file >= 0 && mkdtemp(name), "there is a place for the input");
    return std::string(name);
  }();
  static std::string path;
  if (path.empty())
  {
    path = folder + "/input" + extension;
    const std::string target = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(file);
    Require(symlink(target.c_str(), path.c_str()) == 0, "the input has a name");
    std::atexit([] {
      unlink(path.c_str());
      rmdir(folder.c_str());
    });
  }
  Require(ftruncate(file, 0) == 0 && pwrite(file, data, size, 0) == static_cast<ssize_t>(size),
    "the input is written");
  return path;
}

//------------------------------------------------------------------------------
double Input::Number()
{
  constexpr double special[] = { 0.0, -0.0, 1.0, -1.0, 1e-300, 5e-324, 1e15, 1e30, 1e38, 1e100,
    1e101, std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() };
  switch (this->Integer(0, 7))
  {
    case 0:
      return special[this->Integer(0, static_cast<int>(std::size(special)) - 1)];
    case 1:
      return std::pow(10.0, this->Integer(-40, 40)) * (this->Flag() ? -1.0 : 1.0);
    case 2:
    {
      const auto bits = this->Provider.ConsumeIntegral<uint64_t>();
      double value = 0.0;
      std::memcpy(&value, &bits, sizeof(value));
      return value;
    }
    case 3:
    case 4:
      return this->Integer(-32768, 32767) / 3000.0;
    case 5:
      return this->Integer(0, 1000) / 1000.0;
    default:
      return this->Modest();
  }
}

//------------------------------------------------------------------------------
Vector Input::Point()
{
  if (this->Points < 0)
  {
    this->Points = this->Integer(0, 7) == 7 ? 1 : 0;
  }
  return this->Points == 1 ? this->Numbers() : this->ModestVector();
}
}
