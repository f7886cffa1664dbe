// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneMediumReader_h
#define SceneMediumReader_h

#include "formats/LocatedJson.h"

#include <vtkParticipatingMedium.h>
#include <vtkSmartPointer.h>

#include <string>

namespace airlight
{

/**
 * Three numbers that are not all zero. Media, lights and cameras have such.
 */
Vector3 ReadSceneDirection(const LocatedJson& json);

/**
 * The `medium` of a scene file, see ReadScene(), but for the mesh that bounds it: that is left to
 * ReadMediumBoundary().
 */
vtkSmartPointer<vtkParticipatingMedium> ReadMedium(
  const LocatedJson& json, const std::string& sceneFile);

///@{
/**
 * The mesh that bounds the medium, if one does: look at it in a child process, then read it. All
 * meshes are checked before the first one is read: see CheckModelFile().
 */
void CheckMediumBoundary(const LocatedJson& json, const std::string& sceneFile);
void ReadMediumBoundary(
  const LocatedJson& json, const std::string& sceneFile, vtkParticipatingMedium* medium);
///@}

}

#endif
