// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightPass lets a user's delegate draw. A delegate draws a scene at once; the medium
 * has to come between its surfaces and what blends over them. So the delegate is shown stand-ins of
 * the props, which draw opaque geometry alone.
 */

#ifndef AirlightDelegateProps_h
#define AirlightDelegateProps_h

#include "vtkSmartPointer.h"

#include <set>
#include <vector>

class vtkProp;
class vtkRenderPass;
class vtkRenderState;

namespace airlight
{
class DelegateProps
{
public:
  DelegateProps();
  ~DelegateProps();
  DelegateProps(const DelegateProps&) = delete;
  void operator=(const DelegateProps&) = delete;

  // Takes the props of one state into another. Actors that have nothing but opaque geometry, most
  // actors, stand for themselves. Stand-ins share their prop's keys, by which mappers find the
  // render passes that take part in their shaders.
  void Show(const vtkRenderState* from, vtkRenderState& to);

  // Whether the delegate drew what it was shown. Some draw the renderer's own list.
  bool WereDrawn() const { return this->Drawn; }

  // Notes a prop that drew nothing when it was shown, and those of a state that were noted since.
  void Hide(vtkProp* prop) { this->Hidden.insert(prop); }
  std::vector<vtkProp*> GetHidden(const vtkRenderState* s) const;

  void Clear();

private:
  void Add(vtkProp* prop);

  std::vector<vtkProp*> Props;
  std::vector<vtkSmartPointer<vtkProp>> ProxyProps;
  std::set<vtkProp*> Hidden;
  bool Drawn = false;
};

// The pass by which a delegate draws translucent surfaces: the first of VTK's own that is found in
// it. Null where there is none.
vtkRenderPass* FindTranslucentPass(vtkRenderPass* delegate);

// Whether it draws surfaces with a pass of VTK's own, which asks nothing of the renderer's
// settings.
bool HasOpaquePass(vtkRenderPass* delegate);
}

#endif
