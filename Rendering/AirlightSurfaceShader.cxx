// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightSurfaceShader.h"

#include "AirlightFragment.h"
#include "AirlightQuad.h"
#include "AirlightSurface.h"
#include "AirlightSurfaceGlow.h"
#include "AirlightSurfaceMedium.h"
#include "AirlightView.h"
#include "AirlightViewShader.h"

#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <regex>

namespace airlight
{
namespace
{
// The prelude's words must not reach the mapper's own text.
const char* Undefine = "#undef real\n#undef real2\n#undef real3\n#undef real4\n#undef bool3\n";

std::string Declarations(const SurfaceText& text)
{
  const std::string glow = text.GlowLightCount > 0 ? "#define AIRLIGHT_GLOW_LIGHTS " +
      std::to_string(text.GlowLightCount) + "\n" + AirlightSurfaceGlow
                                                   : "";
  return text.Mathematics + "#define AIRLIGHT_LAMPS " + std::to_string(text.LampCount) +
    "\n#define AIRLIGHT_BITS " + std::to_string(BitsPerChannel) + "\n" + AirlightViewShader +
    AirlightFragment + AirlightSurface + glow + (text.Translucent ? AirlightSurfaceMedium : "") +
    Undefine;
}

// Adds scattered light where VTK's templates add up their lighting: as a light of that colour that
// meets the surface head on, in the diffuse part. Unlit shaders have neither place.
std::string AddGlow(const std::string& body)
{
  const std::string glow = "airlightGlowColour(normalVCVSOutput)";
  static const std::regex phong("\\bambientColor \\+ diffuse \\+ specular\\b");
  static const std::regex physical("\\bcolor \\+= Lo;");
  return std::regex_replace(std::regex_replace(body, phong,
                              "ambientColor + diffuse + diffuseColor * " + glow + " + specular"),
    physical, "color += Lo + (1.0 - metallic) * DiffuseLambert(albedo) * " + glow + ";");
}

// Puts the fragment behind the medium, before other passes make of it what they blend.
std::string AddMedium(const std::string& body)
{
  const std::string marker = "//VTK::DepthPeeling::Impl";
  const size_t place = body.find(marker);
  return place == std::string::npos ? body
                                    : body.substr(0, place) +
      "\n  gl_FragData[0].rgb = airlightThrough(gl_FragData[0].rgb);\n  " + body.substr(place);
}

// Whether nothing but the template's own test of the final opacity can discard a fragment. Then a
// fragment of an opaque surface is as good as drawn before it is shaded.
bool MayLeaveEarly(const std::string& commented)
{
  static const std::regex comment("//[^\n]*");
  const std::string body = std::regex_replace(commented, comment, "");
  const size_t first = body.find("discard");
  return (first == std::string::npos || body.find("discard", first + 1) == std::string::npos) &&
    body.find("texture(") == std::string::npos && body.find("gl_FragDepth") == std::string::npos;
}

void SetGlowUniforms(vtkShaderProgram* program, const SurfaceUniforms& values)
{
  int count = 0;
  for (const Lamp& lamp : *values.Lamps)
  {
    if (lamp.Glows() && count < MaximumGlowLights)
    {
      SetLightUniforms(program, "airlightGlowLights[" + std::to_string(count) + "]", lamp.Values);
      ++count;
    }
  }
  program->SetUniformi("airlightGlowCount", count);
  glm::mat3 normals = values.Rays->GetNormalMatrix();
  program->SetUniformMatrix3x3("airlightNormalToWorld", &normals[0].x);
}
}

//------------------------------------------------------------------------------
void InjectSurfaceShader(std::string& fragmentShader, const SurfaceText& text)
{
  const size_t mainStart = fragmentShader.find("void main");
  const size_t bodyStart = fragmentShader.find('{', mainStart);
  const size_t bodyEnd = fragmentShader.rfind('}');
  if (mainStart == std::string::npos || bodyStart == std::string::npos || bodyEnd < bodyStart ||
    fragmentShader.find("airlightStage") != std::string::npos)
  {
    return;
  }
  const std::string body = fragmentShader.substr(bodyStart + 1, bodyEnd - bodyStart - 1);

  // VTK names the lights lightColor0, lightColor1, ...
  static const std::regex lightColor("\\blightColor([0-9]+)\\b");
  const bool anyLight = std::regex_search(body, lightColor);
  std::string lit = std::regex_replace(body, lightColor, "(lightColor$1 * airlightArrived[$1])");
  lit = text.GlowLightCount > 0 ? AddGlow(lit) : lit;
  lit = text.Translucent ? AddMedium(lit) : lit;
  const std::string writeDistance = "    gl_FragData[0] = vec4(airlightFragmentDistance());\n";
  const std::string early = MayLeaveEarly(body)
    ? "  if (airlightStage == 0)\n  {\n" + writeDistance + "    return;\n  }\n"
    : "";
  const std::string late = "  if (airlightStage == 0)\n  {\n" + writeDistance + "  }\n";
  fragmentShader.replace(bodyStart + 1, bodyEnd - bodyStart - 1,
    "\n" + early + (anyLight ? "  airlightReceive();\n" : "") + lit + (early.empty() ? late : ""));
  fragmentShader.insert(mainStart, Declarations(text));
}

//------------------------------------------------------------------------------
// Shaders without photometry do not have these uniforms.
void SetPhotometries(vtkShaderProgram* program, const std::vector<Lamp>& lamps)
{
  if (!program->IsUniformUsed("airlightGoniometric"))
  {
    return;
  }
  std::vector<int> goniometric;
  for (size_t k = 0; k < lamps.size(); ++k)
  {
    goniometric.push_back(lamps[k].Values.goniometric);
    if (lamps[k].Values.goniometric != 0)
    {
      SetPhotometryUniforms(
        program, "airlightPhotometries[" + std::to_string(k) + "]", lamps[k].Values.photometry);
    }
  }
  program->SetUniform1iv(
    "airlightGoniometric", static_cast<int>(goniometric.size()), goniometric.data());
}

//------------------------------------------------------------------------------
void SetSurfaceUniforms(vtkShaderProgram* program, const SurfaceUniforms& values)
{
  program->SetUniformi("airlightStage", static_cast<int>(values.Stage));
  values.Rays->SetUniforms(program, values.X, values.Y);
  // A sampler left at unit 0 would clash with the mapper's own.
  program->SetUniformi("airlightLit", values.Lit->GetTextureUnit());
  if (values.Data)
  {
    program->SetUniformi("airlightData", values.Data->GetTextureUnit());
  }
  if (values.Stage == SurfaceStage::Distance)
  {
    return;
  }
  SetMediaUniforms(program, "airlightMedia", *values.Media);
  std::vector<glm::vec4> lamps;
  for (const Lamp& lamp : *values.Lamps)
  {
    const float kind = !lamp.Scatters()         ? -1.0f
      : f64::airlightIsDirectional(lamp.Values) ? 0.0f
                                                : 1.0f;
    lamps.emplace_back(glm::vec3(lamp.Values.position), kind);
  }
  if (!lamps.empty())
  {
    program->SetUniform4fv("airlightLamps", static_cast<int>(lamps.size()), &lamps[0].x);
  }
  program->SetUniformi("airlightLampCount", static_cast<int>(lamps.size()));
  SetPhotometries(program, *values.Lamps);
  program->SetUniformi("airlightUseLit", values.UseLit ? 1 : 0);
  if (values.Glow)
  {
    SetGlowUniforms(program, values);
  }
  const bool layer = values.Stage == SurfaceStage::Layer;
  program->SetUniformi("airlightThroughMedium", layer ? 1 : 0);
  for (size_t k = 0; k < values.Lamps->size() && layer; ++k)
  {
    SetLightUniforms(
      program, "airlightLights[" + std::to_string(k) + "]", (*values.Lamps)[k].Values);
  }
}
}
