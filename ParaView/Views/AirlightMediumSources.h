// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   airlight::MediumSources
 * @brief   The pipeline sources of one medium, and what it takes of them
 *
 * A medium may have the closed surface of one source as its region, and the image of another one as
 * its density.
 */

#ifndef AirlightMediumSources_h
#define AirlightMediumSources_h

#include "AirlightMediumSource.h"

#include "vtkType.h"

#include <functional>

class vtkPVParticipatingMedium;

namespace airlight
{
class MediumSources
{
public:
  // The largest of all processes' numbers, for all of them.
  using Reduce = std::function<vtkTypeUInt64(vtkTypeUInt64)>;

  MediumSource& GetSurface() { return this->Surface; }
  MediumSource& GetImage() { return this->Image; }

  // Brings what the medium's region and density need up to date. All processes of the session call
  // it, with the same region and density. False if a source is lacking that they need.
  bool Update(vtkPVParticipatingMedium* medium, double time, const Reduce& reduce);

private:
  MediumSource Surface{ VTK_POLY_DATA };
  MediumSource Image{ VTK_IMAGE_DATA };
};
}

#endif
