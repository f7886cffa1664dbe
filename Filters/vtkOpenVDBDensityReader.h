// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenVDBDensityReader
 * @brief   reads a grid of an OpenVDB file (.vdb) as the density of a medium
 *
 * OpenVDB (Museth 2013) stores clouds, smoke and level sets as sparse grids. This reader converts
 * one of them to a vtkImageData of floats, named like the grid ("density" if it has no name). The
 * image has a point at the centre of every voxel from the first active one to the last, and of one
 * more voxel on each side with the grid's background, usually 0. Linear interpolation then falls
 * off at the rim as OpenVDB's does, and integrals along rays are those of the grid. See
 * Documentation/density.md.
 *
 * - Grids of float and double are read, also if stored in half precision. Inactive voxels and, with
 *   a warning, values that are NaN, infinite or beyond 8e37 count as background. Negative values
 *   stay.
 * - A level set becomes fog: 0 outside and on the surface, rising linearly with the depth below it
 *   to 1 at half of the narrow band's width, and 1 deeper inside.
 * - An orthogonal transform, also if mirrored or non-uniformly scaled, becomes origin, spacing and
 *   direction matrix. Grids with sheared transforms and frustums are resampled with linear
 *   interpolation at points along the world axes, as close to each other as the closest voxels.
 * - Large grids are read at a lower resolution, see SetMaximumDimension().
 *
 * The class exists if Airlight was built with OpenVDB.
 *
 * Errors (ErrorEvent, output empty): FileName missing, empty, not an OpenVDB file, truncated or
 * damaged; no grid of that name, or of another type (the message lists the grids); a grid without
 * active voxels; a singular transform; files from before 2013 (format below 222); and files that
 * were written to a stream and hold grids of points, masks, bits or strings. All sizes in a file
 * are checked before OpenVDB reads it, so that memory is bounded in proportion to the file; damage
 * that leaves sizes valid gives other values.
 *
 * @sa vtkParticipatingMedium
 */

#ifndef vtkOpenVDBDensityReader_h
#define vtkOpenVDBDensityReader_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for the internals
#include <string> // for the names

class VTKAIRLIGHT_EXPORT vtkOpenVDBDensityReader : public vtkImageAlgorithm
{
public:
  static vtkOpenVDBDensityReader* New();
  vtkTypeMacro(vtkOpenVDBDensityReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The .vdb file. Default: empty, which is an error when the reader is updated.
   */
  void SetFileName(const char* name);
  const char* GetFileName() const { return this->FileName.c_str(); }
  ///@}

  ///@{
  /**
   * The name of the grid; "name[1]" is the second grid of a name that the file has twice. Default:
   * empty, which selects the first grid of float or double.
   */
  void SetGridName(const char* name);
  const char* GetGridName() const { return this->GridName.c_str(); }
  ///@}

  ///@{
  /**
   * The maximum number of points of the image in each direction. A larger grid is read at 1/f of
   * its resolution, with one warning: each point has the mean of f x f x f voxels, with the
   * smallest integer f that suffices. This preserves optical depths through the whole grid. The
   * size is checked before memory is allocated; an image of n^3 points takes 4 n^3 bytes. Range: 8
   * to 4096. Default: 512 (at most 512 MiB).
   */
  void SetMaximumDimension(int points);
  vtkGetMacro(MaximumDimension, int);
  ///@}

  ///@{
  /**
   * The contents of the file, in its order: the number of grids, their names, and OpenVDB's names
   * of their value types ("float", "double", "vec3s", "ptdataidx32"). Available after
   * UpdateInformation(), even if GridName is not among them. An index out of range gives "".
   */
  int GetNumberOfGrids() const;
  const char* GetGridName(int index) const;
  const char* GetGridType(int index) const;
  ///@}

  /**
   * The factor f of SetMaximumDimension() that was used; 1 is full resolution. Available after
   * UpdateInformation().
   */
  vtkGetMacro(ReductionFactor, vtkIdType);

protected:
  vtkOpenVDBDensityReader();
  ~vtkOpenVDBDensityReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkOpenVDBDensityReader(const vtkOpenVDBDensityReader&) = delete;
  void operator=(const vtkOpenVDBDensityReader&) = delete;

  class Internals;

  int Fail(vtkInformationVector* output, const std::string& reason);
  std::size_t FindGrid() const;
  void Warn(std::size_t bad);

  std::string FileName;
  std::string GridName;
  int MaximumDimension = 512;
  vtkIdType ReductionFactor = 1;
  std::unique_ptr<Internals> Current;
};

#endif
