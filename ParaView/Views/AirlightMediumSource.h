// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   airlight::MediumSource
 * @brief   A pipeline source of a view's medium: its surface or its density
 *
 * The source is where the data are, on each rank a part of it. All processes of a session may draw,
 * the client too, and each needs all of it. It is sent when it has changed.
 */

#ifndef AirlightMediumSource_h
#define AirlightMediumSource_h

#include "AirlightMediumData.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>

class vtkAlgorithmOutput;
class vtkDataObject;
class vtkImageData;
class vtkPolyData;

namespace airlight
{
class MediumSource
{
public:
  // VTK_POLY_DATA for a surface, VTK_IMAGE_DATA for a density.
  explicit MediumSource(int type);
  ~MediumSource();

  MediumSource(const MediumSource&) = delete;
  MediumSource& operator=(const MediumSource&) = delete;

  // Null: none, as on processes without data.
  void SetConnection(vtkAlgorithmOutput* connection);

  // Names of the point arrays of densities and of colours; null is empty.
  void SetDensityArray(const char* name) { this->SetArray(this->Arrays.Density, name); }
  void SetAlbedoArray(const char* name) { this->SetArray(this->Arrays.Albedo, name); }
  void SetEmissionArray(const char* name) { this->SetArray(this->Arrays.Emission, name); }
  const MediumArrays& GetArrays() const { return this->Arrays; }

  enum State
  {
    UNCHANGED = 0,
    REMOVED = 1,
    CHANGED = 2
  };

  // Updates the source at a time. The state on this process; that of the session is the largest.
  vtkTypeUInt64 Update(double time);

  // All processes call it with the state of the session, unless it is UNCHANGED.
  void Deliver(vtkTypeUInt64 state);

  // The same objects always; empty until the first delivery and without source.
  vtkPolyData* GetSurface() const;
  vtkImageData* GetImage() const;

private:
  void SetArray(std::string& array, const char* name);
  vtkSmartPointer<vtkDataObject> MakePiece() const;

  vtkSmartPointer<vtkAlgorithmOutput> Connection;
  MediumArrays Arrays;
  bool Dirty = false; // another source or other arrays
  vtkMTimeType Time = 0;
  vtkSmartPointer<vtkDataObject> Data;
};
}

#endif
