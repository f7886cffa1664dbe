// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   airlight::ViewLamp
 * @brief   A lamp that follows a view's data
 *
 * A point light above the data, to the left and slightly behind, seen from where ParaView first
 * places the camera: there its shafts are seen. It lights a white surface at the data's centre, if
 * the medium left all its light, with a radiance of 1.1 times the brightness. So does the lamp that
 * PyVista's component derives. It depends on bounds alone, hence a state that is loaded again, and
 * all processes, have the same.
 */

#ifndef AirlightViewLamp_h
#define AirlightViewLamp_h

#include "vtkNew.h" // for the light

class vtkBoundingBox;
class vtkLight;
class vtkRenderer;

namespace airlight
{
class ViewLamp
{
public:
  ViewLamp();
  ~ViewLamp();

  ViewLamp(const ViewLamp&) = delete;
  ViewLamp& operator=(const ViewLamp&) = delete;

  bool On = false;
  double Color[3] = { 1.0, 1.0, 1.0 };
  double Brightness = 1.0;
  double Radius = 0.0; ///< world units
  bool Visible = false;

  /**
   * Adds the light to a renderer, or removes it, and places it by the bounds of the data.
   */
  void Update(vtkRenderer* renderer, const vtkBoundingBox& bounds);

  /**
   * The light, also while it is off.
   */
  vtkLight* GetLight() const { return this->Light; }

private:
  vtkNew<vtkLight> Light;
};
}

#endif
