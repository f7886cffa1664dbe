// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shaders' common texts, and the uniforms of the structures in them. A member of a structure is
 * listed once, by its visitor (Integration/AirlightMembers.h).
 */

#ifndef AirlightShaderLibrary_h
#define AirlightShaderLibrary_h

#include "Integration/AirlightMembers.h"
#include "vtkAirlightModule.h" // for export macro

#include <string>

class vtkShaderProgram;

namespace airlight
{
// The texts of the mathematics in the order in which they need one another, compiled for as many
// media, and where there is one for as many poles, as there are. `lightKind` is the kind of light
// that the text is to handle, below 0 for all; `photometry` tells whether lights may shine by
// tables. Declares the uniform `airlightMedia`; after a definition of AIRLIGHT_OWN_MEDIA, the
// uniform `givenMedia` and a variable `airlightMedia`, which main() is to fill.
VTKAIRLIGHT_EXPORT std::string GetScatteringSource(
  const f64::AirlightMedia& media, int lightKind, bool photometry);

// What airlightScatteredIrradiance() needs beyond them.
std::string GetScatteredIrradianceSource();

// In what the samples of images are on the graphics card: whole numbers of 8 or 16 bits where those
// of all images of a frame are, else single precision.
constexpr int FloatBits = 32;
VTKAIRLIGHT_EXPORT int GetSampleBits(const f64::AirlightMedia& media);

// What shaders have of a medium's image: AirlightGrid.glsl.
struct GridUniforms
{
  glm::dmat3 axes;
  glm::dvec3 start;
  glm::dvec3 last;
  int first;
};

VTKAIRLIGHT_EXPORT GridUniforms GetGridUniforms(const f64::AirlightMedium& medium);

template <typename Visitor>
void VisitGrid(Visitor&& visit, const GridUniforms& grid)
{
  visit(Member{ "axes" }, grid.axes);
  visit(Member{ "start" }, grid.start);
  visit(Member{ "last" }, grid.last);
  visit(Member{ "first" }, grid.first);
}

// VisitMedia(), the skies and, in place of what C++ alone has of images, what shaders have of them.
template <typename Visitor>
void VisitMediaUniforms(Visitor&& visit, const f64::AirlightMedia& media)
{
  VisitMedia(visit, media);
  for (int i = 0; i < media.count + media.volumes; ++i)
  {
    if (HasSky(media))
    {
      VisitSky(VisitIn("item[" + std::to_string(i) + "].sky", visit), media.item[i].sky);
    }
    if (media.item[i].density == AIRLIGHT_DENSITY_GRID)
    {
      const std::string item = "item[" + std::to_string(i) + "]";
      VisitGrid(VisitIn(item + ".grid", visit), GetGridUniforms(media.item[i]));
      VisitIn(item, visit)(Member{ "albedoFirst" }, media.item[i].albedoFirst);
      VisitIn(item, visit)(Member{ "glowFirst" }, media.item[i].glowFirst);
    }
  }
}

// Sets a uniform AirlightMedia, AirlightPhotometry or AirlightLight of this name; with media,
// `airlightMultiple`, too, unless the program does not use it.
void SetMediaUniforms(vtkShaderProgram* program, const std::string& name,
  const f64::AirlightMedia& media, bool multiple = true);
void SetPhotometryUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightPhotometry& photometry);
void SetLightUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightLight& light);
}

#endif
