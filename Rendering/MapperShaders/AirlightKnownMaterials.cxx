// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightKnownMaterials.h"

#include "Scene/AirlightClassNames.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <iterator>

namespace airlight
{
namespace
{
// Mappers that draw with their actor's property. Composite data's blocks have opacities of their own.
bool TakesIntensities(vtkMapper* mapper)
{
  return IsAnyOf(
    mapper, { "vtkOpenGLPolyDataMapper", "vtkDataSetMapper", "vtkCompositePolyDataMapper2" });
}

// Edges, vertices and what is selected are drawn with other numbers.
KnownMaterial Find(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  vtkMapper* mapper = actor->GetMapper();
  KnownMaterial known;
  if (!TakesIntensities(mapper) || mapper->GetSelection() ||
    property->GetRepresentation() != VTK_SURFACE || property->GetEdgeVisibility() ||
    property->GetVertexVisibility())
  {
    return known;
  }
  known.NoAmbient = property->GetAmbient() == 0.0;
  known.WholeDiffuse = property->GetDiffuse() == 1.0;
  known.NoSpecular = property->GetSpecular() == 0.0;
  known.Opaque = property->GetOpacity() == 1.0 && !mapper->IsA("vtkCompositePolyDataMapper2");
  return known;
}

KnownMaterial Both(const KnownMaterial& a, const KnownMaterial& b)
{
  return { a.NoAmbient && b.NoAmbient, a.WholeDiffuse && b.WholeDiffuse,
    a.NoSpecular && b.NoSpecular, a.Opaque && b.Opaque };
}

bool AreSame(const KnownMaterial& a, const KnownMaterial& b)
{
  return a.NoAmbient == b.NoAmbient && a.WholeDiffuse == b.WholeDiffuse &&
    a.NoSpecular == b.NoSpecular && a.Opaque == b.Opaque;
}

// VTK declares each of these at most once, and sets those that there are.
void MakeConstant(std::string& shader, const std::string& uniform, const std::string& value)
{
  const std::string declaration = "uniform float " + uniform + ";";
  const size_t place = shader.find(declaration);
  if (place != std::string::npos)
  {
    shader.replace(place, declaration.size(), "const float " + uniform + " = " + value + ";");
  }
}
}

//------------------------------------------------------------------------------
void KnownMaterials::Meet(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  const KnownMaterial known = Find(actor);
  Entry& entry = this->Entries[mapper];
  const bool newer = actor->GetProperty()->GetMTime() > entry.ToldTime;
  entry.Now = entry.Met ? Both(entry.Now, known) : known;
  entry.Newer = newer && (entry.Newer || !entry.Met);
  entry.Met = true;
}

//------------------------------------------------------------------------------
void KnownMaterials::MeetAll(vtkProp** props, int count)
{
  vtkNew<vtkPropCollection> parts;
  for (int i = 0; i < count; ++i)
  {
    if (auto* actor = vtkActor::SafeDownCast(props[i]))
    {
      this->Meet(actor);
    }
    else
    {
      props[i]->GetActors(parts);
    }
  }
  vtkCollectionSimpleIterator it = nullptr;
  parts->InitTraversal(it);
  while (vtkProp* part = parts->GetNextProp(it))
  {
    if (auto* actor = vtkActor::SafeDownCast(part))
    {
      this->Meet(actor);
    }
  }
}

//------------------------------------------------------------------------------
// All shaders are made anew where they are drawn next, and those of mappers that this frame does not draw
// know nothing until then.
void KnownMaterials::Forget()
{
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    it->second.ToldTime = 0;
    it = it->second.Met ? std::next(it) : this->Entries.erase(it);
  }
}

//------------------------------------------------------------------------------
bool KnownMaterials::Update(vtkProp** props, int count, bool known)
{
  for (auto& entry : this->Entries)
  {
    entry.second.Met = false;
  }
  if (known)
  {
    this->MeetAll(props, count);
  }
  const auto isOld = [](const auto& item) {
    const Entry& entry = item.second;
    return entry.Met && entry.ToldTime > 0 && !entry.Newer && !AreSame(entry.Told, entry.Now);
  };
  constexpr size_t few = 100; // that are not drawn any more
  const bool many = this->Entries.size() > 2 * static_cast<size_t>(count) + few;
  const bool old =
    known != this->Known || many || std::any_of(this->Entries.begin(), this->Entries.end(), isOld);
  this->Known = known;
  if (old)
  {
    this->Forget();
  }
  return old;
}

//------------------------------------------------------------------------------
void KnownMaterials::Tell(std::string& fragmentShader, vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  const auto found = actor ? this->Entries.find(actor->GetMapper()) : this->Entries.end();
  if (found == this->Entries.end())
  {
    return;
  }
  Entry& entry = found->second;
  vtkTimeStamp now;
  now.Modified();
  entry.Told = entry.Now;
  entry.ToldTime = now.GetMTime();
  const auto tell = [&](bool known, const char* uniform, const char* value) {
    if (known)
    {
      MakeConstant(fragmentShader, uniform, value);
    }
  };
  tell(entry.Told.NoAmbient, "ambientIntensity", "0.0");
  tell(entry.Told.WholeDiffuse, "diffuseIntensity", "1.0");
  tell(entry.Told.NoSpecular, "specularIntensity", "0.0");
  tell(entry.Told.Opaque, "opacityUniform", "1.0");
}
}
