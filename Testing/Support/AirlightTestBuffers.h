// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Checks, and what the tests do with the pass's buffers and with pictures.
 */

#ifndef AirlightTestBuffers_h
#define AirlightTestBuffers_h

#include "AirlightTestBruteForce.h"
#include "AirlightTestCheck.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace airlight_test
{
// A value of one of the pass's buffers.
double GetValue(vtkImageData* buffer, int x, int y, int component = 0);

glm::dvec3 GetColour(vtkImageData* buffer, int x, int y);

// Whether two buffers hold the same bits.
bool AreSame(vtkImageData* a, vtkImageData* b);

using Buffers = std::map<std::string, vtkSmartPointer<vtkImageData>>;

void CheckSame(const Buffers& a, const Buffers& b, const std::string& what);

// Neither infinite nor undefined.
void CheckFinite(const Buffers& buffers, const std::string& what);

// What the window shows, RGB.
using Picture = std::vector<int>;

Picture ReadPicture(vtkRenderWindow* window);

// The same of another frame.
Picture Capture(vtkRenderWindow* window);

// The largest difference of two pictures, in steps of 1/255.
int Compare(const Picture& a, const Picture& b);

// A part of a picture that is `stride` pixels wide.
Picture Cut(const Picture& picture, int stride, int x0, int y0, int width, int height);

// Number of pixels that differ by more than `most` steps of 1/255.
int CountDifferent(const Picture& a, const Picture& b, int most);

// The largest difference of two buffers, relative to the largest value of the first.
double CompareBuffers(vtkImageData* a, vtkImageData* b);

double CompareBuffers(const Buffers& a, const Buffers& b);

// Whether the picture shows something: more than a few colours.
bool ShowsScene(const Picture& picture);

// Values of two pictures that differ by more than `limit` steps of 1/255.
int CountApart(const Picture& a, const Picture& b, int limit);

// The value that a share q of the values is not above; 0 without values.
double Quantile(std::vector<double> values, double q);
}

#endif
