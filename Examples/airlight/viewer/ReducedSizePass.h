// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReducedSizePass_h
#define ReducedSizePass_h

#include <vtkImageProcessingPass.h>
#include <vtkNew.h>
#include <vtkOverlayPass.h>
#include <vtkSmartPointer.h>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace airlight
{

/**
 * Renders its delegate with fewer and larger pixels, interpolated between, and annotations over
 * them in the window's own. With pixels of size 1 the picture is the delegate's own, annotations
 * included; else the delegate has to leave them out (vtkAirlightPass::AnnotationsOff()).
 */
class ReducedSizePass : public vtkImageProcessingPass
{
public:
  static ReducedSizePass* New();
  vtkTypeMacro(ReducedSizePass, vtkImageProcessingPass);

  /**
   * Width and height of a pixel in those of the window. Range: at least 1. Default: 1.
   */
  void SetPixelSize(int size) { this->PixelSize = size; }
  int GetPixelSize() const { return this->PixelSize; }

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  void Resize(vtkOpenGLRenderWindow* window, int width, int height);
  void RenderSmall(const vtkRenderState* s, vtkOpenGLRenderWindow* window, int width, int height);
  void Enlarge(vtkRenderer* renderer, vtkOpenGLRenderWindow* window);

  int PixelSize = 1;
  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOverlayPass> Overlay;
};

}

#endif
