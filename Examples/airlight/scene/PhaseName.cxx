// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/PhaseName.h"

#include <vtkParticipatingMedium.h>

#include <algorithm>
#include <array>

namespace airlight
{

namespace
{
using Medium = vtkParticipatingMedium;

// Schlick's k is not the mean cosine g: another letter, lest one is taken for the other.
const std::array<PhaseName, 7> Names = { {
  { "isotropic", Medium::ISOTROPIC, nullptr },
  { "rayleigh", Medium::RAYLEIGH, nullptr },
  { "henyey_greenstein", Medium::HENYEY_GREENSTEIN, "g" },
  { "schlick", Medium::SCHLICK, "k" },
  { "cornette_shanks", Medium::CORNETTE_SHANKS, "g" },
  { "mie_hazy", Medium::MIE_HAZY, nullptr },
  { "mie_murky", Medium::MIE_MURKY, nullptr },
} };
}

//------------------------------------------------------------------------------
const PhaseName* FindPhaseName(const std::string& name)
{
  const auto* found = std::find_if(
    Names.begin(), Names.end(), [&name](const PhaseName& phase) { return name == phase.Name; });
  return found == Names.end() ? nullptr : found;
}

//------------------------------------------------------------------------------
std::string ListPhaseNames()
{
  std::string list;
  for (const PhaseName& phase : Names)
  {
    list += (list.empty() ? "" : ", ") + std::string(phase.Name);
  }
  return list;
}

//------------------------------------------------------------------------------
void SetPhase(vtkParticipatingMedium* medium, const PhaseName& phase, double anisotropy)
{
  // Where Henyey and Greenstein's function is the isotropic one, the latter needs no fit.
  const bool even = phase.Type == Medium::HENYEY_GREENSTEIN && anisotropy == 0.0;
  medium->SetPhaseFunction(even ? Medium::ISOTROPIC : phase.Type);
  if (phase.Parameter && !even)
  {
    medium->SetAnisotropy(anisotropy);
  }
}

}
