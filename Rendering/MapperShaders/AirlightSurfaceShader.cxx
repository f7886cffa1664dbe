// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightSurfaceShader.h"

#include "AirlightCameraShader.h"
#include "AirlightDisplay.h"
#include "AirlightFragment.h"
#include "AirlightInscatterToFragment.h"
#include "AirlightInscatterToTranslucent.h"
#include "AirlightSurface.h"
#include "AirlightSurfaceIrradiance.h"
#include "AirlightSurfaceLights.h"
#include "AirlightSurfaceMedium.h"
#include "AirlightTransmittanceBuffer.h"
#include "AirlightVertexMedium.h"
#include "OpenGL/AirlightShaderLibrary.h"
#include "OpenGL/AirlightStorageBinding.h"
#include "Translucency/AirlightTranslucentFragments.h"

#include <algorithm>
#include <regex>

namespace airlight
{
namespace
{
// What VTK makes of the line for the version, with one that has storage buffers: some compilers
// refuse them as extensions of 1.50.
const char* StorageSystem = "#version 430\n"
                            "#define highp\n"
                            "#define mediump\n"
                            "#define lowp\n"
                            "#define texelFetchBuffer texelFetch\n"
                            "#define texture1D texture\n"
                            "#define texture2D texture\n"
                            "#define texture3D texture\n"
                            "#define varying in\n";

// The prelude's words must not reach the mapper's own options.
const char* Undefine = "#undef real\n#undef real2\n#undef real3\n#undef real4\n#undef bool3\n";

std::string DefineStages()
{
  const auto define = [](const char* name, SurfaceStage stage) {
    return std::string("#define AIRLIGHT_STAGE_") + name + " " +
      std::to_string(static_cast<int>(stage)) + "\n";
  };
  return define("DISTANCE", SurfaceStage::Distance) + define("COLOUR", SurfaceStage::Colour) +
    define("TRANSLUCENT", SurfaceStage::Translucent) + define("COLLECT", SurfaceStage::Collect);
}

bool HasRecords(const SurfaceShaderOptions& options)
{
  return options.InPass && options.Translucent && options.TranslucentFragments;
}

bool HasShadowTransmittance(const SurfaceShaderOptions& options)
{
  return options.InPass && options.TransmitsShadows;
}

// What both shaders begin with.
std::string CommonDeclarations(const SurfaceShaderOptions& options)
{
  const auto define = [](const char* name, int value) {
    return std::string("#define AIRLIGHT_") + name + " " + std::to_string(value) + "\n";
  };
  return options.Mathematics + DefineStages() +
    define("TRANSLUCENT_FRAGMENTS", HasRecords(options)) +
    define("SHADOW_TRANSMITTANCE", HasShadowTransmittance(options)) +
    define("SCENE_LIGHTS", options.SceneLightCount) + define("BITS", BitsPerChannel) +
    define("ONLY_COLOURS",
      options.SingleGeometryPass && options.ViewportIsTarget && !options.Translucent) +
    define("MORE_LIT", options.SceneLightCount > BitsPerChannel) +
    define("IN_PASS", options.InPass) + define("READS_LIT", options.InPass && options.ReadsLit) +
    define("AT_VERTICES", options.AtVertices) +
    (options.ViewportIsTarget
        ? define("PARALLEL", options.Parallel) + define("FRAGMENT_IS_PIXEL", 1)
        : "") +
    DefineEachLight(options.Lights, options.ShadowingLight) + AirlightSurfaceLights;
}

std::string StorageDeclarations(const SurfaceShaderOptions& options)
{
  return (HasRecords(options) || HasShadowTransmittance(options) ? DefineStorageBindings() : "") +
    (HasRecords(options) ? TranslucentFragments::GetSource() : "") +
    (HasShadowTransmittance(options) ? AirlightTransmittanceBuffer : "");
}

std::string Declarations(const SurfaceShaderOptions& options)
{
  const std::string scattered = options.ScatteringLightCount > 0
    ? "#define AIRLIGHT_SCATTERING_LIGHTS " + std::to_string(options.ScatteringLightCount) + "\n" +
      AirlightSurfaceIrradiance
    : "";
  const char* before = HasRecords(options) ? AirlightInscatterToTranslucent
    : options.AtVertices                   ? ""
                                           : AirlightInscatterToFragment;
  const std::string medium =
    options.Translucent ? std::string(before) + AirlightDisplay + AirlightSurfaceMedium : "";
  return CommonDeclarations(options) + AirlightCameraShader + AirlightFragment +
    StorageDeclarations(options) + AirlightSurface + scattered + medium + Undefine;
}

// Adds scattered light where VTK's templates add up their lighting: as a light of that colour that
// meets the surface head on, in the diffuse part. Unlit shaders have neither place.
std::string AddScatteredIrradiance(const std::string& body)
{
  const std::string scattered = "airlightScatteredColour(normalVCVSOutput)";
  static const std::regex phong("\\bambientColor \\+ diffuse \\+ specular\\b");
  static const std::regex physical("\\bcolor \\+= Lo;");
  return std::regex_replace(
    std::regex_replace(
      body, phong, "ambientColor + diffuse + diffuseColor * " + scattered + " + specular"),
    physical, "color += Lo + (1.0 - metallic) * DiffuseLambert(albedo) * " + scattered + ";");
}

// Puts the fragment behind the medium, before other passes make of it what they blend.
std::string AddMedium(const std::string& body)
{
  const std::string marker = "//VTK::DepthPeeling::Impl";
  const size_t position = body.find(marker);
  return position == std::string::npos ? body
                                       : body.substr(0, position) +
      "\n  gl_FragData[0].rgb = airlightApplyMedium(gl_FragData[0].rgb);\n  " +
      body.substr(position);
}

std::string WithoutComments(const std::string& body)
{
  static const std::regex comment("//[^\n]*");
  return std::regex_replace(body, comment, "");
}

// Whether nothing but the template's own test of the final opacity can discard a fragment. Then a
// fragment of an opaque surface is as good as drawn before it is shaded. `body` without comments.
bool MayLeaveEarly(const std::string& body)
{
  const size_t first = body.find("discard");
  return (first == std::string::npos || body.find("discard", first + 1) == std::string::npos) &&
    body.find("texture(") == std::string::npos && body.find("gl_FragDepth") == std::string::npos;
}

// Whether the mapper's shading has the places of lights and of the fragment, which is drawn where
// the triangle is. `body` without comments.
bool HasPositions(
  const std::string& shader, const std::string& body, const std::vector<LightSpecialization>& known)
{
  for (size_t k = 0; k < known.size(); ++k)
  {
    if (known[k].Positional &&
      shader.find("uniform vec3 lightPositionVC" + std::to_string(k) + ";") == std::string::npos)
    {
      return false;
    }
  }
  return shader.find("in vec4 vertexVCVSOutput;") != std::string::npos &&
    body.find("gl_FragDepth") == std::string::npos;
}

// Below 0 in green: no shader that writes colours does that.
const char* WriteDistance =
  "    gl_FragData[0] = vec4(airlightFragmentParameter(), -1.0, 0.0, 1.0);\n";

// What is drawn where no colours are.
std::string OtherStages(bool records, bool leave)
{
  const std::string end = leave ? "    return;\n  }\n" : "  }\n";
  return std::string("  if (airlightStage == AIRLIGHT_STAGE_DISTANCE)\n  {\n") + WriteDistance +
    end +
    // Discarded: opaque point Gaussians would hide one another.
    (records ? "  if (airlightStage == AIRLIGHT_STAGE_COLLECT)\n  {\n    airlightCollect();\n"
               "    discard;\n  }\n"
             : "");
}

// For AirlightDepthPrePassVariants.h.
std::string DepthPrePassBranch(const std::string& hide, const std::string& shade)
{
  return "#ifdef AIRLIGHT_DEPTH_PRE_PASS\nvoid main()\n{\n" + hide + WriteDistance + "}\n#else\n" +
    shade + "\n#endif\n";
}

// main() where all that is known of a fragment is drawn at once. Shades in a function, which may
// have returned from anywhere.
std::string MakeSingleGeometryPass(const SurfaceShaderOptions& options)
{
  const char* withoutLight = "    vec4 colour = gl_FragData[0];\n"
                             "    airlightShadowingLightFactor = 0.0;\n"
                             "    airlightShade();\n"
                             "    gl_FragData[2] = gl_FragData[0];\n"
                             "    gl_FragData[0] = colour;\n";
  return std::string("\nvoid main()\n{\n  airlightShade();\n"
                     "  if (airlightStage == AIRLIGHT_STAGE_COLOUR)\n  {\n"
                     "    gl_FragData[1] = vec4(airlightFragmentParameter(), 0.0, 0.0, 1.0);\n") +
    (options.ShadowingLight >= 0 ? withoutLight : "") + "  }\n}\n";
}
}

//------------------------------------------------------------------------------
void AddExtensions(std::string& shader, const SurfaceShaderOptions& options)
{
  const std::string system = "//VTK::System::Dec"; // VTK's line for the version, which is 1.50
  const size_t line = shader.find(system);
  if (line == std::string::npos)
  {
    return;
  }
  if (HasRecords(options) || HasShadowTransmittance(options))
  {
    shader.replace(line, system.size(), StorageSystem);
    return;
  }
  shader.insert(line + system.size(), "\n#extension GL_ARB_gpu_shader5 : enable\n");
}

//------------------------------------------------------------------------------
std::string GetVolumeDeclarations(const SurfaceShaderOptions& options, const std::string& volume)
{
  return CommonDeclarations(options) + AirlightCameraShader + AirlightFragment +
    StorageDeclarations(options) + AirlightSurface +
    (HasRecords(options) ? AirlightInscatterToTranslucent : AirlightInscatterToFragment) +
    AirlightDisplay + volume + Undefine;
}

//------------------------------------------------------------------------------
void InjectSurfaceShader(
  std::string& fragmentShader, const SurfaceShaderOptions& options, bool pointGaussians)
{
  const size_t mainStart = fragmentShader.find("void main");
  const size_t bodyStart = fragmentShader.find('{', mainStart);
  const size_t bodyEnd = fragmentShader.rfind('}');
  if (mainStart == std::string::npos || bodyStart == std::string::npos || bodyEnd < bodyStart ||
    fragmentShader.find("airlightReceivedLight") != std::string::npos)
  {
    return;
  }
  const std::string body = fragmentShader.substr(bodyStart + 1, bodyEnd - bodyStart - 1);

  // VTK names the lights lightColor0, lightColor1, ...
  static const std::regex lightColor("\\blightColor([0-9]+)\\b");
  const bool anyLight = std::regex_search(body, lightColor);
  std::string lit = SpecializeLightTypes(
    std::regex_replace(body, lightColor, "(lightColor$1 * airlightReceivedLight[$1])"),
    options.Lights);
  lit = options.ScatteringLightCount > 0 ? AddScatteredIrradiance(lit) : lit;
  lit = options.Translucent ? AddMedium(lit) : lit;
  const bool records = HasRecords(options);
  const bool hides = pointGaussians || options.Hides;
  const std::string hide = hides ? "  if (airlightHidden != 0)\n  {\n    discard;\n  }\n" : "";
  const std::string find = records ? "  if (airlightStage == AIRLIGHT_STAGE_TRANSLUCENT)\n  {\n    "
                                     "airlightFindTranslucent();\n  }\n"
                                   : "";
  const std::string bare = WithoutComments(body);
  const bool early = MayLeaveEarly(bare);
  const std::string others = options.InPass ? OtherStages(records, early) : "";
  const std::string shade =
    (options.SingleGeometryPass ? "void airlightShade()\n{\n" : "void main()\n{\n") + hide +
    (early ? others : "") + find + (anyLight ? "  airlightReceive();\n" : "") + lit +
    (early ? "" : others) + fragmentShader.substr(bodyEnd) +
    (options.SingleGeometryPass ? MakeSingleGeometryPass(options) : "");
  fragmentShader.replace(mainStart, fragmentShader.size(),
    (options.UniformMedia && HasPositions(fragmentShader, bare, options.Lights)
        ? "#define AIRLIGHT_UNIFORM_MEDIA\n"
        : "") +
      Declarations(options) + (hides ? "uniform int airlightHidden;\n" : "") +
      (early && options.InPass ? DepthPrePassBranch(hide, shade) : shade));
  AddExtensions(fragmentShader, options);
}

//------------------------------------------------------------------------------
void InjectVertexShader(std::string& vertexShader, const SurfaceShaderOptions& options)
{
  const size_t mainStart = vertexShader.find("void main");
  const size_t bodyStart = vertexShader.find('{', mainStart);
  if (mainStart == std::string::npos || bodyStart == std::string::npos)
  {
    return;
  }
  vertexShader.insert(
    bodyStart + 1, "\n  airlightAtVertex((airlightVertexToEye * vertexMC).xyz);\n");
  vertexShader.insert(mainStart,
    CommonDeclarations(options) + AirlightInscatterToFragment + AirlightVertexMedium + Undefine);
  AddExtensions(vertexShader, options);
}

//------------------------------------------------------------------------------
bool UpdateSurfaceShaderOptions(SurfaceShaderOptions& options, const f64::AirlightMedia& media,
  const std::vector<SceneLight>& sceneLights, bool scatteredLight, bool translucent)
{
  const int sceneLightCount = static_cast<int>(sceneLights.size());
  const bool lights =
    scatteredLight || (translucent && !(options.InPass && options.TranslucentFragments));
  const int kind = lights ? CommonKind(sceneLights) : AIRLIGHT_POINT_CLOSED;
  const bool photometry = std::any_of(sceneLights.begin(), sceneLights.end(),
    [](const SceneLight& sceneLight) { return sceneLight.Values.goniometric != 0; });
  const std::string source = GetScatteringSource(media, kind, photometry) +
    (scatteredLight ? GetScatteredIrradianceSource() : "");
  // VTK's own text knows the number of lights, too, and is made again if another number
  // shines; a mapper without the pass is to stay as it is.
  const std::vector<LightSpecialization> known =
    options.InPass ? SpecializeLights(sceneLights) : std::vector<LightSpecialization>();
  const bool everywhere = std::all_of(media.item, media.item + media.count, [](const auto& medium) {
    return medium.region.kind == AIRLIGHT_REGION_UNBOUNDED &&
      medium.density == AIRLIGHT_DENSITY_UNIFORM;
  });
  if (sceneLightCount <= options.SceneLightCount && everywhere == options.UniformMedia &&
    source == options.Mathematics && translucent == options.Translucent && known == options.Lights)
  {
    return false;
  }
  options.Lights = known;
  options.UniformMedia = everywhere;
  options.Translucent = translucent;
  // Some more, so that another light does not make other shaders.
  options.SceneLightCount = std::max(options.SceneLightCount, (sceneLightCount + 7) / 8 * 8);
  options.ScatteringLightCount =
    scatteredLight ? std::min(options.SceneLightCount, MaximumScatteringLights) : 0;
  options.Mathematics = source;
  return true;
}
}
