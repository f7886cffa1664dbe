// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The media that a pass or a mapper was given, in order, each once.
 */

#ifndef AirlightMediaList_h
#define AirlightMediaList_h

#include "Integration/AirlightMath.h"
#include "vtkParticipatingMedium.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace airlight
{
class MediaList
{
public:
  // Each says whether the list is another one now. Null is ignored.
  bool Add(vtkParticipatingMedium* medium)
  {
    const bool add =
      medium && std::find(this->Media.begin(), this->Media.end(), medium) == this->Media.end();
    if (add)
    {
      this->Media.emplace_back(medium);
    }
    return add;
  }

  bool Remove(vtkParticipatingMedium* medium)
  {
    const auto it = std::find(this->Media.begin(), this->Media.end(), medium);
    const bool found = it != this->Media.end();
    if (found)
    {
      this->Media.erase(it);
    }
    return found;
  }

  bool Set(vtkParticipatingMedium* medium)
  {
    const std::vector<vtkSmartPointer<vtkParticipatingMedium>> before = this->Media;
    this->Media.clear();
    this->Add(medium);
    return this->Media != before;
  }

  bool Clear() { return this->Set(nullptr); }

  int GetSize() const { return static_cast<int>(this->Media.size()); }
  bool Has(int index) const { return index >= 0 && index < this->GetSize(); }
  vtkParticipatingMedium* Get(int index) const { return this->Media[index]; }
  std::vector<vtkParticipatingMedium*> GetAll() const
  {
    return { this->Media.begin(), this->Media.end() };
  }

  // Empty, or what is to be said of more media than are drawn.
  std::string Check() const
  {
    return this->GetSize() <= AIRLIGHT_MAX_MEDIA ? ""
                                                 : "There are " + std::to_string(this->GetSize()) +
        " media and at most " + std::to_string(AIRLIGHT_MAX_MEDIA) +
        " are drawn: the first ones are. Call RemoveMedium() for those not needed.";
  }

  // Empty, or why vtkAirlightPolyDataMapper cannot draw them.
  std::string CheckDensities() const
  {
    for (int i = 0; i < this->GetSize(); ++i)
    {
      if (this->Get(i)->GetDensity() == vtkParticipatingMedium::IMAGE)
      {
        return "medium " + std::to_string(i) +
          " has its density from an image, which this mapper does not draw; choose another "
          "density, "
          "or use vtkAirlightPass";
      }
    }
    return "";
  }

private:
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> Media;
};
}

#endif
