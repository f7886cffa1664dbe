// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightPass
 * @brief   renders a scene in fog, smoke, dust or water, with shadows through the medium
 *
 * One line puts a renderer's scene into a medium:
 * @code
 *   renderer->SetPass(pass);
 * @endcode
 * The renderer's lights then illuminate surfaces and medium, attenuated on their way to the scene
 * and to the eye. Polygonal actors cast shadows through the medium and on surfaces. Nothing is
 * sampled at random: airlight comes from a closed form or from quadrature, shadow edges from
 * silhouettes, and the buffer "ErrorBound" bounds the error of the airlight per pixel. All
 * arithmetic is in linear radiance; see vtkAirlight::SetRadiantIntensity() for the units of a
 * vtkLight.
 *
 * Documentation/guide.md has recipes, shadow techniques, limits and costs;
 * Documentation/composition.md describes how the pass composes with VTK's other passes, inside (as
 * its DelegatePass) and outside; Documentation/physics.md has the equations.
 *
 * Errors: the scene is always rendered. If a shader, a texture or a buffer cannot be created, and
 * below OpenGL 3.3, one error says what to do and the scene is rendered without the medium;
 * GetBuffer() then returns null. The next frame tries again; a shader that did not compile is tried
 * again after 1, 3, 7, ... frames, or at once if it has changed.
 *
 * Source: V. Biri, D. Arques and S. Michelin, "Real Time Rendering of Atmospheric Scattering and
 * Volumetric Shadows", WSCG 2006 (closed form, shadow planes).
 *
 * @sa vtkAirlightPolyDataMapper vtkParticipatingMedium vtkAirlight
 */

#ifndef vtkAirlightPass_h
#define vtkAirlightPass_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkDepthImageProcessingPass.h"

#include <functional> // for the chooser of pixels
#include <memory>     // for the implementation
#include <string>     // for shader sources

class vtkImageData;
class vtkInformationDoubleVectorKey;
class vtkInformationIntegerKey;
class vtkInformationObjectBaseKey;
class vtkLight;
class vtkParticipatingMedium;
class vtkPhaseFunction;
class vtkProp;
class vtkRenderer;
class vtkUnsignedCharArray;
class vtkVolume;

namespace airlight
{
class PassRenderer;
struct DisplayStage;
}

