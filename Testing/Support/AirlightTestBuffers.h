// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Checks, and what the tests do with the pass's buffers and with pictures.
 */

#ifndef AirlightTestBuffers_h
#define AirlightTestBuffers_h

#include "AirlightBruteForce.h"
#include "AirlightTestCheck.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace airlighttest
{
using airlight_test::Check;
using airlight_test::Failures;

//------------------------------------------------------------------------------
// A value of one of the pass's buffers.
inline double GetValue(vtkImageData* buffer, int x, int y, int component = 0)
{
  return buffer ? buffer->GetScalarComponentAsDouble(x, y, 0, component) : Infinity;
}

inline glm::dvec3 GetColour(vtkImageData* buffer, int x, int y)
{
  return { GetValue(buffer, x, y, 0), GetValue(buffer, x, y, 1), GetValue(buffer, x, y, 2) };
}

// Whether two buffers hold the same bits.
inline bool AreSame(vtkImageData* a, vtkImageData* b)
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

using Buffers = std::map<std::string, vtkSmartPointer<vtkImageData>>;

inline void CheckSame(const Buffers& a, const Buffers& b, const std::string& what)
{
  for (const auto& entry : a)
  {
    Check(AreSame(entry.second, b.at(entry.first)), what + ": the same " + entry.first);
  }
}

// Neither infinite nor undefined.
inline void CheckFinite(const Buffers& buffers, const std::string& what)
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

// What the window shows, RGB.
using Picture = std::vector<int>;

inline Picture ReadPicture(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  const unsigned char* first = pixels->GetPointer(0);
  return Picture(first, first + pixels->GetNumberOfValues());
}

// The same of another frame.
inline Picture Capture(vtkRenderWindow* window)
{
  window->Render();
  return ReadPicture(window);
}

// The largest difference of two pictures, in steps of 1/255.
inline int Compare(const Picture& a, const Picture& b)
{
  int largest = a.size() == b.size() ? 0 : 256;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}
}

#endif
