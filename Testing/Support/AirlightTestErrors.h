// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Listens to an object's errors, which then are not printed.
 */

#ifndef AirlightTestErrors_h
#define AirlightTestErrors_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <string>
#include <vector>

namespace airlight_test
{
class ErrorListener
{
public:
  // The event: errors or warnings.
  explicit ErrorListener(vtkObject* object, unsigned long event = vtkCommand::ErrorEvent)
    : Object(object)
  {
    this->Command->SetClientData(&this->Texts);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* texts, void* text) {
      static_cast<std::vector<std::string>*>(texts)->push_back(static_cast<const char*>(text));
    });
    this->Tag = object->AddObserver(event, this->Command);
  }
  ~ErrorListener() { this->Object->RemoveObserver(this->Tag); }
  ErrorListener(const ErrorListener&) = delete;
  void operator=(const ErrorListener&) = delete;

  // How many came since the last call; GetText() then returns the last of them.
  int Take()
  {
    const int count = static_cast<int>(this->Texts.size());
    this->Last = count > 0 ? this->Texts.back() : "";
    this->Texts.clear();
    return count;
  }
  const std::string& GetText() const { return this->Last; }

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag;
  std::vector<std::string> Texts;
  std::string Last;
};
}

#endif