class VTKAIRLIGHT_EXPORT vtkAirlightPass : public vtkDepthImageProcessingPass
{
public:
  static vtkAirlightPass* New();
  vtkTypeMacro(vtkAirlightPass, vtkDepthImageProcessingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The media of the scene, at most eight. Without a medium, or with a clear one, the pass only
   * adds shadows on surfaces (SetSurfaceShadows()). Null is ignored. Default: none.
   */
  void AddMedium(vtkParticipatingMedium* medium);
  void RemoveMedium(vtkParticipatingMedium* medium);
  void RemoveAllMedia();
  void SetMedium(vtkParticipatingMedium* medium);
  int GetNumberOfMedia();
  vtkParticipatingMedium* GetMedium(int index);
  ///@}

  /**
   * How shadows are computed; see "Shadow techniques" in Documentation/guide.md.
   */
  enum ShadowTechniqueType
  {
    NONE = 0,          ///< no shadows
    SHADOW_PLANES = 1, ///< from silhouette edges, to rounding; needs OpenGL 4.3
    AUTOMATIC = 2,     ///< SHADOW_PLANES where possible, else SHADOW_MAP with a warning; see below
    SHADOW_MAP = 3,    ///< lit intervals from shadow maps; see below
    RAY_MARCH = 4,     ///< SHADOW_MAP, with the integrand sampled at each step; for comparison
    FROXELS = 5        ///< a coarse grid in the view; GetEffectiveShadowTechnique() only
  };

  ///@{
  /**
   * The shadow technique. Default: AUTOMATIC.
   *
   * AUTOMATIC uses SHADOW_PLANES. It uses SHADOW_MAP for casters with more shadow boundaries than
   * SetMaximumBoundariesPerPixel() allows and for opaque casters that have no shadow planes, and in
   * frames in which OpenGL 4.3 is missing or the boundaries need too much memory. It uses FROXELS
   * for translucent casters with too many boundaries. The first frame of each kind gives a
   * warning. SHADOW_PLANES draws any number of boundaries; without OpenGL 4.3
   * it uses SHADOW_MAP with an error, casters without planes are left out with a warning, and too
   * little memory is an error.
   */
  void SetShadowTechnique(int technique);
  vtkGetMacro(ShadowTechnique, int);
  void SetShadowTechniqueToNone() { this->SetShadowTechnique(NONE); }
  void SetShadowTechniqueToShadowPlanes() { this->SetShadowTechnique(SHADOW_PLANES); }
  void SetShadowTechniqueToAutomatic() { this->SetShadowTechnique(AUTOMATIC); }
  void SetShadowTechniqueToShadowMap() { this->SetShadowTechnique(SHADOW_MAP); }
  void SetShadowTechniqueToRayMarch() { this->SetShadowTechnique(RAY_MARCH); }
  ///@}

  ///@{
  /**
   * Texels along the side of each of the six faces of a shadow map, for SHADOW_MAP and RAY_MARCH. A
   * map of one face has as many texels as six together. The graphics card limits it to a third of
   * its largest texture. Range: 16 to 8192. Default: 1024.
   */
  void SetShadowMapResolution(int resolution);
  vtkGetMacro(ShadowMapResolution, int);
  ///@}

  ///@{
  /**
   * How many shadow boundaries a pixel may have on average in each light, for AUTOMATIC. The number
   * follows from the silhouettes, before anything is drawn. If there are more, the props with the
   * most get a shadow map in place of shadow planes, until the others have no more: a swarm of
   * small things takes bounded time, while large casters keep exact edges. If translucent casters
   * and point Gaussians together cost more, a fragment as eight boundaries, they get FROXELS: their
   * shadows, and the airlight before translucent surfaces, are interpolated from a coarse grid.
   * "ErrorBound" includes estimates of both errors, but not of shadows on surfaces. With casters of
   * other processes, all keep their planes. Range: not below 0. Default: 16, beyond which
   * planes take longer than a map with Mesa's software renderer; VTK_DOUBLE_MAX for planes only.
   */
  void SetMaximumBoundariesPerPixel(double boundaries);
  vtkGetMacro(MaximumBoundariesPerPixel, double);
  ///@}

  ///@{
  /**
   * Steps along each view ray for RAY_MARCH. For shadow maps, a ray is compared with the map at 16
   * places for each step, from 32 to 1024, in the nearest of 24 planes of rays for each step, from
   * 1536 to 4096. Range: 1 to 2048. Default: 64.
   */
  void SetNumberOfSteps(int steps);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /**
   * The technique of the last frame, or of one of its lights, never AUTOMATIC; see
   * SetShadowTechnique(). SHADOW_MAP if any caster has a shadow map, else FROXELS if translucent
   * casters have a grid; NONE for a light that casts no shadows or was not in that frame.
   */
  int GetEffectiveShadowTechnique();
  int GetEffectiveShadowTechnique(vtkLight* light);
  ///@}

  ///@{
  /**
   * Whether shadows also fall on surfaces. Default: true.
   */
  vtkSetMacro(SurfaceShadows, bool);
  vtkGetMacro(SurfaceShadows, bool);
  vtkBooleanMacro(SurfaceShadows, bool);
  ///@}

  ///@{
  /**
   * Whether translucent polygonal actors cast shadows. Each of their triangles is a layer that
   * transmits 1 - opacity of the light in each colour, in both directions: n layers transmit
   * (1 - opacity)^n, in the medium, on surfaces and on translucent surfaces. Both walls of a closed
   * body attenuate, as in VTK's blending. The opacity is that of the actor's vtkProperty, or of a
   * block of composite data, times the alpha of scalars' colours and of a texture, the same for all
   * colours; SetShadowOpacity() colours shadows. Where alpha varies, a mesh is cut into parts of
   * opacity 0, 1/8, ... 1, or if nearly all of it is clear or opaque, as leaves are, at 1/2; cells
   * of one opacity keep it. Default: true.
   *
   * With SHADOW_MAP and RAY_MARCH, translucent casters cast no shadow, with one warning.
   *
   * Accuracy is that of opaque casters, except for the thickness -ln(1 - opacity) of a layer, which
   * is stored to 5e-7 (included in ErrorBound), and for sums of it above 4000 on the path of one
   * light. Opacities from 1 - 1e-6 on are opaque. A surface is not attenuated by layers within 1e-5
   * of its distance in front of it, or within 1/128 of the change of its distance from pixel to
   * pixel.
   *
   * Source: B. Kim, K. Kim and G. Turk, "A Shadow-Volume Algorithm for Opaque and Transparent
   * Nonmanifold Casters", Journal of Graphics Tools 13(3), 2008.
   */
  vtkSetMacro(TranslucentShadows, bool);
  vtkGetMacro(TranslucentShadows, bool);
  vtkBooleanMacro(TranslucentShadows, bool);
  ///@}

  ///@{
  /**
   * Whether volumes dim the lights behind them: in media, on surfaces and on other volumes,
   * whatever ShadowTechnique and SurfaceShadows are. On a way of length l through a volume
   * exp(-sigma l) of the light passes, sigma = -ln(1 - alpha)/ScalarOpacityUnitDistance as VTK
   * draws it, alpha the scalar opacity function. A volume does not shade itself.
   * SetCastsShadow() excludes volumes.
   *
   * Volumes cast if a vtkSmartVolumeMapper or vtkGPUVolumeRayCastMapper draws them, by composite
   * blending, from point scalars of one component of a vtkImageData, without cropping, clipping
   * planes, mask, gradient opacity or 2D transfer function; others give a warning that says so.
   * Media and volumes that cast are at most eight together. Accuracy and costs are in
   * Documentation/guide.md. Default: false.
   */
  vtkSetMacro(VolumeShadows, bool);
  vtkGetMacro(VolumeShadows, bool);
  vtkBooleanMacro(VolumeShadows, bool);
  ///@}

  ///@{
  /**
   * Whether light that the medium scattered once also illuminates surfaces: the soft glow around a
   * lamp close to a wall. A surface of diffuse colour rho then emits rho E/pi more, with E the
   * integral of the airlight that arrives over the surface's hemisphere. It is added to the diffuse
   * part of VTK's Phong and physically based shading and attenuated to the eye as the rest.
   * Surfaces without lighting receive nothing. At most 32 lights are scattered onto surfaces.
   * Default: false.
   *
   * Unshadowed: casters do not attenuate the scattered light, and no surface hides any part of the
   * medium.
   *
   * Relative error of E, for an optical distance of 0.01 to 10 between light and surface and phase
   * functions from g = -0.6 to 0.9, for any direction of the surface (asserted by
   * TestScatteredSurfaceLight; Documentation/accuracy.md has measured errors):
   *
   * - point and directional lights in one unbounded uniform medium: 0.3 %;
   * - spotlights without exponent in it: 1 %;
   * - point lights inside a sphere or a box: 1 %;
   * - directional lights in a box: 3 %;
   * - lights whose airlight needs quadrature (see vtkAirlight): 3 %; possibly more in fog that
   *   varies with height, or if the surface is outside several regions.
   */
  vtkSetMacro(ScatteredSurfaceLight, bool);
  vtkGetMacro(ScatteredSurfaceLight, bool);
  vtkBooleanMacro(ScatteredSurfaceLight, bool);
  ///@}

  ///@{
  /**
   * Whether the media also scatter the light of the renderer's environment
   * (vtkRenderer::SetEnvironmentTexture(), EnvironmentUp and EnvironmentRight), by its spherical
   * harmonics to order 2: as if each had them by vtkParticipatingMedium::SetSkyHarmonics(), see
   * there for what is neglected and vtkAirlight::EnvironmentHarmonics() for the texels' units. The
   * texture must be equirectangular; a cube map, or none, gives an error once, and no light. The
   * renderer's UseImageBasedLighting lights surfaces with it and is independent of this: renderers
   * that have an environment draw what they drew before unless this is on. Default: false.
   */
  vtkSetMacro(UseEnvironmentTexture, bool);
  vtkGetMacro(UseEnvironmentTexture, bool);
  vtkBooleanMacro(UseEnvironmentTexture, bool);
  ///@}

  ///@{
  /**
   * Whether the colours of VTK's mappers and backgrounds are linear radiances, as those of Phong
   * shading are. Off, they are decoded with a gamma of 2.2 before the medium is added, as
   * physically based materials need it, and the picture is encoded again
   * (SetOutputColorSpace()). Buffers are always
   * linear. Default: true.
   */
  vtkSetMacro(LinearInput, bool);
  vtkGetMacro(LinearInput, bool);
  vtkBooleanMacro(LinearInput, bool);
  ///@}

  ///@{
  /**
   * The factor of the radiance when it is shown: the first step of the display, which is exposure,
   * tone mapping, the output's colour space, dithering, in this order. Buffers are not affected.
   * 2^EV for an exposure value in stops. Range: 1e-30 to 1e30. Default: 1.
   */
  void SetExposure(double exposure);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Whether the exposure follows the picture: its middle luminance becomes middle grey, 0.18, times
   * Exposure, before tone mapping. The middle is the mean of the logarithm, in blocks of 1/64 of
   * the picture's sides, without what is black or below 1e-5 of the brightest block, the 40 % of
   * the other pixels that are darkest and the 5 % that are brightest, which are lamps. A black
   * picture changes nothing. While the user moves something the exposure follows within some
   * tenths of a second; pictures at rest are the same each time. The right eye has the exposure of
   * the left one, and a picture in tiles that of the last whole picture of its renderer, or of its
   * first tile. Debug views have Exposure alone. Default: false.
   */
  vtkSetMacro(AutomaticExposure, bool);
  vtkGetMacro(AutomaticExposure, bool);
  vtkBooleanMacro(AutomaticExposure, bool);
  ///@}

  /**
   * The factor of the radiance in the last picture: Exposure times what was measured; 1 where VTK's
   * own picture is shown.
   */
  double GetEffectiveExposure();

  /**
   * How radiances above 1 become colours. The numbers are vtkToneMappingPass's.
   */
  enum ToneMappingType
  {
    CLAMP = 0,          ///< they are white
    REINHARD = 1,       ///< x/(1 + x)
    EXPONENTIAL = 2,    ///< 1 - exp(-x)
    GENERIC_FILMIC = 3, ///< the curve of film, with VTK's default anchors and the Academy's colours
    NEUTRAL_PBR = 4     ///< Khronos PBR Neutral: hues below 0.8 stay, brighter fade to white
  };

  ///@{
  /**
   * The tone mapping curve, in linear light. Default: CLAMP.
   */
  void SetToneMapping(int curve);
  vtkGetMacro(ToneMapping, int);
  void SetToneMappingToClamp() { this->SetToneMapping(CLAMP); }
  void SetToneMappingToReinhard() { this->SetToneMapping(REINHARD); }
  void SetToneMappingToExponential() { this->SetToneMapping(EXPONENTIAL); }
  void SetToneMappingToGenericFilmic() { this->SetToneMapping(GENERIC_FILMIC); }
  void SetToneMappingToNeutralPBR() { this->SetToneMapping(NEUTRAL_PBR); }
  ///@}

  /**
   * What the numbers of the picture mean.
   */
  enum OutputColorSpaceType
  {
    LINEAR = 0,    ///< they are proportional to radiance
    GAMMA_2_2 = 1, ///< its power of 1/2.2, as VTK's physically based shading and tone mapping
    SRGB = 2       ///< IEC 61966-2-1, which screens and viewers of pictures expect
  };

  ///@{
  /**
   * The colour space of the picture. LINEAR is that of VTK's Phong shading, whose colours are shown
   * as they are; with LinearInput off it is GAMMA_2_2. Use GAMMA_2_2 for a vtkToneMappingPass
   * outside, which decodes its input, and LINEAR in a window with UseSRGBColorSpace, which encodes
   * on the screen, but not what is read back: others get a warning. Default: LINEAR.
   */
  void SetOutputColorSpace(int space);
  vtkGetMacro(OutputColorSpace, int);
  void SetOutputColorSpaceToLinear() { this->SetOutputColorSpace(LINEAR); }
  void SetOutputColorSpaceToGamma22() { this->SetOutputColorSpace(GAMMA_2_2); }
  void SetOutputColorSpaceToSRGB() { this->SetOutputColorSpace(SRGB); }
  ///@}

  ///@{
  /**
   * Whether smooth glows are kept from showing rings of 8-bit steps: a fixed pattern of less than
   * half a step is added to each pixel, with a mean of 0. Flat colours that 8 bits can hold do not
   * change, nor does clear air in VTK's own colours, nor what passes outside read. Default: true.
   */
  vtkSetMacro(Dithering, bool);
  vtkGetMacro(Dithering, bool);
  vtkBooleanMacro(Dithering, bool);
  ///@}

  ///@{
  /**
   * The same as OutputColorSpace: GAMMA_2_2 if on, LINEAR if off. Off for SRGB.
   */
  void SetEncodedOutput(bool encoded);
  bool GetEncodedOutput() { return this->OutputColorSpace == GAMMA_2_2; }
  vtkBooleanMacro(EncodedOutput, bool);
  ///@}

  ///@{
  /**
   * Whether the pass renders the annotations (vtkActor2D and other overlays) at its end. Switch it
   * off if passes outside would blur or map them, and render them with a vtkOverlayPass after the
   * outermost of these, in a vtkSequencePass. Default: true.
   */
  vtkSetMacro(Annotations, bool);
  vtkGetMacro(Annotations, bool);
  vtkBooleanMacro(Annotations, bool);
  ///@}

  /**
   * What is shown instead of the picture. Only SHADED includes translucent surfaces and volumes;
   * debug views do not affect recorded buffers.
   */
  enum DebugViewType
  {
    SHADED = 0,        ///< the picture
    AIRLIGHT_ONLY = 1, ///< what the medium scatters into the rays, without the scene
    BOUNDARY_COUNT =
      2,         ///< shadow planes on each ray: black 0, red 5, yellow 39, white 255 and more
    OUTLINES = 3 ///< the picture with the outlines of the shadow planes, red where the view
                 ///< enters a shadow, blue where it leaves it
  };

  ///@{
  /**
   * The debug view. Default: SHADED.
   */
  void SetDebugView(int view);
  vtkGetMacro(DebugView, int);
  void SetDebugViewToShaded() { this->SetDebugView(SHADED); }
  void SetDebugViewToAirlightOnly() { this->SetDebugView(AIRLIGHT_ONLY); }
  void SetDebugViewToBoundaryCount() { this->SetDebugView(BOUNDARY_COUNT); }
  void SetDebugViewToShadowPlanes() { this->SetDebugView(OUTLINES); }
  ///@}

  ///@{
  /**
   * Radius of point lights in world units: rays that pass a light more closely are shaded as if
   * they passed at this distance, which bounds the airlight near the light. With quadrature, the
   * path of the light is still attenuated. 0 uses the smallest distance that single precision
   * resolves, 1e-5 of the distance from camera to light. Range: finite, at least 0. Default: 0.
   */
  void SetLightRadius(double radius);
  vtkGetMacro(LightRadius, double);
  ///@}

  ///@{
  /**
   * How many frames make a picture: it is their mean, of radiance in single precision, with the
   * camera moved by fixed parts of a pixel. Edges of surfaces and of shadows become smooth: at
   * edges, 16 frames leave less than a fifth of the error of one frame, 64 less than a twelfth. The
   * picture is the same each time, and takes so many times as long. Recorded buffers are means,
   * too, except "Depth" and "BoundaryCount": those are of the middle of each pixel, as the depths
   * of the window are. The mean is displayed, not its frames. The renderer's FXAA is left out. One
   * frame is drawn for selections, for debug views of counts and planes, for a renderer that keeps
   * depths of others (vtkRenderer::PreserveDepthBuffer, Erase off), and for cameras with
   * UseOffAxisProjection; and while the user moves something, which a window's DesiredUpdateRate of
   * 1 or more tells, as interactor styles set it: the frame at rest that they draw then has all.
   * After each frame the pass invokes vtkCommand::ProgressEvent with the share that is done.
   * vtkRenderWindow::CheckAbortStatus() and input that waits in a window with an interactor end the
   * mean with that frame. Range: 1 to 1024. Default: 1.
   */
  vtkSetClampMacro(SubpixelFrames, int, 1, 1024);
  vtkGetMacro(SubpixelFrames, int);
  ///@}

  ///@{
  /**
   * Let the multisampling of the window smooth the edges of surfaces and of shadows, on surfaces
   * and in the air: if vtkRenderWindow::GetMultiSamples() is above 1, whatever the number, pixels
   * that differ from one of their four neighbours by more than 3 of 255 in any channel, about as
   * they are shown, are the mean of four samples of radiance: of one frame, and of three more of a
   * camera that is moved by parts of a pixel, which are drawn at these pixels alone. All others
   * are those of one frame, bit for bit. At edges, the error is about 0.4 of one frame's; things
   * thinner than a pixel may still have gaps. A frame takes about twice as long
   * (Documentation/benchmarks.md). The three frames are drawn at all pixels, which takes longer
   * and gives the same, with a DelegatePass, volumes, SSAO, hidden line removal, and translucent
   * things in a coarse grid. Without effect if SubpixelFrames is above 1, but for the one frame
   * while the user moves something, and wherever SubpixelFrames has none. Recorded buffers are
   * means at these pixels, but for "Depth" and "BoundaryCount". The renderer's FXAA is left out.
   * Clear air is VTK's own picture with the window's own samples. Default: off.
   */
  vtkSetMacro(Multisampling, bool);
  vtkGetMacro(Multisampling, bool);
  vtkBooleanMacro(Multisampling, bool);
  ///@}

  ///@{
  /**
   * Refine the picture while nothing changes, for windows: each Render() adds one frame to the
   * mean and shows it, until it has SubpixelFrames; after that Render() draws no scene and shows
   * the mean again. If the window has an interactor that is initialized, the pass asks for the
   * next frame by a timer of it, so that input comes first. The mean starts again if the
   * modification times of the renderer, its lights, props, textures and the data behind them, of
   * the media, of this pass or its DelegatePass change, or the camera's matrices; a hardware
   * selection counts as a change of the renderer. Call Modified() on this pass for other changes,
   * as of uniforms, of passes below the DelegatePass, or of inner parts of widgets. Annotations
   * (vtkActor2D) are drawn over each picture, and start nothing again. The last picture is the
   * same, bit for bit, as that of one Render() without refinement; until then depths are of a
   * pixel's middle but for half a pixel. All frames are drawn at once for stereo pairs, pictures
   * in tiles, with silhouettes of other processes, below passes that draw into framebuffers of
   * their own, and for a scene that changes whenever it is drawn. Give each renderer a pass of its
   * own: renderers that share one begin the mean again and again. Take screenshots without
   * refinement, or wait until GetAccumulatedFrames() is SubpixelFrames. Default: off, all at once.
   */
  vtkSetMacro(ProgressiveRefinement, bool);
  vtkGetMacro(ProgressiveRefinement, bool);
  vtkBooleanMacro(ProgressiveRefinement, bool);
  ///@}

  /**
   * How many frames the last picture is the mean of: 1 to SubpixelFrames, 0 before the first.
   */
  int GetAccumulatedFrames();

  ///@{
  /**
   * Maximum memory in MiB for shadow boundaries on the graphics card. A frame that needs more is
   * rendered in several horizontal bands, with the same result. The nodes on rays through volumes
   * may take as much again; render targets are not counted. "Costs and memory" in
   * Documentation/guide.md has the bytes per pixel. Range: at least 1. Default: 1024.
   */
  vtkSetClampMacro(MemoryLimit, int, 1, 1 << 20);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  ///@{
  /**
   * Whether each frame is read back into the images of GetBuffer(), which costs time. Default:
   * false.
   */
  vtkSetMacro(RecordBuffers, bool);
  vtkGetMacro(RecordBuffers, bool);
  vtkBooleanMacro(RecordBuffers, bool);
  ///@}

  ///@{
  /**
   * The same as vtkAirlightLight::SetScatters(), SetPhotometry() and SetPhotometryUp(), which
   * document units, ranges and defaults. The light keeps the values: they apply in all passes.
   * Errors are this pass's.
   */
  void SetLightScatters(vtkLight* light, bool scatters);
  bool GetLightScatters(vtkLight* light);
  bool SetLightPhotometry(vtkLight* light, const char* file);
  const char* GetLightPhotometry(vtkLight* light);
  double GetLightPhotometryMaximum(vtkLight* light);
  void SetLightPhotometryUp(vtkLight* light, double x, double y, double z);
  void GetLightPhotometryUp(vtkLight* light, double up[3]);
  ///@}

  ///@{
  /**
   * For rendering in several processes that each render a part of the scene and composite by depth
   * (ParaView): each needs the casters of the others. GetSilhouettes() serialises the silhouettes
   * of the renderer's opaque casters in each of its lights, 48 bytes per edge.
   * AddRemoteSilhouettes() adds those of another process, until RemoveAllRemoteSilhouettes().
   * Lights and camera must be the same in all processes. When a light, the camera or a caster has
   * moved in any process, exchange all again: silhouettes for another position of a light are
   * ignored. Only for shadow planes; shadow maps and translucent casters use the casters of their
   * own process.
   *
   * GetSilhouettes() returns false with an error, and no bytes, if renderer or array is null, the
   * renderer has no window, or its camera is not finite. AddRemoteSilhouettes() returns false with
   * an error that names the cause, and adds nothing, if the bytes are not complete silhouettes.
   */
  bool GetSilhouettes(vtkRenderer* renderer, vtkUnsignedCharArray* silhouettes);
  bool AddRemoteSilhouettes(vtkUnsignedCharArray* silhouettes);
  void RemoveAllRemoteSilhouettes();
  ///@}

#ifndef __VTK_WRAP__
  /**
   * For the same programs: leaves pixels to the processes that have something nearer there. The
   * function is called in each frame of a renderer, of each eye, once its opaque surfaces are
   * drawn, with their depths (0 to 1; 1 where there is none; rows from the bottom); twice if the
   * frame has to be drawn again with less memory. It writes 0 into `drawn`, which holds 1, for each
   * pixel that another process draws, and returns true; or false, if all shall be drawn.
   *
   * Pixels left out are transparent black in the picture, at depth 1; in a renderer above others
   * they stay as they were. VTK's FXAA reads the pixels around one: draw some more then. Null, the
   * default: all are drawn.
   *
   * It is not called by frames with translucent surfaces, point Gaussians, volumes,
   * SubpixelFrames, multisampling, automatic exposure, recorded buffers, debug views, ambient
   * occlusion, hidden line removal or a delegate, nor by frames in clear air without shadows: these
   * draw all pixels. C++ only.
   */
  using PixelChooser =
    std::function<bool(int width, int height, const float* depths, unsigned char* drawn)>;
  void SetPixelChooser(const PixelChooser& chooser);
#endif

  /**
   * The buffer of this name of the last frame, or null before the first recorded frame or for an
   * unknown name; of the renderer rendered last. Single precision, linear, bottom row first. The
   * size is that of the renderer, or of the target of a pass outside (larger for vtkSSAAPass,
   * vtkDepthOfFieldPass and vtkGaussianBlurPass):
   *
   * - "Radiance" (RGB): the radiance that reaches the eye, background included, W/(m^2 sr);
   * - "Airlight" (RGB): the part that the medium scattered into the ray;
   * - "MultipleScattering" (RGB): the part of "Airlight" that was scattered more than once; 0
   *   unless vtkParticipatingMedium::SetMultipleScattering() is on;
   * - "Surface" (RGB): the part from opaque surfaces, attenuated; 0 without a surface;
   * - "Transmittance" (RGB): from the eye to the surface, or to the far side of the medium;
   * - "Depth": distance along the unit ray, world units; -1 without a surface;
   * - "LitLength": length of the ray inside media (overlaps count once) that light of any colour
   *   reaches, attenuated or not, summed over lights;
   * - "BoundaryCount": number of shadow planes and of triangles of translucent casters that the ray
   *   crosses, or of changes between light and shadow that a shadow map has on it, summed over
   *   lights;
   * - "ErrorBound": maximum error of each component of "Airlight", W/(m^2 sr). It is the sum of:
   *   for each light, vtkParticipatingMedium::GetPhaseErrorBound() times its airlight; 1e-4 (closed
   *   forms), 1e-3 (quadrature) or 1e-2 (density images that a region cuts, volumes that cast
   *   shadows) of the ray's airlight without shadows; and 1e-4 of the ambient part, or of light
   *   that is scattered more than once vtkParticipatingMedium::GetMultipleScatteringErrorBound()
   *   and 1e-2, in an unbounded medium (not of boundaries, height fog and casters). With density
   *   images the share of the airlight grows by the largest error of the light's grid in optical
   *   depth at 500 positions between its points, measured when the grid is computed. Shadow maps
   *   add an estimate of theirs, which holds for 99 % of the pixels. Not included are rays within
   *   rounding of a shadow edge, some 1e-6 of its distance, and the errors of RAY_MARCH;
   * - "Airlight:0", "Airlight:1", ... (RGB): the airlight of each switched-on light that was
   *   scattered once, in the order of the renderer's lights.
   */
  vtkImageData* GetBuffer(const char* name);

  ///@{
  /**
   * Whether a prop casts shadows: through media, and on surfaces if SurfaceShadows is on. The pass
   * and vtkAirlightReference read it. Of an assembly it is that of all its parts. Default: true. It
   * is the key CASTS_SHADOW() in the prop's property keys, where 0 means false. Keys that several
   * props share are copied, so that the other props do not change. A null prop gives an error.
   * @code
   *   vtkAirlightPass::SetCastsShadow(actor, false);
   * @endcode
   */
  static void SetCastsShadow(vtkProp* prop, bool casts);
  static vtkInformationIntegerKey* CASTS_SHADOW();
  ///@}

  ///@{
  /**
   * Whether a volume is a medium itself: smoke, cloud or tissue that scatters the lights, shades
   * itself and all else, in place of the glowing fog that ray casting makes of it. Its extinction
   * is that of VolumeShadows, its albedo at each place is its colour function; colours count as
   * they are, without gamma, and shading and ambient properties have no effect. The pass draws it,
   * among at most eight media, and vtkAirlightReference reads it, too. Default: false. It is the
   * key VOLUME_SCATTERS() in the volume's property keys, where 1 means true.
   *
   * The volume must be a visible prop of the renderer and one that can cast shadows
   * (VolumeShadows); others give a warning and are drawn by VTK. In an assembly the key has no
   * effect. Beside it no medium has MultipleScattering. Delegates that draw the renderer's own list
   * of props draw it twice. A null volume gives an error.
   * @code
   *   vtkAirlightPass::SetVolumeScatters(plume, true);
   * @endcode
   */
  static void SetVolumeScatters(vtkVolume* volume, bool scatters);
  static vtkInformationIntegerKey* VOLUME_SCATTERS();
  ///@}

  ///@{
  /**
   * The phase function of a volume that is a medium: smoke and clouds scatter forward. Several
   * volumes and media may share it, and changes of its parameters are followed. Default: null,
   * which is isotropic. It is the key VOLUME_PHASE_FUNCTION() in the volume's property keys. A null
   * volume gives an error.
   * @code
   *   vtkNew<vtkHenyeyGreensteinPhaseFunction> forward;
   *   forward->SetAnisotropy(0.8);
   *   vtkAirlightPass::SetVolumePhaseFunction(plume, forward);
   * @endcode
   */
  static void SetVolumePhaseFunction(vtkVolume* volume, vtkPhaseFunction* function);
  static vtkInformationObjectBaseKey* VOLUME_PHASE_FUNCTION();
  ///@}

  ///@{
  /**
   * The opacity of a prop's shadow for red, green and blue, in place of that of its vtkProperty;
   * opaque props may have it, too. Range: from 0 (no shadow) to 1. Default: none. It is the key
   * SHADOW_OPACITY() in the prop's property keys; remove the key to use the vtkProperty's opacity
   * again. Of an assembly it is that of all its parts, whose own keys VTK replaces. Keys that
   * several props share are copied. See SetTranslucentShadows().
   *
   * A null prop, or a value that is not in range, gives an error, and nothing changes. A key that
   * was set to other than three such values is reported once, and ignored.
   * @code
   *   vtkAirlightPass::SetShadowOpacity(actor, 0.1, 0.8, 0.9); // red glass
   * @endcode
   */
  static void SetShadowOpacity(vtkProp* prop, double red, double green, double blue);
  static vtkInformationDoubleVectorKey* SHADOW_OPACITY();
  ///@}

  void Render(const vtkRenderState* s) override;        ///< Draws a frame; called by vtkRenderer
  void ReleaseGraphicsResources(vtkWindow* w) override; ///< Frees what is on the graphics card
  vtkMTimeType GetMTime() override;                     ///< Includes the media's times

  ///@{
  /**
   * Called by VTK's mappers while they build and use their shaders.
   */
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkAirlightPass();
  ~vtkAirlightPass() override;

private:
  vtkAirlightPass(const vtkAirlightPass&) = delete;
  void operator=(const vtkAirlightPass&) = delete;

  airlight::DisplayStage GetDisplay(const vtkRenderState* s) const;

  int ShadowTechnique = AUTOMATIC;
  int ShadowMapResolution = 1024;
  double MaximumBoundariesPerPixel = 16.0;
  int NumberOfSteps = 64;
  bool SurfaceShadows = true;
  bool TranslucentShadows = true;
  bool VolumeShadows = false;
  bool ScatteredSurfaceLight = false;
  bool UseEnvironmentTexture = false;
  bool LinearInput = true;
  double Exposure = 1.0;
  bool AutomaticExposure = false;
  int ToneMapping = CLAMP;
  int OutputColorSpace = LINEAR;
  bool Dithering = true;
  bool Annotations = true;
  int DebugView = SHADED;
  double LightRadius = 0.0;
  int SubpixelFrames = 1;
  bool Multisampling = false;
  bool ProgressiveRefinement = false;
  int MemoryLimit = 1024;
  bool RecordBuffers = false;

#ifndef __VTK_WRAP__
  PixelChooser ChoosePixels;
#endif
  std::unique_ptr<airlight::PassRenderer> Impl;
};

#endif
