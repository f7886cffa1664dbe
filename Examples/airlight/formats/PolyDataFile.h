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

/**
 * The polygons of a mesh file; of a volume mesh, its outer surface. Throws UserError with file and
 * reason if the file is damaged. Guard the first reading of a file with TryInChildProcess().
 */
vtkSmartPointer<vtkPolyData> ReadPolyDataFile(const std::string& fileName);

/**
 * Throws UserError unless the mesh has polygons, all of them of points that exist, and finite
 * coordinates.
 */
void CheckPolyData(vtkPolyData* mesh, const std::string& fileName);

}

#endif
