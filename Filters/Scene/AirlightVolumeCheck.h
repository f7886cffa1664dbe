// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which volumes can cast shadows and be media. Not installed.
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

// Brings the volume's pipeline up to date and finds its scalars. If its opacity is no function of
// them alone, they are null and the text says why, and how to change that.
VolumeScalars FindVolumeScalars(vtkVolume* volume, std::string& reason);

// The message for such a reason.
std::string DescribeNoShadow(vtkVolume* volume, const std::string& reason);
std::string DescribeNoMedium(vtkVolume* volume, const std::string& reason);
}

#endif
