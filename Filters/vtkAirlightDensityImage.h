// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightDensityImage
 * @brief   makes the density image of a medium from any data set
 *
 * From a simulation or a scan to vtkParticipatingMedium::SetDensityImage() in one step: chooses an
 * array and one of its components, multiplies it by a factor, and samples it on a regular grid. See
 * Documentation/density.md.
 *
 * Input: a vtkDataSet (image, rectilinear, curvilinear or unstructured grid) or a composite one
 * (multi-block, or AMR, whose fine levels cover the coarse ones). Data of points or cells; those of
 * cells are averaged at the points that the cells share (vtkCellDataToPointData).
 *
 * Output: a vtkImageData with point scalars. An image keeps its points and its other point arrays,
 * and if it has one component and Factor is 1, its array of any type without a copy. All others are
 * interpolated by vtkProbeFilter at the points of a grid from end to end of their bounds, 0 outside
 * their cells, in float. PassArraysOn() samples the other arrays, too, such as colours
 * (vtkParticipatingMedium::SetAlbedoArrayName()).
 *
 * Errors: no cells, no such array, several components and none chosen, no component of the name,
 * values that are negative, NaN or infinite, data that are flat, and arrays to pass that differ in
 * type or components from block to block give one error that names the value and an empty image.
 *
 * @sa vtkParticipatingMedium vtkOpenVDBDensityReader vtkResampleToImage
 */

#ifndef vtkAirlightDensityImage_h
#define vtkAirlightDensityImage_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <string> // for members

class VTKAIRLIGHT_EXPORT vtkAirlightDensityImage : public vtkImageAlgorithm
{
public:
  static vtkAirlightDensityImage* New();
  vtkTypeMacro(vtkAirlightDensityImage, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The array of densities: of points, or else of cells. Empty: the active scalars. Default: empty.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * The component of an array that has several, by number or, if it is not empty, by name (see
   * vtkAbstractArray::SetComponentName()). -1 is the only one of an array of one component. Range:
   * at least -1. Defaults: -1 and empty.
   */
  vtkSetClampMacro(Component, int, -1, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  vtkSetMacro(ComponentName, std::string);
  vtkGetMacro(ComponentName, std::string);
  ///@}

  ///@{
  /**
   * Densities are multiplied by this. With a mass extinction coefficient, for example 8700 m^2/kg
   * for soot of flames, soot in kg/m^3 becomes an extinction in 1/m, for a medium whose extinction
   * coefficient is 1. Range: finite, above 0. Default: 1.
   */
  void SetFactor(double factor);
  vtkGetMacro(Factor, double);
  ///@}

  ///@{
  /**
   * Points of the output along each axis. (0, 0, 0): the points of an image as they are, 64 x 64 x
   * 64 of other data. Range: all 0, or all from 2 to 4096. Default: (0, 0, 0).
   */
  void SetDimensions(int x, int y, int z);
  void SetDimensions(const int dimensions[3]);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Whether the data's other arrays of numbers are sampled, too, those of points as well as those
   * of cells, but not one of the name "Density", which is that of the output's scalars. Of two of
   * one name that of points counts. They keep their names and types, and are 0 outside the data's
   * cells and in blocks that lack them. An image that need not be sampled passes its point arrays
   * in any case. Default: false.
   */
  vtkSetMacro(PassArrays, bool);
  vtkGetMacro(PassArrays, bool);
  vtkBooleanMacro(PassArrays, bool);
  ///@}

protected:
  vtkAirlightDensityImage() = default;
  ~vtkAirlightDensityImage() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkAirlightDensityImage(const vtkAirlightDensityImage&) = delete;
  void operator=(const vtkAirlightDensityImage&) = delete;

  std::string ArrayName;
  int Component = -1;
  std::string ComponentName;
  double Factor = 1.0;
  int Dimensions[3] = { 0, 0, 0 };
  bool PassArrays = false;
};

#endif
