// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LoadTools.h"

#include "OpenGL/AirlightOpenGL.h"

#include <fstream>
#include <iomanip>
#include <sstream>
#include <unistd.h>

namespace airlightload
{
//------------------------------------------------------------------------------
double GetResident()
{
  std::ifstream file("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

//------------------------------------------------------------------------------
double GetPeak()
{
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
  {
    double kib = 0.0;
    if (word == "VmHWM:" && file >> kib)
    {
      return kib / 1024;
    }
  }
  return 0.0;
}

//------------------------------------------------------------------------------
// OpenGL gives the smallest numbers that are free.
int CountObjects(vtkRenderWindow* window)
{
  window->MakeCurrent();
  int count = 0;
  for (GLuint id = 1; id < 20000; ++id)
  {
    count += (glIsTexture(id) != 0) + (glIsBuffer(id) != 0) + (glIsRenderbuffer(id) != 0) +
      (glIsFramebuffer(id) != 0) + (glIsVertexArray(id) != 0);
  }
  return count;
}

//------------------------------------------------------------------------------
void Digest::Add(const void* bytes, size_t count)
{
  const auto* first = static_cast<const unsigned char*>(bytes);
  for (size_t i = 0; i < count; ++i)
  {
    this->Value = (this->Value ^ first[i]) * 1099511628211ull;
  }
}

//------------------------------------------------------------------------------
void Digest::Add(vtkImageData* image)
{
  if (Check(image != nullptr, "there is a buffer"))
  {
    this->Add(image->GetScalarPointer(),
      static_cast<size_t>(image->GetNumberOfPoints()) * image->GetNumberOfScalarComponents() *
        image->GetScalarSize());
  }
}

//------------------------------------------------------------------------------
void Digest::Add(const airlight_test::Picture& picture)
{
  this->Add(picture.data(), picture.size() * sizeof(picture[0]));
}

//------------------------------------------------------------------------------
std::string Digest::GetText() const
{
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << this->Value;
  return text.str();
}
}
