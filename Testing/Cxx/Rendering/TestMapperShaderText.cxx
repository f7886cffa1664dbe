// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What becomes of VTK's shaders, pattern by pattern, on literal texts: what each pattern matches,
// and what the surface shader, the volume shader and the specialization put there. TestMapperShader
// checks that VTK's shaders have the patterns.

#include "AirlightTestCheck.h"
#include "MapperShaders/AirlightMapperShader.h"
#include "MapperShaders/AirlightSpecialization.h"
#include "MapperShaders/AirlightSurfaceShader.h"
#include "MapperShaders/AirlightVolumeShader.h"

#include <cstdlib>
#include <set>
#include <vector>

using namespace airlight_test;
using airlight::MapperText;
using airlight::SurfaceShaderOptions;

namespace
{
struct Sample
{
  MapperText Text;
  const char* Shader;
  const char* Marked; // with < before and > after what matches first
};

const std::vector<Sample> Samples = {
  { MapperText::Version, "//VTK::System::Dec\n", "<//VTK::System::Dec>\n" },
  { MapperText::Main, "int a;\nvoid main()\n{", "int a;\n<void main>()\n{" },
  { MapperText::LightColour, "df * lightColor12;", "df * <lightColor12>;" },
  { MapperText::LightColour, "lightColor + mylightColor1 + lightColor1x", "" },
  { MapperText::PhongSum, "vec4(ambientColor + diffuse + specular, opacity)",
    "vec4(<ambientColor + diffuse + specular>, opacity)" },
  { MapperText::PhongSum, "ambientColor + diffuse + specularColor", "" },
  { MapperText::PhysicalSum, "  color += Lo;\n", "  <color += Lo;>\n" },
  { MapperText::Blending, "  //VTK::DepthPeeling::Impl\n", "  <//VTK::DepthPeeling::Impl>\n" },
  { MapperText::Discard, "{ discard; }", "{ <discard>; }" },
  { MapperText::TextureLookup, "= texture(map, at);", "= <texture(>map, at);" },
  { MapperText::FragmentDepth, "gl_FragDepth = 0.5;", "<gl_FragDepth> = 0.5;" },
  { MapperText::FragmentPosition, "in vec4 vertexVCVSOutput;\n", "<in vec4 vertexVCVSOutput;>\n" },
  { MapperText::LightPosition, "uniform vec3 lightPositionVC0;",
    "<uniform vec3 lightPositionVC0;>" },
  { MapperText::Ambient, "uniform float ambientIntensity; // a",
    "<uniform float ambientIntensity;> // a" },
  { MapperText::Diffuse, "uniform float diffuseIntensity; // d",
    "<uniform float diffuseIntensity;> // d" },
  { MapperText::Specular, "uniform float specularIntensity; // s",
    "<uniform float specularIntensity;> // s" },
  { MapperText::Opacity, "uniform float opacityUniform; // o",
    "<uniform float opacityUniform;> // o" },
  { MapperText::LightPositional, "uniform int lightPositional0;",
    "<uniform int lightPositional0;>" },
  { MapperText::LightConeAngle, "uniform float lightConeAngle0;",
    "<uniform float lightConeAngle0;>" },
  { MapperText::LightAttenuation, "uniform vec3 lightAttenuation0;",
    "<uniform vec3 lightAttenuation0;>" },
  { MapperText::VolumeDeclarations, "//VTK::Termination::Dec\n", "<//VTK::Termination::Dec>\n" },
  { MapperText::VolumeStart, "//VTK::DepthPass::Init\n", "<//VTK::DepthPass::Init>\n" },
  { MapperText::VolumeBlending, " g_fragColor = (1.0f - g_fragColor.a) * tmp + g_fragColor;",
    " <g_fragColor = (1.0f - g_fragColor.a) * tmp + g_fragColor;>" },
  { MapperText::VolumeBlending, " g_fragColor = (1.0f - g_fragColor.a) * g_srcColor + g_fragColor;",
    " <g_fragColor = (1.0f - g_fragColor.a) * g_srcColor + g_fragColor;>" },
  { MapperText::VolumeSlice, " g_fragColor.rgb *= opacity;", " <g_fragColor.rgb *= opacity;>" },
  { MapperText::VolumeScale, " g_fragColor.b = g_fragColor.b * in_scale + in_bias * g_fragColor.a;",
    " <g_fragColor.b = g_fragColor.b * in_scale + in_bias * g_fragColor.a;>" },
  { MapperText::VolumeScale, " g_fragColor.b = g_fragColor.r * in_scale + in_bias * g_fragColor.a;",
    "" },
  { MapperText::VolumeLighting, "{\n  vec4 finalColor = vec4(0.0);",
    "{\n  <vec4 finalColor = vec4(0.0);>" },
  { MapperText::VolumeHeadlightColour, "n * in_lightDiffuseColor[0];",
    "n * <in_lightDiffuseColor[0]>;" },
  { MapperText::VolumeLightColour, "n * in_lightSpecularColor[lightNum];",
    "n * <in_lightSpecularColor[lightNum]>;" },
  { MapperText::VolumeSortedLightColour, "n * in_lightDiffuseColor[dirNum];",
    "n * <in_lightDiffuseColor[dirNum]>;" },
  { MapperText::VolumeSortedLightColour, "n * in_lightSpecularColor[posNum];",
    "n * <in_lightSpecularColor[posNum]>;" },
};

//------------------------------------------------------------------------------
void CheckMatches()
{
  std::set<MapperText> checked;
  for (const Sample& sample : Samples)
  {
    const std::string shader = sample.Shader;
    const bool matches = *sample.Marked != '\0';
    std::string marked = shader;
    const bool before = airlight::InsertBefore(marked, sample.Text, "<");
    const bool after = airlight::InsertAfter(marked, sample.Text, ">");
    Check(before == matches && after == matches, shader + (matches ? " matches" : " does not"));
    Check(airlight::CountText(shader + "\n" + shader, sample.Text) == (matches ? 2 : 0),
      shader + ": all matches are counted");
    Check(marked == (matches ? sample.Marked : sample.Shader), shader + ": the match is " + marked);
    checked.insert(sample.Text);
  }
  Check(checked.size() == airlight::GetMapperPatterns().size(), "each pattern has a sample");
  for (size_t i = 0; i < airlight::GetMapperPatterns().size(); ++i)
  {
    Check(airlight::GetMapperPatterns()[i].Text == static_cast<MapperText>(i),
      "the table is in the order of its names");
  }
}

//------------------------------------------------------------------------------
bool Has(const std::string& shader, const std::string& text)
{
  return shader.find(text) != std::string::npos;
}

// Declarations and a body of main().
std::string MakeShader(const std::string& declarations, const std::string& body)
{
  return "//VTK::System::Dec\n" + declarations + "void main()\n{\n" + body +
    "  //VTK::DepthPeeling::Impl\n}\n";
}

std::string Inject(
  const SurfaceShaderOptions& options, const std::string& body, const std::string& declarations)
{
  std::string shader = MakeShader(declarations, body);
  airlight::InjectSurfaceShader(shader, options);
  return shader;
}

SurfaceShaderOptions MakeOptions()
{
  SurfaceShaderOptions options;
  options.Translucent = true;
  options.ScatteringLightCount = 4;
  options.UniformMedia = true;
  options.Lights.resize(1);
  options.Lights[0].Positional = true;
  return options;
}

void CheckSurfaceShader()
{
  const SurfaceShaderOptions options = MakeOptions();
  const char* positions = "in vec4 vertexVCVSOutput;\nuniform vec3 lightPositionVC0;\n";
  const std::string shader = Inject(options,
    "  diffuse = lightColor0 + lightColor7;\n  x = ambientColor + diffuse + specular;\n"
    "  color += Lo;\n  discard;\n",
    positions);
  Check(Has(shader, "//VTK::System::Dec\n#extension GL_ARB_gpu_shader5 : enable\n"),
    "an extension after the version");
  Check(Has(shader,
          "diffuse = (lightColor0 * airlightReceivedLight[0]) + "
          "(lightColor7 * airlightReceivedLight[7]);"),
    "what arrives of each light");
  const std::string scattered = "airlightScatteredColour(normalVCVSOutput)";
  Check(Has(shader, "x = ambientColor + diffuse + diffuseColor * " + scattered + " + specular;"),
    "scattered light in Phong's model");
  Check(Has(shader, "color += Lo + (1.0 - metallic) * DiffuseLambert(albedo) * " + scattered + ";"),
    "scattered light in the physical model");
  Check(Has(shader,
          "gl_FragData[0].rgb = airlightApplyMedium(gl_FragData[0].rgb);\n"
          "  //VTK::DepthPeeling::Impl"),
    "the medium before the blending");
  Check(Has(shader, "#define AIRLIGHT_HAS_POSITIONS\n"), "VTK's distance to the light");
  Check(Has(shader, "#ifdef AIRLIGHT_DEPTH_PRE_PASS\n"), "distances without shading");
  std::string again = shader;
  airlight::InjectSurfaceShader(again, options);
  Check(again == shader, "a shader is changed once");

  SurfaceShaderOptions records = options;
  records.TranslucentFragments = true;
  Check(Has(Inject(records, "", ""), "#version 430\n"), "storage buffers need their version");
  Check(
    !Has(Inject(options, "", "uniform vec3 lightPositionVC0;\n"), "#define AIRLIGHT_HAS_POSITIONS"),
    "no distance without VTK's position of the fragment");
  Check(!Has(Inject(options, "", "in vec4 vertexVCVSOutput;\n"), "#define AIRLIGHT_HAS_POSITIONS"),
    "no distance without VTK's position of the light");
  for (const char* late : { "discard; discard;", "a = texture(map, at);", "gl_FragDepth = 0.5;" })
  {
    Check(!Has(Inject(options, late, positions), "AIRLIGHT_DEPTH_PRE_PASS"),
      std::string(late) + ": the fragment may not be drawn as it is");
    Check(Has(Inject(options, std::string("//") + late + "\n", positions), "_DEPTH_PRE_PASS"),
      std::string(late) + ": not in comments");
  }
  Check(!Has(Inject(options, "gl_FragDepth = 0.5;", positions), "#define AIRLIGHT_HAS_POSITIONS"),
    "no distance of another place");
}

//------------------------------------------------------------------------------
const char* Scales = "g_fragColor.r = g_fragColor.r * in_scale + in_bias * g_fragColor.a;\n"
                     "g_fragColor.g = g_fragColor.g * in_scale + in_bias * g_fragColor.a;\n"
                     "g_fragColor.b = g_fragColor.b * in_scale + in_bias * g_fragColor.a;\n";

std::string InjectVolume(const std::string& body)
{
  std::string shader = "//VTK::System::Dec\nuniform int a;\n//VTK::Termination::Dec\n"
                       "vec4 f()\n{\n  vec4 finalColor = vec4(0.0);\n}\n"
                       "void main()\n{\n//VTK::DepthPass::Init\n" +
    body + "}\n";
  airlight::MarkVolumeShader(shader);
  airlight::InjectVolumeShader(shader, MakeOptions());
  return shader;
}

void CheckVolumeShader()
{
  const std::string blend = "g_fragColor = (1.0f - g_fragColor.a) * tmp + g_fragColor;\n";
  const std::string medium = "tmp.rgb = tmp.rgb * in_scale + in_bias * tmp.a;\n"
                             "tmp = airlightApplyMediumToVolume(tmp);\n";
  const std::string shader = InjectVolume(blend + Scales);
  Check(Has(shader, medium + blend), "the medium before a sample is blended");
  Check(!Has(shader, Scales), "the sum is not scaled again");
  Check(Has(shader, "//VTK::DepthPass::Init\nairlightStartVolume();\n"), "the start of a ray");
  const size_t declarations = shader.find("void airlightStartVolume()");
  Check(declarations > shader.find("uniform int a;") &&
      declarations < shader.find("//VTK::Termination::Dec"),
    "declarations after VTK's");
  Check(!Has(shader, "airlightReceiveSample();"), "no light without a mention of one");

  const std::string slice = InjectVolume(std::string("g_fragColor.rgb *= opacity;\n") + Scales);
  Check(Has(slice,
          "g_fragColor.rgb *= opacity;\n"
          "g_fragColor.rgb = g_fragColor.rgb * in_scale + in_bias * g_fragColor.a;\n"
          "g_fragColor = airlightApplyMediumToVolume(g_fragColor);"),
    "the medium before a slice");
  Check(!Has(InjectVolume(Scales), "airlight"), "unchanged if nothing is blended");
  Check(!Has(InjectVolume(blend), "airlight"), "unchanged without VTK's scale");

  const auto checkLight = [&](const std::string& colour, const std::string& index) {
    const std::string lit = InjectVolume("d = " + colour + ";\n" + blend + Scales);
    Check(Has(lit, "d = (" + colour + " * airlightReceivedLight[" + index + "]);"),
      colour + ": what arrives of the light");
    Check(Has(lit, "vec4 finalColor = vec4(0.0);\n  airlightReceiveSample();"),
      colour + ": what arrives at the sample");
  };
  checkLight("in_lightDiffuseColor[0]", "0");
  checkLight("in_lightSpecularColor[lightNum]", "lightNum");
  checkLight("in_lightDiffuseColor[posNum]", "airlightSortedSceneLights[posNum]");
  checkLight("in_lightSpecularColor[dirNum]", "airlightSortedSceneLights[dirNum]");
}

//------------------------------------------------------------------------------
std::string Specialize(const std::string& shader, const airlight::SpecializationKey& key)
{
  std::string changed = shader;
  airlight::SpecializeShader(changed, key);
  return changed;
}

void CheckSpecialization()
{
  const std::string material = "uniform float ambientIntensity;\nuniform float diffuseIntensity;\n"
                               "uniform float specularIntensity;\nuniform float opacityUniform;\n";
  const std::string lights = "uniform vec3 lightAttenuation0;\nuniform float lightConeAngle0;\n"
                             "uniform int lightPositional0;\nuniform vec3 lightAttenuation1;\n"
                             "uniform float lightConeAngle1;\nuniform int lightPositional1;\n";
  const std::string shader = material + lights;
  Check(Specialize(shader, {}) == shader, "nothing is known");
  Check(Specialize(shader, { {}, { true, true, true, true } }) ==
      "const float ambientIntensity = 0.0;\nconst float diffuseIntensity = 1.0;\n"
      "const float specularIntensity = 0.0;\nconst float opacityUniform = 1.0;\n" +
        lights,
    "a material's coefficients");
  airlight::SpecializationKey key;
  key.Lights.resize(2);
  key.Lights[0].Positional = true;
  key.Lights[0].Spot = true;
  key.Lights[1].InverseSquare = true;
  Check(Specialize(shader, key) ==
      material +
        "uniform vec3 lightAttenuation0;\nuniform float lightConeAngle0;\n"
        "const int lightPositional0 = 1;\nconst vec3 lightAttenuation1 = vec3(0.0, 0.0, 1.0);\n"
        "const float lightConeAngle1 = 90.0;\nconst int lightPositional1 = 0;\n",
    "types of lights");
}
}

//------------------------------------------------------------------------------
int TestMapperShaderText(int /*argc*/, char* /*argv*/[])
{
  CheckMatches();
  CheckSurfaceShader();
  CheckVolumeShader();
  CheckSpecialization();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
