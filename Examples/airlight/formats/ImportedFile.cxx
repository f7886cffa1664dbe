// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/ImportedFile.h"

#include "formats/CheckedOBJ.h"
#include "formats/Files.h"
#include "formats/GLTFNodes.h"
#include "formats/ImportedLights.h"
#include "formats/ModelColours.h"
#include "formats/PolyDataFile.h"
#include "formats/SmoothNormals.h"
#include "formats/UserError.h"
#include "formats/VTKMessages.h"

#include <vtk3DSImporter.h>
#include <vtkActorCollection.h>
#include <vtkBoundingBox.h>
#include <vtkOBJImporter.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVRMLImporter.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <system_error>

namespace airlight
{

namespace
{
template <typename Importer>
vtkSmartPointer<vtkImporter> MakeImporter(const std::string& fileName)
{
  auto importer = vtkSmartPointer<Importer>::New();
  importer->SetFileName(fileName.c_str());
  return importer;
}

// The materials that a Wavefront file names ("mtllib colours.mtl"), where they are beside it.
std::string FindMaterials(const std::string& fileName)
{
  std::ifstream file(fileName);
  std::string line;
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string keyword;
    std::string name;
    if (words >> keyword >> name && keyword == "mtllib")
    {
      const auto materials = std::filesystem::path(fileName).parent_path() / name;
      std::error_code error;
      return std::filesystem::is_regular_file(materials, error) ? materials.string() : "";
    }
  }
  return "";
}

vtkSmartPointer<vtkImporter> MakeOBJImporter(const std::string& fileName)
{
  auto importer = vtkSmartPointer<vtkOBJImporter>::New();
  const std::filesystem::path folder = std::filesystem::path(fileName).parent_path();
  importer->SetFileName(fileName.c_str());
  importer->SetFileNameMTL(FindMaterials(fileName).c_str());
  importer->SetTexturePath(folder.empty() ? "." : folder.string().c_str());
  return importer;
}

using ImporterMaker = std::function<vtkSmartPointer<vtkImporter>(const std::string&)>;

const std::map<std::string, ImporterMaker>& GetImporterMakers()
{
  static const std::map<std::string, ImporterMaker> makers = {
    { "3ds", MakeImporter<vtk3DSImporter> },
    { "glb", MakeImporter<GLTFNodes> },
    { "gltf", MakeImporter<GLTFNodes> },
    { "obj", MakeOBJImporter },
    { "wrl", MakeImporter<vtkVRMLImporter> },
  };
  return makers;
}

// vtkGLTFImporter encodes the linear colours of unlit materials so.
Vector3 UndoUnlit(const double colour[3])
{
  return { std::pow(colour[0], 2.2), std::pow(colour[1], 2.2), std::pow(colour[2], 2.2) };
}

constexpr const char* Albedo = "albedoTex"; // the texture of glTF's base colour, as VTK names it

// A copy without textures; the original keeps that of its colour. VTK 9.1's DeepCopy() does not
// count the copy's references to textures, which are then freed too early: they are away meanwhile.
vtkSmartPointer<vtkProperty> CopyWithoutTextures(vtkProperty* original)
{
  const vtkSmartPointer<vtkTexture> albedo = original->GetTexture(Albedo);
  original->RemoveAllTextures();
  auto copy = vtkSmartPointer<vtkProperty>::New();
  copy->DeepCopy(original);
  if (albedo)
  {
    original->SetTexture(Albedo, albedo);
  }
  return copy;
}

void MakeMatt(vtkActor* actor)
{
  // Actors of one material share its property.
  const vtkSmartPointer<vtkProperty> original = actor->GetProperty();
  const vtkSmartPointer<vtkProperty> property = CopyWithoutTextures(original);
  actor->SetProperty(property);
  const bool linear = property->GetInterpolation() == VTK_PBR; // a glTF material
  if (linear)
  {
    property->SetInterpolationToPhong();
    actor->SetTexture(original->GetTexture(Albedo));
  }
  if (!property->GetLighting())
  {
    property->SetColor(UndoUnlit(property->GetDiffuseColor()).data());
  }
  else if (!linear)
  {
    property->SetDiffuseColor(DecodeSRGB(property->GetDiffuseColor()).data());
  }
  if (actor->GetTexture())
  {
    actor->GetTexture()->UseSRGBColorSpaceOn();
  }
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
}

// VRML's colours of points are indices into a table, which VTK's mapper would stretch over 0 to 1.
void DecodePointColours(vtkActor* actor)
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  vtkPolyData* mesh = mapper->GetInput();
  if (!mapper->GetScalarVisibility() || !mesh->GetPointData()->GetScalars())
  {
    return;
  }
  mapper->UseLookupTableScalarRangeOn();
  vtkUnsignedCharArray* mapped = mapper->MapScalars(1.0);
  if (!mapped || mapped->GetNumberOfTuples() < mesh->GetNumberOfPoints())
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(mapped->GetNumberOfComponents());
  colours->SetNumberOfTuples(mesh->GetNumberOfPoints());
  colours->InsertTuples(0, mesh->GetNumberOfPoints(), 0, mapped); // there may be one too many
  vtkNew<vtkPolyData> coloured;
  coloured->ShallowCopy(mesh);
  coloured->GetPointData()->SetScalars(colours);
  mapper->SetInputData(DecodeColours(coloured));
  mapper->SetColorModeToDefault();
}

