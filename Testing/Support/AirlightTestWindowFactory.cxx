// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause

// With AIRLIGHT_TEST_EGL in the environment, every window of a test is a vtkAirlightHeadlessWindow:
// a graphics card without an X server then draws the tests. This source is part of each test
// program, which would leave it out of a library.

#include "vtkAirlightHeadlessWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkVersion.h"

#include <cstdlib>

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkAirlightHeadlessWindow);

//------------------------------------------------------------------------------
class WindowFactory : public vtkObjectFactory
{
public:
  static WindowFactory* New()
  {
    auto* factory = new WindowFactory;
    factory->InitializeObjectBase();
    return factory;
  }
  vtkTypeMacro(WindowFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Windows without a screen"; }

protected:
  WindowFactory()
  {
    for (const char* name : { "vtkRenderWindow", "vtkOpenGLRenderWindow" })
    {
      this->RegisterOverride(name, "vtkAirlightHeadlessWindow", this->GetDescription(), 1,
        vtkObjectFactoryCreatevtkAirlightHeadlessWindow);
    }
  }
};

//------------------------------------------------------------------------------
struct RegisterWindows
{
  RegisterWindows()
  {
    if (!std::getenv("AIRLIGHT_TEST_EGL"))
    {
      return;
    }
    // The first factory wins, and VTK's may have been registered before.
    vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindow");
    vtkNew<WindowFactory> factory;
    vtkObjectFactory::RegisterFactory(factory);
  }
};

const RegisterWindows registerWindows;
}
