// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolyDataFile_h
#define PolyDataFile_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace airlight
{

/**
 * Whether ReadPolyDataFile() reads files of this name: ply, stl, obj, vtp, vtk and vtu.
 */
bool IsPolyDataFile(const std::string& fileName);

enum class Content
{
  Surface, ///< polygons, or there is an error
  Any      ///< polygons, lines or points
};

/**
 * The cells of a mesh file; of a volume mesh, its outer surface. Throws UserError with file and
 * reason if the file is damaged. Guard the first reading of a file with TryInChildProcess().
 */
vtkSmartPointer<vtkPolyData> ReadPolyDataFile(
  const std::string& fileName, Content content = Content::Surface);

/**
 * Throws UserError unless the mesh has the content, all cells are of points that exist, and
 * coordinates are finite.
 */
void CheckPolyData(
  vtkPolyData* mesh, const std::string& fileName, Content content = Content::Surface);

}

#endif
