// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Contents that are drawn as surfaces, lines and points, opaque and translucent.
 */

#ifndef AirlightTestContentSurfaces_h
#define AirlightTestContentSurfaces_h

#include "AirlightTestContent.h"

#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLineSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"

#include <utility>

namespace airlight_test
{
// Shadings and representations of one sphere each.
void AddShadings(Scene& scene);

void AddVertices(Scene& scene);

void AddLines(Scene& scene);

void AddPoints(Scene& scene, bool spheres);

void AddBackfaces(Scene& scene);

void AddUnlit(Scene& scene);

void AddPhysical(Scene& scene, bool environment);

void AddTexture(Scene& scene, int components);

// By point, by cell, and by point through a texture.
void AddScalars(Scene& scene);

// Translucent surfaces that cross each other, before and behind an opaque one.
void AddTranslucent(Scene& scene);

// Blocks of their own colour and opacity, one of them hidden.
void AddComposite(Scene& scene);

// Glyphs turned and scaled by arrays.
vtkSmartPointer<vtkGlyph3DMapper> MakeGlyphs();

void AddGlyphs(Scene& scene, double opacity);

void AddGaussians(Scene& scene, bool emissive, double opacity);
}

#endif
