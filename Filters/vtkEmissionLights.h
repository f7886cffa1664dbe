// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkEmissionLights
 * @brief   lamps in place of a medium that emits: what a fire lights
 *
 * vtkParticipatingMedium::SetEmission() makes a medium visible; surfaces and other media do not
 * see its light. This class fits point lights to the emission. The medium's density e(x) is
 * sampled, and cut into NumberOfLights clusters C by weighted k-means (Lloyd 1982). A cluster's
 * light is at its centre and has the radiant intensity
 *
 *  I = Emission * integral of e over C   [W/sr]
 *
 * so that the power, 4 pi I, is the medium's. It casts shadows and scatters as all lights do, and
 * has the extent of its cluster (vtkAirlightLight::SetRadius()), which pictures of several frames
 * show. What is approximate: light that the medium itself absorbs on its way out is not taken away,
 * and within a cluster's size of the fire the light comes from a few places.
 *
 * @code
 * vtkNew<vtkEmissionLights> lights;
 * lights->SetMedium(flames);
 * lights->AddLights(renderer);
 * lights->Update(); // again when the flames have changed
 * @endcode
 *
 * Errors (ErrorEvent, all lights are switched off): no medium, a medium that is infinite, a density
 * image that cannot be used.
 *
 * @sa vtkParticipatingMedium vtkAirlightLight vtkAirlight::BlackbodyRadiance
 */

#ifndef vtkEmissionLights_h
#define vtkEmissionLights_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkNew.h"            // for the lights
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for the medium

#include <memory> // for the renderers

class vtkLightCollection;
class vtkParticipatingMedium;
class vtkRenderer;

class VTKAIRLIGHT_EXPORT vtkEmissionLights : public vtkObject
{
public:
  static vtkEmissionLights* New();
  vtkTypeMacro(vtkEmissionLights, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The medium that emits. Default: null.
   */
  void SetMedium(vtkParticipatingMedium* medium);
  vtkParticipatingMedium* GetMedium();
  ///@}

  ///@{
  /**
   * The number of lights. Each costs what a light costs. Range: 1 to 64. Default: 8.
   */
  vtkSetClampMacro(NumberOfLights, int, 1, 64);
  vtkGetMacro(NumberOfLights, int);
  ///@}

  /**
   * Fits the lights to the medium as it is now. They begin where they were, so that those of a fire
   * that moves move with it. A small fire may need fewer lights than NumberOfLights: the rest are
   * switched off. Returns false after an error.
   */
  bool Update();

  /**
   * The lights, of which there are NumberOfLights after Update(). They stay the same objects.
   */
  vtkLightCollection* GetLights();

  /**
   * Adds the lights to a renderer; those that a later Update() needs besides are added by it, too.
   */
  void AddLights(vtkRenderer* renderer);

  /**
   * Takes the lights from a renderer; its other lights stay.
   */
  void RemoveLights(vtkRenderer* renderer);

protected:
  vtkEmissionLights();
  ~vtkEmissionLights() override;

private:
  vtkEmissionLights(const vtkEmissionLights&) = delete;
  void operator=(const vtkEmissionLights&) = delete;

  void MakeLights();
  void SwitchOff();

  vtkSmartPointer<vtkParticipatingMedium> Medium;
  int NumberOfLights = 8;
  vtkNew<vtkLightCollection> Lights;
  bool Placed = false;
  class Renderers;
  std::unique_ptr<Renderers> Followers;
};

#endif
