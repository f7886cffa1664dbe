// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightOpacityPieces.h"

#include "Casters/AirlightOpacityMesh.h"
#include "Casters/AirlightUsedEntries.h"
#include "Scene/AirlightGeometryTimes.h"
#include "Scene/AirlightTextureColours.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"

#include <set>

namespace airlight
{
namespace
{
constexpr int Levels = 8;

// Opacities that are neither nearly 0 nor nearly 1, and the share of a cut-out's corners that may
// be so.
constexpr double Nearly = 0.05;
constexpr double MostBetween = 0.1;

// So many different opacities of whole triangles are kept as they are.
constexpr size_t MostExact = 32;

bool IsFlat(const OpacityTriangle& t)
{
  return t[0].Opacity == t[1].Opacity && t[0].Opacity == t[2].Opacity;
}

// The part of a polygon on one side of an opacity. Points on an edge are interpolated from its less
// opaque end, so that both triangles at it get the same.
std::vector<OpacityCorner> Clip(const std::vector<OpacityCorner>& polygon, double value, bool above)
{
  std::vector<OpacityCorner> part;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const OpacityCorner& a = polygon[i];
    const OpacityCorner& b = polygon[(i + 1) % polygon.size()];
    if ((a.Opacity >= value) == above)
    {
      part.push_back(a);
    }
    if ((a.Opacity >= value) != (b.Opacity >= value))
    {
      const OpacityCorner& low = a.Opacity < b.Opacity ? a : b;
      const OpacityCorner& high = a.Opacity < b.Opacity ? b : a;
      const double share = (value - low.Opacity) / (high.Opacity - low.Opacity);
      part.push_back({ glm::mix(low.Position, high.Position, share), value });
    }
  }
  return part;
}

// Gathers polygons by their opacity.
class Cutter
{
public:
  explicit Cutter(int levels)
    : Levels(levels)
  {
  }

  void CutTriangle(const OpacityTriangle& triangle)
  {
    std::vector<OpacityCorner> rest(triangle.begin(), triangle.end());
    for (int level = 0; level < this->Levels && rest.size() > 2; ++level)
    {
      const double value = (level + 0.5) / this->Levels;
      this->Add(static_cast<double>(level) / this->Levels, Clip(rest, value, false));
      rest = Clip(rest, value, true);
    }
    this->Add(1.0, rest);
  }

  void Add(double opacity, const std::vector<OpacityCorner>& polygon)
  {
    if (polygon.size() < 3 || opacity <= 0.0)
    {
      return;
    }
    vtkSmartPointer<vtkPolyData>& mesh = this->Meshes[opacity];
    if (!mesh)
    {
      mesh = vtkSmartPointer<vtkPolyData>::New();
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      mesh->SetPoints(points);
      mesh->SetPolys(vtkNew<vtkCellArray>());
    }
    mesh->GetPolys()->InsertNextCell(static_cast<int>(polygon.size()));
    for (const OpacityCorner& corner : polygon)
    {
      mesh->GetPolys()->InsertCellPoint(mesh->GetPoints()->InsertNextPoint(&corner.Position.x));
    }
  }

  std::vector<OpacityPiece> GetPieces() const
  {
    std::vector<OpacityPiece> pieces;
    for (const auto& mesh : this->Meshes)
    {
      pieces.push_back({ mesh.second, mesh.first });
    }
    return pieces;
  }

private:
  std::map<double, vtkSmartPointer<vtkPolyData>> Meshes;
  int Levels;
};

std::vector<OpacityPiece> CutToPieces(const OpacityMesh& mesh, bool opaque)
{
  size_t corners = 0;
  size_t between = 0;
  std::set<double> flat;
  mesh.VisitTriangles([&](const OpacityTriangle& triangle) {
    for (const OpacityCorner& corner : triangle)
    {
      ++corners;
      between += corner.Opacity > Nearly && corner.Opacity < 1.0 - Nearly ? 1 : 0;
    }
    if (IsFlat(triangle) && flat.size() <= MostExact)
    {
      flat.insert(triangle[0].Opacity);
    }
  });
  const bool cutOut =
    opaque || static_cast<double>(between) < MostBetween * static_cast<double>(corners);
  const bool exact = !cutOut && flat.size() <= MostExact;
  Cutter cutter(cutOut ? 1 : Levels);
  mesh.VisitTriangles([&](const OpacityTriangle& triangle) {
    if (exact && IsFlat(triangle))
    {
      cutter.Add(triangle[0].Opacity, { triangle.begin(), triangle.end() });
    }
    else
    {
      cutter.CutTriangle(triangle);
    }
  });
  return cutter.GetPieces();
}

// Of most actors it cannot; these need no record.
bool MayVary(vtkActor* actor, vtkPolyData* data)
{
  int kind = 0;
  return GetColourTexture(actor) ||
    (!actor->HasOpaqueGeometry() && FindMappedScalars(actor->GetMapper(), data, kind));
}
}

//------------------------------------------------------------------------------
OpacityPieces::Stamp OpacityPieces::GetStamp(vtkActor* actor, vtkPolyData* data)
{
  vtkMapper* mapper = actor->GetMapper();
  vtkTexture* texture = GetColourTexture(actor);
  if (texture && texture->GetInputAlgorithm())
  {
    texture->GetInputAlgorithm()->Update();
  }
  return { data->GetMTime(), mapper->GetMTime(),
    mapper->GetScalarVisibility() ? GetTime(mapper->GetLookupTable()) : 0, GetTime(texture),
    GetTime(texture ? texture->GetInput() : nullptr),
    static_cast<vtkMTimeType>(actor->HasOpaqueGeometry()) };
}

//------------------------------------------------------------------------------
bool OpacityPieces::Find(
  vtkActor* actor, vtkPolyData* data, const std::vector<OpacityPiece>*& pieces)
{
  if (!MayVary(actor, data))
  {
    return false;
  }
  Entry& entry = this->Entries[{ actor, data }];
  entry.Used = true;
  const Stamp times = GetStamp(actor, data);
  const double opacity = actor->GetProperty()->GetOpacity();
  // Another mesh may have got a deleted one's address.
  if (entry.Data != data || entry.Times != times || entry.ActorOpacity != opacity)
  {
    entry.Data = data;
    entry.Times = times;
    entry.ActorOpacity = opacity;
    const OpacityMesh mesh(actor, data);
    entry.Varies = mesh.Varies();
    entry.Pieces = entry.Varies ? CutToPieces(mesh, actor->HasOpaqueGeometry() != 0)
                                : std::vector<OpacityPiece>();
  }
  pieces = &entry.Pieces;
  return entry.Varies;
}

//------------------------------------------------------------------------------
void OpacityPieces::BeginWalk() { MarkUnused(this->Entries); }

//------------------------------------------------------------------------------
void OpacityPieces::EndWalk() { EraseUnused(this->Entries); }
}
