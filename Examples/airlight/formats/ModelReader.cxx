// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/ModelReader.h"

#include "formats/ChildProcess.h"
#include "formats/Files.h"
#include "formats/ImportedFile.h"
#include "formats/ModelColours.h"
#include "formats/PolyDataFile.h"
#include "formats/SolidMesh.h"
#include "formats/UserError.h"
#include "scene/LambertActor.h"

#include <vtkAppendPolyData.h>
#include <vtkMatrixToLinearTransform.h>
#include <vtkPolyDataMapper.h>
#include <vtkTransformPolyDataFilter.h>

#include <utility>

namespace airlight
{

namespace
{
constexpr double DefaultAlbedo = 0.7;
}

//------------------------------------------------------------------------------
std::string CheckModelFile(const std::string& fileName)
{
  CheckInputFile(fileName);
  if (!IsImportedFile(fileName) && !IsPolyDataFile(fileName))
  {
    throw UserError(fileName +
      ": unknown kind of model; known: gltf, glb, obj, ply, stl, vtp, vtk, vtu, wrl, 3ds");
  }
  const auto tryToRead = [&fileName](bool materials) {
    TryInChildProcess(fileName, [&] { ReadModel(fileName, false, materials); });
  };
  try
  {
    tryToRead(true);
    return "";
  }
  catch (const UserError& error)
  {
    if (!IsImportedFile(fileName) || !IsPolyDataFile(fileName))
    {
      throw;
    }
    tryToRead(false);
    return error.what();
  }
}

//------------------------------------------------------------------------------
Model ReadModel(const std::string& fileName, bool keepFacets, bool materials)
{
  Model model;
  if (IsImportedFile(fileName) && (materials || !IsPolyDataFile(fileName)))
  {
    ImportedScene imported = ImportFile(fileName, keepFacets);
    for (const auto& actor : imported.Actors)
    {
      model.Surfaces.push_back({ fileName, actor });
    }
    model.Lights = std::move(imported.Lights);
    model.Camera = imported.Camera;
    return model;
  }
  const vtkSmartPointer<vtkPolyData> mesh =
    MakeSolid(DecodeColours(ColourByScalars(ReadPolyDataFile(fileName, Content::Any))));
  vtkSmartPointer<vtkActor> actor =
    MakeLambertActor(mesh, { DefaultAlbedo, DefaultAlbedo, DefaultAlbedo },
      keepFacets ? Shading::Smooth : Shading::Curved);
  actor->GetMapper()->SetScalarVisibility(HasColours(mesh));
  model.Surfaces.push_back({ fileName, actor });
  return model;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& fileName)
{
  if (IsPolyDataFile(fileName))
  {
    return ReadPolyDataFile(fileName);
  }
  vtkNew<vtkAppendPolyData> append;
  for (const auto& actor : ImportFile(fileName, true).Actors)
  {
    vtkNew<vtkMatrixToLinearTransform> placement;
    placement->SetInput(actor->GetMatrix());
    vtkNew<vtkTransformPolyDataFilter> placed;
    placed->SetTransform(placement);
    placed->SetInputData(vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput());
    placed->Update();
    append->AddInputData(placed->GetOutput());
  }
  append->Update();
  return append->GetOutput();
}

}
