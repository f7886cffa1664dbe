// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenVDBDensityReader
 * @brief   reads a grid of an OpenVDB file (.vdb) as the density of a medium
 *
 * OpenVDB (Museth 2013) stores clouds, smoke and level sets as sparse grids. This reader makes one
 * of them a vtkImageData of floats, named like the grid ("density" where it has no name), with a
 * point in the centre of every voxel from the first active one to the last, and of one more voxel
 * on each side. That one holds the grid's background, usually 0: so linear interpolation inside the
 * image falls off at its rim as OpenVDB's own does, and integrals along rays are those of the grid.
 *
 * - Grids of float and of double, in half precision on disk or not, are read. What is not active
 *   counts as background. Values that are not finite or beyond 8e37 count as background, too,
 *   with a warning; negative ones are left as they are.
 * - A level set becomes fog: 0 outside and on the surface, rising linearly with the depth below it
 *   to 1 at half of the narrow band's width, 1 deeper inside.
 * - The transform becomes origin, spacing and direction matrix where its axes are at right angles,
 *   mirrored and non-uniformly scaled ones included. Sheared ones and frustums have no such form:
 *   they are sampled, by linear interpolation, at points along the axes of the world, as close to
 *   each other as the closest voxels are.
 * - Large grids are read coarsely, see SetMaximumDimension().
 *
 * The class exists where Airlight was built with OpenVDB.
 *
 * Errors (VTK's error event, output empty): FileName missing, empty, not an OpenVDB file or
 * truncated or damaged; no grid of that name, or of another type (the message lists the grids); a grid without
 * active voxels; a transform that cannot be inverted. OpenVDB itself trusts its files. So all sizes
 * are looked at before it reads, and no more memory is used than in proportion to the file; damage that
 * leaves sizes as they have to be gives other numbers. Files of before 2013 (format below 222) are
 * refused, and files that were written to a stream and hold grids of points, masks, bits or strings.
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
   * The grid to read, by its name; "name[1]" is the second of a name that the file has twice.
   * Default: empty, the first grid of the file that is of float or double.
   */
  void SetGridName(const char* name);
  const char* GetGridName() const { return this->GridName.c_str(); }
  ///@}

  ///@{
  /**
   * The most points that the image may have in each direction. A larger grid is read at 1/f of its
   * resolution, with one warning: each point has the mean of f x f x f voxels, f the least whole
   * number that will do, so that optical depths through the whole grid stay. The size is known
   * before memory is asked for; an image of n^3 points takes 4 n^3 bytes. Range: 8 to 4096.
   * Default: 512 (at most 512 MiB).
   */
  void SetMaximumDimension(int points);
  vtkGetMacro(MaximumDimension, int);
  ///@}

  ///@{
  /**
   * What the file holds, in its order: the number of grids, their names, and the types of their
   * values by OpenVDB's names ("float", "double", "vec3s", "ptdataidx32"). They are known after
   * UpdateInformation(), whether GridName is among them or not. An index out of range gives "".
   */
  int GetNumberOfGrids() const;
  const char* GetGridName(int index) const;
  const char* GetGridType(int index) const;
  ///@}

  /**
   * The factor f of SetMaximumDimension() that was used; 1 is full resolution. Known after
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
