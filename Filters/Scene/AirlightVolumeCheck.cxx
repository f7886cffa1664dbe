// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightVolumeCheck.h"

#include "vtkAbstractMapper.h"
#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneCollection.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <sstream>

namespace airlight
{
namespace
{
// Of mappers that cast rays on the graphics card; null for others.
vtkVolumeMapper* GetRayCaster(vtkVolume* volume)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  const bool known = mapper &&
    (mapper->IsA("vtkGPUVolumeRayCastMapper") || mapper->IsA("vtkSmartVolumeMapper") ||
      mapper->IsA("vtkMultiBlockVolumeMapper"));
  return known && !volume->IsA("vtkMultiVolume") ? vtkVolumeMapper::SafeDownCast(mapper) : nullptr;
}

std::string CheckMapper(vtkVolumeMapper* mapper)
{
  std::ostringstream text;
  if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    text << "its mapper's blend mode is " << mapper->GetBlendMode()
         << ", a projection without opacity along the way: call SetBlendModeToComposite()";
  }
  else if (mapper->GetCropping())
  {
    text << "its mapper crops it: call CroppingOff() and cut the image by vtkExtractVOI";
  }
  else if (mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0)
  {
    text << "its mapper has " << mapper->GetClippingPlanes()->GetNumberOfItems()
         << " clipping planes: call RemoveAllClippingPlanes() and cut the image by vtkExtractVOI";
  }
  else if (auto* caster = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    text << (caster->GetMaskInput()
        ? "its mapper has a mask: call SetMaskInput(nullptr) and set masked scalars to a value of "
          "opacity 0"
        : "");
  }
  return text.str();
}

// VTK makes a function that is 1 everywhere for those that have none.
bool DependsOnGradient(vtkVolumeProperty* property)
{
  // Without the first check, GetStoredGradientOpacity() would make one.
  vtkPiecewiseFunction* function =
    property->HasGradientOpacity() && !property->GetDisableGradientOpacity()
    ? property->GetStoredGradientOpacity()
    : nullptr;
  for (int i = 0; function && i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    if (node[1] != 1.0)
    {
      return true;
    }
  }
  return false;
}

std::string CheckProperty(vtkVolumeProperty* property)
{
  std::ostringstream text;
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    text << "its opacity depends on a 2D transfer function: call SetTransferFunctionModeTo1D() and "
            "SetScalarOpacity() of its vtkVolumeProperty";
  }
  else if (DependsOnGradient(property))
  {
    text << "its opacity depends on the gradient: call DisableGradientOpacityOn() of its "
            "vtkVolumeProperty";
  }
  else if (const double unit = property->GetScalarOpacityUnitDistance(); !(unit > 0.0))
  {
    text << "its ScalarOpacityUnitDistance is " << unit << ": give it a length above 0";
  }
  return text.str();
}

std::string CheckImage(vtkImageData* image)
{
  int size[3] = { 0, 0, 0 };
  std::ostringstream text;
  if (!image)
  {
    return "its mapper has no vtkImageData: connect one, or resample other data by "
           "vtkResampleToImage";
  }
  image->GetDimensions(size);
  if (size[0] < 2 || size[1] < 2 || size[2] < 2)
  {
    text << "its image has " << size[0] << " x " << size[1] << " x " << size[2]
         << " points: it needs at least 2 along each axis";
  }
  return text.str();
}

std::string CheckValues(vtkDataArray* values, bool ofCells, vtkIdType points)
{
  std::ostringstream text;
  if (!values || ofCells)
  {
    return std::string("its mapper draws ") + (values ? "scalars of cells" : "no scalars") +
      ": give the points scalars, for instance by vtkCellDataToPointData";
  }
  if (values->GetNumberOfComponents() != 1 || values->GetNumberOfTuples() != points)
  {
    text << "its scalars have " << values->GetNumberOfComponents() << " components and "
         << values->GetNumberOfTuples() << " tuples: one number for each of " << points
         << " points is needed, for instance by vtkImageExtractComponents";
    return text.str();
  }
  if (values->GetDataType() != VTK_FLOAT && values->GetDataType() != VTK_DOUBLE)
  {
    return std::string();
  }
  for (vtkIdType i = 0; i < points; ++i)
  {
    if (const double value = values->GetComponent(i, 0); !std::isfinite(value))
    {
      text << "scalar " << i << " is " << value << ": all must be finite";
      return text.str();
    }
  }
  return std::string();
}

std::string Find(vtkVolume* volume, VolumeScalars& scalars)
{
  vtkVolumeMapper* mapper = GetRayCaster(volume);
  if (!mapper)
  {
    return std::string("it is drawn by ") +
      (volume->GetMapper() ? volume->GetMapper()->GetClassName() : "no mapper") +
      ": give it a vtkSmartVolumeMapper or a vtkGPUVolumeRayCastMapper with an image";
  }
  if (mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->Update();
  }
  std::string error = CheckMapper(mapper);
  error = error.empty() ? CheckProperty(volume->GetProperty()) : error;
  auto* image = vtkImageData::SafeDownCast(
    mapper->GetNumberOfInputConnections(0) > 0 ? mapper->GetInputDataObject(0, 0) : nullptr);
  error = error.empty() ? CheckImage(image) : error;
  if (!error.empty())
  {
    return error;
  }
  int ofCells = 0;
  vtkDataArray* values = vtkAbstractMapper::GetScalars(image, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), ofCells);
  error = CheckValues(values, ofCells != 0, image->GetNumberOfPoints());
  if (error.empty())
  {
    scalars = { image, values };
  }
  return error;
}

std::string Describe(vtkVolume* volume, const char* what, const std::string& reason)
{
  std::ostringstream text;
  text << "The " << volume->GetClassName() << " (" << volume << ") " << what << ", as " << reason
       << ".";
  return text.str();
}
}

//------------------------------------------------------------------------------
VolumeScalars FindVolumeScalars(vtkVolume* volume, std::string& reason)
{
  VolumeScalars scalars;
  reason = Find(volume, scalars);
  return scalars;
}

//------------------------------------------------------------------------------
std::string DescribeNoShadow(vtkVolume* volume, const std::string& reason)
{
  return Describe(volume, "casts no shadow", reason);
}

//------------------------------------------------------------------------------
std::string DescribeNoMedium(vtkVolume* volume, const std::string& reason)
{
  return Describe(
    volume, "does not scatter light and is drawn as without SetVolumeScatters()", reason);
}
}
