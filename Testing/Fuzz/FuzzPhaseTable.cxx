// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A phase function from a text file, as scene files and command lines name it, and its use.

#include "AirlightFuzz.h"

#include "formats/UserError.h"
#include "scene/MediumFile.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <cmath>

using namespace airlight_fuzz;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  vtkNew<vtkParticipatingMedium> medium;
  try
  {
    airlight::ReadPhaseTable(WriteInput(data, size, ".csv"), medium);
  }
  catch (const airlight::UserError& error)
  {
    Require(std::string(error.what()).find(".csv: ") != std::string::npos,
      std::string("the error names the file: ") + error.what());
    return 0;
  }
  // A fit takes a second: not for each.
  if (size % 64 != 0)
  {
    return 0;
  }
  medium->SetPhaseTolerance(0.1);
  for (int degree = 0; degree <= 180; degree += 5)
  {
    const double value = medium->EvaluatePhaseFunction(std::cos(degree * M_PI / 180.0));
    RequirePositive(&value, 1, "the phase function");
  }
  return 0;
}
