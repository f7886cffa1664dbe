// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tables of phase functions, and what vtkParticipatingMedium says that it makes of them: the
 * logarithm is a monotone cubic of the angle between the rows, constant beyond the first and the
 * last one, and the whole is normalised.
 */

#ifndef AirlightTestPhaseTable_h
#define AirlightTestPhaseTable_h

#include "AirlightTestQuadrature.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <cmath>
#include <functional>
#include <vector>

namespace airlight_test
{
class ReferenceTable
{
public:
  ReferenceTable() = default;

  explicit ReferenceTable(vtkTable* table)
  {
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const long double degrees = table->GetValue(row, 0).ToDouble();
      const long double value = table->GetValue(row, 1).ToDouble();
      this->Angles.push_back(degrees * static_cast<long double>(std::acos(-1.0L)) / 180.0L);
      this->Logarithms.push_back(std::log(value));
    }
    this->Slopes.assign(this->Angles.size(), 0.0L);
    for (size_t i = 1; i + 1 < this->Angles.size(); ++i)
    {
      this->Slopes[i] = this->Slope(i);
    }
    this->Normalise();
  }

  const std::vector<long double>& GetAngles() const { return this->Angles; } // radians

  // Newton's form of the cubic with two double nodes: divided differences of value and slope.
  template <typename T>
  T Evaluate(T angle) const
  {
    size_t i = 0;
    while (i < this->Angles.size() && angle >= static_cast<T>(this->Angles[i]))
    {
      ++i;
    }
    if (i == 0 || i == this->Angles.size())
    {
      return std::exp(static_cast<T>(i == 0 ? this->Logarithms.front() : this->Logarithms.back()) +
        static_cast<T>(this->Scale));
    }
    const T h = static_cast<T>(this->Angles[i] - this->Angles[i - 1]);
    const T x = angle - static_cast<T>(this->Angles[i - 1]);
    const T first = static_cast<T>(this->Slopes[i - 1]);
    const T chord = static_cast<T>(this->Logarithms[i] - this->Logarithms[i - 1]) / h;
    const T second = (chord - first) / h;
    const T third = ((static_cast<T>(this->Slopes[i]) - chord) / h - second) / h;
    return std::exp(static_cast<T>(this->Logarithms[i - 1] + this->Scale) +
      x * (first + x * (second + (x - h) * third)));
  }

private:
  // Brodlie's: a weighted harmonic mean of the slopes on both sides, 0 at an extremum.
  long double Slope(size_t i) const
  {
    const long double h0 = this->Angles[i] - this->Angles[i - 1];
    const long double h1 = this->Angles[i + 1] - this->Angles[i];
    const long double m0 = (this->Logarithms[i] - this->Logarithms[i - 1]) / h0;
    const long double m1 = (this->Logarithms[i + 1] - this->Logarithms[i]) / h1;
    const long double share = (h0 + 2.0L * h1) / (3.0L * (h0 + h1));
    return m0 * m1 > 0.0L ? m0 * m1 / (share * m1 + (1.0L - share) * m0) : 0.0L;
  }

  // 2 pi times the integral of p sin over the angle becomes 1.
  void Normalise()
  {
    std::vector<long double> ends = { 0.0L, std::acos(-1.0L) };
    ends.insert(ends.end(), this->Angles.begin(), this->Angles.end());
    std::sort(ends.begin(), ends.end());
    const long double integral = 2.0L * std::acos(-1.0L) *
      Integrate([&](double angle) { return this->Evaluate(angle) * std::sin(angle); }, ends, 1e-15);
    this->Scale = -std::log(integral);
  }

  std::vector<long double> Angles;
  std::vector<long double> Logarithms;
  std::vector<long double> Slopes;
  long double Scale = 0.0L;
};

// Rows from first to last degree of a function of the cosine, times a scale that means nothing.
vtkSmartPointer<vtkTable> SampleTable(
  double first, double last, double step, const std::function<double(double)>& function);

enum TestTable
{
  TABLE_SMOOTH,   // two lobes in steps of 2 degrees
  TABLE_PARTIAL,  // the same, as an instrument sees it that is blind within 10 degrees of the axis
  TABLE_TWO_ROWS, // the least that is a table
  TABLE_CONTRAST, // six decades
  TABLE_RAINBOW,  // drops of water: a bump at 138 degrees
  TEST_TABLES
};

const char* TestTableName(int kind);

vtkSmartPointer<vtkTable> MakeTable(int kind, double scale = 1.0);
}

#endif
