// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSilhouetteEdgesFilter.h"

#include "Medium/AirlightConvert.h"
#include "Scene/AirlightVTKVersions.h"
#include "Silhouette/AirlightMeshCache.h"
#include "Silhouette/AirlightSilhouette.h"
#include "Silhouette/AirlightWritePieces.h"

#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{
// How much of the work the preparation of the mesh is.
constexpr double MeshProgress = 0.8;
}

class vtkSilhouetteEdgesFilter::Internals
{
public:
  vtkSmartPointer<vtkLight> Light;
  airlight::MeshCache Meshes;
  int Depth = 0; // of executions: those of blocks are nested in that of the composite data
};

vtkStandardNewMacro(vtkSilhouetteEdgesFilter);

//------------------------------------------------------------------------------
vtkSilhouetteEdgesFilter::vtkSilhouetteEdgesFilter()
  : Internal(new Internals)
{
  // Nothing else tells when the last block of composite data is done.
  this->AddObserver(vtkCommand::StartEvent, this, &vtkSilhouetteEdgesFilter::BeginExecution);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkSilhouetteEdgesFilter::EndExecution);
}

//------------------------------------------------------------------------------
vtkSilhouetteEdgesFilter::~vtkSilhouetteEdgesFilter() = default;

//------------------------------------------------------------------------------
void vtkSilhouetteEdgesFilter::BeginExecution()
{
  if (this->Internal->Depth++ == 0)
  {
    this->Internal->Meshes.MarkUnused();
  }
}

//------------------------------------------------------------------------------
void vtkSilhouetteEdgesFilter::EndExecution()
{
  if (--this->Internal->Depth == 0)
  {
    this->Internal->Meshes.EraseUnused();
  }
}

