// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVParticipatingMedium.h"

#include "AirlightSceneLengths.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkPVParticipatingMedium);

namespace
{
// Koschmieder 1924, as in vtkParticipatingMedium::SetVisibility().
constexpr double ContrastThreshold = 3.912;

// What is left of the light of the scene's far end, seen from where ParaView first places the
// camera: half a diagonal over the sine of half of the view angle of 30 degrees from the centre.
// PyVista's component leaves less, 0.3, since it also adds a lamp.
constexpr double FarTransmittance = 0.5;
constexpr double FarEnd = 0.5 / 0.25881904510252074 + 0.5; // in diagonals

constexpr double UnknownVisibility = 10.0; // without a scene, in world units

// Of the colour of the background: the sky over fog is brighter than the fog.
constexpr double AmbientShare = 0.55;
constexpr double MaximumRadiance = 1e100;

bool HasAnisotropy(int function)
{
  return function == vtkParticipatingMedium::HENYEY_GREENSTEIN ||
    function == vtkParticipatingMedium::SCHLICK ||
    function == vtkParticipatingMedium::CORNETTE_SHANKS;
}

// Some valid surface.
void MakeTetrahedron(vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    points->InsertNextPoint(i == 0, i == 1, i == 2);
  }
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const vtkIdType face[3] = { i, (i + 1) % 4, (i + 2) % 4 };
    faces->InsertNextCell(3, face);
  }
  surface->Initialize();
  surface->SetPoints(points);
  surface->SetPolys(faces);
}

// Some valid image.
void MakeCell(vtkImageData* image)
{
  image->Initialize();
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::fill_n(static_cast<float*>(image->GetScalarPointer()), 8, 0.0f);
}
}

//------------------------------------------------------------------------------
vtkPVParticipatingMedium::vtkPVParticipatingMedium()
  : Lengths(std::make_unique<airlight::SceneLengths>())
{
  this->UpdateThickness();
  this->UpdatePhase();
}

