// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which props may cast shadows, and of which mappers the polygons are known.
 */

#ifndef AirlightCasterKinds_h
#define AirlightCasterKinds_h

class vtkDataObject;
class vtkMapper;
class vtkProp;

namespace airlight
{
// Visible, and its keys do not say otherwise.
bool MayCast(vtkProp* prop);

// Whether what the mapper draws can be made of polygons.
bool HasPolygons(vtkMapper* mapper);

// Whether a mapper draws all cells of this input. Of blocks, some may look otherwise than the
// actor.
bool ShowsAll(vtkDataObject* input);
}

#endif
