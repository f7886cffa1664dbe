// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightCasters.h"

#include "Casters/AirlightCasterBlocks.h"
#include "Casters/AirlightGlyphs.h"
#include "Casters/AirlightUsedEntries.h"
#include "Integration/AirlightMatrix.h"
#include "Scene/AirlightCasterKeys.h"
#include "Scene/AirlightClassTraits.h"
#include "Scene/AirlightSceneProps.h"
#include "vtkActor.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkGeometryFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cmath>

namespace airlight
{
namespace
{
// A flattened or undefined object has no shadow volume.
bool HasVolume(const glm::dmat4& toWorld)
{
  const double determinant = glm::determinant(toWorld);
  return std::isfinite(determinant) && determinant != 0.0;
}

// Whether what the mapper draws can be made of polygons.
bool HasPolygons(vtkMapper* mapper)
{
  auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper);
  if (!glyphs || glyphs->GetNumberOfInputConnections(0) == 0)
  {
    return glyphs || DrawsItsPolygons(mapper);
  }
  glyphs->Update();
  return HasSupportedGlyphs(glyphs);
}

// Whether a mapper draws all cells of this input. Of blocks, some may look otherwise than the
// actor.
bool ShowsAll(vtkDataObject* input)
{
  auto* data = vtkDataSet::SafeDownCast(input);
  return data && !data->HasAnyGhostCells() && !data->HasAnyBlankCells();
}
}

//------------------------------------------------------------------------------
const std::vector<Caster>& CasterCache::Collect(const SceneProps& props, bool translucent)
{
  this->Translucent = false;
  this->TakesTranslucent = translucent;
  this->Error.clear();
  this->Casters.clear();
  this->NonPolygonal.clear();
  this->UnsupportedProp.clear();
  MarkUnused(this->Meshes);
  MarkUnused(this->Surfaces);
  this->Pieces.BeginWalk();
  for (const SceneProp& prop : props.GetProps())
  {
    this->AddProp(prop);
  }
  this->Pieces.EndWalk();
  EraseUnused(this->Meshes);
  EraseUnused(this->Surfaces);
  return this->Casters;
}

//------------------------------------------------------------------------------
std::shared_ptr<const std::vector<PlanarFace>> CasterCache::Entry::GetFaces()
{
  if (!this->Faces)
  {
    this->Faces = std::make_shared<std::vector<PlanarFace>>(FindPlanarFaces(*this->Mesh));
  }
  return this->Faces->empty() ? nullptr : this->Faces;
}

//------------------------------------------------------------------------------
void CasterCache::Clear()
{
  this->Meshes.clear();
  this->Pieces.Clear();
  this->Surfaces.clear();
  this->Casters.clear();
  this->NonPolygonal.clear();
}

//------------------------------------------------------------------------------
void CasterCache::AddProp(const SceneProp& prop)
{
  if (!prop.Casts)
  {
    return;
  }
  for (const ScenePart& part : prop.Parts)
  {
    vtkMapper* mapper = part.Actor->GetMapper();
    if (mapper && part.Casts)
    {
      HasPolygons(mapper) ? this->AddActor(part, prop.Prop) : this->AddOther(part, prop.Prop);
    }
  }
  for (vtkProp* part : prop.OtherParts)
  {
    if (part->IsA("vtkLODProp3D") && CastsShadow(part))
    {
      this->UnsupportedProp = part->GetClassName();
    }
  }
}

//------------------------------------------------------------------------------
void CasterCache::AddOther(const ScenePart& part, vtkProp* owner)
{
  part.Actor->GetMapper()->Update();
  const NonPolygonalCaster other(part.Actor, owner, part.ToWorld);
  if (part.Actor->HasOpaqueGeometry() && !other.GetCorners().empty())
  {
    this->NonPolygonal.push_back(other);
  }
}

//------------------------------------------------------------------------------
// Where the opacity is not the property's and AddMesh() does not find it, the actor casts nothing.
CasterCache::Appearance CasterCache::GetAppearance(vtkActor* actor, vtkProp* owner)
{
  vtkMapper* mapper = actor->GetMapper();
  vtkProperty* property = actor->GetProperty();
  Appearance appearance;
  appearance.Owner = owner;
  appearance.Culled = property->GetBackfaceCulling() || property->GetFrontfaceCulling() ||
    (mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0);
  appearance.HidesFaces = appearance.Culled;
  const double opacity = property->GetOpacity();
  if (actor->HasTranslucentPolygonalGeometry() && (opacity < 1.0 || !actor->HasOpaqueGeometry()))
  {
    appearance.HidesFaces = true;
    appearance.Opacity = glm::dvec3(opacity < 1.0 ? opacity : 0.0);
  }
  // VTK hands an assembly's keys to its parts while it draws them.
  appearance.FromKey = ReadShadowOpacity(owner, appearance.Opacity, this->Error);
  return appearance;
}

