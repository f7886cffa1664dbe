// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightMapperShader.h"

#include "vtkVersionMacros.h"

#include <cstring>
#include <iterator>
#include <regex>

namespace airlight
{
//------------------------------------------------------------------------------
// All but the last are the same from VTK 9.1 to 9.7.
const std::vector<MapperPattern>& GetMapperPatterns()
{
  using T = MapperText;
  constexpr bool regex = true;
  constexpr bool literal = false;
  constexpr auto sorts = VTK_VERSION_CHECK(9, 2, 0);
  static const std::vector<MapperPattern> patterns = {
    { T::Version, "//VTK::System::Dec", literal, "becomes #version 150; extensions come after it" },
    { T::Main, "void main", literal, "declarations come before it" },

    { T::LightColour, "\\blightColor([0-9]+)\\b", regex, "is multiplied by what arrives" },
    { T::PhongSum, "\\bambientColor \\+ diffuse \\+ specular\\b", regex, "gets scattered light" },
    { T::PhysicalSum, "\\bcolor \\+= Lo;", regex, "gets scattered light" },
    { T::Blending, "//VTK::DepthPeeling::Impl", literal,
      "where passes make of the colour what they blend; the medium comes before that" },
    { T::Discard, "discard", literal,
      "is there once, for fragments without opacity; more may hide opaque fragments" },
    { T::TextureLookup, "texture(", literal, "may make opaque surfaces transparent" },
    { T::FragmentDepth, "gl_FragDepth", literal, "the fragment is not where the triangle is" },
    { T::FragmentPosition, "in vec4 vertexVCVSOutput;", literal, "gives the distance of lights" },
    { T::LightPosition, "uniform vec3 lightPositionVC#;", literal, "gives the distance of lights" },
    { T::Ambient, "uniform float ambientIntensity;", literal, "may be constant" },
    { T::Diffuse, "uniform float diffuseIntensity;", literal, "may be constant" },
    { T::Specular, "uniform float specularIntensity;", literal, "may be constant" },
    { T::Opacity, "uniform float opacityUniform;", literal, "may be constant" },
    { T::LightPositional, "uniform int lightPositional#;", literal, "may be constant" },
    { T::LightConeAngle, "uniform float lightConeAngle#;", literal, "may be constant" },
    { T::LightAttenuation, "uniform vec3 lightAttenuation#;", literal, "may be constant" },

    { T::VolumeDeclarations, "//VTK::Termination::Dec", literal, "comes after VTK's declarations" },
    { T::VolumeStart, "//VTK::DepthPass::Init", literal, "ends what VTK does once a ray" },
    { T::VolumeBlending,
      "g_fragColor = \\(1\\.0f - g_fragColor\\.a\\) \\* (g_srcColor|tmp) \\+ g_fragColor;", regex,
      "blends a sample; the medium comes before that" },
    { T::VolumeSlice, "g_fragColor\\.rgb \\*= opacity;", regex, "the only sample of a slice" },
    { T::VolumeScale,
      "g_fragColor\\.([rgb]) = g_fragColor\\.\\1 \\* in_scale \\+ in_bias \\* g_fragColor\\.a;",
      regex, "one line a channel, for the sum; each sample gets it instead" },
    { T::VolumeLighting, "vec4 finalColor = vec4(0.0);", literal, "begins computeLighting()" },
    { T::VolumeHeadlightColour, "in_light(Diffuse|Specular)Color\\[0\\]", regex,
      "is multiplied by what arrives" },
    { T::VolumeLightColour, "in_light(Diffuse|Specular)Color\\[lightNum\\]", regex,
      "likewise; numbered as in the renderer", 0, sorts },
    { T::VolumeSortedLightColour, "in_light(Diffuse|Specular)Color\\[(posNum|dirNum)\\]", regex,
      "likewise; lights with a position have the first numbers", sorts },
  };
  return patterns;
}

namespace
{
const MapperPattern& GetPattern(MapperText text)
{
  return GetMapperPatterns()[static_cast<size_t>(text)];
}

const std::regex& GetRegex(MapperText text)
{
  static const std::vector<std::regex> all = [] {
    std::vector<std::regex> made;
    for (const MapperPattern& pattern : GetMapperPatterns())
    {
      made.emplace_back(pattern.IsRegex ? pattern.Pattern : "");
    }
    return made;
  }();
  return all[static_cast<size_t>(text)];
}

std::string GetLiteral(MapperText text, size_t light)
{
  std::string literal = GetPattern(text).Pattern;
  const size_t number = literal.find('#');
  return number == std::string::npos ? literal : literal.replace(number, 1, std::to_string(light));
}

struct Match
{
  size_t Start = std::string::npos;
  size_t Length = 0;
};

Match FindFirst(const std::string& shader, MapperText text, size_t light = 0)
{
  if (!GetPattern(text).IsRegex)
  {
    const std::string literal = GetLiteral(text, light);
    return { shader.find(literal), literal.size() };
  }
  std::smatch match;
  return std::regex_search(shader, match, GetRegex(text))
    ? Match{ static_cast<size_t>(match.position()), static_cast<size_t>(match.length()) }
    : Match{};
}
}

//------------------------------------------------------------------------------
bool IsOfLight(MapperText text)
{
  return !GetPattern(text).IsRegex && std::strchr(GetPattern(text).Pattern, '#') != nullptr;
}

//------------------------------------------------------------------------------
int CountText(const std::string& shader, MapperText text, size_t light)
{
  if (GetPattern(text).IsRegex)
  {
    const std::sregex_iterator first(shader.begin(), shader.end(), GetRegex(text));
    return static_cast<int>(std::distance(first, std::sregex_iterator()));
  }
  const std::string literal = GetLiteral(text, light);
  int count = 0;
  for (size_t start = shader.find(literal); start != std::string::npos;
       start = shader.find(literal, start + literal.size()))
  {
    ++count;
  }
  return count;
}

//------------------------------------------------------------------------------
bool HasText(const std::string& shader, MapperText text, size_t light)
{
  return FindFirst(shader, text, light).Start != std::string::npos;
}

//------------------------------------------------------------------------------
bool InsertBefore(std::string& shader, MapperText text, const std::string& added)
{
  const Match match = FindFirst(shader, text);
  if (match.Start == std::string::npos)
  {
    return false;
  }
  shader.insert(match.Start, added);
  return true;
}

//------------------------------------------------------------------------------
bool InsertAfter(std::string& shader, MapperText text, const std::string& added)
{
  const Match match = FindFirst(shader, text);
  if (match.Start == std::string::npos)
  {
    return false;
  }
  shader.insert(match.Start + match.Length, added);
  return true;
}

//------------------------------------------------------------------------------
bool ReplaceText(std::string& shader, MapperText text, const std::string& replacement)
{
  const bool found = HasText(shader, text);
  if (GetPattern(text).IsRegex)
  {
    shader = found ? std::regex_replace(shader, GetRegex(text), replacement) : shader;
    return found;
  }
  const std::string literal = GetLiteral(text, 0);
  for (size_t start = shader.find(literal); start != std::string::npos;
       start = shader.find(literal, start + replacement.size()))
  {
    shader.replace(start, literal.size(), replacement);
  }
  return found;
}

//------------------------------------------------------------------------------
// VTK declares each uniform at most once, and sets those that the linked program has.
bool MakeConstant(std::string& shader, MapperText uniform, const std::string& value, size_t light)
{
  const std::string declaration = GetLiteral(uniform, light);
  const std::string typeAndName = declaration.substr(declaration.find(' '));
  return ReplaceFirst(shader, declaration,
    "const" + typeAndName.substr(0, typeAndName.size() - 1) + " = " + value + ";");
}

//------------------------------------------------------------------------------
bool ReplaceFirst(std::string& shader, const std::string& text, const std::string& replacement)
{
  const size_t position = shader.find(text);
  if (position == std::string::npos)
  {
    return false;
  }
  shader.replace(position, text.size(), replacement);
  return true;
}

//------------------------------------------------------------------------------
std::string RemoveComments(const std::string& shader)
{
  static const std::regex comment("//[^\n]*");
  return std::regex_replace(shader, comment, "");
}

//------------------------------------------------------------------------------
std::optional<SplitShader> SplitAtMain(const std::string& shader)
{
  const size_t start = FindFirst(shader, MapperText::Main).Start;
  const size_t open = shader.find('{', start);
  const size_t close = shader.rfind('}');
  if (start == std::string::npos || open == std::string::npos || close == std::string::npos ||
    close < open)
  {
    return {};
  }
  return SplitShader{ shader.substr(0, start), shader.substr(open + 1, close - open - 1),
    shader.substr(close) };
}
}
