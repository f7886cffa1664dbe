// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The fixture for tests of whole pictures: a scene in a medium, drawn by vtkAirlightPass and
 * compared with AirlightTestBruteForce.h. AirlightTestBodies.h has bodies for it. Tests of single
 * pixels use AirlightTestPixelScene.h.
 */

#ifndef AirlightTestScene_h
#define AirlightTestScene_h

#include "AirlightTestBuffers.h"
#include "AirlightTestMeshes.h"

#include "vtkActor.h"
#include "vtkAirlightPass.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <functional>

namespace airlight_test
{
class Scene
{
public:
  explicit Scene(int width = 200, int height = 150);
  ~Scene();
  Scene(const Scene&) = delete;
  void operator=(const Scene&) = delete;

  void Look(const glm::dvec3& from, const glm::dvec3& to);

  ///@{
  /**
   * Lights. `towards` points to the light.
   */
  vtkLight* AddPointLight(
    const glm::dvec3& position, const glm::dvec3& intensity = glm::dvec3(40.0, 30.0, 20.0));
  vtkLight* AddDirectionalLight(
    const glm::dvec3& towards, const glm::dvec3& irradiance = glm::dvec3(3.0));
  vtkLight* AddLight(vtkLight* light);
  ///@}

  ///@{
  /**
   * Bodies, for the picture and for the reference: white and diffuse, one normal a triangle.
   * AddTriangles() is for the reference only, MakeActor() for neither.
   */
  static vtkSmartPointer<vtkActor> MakeActor(vtkMapper* mapper);
  static vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* data);
  vtkActor* Add(vtkPolyData* data, const std::function<void(vtkActor*)>& place = {});
  vtkActor* Add(vtkPolyDataAlgorithm* source, const std::function<void(vtkActor*)>& place = {});
  void AddTriangles(vtkPolyData* data, vtkMatrix4x4* matrix);
  ///@}

  ///@{
  /**
   * Coloured bodies, which ambient light that no light source sends reaches.
   */
  static void Paint(vtkActor* actor, const glm::dvec3& albedo, double ambient);
  vtkActor* AddBox(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& albedo);
  vtkActor* AddBall(const glm::dvec3& centre, double radius, const glm::dvec3& albedo);
  double AmbientLight = 0.0;
  ///@}

  ///@{
  /**
   * The ray of a point of the picture, in pixels from the lower left corner, or of a pixel's
   * middle; what it ought to see; and the pixel that shows a point.
   */
  Ray GetRay(double px, double py) const;
  Ray GetPixelRay(const glm::ivec2& pixel) const
  {
    return this->GetRay(pixel.x + 0.5, pixel.y + 0.5);
  }
  Answer GetAnswer(double px, double py);
  glm::ivec2 GetPixel(const glm::dvec3& point) const;
  ///@}

  ///@{
  /**
   * The last frame's buffers, all of them copied, and the 99th percentile of the largest components
   * of one. Render() is a frame and its copies.
   */
  vtkImageData* GetBuffer(const char* name) { return this->Pass->GetBuffer(name); }
  Buffers CopyBuffers();
  Buffers Render();
  double GetPercentile99(const char* name);
  ///@}

  // The picture with this as the renderer's pass, which may hold the scene's own.
  Picture Show(vtkRenderPass* pass);

  // Lets go of the OpenGL objects of a pass of VTK's, which complains otherwise.
  Picture ShowOnce(vtkRenderPass* pass);

  // The buffers stay as the pass writes them; the picture's edges are smoothed.
  void SmoothEdges();

  // A new renderer and a new pass in the same window, which keeps the shaders that it has compiled.
  // Of what was in the scene only the medium is left.
  void Restart();

  // A test's exit status, the picture's comparison with its baseline included.
  int Finish(int argc, char* argv[]);

  int Width;
  int Height;
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkAirlightPass> Pass;
  vtkNew<vtkParticipatingMedium> Medium;
  std::vector<vtkLight*> Lights;
  std::vector<Triangle> Triangles;

protected:
  bool ReleasesPass = false; // at the end, since the renderer may not know the pass any more

private:
  void ReleasePass();

  vtkNew<vtkOpenGLFXAAPass> Antialiased;
};

// In clip coordinates by VTK's own matrix: in a perspective w is the depth. `aspect`: of the
// picture, width by height.
glm::dvec4 Project(vtkCamera* camera, double aspect, const glm::dvec3& point);

// Whether it is in the picture, in or outside of the clipping range. Behind the eye no ray of a
// perspective comes along.
bool IsInPicture(const glm::dvec4& clip);

// A replacement that changes nothing in the actor's shader, of which the pass cannot know that.
void MakeUnknown(vtkActor* actor);
}

#endif
