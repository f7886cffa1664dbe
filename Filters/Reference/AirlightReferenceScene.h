// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightReference sees of a renderer's props: triangles in the world, with what VTK's
 * mappers shade them by.
 */

#ifndef AirlightReferenceScene_h
#define AirlightReferenceScene_h

#include "Occlusion/AirlightOccluders.h"
#include "Reference/AirlightReferenceVolumes.h"
#include "Scene/AirlightTextureColours.h"

#include <glm/glm.hpp>

#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkActor;
class vtkDataObject;
class vtkPolyData;
class vtkProp;
class vtkProperty;
class vtkRenderer;

namespace airlight
{
struct ScenePart;
struct SceneProp;

// A property as VTK's Phong shading takes it, colours times their coefficients.
struct ReferenceMaterial
{
  ReferenceMaterial() = default;
  explicit ReferenceMaterial(vtkProperty* property);

  glm::dvec3 Ambient{ 0.0 };
  glm::dvec3 Diffuse{ 0.0 };
  glm::dvec3 Specular{ 0.0 };
  double SpecularPower = 1.0;
  double Opacity = 1.0;
};

// One mesh in its place.
struct ReferencePart
{
  ReferenceMaterial Front;
  ReferenceMaterial Back; // differs with a backface property
  // What the colours of scalars are multiplied by where there are any.
  double AmbientFactor = 0.0;
  double DiffuseFactor = 0.0;
  bool Lighting = true;
  bool HidesFront = false;
  bool HidesBack = false;
  std::vector<glm::dvec4> ClippingPlanes; // of the world; what is below 0 is not drawn
  std::vector<glm::dvec3> Normals;        // three for each triangle, or none
  std::vector<glm::dvec4> Colours;        // three for each triangle, or none: RGBA of scalars
  // By which colours are multiplied, with coordinates for three corners a triangle; else null.
  std::shared_ptr<const TextureColours> Texture;
  std::vector<glm::dvec2> TextureCoordinates;
  bool HasHoles = false; // the texture has alpha
  bool IsDrawnOpaque = true;
  bool HasShadowOpacity = false; // by a key
  glm::dvec3 ShadowOpacity{ 1.0 };
};

struct ReferenceHit
{
  double T;
  const OccluderTriangle* Triangle;
};

class ReferenceScene
{
public:
  // Brings the props' pipelines up to date. Translucent casters cast, and volumes dim lights, on
  // request.
  ReferenceScene(vtkRenderer* renderer, bool translucentShadows, bool volumeShadows);

  const ReferencePart& GetPart(const OccluderTriangle& triangle) const
  {
    return this->Parts[triangle.Caster];
  }

  const Occluders& GetOpaque() const { return this->Opaque; }
  const Occluders& GetTranslucent() const { return this->Translucent; }
  // The opaque triangles that cast shadows, and those that let a part of the light through.
  const Occluders& GetCasters() const { return this->AllCast ? this->Opaque : this->Casting; }
  const Occluders& GetTranslucentCasters() const { return this->Dimming; }

  // The share of light that one of the latter lets through at a point of it. Where alpha varies, it
  // is looked up there; what is drawn as opaque is cut at an opacity of 1/2, as by the pass.
  glm::dvec3 GetTransmittance(const OccluderTriangle& triangle, const glm::dvec3& point) const;

  // The share of light that translucent casters let through to a point from a light, which they
  // are farther from than `margin`.
  glm::dvec3 GetTransmittance(
    const glm::dvec3& point, const HomogeneousPoint& light, double margin) const;

  // Those that cast shadows.
  const ReferenceVolumes& GetVolumes() const { return this->Volumes; }

  // What there is that is left out or drawn otherwise than VTK does; empty if nothing.
  std::string GetUnsupported() const;

  // Whether the ray does not see the triangle at t: culled or clipped away. `origin` in the world.
  bool IsHidden(const OccluderTriangle& triangle, const glm::dvec3& origin,
    const glm::dvec3& direction, double t) const;

  // The first surface that is seen with after < T < before; `origin` in the world.
  bool FindFirst(const Occluders& surfaces, const glm::dvec3& origin, const glm::dvec3& direction,
    double after, double before, ReferenceHit& hit) const;

private:
  void AddProp(const SceneProp& prop);
  void AddActor(const ScenePart& part, vtkProp* owner);
  bool CanDraw(vtkActor* actor);
  void AddDataObject(vtkDataObject* data, const ScenePart& part, vtkProp* owner);
  void AddData(vtkPolyData* data, const ScenePart& part, vtkProp* owner);
  void AddTriangles(vtkPolyData* triangles, bool casts);

  std::vector<ReferencePart> Parts;
  Occluders Opaque;
  Occluders Casting;
  Occluders Translucent;
  Occluders Dimming;
  ReferenceVolumes Volumes;
  bool AllCast = true;
  bool TranslucentShadows;
  std::set<std::string> Unsupported;
};
}

#endif
