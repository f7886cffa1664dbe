// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A picture of vtkAirlightReference to which paths of light are added until there are enough.
 */

#ifndef AirlightPathPicture_h
#define AirlightPathPicture_h

#include "Reference/AirlightPathTracer.h"

#include <functional>
#include <vector>

class vtkImageData;

namespace airlight
{
struct PathSettings
{
  int Orders = 0;
  int Samples = 64;         // of a pixel, at most; 2 at least
  double TargetError = 0.0; // 0: none
  double TimeLimit = 0.0;   // seconds; 0: none
  int Seed = 0;
};

class PathPicture
{
public:
  // To an image with the arrays of ReferencePicture, to which "StandardError" is added.
  PathPicture(vtkImageData* image, const ReferenceTracer& tracer, const PathSettings& settings);

  // Takes rounds of samples on all threads of vtkSMPTools; between them the arrays hold the means
  // so far. Calls `proceed` with the share of the work that is done, from this thread, and stops
  // where it returns false.
  void Compute(const std::function<bool(double)>& proceed);

  // The root mean square of the standard errors over the mean radiance, of pixels and colours.
  double GetRelativeError() const;

private:
  struct Pixel
  {
    glm::dvec3 First[3]; // of the arrays, without paths
    glm::dvec3 Means[3]; // of the paths
    glm::dvec3 Squares{ 0.0 };
    int Count = 0;
  };

  void Add(vtkIdType index, int samples);
  void AddRows(int row, int rows, int samples);
  void MarkModified();

  vtkImageData* Image;
  const ReferenceTracer& Tracer;
  PathSettings Settings;
  PathTracer Paths;
  int Width;
  int Height;
  double* Arrays[3]; // radiance, airlight, surface
  double* Error;
  std::vector<Pixel> Pixels;
};
}

#endif
