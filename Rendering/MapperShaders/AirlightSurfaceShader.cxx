// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightSurfaceShader.h"

#include "MapperShaders/AirlightMapperShader.h"
#include "MapperShaders/AirlightSurfaceDeclarations.h"
#include "Medium/AirlightConvert.h"
#include "OpenGL/AirlightShaderLibrary.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Adds scattered light where VTK's templates add up their lighting: as a light of that colour that
// meets the surface head on, in the diffuse part. Unlit shaders have neither place.
void AddScatteredIrradiance(std::string& body)
{
  const std::string scattered = "airlightScatteredColour(normalVCVSOutput)";
  ReplaceText(body, MapperText::PhongSum,
    "ambientColor + diffuse + diffuseColor * " + scattered + " + specular");
  ReplaceText(body, MapperText::PhysicalSum,
    "color += Lo + (1.0 - metallic) * DiffuseLambert(albedo) * " + scattered + ";");
}

// Puts the fragment behind the medium, before other passes make of it what they blend.
void AddMedium(std::string& body)
{
  InsertBefore(body, MapperText::Blending,
    "\n  gl_FragData[0].rgb = airlightApplyMedium(gl_FragData[0].rgb);\n  ");
}

// Whether nothing but the template's own test of the final opacity can discard a fragment. Then a
// fragment of an opaque surface is as good as drawn before it is shaded. `body` without comments.
bool MayLeaveEarly(const std::string& body)
{
  return CountText(body, MapperText::Discard) <= 1 && !HasText(body, MapperText::TextureLookup) &&
    !HasText(body, MapperText::FragmentDepth);
}

