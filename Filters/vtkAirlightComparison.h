// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightComparison
 * @brief   compares an image with a reference: error metrics and the difference
 *
 * Input port 0 takes the image, port 1 the reference, port 2, optional, a mask: pixels count if its
 * first channel is above 0.5. Image and reference have point scalars of the same size and number of
 * channels, of any type; they are compared in double precision. NaN and infinite values are errors,
 * see SetSkipNonFinite().
 *
 * Output port 0 is a vtkTable of one row. Let a be the samples (pixels times channels) of the image
 * and b those of the reference, floor = 1e-3 of the 99th percentile of b, eps = 1e-2 of the mean of
 * b; a sample is lit if b > floor. Percentiles interpolate linearly. The columns are
 *
 * - relMSE: the mean of (a-b)^2/(b^2+eps^2); relMSE_trim: the same without the worst 0.1 % of the
 *   pixels
 * - median, p95, p99, max: of the relative errors |a-b|/max(|b|, floor) of the lit samples
 * - dark_max_abs: the largest |a-b| of the samples that are not lit
 * - bias: the sum of a-b over the sum of b, lit samples
 * - median_signed: the median of (a-b)/max(|b|, floor), lit samples
 * - fit: the least-squares gain, a ~ fit b
 * - lit_frac: the fraction of lit samples
 * - pixels: the number of compared pixels; nonfinite: the number of samples of the image that are
 *   NaN or infinite
 * - PSNR: 10 log10(max(b)^2/mean of (a-b)^2) in dB; infinite if a and b are the same, minus
 *   infinite if they are not and b is black
 *
 * If no sample is lit, the columns of lit samples are 0. The definitions are those of the reference
 * scenes in Testing/Data/Reference.
 *
 * Output port 1 is the difference a-b with the geometry of port 0, float if both images are, else
 * double; 0 if a pixel does not count. Its scalars are named "Difference".
 *
 * Errors (ErrorEvent, outputs empty): an image without point scalars; different sizes or numbers of
 * channels; a counted value that is NaN or infinite; no counted pixel.
 *
 * @sa vtkAirlightPass::GetBuffer
 */

#ifndef vtkAirlightComparison_h
#define vtkAirlightComparison_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkAlgorithm.h"

class vtkImageData;
class vtkTable;

class VTKAIRLIGHT_EXPORT vtkAirlightComparison : public vtkAlgorithm
{
public:
  static vtkAirlightComparison* New();
  vtkTypeMacro(vtkAirlightComparison, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The inputs as data. SetInputConnection() takes them from a pipeline. A null mask removes the
   * mask.
   */
  void SetImageData(vtkImageData* image);
  void SetReferenceData(vtkImageData* reference);
  void SetMaskData(vtkImageData* mask);
  ///@}

  ///@{
  /**
   * Whether pixels of the image (not of the reference) that are NaN or infinite are left out and
   * counted, instead of being an error. Default: off.
   */
  vtkSetMacro(SkipNonFinite, bool);
  vtkGetMacro(SkipNonFinite, bool);
  vtkBooleanMacro(SkipNonFinite, bool);
  ///@}

  ///@{
  /**
   * The outputs: the table of port 0 and the image of port 1. Call Update() before.
   */
  vtkTable* GetMetrics();
  vtkImageData* GetDifference();
  ///@}

protected:
  vtkAirlightComparison();
  ~vtkAirlightComparison() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkAirlightComparison(const vtkAirlightComparison&) = delete;
  void operator=(const vtkAirlightComparison&) = delete;

  int RequestData(vtkInformationVector** input, vtkInformationVector* output);

  bool SkipNonFinite = false;
};

#endif
