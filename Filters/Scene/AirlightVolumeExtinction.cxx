// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightVolumeExtinction.h"

#include "Density/AirlightTrilinear.h"
#include "Integration/AirlightMatrix.h"
#include "Scene/AirlightVolumeOpacity.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace airlight
{
namespace
{
constexpr double MostSamples = 2097152.0; // 128^3
constexpr int Finest = 4;
// Samples are refined until optical depths across the image are no more wrong than this.
constexpr double Tolerance = 1e-3;
constexpr int TestPoints = 4000;
constexpr int MostAge = 4;

// Extinctions on a grid over the volume.
struct ExtinctionSamples
{
  glm::ivec3 Size;
  glm::dvec3 Step; // in the volume's points
  std::vector<float> Values;
  std::vector<glm::vec3> Colours; // where these are asked for
};

// At most MostSamples.
glm::ivec3 GetCoarseSize(const glm::ivec3& volume)
{
  const double count = static_cast<double>(volume.x) * volume.y * volume.z;
  const double scale = count > MostSamples ? std::cbrt(MostSamples / count) : 1.0;
  return glm::max(glm::ivec3(scale * glm::dvec3(volume)), 2);
}

// A sample stands for what is around it: where samples are farther apart than points, for several
// places. Returns their number.
template <typename Visit>
int VisitPlaces(const glm::dvec3& middle, const glm::dvec3& step, const Visit& visit)
{
  const glm::ivec3 parts(glm::ceil(step - 1e-9));
  const glm::dvec3 part = step / glm::dvec3(parts);
  const int count = parts.x * parts.y * parts.z;
  for (int k = 0; k < count; ++k)
  {
    const glm::dvec3 at(k % parts.x, k / parts.x % parts.y, k / (parts.x * parts.y));
    visit(middle + (at - 0.5 * glm::dvec3(parts - 1)) * part);
  }
  return count;
}

double GetMean(const VolumeOpacity& opacity, const glm::dvec3& middle, const glm::dvec3& step)
{
  double sum = 0.0;
  const int count = VisitPlaces(
    middle, step, [&](const glm::dvec3& place) { sum += opacity.GetExtinction(place); });
  return sum / count;
}

glm::dvec3 GetMeanColour(
  const VolumeOpacity& opacity, const glm::dvec3& middle, const glm::dvec3& step)
{
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  VisitPlaces(middle, step, [&](const glm::dvec3& place) {
    const double weight = opacity.GetExtinction(place);
    sum += weight * opacity.GetColour(place);
    weights += weight;
  });
  return weights > 0.0 ? sum / weights : opacity.GetColour(middle);
}

ExtinctionSamples Sample(const VolumeOpacity& opacity, const glm::ivec3& size, bool colours)
{
  ExtinctionSamples samples{ size, glm::dvec3(opacity.GetSize() - 1) / glm::dvec3(size - 1), {},
    {} };
  samples.Values.resize(static_cast<size_t>(size.x) * size.y * size.z);
  samples.Colours.resize(colours ? samples.Values.size() : 0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(size.y) * size.z, [&](vtkIdType a, vtkIdType b) {
    for (vtkIdType row = a; row < b; ++row)
    {
      for (int i = 0; i < size.x; ++i)
      {
        const glm::dvec3 place(i, row % size.y, row / size.y);
        samples.Values[row * size.x + i] =
          static_cast<float>(GetMean(opacity, place * samples.Step, samples.Step));
        if (colours)
        {
          samples.Colours[row * size.x + i] =
            GetMeanColour(opacity, place * samples.Step, samples.Step);
        }
      }
    }
  });
  return samples;
}

// The root of the mean square of what is wrong at places spread evenly: multiples, modulo 1, of the
// inverse powers of the root of x^4 = x + 1.
double GetError(const VolumeOpacity& opacity, const ExtinctionSamples& samples)
{
  const glm::dvec3 advance(0.8191725133961645, 0.6710436067037890, 0.5497004779019701);
  double squares = 0.0;
  for (int i = 1; i <= TestPoints; ++i)
  {
    const glm::dvec3 place = glm::fract(double(i) * advance) * glm::dvec3(samples.Size - 1);
    const double extinction = opacity.GetExtinction(place * samples.Step);
    const double sampled = InterpolateTrilinearly(samples.Values, samples.Size, place);
    double error = std::abs(sampled - extinction);
    if (!samples.Colours.empty())
    {
      // What is scattered counts, too.
      const glm::dvec3 off = glm::abs(
        sampled * InterpolateTrilinearly<glm::dvec3>(samples.Colours, samples.Size, place) -
        extinction * opacity.GetColour(place * samples.Step));
      error = std::max({ error, off.x, off.y, off.z });
    }
    squares += error * error;
  }
  return std::sqrt(squares / TestPoints);
}

// As coarse as the tolerance allows. The errors of a way's cells partly cancel.
ExtinctionSamples Refine(const VolumeOpacity& opacity, bool colours, int& refinement)
{
  const glm::ivec3& size = opacity.GetSize();
  const glm::ivec3 coarse = GetCoarseSize(size);
  const double length = glm::length(glm::dmat3(opacity.GetToWorld()) * glm::dvec3(size - 1));
  ExtinctionSamples samples = Sample(opacity, coarse, colours);
  refinement = 1;
  while (coarse == size && 2 * refinement <= Finest)
  {
    const glm::ivec3 next = 2 * refinement * (size - 1) + 1;
    const bool fits = static_cast<double>(next.x) * next.y * next.z <= MostSamples;
    const double cells = glm::length(glm::dvec3(samples.Size - 1));
    if (!fits || GetError(opacity, samples) * length / std::sqrt(cells) <= Tolerance)
    {
      break;
    }
    refinement *= 2;
    samples = Sample(opacity, next, colours);
  }
  return samples;
}

// The samples divided by `largest`.
vtkSmartPointer<vtkImageData> MakeImage(
  const ExtinctionSamples& samples, const glm::dmat4& toWorld, float largest)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(samples.Size.x, samples.Size.y, samples.Size.z);
  image->SetOrigin(toWorld[3].x, toWorld[3].y, toWorld[3].z);
  vtkNew<vtkMatrix3x3> directions;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      directions->SetElement(row, axis, toWorld[axis][row] * samples.Step[axis]);
    }
  }
  image->SetDirectionMatrix(directions);
  vtkNew<vtkFloatArray> densities;
  densities->SetNumberOfTuples(static_cast<vtkIdType>(samples.Values.size()));
  std::transform(samples.Values.begin(), samples.Values.end(), densities->GetPointer(0),
    [largest](float value) { return value / largest; });
  image->GetPointData()->SetScalars(densities);
  return image;
}

