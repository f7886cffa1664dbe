// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK's fragment shaders as vtkAirlightPass sees them.
 */

#ifndef AirlightTestShaderCapture_h
#define AirlightTestShaderCapture_h

#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <string>

namespace airlight_test
{
// Before and after VTK fills in the template.
struct FragmentShader
{
  std::string Template;
  std::string Filled;
};

// Draws the scene, for a vtkCameraPass, and keeps the shader of what is drawn last.
class ShaderCapture : public vtkOpenGLRenderPass
{
public:
  static ShaderCapture* New() { VTK_STANDARD_NEW_BODY(ShaderCapture); }
  vtkTypeMacro(ShaderCapture, vtkOpenGLRenderPass);

  void Render(const vtkRenderState* s) override
  {
    this->PreRender(s);
    this->Lights->Render(s);
    this->Opaque->Render(s);
    this->Translucent->Render(s);
    this->Volumetric->Render(s);
    this->PostRender(s);
  }

  bool PreReplaceShaderValues(std::string& /*vertex*/, std::string& /*geometry*/,
    std::string& fragment, vtkAbstractMapper* /*mapper*/, vtkProp* /*prop*/) override
  {
    this->Last.Template = fragment;
    return true;
  }

  bool PostReplaceShaderValues(std::string& /*vertex*/, std::string& /*geometry*/,
    std::string& fragment, vtkAbstractMapper* /*mapper*/, vtkProp* /*prop*/) override
  {
    this->Last.Filled = fragment;
    return true;
  }

  FragmentShader Last;

private:
  vtkNew<vtkLightsPass> Lights;
  vtkNew<vtkOpaquePass> Opaque;
  vtkNew<vtkTranslucentPass> Translucent;
  vtkNew<vtkVolumetricPass> Volumetric;
};
}

#endif
