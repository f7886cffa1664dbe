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
 * Every switched-on light of the renderer then lights the surfaces and the medium alike, but for lights
 * that are fixed to the camera, which light the surfaces only (see SetLightScatters()). Both are
 * attenuated on the way from the light and on the way to the eye. Polygonal actors cast shadows
 * through the medium and on the surfaces, translucent ones by their opacity; what casts none is among
 * the limits. Nothing is sampled at random: the light scattered into a ray comes from a
 * closed form or, if there is none, from quadrature, and the shadows' edges from silhouettes. The
 * buffer "ErrorBound" says how far the airlight may be off.
 *
 * All arithmetic is in linear radiance. What VTK's mappers show is taken as linear, unless
 * SetLinearInput() says otherwise; the picture is written without tone mapping. See vtkAirlight::SetRadiantIntensity() for the units of
 * a vtkLight.
 *
 * Order: opaque geometry (with the renderer's SSAO and hidden line removal), the medium, translucent
 * geometry (order-independent, peeled or blended as the renderer says), volumes, FXAA, annotations.
 * The window's multisampling is without effect: the pass draws into textures of its own. For smooth
 * edges use FXAA or SSAA. Documentation/composition.md tells what to expect of VTK's other passes
 * inside and outside this one.
 *
 * A DelegatePass draws the opaque geometry, before the medium: it is shown props that draw nothing
 * else. What blends over the medium the pass then draws itself, with the delegate's translucent
 * pass (vtkTranslucentPass, vtkOrderIndependentTranslucentPass, vtkDepthPeelingPass) if there is
 * one in it. So ambient occlusion or eye-dome lighting as the delegate darken surfaces, and fog
 * lies over them.
 *
 * Cost: the opaque scene is drawn once without shadows on surfaces, or if one of at most four lights
 * casts them; else twice (distances first, then colours), as with a delegate, hidden lines, casters that
 * let light through and some surfaces. The translucent scene is drawn twice. The closed form is
 * evaluated once per pixel and light, plus once per visible edge of a shadow volume, quadrature once
 * per lit interval of a ray; each silhouette edge seen from a light is drawn as one quadrilateral.
 * Silhouettes, fits of phase functions and the trees of closed surfaces are kept until they change.
 *
 * Limits:
 *  - A directional light in an unbounded uniform medium arrives unattenuated.
 *  - What has no closed form takes quadrature, within 1e-3. That is lights outside the
 *    region of a bounded medium, with photometric files, other attenuations than the inverse square
 *    or exponents; regions of closed surfaces; Mie's phase functions and tables that no fit
 *    follows, but for directional lights in an unbounded medium or a box; directional lights in a
 *    sphere; height fog, but for directional lights where it is unbounded; several media.
 *  - Headlights and camera lights neither scatter nor cast shadows unless SetLightScatters(light,
 *    true) is called. Headlights cast none even then: they see what the camera sees.
 *  - Volumes, lines, points and wireframes cast no shadows; point gaussians, imposters and the glyphs
 *    of composite data or of a tree of sources only with shadow maps (see SetShadowTechnique()). Translucent surfaces dim light
 *    (SetTranslucentShadows()).
 *  - A vtkLODProp3D casts by the level of detail that VTK chose for its last frame; before its first
 *    frame (outside the view), by the one that is selected or, if VTK is to choose, that was added
 *    first. A level that is a volume or an image casts none, and one warning says so.
 *  - Translucent surfaces and point gaussians are put behind the medium before them, fragment by
 *    fragment, with its shadows (32 bytes a fragment); without OpenGL 4.3 without
 *    shadows. VTK's depth peeling keeps 8 bits a layer (5e-3) and clips radiances above 1.
 *  - Volumes that are drawn by ray casting on the graphics card (vtkGPUVolumeRayCastMapper,
 *    vtkSmartVolumeMapper, vtkMultiVolume) with the blend mode composite, isosurface or slice are lit
 *    by what arrives of the lights, and put behind the medium before them, sample by sample. The
 *    medium before the samples is known at sixteen nodes between where a ray enters the volume and
 *    where it leaves it, and interpolated: in smooth fog within 1e-5, at the edges of shadows and
 *    media and close to a lamp within what the air between two nodes scatters. On samples, the edges
 *    of shadows are as wide as nodes are apart. 512 bytes a pixel; fewer nodes where volumes over all
 *    pixels would take more than GetMemoryLimit(). Without OpenGL 4.3 without shadows. Surfaces'
 *    scattered light does not light volumes.
 *    Projections (maximum, minimum, average, additive) and volumes of other mappers
 *    (vtkFixedPointVolumeRayCastMapper, those of unstructured grids) are drawn without the medium
 *    before them, and one warning says so.
 *  - Props that draw with actors of their own (axes, skyboxes) are fogged by the depth buffer, to its
 *    precision; billboard texts and annotations are not fogged.
 *  - A DelegatePass that draws the renderer's list of props instead of those it is given (one that
 *    calls vtkRenderPass::UpdateGeometry(), as ParaView's does) draws volumes, and translucent parts
 *    of assemblies, before the medium: they are fogged as what lies behind them. Annotations are
 *    then drawn twice, before the medium and over it.
 *  - The renderer's FXAA is left out, with one warning, where a pass outside gives a target of
 *    floating point or of another size, which VTK's FXAA cannot do.
 *  - A vtkSSAOPass outside needs the positions and normals of surfaces, which it does not get; one
 *    warning says so. Make it the delegate.
 *  - VTK's own shadow maps (vtkRenderer::UseShadows) are not drawn besides those of the pass.
 *  - At most eight media; where they overlap, their coefficients add.
 *  - A medium whose density is an image (vtkParticipatingMedium::SetDensityToImage()) must be the only
 *    one and its region no closed surface, or an error says so. Rays are followed from cell to cell,
 *    between the same boundaries of shadows as in other media, in steps as short as density and light
 *    ask for; cells of an optical depth above 20 look darker than they are. What a light loses on its
 *    way comes from a grid of its own, of at most 65 points along the image's longest side, refined
 *    until it is good for 1e-3, and computed on the CPU whenever light, image or medium change: some
 *    milliseconds for smooth images, a second for others. What arrives on surfaces does without it. A
 *    frame takes up to some times as long as in a uniform box, in proportion to the image's points on a ray.
 *    SetScatteredSurfaceLight() has no effect there, and one warning says so.
 *  - A layer that keeps the depth of those below (vtkRenderer::SetPreserveDepthBuffer()) is drawn
 *    over them. Over other layers the medium is as opaque as the mean of its colours.
 *  - Shadows from silhouettes need OpenGL 4.3, polygons that cast and not too many of them; else
 *    they come from shadow maps, and one warning says so (see SetShadowTechnique()).
 *
 * One pass may serve several renderers, of one window or of several. In several windows at once it
 * makes all its OpenGL objects anew whenever the window changes; a pass for each is faster.
 *
 * Errors: the pass never loses the scene. Where a shader, a texture or a buffer cannot be had, and below
 * OpenGL 3.3, it reports one error, which says what to do, and draws the scene without the medium;
 * GetBuffer() is null then. The next frame tries anew; a shader that did not compile is tried again
 * after 1, 3, 7, ... frames, or at once where it is another one.
 *
 * Sources: V. Biri, D. Arques and S. Michelin, "Real Time Rendering of Atmospheric Scattering and
 * Volumetric Shadows", WSCG 2006 (closed form, shadow planes).
 *
 * @sa vtkAirlightPolyDataMapper vtkParticipatingMedium vtkAirlight
 */

#ifndef vtkAirlightPass_h
#define vtkAirlightPass_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkDepthImageProcessingPass.h"

#include <memory> // for the implementation
#include <string> // for shader sources

class vtkImageData;
class vtkInformationDoubleVectorKey;
class vtkInformationIntegerKey;
class vtkLight;
class vtkParticipatingMedium;
class vtkProp;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace airlight
{
class PassRenderer;
}

class VTKAIRLIGHT_EXPORT vtkAirlightPass : public vtkDepthImageProcessingPass
{
public:
  static vtkAirlightPass* New();
  vtkTypeMacro(vtkAirlightPass, vtkDepthImageProcessingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The media of the scene. Without a medium, or with a clear one, the scene keeps its look, apart
   * from the shadows on surfaces (SetSurfaceShadows()). Null is ignored.
   */
  void AddMedium(vtkParticipatingMedium* medium);
  void RemoveMedium(vtkParticipatingMedium* medium);
  void RemoveAllMedia();
  void SetMedium(vtkParticipatingMedium* medium);
  int GetNumberOfMedia();
  vtkParticipatingMedium* GetMedium(int index);
  ///@}

  /**
   * How shadows are found.
   */
  enum ShadowTechniqueType
  {
    NONE = 0,          ///< no shadows
    SHADOW_PLANES = 1, ///< from silhouette edges, to rounding; needs OpenGL 4.3
    AUTOMATIC = 2,     ///< SHADOW_PLANES where possible, else SHADOW_MAP with a warning; see below
    SHADOW_MAP = 3,    ///< lit intervals from shadow maps; see below
    RAY_MARCH = 4      ///< SHADOW_MAP, with the integrand sampled at each step; for comparison
  };

  ///@{
  /**
   * The shadow technique. Default: AUTOMATIC.
   *
   * SHADOW_MAP draws what casts shadows from each light into a map of distances: six square faces
   * around a light at a place, one for a spot of up to 60 degrees or a directional light. Each view
   * ray is walked in GetNumberOfSteps() steps, of equal angle seen from a light at a place; where
   * light turns into shadow or back between two steps, eight halvings find the place, and each lit
   * interval is integrated as with SHADOW_PLANES. Edges of shadows are as coarse as the map's
   * texels, and what begins and ends within one step is missed. Faces do not shadow
   * themselves: the map holds the largest distance of each face within three quarters of a texel,
   * which is a bias by the face's slope. On surfaces the nearest of four texels counts, which shrinks
   * shadows by up to half a texel. A directional light's map covers all that casts.
   *
   * Besides the polygons that cast with SHADOW_PLANES, opaque actors of other mappers cast, as those
   * draw them: glyphs, point gaussians, imposters, as parts of assemblies, too. While there are any,
   * maps are drawn anew each frame, with a camera of each face as the renderer's active one.
   *
   * RAY_MARCH takes the integrand in the middle of each step, in the same maps: what others do.
   *
   * AUTOMATIC takes SHADOW_PLANES, but SHADOW_MAP in frames of which one of these is true:
   *  - the window lacks OpenGL 4.3 with storage buffers;
   *  - an opaque actor casts whose mapper draws something else than its input's polygons, from which
   *    planes cannot be drawn: point gaussians, imposters, glyphs of composite data or of a tree
   *    of sources. For shadow planes of all others, keep it from casting with CASTS_SHADOW();
   *  - the boundaries of a light's shadows need more than sixteen times GetMemoryLimit(), or those
   *    of one row of pixels more than GetMemoryLimit(). Such a frame is begun twice.
   * The first frame of each of the three kinds gives a warning that names it.
   *
   * SHADOW_PLANES takes SHADOW_MAP where OpenGL 4.3 is missing, with an error; leaves out casters that
   * planes cannot be drawn from, with a warning that names their mapper; and fails
   * with an error where one row of pixels is too much.
   *
   * Cost of SHADOW_MAP: for each light 24 bytes a texel of a face (24 MiB at 1024 texels a side), drawn
   * anew when the light or a caster changes; per pixel and light GetNumberOfSteps() look-ups and one
   * closed form per boundary found.
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
   * Texels along the side of each of the six faces of a shadow map, for SHADOW_MAP and RAY_MARCH;
   * a map of one face has as many texels as six together. A third of the largest texture that the graphics card has
   * is the most that it can draw.
   * Range: 16 to 8192. Default: 1024.
   */
  void SetShadowMapResolution(int resolution);
  vtkGetMacro(ShadowMapResolution, int);
  ///@}

  ///@{
  /**
   * Steps along each view ray, for SHADOW_MAP and RAY_MARCH. Range: 1 to 2048. Default: 64.
   */
  void SetNumberOfSteps(int steps);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  /**
   * The technique used in the last frame: any but AUTOMATIC, whose rule is that of
   * SetShadowTechnique().
   */
  int GetEffectiveShadowTechnique();

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
   * Whether translucent polygonal actors cast shadows. Each of their triangles is a layer that lets
   * 1 - opacity of the light through, in each colour, whichever way it faces: light behind n layers is
   * dimmed by (1 - opacity)^n, in the medium, on surfaces and on translucent surfaces. A closed body
   * dims by both its walls, as VTK's blending dims what is seen through it. The opacity is that of the
   * actor's vtkProperty, or of a block of composite data, the same for all colours; see
   * SHADOW_OPACITY() for glass that has a colour. Opacities of colours, lookup tables or textures vary
   * over a surface and are left out of account: an actor that is translucent by them alone casts no
   * shadow, unless that key says otherwise.
   *
   * As accurate as the shadows of opaque actors, but for the thickness -ln(1 - opacity) of a layer, which
   * is kept to 5e-7 (ErrorBound counts that), and for sums of it above 4000 on the way of one light.
   * Opacities from 1 - 1e-6 on block light wholly. A surface is not dimmed by what lies within 1e-5 of
   * its distance before it, or less than 1/128 of what its distance changes by from pixel to pixel.
   *
   * With SHADOW_MAP and RAY_MARCH what lets light through casts no shadow, and one warning says so.
   *
   * Cost, while there are such casters: all boundaries in lists of 24 bytes each, on surfaces 8 bytes a
   * pixel and light, a closed form for each boundary; each of their triangles is drawn for each light.
   * Without them: none.
   *
   * Default: true.
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
   * Whether surfaces are also lit by the light that the medium scattered once on its way to them:
   * the soft glow around a lamp close to a wall. A surface of diffuse colour rho then sends
   * rho E/pi more, with E the integral of the airlight that arrives over the surface's hemisphere;
   * it shows in the diffuse part of VTK's Phong and physically based shading and is attenuated to
   * the eye as the rest. Surfaces without lighting get nothing.
   * Default: false.
   *
   * Unshadowed: neither is the scattered light dimmed by casters, nor do other surfaces, or the
   * surface itself where it lies between the light and the viewer, hide any of the medium.
   *
   * Error of E, relative, in fog of optical distance 0.01 to 10 between lamp and surface, with
   * phase functions from g = -0.6 to 0.9, for any direction of the surface (asserted by
   * TestScatteredSurfaceLight; measured there: median, largest):
   *  - point and directional lights in one unbounded uniform medium: 0.3 % (2e-5, 7e-4);
   *  - spots without exponent in it: 1 % (3e-5, 3e-4);
   *  - point lights inside a sphere or a box: 1 % (3e-4, 6e-3);
   *  - directional lights in a box: 3 % (6e-4, 2.1e-2, where little light arrives);
   *  - lights that the pass integrates by quadrature (see vtkAirlight): 3 % (1e-3, 1.4e-3); in fog
   *    that varies with height, or where the surface is outside several regions, it can be more.
   *
   * Cost: in one unbounded medium without spots 16 to 32 evaluations of the closed form per pixel
   * and light, else 377 to 1597: for graphics cards rather than for software rendering.
   *
   * At most 32 lights are scattered onto surfaces.
   */
  vtkSetMacro(ScatteredSurfaceLight, bool);
  vtkGetMacro(ScatteredSurfaceLight, bool);
  vtkBooleanMacro(ScatteredSurfaceLight, bool);
  ///@}

  ///@{
  /**
   * Whether the colours that VTK's mappers and backgrounds give are linear radiances, as those of
   * Phong shading are. Off, they are taken as encoded for display with a gamma of 2.2, as physically
   * based materials give them: decoded before the medium is put before them, and the picture encoded
   * again. Buffers are linear in any case. Default: true.
   */
  vtkSetMacro(LinearInput, bool);
  vtkGetMacro(LinearInput, bool);
  vtkBooleanMacro(LinearInput, bool);
  ///@}

  ///@{
  /**
   * Whether the picture is encoded for display with a gamma of 2.2, which is done in any case where
   * LinearInput is off. On for a vtkToneMappingPass outside: it decodes what it is given before it
   * maps it. Buffers are linear in any case. Default: false.
   */
  vtkSetMacro(EncodedOutput, bool);
  vtkGetMacro(EncodedOutput, bool);
  vtkBooleanMacro(EncodedOutput, bool);
  ///@}

  ///@{
  /**
   * Whether the pass ends with the annotations (vtkActor2D and what else draws overlays). Off where
   * passes outside would blur or map them: then a vtkOverlayPass after the outermost of these, in a
   * vtkSequencePass, draws them as they are. Default: true.
   */
  vtkSetMacro(Annotations, bool);
  vtkGetMacro(Annotations, bool);
  vtkBooleanMacro(Annotations, bool);
  ///@}

  /**
   * What is shown instead of the picture, to see what the pass does. Translucent surfaces and volumes
   * are left out of all but SHADED; recorded buffers are not touched.
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
   * they passed at this distance, which bounds the airlight near the light; by quadrature the medium
   * attenuates light on its own way. 0 is the least that single precision resolves, 1e-5 of the distance
   * from camera to light. Range: finite, at least 0. Default: 0.
   */
  void SetLightRadius(double radius);
  vtkGetMacro(LightRadius, double);
  ///@}

  ///@{
  /**
   * Most memory in MiB that the boundaries of shadows may take on the graphics card: 64 bytes a pixel,
   * which hold 16 of them, or 128 bytes, which hold 32, where a light has more than 8192 silhouette
   * edges; 12 bytes for each on pixels with more; and 16 bytes a pixel that the limit does not count.
   * Where casters let light through (SetTranslucentShadows()), 24 bytes for each and 16 a pixel. A frame
   * that needs more is drawn in several horizontal bands, with the same result.
   * The nodes on rays through volumes may take as much again. Render targets are not counted either:
   * every frame needs 40 to 96 bytes a pixel for them, 80 more with RecordBuffersOn() (1.3 to 5.9 GB at
   * 7680 x 4320). Draw larger pictures in tiles, by vtkWindowToImageFilter::SetScale().
   * Range: at least 1. Default: 1024.
   */
  vtkSetClampMacro(MemoryLimit, int, 1, 1 << 20);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  ///@{
  /**
   * Whether each frame is read back into the images of GetBuffer(). It costs time. Default: false.
   */
  vtkSetMacro(RecordBuffers, bool);
  vtkGetMacro(RecordBuffers, bool);
  vtkBooleanMacro(RecordBuffers, bool);
  ///@}

  ///@{
  /**
   * Whether the medium scatters this light. When off, the light illuminates surfaces only, attenuated
   * by the medium: for lamps that are there to show an object, not the air. Lights of the scene still
   * cast shadows on surfaces then; lights that are fixed to the camera (headlights, camera lights,
   * those of vtkLightKit, and the light that a renderer creates by itself) cast none. Default: true
   * for lights of the scene, false for those fixed to the camera. One warning says how many of them
   * a medium leaves out, until this is called for them.
   */
  void SetLightScatters(vtkLight* light, bool scatters);
  bool GetLightScatters(vtkLight* light);
  ///@}

  ///@{
  /**
   * Let a positional light shine as a photometric file of IES LM-63 (*.ies) says: its colour and
   * intensity are those of the brightest direction, all others are the file's share of it, for
   * medium and surfaces alike. The light aims from its position at its focal point. Photometric
   * types A, B and C, linear between the file's angles, nothing beyond them; the lamp is a point,
   * its tilt is ignored. Airlight is integrated by quadrature, within 1e-3, cell by cell of the
   * file's table: three or eight nodes for each cell that a ray crosses. A spot's cone and exponent
   * apply besides. Directional lights, and lamps whose focal point is their position, shine as
   * without the file, and one warning says so.
   *
   * False, with an error that names file, line and culprit, and the light as it was, where the file
   * is no good. Null or an empty name: as without a file, the default.
   */
  bool SetLightPhotometry(vtkLight* light, const char* file);
  const char* GetLightPhotometry(vtkLight* light);
  ///@}

  /**
   * The largest intensity in the light's photometric file, candela; 0 without one. For a light whose
   * vtkAirlight::SetRadiantIntensity() is to be the file's own.
   */
  double GetLightPhotometryMaximum(vtkLight* light);

  ///@{
  /**
   * How the photometric file is turned about the light's axis: the direction, made perpendicular to
   * the axis, of its horizontal angle 0 (type C, counted counter-clockwise for who looks along the
   * axis) or of its vertical angle 90 (types A and B). World coordinates; for headlights and camera
   * lights the camera's. Range: finite, not 0. Default: (0, 1, 0); where that lies along the axis,
   * (0, 0, 1).
   */
  void SetLightPhotometryUp(vtkLight* light, double x, double y, double z);
  void GetLightPhotometryUp(vtkLight* light, double up[3]);
  ///@}

  ///@{
  /**
   * Rendering in several processes, each of which draws a part of the scene, and whose pictures are
   * put together by depth (ParaView): each needs to know what casts shadows in the others.
   * GetSilhouettes() makes bytes to send to them, the silhouettes of the renderer's opaque casters in
   * each of its lights, 48 bytes an edge; AddRemoteSilhouettes() takes those of another process,
   * until RemoveAllRemoteSilhouettes(). Lights and camera must be the same in all processes. Whenever
   * a light, the camera or a caster has moved anywhere, make, send and set all anew: what was made for
   * another place of a light is left out. For shadow planes; shadow maps and casters that let light
   * through know their own process alone.
   *
   * GetSilhouettes(): false with an error, and no bytes, where renderer or array are null, the
   * renderer has no window, or its camera is not finite. AddRemoteSilhouettes(): false with an error
   * that says what is wrong, and nothing added, where the bytes are not such silhouettes, whole.
   */
  bool GetSilhouettes(vtkRenderer* renderer, vtkUnsignedCharArray* silhouettes);
  bool AddRemoteSilhouettes(vtkUnsignedCharArray* silhouettes);
  void RemoveAllRemoteSilhouettes();
  ///@}

  /**
   * The last frame's buffer of this name, or null before the first recorded frame or for an
   * unknown name; of the renderer drawn last. Single precision, linear, bottom row first, of the
   * renderer's size, or of the target's that a pass outside gives (larger for vtkSSAAPass,
   * vtkDepthOfFieldPass and vtkGaussianBlurPass):
   *  - "Radiance" (RGB): what reaches the eye, background included, W/(m^2 sr);
   *  - "Airlight" (RGB): the part that the medium scattered into the ray;
   *  - "Surface" (RGB): the part that opaque surfaces sent, attenuated; 0 where there is none;
   *  - "Transmittance" (RGB): from the eye to the surface, or to the far side of the medium;
   *  - "Depth": distance along the unit ray, world units; -1 where there is no surface;
   *  - "LitLength": length of the ray inside media (once where they overlap) that light of any colour
   *    reaches, dimmed or not, summed over lights;
   *  - "BoundaryCount": number of shadow planes that the ray crosses, and of translucent casters' triangles, or of changes between light
   *    and shadow that a shadow map shows on it, summed over lights;
   *  - "ErrorBound": how far each component of "Airlight" may be from the exact integral, W/(m^2 sr):
   *    for each light the error bound of the medium's phase function
   *    (vtkParticipatingMedium::GetPhaseErrorBound()) times the light's airlight, and 1e-4 (closed
   *    forms) or 1e-3 (quadrature) of the airlight that the ray would have without shadows; and 1e-4
   *    of the ambient part. Where an image is the density, the 1e-3 grow by the largest error that the
   *    light's grid has in optical depth at 500 places between its points, measured whenever it is
   *    made. A ray that meets the very edge of a shadow within rounding, some 1e-6
   *    of its distance, may fall on either side of it, which this does not count, nor what
   *    SHADOW_MAP and RAY_MARCH miss;
   *  - "Airlight:0", "Airlight:1", ... (RGB): the airlight of each switched-on light, in the order
   *    of the renderer's lights.
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

  int ShadowTechnique = AUTOMATIC;
  int ShadowMapResolution = 1024;
  int NumberOfSteps = 64;
  bool SurfaceShadows = true;
  bool TranslucentShadows = true;
  bool ScatteredSurfaceLight = false;
  bool LinearInput = true;
  bool EncodedOutput = false;
  bool Annotations = true;
  int DebugView = SHADED;
  double LightRadius = 0.0;
  int MemoryLimit = 1024;
  bool RecordBuffers = false;

  std::unique_ptr<airlight::PassRenderer> Impl;
};

#endif
