// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceScene.h"

#include "Reference/AirlightReferenceMesh.h"
#include "Reference/AirlightReferenceSurface.h"
#include "Scene/AirlightCasterKeys.h"
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

#include <algorithm>
#include <cmath>
#include <limits>

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
static void AddTexture(vtkActor* actor, const ReferenceMesh& mesh, ReferencePart& part)
{
  auto texture = std::make_shared<TextureColours>(GetColourTexture(actor));
  part.TextureCoordinates = mesh.GetTextureCoordinates();
  if (!texture->IsEmpty() && !part.TextureCoordinates.empty())
  {
    part.Texture = texture;
    part.HasHoles = texture->HasAlpha();
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
ReferenceScene::ReferenceScene(vtkRenderer* renderer, bool translucentShadows, bool volumeShadows)
  : TranslucentShadows(translucentShadows)
{
  const SceneProps props(renderer);
  for (const SceneProp& prop : props.GetProps())
  {
    this->AddProp(prop);
    for (const SceneVolume& part : prop.VolumeParts)
    {
      if (volumeShadows && part.Casts)
      {
        this->Volumes.Add(part.Volume, part.ToWorld);
      }
    }
  }
  if (renderer->GetTexturedBackground())
  {
    this->Unsupported.insert("textured background");
  }
  this->Opaque.Build();
  this->Casting.Build();
  this->Translucent.Build();
  this->Dimming.Build();
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
  if (part.HasHoles &&
    !(ReferenceSurface(part, triangle, glm::dvec3(point), direction).Material.Opacity > 0.0))
  {
    return true; // VTK's shaders discard it
  }
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
    this->AddActor(part, prop.Prop);
  }
  for (vtkProp* part : prop.OtherParts)
  {
    if (!IsMedium(part, prop.Prop))
    {
      this->Unsupported.insert(part->GetClassName());
    }
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
  note(property->GetNumberOfTextures() > 0, "textures of the property");
  note(property->GetInterpolation() == VTK_PBR, "physically based shading");
  note(property->GetEdgeVisibility(), "edges of polygons");
  note(BlocksMapper::SafeDownCast(mapper), "visibility and colours of single blocks");
  return true;
}

//------------------------------------------------------------------------------
void ReferenceScene::AddActor(const ScenePart& part, vtkProp* owner)
{
  vtkMapper* mapper = part.Actor->GetMapper();
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0 || !this->CanDraw(part.Actor))
  {
    return;
  }
  mapper->Update();
  this->AddDataObject(mapper->GetInputDataObject(0, 0), part, owner);
}

//------------------------------------------------------------------------------
void ReferenceScene::AddDataObject(vtkDataObject* data, const ScenePart& part, vtkProp* owner)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    this->AddData(mesh, part, owner);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      this->AddDataObject(it->GetCurrentDataObject(), part, owner);
    }
  }
  else if (auto* grid = vtkDataSet::SafeDownCast(data))
  {
    // The surface, as vtkDataSetMapper takes it.
    vtkNew<vtkGeometryFilter> surface;
    surface->SetInputData(grid);
    surface->Update();
    this->AddData(surface->GetOutput(), part, owner);
  }
}

//------------------------------------------------------------------------------
void ReferenceScene::AddData(vtkPolyData* data, const ScenePart& scenePart, vtkProp* owner)
{
  if (data->GetNumberOfVerts() + data->GetNumberOfLines() > 0)
  {
    this->Unsupported.insert("points and lines");
  }
  const ReferenceMesh mesh(data, scenePart.ToWorld);
  if (mesh.GetCorners().empty())
  {
    return;
  }
  vtkActor* actor = scenePart.Actor;
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
  AddTexture(actor, mesh, part);
  if (actor->GetTexture() && !part.Texture)
  {
    this->Unsupported.insert("textures without an image or without coordinates");
  }
  part.IsDrawnOpaque = actor->HasOpaqueGeometry() != 0;
  std::string error;
  part.HasShadowOpacity = ReadShadowOpacity(owner, part.ShadowOpacity, error);
  this->Parts.push_back(std::move(part));
  this->AddTriangles(mesh.GetTriangles(), scenePart.Casts);
}

//------------------------------------------------------------------------------
// Of the last part.
void ReferenceScene::AddTriangles(vtkPolyData* triangles, bool casts)
{
  const int number = static_cast<int>(this->Parts.size()) - 1;
  const ReferencePart& part = this->Parts.back();
  (part.IsDrawnOpaque ? this->Opaque : this->Translucent).Add(triangles, nullptr, number);
  const bool cutOut = part.IsDrawnOpaque && !part.HasShadowOpacity;
  const bool blocks = cutOut && !part.HasHoles;
  this->AllCast = this->AllCast && (!part.IsDrawnOpaque || (casts && blocks));
  if (casts && (cutOut || this->TranslucentShadows))
  {
    (blocks ? this->Casting : this->Dimming).Add(triangles, nullptr, number);
  }
}

//------------------------------------------------------------------------------
glm::dvec3 ReferenceScene::GetTransmittance(
  const OccluderTriangle& triangle, const glm::dvec3& point) const
{
  const ReferencePart& part = this->GetPart(triangle);
  if (part.HasShadowOpacity)
  {
    return 1.0 - part.ShadowOpacity;
  }
  const glm::dvec3 front = -glm::cross(triangle.B - triangle.A, triangle.C - triangle.A);
  const double opacity = ReferenceSurface(part, triangle, point, front).Material.Opacity;
  return glm::dvec3(
    part.IsDrawnOpaque ? (opacity < 0.5 ? 1.0 : 0.0) : 1.0 - std::clamp(opacity, 0.0, 1.0));
}

//------------------------------------------------------------------------------
glm::dvec3 ReferenceScene::GetTransmittance(
  const glm::dvec3& point, const HomogeneousPoint& light, double margin) const
{
  glm::dvec3 result(1.0);
  if (this->Dimming.GetTriangles().empty())
  {
    return result;
  }
  const glm::dvec3 way = glm::dvec3(light) - light.w * point;
  const double length = glm::length(way);
  const glm::dvec3 direction = way / length;
  const double end =
    light.w != 0.0 ? length / std::abs(light.w) - margin : std::numeric_limits<double>::infinity();
  Occluders::Hit hit{ margin, -1 };
  while (this->Dimming.FirstHit(point, direction, hit.T, end, hit))
  {
    result *=
      this->GetTransmittance(this->Dimming.GetTriangles()[hit.Triangle], point + hit.T * direction);
  }
  return result;
}
}
