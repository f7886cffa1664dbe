// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LampMarkers_h
#define LampMarkers_h

#include <vtkActor2D.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

class vtkRenderer;

namespace airlight
{

/**
 * A dot over the picture for each lamp that has a place, with a ring around the chosen one. The
 * mouse takes hold of a lamp by its dot. Lamps outside the picture have a paler dot at its edge.
 * Directional lights and lamps behind the camera have none. Dots are annotations: they have no fog,
 * cast no shadow, and surfaces do not hide them.
 */
class LampMarkers
{
public:
  static constexpr int None = -1; ///< no lamp

  LampMarkers(vtkRenderer* renderer, const std::vector<vtkSmartPointer<vtkLight>>& lamps);

  /**
   * Put the dots where the lamps are, and the ring around the chosen one.
   */
  void Update(int chosen);

  /**
   * The lamp whose dot is at most ten pixels from a place in the window, the nearest first; None if
   * there is none or the markers are hidden.
   */
  int Find(int x, int y) const;

  /**
   * From a lamp to its dot, in pixels to the right and up: 0 inside the picture.
   */
  std::array<double, 2> GetOffset(int lamp) const;

  /**
   * Keep the dots of lamps outside the picture above so many pixels. Default: 0.
   */
  void SetBottom(int pixels) { this->Bottom = pixels; }

  /**
   * Default: true.
   */
  void SetVisible(bool visible) { this->Visible = visible; }

private:
  struct Marker
  {
    vtkSmartPointer<vtkLight> Lamp;
    vtkNew<vtkActor2D> Rim;
    vtkNew<vtkActor2D> Dot;
  };

  bool IsShown(vtkLight* lamp) const;
  std::array<double, 2> Project(vtkLight* lamp) const;
  std::array<double, 2> FindDot(vtkLight* lamp) const;

  vtkRenderer* Renderer;
  std::vector<Marker> Markers; // one a lamp, also for those without a dot
  vtkNew<vtkActor2D> Ring;
  int Bottom = 0;
  bool Visible = true;
};

}

#endif
