// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A surface drawn by vtkAirlightPolyDataMapper into a target of single precision, and what each
 * pixel ought to show: the nearest triangle on its ray, then vtkAirlight in double precision, which
 * its own tests compare with quadrature.
 */

#ifndef AirlightTestMapper_h
#define AirlightTestMapper_h

#include "AirlightTestPixelScene.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkAirlightPolyDataMapper.h"
#include "vtkFramebufferPass.h"
#include "vtkLightCollection.h"
#include "vtkPixelBufferObject.h"
#include "vtkPlaneSource.h"
#include "vtkRenderStepsPass.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

namespace airlight_test
{
using FloatPicture = std::vector<float>; // RGBA

// A pixel that shows the surface, and how far that is along the pixel's ray.
struct MapperSample
{
  int I, J;
  PixelRay Ray;
  double Depth;
};

class MapperScene : public PixelScene
{
public:
  MapperScene()
  {
    this->Framebuffer->SetDelegatePass(this->Steps);
    this->Framebuffer->SetColorFormat(vtkTextureObject::Float32);
    this->Framebuffer->SetDepthFormat(vtkTextureObject::Fixed32);
    this->Renderer->SetPass(this->Framebuffer);
    this->Medium->SetScattering(0.05, 0.07, 0.1);
    this->Medium->SetAbsorption(0.02, 0.02, 0.01);
    this->Medium->SetAmbientRadiance(0.1, 0.2, 0.3);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 1.0, 10.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(40.0);
    camera->SetParallelScale(3.0);
    camera->SetClippingRange(0.1, 200.0);
  }

  ~MapperScene()
  {
    this->Framebuffer->ReleaseGraphicsResources(this->Window);
    this->Steps->ReleaseGraphicsResources(this->Window);
  }

  // Unlit, of this colour: then all that is not the surface's own is the medium's.
  vtkActor* Add(vtkPolyData* data)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    vtkNew<vtkAirlightPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetMedium(this->Medium);
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(&this->Colour.x);
    this->Renderer->AddActor(actor);
    this->Triangles = GetTriangles(data, actor->GetMatrix());
    this->Mapper = mapper;
    this->Actor = actor;
    return actor;
  }

