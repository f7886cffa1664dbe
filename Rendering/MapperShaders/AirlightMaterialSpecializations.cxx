// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightMaterialSpecializations.h"

#include "Scene/AirlightClassTraits.h"
#include "Scene/AirlightVTKVersions.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <iterator>

namespace airlight
{
namespace
{
// Edges, vertices and what is selected are drawn with other numbers.
MaterialSpecialization Find(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  vtkMapper* mapper = actor->GetMapper();
  MaterialSpecialization known;
  if (!HasTrait(mapper, ClassTrait::UsesItsProperty) || mapper->GetSelection() ||
    property->GetRepresentation() != VTK_SURFACE || property->GetEdgeVisibility() ||
    property->GetVertexVisibility())
  {
    return known;
  }
  known.NoAmbient = property->GetAmbient() == 0.0;
  known.FullDiffuse = property->GetDiffuse() == 1.0;
  known.NoSpecular = property->GetSpecular() == 0.0;
  known.Opaque = property->GetOpacity() == 1.0 && !BlocksMapper::SafeDownCast(mapper);
  return known;
}

MaterialSpecialization Both(const MaterialSpecialization& a, const MaterialSpecialization& b)
{
  return { a.NoAmbient && b.NoAmbient, a.FullDiffuse && b.FullDiffuse, a.NoSpecular && b.NoSpecular,
    a.Opaque && b.Opaque };
}

bool AreSame(const MaterialSpecialization& a, const MaterialSpecialization& b)
{
  return a.NoAmbient == b.NoAmbient && a.FullDiffuse == b.FullDiffuse &&
    a.NoSpecular == b.NoSpecular && a.Opaque == b.Opaque;
}
}

//------------------------------------------------------------------------------
void MaterialSpecializations::AddActor(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  const MaterialSpecialization known = Find(actor);
  Entry& entry = this->Entries[mapper];
  const bool newer = actor->GetProperty()->GetMTime() > entry.CompileTime;
  entry.Current = entry.Drawn ? Both(entry.Current, known) : known;
  entry.AllNewer = newer && (entry.AllNewer || !entry.Drawn);
  entry.Drawn = true;
}

//------------------------------------------------------------------------------
// All shaders are made again when they are drawn next, and those of mappers that this frame does
// not draw know nothing until then.
void MaterialSpecializations::Invalidate()
{
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    it->second.CompileTime = 0;
    it = it->second.Drawn ? std::next(it) : this->Entries.erase(it);
  }
}

//------------------------------------------------------------------------------
bool MaterialSpecializations::Update(const std::vector<vtkActor*>& actors, bool known)
{
  for (auto& entry : this->Entries)
  {
    entry.second.Drawn = false;
  }
  if (known)
  {
    std::for_each(actors.begin(), actors.end(), [this](vtkActor* actor) { this->AddActor(actor); });
  }
  const auto isOld = [](const auto& item) {
    const Entry& entry = item.second;
    return entry.Drawn && entry.CompileTime > 0 && !entry.AllNewer &&
      !AreSame(entry.Compiled, entry.Current);
  };
  constexpr size_t few = 100; // that are not drawn any more
  const bool many = this->Entries.size() > 2 * actors.size() + few;
  const bool old = known != this->CoversAll || many ||
    std::any_of(this->Entries.begin(), this->Entries.end(), isOld);
  this->CoversAll = known;
  if (old)
  {
    this->Invalidate();
  }
  return old;
}

//------------------------------------------------------------------------------
MaterialSpecialization MaterialSpecializations::Compile(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  const auto found = actor ? this->Entries.find(actor->GetMapper()) : this->Entries.end();
  if (found == this->Entries.end())
  {
    return {};
  }
  Entry& entry = found->second;
  vtkTimeStamp now;
  now.Modified();
  entry.Compiled = entry.Current;
  entry.CompileTime = now.GetMTime();
  return entry.Compiled;
}
}
