// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightPolyDataMapper.h"

#include "Integration/AirlightMatrix.h"
#include "MapperShaders/AirlightPolyDataMapperShader.h"
#include "Medium/AirlightMediaMethods.h"
#include "vtkAirlightLight.h"
#include "vtkAirlightPass.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>

using namespace airlight;

class vtkAirlightPolyDataMapper::Internals : public PolyDataMapperShader
{
};

namespace
{
bool IsDrawnByPass(vtkActor* actor)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  const int count = keys && keys->Has(passes) ? keys->Length(passes) : 0;
  for (int i = 0; i < count; ++i)
  {
    if (vtkAirlightPass::SafeDownCast(keys->Get(passes, i)))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkAirlightPolyDataMapper);

vtkAirlightPolyDataMapper::vtkAirlightPolyDataMapper()
  : Impl(new Internals)
{
}

vtkAirlightPolyDataMapper::~vtkAirlightPolyDataMapper() { this->Impl->SetWindow(nullptr); }

//------------------------------------------------------------------------------
AirlightMediaMethodsMacro(vtkAirlightPolyDataMapper);

//------------------------------------------------------------------------------
void vtkAirlightPolyDataMapper::SetEvaluation(int evaluation)
{
  if (evaluation != FRAGMENT && evaluation != VERTEX)
  {
    vtkErrorMacro(<< "Evaluation " << evaluation << " is unknown: use FRAGMENT or VERTEX.");
    return;
  }
  if (this->Evaluation != evaluation)
  {
    this->Evaluation = evaluation;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPolyDataMapper::SetLightScatters(vtkLight* light, bool scatters)
{
  if (!light)
  {
    vtkErrorMacro("SetLightScatters() needs a light; it got null.");
    return;
  }
  vtkAirlightLight::SetScatters(light, scatters);
}

bool vtkAirlightPolyDataMapper::GetLightScatters(vtkLight* light)
{
  return vtkAirlightLight::GetScatters(light);
}

//------------------------------------------------------------------------------
void vtkAirlightPolyDataMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkAirlightPolyDataMapper::SafeDownCast(mapper))
  {
    this->Impl->Media = other->Impl->Media;
    this->SetEvaluation(other->GetEvaluation());
    this->SetLightRadius(other->GetLightRadius());
  }
  this->Superclass::ShallowCopy(mapper);
}

//------------------------------------------------------------------------------
void vtkAirlightPolyDataMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& impl = *this->Impl;
  impl.Shades = false;
  if (impl.Media.GetSize() == 0 || renderer->GetSelector() || IsDrawnByPass(actor))
  {
    this->Superclass::RenderPiece(renderer, actor);
    return;
  }
  impl.SetWindow(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  impl.Shades = impl.Prepare(renderer, this->LightRadius);
  impl.Check(this);
  impl.Retries = impl.NotCompiled;
  impl.NotCompiled = false;

  vtkTextureObject* data = impl.Shades ? impl.Arrays.GetTexture() : nullptr;
  if (data)
  {
    data->Activate();
  }
  this->Superclass::RenderPiece(renderer, actor);
  if (data)
  {
    data->Deactivate();
  }
  impl.CheckShaders(this);
}

//------------------------------------------------------------------------------
bool vtkAirlightPolyDataMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  const bool rebuild = this->Superclass::GetNeedToRebuildShaders(cellBO, renderer, actor);
  Internals::Build& built = this->Impl->Built[&cellBO];
  const Internals::Build now{ this->Impl->Shades, this->Impl->OptionsVersion };
  const bool other = built.Shades != now.Shades ||
    (now.Shades && built.OptionsVersion != now.OptionsVersion) || this->Impl->Retries;
  built = now;
  return rebuild || other;
}

//------------------------------------------------------------------------------
// After the superclass's own text and before other passes' turns: those of translucent surfaces
// replace the marker that the medium is put at.
void vtkAirlightPolyDataMapper::ReplaceShaderRenderPass(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor,
  bool prePass)
{
  if (!prePass && this->Impl->Shades)
  {
    SurfaceShaderOptions options = this->Impl->Options;
    options.AtVertices =
      this->Evaluation == VERTEX && shaders[vtkShader::Geometry]->GetSource().empty();
    std::string vertexShader = shaders[vtkShader::Vertex]->GetSource();
    std::string fragmentShader = shaders[vtkShader::Fragment]->GetSource();
    InjectSurfaceShader(fragmentShader, options);
    if (options.AtVertices)
    {
      InjectVertexShader(vertexShader, options);
    }
    if (this->Impl->Compiles(
          actor, vertexShader, fragmentShader, shaders[vtkShader::Geometry]->GetSource()))
    {
      shaders[vtkShader::Vertex]->SetSource(vertexShader);
      shaders[vtkShader::Fragment]->SetSource(fragmentShader);
    }
  }
  this->Superclass::ReplaceShaderRenderPass(shaders, renderer, actor, prePass);
}

//------------------------------------------------------------------------------
void vtkAirlightPolyDataMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(cellBO, renderer, actor);
  if (!this->Impl->Shades)
  {
    return;
  }
  const SurfaceUniforms values = this->Impl->GetUniforms();
  SetSurfaceUniforms(cellBO.Program, values);

  // From the vertices' buffer, in which VTK may have shifted and scaled them; VTK keeps the inverse
  // transposed. The eye is subtracted in double precision.
  glm::dmat4 vertexToEye = ToGlm(actor->GetMatrix());
  vtkOpenGLVertexBufferObject* buffer = this->VBOs->GetVBO("vertexMC");
  if (buffer && buffer->GetCoordShiftAndScaleEnabled())
  {
    vertexToEye = vertexToEye * glm::transpose(ToGlm(this->VBOShiftScale));
  }
  vertexToEye[3] -= glm::dvec4(values.Rays->GetEye(), 0.0);
  glm::mat4 matrix(vertexToEye);
  cellBO.Program->SetUniformMatrix4x4("airlightVertexToEye", &matrix[0].x);
}

//------------------------------------------------------------------------------
void vtkAirlightPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  // What is there for another window stays, while the superclass changes windows.
  if (window == this->Impl->Window)
  {
    this->Impl->Arrays.Release(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkAirlightPolyDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMedia: " << this->GetNumberOfMedia() << "\n";
  for (vtkParticipatingMedium* medium : this->Impl->Media.GetAll())
  {
    medium->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Evaluation: " << (this->Evaluation == VERTEX ? "Vertex" : "Fragment") << "\n";
  os << indent << "LightRadius: " << this->LightRadius << "\n";
}