//------------------------------------------------------------------------------
void CasterCache::AddActor(const ScenePart& part, vtkProp* owner)
{
  vtkActor* actor = part.Actor;
  vtkMatrix4x4* matrix = part.ToWorld;
  vtkMapper* mapper = actor->GetMapper();
  if (mapper->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  // Actors outside the view are not rendered, so nobody else updates them.
  mapper->Update();
  if (actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
    !(actor->HasOpaqueGeometry() || actor->HasTranslucentPolygonalGeometry()))
  {
    return;
  }
  Appearance appearance = this->GetAppearance(actor, owner);
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    this->AddGlyphs(glyphs, matrix, appearance);
    return;
  }
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  appearance.ShowsAll = owner == actor && ShowsAll(input);
  if (auto* data = vtkPolyData::SafeDownCast(input))
  {
    this->AddMesh(actor, data, matrix, appearance);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    for (const CasterBlock& block : GetBlocks(composite, mapper))
    {
      if (block.Opacity < 0.0)
      {
        this->AddMesh(actor, block.Data, matrix, appearance);
        continue;
      }
      Appearance own = appearance;
      own.HidesFaces = appearance.Culled || block.Opacity < 1.0;
      own.Opacity = appearance.FromKey ? appearance.Opacity : glm::dvec3(block.Opacity);
      this->AddData(block.Data, matrix, own);
    }
  }
  else if (auto* grid = vtkDataSet::SafeDownCast(input))
  {
    this->AddMesh(actor, this->GetSurface(grid), matrix, appearance);
  }
}

//------------------------------------------------------------------------------
// Each a caster of its own; they share the meshes of their sources.
void CasterCache::AddGlyphs(
  vtkGlyph3DMapper* mapper, vtkMatrix4x4* matrix, const Appearance& appearance)
{
  vtkNew<vtkMatrix4x4> toWorld;
  for (const Glyph& glyph : GetGlyphs(mapper))
  {
    vtkMatrix4x4::Multiply4x4(matrix, glyph.ToActor, toWorld);
    this->AddData(glyph.Source, toWorld, appearance);
  }
}

//------------------------------------------------------------------------------
vtkPolyData* CasterCache::GetSurface(vtkDataSet* grid)
{
  Surface& surface = this->Surfaces[grid];
  if (!surface.Filter)
  {
    surface.Filter = vtkSmartPointer<vtkGeometryFilter>::New();
    surface.Filter->SetInputData(grid);
  }
  surface.Used = true;
  surface.Filter->Update();
  return surface.Filter->GetOutput();
}

//------------------------------------------------------------------------------
// In pieces where textures or scalars make the opacity vary. A key is the opacity of all.
void CasterCache::AddMesh(
  vtkActor* actor, vtkPolyData* data, vtkMatrix4x4* matrix, const Appearance& appearance)
{
  const std::vector<OpacityPiece>* pieces = nullptr;
  if (appearance.FromKey || !this->Pieces.Find(actor, data, pieces))
  {
    this->AddData(data, matrix, appearance);
    return;
  }
  Appearance own = appearance;
  own.HidesFaces = true;
  for (const OpacityPiece& piece : *pieces)
  {
    own.Opacity = glm::dvec3(piece.Opacity);
    this->AddData(piece.Data, matrix, own);
  }
}

//------------------------------------------------------------------------------
void CasterCache::AddData(vtkPolyData* data, vtkMatrix4x4* matrix, const Appearance& appearance)
{
  Caster caster;
  caster.HidesFaces = appearance.HidesFaces;
  caster.Owner = appearance.Owner;
  caster.OpticalThickness = GetOpticalThickness(appearance.Opacity);
  caster.ToWorld = ToGlm(matrix);
  if (!HasVolume(caster.ToWorld) || caster.OpticalThickness == CasterOpticalThickness{})
  {
    return;
  }
  const bool translucent = caster.OpticalThickness.Blocks != glm::ivec3(1);
  this->Translucent = this->Translucent || translucent;
  if (translucent && !this->TakesTranslucent)
  {
    return;
  }
  Entry& entry = this->Meshes[data];
  const GeometryTimes times = GetGeometryTimes(data);
  // Another data set may have got a deleted one's address.
  if (entry.Data != data || entry.Times != times)
  {
    entry.Data = data;
    entry.Times = times;
    entry.Mesh = std::make_shared<CasterMesh>(data);
    entry.Faces = nullptr;
  }
  entry.Used = true;
  if (!entry.Mesh->Triangles.empty())
  {
    caster.Mesh = entry.Mesh;
    if (appearance.ShowsAll && !appearance.HidesFaces && !translucent)
    {
      caster.Faces = entry.GetFaces();
    }
    this->Casters.push_back(caster);
  }
}
}