vtkPolyData* GetMesh(vtkActor* actor)
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  if (!mapper || !mapper->GetInputAlgorithm())
  {
    return nullptr;
  }
  mapper->GetInputAlgorithm()->Update();
  return mapper->GetInput();
}

std::vector<vtkSmartPointer<vtkActor>> TakeActors(
  vtkRenderer* renderer, const std::string& fileName, bool keepFacets)
{
  std::vector<vtkSmartPointer<vtkActor>> actors;
  vtkActorCollection* imported = renderer->GetActors();
  imported->InitTraversal();
  while (vtkActor* actor = imported->GetNextActor())
  {
    vtkPolyData* mesh = GetMesh(actor);
    if (mesh && (mesh->GetNumberOfPolys() > 0 || mesh->GetNumberOfStrips() > 0))
    {
      CheckPolyData(mesh, fileName);
      MakeMatt(actor);
      if (GetExtension(fileName) == "wrl")
      {
        DecodePointColours(actor);
      }
      else if (!keepFacets)
      {
        vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(AddSmoothNormals(mesh));
      }
      actors.emplace_back(actor);
    }
  }
  return actors;
}
}

//------------------------------------------------------------------------------
bool IsImportedFile(const std::string& fileName)
{
  const std::string extension = GetExtension(fileName);
  return GetImporterMakers().count(extension) > 0 &&
    (extension != "obj" || !FindMaterials(fileName).empty());
}

//------------------------------------------------------------------------------
ImportedScene ImportFile(const std::string& fileName, bool keepFacets)
{
  CheckInputFile(fileName);
  const VTKMessages messages;
  const std::string extension = GetExtension(fileName);
  if (extension == "obj")
  {
    CheckOBJ(fileName);
  }
  vtkSmartPointer<vtkImporter> importer = GetImporterMakers().at(extension)(fileName);
  vtkNew<vtkRenderWindow> window; // importers put their actors into one; it never opens
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  importer->SetRenderWindow(window);
  importer->Read();

  ImportedScene scene;
  scene.Actors = TakeActors(renderer, fileName, keepFacets);
  if (!messages.GetFirstError().empty())
  {
    throw UserError(fileName + ": " + messages.GetFirstError());
  }
  if (scene.Actors.empty())
  {
    const std::string reason = messages.GetFirstWarning();
    throw UserError(fileName + ": has no polygons" + (reason.empty() ? "" : " (" + reason + ")"));
  }
  vtkBoundingBox box;
  for (const auto& actor : scene.Actors)
  {
    box.AddBounds(actor->GetBounds());
  }
  Vector3 center;
  box.GetCenter(center.data());
  scene.Lights = GetImportedLights(importer, renderer, extension, center);
  scene.Camera = GetImportedCamera(importer, renderer, center, box.GetDiagonalLength());
  return scene;
}

}
