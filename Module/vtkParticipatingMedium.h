// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticipatingMedium
 * @brief   fog, smoke, dust or water: a volume that scatters and absorbs light
 *
 * A medium has scattering and absorption coefficients (per colour channel, in 1/world unit), a
 * phase function (the directions of scattered light), a region and a density. Add it to a
 * vtkAirlightPass to render it, or compute with it in vtkAirlight. See Documentation/guide.md.
 *
 * SetScattering() and SetAbsorption() set the coefficients; SetMeanFreePath() and SetVisibility()
 * scale them. The default is a clear medium, isotropic and unbounded, which changes nothing.
 *
 * Errors: invalid values (negative, infinite or NaN) give an error and the old value is kept.
 *
 * @sa vtkAirlightPass vtkAirlight
 */

#ifndef vtkParticipatingMedium_h
#define vtkParticipatingMedium_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for code that relies on this header for it

#include <memory> // for the phase function, the surface and the image
#include <string> // for the names of arrays

class vtkImageData;
class vtkPhaseFunction;
class vtkPolyData;
class vtkTable;

namespace airlight
{
struct Change;
class DensityGrid;
class ImageColours;
class MediumSky;
struct PhaseShape;
struct SourceFit;
class SurfaceTree;
}

class VTKAIRLIGHT_EXPORT vtkParticipatingMedium : public vtkObject
{
public:
  static vtkParticipatingMedium* New();
  vtkTypeMacro(vtkParticipatingMedium, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Scattering coefficient sigma_s per RGB channel, in 1/world unit: the fraction of light
   * scattered per unit length. Range: 0 to 1e100. Default: (0, 0, 0).
   */
  void SetScattering(double r, double g, double b);
  void SetScattering(const double rgb[3]);
  vtkGetVector3Macro(Scattering, double);
  ///@}

  ///@{
  /**
   * Absorption coefficient sigma_a per RGB channel, in 1/world unit: the fraction of light absorbed
   * per unit length. Range: 0 to 1e100. Default: (0, 0, 0).
   */
  void SetAbsorption(double r, double g, double b);
  void SetAbsorption(const double rgb[3]);
  vtkGetVector3Macro(Absorption, double);
  ///@}

  ///@{
  /**
   * Extinction coefficient sigma_t = sigma_s + sigma_a per RGB channel, in 1/world unit.
   */
  double* GetExtinction() VTK_SIZEHINT(3);
  void GetExtinction(double rgb[3]);
  ///@}

  ///@{
  /**
   * Single-scattering albedo sigma_s/sigma_t per RGB channel, in [0, 1]. A channel without
   * extinction has the albedo 1.
   */
  double* GetAlbedo() VTK_SIZEHINT(3);
  void GetAlbedo(double rgb[3]);
  ///@}

  /**
   * Scales all coefficients so that the mean extinction of the three channels is 3.912/distance.
   * The distance is the meteorological range, at which the contrast of a black object against the
   * horizon has fallen to 2 % (Koschmieder 1924). Albedo and colour are kept; a clear medium
   * becomes purely scattering and grey. Unit: world. Range: finite, at least 1e-99.
   */
  void SetVisibility(double distance);

  /**
   * The meteorological range 3.912/sigma_t of the mean extinction; infinite for a clear medium.
   */
  double GetVisibility();

  /**
   * Scales all coefficients so that the mean extinction of the three channels is 1/distance. Albedo
   * and colour are kept; a clear medium becomes purely scattering and grey. Unit: world. Range:
   * finite, at least 1e-99.
   */
  void SetMeanFreePath(double distance);

  /**
   * The mean free path 1/sigma_t of the mean extinction; infinite for a clear medium.
   */
  double GetMeanFreePath();

  /**
   * Phase functions: the distribution of scattered light over angle, normalised to 1 over the
   * sphere. mu is the cosine of the scattering angle, 1 is forward.
   */
  enum PhaseFunctionType
  {
    ISOTROPIC = 0,         ///< 1/(4 pi): the same in all directions
    HENYEY_GREENSTEIN = 1, ///< (1 - g^2)/(4 pi (1 + g^2 - 2 g mu)^(3/2)) (1941); by a fit
    RAYLEIGH = 2,          ///< 3/(16 pi) (1 + mu^2): particles far smaller than the wavelength
    SCHLICK = 3,           ///< (1 - k^2)/(4 pi (1 - k mu)^2), k the anisotropy (Blasi et al. 1993)
    CORNETTE_SHANKS = 4,   ///< 3/(8 pi) (1 - g^2)/(2 + g^2) (1 + mu^2)/(1 + g^2 - 2 g mu)^(3/2)
                           ///< (1992); by a fit, at g = 0 exactly Rayleigh's
    MIE_HAZY = 5,          ///< (1/2 + 9/2 ((1 + mu)/2)^8)/(4 pi) (Nishita et al. 1987)
    MIE_MURKY = 6,         ///< (1/2 + 33/2 ((1 + mu)/2)^32)/(4 pi) (Nishita et al. 1987)
    TABULATED = 7,         ///< measured, see SetPhaseTable(); by a fit
    OBJECT = 8             ///< an object, see SetPhaseFunction(vtkPhaseFunction*)
  };

  ///@{
  /**
   * The phase function. Default: ISOTROPIC. Isotropic, Rayleigh's and Schlick's functions are exact
   * in closed form. Henyey and Greenstein's, Cornette and Shanks' and tables are fitted, see
   * SetPhaseTolerance(). Mie's are evaluated exactly and integrated by quadrature, since a few
   * poles cannot represent their high powers without losing digits. In the air before opaque
   * surfaces, the pass integrates them as fast as the others for point lights in one uniform
   * medium; elsewhere they cost more.
   *
   * OBJECT selects the object given last, see below; without one it is an error. Other numbers are
   * errors, too, and the old function is kept.
   */
  void SetPhaseFunction(int type);
  int GetPhaseFunction();
  void SetPhaseFunctionToIsotropic() { this->SetPhaseFunction(ISOTROPIC); }
  void SetPhaseFunctionToHenyeyGreenstein() { this->SetPhaseFunction(HENYEY_GREENSTEIN); }
  void SetPhaseFunctionToRayleigh() { this->SetPhaseFunction(RAYLEIGH); }
  void SetPhaseFunctionToSchlick() { this->SetPhaseFunction(SCHLICK); }
  void SetPhaseFunctionToCornetteShanks() { this->SetPhaseFunction(CORNETTE_SHANKS); }
  void SetPhaseFunctionToMieHazy() { this->SetPhaseFunction(MIE_HAZY); }
  void SetPhaseFunctionToMieMurky() { this->SetPhaseFunction(MIE_MURKY); }
  void SetPhaseFunctionToTabulated() { this->SetPhaseFunction(TABULATED); }
  ///@}

  ///@{
  /**
   * Selects a phase function object, which has parameters of its own: SetAnisotropy() and
   * SetPhaseTable() do not affect it. Several media may share it. Null removes the object, and
   * selects ISOTROPIC if the object was in use. Default: null.
   */
  void SetPhaseFunction(vtkPhaseFunction* function);
  vtkPhaseFunction* GetPhaseFunctionObject();
  ///@}

  ///@{
  /**
   * The parameter of the functions of Henyey and Greenstein (g, the mean cosine of the scattering
   * angle), Cornette and Shanks (g) and Schlick (k; k = 1.55 g - 0.55 g^3 approximates Henyey and
   * Greenstein's g): above 0 forward, below 0 backward. Range: [-0.99, 0.99]. Default: 0.
   *
   * It may be set before or after the function is selected. The other functions ignore it. If a
   * value other than 0 is set and no function that has one is selected before the medium is used,
   * an error is reported then.
   */
  void SetAnisotropy(double g);
  double GetAnisotropy();
  ///@}

  ///@{
  /**
   * The measured function of SetPhaseFunctionToTabulated(). Column 0: scattering angle in degrees,
   * in [0, 180], ascending; column 1: value, above 0, in any unit: the function is normalised. Its
   * logarithm is a monotone cubic between the rows (Fritsch and Carlson 1980) and constant before
   * the first and after the last one. At least 2 rows. An invalid table gives an error and the old
   * one is kept. Default: none.
   */
  void SetPhaseTable(vtkTable* table);
  vtkTable* GetPhaseTable();
  ///@}

  ///@{
  /**
   * Maximum relative error of the fit of the phase function by poles. The error of an integral of
   * airlight never exceeds it, because the integrand is positive. Smaller values need more poles
   * and more time. Range: [1e-6, 0.1]. Default: 1e-3.
   */
  void SetPhaseTolerance(double tolerance);
  double GetPhaseTolerance();
  ///@}

  /**
   * The relative error of the fit: 0 for functions that need no fit. It exceeds the tolerance only
   * at extreme anisotropy, if GetNumberOfPhasePoles() is at its limit. A table that no fit matches
   * within the tolerance is used directly, without poles and error, and integrated by quadrature as
   * Mie's functions are. So is an object that no fit matches, through a table of it with a relative
   * error of about 1e-6.
   */
  double GetPhaseErrorBound();

  /**
   * The phase function p(cosTheta) itself, not its fit, in 1/sr. cosTheta = 1 is forward.
   */
  double EvaluatePhaseFunction(double cosTheta);

  ///@{
  /**
   * The function as it is integrated: with s = tan(theta/2) and q_k = s^2 + b_k^2
   *
   *  p = (1 + s^2) sum_k (c1_k/q_k + c2_k/q_k^2 + c3_k/q_k^3) + factor ((1 + cosTheta)/2)^exponent
   *
   * GetPhasePole() returns (b, c1, c2, c3), GetPhasePower() (factor, exponent). Index range: 0 to
   * GetNumberOfPhasePoles() - 1.
   */
  int GetNumberOfPhasePoles();
  void GetPhasePole(int index, double pole[4]);
  void GetPhasePower(double power[2]);
  ///@}

  ///@{
  /**
   * Ambient radiance per RGB channel, W/(m^2 sr): light that arrives evenly from all directions, an
   * approximation of multiple scattering. The medium adds albedo * L * (1 - transmittance) to each
   * ray. Range: 0 to 1e100. Default: (0, 0, 0).
   */
  void SetAmbientRadiance(double r, double g, double b);
  void SetAmbientRadiance(const double rgb[3]);
  vtkGetVector3Macro(AmbientRadiance, double);
  ///@}

  ///@{
  /**
   * A sky of two colours: the radiance per RGB channel that arrives from all directions above the
   * horizon, within 90 degrees of SetUp(), and from all below it, W/(m^2 sr). It adds to ambient
   * radiance: a ray of direction d gets the integral of sky times phase function over all
   * directions w, at the angle between w and d; to 2e-5 of the colours' difference for Henyey and
   * Greenstein's functions up to 0.99 and 1e-3 for those with narrow features, as rainbows. Nothing
   * casts shadows from the sky, and the medium itself does not dim it; surfaces do not receive it.
   * Range: 0 to 1e100. Defaults: (0, 0, 0).
   */
  void SetSkyRadiance(double r, double g, double b);
  void SetSkyRadiance(const double rgb[3]);
  vtkGetVector3Macro(SkyRadiance, double);
  void SetGroundRadiance(double r, double g, double b);
  void SetGroundRadiance(const double rgb[3]);
  vtkGetVector3Macro(GroundRadiance, double);
  ///@}

  ///@{
  /**
   * A sky by its spherical harmonics to order 2, W/(m^2 sr): nine coefficients, each for red, green
   * and blue, of the orthonormal real harmonics in world axes, in the order 1, y, z, x, xy, yz,
   * 3 z^2 - 1, xz, x^2 - y^2 (Ramamoorthi and Hanrahan 2001). The first is the mean radiance over
   * 0.28209. It adds to ambient light, too: a ray of direction d gets the same sum in d, those of
   * order l times the l-th Legendre moment of the phase function, which is exact; of a sky that has
   * more orders it is what these scatter. Sums below 0 count as 0.
   * vtkAirlight::EnvironmentHarmonics() makes them of a picture. Range: finite, from -1e100 to
   * 1e100. Default: all 0.
   */
  void SetSkyHarmonics(const double coefficients[27]);
  void ClearSkyHarmonics();
  vtkGetVectorMacro(SkyHarmonics, double, 27);
  ///@}

  ///@{
  /**
   * Emission coefficient per RGB channel, W/(m^2 sr) per world unit at density 1: the radiance that
   * a thin layer adds to a ray per unit of length, as flames, glowing gas and phosphorescent water
   * do. It follows the density, and what is behind absorbs it: a uniform layer of length l adds
   * Emission (1 - exp(-extinction l))/extinction. Gas in thermal equilibrium has absorption times
   * vtkAirlight::BlackbodyRadiance() (Kirchhoff's law). It lights surfaces and other media through
   * vtkEmissionLights, or in vtkAirlightReference with SetScatteringOrders(0). In an unbounded
   * medium without image a channel needs extinction to emit: its rays would be infinitely bright;
   * otherwise an error says so and the channel is dark. Range: 0 to 1e100. Default: (0, 0, 0).
   */
  void SetEmission(double r, double g, double b);
  void SetEmission(const double rgb[3]);
  vtkGetVector3Macro(Emission, double);
  ///@}

  ///@{
  /**
   * Whether light that was scattered more than once is computed, too, where there is one medium:
   *
   * - of lamps with inverse-square attenuation, in a medium of uniform density that is unbounded or
   *   a box, sphere or cylinder, by the exact solution of the transport equation round a lamp in an
   *   unbounded medium, fitted, with a factor for the faces of boxes and spheres; spotlights, lamps
   *   with photometric files and lamps outside as two lamps where their light first changes
   *   direction, for phase functions of mean cosines up to 0.65;
   * - of such lamps, but no spotlights or photometric files, in an unbounded medium that falls with
   *   height, by the same solution at the mean density between lamp and point;
   * - of directional lights in a box, or in an unbounded medium that falls with height, by the
   *   delta-Eddington approximation.
   *
   * See Documentation/physics.md. It replaces ambient radiance and skies. Surfaces receive what
   * arrives there. Other lights are scattered once, with a message; other media, too. Default: off.
   *
   * In an unbounded medium the error is that of the fit and 0.5 % of all scattered light, where the
   * lamp is 0.05 to 20 mean free paths away (nearer, 3 %). What no bound covers, see
   * Documentation/accuracy.md: boundaries, floors and walls that reflect it, and casters. Surfaces
   * get it also in shadow. Casters dim it in the air as they dim the light of all lights together
   * that is scattered once.
   */
  void SetMultipleScattering(bool on);
  vtkGetMacro(MultipleScattering, bool);
  vtkBooleanMacro(MultipleScattering, bool);
  ///@}

  /**
   * The relative error of the fit of the multiply scattered light; 0 while MultipleScattering is
   * off, or left out with an error. In an unbounded medium the multiply scattered light of a ray is
   * in error by this and by that of the quadrature.
   */
  double GetMultipleScatteringErrorBound();

  /**
   * Where the medium is.
   */
  enum RegionType
  {
    UNBOUNDED = 0, ///< everywhere
    BOX = 1,       ///< inside an axis-aligned box, see SetBounds()
    SPHERE = 2,    ///< inside a sphere, see SetCenter() and SetRadius()
    SURFACE = 3,   ///< inside a closed surface, see SetSurface()
    CYLINDER = 4   ///< inside a cylinder, see SetCenter(), SetRadius(), SetHeight() and SetAxis()
  };

  ///@{
  /**
   * The region of the medium. Outside it is vacuum. Default: UNBOUNDED.
   */
  void SetRegion(int type);
  vtkGetMacro(Region, int);
  void SetRegionToUnbounded() { this->SetRegion(UNBOUNDED); }
  void SetRegionToBox() { this->SetRegion(BOX); }
  void SetRegionToSphere() { this->SetRegion(SPHERE); }
  void SetRegionToSurface() { this->SetRegion(SURFACE); }
  void SetRegionToCylinder() { this->SetRegion(CYLINDER); }
  ///@}

  ///@{
  /**
   * The box of SetRegionToBox(): xmin, xmax, ymin, ymax, zmin, zmax in world units, each minimum at
   * most its maximum. Default: (-1, 1, -1, 1, -1, 1).
   */
  void SetBounds(double xmin, double xmax, double ymin, double ymax, double zmin, double zmax);
  void SetBounds(const double bounds[6]);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * The centre of SetRegionToSphere() or SetRegionToCylinder(), halfway between the cylinder's
   * ends, in world coordinates. Range: finite. Default: (0, 0, 0).
   */
  void SetCenter(double x, double y, double z);
  void SetCenter(const double center[3]);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * The radius of SetRegionToSphere() or SetRegionToCylinder(), world units. Range: finite, at
   * least 0. Default: 1.
   */
  void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * The height of SetRegionToCylinder(), from end to end, world units, as in vtkCylinderSource.
   * Range: finite, above 0. Default: 1.
   */
  void SetHeight(double height);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * The direction of the axis of SetRegionToCylinder(), as in vtkCylinder; it is normalised. Range:
   * finite, not 0. Default: (0, 1, 0).
   */
  void SetAxis(double x, double y, double z);
  void SetAxis(const double axis[3]);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * The surface of SetRegionToSurface(): closed polygons or strips, of any orientation and shape,
   * in world coordinates. A point is inside if a path from infinity to it crosses the surface an
   * odd number of times: a surface within another one bounds a hole. Surfaces must not intersect
   * each other; give overlapping bodies separate media. Points at the same position count as one.
   * A surface makes the region one of SetRegionToSurface() if SetRegion() has not been called.
   * Airlight is integrated by quadrature, see vtkAirlight.
   *
   * An empty or open mesh gives an error and the old surface is kept. If a mesh becomes so later,
   * an error is reported when the medium is used, and the medium is ignored. At most 4 million
   * triangles. Default: none.
   */
  void SetSurface(vtkPolyData* surface);
  vtkPolyData* GetSurface();
  ///@}

  /**
   * How the density varies inside the region.
   */
  enum DensityType
  {
    UNIFORM = 0, ///< the same everywhere
    EXPONENTIAL_HEIGHT =
      1,      ///< exp(-(height - reference height)/scale height), as in the atmosphere
    IMAGE = 2 ///< measured or simulated, see SetDensityImage()
  };

  ///@{
  /**
   * The density. All coefficients are those at density 1. Default: UNIFORM.
   */
  void SetDensity(int type);
  vtkGetMacro(Density, int);
  void SetDensityToUniform() { this->SetDensity(UNIFORM); }
  void SetDensityToExponentialHeight() { this->SetDensity(EXPONENTIAL_HEIGHT); }
  void SetDensityToImage() { this->SetDensity(IMAGE); }
  ///@}

  ///@{
  /**
   * The height over which SetDensityToExponentialHeight() falls to 1/e, world units. Range: finite,
   * above 0. Default: 1.
   */
  void SetScaleHeight(double height);
  vtkGetMacro(ScaleHeight, double);
  ///@}

  ///@{
  /**
   * The height at which SetDensityToExponentialHeight() is 1, world units; the height of a point is
   * dot(up, point). Range: finite. Default: 0.
   */
  void SetReferenceHeight(double height);
  vtkGetMacro(ReferenceHeight, double);
  ///@}

  ///@{
  /**
   * Whether there is level ground at GroundHeight, world units, of the albedo GroundAlbedo. It ends
   * what SetMultipleScattering() computes of directional lights in SetDensityToExponentialHeight(),
   * where fog that went on below would scatter light back from there; nothing else knows of it.
   * Ranges: height finite, albedo 0 to 1. Defaults: off, 0, (0.2, 0.2, 0.2), that of soil.
   */
  void SetGround(bool on);
  vtkGetMacro(Ground, bool);
  vtkBooleanMacro(Ground, bool);
  void SetGroundHeight(double height);
  vtkGetMacro(GroundHeight, double);
  void SetGroundAlbedo(double r, double g, double b);
  void SetGroundAlbedo(const double rgb[3]);
  vtkGetVector3Macro(GroundAlbedo, double);
  ///@}

  ///@{
  /**
   * The direction in which heights are measured; it is normalised. Range: finite, not 0. Default:
   * (0, 1, 0).
   */
  void SetUp(double x, double y, double z);
  void SetUp(const double up[3]);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * The image of SetDensityToImage(): its point scalars are the density, a factor of both
   * coefficients, without unit. It is trilinear between the points and 0 outside the image, whose
   * origin, spacing and direction matrix position it in the world. The medium is the intersection
   * of its region and the image; an unbounded region is the axis-aligned box that contains the
   * image. Optical depths are summed cell by cell, to rounding; airlight is integrated by
   * quadrature. Range: one finite value for each point, 0 to 1e100; at least 2 points along each
   * axis. Default: none. An image makes the density one of SetDensityToImage() if SetDensity() has
   * not been called.
   *
   * An invalid image gives an error and the old one is kept. If it becomes invalid later, or there
   * is none, an error is reported when the medium is used, and the medium is ignored. Call
   * Modified() of the image after a change of its scalars. The medium keeps a copy, of 8 or 16
   * bits or float if the scalars are, else of double. vtkAirlightDensityImage makes such images.
   *
   * vtkAirlight and vtkAirlightReference support any number of such media; for the limits of
   * vtkAirlightPass and vtkAirlightPolyDataMapper see Documentation/guide.md.
   */
  void SetDensityImage(vtkImageData* image);
  vtkImageData* GetDensityImage();
  ///@}

  ///@{
  /**
   * Names of point arrays of the density image that give each place its own colours, with one
   * component for all channels or three; of unsigned characters 255 counts as 1. They are trilinear
   * between the points and kept in single precision. AlbedoArrayName: the share of extinction that
   * is scattered there, in place of Scattering/(Scattering + Absorption), as where white steam and
   * black smoke mix; the extinction stays. Range: 0 to 1. EmissionArrayName: factors of Emission,
   * as in flames in which the temperature varies; the density counts, too, as for all emission.
   * Range: 0 to 1e10. Default: "", no array. GetAlbedo() and what sets it know of no array.
   *
   * If the image has no such array or a value is out of range when the medium is used, an error
   * says so once, and the array is ignored until it is fixed.
   */
  vtkSetMacro(AlbedoArrayName, std::string);
  vtkGetMacro(AlbedoArrayName, std::string);
  vtkSetMacro(EmissionArrayName, std::string);
  vtkGetMacro(EmissionArrayName, std::string);
  ///@}

  /**
   * The last modification of the medium, its phase function's object or table, its surface or its
   * image.
   */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  // The phase function as it is used. For the library's own use.
  std::shared_ptr<const airlight::PhaseShape> GetPhaseShape();

  // The source function of multiply scattered light; null where there is none, as where the medium
  // is not alone. For the library's own use.
  std::shared_ptr<const airlight::SourceFit> GetSourceFit(bool alone = true);

  // What the phase function makes of skies, with or without that of a sky of two colours. For the
  // module.
  const airlight::MediumSky& UpdateSky(bool needsHemisphere);

  // The surface as it is used; null without a region of a surface or where that is no good. For the
  // library's own use.
  std::shared_ptr<const airlight::SurfaceTree> GetSurfaceTree();

  // Emission, 0 in channels where it would be infinite, about which there is an error once. For the
  // module.
  void GetFiniteEmission(double rgb[3]);

  // The image as it is used; null without a density from an image or where that is no good. For the
  // library's own use.
  std::shared_ptr<const airlight::DensityGrid> GetDensityGrid();

  // The arrays of AlbedoArrayName and EmissionArrayName; null where there are none. For the
  // library's own use.
  std::shared_ptr<const airlight::ImageColours> GetAlbedoColours();
  std::shared_ptr<const airlight::ImageColours> GetEmissionColours();
#endif

protected:
  vtkParticipatingMedium();
  ~vtkParticipatingMedium() override;

private:
  vtkParticipatingMedium(const vtkParticipatingMedium&) = delete;
  void operator=(const vtkParticipatingMedium&) = delete;

  struct Internals;

  void Apply(const airlight::Change& change);
  bool SetCoefficients(const char* name, double target[3], double r, double g, double b);
  bool SetVector(const char* name, double target[3], double x, double y, double z);
  bool SetDirection(const char* name, double target[3], double x, double y, double z);
  bool SetNumber(const char* name, double& target, double value, bool accepted, const char* range);
  void ScaleExtinction(double meanExtinction);

  double Scattering[3] = { 0.0, 0.0, 0.0 };
  double Absorption[3] = { 0.0, 0.0, 0.0 };
  double Extinction[3] = { 0.0, 0.0, 0.0 }; // returned by GetExtinction()
  double Albedo[3] = { 1.0, 1.0, 1.0 };     // returned by GetAlbedo()
  double AmbientRadiance[3] = { 0.0, 0.0, 0.0 };
  double SkyRadiance[3] = { 0.0, 0.0, 0.0 };
  double GroundRadiance[3] = { 0.0, 0.0, 0.0 };
  double SkyHarmonics[27] = {};
  double Emission[3] = { 0.0, 0.0, 0.0 };
  vtkMTimeType EmissionProblemTime = 0; // of the medium when it was last said that it is infinite
  bool MultipleScattering = false;
  vtkMTimeType MultipleProblemTime = 0; // of the medium when it was last said that it has none

  int Region = UNBOUNDED;
  bool RegionChosen = false; // by SetRegion()
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 1.0;
  double Height = 1.0;
  double Axis[3] = { 0.0, 1.0, 0.0 };

  int Density = UNIFORM;
  bool DensityChosen = false; // by SetDensity()
  std::string AlbedoArrayName;
  std::string EmissionArrayName;
  double ScaleHeight = 1.0;
  double ReferenceHeight = 0.0;
  bool Ground = false;
  double GroundHeight = 0.0;
  double GroundAlbedo[3] = { 0.2, 0.2, 0.2 };
  double Up[3] = { 0.0, 1.0, 0.0 };

  std::unique_ptr<Internals> Impl; // phase function, surface and image
};

#endif
