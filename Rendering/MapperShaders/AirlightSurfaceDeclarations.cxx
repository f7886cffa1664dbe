// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightSurfaceDeclarations.h"

#include "AirlightCameraShader.h"
#include "AirlightDecode.h"
#include "AirlightFragment.h"
#include "AirlightInscatterFromFroxels.h"
#include "AirlightInscatterToFragment.h"
#include "AirlightInscatterToTranslucent.h"
#include "AirlightSurface.h"
#include "AirlightSurfaceIrradiance.h"
#include "AirlightSurfaceLights.h"
#include "AirlightSurfaceMedium.h"
#include "AirlightSurfaceMultiple.h"
#include "AirlightTransmittanceBuffer.h"
#include "AirlightVertexMedium.h"
#include "MapperShaders/AirlightMapperShader.h"
#include "OpenGL/AirlightStorageBinding.h"
#include "Translucency/AirlightFroxelNodes.h"
#include "Translucency/AirlightTranslucentFragments.h"

namespace airlight
{
namespace
{
// What VTK makes of MapperText::Version, with a version that has storage buffers: some compilers
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
const char* Undefine = "#undef real\n#undef real2\n#undef real3\n#undef real4\n#undef "
                       "bool3\n#undef int3\n#undef real3x3\n#undef real4x4\n";

std::string DefineStages()
{
  const auto define = [](const char* name, SurfaceStage stage) {
    return std::string("#define AIRLIGHT_STAGE_") + name + " " +
      std::to_string(static_cast<int>(stage)) + "\n";
  };
  return define("DISTANCE", SurfaceStage::Distance) + define("COLOUR", SurfaceStage::Colour) +
    define("TRANSLUCENT", SurfaceStage::Translucent) + define("COLLECT", SurfaceStage::Collect);
}

bool HasShadowTransmittance(const SurfaceShaderOptions& options)
{
  return options.InPass && options.TransmitsShadows && !options.Froxels;
}

bool HasFroxels(const SurfaceShaderOptions& options) { return options.InPass && options.Froxels; }

// Translucent surfaces are in front of those to which ways are known.
KnownWays GetWays(const SurfaceShaderOptions& options)
{
  const bool some = options.Translucent && options.Ways == KnownWays::All;
  return !options.InPass ? KnownWays::None : some ? KnownWays::Some : options.Ways;
}

// The light that a surface receives from a scene light, for AirlightSurface.glsl.
std::string GetReceivedLight(const LightSpecialization& sceneLight, const std::string& index)
{
  if (!sceneLight.Scatters)
  {
    return "vec3(1.0)";
  }
  const std::string transmittance = sceneLight.Sun
    ? "airlightLightTransmittance(" + index + ", true, point)"
    : sceneLight.Positional && !sceneLight.Goniometric
    ? "AIRLIGHT_TRANSMITTANCE_FROM(" + index + ", lightPositionVC" + index + ", point)"
    : "airlightLightTransmittance(" + index + ", false, point)";
  return "airlightApplyShadows(" + index + ", " + transmittance + ")";
}

// A loop of a length that the compiler does not know, and arrays in it, cost several times as much.
std::string DefineEachLight(const std::vector<LightSpecialization>& lights, int shadowingLight)
{
  std::string lines;
  for (size_t k = 0; k < lights.size(); ++k)
  {
    const std::string index = std::to_string(k);
    lines += " airlightReceivedLight[" + index +
      "] = " + (static_cast<int>(k) == shadowingLight ? "airlightShadowingLightFactor * " : "") +
      GetReceivedLight(lights[k], index) + ";";
  }
  return lines.empty() ? "" : "#define AIRLIGHT_EACH_LIGHT(point)" + lines + "\n";
}

// What the shaders of surfaces and of volumes begin with.
std::string CommonDeclarations(const SurfaceShaderOptions& options)
{
  const auto define = [](const char* name, int value) {
    return std::string("#define AIRLIGHT_") + name + " " + std::to_string(value) + "\n";
  };
  return options.Mathematics + DefineStages() +
    define("TRANSLUCENT_FRAGMENTS", HasRecords(options)) +
    define("SHADOW_TRANSMITTANCE", HasShadowTransmittance(options)) +
    define("FROXELS", HasFroxels(options)) + define("SCENE_LIGHTS", options.SceneLightCount) +
    define("BITS", BitsPerChannel) +
    define("ONLY_COLOURS",
      options.SingleGeometryPass && options.ViewportIsTarget && !options.Translucent) +
    define("MORE_LIT", options.SceneLightCount > BitsPerChannel) +
    define("IN_PASS", options.InPass) + define("READS_LIT", options.InPass && options.ReadsLit) +
    define("LIGHT_WAYS", static_cast<int>(GetWays(options))) +
    define("AT_VERTICES", options.AtVertices) + define("ENCODED_INPUT", options.EncodedInput) +
    define("UNIFORM_MEDIA", options.UniformMedia) +
    (options.ViewportIsTarget
        ? define("PARALLEL", options.Parallel) + define("FRAGMENT_IS_PIXEL", 1)
        : "") +
    DefineEachLight(options.Lights, options.ShadowingLight) + AirlightSurfaceLights;
}

std::string StorageDeclarations(const SurfaceShaderOptions& options)
{
  return (HasRecords(options) || HasShadowTransmittance(options) ? DefineStorageBindings() : "") +
    (HasRecords(options) ? TranslucentFragments::GetSource() : "") +
    (HasShadowTransmittance(options) ? AirlightTransmittanceBuffer : "") +
    (HasFroxels(options) ? FroxelNodes::GetLookupSource() : "");
}
}

//------------------------------------------------------------------------------
bool HasRecords(const SurfaceShaderOptions& options)
{
  return options.InPass && options.Translucent && options.TranslucentFragments;
}

//------------------------------------------------------------------------------
std::string GetSurfaceDeclarations(const SurfaceShaderOptions& options)
{
  const std::string scattered = options.ScatteringLightCount > 0
    ? "#define AIRLIGHT_SCATTERING_LIGHTS " + std::to_string(options.ScatteringLightCount) + "\n" +
      AirlightSurfaceIrradiance
    : options.MultipleScattering ? AirlightSurfaceMultiple
                                 : "";
  const char* before = HasRecords(options) ? AirlightInscatterToTranslucent
    : HasFroxels(options)                  ? AirlightInscatterFromFroxels
    : options.AtVertices                   ? ""
                                           : AirlightInscatterToFragment;
  const std::string medium =
    options.Translucent ? std::string(before) + AirlightDecode + AirlightSurfaceMedium : "";
  return CommonDeclarations(options) + AirlightCameraShader + AirlightFragment +
    StorageDeclarations(options) + AirlightSurface + scattered + medium + Undefine;
}

//------------------------------------------------------------------------------
std::string GetVertexDeclarations(const SurfaceShaderOptions& options)
{
  return CommonDeclarations(options) + AirlightInscatterToFragment + AirlightVertexMedium +
    Undefine;
}

//------------------------------------------------------------------------------
std::string GetVolumeDeclarations(const SurfaceShaderOptions& options, const std::string& volume)
{
  return CommonDeclarations(options) + AirlightCameraShader + AirlightFragment +
    StorageDeclarations(options) + AirlightSurface +
    (HasRecords(options) ? AirlightInscatterToTranslucent : AirlightInscatterToFragment) +
    AirlightDecode + volume + Undefine;
}

//------------------------------------------------------------------------------
void AddExtensions(std::string& shader, const SurfaceShaderOptions& options)
{
  if (HasRecords(options) || HasShadowTransmittance(options))
  {
    ReplaceText(shader, MapperText::Version, StorageSystem);
    return;
  }
  InsertAfter(shader, MapperText::Version, "\n#extension GL_ARB_gpu_shader5 : enable\n");
}
}
