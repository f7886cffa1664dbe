// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightSurfaceShader.h"

#include "AirlightFragment.h"
#include "AirlightQuad.h"
#include "AirlightSurface.h"
#include "AirlightView.h"
#include "AirlightViewShader.h"

#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <regex>
#include <set>

namespace airlight
{
namespace
{
// The prelude's words must not reach the mapper's own text.
const char* Undefine = "#undef real\n#undef real2\n#undef real3\n#undef real4\n#undef bool3\n";

std::string Declarations(int lampCount, const std::string& mathematics)
{
  return mathematics + "#define AIRLIGHT_LAMPS " + std::to_string(lampCount) +
    "\n#define AIRLIGHT_BITS " + std::to_string(BitsPerChannel) + "\n" + AirlightViewShader +
    AirlightFragment + AirlightSurface + Undefine;
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
}

//------------------------------------------------------------------------------
void InjectSurfaceShader(std::string& fragmentShader, int lampCount, const std::string& mathematics)
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
  std::set<int> used;
  for (std::sregex_iterator it(body.begin(), body.end(), lightColor), end; it != end; ++it)
  {
    used.insert(std::stoi((*it)[1]));
  }
  std::string arrives;
  for (int k : used)
  {
    const std::string number = std::to_string(k);
    arrives += "  vec3 airlightArrives" + number + " = " +
      (k < lampCount ? "airlightArrives(" + number + ")" : "vec3(1.0)") + ";\n";
  }
  const std::string lit =
    std::regex_replace(body, lightColor, "(lightColor$1 * airlightArrives$1)");
  const std::string writeDistance = "    gl_FragData[0] = vec4(airlightFragmentDistance());\n";
  const std::string early = MayLeaveEarly(body)
    ? "  if (airlightStage == 0)\n  {\n" + writeDistance + "    return;\n  }\n"
    : "";
  const std::string late = "  if (airlightStage == 0)\n  {\n" + writeDistance + "  }\n";
  fragmentShader.replace(bodyStart + 1, bodyEnd - bodyStart - 1,
    "\n" + early + arrives + lit + (early.empty() ? late : ""));
  fragmentShader.insert(mainStart, Declarations(lampCount, mathematics));
}

//------------------------------------------------------------------------------
void SetSurfaceUniforms(vtkShaderProgram* program, const SurfaceUniforms& values)
{
  program->SetUniformi("airlightStage", static_cast<int>(values.Stage));
  values.Rays->SetUniforms(program, 0, 0);
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
  program->SetUniformi("airlightUseLit", values.UseLit ? 1 : 0);
}
}
