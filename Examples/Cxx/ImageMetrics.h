// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far a picture is from its reference, as numbers. Let a be the samples (pixels times channels)
 * of the picture and b those of the reference, floor = 1e-3 of the 99th percentile of b,
 * eps = 1e-2 of the mean of b, and call a sample lit where b > floor. Percentiles interpolate
 * linearly. Left out are pixels outside the mask and pixels that are not finite in the picture.
 */

#ifndef ImageMetrics_h
#define ImageMetrics_h

#include <vtkImageData.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

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
  double LitFraction = 0.0;  ///< of all samples
  long long Pixels = 0;      ///< how many pixels were compared
  long long NonFinite = 0;   ///< samples of the whole picture that are not finite

  /**
   * All of them by the name that `airlight compare` prints.
   */
  std::vector<std::pair<std::string, std::variant<double, long long>>> GetNamed() const;
};

/**
 * Compare float images of the same size and number of channels. A pixel counts where the first
 * channel of `mask` (may be null) is above 0.5. Throws UserError if sizes differ, if the reference
 * is not finite, or if no pixel is left.
 */
ImageMetrics CompareImages(vtkImageData* picture, vtkImageData* reference, vtkImageData* mask);

}

#endif
