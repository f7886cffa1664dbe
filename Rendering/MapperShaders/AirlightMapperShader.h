// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The text of VTK's shaders that the module searches for, and how it is changed.
 *
 * VTK promises none of it. Each pattern is in the table of the .cxx file, with its use and the
 * versions of VTK that have it; TestMapperShader checks each against the shaders of the installed
 * VTK. Names that only the added GLSL uses are not there: without them a shader does not compile,
 * which is reported.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightMapperShader_h
#define AirlightMapperShader_h

#include "vtkAirlightModule.h" // for export macro

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace airlight
{
enum class MapperText
{
  // Of all shaders.
  Version,
  Main,
  // Of fragment shaders of surfaces.
  LightColour,
  PhongSum,
  PhysicalSum,
  Blending,
  Discard,
  TextureLookup,
  FragmentDepth,
  FragmentPosition,
  LightPosition,
  Ambient,
  Diffuse,
  Specular,
  Opacity,
  LightPositional,
  LightConeAngle,
  LightAttenuation,
  // Of fragment shaders of volumes.
  VolumeDeclarations,
  VolumeStart,
  VolumeBlending,
  VolumeSlice,
  VolumeScale,
  VolumeLighting,
  VolumeHeadlightColour,
  VolumeLightColour,
  VolumeSortedLightColour
};

struct MapperPattern
{
  MapperText Text;
  const char* Pattern; // # stands for the number of a light
  bool IsRegex;        // with ECMAScript's grammar; else the text itself
  const char* Use;
  // The first version of VTK that has it, and the first later one that does not, as
  // VTK_VERSION_CHECK() gives them. 0: all versions from 9.1 on.
  unsigned long long Since = 0;
  unsigned long long Until = 0;
};

// One for each MapperText, in its order.
VTKAIRLIGHT_EXPORT const std::vector<MapperPattern>& GetMapperPatterns();

// Whether there is one for each light.
VTKAIRLIGHT_EXPORT bool IsOfLight(MapperText text);

VTKAIRLIGHT_EXPORT int CountText(const std::string& shader, MapperText text, std::size_t light = 0);
VTKAIRLIGHT_EXPORT bool HasText(const std::string& shader, MapperText text, std::size_t light = 0);

///@{
/**
 * Where the text is first. False if it is not there.
 */
VTKAIRLIGHT_EXPORT bool InsertBefore(
  std::string& shader, MapperText text, const std::string& added);
VTKAIRLIGHT_EXPORT bool InsertAfter(std::string& shader, MapperText text, const std::string& added);
///@}

// Wherever the text is. In the replacement of a regex, $& is what is replaced, $1 its first group.
// False if the text is not there.
VTKAIRLIGHT_EXPORT bool ReplaceText(
  std::string& shader, MapperText text, const std::string& replacement);

// Turns the declaration of a uniform into that of a constant. False if it is not there.
VTKAIRLIGHT_EXPORT bool MakeConstant(
  std::string& shader, MapperText uniform, const std::string& value, std::size_t light = 0);

// Replaces a text of one's own, such as a mark, where it is first. False if it is not there.
VTKAIRLIGHT_EXPORT bool ReplaceFirst(
  std::string& shader, const std::string& text, const std::string& replacement);

VTKAIRLIGHT_EXPORT std::string RemoveComments(const std::string& shader);

// A shader without the line and the opening brace of main().
struct SplitShader
{
  std::string Before;
  std::string Body;
  std::string After; // from the closing brace on
};
VTKAIRLIGHT_EXPORT std::optional<SplitShader> SplitAtMain(const std::string& shader);
}

#endif
