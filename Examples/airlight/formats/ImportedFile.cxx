// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/ImportedFile.h"

#include "formats/Files.h"
#include "formats/ModelColours.h"
#include "formats/PolyDataFile.h"
#include "formats/UserError.h"
#include "formats/VTKMessages.h"

#include <vtk3DSImporter.h>
#include <vtkActorCollection.h>
#include <vtkGLTFImporter.h>
#include <vtkOBJImporter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkTexture.h>
#include <vtkVRMLImporter.h>

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
    { "glb", MakeImporter<vtkGLTFImporter> },
    { "gltf", MakeImporter<vtkGLTFImporter> },
    { "obj", MakeOBJImporter },
    { "wrl", MakeImporter<vtkVRMLImporter> },
  };
  return makers;
}

void MakeMatt(vtkActor* actor)
{
  // Actors of one material share its property.
  vtkNew<vtkProperty> property;
  property->DeepCopy(actor->GetProperty());
  actor->SetProperty(property);
  if (property->GetInterpolation() == VTK_PBR) // a glTF material, in linear colours
  {
    property->SetInterpolationToPhong();
    actor->SetTexture(property->GetTexture("albedoTex"));
    property->RemoveAllTextures();
  }
  else
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
}

//------------------------------------------------------------------------------
bool IsImportedFile(const std::string& fileName)
{
  const std::string extension = GetExtension(fileName);
  return GetImporterMakers().count(extension) > 0 &&
    (extension != "obj" || !FindMaterials(fileName).empty());
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkActor>> ImportFile(const std::string& fileName)
{
  CheckInputFile(fileName);
  const VTKMessages messages;
  vtkSmartPointer<vtkImporter> importer = GetImporterMakers().at(GetExtension(fileName))(fileName);
  vtkNew<vtkRenderWindow> window; // importers put their actors into one; it never opens
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  importer->SetRenderWindow(window);
  importer->Read();

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
      actors.emplace_back(actor);
    }
  }
  if (!messages.GetFirstError().empty())
  {
    throw UserError(fileName + ": " + messages.GetFirstError());
  }
  if (actors.empty())
  {
    const std::string reason = messages.GetFirstWarning();
    throw UserError(fileName + ": has no polygons" + (reason.empty() ? "" : " (" + reason + ")"));
  }
  return actors;
}

}
