// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What casts shadows in a renderer, inside the view or not.
 */

#ifndef AirlightCasters_h
#define AirlightCasters_h

#include "Casters/AirlightCasterOpticalThickness.h"
#include "Casters/AirlightNonPolygonalCaster.h"
#include "Casters/AirlightOpacityPieces.h"
#include "Casters/AirlightPlanarFaces.h"
#include "Scene/AirlightGeometryTimes.h"
#include "Silhouette/AirlightCasterMesh.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <glm/glm.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkDataSet;
class vtkGeometryFilter;
class vtkGlyph3DMapper;
class vtkMatrix4x4;
class vtkPolyData;
class vtkProp;

namespace airlight
{
class SceneProps;
struct ScenePart;
struct SceneProp;

// A mesh in its place.
struct Caster
{
  std::shared_ptr<const CasterMesh> Mesh;
  glm::dmat4 ToWorld;
  bool HidesFaces =
    false; // culled, clipped or translucent: rays can go through parts of it that cast
  CasterOpticalThickness OpticalThickness; // what each of its triangles does to light
  // What of it hides what lies behind, where the prop draws its triangles as they are; else null.
  std::shared_ptr<const std::vector<PlanarFace>> Faces;
  const vtkProp* Owner = nullptr; // in the renderer; to be compared only

  // A point of the mesh in the world.
  glm::dvec3 GetPoint(int point) const
  {
    return glm::dvec3(this->ToWorld * glm::dvec4(this->Mesh->Points[point], 1.0));
  }

  // Opaque ones block all light.
  bool IsOpaque() const { return this->OpticalThickness.Blocks == glm::ivec3(1); }

  bool HasSameShape(const Caster& other) const
  {
    return this->Mesh == other.Mesh && this->ToWorld == other.ToWorld &&
      this->HidesFaces == other.HidesFaces;
  }

  bool operator==(const Caster& other) const
  {
    return this->HasSameShape(other) && this->OpticalThickness == other.OpticalThickness;
  }
};

// Meshes are prepared once per change of their points or polygons and kept while anything in the
// renderer shows them.
class CasterCache
{
public:
  // All visible polygonal actors, glyphs, parts of assemblies and blocks of composite data sets,
  // but for those whose property keys say otherwise; translucent ones if requested.
  const std::vector<Caster>& Collect(const SceneProps& props, bool translucent);

  // Whether the last Collect() met casters that let light through, and what is wrong with the keys
  // of one of the props.
  bool MetTranslucent() const { return this->Translucent; }
  const std::string& GetError() const { return this->Error; }

  // What the last Collect() returned.
  const std::vector<Caster>& GetCasters() const { return this->Casters; }

  // Those of the last Collect().
  const std::vector<NonPolygonalCaster>& GetNonPolygonal() const { return this->NonPolygonal; }

  // A vtkLODProp3D of the last Collect() that shows something else than an actor; empty if there is
  // none.
  const std::string& GetUnsupportedProp() const { return this->UnsupportedProp; }

  void Clear();

private:
  struct Entry
  {
    vtkWeakPointer<vtkPolyData> Data;
    GeometryTimes Times{};
    std::shared_ptr<const CasterMesh> Mesh;
    std::shared_ptr<const std::vector<PlanarFace>> Faces; // null until asked for
    bool Used = false;

    // Null if there are none.
    std::shared_ptr<const std::vector<PlanarFace>> GetFaces();
  };

  // The surface of a grid, extracted as vtkDataSetMapper does.
  struct Surface
  {
    vtkSmartPointer<vtkGeometryFilter> Filter;
    bool Used = false;
  };

  // How an actor's triangles stand in the light and in the way of rays.
  struct Appearance
  {
    glm::dvec3 Opacity{ 1.0 };
    bool HidesFaces = false;
    bool Culled = false;  // or clipped
    bool FromKey = false; // the opacity, which then is that of all blocks
    const vtkProp* Owner = nullptr;
    bool ShowsAll = false; // the mapper's input and nothing else
  };

  void AddProp(const SceneProp& prop);
  void AddOther(const ScenePart& part, vtkProp* owner);
  void AddActor(const ScenePart& part, vtkProp* owner);
  Appearance GetAppearance(vtkActor* actor, vtkProp* owner);
  void AddGlyphs(vtkGlyph3DMapper* mapper, vtkMatrix4x4* matrix, const Appearance& appearance);
  void AddMesh(
    vtkActor* actor, vtkPolyData* data, vtkMatrix4x4* matrix, const Appearance& appearance);
  void AddData(vtkPolyData* data, vtkMatrix4x4* matrix, const Appearance& appearance);

  vtkPolyData* GetSurface(vtkDataSet* grid);

  std::map<vtkPolyData*, Entry> Meshes;
  OpacityPieces Pieces;
  std::map<vtkDataSet*, Surface> Surfaces;
  std::vector<Caster> Casters;
  std::vector<NonPolygonalCaster> NonPolygonal;
  std::string UnsupportedProp;
  bool Translucent = false;
  bool TakesTranslucent = false;
  std::string Error;
};
}

#endif
