// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Phase functions by name, as scene files and command lines have them: those of
 * vtkPhaseFunction::NewByName() in small letters, such as "henyey_greenstein".
 */

#ifndef PhaseName_h
#define PhaseName_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPhaseFunction;

namespace airlight
{

constexpr double MaximumAnisotropy = 0.99;

/**
 * A new phase function; null for an unknown name. The tabulated one is not among them: it needs a
 * file.
 */
vtkSmartPointer<vtkPhaseFunction> MakePhaseFunction(const std::string& name);

/**
 * All names, separated by commas.
 */
std::string ListPhaseNames();

/**
 * The names of a function's parameters.
 */
std::vector<std::string> GetPhaseParameters(vtkPhaseFunction* function);

/**
 * The parameters of all functions.
 */
std::vector<std::string> GetAllPhaseParameters();

/**
 * A function on the command line, its name and its parameters: "henyey_greenstein:g".
 */
std::string GetPhaseForm(vtkPhaseFunction* function);

/**
 * All of them, separated by commas.
 */
std::string ListPhaseForms();

}

#endif
