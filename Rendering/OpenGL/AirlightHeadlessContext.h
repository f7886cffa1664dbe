// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An OpenGL context without a screen, by EGL. The library libEGL is opened while the program runs:
 * where it is missing, the first use says so.
 */

#ifndef AirlightHeadlessContext_h
#define AirlightHeadlessContext_h

#include "vtkAirlightModule.h" // for export macro

#include <memory>
#include <string>
#include <vector>

namespace airlight
{
class VTKAIRLIGHT_EXPORT HeadlessContext
{
public:
  using Function = void (*)();

  // A context of the newest OpenGL that a device gives. Null where there is none; `problem` then is
  // a sentence with the remedy. Devices are counted from 0, graphics cards before software.
  static std::unique_ptr<HeadlessContext> Make(int device, std::string& problem);

  // 0 where EGL is missing.
  static int CountDevices();

  // A function of OpenGL by its name. Null where there is none.
  static Function Find(const char* name);

  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  void operator=(const HeadlessContext&) = delete;

  // For this thread, in place of another of EGL or GLX. Release() makes room for one of GLX, which
  // would be refused.
  bool MakeCurrent() const;
  void Release() const;
  bool IsCurrent() const;

  // MakeCurrent(), and back to what was current before, of EGL or of GLX. Pairs may be nested.
  void Push();
  void Pop();

private:
  // What is current in a thread.
  struct Current
  {
    void* Display = nullptr;
    void* Surface = nullptr;    // of EGL
    unsigned long Drawable = 0; // of GLX
    void* Context = nullptr;
  };
  static Current GetCurrent();

  HeadlessContext() = default;

  void* Display = nullptr;
  void* Surface = nullptr; // is never drawn into
  void* Context = nullptr;
  std::vector<Current> Before;
};
}

#endif
