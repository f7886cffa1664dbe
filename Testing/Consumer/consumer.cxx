// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlight.h"
#include "vtkAirlightPass.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.2, 0.3);
  vtkNew<vtkAirlightPass> pass; // links the rendering half of the library
  pass->SetMedium(medium);

  const double a[3] = { 0.0, 0.0, 0.0 };
  const double b[3] = { 0.0, 3.0, 4.0 }; // 5 away from a
  double rgb[3] = { 0.0, 0.0, 0.0 };
  if (!vtkAirlight::Transmittance(medium, a, b, rgb))
  {
    std::cerr << "Transmittance failed\n";
    return EXIT_FAILURE;
  }
  for (int c = 0; c < 3; ++c)
  {
    const double expected = std::exp(-5.0 * medium->GetScattering()[c]);
    if (!(std::abs(rgb[c] - expected) <= 1e-14))
    {
      std::cerr << "Transmittance " << rgb[c] << ", expected " << expected << "\n";
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