void AddColours(const ExtinctionSamples& samples, vtkImageData* image)
{
  vtkNew<vtkFloatArray> albedos;
  albedos->SetName(VolumeAlbedos);
  albedos->SetNumberOfComponents(3);
  albedos->SetNumberOfTuples(static_cast<vtkIdType>(samples.Colours.size()));
  for (size_t i = 0; i < samples.Colours.size(); ++i)
  {
    std::copy_n(&samples.Colours[i].x, 3, albedos->GetPointer(3 * static_cast<vtkIdType>(i)));
  }
  image->GetPointData()->AddArray(albedos);
}
}

//------------------------------------------------------------------------------
// A volume's property counts the times of its functions, the mapper not that of its input.
vtkMTimeType GetVolumeTime(vtkVolume* volume)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  vtkMTimeType time = volume->GetProperty()->GetMTime();
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->Update();
    vtkDataObject* input = mapper->GetInputDataObject(0, 0);
    time = std::max(time, input ? input->GetMTime() : 0);
  }
  return std::max(time, mapper ? mapper->GetMTime() : 0);
}

//------------------------------------------------------------------------------
VolumeImage MakeVolumeImage(
  vtkVolume* volume, vtkMatrix4x4* toWorld, bool colours, std::string& reason)
{
  VolumeImage result;
  const VolumeScalars scalars = FindVolumeScalars(volume, reason);
  const double size = glm::determinant(glm::dmat3(ToGlm(toWorld)));
  if (reason.empty() && (!std::isfinite(size) || size == 0.0))
  {
    reason = "its matrix makes it flat: give it a scale and a matrix that can be inverted";
  }
  if (!reason.empty())
  {
    return result;
  }
  const VolumeOpacity opacity(volume, scalars, toWorld, colours);
  const ExtinctionSamples samples = Refine(opacity, colours, result.Refinement);
  const float largest = *std::max_element(samples.Values.begin(), samples.Values.end());
  if (largest > 0.0f)
  {
    result.SigmaT = largest;
    result.Image = MakeImage(samples, opacity.GetToWorld(), largest);
    if (colours)
    {
      AddColours(samples, result.Image);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::shared_ptr<const VolumeExtinction> VolumeExtinction::Build(
  vtkVolume* volume, vtkMatrix4x4* toWorld, std::string& error)
{
  std::string reason;
  const VolumeImage image = MakeVolumeImage(volume, toWorld, false, reason);
  auto result = std::make_shared<VolumeExtinction>();
  result->SigmaT = image.SigmaT;
  result->Refinement = image.Refinement;
  result->Grid = image.Image ? DensityGrid::Build(image.Image, reason) : nullptr;
  if (image.Image && !result->Grid)
  {
    reason = "its image " + reason;
  }
  error = reason.empty() ? error : DescribeNoShadow(volume, reason);
  return result->Grid ? result : nullptr;
}

//------------------------------------------------------------------------------
std::shared_ptr<const VolumeExtinction> VolumeExtinctions::Get(
  vtkVolume* volume, vtkMatrix4x4* toWorld, std::string& error)
{
  const vtkMTimeType time = GetVolumeTime(volume);
  const glm::dmat4 matrix = ToGlm(toWorld);
  Entry& entry = this->Entries[volume];
  entry.Age = 0;
  if (entry.Time != time || entry.ToWorld != matrix)
  {
    entry.Time = time;
    entry.ToWorld = matrix;
    entry.Error.clear();
    entry.Values = VolumeExtinction::Build(volume, toWorld, entry.Error);
  }
  error = entry.Error;
  return entry.Values;
}

//------------------------------------------------------------------------------
void VolumeExtinctions::Forget()
{
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    it = ++it->second.Age > MostAge ? this->Entries.erase(it) : std::next(it);
  }
}
}
