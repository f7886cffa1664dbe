// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pass's picture of a scene and vtkAirlightReference's, buffer by buffer and pixel by pixel.
 *
 * The error of a pixel in a buffer is |a - b|/max(|b|, floor), the largest of the channels; a is
 * the pass's, b the reference's value, and floor 1e-3 of the 99th percentile of b, as in
 * vtkAirlightComparison. A pixel is right where that is at most 1 % in all buffers. Of radiance,
 * airlight and lit length 1e-5 of what the ray's airlight or lit length is without shadows is
 * right, too, a tenth of what the pass promises: there is nothing else to measure a wholly dark
 * picture by.
 *
 * A pixel that is not right is explained by an edge where each channel of each buffer lies between
 * the least and the largest of what the reference says within 0.02 pixels of the pixel's middle, or
 * within 1 % of these: rasterisers place corners to 1/256 of a pixel. Among the places are a ring
 * and two in each triangle that comes so near. It is explained by rounding, and counted apart,
 * where that is so for rays that besides are moved by d = 5e-7 of the farthest corner of any part,
 * and a clipping range that is wider or narrower by d over twice its beginning: surfaces are drawn
 * and clipped in single precision, which shows where parts are large; or for the surface behind the
 * first one, if a depth buffer of 24 bits cannot tell which is the first. It is explained by an
 * outline, and counted apart, where the pixel's middle is beside a triangle that a rasteriser may
 * draw there, and the surface is as it is without shadows: where a shadow ends with the surface
 * that it is on, as it does where two faces meet, what is drawn beyond that edge is beyond the
 * shadow, too. It is explained by a border, and counted apart, where a triangle's border is within
 * those 0.02 pixels and VTK has drawn another surface than the reference sees: a rasteriser that
 * draws the triangle beside itself follows its plane, normals and colours beyond the border, far
 * beyond, if it is a sliver, and in another order of depth, where two triangles meet in a fold; one
 * that leaves it out shows what is behind. Then the surface is VTK's, no brighter than a white one
 * that faces all lights there, and the medium before it has to be right, for the depth that was
 * drawn: airlight, transmittance and lit length, and the radiance with the surface as it was drawn.
 * The same holds where d is more than a thousandth of the depth: VTK places such surfaces by
 * chance. All others are unexplained; there may be none.
 *
 * No radiance is measured by less than 1e-6 W/(m^2 sr), where lamps give surfaces some 1 to 100:
 * the pass leaves out what is behind an optical depth of 20.
 *
 * A scene passes where no pixel is unexplained, and no value of the pass is negative, infinite or
 * not a number; of all scenes' pixels together at least 99 % have to be right. (In one small
 * picture an edge that runs through the middles of a column of pixels makes more than 1 %.) Pixels
 * that the reference has dark are measured against the floor: what leaks there is at most 1e-5 of
 * the 99th percentile.
 */

#ifndef SceneComparison_h
#define SceneComparison_h

#include "AirlightTestScene.h"
#include "ScreenTriangles.h"

