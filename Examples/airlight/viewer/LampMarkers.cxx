// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/LampMarkers.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>

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

// Yellow on a dark rim, visible on fog as on night
const Color Black = { 0.0, 0.0, 0.0 };
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
  actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  actor->VisibilityOff();
  renderer->AddActor2D(actor);
}

void Place(vtkActor2D* actor, vtkLight* lamp, bool visible)
{
  actor->GetPositionCoordinate()->SetValue(lamp->GetPosition());
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
    AddCircle(renderer, marker.Rim, RimRadius, true, Black);
    marker.Rim->GetProperty()->SetOpacity(0.5);
    AddCircle(renderer, marker.Dot, DotRadius, true, Yellow);
  }
  AddCircle(renderer, this->Ring, RingRadius, false, Yellow);
}

//------------------------------------------------------------------------------
bool LampMarkers::IsShown(vtkLight* lamp) const
{
  return this->Visible && lamp->GetPositional() && IsAhead(this->Renderer->GetActiveCamera(), lamp);
}

//------------------------------------------------------------------------------
void LampMarkers::Update(int chosen)
{
  this->Ring->VisibilityOff();
  for (int i = 0; i < static_cast<int>(this->Markers.size()); ++i)
  {
    const Marker& marker = this->Markers[static_cast<std::size_t>(i)];
    const bool shown = this->IsShown(marker.Lamp);
    Place(marker.Rim, marker.Lamp, shown);
    Place(marker.Dot, marker.Lamp, shown);
    if (i == chosen)
    {
      Place(this->Ring, marker.Lamp, shown);
    }
  }
}

//------------------------------------------------------------------------------
int LampMarkers::Find(int x, int y) const
{
  int found = None;
  double nearest = Reach;
  for (int i = 0; i < static_cast<int>(this->Markers.size()); ++i)
  {
    const Marker& marker = this->Markers[static_cast<std::size_t>(i)];
    if (this->IsShown(marker.Lamp))
    {
      const double* place =
        marker.Dot->GetPositionCoordinate()->GetComputedDoubleDisplayValue(this->Renderer);
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
