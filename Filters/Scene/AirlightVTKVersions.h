// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What differs between the versions of VTK, from 9.1 to 9.7. No other file of the library asks for
 * VTK's version, except AirlightMapperShader, whose table holds the texts of VTK's shaders, and
 * vtkAirlightHeadlessWindow, which loads OpenGL by GLEW where there is no glad.
 */

#ifndef AirlightVTKVersions_h
#define AirlightVTKVersions_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

// The mapper that draws blocks, each with a visibility and an opacity of its own. Until 9.2 the
// plain class makes a mapper for each block; from 9.3 on both are one, and from 9.5 on one is gone.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
#else
#include "vtkCompositePolyDataMapper2.h"
#endif

namespace airlight
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
using BlocksMapper = vtkCompositePolyDataMapper;
inline constexpr const char* BlocksMapperName = "vtkCompositePolyDataMapper";
#else
using BlocksMapper = vtkCompositePolyDataMapper2;
inline constexpr const char* BlocksMapperName = "vtkCompositePolyDataMapper2";
#endif

// Whether a filter was requested to stop. From 9.3 on it also stops if one upstream was.
inline bool IsAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

// The least cosine by which VTK's mappers shade what is turned away from a headlight, since 9.2,
// and the least of a specular reflection, since 9.3.
inline constexpr double LeastToHeadlight =
  VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0) ? 1e-6 : 0.0;
inline constexpr double LeastReflection =
  VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0) ? 1e-5 : 0.0;
}

#endif
