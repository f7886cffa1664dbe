// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The declarations that the module adds to VTK's shaders before main().
 */

#ifndef AirlightSurfaceDeclarations_h
#define AirlightSurfaceDeclarations_h

#include "MapperShaders/AirlightSurfaceShader.h"

#include <string>

namespace airlight
{
// Whether translucent fragments have records (AirlightTranslucentFragments.h).
bool HasRecords(const SurfaceShaderOptions& options);

std::string GetSurfaceDeclarations(const SurfaceShaderOptions& options);
std::string GetVertexDeclarations(const SurfaceShaderOptions& options);

// `volume`: what comes last.
std::string GetVolumeDeclarations(const SurfaceShaderOptions& options, const std::string& volume);

// Requests what the declarations need, and what they use if it is available.
void AddExtensions(std::string& shader, const SurfaceShaderOptions& options);
}

#endif
