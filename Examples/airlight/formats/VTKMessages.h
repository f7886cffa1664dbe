// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VTKMessages_h
#define VTKMessages_h

#include <vtkSmartPointer.h>

#include <string>

class vtkOutputWindow;

namespace airlight
{

/**
 * Collects VTK's errors and warnings while it lives, in place of printing them. VTK's readers
 * report a damaged file in no other way, and many a message comes from an object inside a reader
 * where no observer can be attached.
 */
class VTKMessages
{
public:
  VTKMessages();
  ~VTKMessages();
  VTKMessages(const VTKMessages&) = delete;
  void operator=(const VTKMessages&) = delete;

  ///@{
  /**
   * The first message of a kind, in one line without VTK's source file and object address; empty
   * if there was none.
   */
  std::string GetFirstError() const;
  std::string GetFirstWarning() const;
  ///@}

private:
  class Collector;
  vtkSmartPointer<vtkOutputWindow> Previous;
  vtkSmartPointer<Collector> Current;
  int Verbosity; // of VTK's log before
};

/**
 * Throws UserError with the first error, after what it means to the user, if there was one, and
 * prints the first warning.
 */
void ReportMessages(const VTKMessages& messages, const std::string& meaning);

}

#endif
