// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/LampMarkers.h"

#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkMath.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace airlight
{

namespace
{
using Color = std::array<double, 3>;

// Pixels
constexpr double DotRadius = 4.0;
constexpr double RimRadius = 6.0;
constexpr double RingRadius = 9.0;
constexpr double Reach = 10.0;
constexpr double EdgeMargin = 12.0;

constexpr double OutsideOpacity = 0.6;

// Yellow on a dark rim, visible on fog as on night
const Color Dark = { 0.3, 0.25, 0.1 };
const Color Yellow = { 1.0, 0.8, 0.2 };

void AddCircle(
  vtkRenderer* renderer, vtkActor2D* actor, double radius, bool filled, const Color& color)
{
  vtkNew<vtkRegularPolygonSource> circle;
  circle->SetNumberOfSides(24);
  circle->SetRadius(radius);
  circle->SetGeneratePolygon(filled);
  circle->SetGeneratePolyline(!filled);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(circle->GetOutputPort());
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
  actor->VisibilityOff();
  renderer->AddActor2D(actor);
}

void Place(vtkActor2D* actor, const std::array<double, 2>& place, bool visible, bool inside)
{
  actor->GetPositionCoordinate()->SetValue(place[0], place[1]);
  actor->GetProperty()->SetOpacity(inside ? 1.0 : OutsideOpacity);
  actor->SetVisibility(visible);
}

bool IsAhead(vtkCamera* camera, vtkLight* lamp)
{
  double way[3];
  vtkMath::Subtract(lamp->GetPosition(), camera->GetPosition(), way);
  return vtkMath::Dot(way, camera->GetDirectionOfProjection()) > 0.0;
}
}

//------------------------------------------------------------------------------
LampMarkers::LampMarkers(vtkRenderer* renderer, const std::vector<vtkSmartPointer<vtkLight>>& lamps)
  : Renderer(renderer)
  , Markers(lamps.size())
{
  for (std::size_t i = 0; i < lamps.size(); ++i)
  {
    Marker& marker = this->Markers[i];
    marker.Lamp = lamps[i];
    AddCircle(renderer, marker.Rim, RimRadius, true, Dark);
    AddCircle(renderer, marker.Dot, DotRadius, true, Yellow);
  }
  AddCircle(renderer, this->Ring, RingRadius, false, Yellow);
  this->Ring->GetProperty()->SetLineWidth(2.0F);
}

//------------------------------------------------------------------------------
bool LampMarkers::IsShown(vtkLight* lamp) const
{
  return this->Visible && lamp->GetPositional() && IsAhead(this->Renderer->GetActiveCamera(), lamp);
}

//------------------------------------------------------------------------------
std::array<double, 2> LampMarkers::Project(vtkLight* lamp) const
{
  vtkNew<vtkCoordinate> place;
  place->SetCoordinateSystemToWorld();
  place->SetValue(lamp->GetPosition());
  const double* display = place->GetComputedDoubleDisplayValue(this->Renderer);
  return { display[0], display[1] };
}

//------------------------------------------------------------------------------
std::array<double, 2> LampMarkers::FindDot(vtkLight* lamp) const
{
  const int* size = this->Renderer->GetSize();
  std::array<double, 2> place = this->Project(lamp);
  if (place[0] < 0.0 || place[1] < 0.0 || place[0] > size[0] || place[1] > size[1])
  {
    place[0] = std::max(EdgeMargin, std::min(place[0], size[0] - EdgeMargin));
    place[1] = std::max(this->Bottom + EdgeMargin, std::min(place[1], size[1] - EdgeMargin));
  }
  return place;
}

//------------------------------------------------------------------------------
std::array<double, 2> LampMarkers::GetOffset(int lamp) const
{
  vtkLight* light = this->Markers[static_cast<std::size_t>(lamp)].Lamp;
  const std::array<double, 2> dot = this->FindDot(light);
  const std::array<double, 2> place = this->Project(light);
  return { dot[0] - place[0], dot[1] - place[1] };
}

//------------------------------------------------------------------------------
void LampMarkers::Update(int chosen)
{
  bool ringed = false;
  for (int i = 0; i < static_cast<int>(this->Markers.size()); ++i)
  {
    const Marker& marker = this->Markers[static_cast<std::size_t>(i)];
    const bool shown = this->IsShown(marker.Lamp);
    const std::array<double, 2> place = this->FindDot(marker.Lamp);
    const bool inside = place == this->Project(marker.Lamp);
    Place(marker.Rim, place, shown, inside);
    Place(marker.Dot, place, shown, inside);
    if (i == chosen)
    {
      Place(this->Ring, place, shown, inside);
      ringed = shown;
    }
  }
  this->Ring->SetVisibility(ringed);
}

//------------------------------------------------------------------------------
int LampMarkers::Find(int x, int y) const
{
  int found = None;
  double nearest = Reach;
  for (int i = 0; i < static_cast<int>(this->Markers.size()); ++i)
  {
    vtkLight* lamp = this->Markers[static_cast<std::size_t>(i)].Lamp;
    if (this->IsShown(lamp))
    {
      const std::array<double, 2> place = this->FindDot(lamp);
      const double distance = std::hypot(place[0] - x, place[1] - y);
      if (distance <= nearest)
      {
        nearest = distance;
        found = i;
      }
    }
  }
  return found;
}

}
