// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Renders with a delegate what IceT composites, and then moves the background slightly in front of
 * the far end of the depth buffer. IceT ignores pixels at that end, and would lose the medium in
 * front of an empty background.
 *
 * ParaView composites before black and puts the background behind the result by its opacity, which
 * is one number: coloured media would lose their colour before it. Where all is opaque, the
 * delegate draws the background.
 */

#ifndef AirlightFarPass_h
#define AirlightFarPass_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;

class AirlightFarPass : public vtkRenderPass
{
public:
  static AirlightFarPass* New();
  vtkTypeMacro(AirlightFarPass, vtkRenderPass);

  void SetDelegate(vtkRenderPass* delegate);
  // If off, the background stays where it is.
  void SetMoves(bool moves) { this->Moves = moves; }
  // If off, it clears the picture instead: another rank draws all of it. Selections draw on all.
  void SetDraws(bool draws) { this->Draws = draws; }
  // Draws before the background that the renderer has now, and leaves an opaque picture. Null:
  // before the one that it has then.
  void SetBackground(vtkRenderer* renderer);
  // Called after the delegate, before the background is moved.
  void SetRendered(const std::function<void()>& rendered) { this->Rendered = rendered; }

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  AirlightFarPass();
  ~AirlightFarPass() override;
  AirlightFarPass(const AirlightFarPass&) = delete;
  void operator=(const AirlightFarPass&) = delete;

  struct Background
  {
    double Colour[3] = { 0.0, 0.0, 0.0 };
    bool Gradient = false;
    bool Textured = false;
  };

  static Background GetBackground(vtkRenderer* renderer);
  static void PutBackground(vtkRenderer* renderer, const Background& background);
  void RenderScene(const vtkRenderState* s);
  void MoveBackground(vtkOpenGLRenderWindow* window);

  vtkSmartPointer<vtkRenderPass> Delegate;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::function<void()> Rendered;
  bool Moves = false;
  bool Draws = true;
  bool HasBackground = false;
  Background Kept;
};

#endif
