// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ExampleScene.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>

namespace example
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> Add(vtkRenderer* renderer, vtkAlgorithm* source, const Colour& colour)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkNew<vtkCubeSource> MakeBox(double x0, double x1, double y0, double y1, double z0, double z1)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(x0, x1, y0, y1, z0, z1);
  return box;
}

//------------------------------------------------------------------------------
Window::Window(vtkRenderer* renderer, int width, int height, const std::string& picture)
  : Picture(picture)
{
  this->RenderWindow->SetMultiSamples(0);
  this->RenderWindow->SetSize(width, height);
  this->RenderWindow->AddRenderer(renderer);
  this->RenderWindow->SetOffScreenRendering(!picture.empty());
  if (picture.empty())
  {
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    this->Interactor->SetInteractorStyle(style);
    this->Interactor->SetRenderWindow(this->RenderWindow);
  }
  this->RenderWindow->Render();
}

//------------------------------------------------------------------------------
int Window::Show()
{
  if (this->Picture.empty())
  {
    this->Interactor->Start();
    return EXIT_SUCCESS;
  }
  vtkNew<vtkWindowToImageFilter> shot;
  shot->SetInput(this->RenderWindow);
  shot->ReadFrontBufferOff();
  shot->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(shot->GetOutputPort());
  writer->SetFileName(this->Picture.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}