  vtkLight* AddPointLight(const glm::dvec3& position, const glm::dvec3& intensity)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    vtkAirlight::SetRadiantIntensity(light, &intensity.x);
    light->SetPosition(position.x, position.y, position.z);
    this->Renderer->AddLight(light);
    return light;
  }

  FloatPicture Render()
  {
    this->Window->Render();
    vtkTextureObject* texture = this->Framebuffer->GetColorTexture();
    FloatPicture picture(4 * Width * Height);
    unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
    vtkIdType increments[2] = { 0, 0 };
    if (!Check(size[0] == Width && size[1] == Height, "the target has the window's size"))
    {
      return picture;
    }
    vtkPixelBufferObject* pixels = texture->Download();
    pixels->Download2D(VTK_FLOAT, picture.data(), size, 4, increments);
    pixels->Delete();
    return picture;
  }

  // Distance of the nearest triangle; Infinity without one.
  double GetDepth(double i, double j)
  {
    const PixelRay ray = this->GetRay(i, j);
    double depth = Infinity;
    for (const Triangle& triangle : this->Triangles)
    {
      const double t = Hit(triangle, { ray.Origin, ray.Direction });
      depth = t > 0.0 ? std::min(depth, t) : depth;
    }
    return depth;
  }

  // Every third pixel (the width is no multiple of three) that the surface covers with some margin:
  // rasterisation may round its edges.
  std::vector<MapperSample> GetSamples()
  {
    std::vector<MapperSample> samples;
    for (int pixel = 0; pixel < Width * Height; pixel += 3)
    {
      const int i = pixel % Width;
      const int j = pixel / Width;
      bool covers = true;
      for (int corner = 0; corner < 4 && covers; ++corner)
      {
        covers = std::isfinite(
          this->GetDepth(i + (corner % 2 ? 0.3 : -0.3), j + (corner / 2 ? 0.3 : -0.3)));
      }
      const double depth = covers ? this->GetDepth(i, j) : Infinity;
      if (std::isfinite(depth))
      {
        samples.push_back({ i, j, this->GetRay(i, j), depth });
      }
    }
    return samples;
  }

  // The light that the medium scatters into [0, t] of a ray, of all lights and of ambient light.
  glm::dvec3 GetAirlight(const PixelRay& ray, double t)
  {
    glm::dvec3 sum;
    vtkAirlight::Ambient(this->Medium, &ray.Origin.x, &ray.Direction.x, t, &sum.x);
    vtkLightCollection* lights = this->Renderer->GetLights();
    for (int k = 0; k < lights->GetNumberOfItems(); ++k)
    {
      auto* light = static_cast<vtkLight*>(lights->GetItemAsObject(k));
      glm::dvec3 one;
      vtkAirlight::Inscatter(this->Medium, light, &ray.Origin.x, &ray.Direction.x, 0.0, t, &one.x);
      sum += one;
    }
    return sum;
  }

  glm::dvec3 GetTransmittance(const PixelRay& ray, double t)
  {
    const glm::dvec3 end = ray.Origin + t * ray.Direction;
    glm::dvec3 passes;
    vtkAirlight::Transmittance(this->Medium, &ray.Origin.x, &end.x, &passes.x);
    return passes;
  }

  // What a fragment of this colour shows at the distance t.
  glm::dvec3 Fog(const PixelRay& ray, double t, const glm::dvec3& colour)
  {
    return colour * this->GetTransmittance(ray, t) + this->GetAirlight(ray, t);
  }

  // Compares a frame with what the samples ought to show, against `limit` of it.
  void Compare(const std::string& what, const std::vector<MapperSample>& samples, double limit,
    Comparison& comparison)
  {
    const FloatPicture picture = this->Render();
    for (const MapperSample& sample : samples)
    {
      CompareColour(what, sample, picture, this->Fog(sample.Ray, sample.Depth, this->Colour), limit,
        comparison);
    }
  }

  static void CompareColour(const std::string& what, const MapperSample& sample,
    const FloatPicture& picture, const glm::dvec3& expected, double limit, Comparison& comparison)
  {
    for (int k = 0; k < 3; ++k)
    {
      const float got = picture[4 * (sample.J * Width + sample.I) + k];
      comparison.Add(std::abs(got - expected[k]), limit * expected[k], [&] {
        return Text(what, ", pixel ", sample.I, " ", sample.J, ", channel ", k, ": expected ",
          expected[k], ", got ", got);
      });
    }
  }

  vtkNew<vtkFramebufferPass> Framebuffer;
  vtkNew<vtkRenderStepsPass> Steps;
  glm::dvec3 Colour{ 0.3, 0.2, 0.6 };
  std::vector<Triangle> Triangles; // of the actor that was added last
  vtkAirlightPolyDataMapper* Mapper = nullptr;
  vtkActor* Actor = nullptr;
};

//------------------------------------------------------------------------------
// A pixel of a window of eight bits a channel; the limit in steps of these.
inline void CompareWindow(const std::string& what, const Picture& picture, int width, int x, int y,
  const glm::dvec3& expected, double steps, Comparison& comparison)
{
  for (int k = 0; k < 3; ++k)
  {
    const int got = picture[3 * (y * width + x) + k];
    comparison.Add(std::abs(got / 255.0 - std::min(expected[k], 1.0)), steps / 255.0, [&] {
      return Text(what, ", pixel ", x, " ", y, ": expected ", 255.0 * expected[k], ", got ", got);
    });
  }
}

//------------------------------------------------------------------------------
// A plane that leans; `resolution` quadrilaterals a side.
inline vtkSmartPointer<vtkPolyData> MakePlane(int resolution, double z = -1.0)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-4.0, -3.0, z + 1.0);
  plane->SetPoint1(4.0, -3.0, z + 0.4);
  plane->SetPoint2(-4.0, 3.0, z - 1.0);
  plane->SetResolution(resolution, resolution);
  return Make(plane);
}
}

#endif
