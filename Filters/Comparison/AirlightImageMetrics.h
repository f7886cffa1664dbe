// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far an image is from its reference, as numbers. What they mean stands in
 * vtkAirlightComparison.h.
 */

#ifndef AirlightImageMetrics_h
#define AirlightImageMetrics_h

#include <string>
#include <utility>
#include <variant>
#include <vector>

class vtkImageData;

namespace airlight
{

struct ImageMetrics
{
  double RelMSE = 0.0;       ///< mean of (a-b)^2/(b^2+eps^2)
  double RelMSETrim = 0.0;   ///< the same without the worst 0.1 % of the pixels
  double Median = 0.0;       ///< of the relative errors |a-b|/max(|b|, floor) of lit samples
  double P95 = 0.0;          ///< their 95th percentile
  double P99 = 0.0;          ///< their 99th percentile
  double Max = 0.0;          ///< the largest of them
  double DarkMaxAbs = 0.0;   ///< largest |a-b| of the samples that are not lit
  double Bias = 0.0;         ///< sum of a-b over sum of b, lit samples
  double MedianSigned = 0.0; ///< median of (a-b)/max(|b|, floor), lit samples
  double Fit = 0.0;          ///< least-squares gain: a ~ fit * b
  double PSNR = 0.0;         ///< 10 log10(max(b)^2/mean of (a-b)^2), all samples
  double LitFraction = 0.0;  ///< of all samples
  long long Pixels = 0;      ///< how many pixels were compared
  long long NonFinite = 0;   ///< samples of the whole image that are not finite

  // All of them by their names.
  std::vector<std::pair<std::string, std::variant<double, long long>>> GetNamed() const;
};

/**
 * Compare images of the same size and number of channels. A pixel counts where the first channel of
 * `mask` (may be null) is above 0.5 and, with `skipNonFinite`, where all channels of `image` are
 * finite. Throws std::runtime_error if there are no scalars, if sizes differ, if no pixel is left,
 * or if a value that counts is not finite. If it returns, `counts` says of every pixel whether it
 * did.
 */
ImageMetrics CompareImages(vtkImageData* image, vtkImageData* reference, vtkImageData* mask,
  bool skipNonFinite, std::vector<bool>& counts);

}

#endif
