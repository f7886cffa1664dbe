// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What Print() says: each public class its properties, each value of an enumeration its name, with
// nothing set and with all set.

#include "AirlightTestCheck.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkAirlightComparison.h"
#include "vtkAirlightDensityImage.h"
#include "vtkAirlightPass.h"
#include "vtkAirlightPolyDataMapper.h"
#include "vtkAirlightProbeFilter.h"
#include "vtkAirlightReference.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLitIntervalsFilter.h"
#include "vtkNew.h"
#ifdef AIRLIGHT_HAS_OPENVDB
#include "vtkOpenVDBDensityReader.h"
#endif
#include "vtkParticipatingMedium.h"
#include "vtkSchlickPhaseFunction.h"
#include "vtkShadowPlanesFilter.h"
#include "vtkSilhouetteEdgesFilter.h"

#include <cstdlib>
#include <initializer_list>
#include <sstream>
#include <string>

using namespace airlight_test;

namespace
{
std::string Print(vtkObject* object)
{
  std::ostringstream text;
  object->Print(text);
  return text.str();
}

void CheckPrint(vtkObject* object, std::initializer_list<const char*> parts)
{
  const std::string text = Print(object);
  for (const char* part : parts)
  {
    Check(text.find(part) != std::string::npos,
      Text(object->GetClassName(), " prints \"", part, "\"; it prints\n", text));
  }
}

// `set` takes the values from 0, which have these names.
template <typename Set>
void CheckNames(vtkObject* object, const std::string& property,
  std::initializer_list<const char*> names, const Set& set)
{
  int value = 0;
  for (const char* name : names)
  {
    set(value++);
    CheckPrint(object, { (property + ": " + name + "\n").c_str() });
  }
}

void TestMedium()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.25, 0.5, 0.75);
  medium->SetAbsorption(0.125, 1.25, 1.5);
  medium->SetAmbientRadiance(2.0, 3.0, 4.0);
  medium->SetEmission(5.0, 6.0, 7.0);
  medium->SetSkyRadiance(1.5, 2.5, 3.5);
  medium->SetGroundRadiance(0.5, 0.25, 0.125);
  medium->SetBounds(-1.0, 2.0, -3.0, 4.0, -5.0, 6.0);
  medium->SetCenter(7.0, 8.0, 9.0);
  medium->SetRadius(10.5);
  medium->SetHeight(13.5);
  medium->SetAxis(0.0, 0.0, 5.0);
  medium->SetScaleHeight(11.5);
  medium->SetReferenceHeight(12.5);
  medium->SetUp(0.0, 2.0, 0.0);
  CheckPrint(medium,
    { "Scattering: (0.25, 0.5, 0.75)\n", "Absorption: (0.125, 1.25, 1.5)\n",
      "AmbientRadiance: (2, 3, 4)\n", "Emission: (5, 6, 7)\n", "SkyRadiance: (1.5, 2.5, 3.5)\n",
      "GroundRadiance: (0.5, 0.25, 0.125)\n", "SkyHarmonics: 0 0 ",
      "Bounds: (-1, 2, -3, 4, -5, 6)\n", "Center: (7, 8, 9)\n", "Radius: 10.5\n", "Height: 13.5\n",
      "Axis: (0, 0, 1)\n", "ScaleHeight: 11.5\n", "ReferenceHeight: 12.5\n", "Up: (0, 1, 0)\n",
      "PhaseErrorBound: (not fitted yet)\n" });
  CheckNames(medium, "PhaseFunction",
    { "Isotropic", "HenyeyGreenstein", "Rayleigh", "Schlick", "CornetteShanks", "MieHazy",
      "MieMurky", "Tabulated" },
    [&](int value) { medium->SetPhaseFunction(value); });
  CheckNames(medium, "Region", { "Unbounded", "Box", "Sphere", "Surface", "Cylinder" },
    [&](int value) { medium->SetRegion(value); });
  CheckNames(medium, "Density", { "Uniform", "ExponentialHeight", "Image" },
    [&](int value) { medium->SetDensity(value); });
  medium->SetPhaseFunctionToRayleigh();
  medium->GetPhaseErrorBound();
  CheckPrint(medium, { " poles)\n" }); // Rayleigh's is exact: one suffices
  vtkNew<vtkSchlickPhaseFunction> phase;
  phase->SetAnisotropy(0.375);
  medium->SetPhaseFunction(phase);
  CheckPrint(medium, { "PhaseFunction: Schlick\n", "k: 0.375\n" });
}

