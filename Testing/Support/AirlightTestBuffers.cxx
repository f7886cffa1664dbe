// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestBuffers.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>

namespace airlight_test
{
//------------------------------------------------------------------------------
double GetValue(vtkImageData* buffer, int x, int y, int component)
{
  return buffer ? buffer->GetScalarComponentAsDouble(x, y, 0, component) : Infinity;
}

//------------------------------------------------------------------------------
glm::dvec3 GetColour(vtkImageData* buffer, int x, int y)
{
  return { GetValue(buffer, x, y, 0), GetValue(buffer, x, y, 1), GetValue(buffer, x, y, 2) };
}

//------------------------------------------------------------------------------
bool AreSame(vtkImageData* a, vtkImageData* b)
{
  if (!a || !b || a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfScalarComponents() != b->GetNumberOfScalarComponents())
  {
    return false;
  }
  const auto* p = static_cast<const char*>(a->GetScalarPointer());
  const auto* q = static_cast<const char*>(b->GetScalarPointer());
  return std::equal(p, p + a->GetPointData()->GetScalars()->GetDataSize() * a->GetScalarSize(), q);
}

//------------------------------------------------------------------------------
void CheckSame(const Buffers& a, const Buffers& b, const std::string& what)
{
  for (const auto& entry : a)
  {
    Check(AreSame(entry.second, b.at(entry.first)), what + ": the same " + entry.first);
  }
}

//------------------------------------------------------------------------------
void CheckFinite(const Buffers& buffers, const std::string& what)
{
  for (const auto& entry : buffers)
  {
    vtkDataArray* values = entry.second->GetPointData()->GetScalars();
    bool ok = values != nullptr;
    for (vtkIdType i = 0; ok && i < values->GetNumberOfTuples(); ++i)
    {
      for (int k = 0; k < values->GetNumberOfComponents(); ++k)
      {
        ok = ok && std::isfinite(values->GetComponent(i, k));
      }
    }
    Check(ok, what + ": finite " + entry.first);
  }
}

//------------------------------------------------------------------------------
Picture ReadPicture(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  const unsigned char* first = pixels->GetPointer(0);
  return Picture(first, first + pixels->GetNumberOfValues());
}

//------------------------------------------------------------------------------
Picture Capture(vtkRenderWindow* window)
{
  window->Render();
  return ReadPicture(window);
}

//------------------------------------------------------------------------------
int Compare(const Picture& a, const Picture& b)
{
  int largest = a.size() == b.size() ? 0 : 256;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

//------------------------------------------------------------------------------
Picture Cut(const Picture& picture, int stride, int x0, int y0, int width, int height)
{
  Picture part;
  for (int y = y0; y < y0 + height; ++y)
  {
    const auto row = picture.begin() + 3 * (static_cast<long>(stride) * y + x0);
    part.insert(part.end(), row, row + 3 * width);
  }
  return part;
}

//------------------------------------------------------------------------------
int CountDifferent(const Picture& a, const Picture& b, int most)
{
  int count = a.size() == b.size() ? 0 : static_cast<int>(a.size());
  for (size_t i = 0; i + 2 < std::min(a.size(), b.size()); i += 3)
  {
    count += std::abs(a[i] - b[i]) > most || std::abs(a[i + 1] - b[i + 1]) > most ||
      std::abs(a[i + 2] - b[i + 2]) > most;
  }
  return count;
}

//------------------------------------------------------------------------------
double CompareBuffers(vtkImageData* a, vtkImageData* b)
{
  if (!a || !b || a->GetNumberOfPoints() != b->GetNumberOfPoints())
  {
    return Infinity;
  }
  double largest = 0.0;
  double difference = 0.0;
  auto* p = static_cast<float*>(a->GetScalarPointer());
  auto* q = static_cast<float*>(b->GetScalarPointer());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints() * a->GetNumberOfScalarComponents(); ++i)
  {
    const double step = std::abs(static_cast<double>(p[i]) - q[i]);
    largest = std::max(largest, std::abs(static_cast<double>(p[i])));
    difference = step <= difference ? difference : step; // NaN stays
  }
  return difference > 0.0 || std::isnan(difference) ? difference / largest : 0.0;
}

//------------------------------------------------------------------------------
double CompareBuffers(const Buffers& a, const Buffers& b)
{
  double largest = 0.0;
  for (const auto& entry : a)
  {
    const double difference = CompareBuffers(entry.second, b.at(entry.first));
    largest = difference <= largest ? largest : difference;
  }
  return largest;
}

//------------------------------------------------------------------------------
bool ShowsScene(const Picture& picture)
{
  const auto range = std::minmax_element(picture.begin(), picture.end());
  return !picture.empty() && *range.second - *range.first > 60;
}

//------------------------------------------------------------------------------
int CountApart(const Picture& a, const Picture& b, int limit)
{
  int count = a.size() == b.size() ? 0 : static_cast<int>(a.size());
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    count += std::abs(a[i] - b[i]) > limit ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
double Quantile(std::vector<double> values, double q)
{
  if (values.empty())
  {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(q * static_cast<double>(values.size() - 1))];
}
}