//------------------------------------------------------------------------------
void vtkSilhouetteEdgesFilter::SetLight(vtkLight* light)
{
  if (this->Internal->Light != light)
  {
    this->Internal->Light = light;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkLight* vtkSilhouetteEdgesFilter::GetLight() { return this->Internal->Light; }

//------------------------------------------------------------------------------
bool vtkSilhouetteEdgesFilter::SetVector(
  const char* name, double x, double y, double z, double vector[3])
{
  if (!airlight::IsModerate({ x, y, z }))
  {
    vtkErrorMacro(<< name << " (" << x << ", " << y << ", " << z
                  << ") must be finite and at most 1e100; the old values stay.");
    return false;
  }
  const double values[3] = { x, y, z };
  if (!std::equal(values, values + 3, vector))
  {
    std::copy(values, values + 3, vector);
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkSilhouetteEdgesFilter::SetLightPosition(double x, double y, double z)
{
  this->SetVector("LightPosition", x, y, z, this->LightPosition);
}

//------------------------------------------------------------------------------
void vtkSilhouetteEdgesFilter::SetLightPosition(const double position[3])
{
  this->SetLightPosition(position[0], position[1], position[2]);
}

//------------------------------------------------------------------------------
void vtkSilhouetteEdgesFilter::SetLightDirection(double x, double y, double z)
{
  this->SetVector("LightDirection", x, y, z, this->LightDirection);
}

//------------------------------------------------------------------------------
void vtkSilhouetteEdgesFilter::SetLightDirection(const double direction[3])
{
  this->SetLightDirection(direction[0], direction[1], direction[2]);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkSilhouetteEdgesFilter::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (vtkLight* light = this->Internal->Light)
  {
    time = std::max(time, light->GetMTime());
    if (vtkMatrix4x4* matrix = light->GetTransformMatrix())
    {
      time = std::max(time, matrix->GetMTime());
    }
  }
  return time;
}

//------------------------------------------------------------------------------
// The light as a homogeneous point.
bool vtkSilhouetteEdgesFilter::FindLight(double light[4])
{
  glm::dvec3 position(this->LightPosition[0], this->LightPosition[1], this->LightPosition[2]);
  glm::dvec3 axis(this->LightDirection[0], this->LightDirection[1], this->LightDirection[2]);
  bool positional = axis == glm::dvec3(0.0);
  if (vtkLight* source = this->Internal->Light)
  {
    glm::dvec3 focalPoint;
    source->GetTransformedPosition(&position.x);
    source->GetTransformedFocalPoint(&focalPoint.x);
    axis = focalPoint - position;
    positional = source->GetPositional() != 0;
    if (!airlight::IsModerate(position) || !(positional || airlight::IsModerate(axis)))
    {
      vtkErrorMacro(<< "The light's position (" << position.x << ", " << position.y << ", "
                    << position.z << ") or focal point (" << focalPoint.x << ", " << focalPoint.y
                    << ", " << focalPoint.z
                    << ") is not finite or above 1e100: set others. The output is empty.");
      return false;
    }
  }
  const glm::dvec3 size = glm::abs(axis);
  const double largest = std::max({ size.x, size.y, size.z });
  if (!positional && largest == 0.0)
  {
    vtkErrorMacro(<< "The directional light's position and focal point are both (" << position.x
                  << ", " << position.y << ", " << position.z
                  << "): move one of them. The output is empty.");
    return false;
  }
  // First to a size whose square neither vanishes nor overflows.
  const glm::dvec4 result =
    positional ? glm::dvec4(position, 1.0) : glm::dvec4(-glm::normalize(axis / largest), 0.0);
  std::copy(&result.x, &result.x + 4, light);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSilhouetteEdgesFilter::IsOnMesh(const airlight::CasterMesh& mesh, const double light[4])
{
  const int triangle =
    light[3] != 0.0 ? airlight::FindTriangleAt(mesh, { light[0], light[1], light[2] }) : -1;
  if (triangle < 0)
  {
    return false;
  }
  const std::array<int, 3>& t = mesh.Triangles[triangle];
  vtkErrorMacro(<< "The light at (" << light[0] << ", " << light[1] << ", " << light[2]
                << ") lies on the input's triangle of the points " << mesh.SourcePoints[t[0]]
                << ", " << mesh.SourcePoints[t[1]] << " and " << mesh.SourcePoints[t[2]]
                << ", where shadows are undefined: move it off the mesh. The output is empty.");
  return true;
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::CasterMesh> vtkSilhouetteEdgesFilter::GetMesh(vtkPolyData* input)
{
  return this->Internal->Meshes.Get(input, [this](double progress) {
    this->UpdateProgress(MeshProgress * progress);
    return !airlight::IsAborted(this);
  });
}

//------------------------------------------------------------------------------
bool vtkSilhouetteEdgesFilter::CheckProperties() { return true; }

//------------------------------------------------------------------------------
int vtkSilhouetteEdgesFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  double light[4];
  if (!this->CheckProperties() || !this->FindLight(light) || !input ||
    input->GetNumberOfCells() == 0)
  {
    return 1;
  }
  const std::shared_ptr<const airlight::CasterMesh> mesh = this->GetMesh(input);
  if (!mesh) // aborted
  {
    return 1;
  }
  if (mesh->Triangles.empty())
  {
    vtkErrorMacro(<< "The input has " << input->GetNumberOfCells() << " cells, but no triangle of "
                  << "three different finite points: give it polygons or strips. The output is "
                  << "empty.");
    return 1;
  }
  if (!this->IsOnMesh(*mesh, light))
  {
    this->MakeOutput(*mesh, light, input, output);
    if (airlight::IsAborted(this))
    {
      output->Initialize();
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkSilhouetteEdgesFilter::MakeOutput(
  const airlight::CasterMesh& mesh, const double light[4], vtkPolyData* input, vtkPolyData* output)
{
  airlight::WriteLines(mesh,
    airlight::FindSilhouette(mesh, { light[0], light[1], light[2], light[3] }), input, output);
}

//------------------------------------------------------------------------------
void vtkSilhouetteEdgesFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Light: " << this->Internal->Light.Get() << "\n";
  const double* position = this->LightPosition;
  os << indent << "LightPosition: (" << position[0] << ", " << position[1] << ", " << position[2]
     << ")\n";
  const double* direction = this->LightDirection;
  os << indent << "LightDirection: (" << direction[0] << ", " << direction[1] << ", "
     << direction[2] << ")\n";
}