void TestPass()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetRadius(10.5);
  vtkNew<vtkAirlightPass> pass;
  CheckPrint(pass, { "NumberOfMedia: 0\n" });
  pass->SetMedium(medium);
  pass->SetLightRadius(0.25);
  pass->SetShadowMapResolution(512);
  pass->SetNumberOfSteps(33);
  pass->SetMemoryLimit(77);
  pass->MultisamplingOn();
  CheckPrint(pass,
    { "NumberOfMedia: 1\n", "Radius: 10.5\n", "LightRadius: 0.25\n", "ShadowMapResolution: 512\n",
      "NumberOfSteps: 33\n", "MemoryLimit: 77 MiB\n", "Multisampling: 1\n" });
  CheckNames(pass, "ShadowTechnique",
    { "None", "ShadowPlanes", "Automatic", "ShadowMap", "RayMarch" },
    [&](int value) { pass->SetShadowTechnique(value); });
  CheckNames(pass, "DebugView",
    { "Shaded", "AirlightOnly", "BoundaryCount", "ShadowPlaneOutlines" },
    [&](int value) { pass->SetDebugView(value); });

  vtkNew<vtkAirlightPolyDataMapper> mapper;
  mapper->SetMedium(medium);
  mapper->SetLightRadius(0.75);
  CheckPrint(mapper, { "NumberOfMedia: 1\n", "Radius: 10.5\n", "LightRadius: 0.75\n" });
  CheckNames(mapper, "Evaluation", { "Fragment", "Vertex" },
    [&](int value) { mapper->SetEvaluation(value); });
}

void TestFilters()
{
  vtkNew<vtkLight> light;
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetRadius(10.5);

  vtkNew<vtkShadowPlanesFilter> planes;
  CheckPrint(planes, { "Light: 0\n" });
  planes->SetLight(light);
  planes->SetLightPosition(1.0, 2.0, 3.0);
  planes->SetFarDistance(44.0);
  planes->SetBounds(-1.0, 2.0, -3.0, 4.0, -5.0, 6.0);
  CheckPrint(planes,
    { "LightPosition: (1, 2, 3)\n", "FarDistance: 44\n", "Bounds: (-1, 2, -3, 4, -5, 6)\n",
      "LightCap: ", "FarCap: " });
  CheckNames(
    planes, "Extent", { "FarDistance", "Bounds" }, [&](int value) { planes->SetExtent(value); });

  vtkNew<vtkAirlightProbeFilter> probe;
  CheckPrint(probe, { "Lights: 0\n" });
  probe->AddLight(light);
  probe->SetMedium(medium);
  probe->SetViewpoint(1.0, 2.0, 3.0);
  probe->SetMaximumVisibility(30.0);
  CheckPrint(probe,
    { "Lights: 1\n", "NumberOfMedia: 1\n", "Viewpoint: 1, 2, 3\n", "SightLines: 0\n",
      "ReflectingSignConstant: 3\n", "EmittingSignConstant: 8\n", "MaximumVisibility: 30\n",
      "SignRadiance: 0\n", "SignReflectance: 0.8\n", "SignGroundReflectance: 0.1\n" });

  vtkNew<vtkAirlightDensityImage> density;
  density->SetArrayName("soot");
  density->SetDimensions(4, 5, 6);
  CheckPrint(density,
    { "ArrayName: soot\n", "Component: -1\n", "ComponentName: \n", "Factor: 1\n",
      "Dimensions: 4, 5, 6\n" });

  vtkNew<vtkLitIntervalsFilter> intervals;
  CheckPrint(intervals, { "Light: 0\n", "Medium: 0\n" });

  vtkNew<vtkAirlightReference> reference;
  CheckPrint(reference, { "Renderer: 0\n", "NumberOfMedia: 0\n" });
  reference->AddMedium(medium);
  reference->SetSize(12, 34);
  CheckPrint(reference, { "NumberOfMedia: 1\n", "Radius: 10.5\n", "Size: 12 x 34\n" });

  vtkNew<vtkAirlightComparison> comparison;
  comparison->SetSkipNonFinite(true);
  CheckPrint(comparison, { "SkipNonFinite: on\n" });
  comparison->SetSkipNonFinite(false);
  CheckPrint(comparison, { "SkipNonFinite: off\n" });

#ifdef AIRLIGHT_HAS_OPENVDB
  vtkNew<vtkOpenVDBDensityReader> reader;
  CheckPrint(reader, { "FileName: \n", "GridName: " });
  reader->SetFileName("smoke.vdb");
  reader->SetGridName("soot");
  reader->SetMaximumDimension(99);
  CheckPrint(reader, { "FileName: smoke.vdb\n", "GridName: soot\n", "MaximumDimension: 99\n" });
#endif

  vtkNew<vtkAirlight> airlight;
  CheckPrint(airlight, { "vtkAirlight" });
}
}

//------------------------------------------------------------------------------
int TestPrint(int, char*[])
{
  TestMedium();
  TestPass();
  TestFilters();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
