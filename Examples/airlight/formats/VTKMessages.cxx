// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/VTKMessages.h"

#include "formats/UserError.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <cctype>
#include <iostream>

namespace airlight
{

namespace
{
// VTK's messages look like "ERROR: In <source>, line <n>\n<class> (<address>): <text>\n\n".
std::string GetPlainText(const std::string& message)
{
  std::size_t begin = message.find('\n');
  begin = begin == std::string::npos ? 0 : begin + 1;
  const std::size_t address = message.find("): ", begin);
  const std::size_t opening = message.find(" (0x", begin);
  if (opening != std::string::npos && address != std::string::npos && opening < address)
  {
    begin = address + 3;
  }
  std::string text;
  for (char c : message.substr(begin))
  {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!blank || (!text.empty() && text.back() != ' '))
    {
      text += blank ? ' ' : c;
    }
  }
  return text.substr(0, text.find_last_not_of(' ') + 1).substr(0, 300);
}

// That a reader failed is said once more by the pipeline that ran it, without a reason.
bool HasReason(const std::string& text)
{
  return text.find("returned failure for request") == std::string::npos;
}

void KeepFirst(std::string& first, const char* message)
{
  const std::string text = GetPlainText(message ? message : "");
  if (first.empty() && HasReason(text))
  {
    first = text;
  }
}
}

//------------------------------------------------------------------------------
class VTKMessages::Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override { KeepFirst(this->Error, text); }
  void DisplayWarningText(const char* text) override { KeepFirst(this->Warning, text); }
  void DisplayGenericWarningText(const char* text) override { KeepFirst(this->Warning, text); }

  std::string Error;
  std::string Warning;
};
vtkStandardNewMacro(VTKMessages::Collector);

//------------------------------------------------------------------------------
VTKMessages::VTKMessages()
  : Previous(vtkOutputWindow::GetInstance())
  , Current(vtkSmartPointer<Collector>::New())
  , Verbosity(vtkLogger::GetCurrentVerbosityCutoff())
{
  vtkOutputWindow::SetInstance(this->Current);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // it would print them all the same
}

//------------------------------------------------------------------------------
VTKMessages::~VTKMessages()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::ConvertToVerbosity(this->Verbosity));
  vtkOutputWindow::SetInstance(this->Previous);
}

//------------------------------------------------------------------------------
std::string VTKMessages::GetFirstError() const { return this->Current->Error; }

//------------------------------------------------------------------------------
std::string VTKMessages::GetFirstWarning() const { return this->Current->Warning; }

//------------------------------------------------------------------------------
void ReportMessages(const VTKMessages& messages, const std::string& meaning)
{
  if (!messages.GetFirstError().empty())
  {
    throw UserError(meaning + ": " + messages.GetFirstError());
  }
  if (!messages.GetFirstWarning().empty())
  {
    std::cerr << "warning: " << messages.GetFirstWarning() << std::endl;
  }
}

}
