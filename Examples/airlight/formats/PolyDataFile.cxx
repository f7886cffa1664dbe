// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/PolyDataFile.h"

#include "formats/CheckedOBJ.h"
#include "formats/CheckedPLY.h"
#include "formats/Files.h"
#include "formats/UserError.h"
#include "formats/VTKMessages.h"

#include <vtkCellArray.h>
#include <vtkDataArrayRange.h>
#include <vtkDataSetReader.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPoints.h>
#include <vtkSTLReader.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>

namespace airlight
{

namespace
{
template <typename Reader>
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& fileName)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

using ReaderMaker = std::function<vtkSmartPointer<vtkAlgorithm>(const std::string&)>;

const std::map<std::string, ReaderMaker>& GetReaderMakers()
{
  static const std::map<std::string, ReaderMaker> makers = {
    { "obj", MakeReader<vtkOBJReader> },
    { "ply", MakeReader<vtkPLYReader> },
    { "stl", MakeReader<vtkSTLReader> },
    { "vtk", MakeReader<vtkDataSetReader> },
    { "vtp", MakeReader<vtkXMLPolyDataReader> },
    { "vtu", MakeReader<vtkXMLUnstructuredGridReader> },
  };
  return makers;
}

// vtkSTLReader takes whatever triangles it finds: a binary file that ends early goes unnoticed.
void CheckBinarySTL(vtkAlgorithm* reader, const std::string& fileName)
{
  vtkSTLReader* stl = vtkSTLReader::SafeDownCast(reader);
  if (!stl || !stl->GetBinaryHeader())
  {
    return;
  }
  const std::string bytes = ReadTextFile(fileName);
  std::uint32_t triangles = 0;
  if (bytes.size() >= 84)
  {
    std::memcpy(&triangles, bytes.data() + 80, sizeof(triangles)); // little endian, as the file
  }
  if (bytes.size() < 84 + 50 * static_cast<std::uint64_t>(triangles))
  {
    throw UserError(fileName + ": the file ends before the last of its " +
      std::to_string(triangles) + " triangles");
  }
}

bool HasValidIds(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  const auto ids = vtk::DataArrayValueRange(cells->GetConnectivityArray());
  return std::all_of(ids.begin(), ids.end(),
    [numberOfPoints](double id) { return id >= 0 && id < static_cast<double>(numberOfPoints); });
}
}

//------------------------------------------------------------------------------
bool IsPolyDataFile(const std::string& fileName)
{
  return GetReaderMakers().count(GetExtension(fileName)) > 0;
}

//------------------------------------------------------------------------------
void CheckPolyData(vtkPolyData* mesh, const std::string& fileName, Content content)
{
  const bool surface = mesh && (mesh->GetNumberOfPolys() > 0 || mesh->GetNumberOfStrips() > 0);
  if (content == Content::Surface && !surface)
  {
    throw UserError(fileName + ": has no polygons");
  }
  if (!mesh || !mesh->GetPoints() || mesh->GetNumberOfPoints() == 0)
  {
    throw UserError(fileName + ": has no polygons, lines or points");
  }
  for (vtkCellArray* cells :
    { mesh->GetPolys(), mesh->GetStrips(), mesh->GetLines(), mesh->GetVerts() })
  {
    if (!HasValidIds(cells, mesh->GetNumberOfPoints()))
    {
      throw UserError(fileName + ": has cells of points that it does not hold");
    }
  }
  const auto coordinates = vtk::DataArrayValueRange(mesh->GetPoints()->GetData());
  if (!std::all_of(
        coordinates.begin(), coordinates.end(), [](double x) { return std::isfinite(x); }))
  {
    throw UserError(fileName + ": has points that are not finite");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadPolyDataFile(const std::string& fileName, Content content)
{
  CheckInputFile(fileName);
  if (GetExtension(fileName) == "ply")
  {
    CheckPLY(fileName);
  }
  else if (GetExtension(fileName) == "obj")
  {
    CheckOBJ(fileName);
  }
  const VTKMessages messages;
  vtkSmartPointer<vtkAlgorithm> reader = GetReaderMakers().at(GetExtension(fileName))(fileName);
  reader->Update();
  auto* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  // Truncation is a warning to some readers and an error to others.
  const std::string error = messages.GetFirstError();
  const std::string complaint = error.empty() ? messages.GetFirstWarning() : error;
  if (!complaint.empty())
  {
    throw UserError(fileName + ": " + complaint);
  }
  if (!data)
  {
    throw UserError(fileName + ": cannot be read");
  }
  CheckBinarySTL(reader, fileName);
  vtkSmartPointer<vtkPolyData> mesh = vtkPolyData::SafeDownCast(data);
  if (!mesh)
  {
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputData(data);
    surface->Update();
    mesh = surface->GetOutput();
  }
  CheckPolyData(mesh, fileName, content);
  return mesh;
}

}
