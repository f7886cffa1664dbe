// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMAirlightRenderViewProxy
 * @brief   a client's proxy of a vtkPVAirlightRenderView
 *
 * For a picture with a transparent background, ParaView's client draws before a white and a black
 * one, which its servers cannot tell from those of a user. The medium, to which a share of the
 * background's colour arrives from all sides, must not follow them: the proxy tells all processes
 * to keep the former one.
 *
 * @sa vtkPVAirlightRenderView::SetKeepsBackground()
 */

#ifndef vtkSMAirlightRenderViewProxy_h
#define vtkSMAirlightRenderViewProxy_h

#include "vtkAirlightParaViewViewsModule.h" // for export macro
#include "vtkSMRenderViewProxy.h"

class VTKAIRLIGHTPARAVIEWVIEWS_EXPORT vtkSMAirlightRenderViewProxy : public vtkSMRenderViewProxy
{
public:
  static vtkSMAirlightRenderViewProxy* New();
  vtkTypeMacro(vtkSMAirlightRenderViewProxy, vtkSMRenderViewProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMAirlightRenderViewProxy() = default;
  ~vtkSMAirlightRenderViewProxy() override = default;

  vtkTypeUInt32 PreRender(bool interactive) override;

private:
  vtkSMAirlightRenderViewProxy(const vtkSMAirlightRenderViewProxy&) = delete;
  void operator=(const vtkSMAirlightRenderViewProxy&) = delete;
};

#endif