#include "Reference/AirlightReferenceTracer.h"
#include "vtkPointData.h"

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace airlight_test
{
struct SceneFigures
{
  int Pixels = 0;
  int Wrong = 0;       // by more than 1 %
  int Unexplained = 0; // of these
  int Rounded = 0;     // explained not by pixels' edges but by single precision
  int Outlines = 0;    // explained by light on a surface's outline
  int Borders = 0;     // explained by VTK drawing another surface at a border
  int Improper = 0;    // negative or not finite
  double Median = 0.0; // error of the radiance
  double P99 = 0.0;
  double Largest = 0.0; // of the pixels that no edge explains
  double Leak = 0.0;    // largest difference where the reference is dark, of the 99th percentile
  std::string Worst;    // the first unexplained or improper pixels

  bool Passes() const { return this->Unexplained == 0 && this->Improper == 0; }
};

class SceneComparison
{
public:
  // The scene has been drawn. `byBound`: where the pass promises less than 1 % by its "ErrorBound",
  // that counts.
  SceneComparison(airlight_test::Scene& scene,
    const std::vector<vtkSmartPointer<vtkParticipatingMedium>>& media, bool byBound);

  const SceneFigures& GetFigures() const { return this->Figures; }

  // For FaultInjection: what was drawn at a pixel, what the reference finds there, and whether the
  // pixel would be reported as wrong with other values.
  airlight::ReferencePixel GetDrawnPixel(vtkIdType pixel) const;
  airlight::ReferencePixel Trace(vtkIdType pixel, const airlight::ReferenceChange& change);
  airlight::ReferencePixel TraceTo(vtkIdType pixel, double depth);
  airlight::ReferencePixel TraceUnshadowed(vtkIdType pixel);
  bool Reports(vtkIdType pixel, const airlight::ReferencePixel& drawn);

  // The values of a pixel, channel by channel in the order of the buffers, and the largest of each
  // in the picture, but for what is without end, and no less than what a thousandth of is measured.
  static std::vector<double> Flatten(const airlight::ReferencePixel& pixel);
  const std::vector<double>& GetLargest() const { return this->Largest; }

  // Writes the first channel of this buffer, the pass's and the reference's, as numbers.
  void Print(const std::string& name, std::ostream& out) const;

private:
  struct Buffer
  {
    const char* Name;
    int Components;
    vtkSmartPointer<vtkImageData> Drawn;
    vtkSmartPointer<vtkDataArray> Computed;
    double Floor;
    bool MayBeNegative;

    double Get(vtkIdType pixel, int component) const
    {
      return this->Drawn->GetPointData()->GetScalars()->GetComponent(pixel, component);
    }
  };

  enum BufferIndex
  {
    RADIANCE,
    AIRLIGHT,
    SURFACE,
    TRANSMITTANCE,
    DEPTH,
    LIT_LENGTH
  };

  void AddBuffer(const char* name, vtkImageData* computed);
  double GetError(const Buffer& buffer, vtkIdType pixel) const;
  void CountImproper(vtkIdType pixel);
  bool IsRight(vtkIdType pixel);
  bool IsExplained(vtkIdType pixel);
  static constexpr double Tolerance = 0.01;
  // Beyond this the pass and the reference mean "without end".
  static constexpr double Endless = 1e15;

  // What the reference finds at several places, channel by channel.
  struct Range
  {
    std::vector<double> Low;
    std::vector<double> High;

    void Add(const airlight::ReferencePixel& pixel);
  };
  bool IsBetween(vtkIdType pixel, const Range& range) const;
  void AddMoved(const glm::dvec2& middle, Range& range);
  void AddBehind(const glm::dvec2& middle, Range& range);
  bool AreSurfacesCoarse(vtkIdType pixel);
  bool IsMediumRight(vtkIdType pixel);
  bool IsShadingPossible(vtkIdType pixel);
  void SetDrawn(vtkIdType pixel, const std::vector<double>& values);
  void MakeTools();
  glm::dvec2 GetMiddle(vtkIdType pixel) const;
  double GetDrawn(BufferIndex buffer, vtkIdType pixel, int component = 0) const
  {
    return this->Buffers[buffer].Get(pixel, component);
  }
  double GetReach();
  std::vector<vtkLight*> GetLights();
  std::unique_ptr<airlight::ReferenceTracer> MakeTracer();
  std::unique_ptr<airlight::ReferenceTracer> MakeUnshadowedTracer();
  airlight::ReferencePixel TraceUnshadowed(
    const glm::dvec2& place, const airlight::ReferenceChange& change = {});
  void MeasureRadiance();
  void Describe(vtkIdType pixel);

  airlight_test::Scene& Scene;
  bool ByBound;
  vtkSmartPointer<vtkImageData> Bound; // of all channels
  std::vector<Buffer> Buffers;
  std::vector<char> Excused; // pixels explained by edges
  std::vector<double> Largest;
  // Made at the first call.
  std::unique_ptr<airlight::ReferenceTracer> Tracer;
  std::unique_ptr<airlight::ReferenceTracer> Unshadowed;
  std::unique_ptr<ScreenTriangles> Triangles;
  std::vector<vtkParticipatingMedium*> Media;
  SceneFigures Figures;
};
}

#endif
