// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How a shadow map is cut into epipolar slices for a view: a row for each plane through the eye and
 * the light, in which columns follow the rays. See glsl/AirlightSliceLayout.glsl.
 *
 * Rows and columns cover what the view sees of the map, and no more. Calls no OpenGL.
 */

#ifndef AirlightEpipolarSlices_h
#define AirlightEpipolarSlices_h

#include "ShadowMaps/AirlightShadowMapProjection.h"

#include <glm/glm.hpp>

class vtkShaderProgram;

namespace airlight
{
class CameraUniforms;

class EpipolarSlices
{
public:
  // `columns`: at least so many, up to MostColumns; more give more rows alone.
  EpipolarSlices() = default;
  EpipolarSlices(
    const ShadowMapProjection& projection, const CameraUniforms& view, int columns, int mostRows);

  // None if the light is at the eye, or shines along a parallel view or against it: then all of a
  // ray is lit or dark.
  bool IsEmpty() const { return this->Rows == 0; }
  int GetRows() const { return this->Rows; }
  int GetColumns() const { return this->Columns; }
  // A multiple of Word, at most MostColumns.
  static constexpr int Word = 32;
  static constexpr int MostColumns = 1024;
  static constexpr int ColumnsPerTexel = 8; // AIRLIGHT_SLICE_TEXEL

  void SetUniforms(vtkShaderProgram* program) const;

private:
  struct Range
  {
    double First;
    double Last;
  };
  // Rows around a direction.
  struct Arc
  {
    double Width; // to either side
    glm::dvec3 Middle;
  };
  double LimitToView(const CameraUniforms& view, Arc& arc);
  void SetAround(const ShadowMapProjection& projection, const CameraUniforms& view);
  void SetFan(const ShadowMapProjection& projection, const CameraUniforms& view);
  void SetParallel(const ShadowMapProjection& projection, const CameraUniforms& view);
  void SetRanges(Range rows, Range columns);
  void SetValue(const ShadowMapProjection& projection, const CameraUniforms& view);
  void TurnTo(const glm::dvec3& direction);

  glm::dmat3 Axes{ 1.0 };
  Range RowRange{ 0.0, 1.0 };
  Range ColumnRange{ 0.0, 1.0 };
  // How values are kept: see sliceValue and sliceShift.
  glm::dvec2 Value{ 1.0, 1.0 };
  int Shift = 0;
  bool Fan = true;
  int Rows = 0;
  int Columns = 0;
};
}

#endif
