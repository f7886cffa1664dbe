// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The picture of vtkAirlightReference: the arrays of its output.
 */

#ifndef AirlightReferencePicture_h
#define AirlightReferencePicture_h

#include "vtkType.h"

class vtkImageData;

namespace airlight
{
class ReferenceTracer;
struct ReferencePixel;

class ReferencePicture
{
public:
  // Adds the arrays, of zeros, to an image that has its extent.
  explicit ReferencePicture(vtkImageData* image);

  // Traces the rays of the rows [row, row + rows), on all threads of vtkSMPTools.
  void Trace(const ReferenceTracer& tracer, int row, int rows);

private:
  void Set(vtkIdType index, const ReferencePixel& pixel) const;

  int Width;
  double* Radiance;
  double* Airlight;
  double* Surface;
  double* Transmittance;
  double* Depth;
  double* LitLength;
};
}

#endif
