// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVMediumRepresentation
 * @brief   shows data as a participating medium
 *
 * In a vtkPVAirlightRenderView, image data are a medium that is as dense as one of their point
 * arrays says; other data have the medium inside their closed surface, or inside their outer
 * surface if they are not polygons. Such media stand beside the view's own one, at most eight in
 * all. Other views show nothing, with a warning.
 *
 * An automatic visibility, see vtkPVParticipatingMedium::SetVisibilityDistance(), is that with
 * which the medium's visibility at its greatest density is the diagonal of its bounds: 2 % of the
 * light that crosses it along the diagonal is left.
 *
 * Invalid data, as an open surface or negative densities, give an error when they are drawn, and
 * the scene is drawn without this medium.
 *
 * @sa vtkPVParticipatingMedium vtkPVAirlightRenderView
 */

#ifndef vtkPVMediumRepresentation_h
#define vtkPVMediumRepresentation_h

#include "vtkAirlightParaViewViewsModule.h" // for export macro
#include "vtkNew.h"                         // for the piece
#include "vtkPVDataRepresentation.h"
#include "vtkSmartPointer.h" // for the medium

#include <functional> // for reductions
#include <memory>     // for the sources

class vtkPVParticipatingMedium;
class vtkPolyData;

namespace airlight
{
class MediumSources;
}

class VTKAIRLIGHTPARAVIEWVIEWS_EXPORT vtkPVMediumRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkPVMediumRepresentation* New();
  vtkTypeMacro(vtkPVMediumRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The medium with the optical properties. Its region, density and automatic visibility become
   * those of the data. Default: none, which shows nothing.
   */
  void SetMedium(vtkPVParticipatingMedium* medium);
  vtkPVParticipatingMedium* GetMedium();
  ///@}

  /**
   * The name of the image's point array that is the density. The other arguments are those of
   * vtkAlgorithm::SetInputArrayToProcess() and are ignored. Empty: the active scalars, or else the
   * first array. Default: empty.
   */
  void SetDensityArray(int, int, int, int, const char* name);

  ///@{
  /**
   * The names of the image's point arrays of the albedo and of factors of the emission; see
   * vtkParticipatingMedium::SetAlbedoArrayName(). Empty: those of the medium. Default: empty.
   */
  void SetAlbedoArrayName(const char* name);
  void SetEmissionArrayName(const char* name);
  ///@}

  /**
   * Gives the medium the data at a time. A view calls it on all processes, with a function that
   * finds the largest of their numbers. False if there are no data.
   */
  bool UpdateMedium(double time, const std::function<vtkTypeUInt64(vtkTypeUInt64)>& findLargest);

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output) override;

protected:
  vtkPVMediumRepresentation();
  ~vtkPVMediumRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPVMediumRepresentation(const vtkPVMediumRepresentation&) = delete;
  void operator=(const vtkPVMediumRepresentation&) = delete;

  double GetFullVisibility() const;

  vtkSmartPointer<vtkPVParticipatingMedium> Medium;
  std::unique_ptr<airlight::MediumSources> Sources;
  vtkNew<vtkPolyData> Piece;  // nothing to draw, which carries the bounds
  double Bounds[6];           // of this process's part
  vtkTypeUInt64 DataKind = 0; // of this process's part
  bool WarnedOfView = false;
};

#endif
