// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the examples of one file share: putting things into a renderer, and its window or picture.
 */

#ifndef ExampleScene_h
#define ExampleScene_h

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>

namespace example
{

using Colour = double[3]; // linear, or the albedo, of red, green and blue

/**
 * A new actor of a source's or filter's surface; it can be changed afterwards.
 */
vtkSmartPointer<vtkActor> Add(vtkRenderer* renderer, vtkAlgorithm* source, const Colour& colour);

/**
 * A box from its bounds on the three axes.
 */
vtkNew<vtkCubeSource> MakeBox(double x0, double x1, double y0, double y1, double z0, double z1);

/**
 * A window on a renderer, which has drawn its first frame when it is there: the pass's buffers can
 * be read. With the name of a picture it is not on the screen.
 */
class Window
{
public:
  Window(vtkRenderer* renderer, int width, int height, const std::string& picture);

  /**
   * Writes the picture (.png), or shows the window until q is pressed. Returns what main() is to
   * return; VTK reports a file that cannot be written.
   */
  int Show();

private:
  std::string Picture;
  vtkNew<vtkRenderWindow> RenderWindow;
  vtkNew<vtkRenderWindowInteractor> Interactor;
};

}

#endif