// Whether the mapper's shading has the places of lights and of the fragment, which is drawn where
// the triangle is. `body` without comments.
bool HasPositions(
  const std::string& shader, const std::string& body, const std::vector<LightSpecialization>& known)
{
  for (size_t k = 0; k < known.size(); ++k)
  {
    if (known[k].Positional && !HasText(shader, MapperText::LightPosition, k))
    {
      return false;
    }
  }
  return HasText(shader, MapperText::FragmentPosition) && !HasText(body, MapperText::FragmentDepth);
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

// For AirlightStageVariants.h.
std::string StageBranches(const std::string& hide, bool records, const std::string& shade)
{
  const std::string begin = "\nvoid main()\n{\n" + hide;
  return "#ifdef " + GetStageMacro(SurfaceStage::Distance) + begin + WriteDistance + "}\n" +
    (records ? "#elif defined(" + GetStageMacro(SurfaceStage::Collect) + ")" + begin +
          "  airlightCollect();\n  discard;\n}\n"
             : "") +
    "#else\n" + shade + "\n#endif\n";
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
void KeepSplatDepth(std::string& geometryShader)
{
  const std::string corner = "vec4(posNDC.xy + offset, posNDC.zw)";
  const size_t at = geometryShader.find(corner);
  if (at != std::string::npos)
  {
    geometryShader.insert(at, "gl_in[0].gl_Position.w * ");
  }
}

//------------------------------------------------------------------------------
void InjectSurfaceShader(
  std::string& fragmentShader, const SurfaceShaderOptions& options, bool pointGaussians)
{
  const std::optional<SplitShader> split = SplitAtMain(fragmentShader);
  if (!split || fragmentShader.find("airlightReceivedLight") != std::string::npos)
  {
    return;
  }
  std::string lit = split->Body;
  const bool anyLight =
    ReplaceText(lit, MapperText::LightColour, "($& * airlightReceivedLight[$1])");
  if (options.ScatteringLightCount > 0 || options.MultipleScattering)
  {
    AddScatteredIrradiance(lit);
  }
  if (options.Translucent)
  {
    AddMedium(lit);
  }
  const bool records = HasRecords(options);
  const bool hides = pointGaussians || options.Hides;
  const std::string hide = hides ? "  if (airlightHidden != 0)\n  {\n    discard;\n  }\n" : "";
  const std::string find = records ? "  if (airlightStage == AIRLIGHT_STAGE_TRANSLUCENT)\n  {\n    "
                                     "airlightFindTranslucent();\n  }\n"
                                   : "";
  const std::string bare = RemoveComments(split->Body);
  const bool early = MayLeaveEarly(bare);
  const std::string others = options.InPass ? OtherStages(records, early) : "";
  const std::string shade =
    (options.SingleGeometryPass ? "void airlightShade()\n{\n" : "void main()\n{\n") + hide +
    (early ? others : "") + find + (anyLight ? "  airlightReceive();\n" : "") + lit +
    (early ? "" : others) + split->After +
    (options.SingleGeometryPass ? MakeSingleGeometryPass(options) : "");
  const bool positions = options.UniformMedia && !options.CastingVolumes &&
    HasPositions(fragmentShader, bare, options.Lights);
  fragmentShader = split->Before + (positions ? "#define AIRLIGHT_HAS_POSITIONS\n" : "") +
    GetSurfaceDeclarations(options) + (hides ? "uniform int airlightHidden;\n" : "") +
    (early && options.InPass ? StageBranches(hide, records, shade) : shade);
  AddExtensions(fragmentShader, options);
}

//------------------------------------------------------------------------------
void InjectVertexShader(std::string& vertexShader, const SurfaceShaderOptions& options)
{
  const std::optional<SplitShader> split = SplitAtMain(vertexShader);
  if (!split)
  {
    return;
  }
  vertexShader = split->Before + GetVertexDeclarations(options) +
    "void main()\n{\n  airlightAtVertex((airlightVertexToEye * vertexMC).xyz);\n" + split->Body +
    split->After;
  AddExtensions(vertexShader, options);
}

//------------------------------------------------------------------------------
bool UpdateSurfaceShaderOptions(SurfaceShaderOptions& options, const f64::AirlightMedia& media,
  const std::vector<SceneLight>& sceneLights, bool scatteredLight, bool translucent)
{
  const int sceneLightCount = static_cast<int>(sceneLights.size());
  const bool lights = scatteredLight ||
    (translucent && !(options.InPass && (options.TranslucentFragments || options.Froxels)));
  const bool multiple = media.multiple.count > 0;
  const int kind = lights ? CommonKind(sceneLights) : AIRLIGHT_POINT_CLOSED;
  const bool photometry = std::any_of(sceneLights.begin(), sceneLights.end(),
    [](const SceneLight& sceneLight) { return sceneLight.Values.goniometric != 0; });
  // Of lamps whose light is scattered more than once, what is scattered once is a part of that.
  const bool irradiance = scatteredLight &&
    (!multiple ||
      std::any_of(sceneLights.begin(), sceneLights.end(), [&media](const SceneLight& sceneLight) {
        return sceneLight.HasPower() && !IsMultiple(media, sceneLight.Values);
      }));
  const std::string source = GetScatteringSource(media, kind, photometry) +
    (irradiance ? GetScatteredIrradianceSource() : "");
  // VTK's own text knows the number of lights, too, and is made again if another number
  // shines; a mapper without the pass is to stay as it is.
  const std::vector<LightSpecialization> known =
    options.InPass ? SpecializeLights(sceneLights) : std::vector<LightSpecialization>();
  const bool everywhere = std::all_of(media.item, media.item + media.count, [](const auto& medium) {
    return medium.region.kind == AIRLIGHT_REGION_UNBOUNDED &&
      medium.density == AIRLIGHT_DENSITY_UNIFORM;
  });
  const bool volumes = media.volumes > 0;
  if (sceneLightCount <= options.SceneLightCount && everywhere == options.UniformMedia &&
    volumes == options.CastingVolumes && source == options.Mathematics &&
    translucent == options.Translucent && known == options.Lights)
  {
    return false;
  }
  options.Lights = known;
  options.UniformMedia = everywhere;
  options.CastingVolumes = volumes;
  options.Translucent = translucent;
  // Some more, so that another light does not make other shaders.
  options.SceneLightCount = std::max(options.SceneLightCount, (sceneLightCount + 7) / 8 * 8);
  options.ScatteringLightCount =
    irradiance ? std::min(options.SceneLightCount, MaximumScatteringLights) : 0;
  options.MultipleScattering = multiple;
  options.Mathematics = source;
  return true;
}
}
