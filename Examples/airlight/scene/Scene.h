// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the programs render: a picture size, a camera, a medium, lamps and surfaces. Lengths are in
 * world units (metres in the reference scenes), radiance in W/(m^2 sr).
 *
 * A scene comes from a scene file (ReadScene) or from a model with default lamp, camera and medium
 * (MakeModelScene); BuildScene turns it into a window.
 */

#ifndef Scene_h
#define Scene_h

#include "formats/Vector3.h"

#include <vtkActor.h>
#include <vtkParticipatingMedium.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace airlight
{

///@{
/**
 * What scene files and command lines may ask for.
 */
constexpr double LargestNumber = 1e30; ///< beyond it single precision on the card overflows
constexpr double SmallestConeAngle = 0.001;
constexpr double LargestConeAngle = 89.999; ///< VTK takes 90 for a point light
constexpr double LargestExponent = 128.0;   ///< VTK clamps it there
constexpr double SmallestHeight = 1e-30;
constexpr double LargestAngularDiameter = 179.0; ///< degrees
///@}

struct CameraSettings
{
  Vector3 Position = { 0.0, 0.0, 1.0 };
  Vector3 FocalPoint = { 0.0, 0.0, 0.0 };
  Vector3 ViewUp = { 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0; ///< vertical, degrees

  /// The way up of a model's world, about which turntables turn; without one, or where the camera
  /// looks along it, that is ViewUp.
  std::optional<Vector3> Vertical;

  /**
   * Vertical or ViewUp.
   */
  Vector3 GetUp() const;
};

struct LightSource
{
  enum class Kind
  {
    Point,
    Spot,
    Directional
  };

  Kind Type = Kind::Point;
  Vector3 Position = { 0.0, 0.0, 0.0 };   ///< point and spot
  Vector3 Direction = { 0.0, -1.0, 0.0 }; ///< of the light's travel; all but plain points
  Vector3 Power = { 1.0, 1.0, 1.0 };      ///< radiant intensity W/sr; directional: irradiance W/m^2
  double ConeHalfAngle = 30.0;            ///< spot, degrees
  double Exponent = 0.0;                  ///< spot: intensity times cos(angle to the axis)^exponent
  bool Scatters = true;                   ///< vtkAirlightLight::SetScatters()

  /// Point and spot: a photometric file, empty for none. A point shines along Direction then, and
  /// Power is that of its brightest direction.
  std::string PhotometryFile;
  Vector3 PhotometryUp = { 0.0, 1.0, 0.0 }; ///< vtkAirlightLight::SetPhotometryUp()

  ///@{
  /// The lamp's extent, see vtkAirlightLight::SetRadius(). A rectangle lies across Direction.
  double Radius = 0.0;                       ///< point and spot
  std::array<double, 2> Size = { 0.0, 0.0 }; ///< point and spot, width and height
  double AngularDiameter = 0.0;              ///< directional, degrees
  ///@}
  bool Visible = false; ///< vtkAirlightLight::SetVisible(); of a lamp with an extent

  bool IsRectangle() const { return this->Size[0] > 0.0 || this->Size[1] > 0.0; }
  bool HasExtent() const
  {
    return this->Radius > 0.0 || this->IsRectangle() || this->AngularDiameter > 0.0;
  }
};

struct Surface
{
  std::string Name; ///< the file that it came from
  vtkSmartPointer<vtkActor> Actor;
};

struct Scene
{
  std::string FileName;
  int Width = 800;
  int Height = 600;
  CameraSettings Camera;
  vtkSmartPointer<vtkParticipatingMedium> Medium;
  std::vector<LightSource> Lights;
  std::vector<Surface> Surfaces;
  bool ScatteredSurfaceLight = false; ///< vtkAirlightPass::SetScatteredSurfaceLight()
  double Brightness = 1.0;            ///< factor of automatic exposure: nights are dark

  /**
   * Box around all surfaces: xmin, xmax, ymin, ymax, zmin, zmax. False if there is no surface.
   */
  bool GetBounds(double bounds[6]) const;
};

}

#endif
