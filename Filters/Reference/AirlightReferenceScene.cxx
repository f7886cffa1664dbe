// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceScene.h"

#include "Reference/AirlightReferenceMesh.h"
#include "Scene/AirlightClassTraits.h"
#include "Scene/AirlightSceneProps.h"
#include "Scene/AirlightVTKVersions.h"
#include "vtkActor.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkGeometryFilter.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/gtc/type_ptr.hpp>

namespace airlight
{
namespace
{
std::vector<glm::dvec4> GetClippingPlanes(vtkMapper* mapper)
{
  std::vector<glm::dvec4> result;
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    const glm::dvec3 normal = glm::make_vec3(planes->GetItem(i)->GetNormal());
    const glm::dvec3 origin = glm::make_vec3(planes->GetItem(i)->GetOrigin());
    result.emplace_back(normal, -glm::dot(normal, origin));
  }
  return result;
}
}

//------------------------------------------------------------------------------
ReferenceMaterial::ReferenceMaterial(vtkProperty* property)
  : Ambient(property->GetAmbient() * glm::make_vec3(property->GetAmbientColor()))
  , Diffuse(property->GetDiffuse() * glm::make_vec3(property->GetDiffuseColor()))
  , Specular(property->GetSpecular() * glm::make_vec3(property->GetSpecularColor()))
  , SpecularPower(property->GetSpecularPower())
  , Opacity(property->GetOpacity())
{
}

//------------------------------------------------------------------------------
ReferenceScene::ReferenceScene(vtkRenderer* renderer)
{
  const SceneProps props(renderer);
  for (const SceneProp& prop : props.GetProps())
  {
    this->AddProp(prop);
  }
  if (renderer->GetTexturedBackground())
  {
    this->Unsupported.insert("textured background");
  }
  this->Opaque.Build();
  this->Casting.Build();
  this->Translucent.Build();
}

//------------------------------------------------------------------------------
std::string ReferenceScene::GetUnsupported() const
{
  std::string text;
  for (const std::string& name : this->Unsupported)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

//------------------------------------------------------------------------------
bool ReferenceScene::IsHidden(const OccluderTriangle& triangle, const glm::dvec3& origin,
  const glm::dvec3& direction, double t) const
{
  const ReferencePart& part = this->GetPart(triangle);
  if (IsSeenFromFront(triangle, direction) ? part.HidesFront : part.HidesBack)
  {
    return true;
  }
  const glm::dvec4 point(origin + t * direction, 1.0);
  for (const glm::dvec4& plane : part.ClippingPlanes)
  {
    if (glm::dot(plane, point) < 0.0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool ReferenceScene::FindFirst(const Occluders& surfaces, const glm::dvec3& origin,
  const glm::dvec3& direction, double after, double before, ReferenceHit& hit) const
{
  Occluders::Hit found;
  while (surfaces.FirstHit(origin, direction, after, before, found))
  {
    const OccluderTriangle& triangle = surfaces.GetTriangles()[found.Triangle];
    if (!this->IsHidden(triangle, origin, direction, found.T))
    {
      hit = { found.T, &triangle };
      return true;
    }
    after = found.T;
  }
  return false;
}

//------------------------------------------------------------------------------
void ReferenceScene::AddProp(const SceneProp& prop)
{
  if (prop.Prop->IsA("vtkActor2D"))
  {
    return;
  }
  for (const ScenePart& part : prop.Parts)
  {
    this->AddActor(part.Actor, part.ToWorld, part.Casts);
  }
  for (vtkProp* part : prop.OtherParts)
  {
    this->Unsupported.insert(part->GetClassName());
  }
}

//------------------------------------------------------------------------------
// Notes what cannot be drawn, or not as VTK draws it.
bool ReferenceScene::CanDraw(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  vtkProperty* property = actor->GetProperty();
  if (!DrawsItsPolygons(mapper))
  {
    this->Unsupported.insert(mapper->GetClassName());
    return false;
  }
  if (property->GetRepresentation() != VTK_SURFACE)
  {
    this->Unsupported.insert("representation as wireframe or points");
    return false;
  }
  const auto note = [&](bool used, const char* name) {
    if (used)
    {
      this->Unsupported.insert(name);
    }
  };
  note(actor->GetTexture() || property->GetNumberOfTextures() > 0, "textures");
  note(property->GetInterpolation() == VTK_PBR, "physically based shading");
  note(property->GetEdgeVisibility(), "edges of polygons");
  note(BlocksMapper::SafeDownCast(mapper), "visibility and colours of single blocks");
  return true;
}

//------------------------------------------------------------------------------
void ReferenceScene::AddActor(vtkActor* actor, vtkMatrix4x4* matrix, bool casts)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0 || !this->CanDraw(actor))
  {
    return;
  }
  mapper->Update();
  this->AddDataObject(mapper->GetInputDataObject(0, 0), actor, matrix, casts);
}

//------------------------------------------------------------------------------
void ReferenceScene::AddDataObject(
  vtkDataObject* data, vtkActor* actor, vtkMatrix4x4* matrix, bool casts)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    this->AddData(mesh, actor, matrix, casts);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      this->AddDataObject(it->GetCurrentDataObject(), actor, matrix, casts);
    }
  }
  else if (auto* grid = vtkDataSet::SafeDownCast(data))
  {
    // The surface, as vtkDataSetMapper takes it.
    vtkNew<vtkGeometryFilter> surface;
    surface->SetInputData(grid);
    surface->Update();
    this->AddData(surface->GetOutput(), actor, matrix, casts);
  }
}

//------------------------------------------------------------------------------
void ReferenceScene::AddData(vtkPolyData* data, vtkActor* actor, vtkMatrix4x4* matrix, bool casts)
{
  if (data->GetNumberOfVerts() + data->GetNumberOfLines() > 0)
  {
    this->Unsupported.insert("points and lines");
  }
  const ReferenceMesh mesh(data, matrix);
  if (mesh.GetCorners().empty())
  {
    return;
  }
  vtkProperty* property = actor->GetProperty();
  vtkProperty* back = actor->GetBackfaceProperty();
  vtkMapper* mapper = actor->GetMapper();
  ReferencePart part;
  part.Front = ReferenceMaterial(property);
  part.AmbientFactor = property->GetAmbient();
  part.DiffuseFactor = property->GetDiffuse();
  part.Lighting = property->GetLighting();
  part.HidesFront = property->GetFrontfaceCulling();
  part.HidesBack = property->GetBackfaceCulling();
  part.ClippingPlanes = GetClippingPlanes(mapper);
  part.Normals = mesh.GetNormals(property->GetInterpolation() == VTK_FLAT);
  part.Colours = mesh.GetColours(mapper);
  // Scalars leave backface properties without effect.
  part.Back = back && part.Colours.empty() ? ReferenceMaterial(back) : part.Front;
  if (part.Colours.empty() && mapper->GetScalarVisibility() &&
    mapper->GetInterpolateScalarsBeforeMapping() && mapper->GetColorTextureMap())
  {
    this->Unsupported.insert("scalars interpolated before mapping");
  }
  const int number = static_cast<int>(this->Parts.size());
  this->Parts.push_back(std::move(part));
  if (!actor->HasOpaqueGeometry())
  {
    this->Translucent.Add(mesh.GetTriangles(), nullptr, number);
    return;
  }
  this->Opaque.Add(mesh.GetTriangles(), nullptr, number);
  this->AllCast = this->AllCast && casts;
  if (casts)
  {
    this->Casting.Add(mesh.GetTriangles(), nullptr, number);
  }
}
}
