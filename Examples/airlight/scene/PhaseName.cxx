// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/PhaseName.h"

#include <vtkPhaseFunction.h>

#include <algorithm>
#include <cctype>

namespace airlight
{

namespace
{
// "henyey_greenstein" of "HenyeyGreenstein".
std::string ToFileName(const std::string& name)
{
  std::string result;
  for (const char c : name)
  {
    const auto letter = static_cast<unsigned char>(c);
    result += std::isupper(letter) && !result.empty() ? "_" : "";
    result += static_cast<char>(std::tolower(letter));
  }
  return result;
}

// One of each, but for the one that needs a file.
std::vector<vtkSmartPointer<vtkPhaseFunction>> MakeAll()
{
  std::vector<vtkSmartPointer<vtkPhaseFunction>> all;
  for (int i = 0; i < vtkPhaseFunction::GetNumberOfClasses(); ++i)
  {
    const std::string name = vtkPhaseFunction::GetNameOfClass(i);
    if (name != "Tabulated")
    {
      all.push_back(vtkSmartPointer<vtkPhaseFunction>::Take(vtkPhaseFunction::NewByName(name)));
    }
  }
  // Those without parameters first.
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a->GetNumberOfParameters() < b->GetNumberOfParameters();
  });
  return all;
}

template <typename Describe>
std::string List(const Describe& describe)
{
  std::string list;
  for (vtkPhaseFunction* function : MakeAll())
  {
    list += (list.empty() ? "" : ", ") + describe(function);
  }
  return list;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPhaseFunction> MakePhaseFunction(const std::string& name)
{
  for (vtkPhaseFunction* function : MakeAll())
  {
    if (name == ToFileName(function->GetName()))
    {
      return function;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::string ListPhaseNames()
{
  return List([](vtkPhaseFunction* function) { return ToFileName(function->GetName()); });
}

//------------------------------------------------------------------------------
std::vector<std::string> GetPhaseParameters(vtkPhaseFunction* function)
{
  std::vector<std::string> names;
  for (int i = 0; i < function->GetNumberOfParameters(); ++i)
  {
    names.push_back(function->GetParameterName(i));
  }
  return names;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetAllPhaseParameters()
{
  std::vector<std::string> all;
  for (vtkPhaseFunction* function : MakeAll())
  {
    for (const std::string& name : GetPhaseParameters(function))
    {
      if (std::find(all.begin(), all.end(), name) == all.end())
      {
        all.push_back(name);
      }
    }
  }
  return all;
}

//------------------------------------------------------------------------------
std::string GetPhaseForm(vtkPhaseFunction* function)
{
  std::string form = ToFileName(function->GetName());
  for (const std::string& name : GetPhaseParameters(function))
  {
    form += ":" + name;
  }
  return form;
}

//------------------------------------------------------------------------------
std::string ListPhaseForms() { return List(GetPhaseForm); }

}
