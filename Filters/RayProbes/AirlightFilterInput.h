// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the filters that follow rays on the CPU share: their occluders and lights, and work in
 * several threads with progress.
 */

#ifndef AirlightFilterInput_h
#define AirlightFilterInput_h

#include "Medium/AirlightConvert.h"
#include "Occlusion/AirlightOccluders.h"
#include "Scene/AirlightVTKVersions.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm>

class vtkInformationVector;
class vtkLight;
class vtkParticipatingMedium;

namespace airlight
{
// The data of all connections of a port, each a caster of its connection's number.
Occluders CollectOccluders(vtkInformationVector* input);

// Where the light is, as it stands: headlights and camera lights with the matrix they have.
HomogeneousPoint GetHomogeneousPosition(vtkLight* light);

// The light relative to `origin`, with a radius that keeps everything finite.
LightSupport ConvertSceneLight(const f64::AirlightMedia& media, vtkLight* light,
  const glm::dvec3& origin, f64::AirlightLight& sceneLight);

// Whether the light can be used. If not, an error in the filter's name says why. Also lets the
// medium prepare what it prepares on first use, so that threads may share it.
bool CheckSceneLight(vtkObject* filter, vtkParticipatingMedium* medium, vtkLight* light);

// The last modification of the light or the matrix that it has.
vtkMTimeType GetLightTime(vtkLight* light);

// Coordinates that rays may have: numbers, and below the length at which AIRLIGHT_FAR ends.
inline bool IsUsable(const glm::dvec3& p)
{
  return glm::all(glm::lessThanEqual(glm::abs(p), glm::dvec3(1e15)));
}

// Calls work(begin, end) for parts of [0, count), in several threads where VTK has them. Between
// parts it reports progress, from `progress0` to `progress1`. False if the filter was requested to
// abort. What work() does for an element must not depend on the parts.
template <typename Work>
bool RunInParts(
  vtkAlgorithm* filter, vtkIdType count, double progress0, double progress1, const Work& work)
{
  const vtkIdType threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  const vtkIdType part = std::max<vtkIdType>(count / 50, 32 * threads);
  for (vtkIdType begin = 0; begin < count; begin += part)
  {
    filter->UpdateProgress(progress0 +
      (progress1 - progress0) * static_cast<double>(begin) / static_cast<double>(count));
    if (IsAborted(filter))
    {
      return false;
    }
    vtkSMPTools::For(begin, std::min(begin + part, count), work);
  }
  return true;
}
}

#endif