vtkPVParticipatingMedium::~vtkPVParticipatingMedium() = default;

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetThickness(int thickness)
{
  if (thickness != VISIBILITY && thickness != COEFFICIENTS)
  {
    vtkErrorMacro(<< "Thickness " << thickness << " must be VISIBILITY (0) or COEFFICIENTS (1).");
    return;
  }
  this->Thickness = thickness;
  this->UpdateThickness();
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::TakeDistance(const char* name, double value, double& distance)
{
  if (!std::isfinite(value) || value < 0.0)
  {
    vtkErrorMacro(<< name << " " << value << " must be finite and at least 0; it stays " << distance
                  << ".");
    return;
  }
  distance = value;
  this->UpdateThickness();
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetVisibilityDistance(double distance)
{
  this->TakeDistance("VisibilityDistance", distance, this->VisibilityDistance);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetAutomaticVisibility(double distance)
{
  this->TakeDistance("AutomaticVisibility", distance, this->AutomaticVisibility);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetSceneBounds(const double bounds[6])
{
  this->Lengths->Scene = vtkBoundingBox();
  if (std::all_of(bounds, bounds + 6, [](double value) { return std::isfinite(value); }))
  {
    this->Lengths->Scene.SetBounds(bounds);
  }
  const double size =
    this->Lengths->Scene.IsValid() ? this->Lengths->Scene.GetDiagonalLength() : 0.0;
  if (this->SceneSize != size)
  {
    this->SceneSize = size;
    this->UpdateThickness();
  }
  this->Lengths->Apply(this);
}

//------------------------------------------------------------------------------
// The medium's own setters refuse invalid values, and say so.
void vtkPVParticipatingMedium::SetRegionBounds(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax)
{
  const double bounds[6] = { xmin, xmax, ymin, ymax, zmin, zmax };
  if (std::any_of(bounds, bounds + 6, [](double value) { return value != 0.0; }))
  {
    this->SetBounds(bounds);
    if (!std::equal(bounds, bounds + 6, this->GetBounds()))
    {
      return;
    }
  }
  std::copy(bounds, bounds + 6, this->Lengths->Bounds);
  this->Lengths->Apply(this);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetRegionCenter(double x, double y, double z)
{
  const double center[3] = { x, y, z };
  this->SetCenter(center);
  if (std::equal(center, center + 3, this->GetCenter()))
  {
    std::copy(center, center + 3, this->Lengths->Center);
    this->Lengths->Apply(this);
  }
}

//------------------------------------------------------------------------------
// 0 is automatic: the medium's own setter does not see it.
void vtkPVParticipatingMedium::TakeLength(double value, double& length,
  void (vtkParticipatingMedium::*set)(double), double (vtkParticipatingMedium::*get)())
{
  if (value != 0.0)
  {
    (this->*set)(value);
  }
  if (value == 0.0 || value == (this->*get)())
  {
    length = value;
    this->Lengths->Apply(this);
  }
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetRegionRadius(double radius)
{
  this->TakeLength(radius, this->Lengths->Radius, &vtkParticipatingMedium::SetRadius,
    &vtkParticipatingMedium::GetRadius);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetRegionHeight(double height)
{
  this->TakeLength(height, this->Lengths->Height, &vtkParticipatingMedium::SetHeight,
    &vtkParticipatingMedium::GetHeight);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetDensityScaleHeight(double height)
{
  this->TakeLength(height, this->Lengths->ScaleHeight, &vtkParticipatingMedium::SetScaleHeight,
    &vtkParticipatingMedium::GetScaleHeight);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetDensityReferenceHeight(double height)
{
  this->SetReferenceHeight(height);
  if (height == this->GetReferenceHeight())
  {
    this->Lengths->ReferenceHeight = height;
    this->Lengths->Apply(this);
  }
}

//------------------------------------------------------------------------------
double vtkPVParticipatingMedium::GetEffectiveVisibility()
{
  if (this->VisibilityDistance > 0.0)
  {
    return this->VisibilityDistance;
  }
  if (this->AutomaticVisibility > 0.0)
  {
    return this->AutomaticVisibility;
  }
  return this->SceneSize > 0.0
    ? ContrastThreshold / -std::log(FarTransmittance) * FarEnd * this->SceneSize
    : UnknownVisibility;
}

//------------------------------------------------------------------------------
// Takes values from 0 to the most.
bool vtkPVParticipatingMedium::SetRange(
  const char* name, const double values[3], double most, double target[3])
{
  if (!std::all_of(values, values + 3,
        [most](double value) { return std::isfinite(value) && value >= 0.0 && value <= most; }))
  {
    vtkErrorMacro(<< name << " (" << values[0] << ", " << values[1] << ", " << values[2]
                  << ") must be finite, at least 0" << (most == 1.0 ? " and at most 1" : "")
                  << "; it stays (" << target[0] << ", " << target[1] << ", " << target[2] << ").");
    return false;
  }
  std::copy(values, values + 3, target);
  this->UpdateThickness();
  return true;
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetColor(double r, double g, double b)
{
  const double values[3] = { r, g, b };
  this->SetRange("Color", values, 1.0, this->Color);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetScatteringCoefficient(double r, double g, double b)
{
  const double values[3] = { r, g, b };
  this->SetRange("ScatteringCoefficient", values, VTK_DOUBLE_MAX, this->ScatteringCoefficient);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetAbsorptionCoefficient(double r, double g, double b)
{
  const double values[3] = { r, g, b };
  this->SetRange("AbsorptionCoefficient", values, VTK_DOUBLE_MAX, this->AbsorptionCoefficient);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::UpdateThickness()
{
  if (this->Thickness == COEFFICIENTS)
  {
    this->SetScattering(this->ScatteringCoefficient);
    this->SetAbsorption(this->AbsorptionCoefficient);
    return;
  }
  const double extinction = ContrastThreshold / this->GetEffectiveVisibility();
  const double* albedo = this->Color;
  this->SetScattering(albedo[0] * extinction, albedo[1] * extinction, albedo[2] * extinction);
  this->SetAbsorption(
    (1.0 - albedo[0]) * extinction, (1.0 - albedo[1]) * extinction, (1.0 - albedo[2]) * extinction);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetAmbient(double r, double g, double b)
{
  const double values[3] = { r, g, b };
  this->SetRange("AmbientRadiance", values, MaximumRadiance, this->Ambient);
  this->UpdateAmbient();
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetAmbientFromBackground(bool on)
{
  this->AmbientFromBackground = on;
  this->UpdateAmbient();
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetBackground(const double rgb[3])
{
  std::copy(rgb, rgb + 3, this->Background);
  this->UpdateAmbient();
}

//------------------------------------------------------------------------------
// Setters of a medium do nothing if the value is as before.
void vtkPVParticipatingMedium::UpdateAmbient()
{
  const bool isGiven =
    std::any_of(this->Ambient, this->Ambient + 3, [](double value) { return value > 0.0; });
  const double share = this->AmbientFromBackground ? AmbientShare : 0.0;
  double radiance[3];
  for (int i = 0; i < 3; ++i)
  {
    radiance[i] = isGiven ? this->Ambient[i] : share * this->Background[i];
  }
  this->SetAmbientRadiance(radiance);
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetPhase(int function)
{
  if (function < ISOTROPIC || function > OBJECT || function == TABULATED)
  {
    vtkErrorMacro(<< "Phase " << function << " must be from " << ISOTROPIC << " (ISOTROPIC) to "
                  << MIE_MURKY << " (MIE_MURKY), or " << OBJECT << " (OBJECT, Draine's); it stays "
                  << this->Phase << ".");
    return;
  }
  this->Phase = function;
  this->UpdatePhase();
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetPhaseAnisotropy(double g)
{
  if (!(g >= -0.99 && g <= 0.99))
  {
    vtkErrorMacro(<< "PhaseAnisotropy " << g << " must be from -0.99 to 0.99; it stays "
                  << this->PhaseAnisotropy << ".");
    return;
  }
  this->PhaseAnisotropy = g;
  this->UpdatePhase();
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::SetPhaseAlpha(double alpha)
{
  double range[2];
  this->Draine->GetParameterRange(1, range);
  if (!(alpha >= range[0] && alpha <= range[1]))
  {
    vtkErrorMacro(<< "PhaseAlpha " << alpha << " must be from " << range[0] << " to " << range[1]
                  << "; it stays " << this->PhaseAlpha << ".");
    return;
  }
  this->PhaseAlpha = alpha;
  this->UpdatePhase();
}

//------------------------------------------------------------------------------
// A function without anisotropy accepts none but 0, which every function takes.
void vtkPVParticipatingMedium::UpdatePhase()
{
  this->SetAnisotropy(0.0);
  if (this->Phase == OBJECT)
  {
    this->Draine->SetAnisotropy(this->PhaseAnisotropy);
    this->Draine->SetAlpha(this->PhaseAlpha);
    this->SetPhaseFunction(this->Draine);
    return;
  }
  this->SetPhaseFunction(this->Phase);
  if (HasAnisotropy(this->Phase))
  {
    this->SetAnisotropy(this->PhaseAnisotropy);
  }
}

//------------------------------------------------------------------------------
// Valid when it is set, which is all that the setter looks at.
void vtkPVParticipatingMedium::FollowSurface(vtkPolyData* surface)
{
  if (!surface)
  {
    this->SetSurface(nullptr);
  }
  else if (this->GetSurface() != surface)
  {
    vtkNew<vtkPolyData> contents;
    contents->ShallowCopy(surface);
    MakeTetrahedron(surface);
    this->SetSurface(surface);
    surface->ShallowCopy(contents);
    surface->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::FollowDensityImage(vtkImageData* image)
{
  if (!image)
  {
    this->SetDensityImage(nullptr);
  }
  else if (this->GetDensityImage() != image)
  {
    vtkNew<vtkImageData> contents;
    contents->ShallowCopy(image);
    MakeCell(image);
    this->SetDensityImage(image);
    image->ShallowCopy(contents);
    image->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVParticipatingMedium::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* values) {
    os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << "\n";
  };
  os << indent << "Thickness: " << (this->Thickness == VISIBILITY ? "Visibility" : "Coefficients")
     << "\n";
  os << indent << "VisibilityDistance: " << this->VisibilityDistance << "\n";
  os << indent << "AutomaticVisibility: " << this->AutomaticVisibility << "\n";
  os << indent << "SceneSize: " << this->SceneSize << "\n";
  print("Color", this->Color);
  print("ScatteringCoefficient", this->ScatteringCoefficient);
  print("AbsorptionCoefficient", this->AbsorptionCoefficient);
  print("Ambient", this->Ambient);
  os << indent << "AmbientFromBackground: " << this->AmbientFromBackground << "\n";
  print("Background", this->Background);
  os << indent << "Phase: " << this->Phase << "\n";
  os << indent << "PhaseAnisotropy: " << this->PhaseAnisotropy << "\n";
  os << indent << "PhaseAlpha: " << this->PhaseAlpha << "\n";
}
