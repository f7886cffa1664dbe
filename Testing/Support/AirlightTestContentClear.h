// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Contents through vtkAirlightPass with a clear medium: VTK's own picture.
 */

#ifndef AirlightTestContentClear_h
#define AirlightTestContentClear_h

#include "AirlightTestContentOthers.h"
#include "AirlightTestContentSurfaces.h"

#include <cstdlib>

namespace airlighttest
{
struct Content
{
  const char* Name;
  std::function<void(Theatre&)> Add;
  int Limit = 1; // of the difference, in steps of 1/255
};

// VTK blends splats and volumes into 8 bits: each of the layers, or the one colour and opacity that
// they add up to, is rounded, and so is what it is blended with. The pass blends in single precision
// and rounds once, where it does not leave the picture to VTK altogether. Measured: 3 for splats
// that lie over each other, 2 for the others.
constexpr int ManyLayers = 3;
constexpr int OneLayer = 2;

//------------------------------------------------------------------------------
// Values whose difference is above this many steps of 1/255.
inline int CountAbove(const Picture& a, const Picture& b, int limit)
{
  int count = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    count += std::abs(a[i] - b[i]) > limit ? 1 : 0;
  }
  return count;
}

inline bool ShowsSomething(Theatre& theatre, const Picture& picture)
{
  vtkPropCollection* props = theatre.Renderer->GetViewProps();
  vtkCollectionSimpleIterator it = nullptr;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    prop->VisibilityOff();
  }
  return CountAbove(picture, Capture(theatre.Window), 10) > 100;
}

inline void CheckClear(Theatre& theatre, const Content& content)
{
  theatre.Open();
  theatre.AddLamp();
  theatre.Pass->SurfaceShadowsOff();
  content.Add(theatre);
  const Picture plain = Capture(theatre.Window);
  theatre.Renderer->SetPass(theatre.Pass);
  const Picture clear = Capture(theatre.Window);
  Check(Compare(plain, clear) == 0, std::string(content.Name) + ": VTK draws the picture");
  // All steps are taken where buffers are recorded.
  theatre.Pass->RecordBuffersOn();
  const Picture recorded = Capture(theatre.Window);
  const int difference = Compare(plain, recorded);
  std::cout << content.Name << ": differs by " << difference << " in "
            << CountAbove(plain, recorded, 1) << " values\n";
  Check(difference <= content.Limit, std::string(content.Name) + ": the picture is VTK's");
  Check(
    ShowsSomething(theatre, plain), std::string(content.Name) + ": the picture shows something");
}

//------------------------------------------------------------------------------
// The exit status.
inline int CheckAllClear(const std::vector<Content>& contents)
{
  Theatre theatre;
  theatre.Medium->SetScattering(0.0, 0.0, 0.0);
  theatre.Medium->SetAbsorption(0.0, 0.0, 0.0);
  for (const Content& content : contents)
  {
    CheckClear(theatre, content);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

#endif
