// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which volumes can cast shadows. Not installed.
 */

#ifndef AirlightVolumeCheck_h
#define AirlightVolumeCheck_h

#include <string>

class vtkDataArray;
class vtkImageData;
class vtkVolume;

namespace airlight
{
// What a volume's opacity is a function of.
struct VolumeScalars
{
  vtkImageData* Image = nullptr;
  vtkDataArray* Values = nullptr; // one finite number for each point
};

// Brings the volume's pipeline up to date and finds its scalars. If it cannot cast a shadow, they
// are null and the text says why, and how to change that.
VolumeScalars FindVolumeScalars(vtkVolume* volume, std::string& error);

// The text for such a reason.
std::string DescribeNoShadow(vtkVolume* volume, const std::string& reason);
}

#endif
