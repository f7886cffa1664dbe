// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/ModelView.h"

#include "formats/Files.h"
#include "formats/UserError.h"

#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace airlight
{

namespace
{
// To the right, up and to the front.
constexpr Vector3 EyeDirection{ 0.42, 0.28, 1.0 };

constexpr double Margin = 1.3; // of the distance, for air around the model and its shafts

constexpr Vector3 X{ 1.0, 0.0, 0.0 }, Y{ 0.0, 1.0, 0.0 }, Z{ 0.0, 0.0, 1.0 };
constexpr Vector3 MinusX{ -1.0, 0.0, 0.0 }, MinusY{ 0.0, -1.0, 0.0 }, MinusZ{ 0.0, 0.0, -1.0 };

// The model that stands on y turned upright, by a quarter or a half turn.
constexpr std::array<std::pair<const char*, ModelAxes>, 6> Axes = { {
  { "x", { MinusY, X, Z } },
  { "y", { X, Y, Z } },
  { "z", { X, Z, MinusY } },
  { "-x", { Y, MinusX, Z } },
  { "-y", { MinusX, MinusY, Z } },
  { "-z", { X, MinusZ, Y } },
} };

// The distance of a camera from the axis of a turntable, at which a point on it stays in the
// picture: for a camera that sees the axis at an angle, in terms of half the picture's sides.
class Turntable
{
public:
  Turntable(double elevation, double halfHeight, double halfWidth)
    : Sine(std::sin(elevation))
    , Cosine(std::cos(elevation))
    , HalfHeight(halfHeight)
    , HalfWidth(halfWidth)
  {
  }

  // A point at z before the axis is z cos e + y sin e nearer, and at y cos e - z sin e in the
  // picture. Both are linear in z, so that the point at its nearest or farthest is decisive. To the
  // sides that is the largest value of z cos e + x / halfWidth on the circle.
  double GetDistance(double radius, double height) const
  {
    double distance = height * this->Sine +
      radius * std::sqrt(this->Cosine * this->Cosine + 1.0 / (this->HalfWidth * this->HalfWidth));
    for (const double z : { radius, -radius })
    {
      distance = std::max(distance,
        height * this->Sine + z * this->Cosine +
          std::abs(height * this->Cosine - z * this->Sine) / this->HalfHeight);
    }
    return distance;
  }

private:
  double Sine, Cosine, HalfHeight, HalfWidth;
};

double GetDistance(vtkActor* actor, const Vector3& center, const Vector3& up, const Turntable& turn)
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  vtkPolyData* mesh = mapper ? mapper->GetInput() : nullptr;
  double distance = 0.0;
  for (vtkIdType i = 0; mesh && i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    mesh->GetPoint(i, point);
    actor->GetMatrix()->MultiplyPoint(point, point);
    vtkMath::Subtract(point, center.data(), point);
    const double height = vtkMath::Dot(point, up.data());
    const double radius = std::sqrt(std::max(0.0, vtkMath::Dot(point, point) - height * height));
    distance = std::max(distance, turn.GetDistance(radius, height));
  }
  return distance;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetUpNames()
{
  std::vector<std::string> names;
  names.reserve(Axes.size());
  for (const auto& entry : Axes)
  {
    names.emplace_back(entry.first);
  }
  return names;
}

//------------------------------------------------------------------------------
ModelAxes GetModelAxes(const std::string& up, const std::string& fileName)
{
  const std::string extension = GetExtension(fileName);
  const std::string usual = extension == "stl" || extension == "3ds" ? "z" : "y";
  const std::string& name = up.empty() ? usual : up;
  const auto* found = std::find_if(
    Axes.begin(), Axes.end(), [&name](const auto& entry) { return entry.first == name; });
  if (found == Axes.end())
  {
    throw UserError("unknown way up '" + name + "': expected " + ListNames(GetUpNames()));
  }
  return found->second;
}

//------------------------------------------------------------------------------
ModelAxes GetCameraAxes(const CameraSettings& camera)
{
  ModelAxes axes;
  axes.Up = camera.GetUp();
  vtkMath::Subtract(camera.Position.data(), camera.FocalPoint.data(), axes.Front.data());
  vtkMath::Cross(axes.Up.data(), axes.Front.data(), axes.Right.data());
  vtkMath::Cross(axes.Right.data(), axes.Up.data(), axes.Front.data());
  for (Vector3* axis : { &axes.Right, &axes.Up, &axes.Front })
  {
    vtkMath::Normalize(axis->data());
  }
  return axes;
}

//------------------------------------------------------------------------------
Vector3 Turn(const Vector3& vector, const ModelAxes& axes)
{
  Vector3 turned;
  for (std::size_t i = 0; i < 3; ++i)
  {
    turned[i] = vector[0] * axes.Right[i] + vector[1] * axes.Up[i] + vector[2] * axes.Front[i];
  }
  return turned;
}

//------------------------------------------------------------------------------
void SeeModel(CameraSettings& camera, const std::vector<Surface>& surfaces, const Vector3& center,
  const ModelAxes& axes, double aspect)
{
  const double length = vtkMath::Norm(EyeDirection.data());
  const double halfHeight = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera.ViewAngle));
  const Turntable turn(std::asin(EyeDirection[1] / length), halfHeight, halfHeight * aspect);
  double distance = 0.0;
  for (const Surface& surface : surfaces)
  {
    distance = std::max(distance, GetDistance(surface.Actor, center, axes.Up, turn));
  }
  Vector3 offset = Turn(EyeDirection, axes);
  vtkMath::MultiplyScalar(offset.data(), Margin * distance / length);
  camera.FocalPoint = center;
  camera.ViewUp = axes.Up;
  vtkMath::Add(center.data(), offset.data(), camera.Position.data());
}

}
