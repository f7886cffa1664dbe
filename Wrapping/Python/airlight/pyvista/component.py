# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""``plotter.airlight``: fog, smoke, dust and water in PyVista's plots."""

from __future__ import annotations

from typing import Any
import weakref

import pyvista as pv

from airlight import vtkAirlightPass, vtkParticipatingMedium
from airlight.windows import require_screen

from . import arguments, buffers
from .lamp import Lamp, make_lamp, make_sun
from .settings import Settings
from .smooth_edges import SmoothEdges
from .state import medium_from_dict, medium_to_dict
from .subplot import Subplot


@pv.register_plotter_component("airlight")
class AirlightComponent:
    """The medium of a plotter's active subplot: ``plotter.airlight``.

    Each subplot has a medium, lamps and a pass of its own; methods and properties are those of the
    subplot that is active when they are called. Lengths are in units of the scene. The methods
    that change something return the component, or the light that they made.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter, which is not kept alive.

    Examples
    --------
    >>> import pyvista as pv
    >>> pl = pv.Plotter(off_screen=True)
    >>> _ = pl.add_mesh(pv.Sphere())
    >>> pl.airlight.enable(visibility=15, anisotropy=0.6).describe()
    'Airlight(visibility=15, anisotropy=0.6, shadows=automatic, 1 lamp (derived))'
    """

    def __init__(self, plotter: pv.Plotter) -> None:
        self._plotter = weakref.ref(plotter)
        self._subplots: list[tuple[Any, Subplot]] = []
        self._edges = SmoothEdges()

    def _active(self) -> Subplot:
        plotter = self._plotter()
        if plotter is None or plotter.render_window is None:
            raise RuntimeError("The plotter is closed: plotter.airlight can no longer be used. "
                               "Make a new Plotter, or keep this one by show(auto_close=False).")
        renderer = plotter.renderer
        for known, subplot in self._subplots:
            if known() is renderer:
                return subplot
        subplot = Subplot(plotter, renderer, self._edges)
        self._subplots.append((weakref.ref(renderer), subplot))
        return subplot

    def __plotter_close__(self) -> None:
        """Give up what the renderers hold, while the window is there."""
        for _, subplot in self._subplots:
            subplot.close()
        self._subplots.clear()

    def __plotter_deep_clean__(self) -> None:
        """Give up what the renderers hold; the plotter may be used again."""
        self.__plotter_close__()

    def enable(self, visibility: float | None = None, anisotropy: float | None = None, *,
               albedo: Any = 1.0, ambient: Any = None, multiple_scattering: bool = False,
               region: Any = None, emission: Any = None,
               density: pv.ImageData | None = None, albedo_array: str | None = None,
               emission_array: str | None = None, scale_height: float | None = None,
               reference_height: float | None = None,
               medium: vtkParticipatingMedium | None = None, shadows: bool | str = True,
               lamp: bool | None = None, white: float = 1.0,
               anti_aliasing: bool | str | None = None, tone_mapping: str | None = None,
               color_space: str = "linear", frames: int = 1,
               progressive: bool = False) -> AirlightComponent:
        """Put the active subplot into a medium.

        What is None is derived from the scene at the first frame, and again if the scene's size
        changes by half. A second call replaces all settings of the first one.

        Parameters
        ----------
        visibility : float, optional
            The distance at which the contrast of a black object against the horizon has fallen to
            2 %, in units of the scene: 3.912 over the extinction coefficient. Above 0;
            ``math.inf`` is clear air. None: the far end of the scene, seen from the camera, keeps
            30 % of its light.
        anisotropy : float, optional
            The mean cosine g of the scattering angle (Henyey and Greenstein): above 0 forward.
            -0.99 to 0.99. None: 0.5. Fog has 0.85, sea water 0.92.
        albedo : float | sequence[float] | ColorLike, default: 1.0
            The scattered share of the extinction, for all colours or for red, green and blue; the
            rest is absorbed. 0 to 1. Water droplets have 1, soot has 0.25.
        ambient : float | sequence[float] | ColorLike, optional
            Radiance that arrives from all sides, as light that is scattered more than once does:
            the colour of the fog at a great distance. In the unit of radiance, at least 0. None:
            0.55 of the background's colour.
        multiple_scattering : bool, default: False
            Whether light that is scattered more than once is computed, instead of the ambient
            radiance: of lamps, in a uniform medium that is everywhere or in bounds, and of suns,
            in bounds or with a scale_height above the ground, which is the scene's lowest point.
        region : sequence[float] | pyvista.PolyData, optional
            Where the medium is: bounds (xmin, xmax, ymin, ymax, zmin, zmax), or a closed surface.
            None: everywhere.
        emission : float | sequence[float] | ColorLike, optional
            What the medium shines by itself, radiance per unit of length where the density is 1,
            as flames do. At least 0. None: 0.
        density : pyvista.ImageData, optional
            Factors of the extinction, the active point scalars, at least 0. None: uniform.
        albedo_array : str, optional
            A point array of ``density``, of one component or three, 0 to 1: the albedo of each
            place instead of ``albedo``, as where white steam and black smoke mix.
        emission_array : str, optional
            A point array of ``density``, of one component or three, at least 0: factors of
            ``emission``.
        scale_height : float, optional
            The height (along z) over which the density falls to 1/e, above 0. None: it does not.
        reference_height : float, optional
            The height at which the density is 1. None: the bottom of the scene.
        medium : vtkParticipatingMedium, optional
            A medium of yours, instead of all parameters above.
        shadows : bool | str, default: True
            False or ``"none"``: no shadows. True or ``"automatic"``: from silhouettes where
            possible. ``"planes"``: from silhouettes. ``"map"``: from shadow maps. ``"march"``:
            from shadow maps, by steps, to compare with.
        lamp : bool, optional
            Whether Airlight adds a lamp above the scene. None: if no other light scatters, as
            PyVista's lights that are fixed to the camera do not.
        white : float, default: 1.0
            The radiance, W/(m^2 sr), or luminance, cd/m^2, that is drawn white: the exposure. With
            neutral tone mapping it is drawn nearly white, 0.87.
            Above 0. The lights of add_lamp() and add_sun() have their power divided by it.
        anti_aliasing : bool | str, optional
            How edges of a single frame are smoothed. True: by FXAA, which guesses shapes.
            ``"msaa"``: by multisampling, four samples of pixels at edges, also of shadows in the
            air; a frame takes about twice as long. False: not at all. None: by FXAA, unless
            PyVista's SSAA is on. ``plotter.enable_anti_aliasing("msaa")`` after this call means
            multisampling, too. PyVista's default does not, for its time.
        tone_mapping : str, optional
            How radiances become colours: ``"neutral"`` keeps hues below 0.8, takes up to 0.04 of
            grey away, and fades brighter ones to white; ``"clamp"`` cuts those off; ``"filmic"``,
            ``"reinhard"``, ``"exponential"``. None: neutral, in clear air clamp.
        color_space : str, default: "linear"
            ``"linear"``: colours are shown as PyVista shows them. ``"srgb"``: radiances are encoded
            as screens expect; colours of meshes are then linear reflectances, and lighter.
        frames : int, default: 1
            How many frames make a picture, whose mean has smooth edges of surfaces and shadows, and
            soft shadows of lamps with a radius. 16 are good, 64 very good. 1 to 1024.
        progressive : bool, default: False
            Whether a window on the screen stays responsive meanwhile: each frame is shown as the
            mean so far, and input comes before the next. Pictures off screen, and buffers, are of
            all frames at once in any case.

        Returns
        -------
        AirlightComponent
            The component.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid; the message says what to give. Nothing changes.
        RuntimeError
            If the plotter is closed, or VTK has nothing to draw with.
        """
        subplot = self._active()
        require_screen(subplot.plotter.render_window)
        given = {"visibility": visibility, "anisotropy": anisotropy, "ambient": ambient,
                 "region": region, "emission": emission, "density": density,
                 "albedo_array": albedo_array, "emission_array": emission_array,
                 "scale_height": scale_height, "reference_height": reference_height}
        if medium is not None:
            medium = arguments.medium(medium)
            names = [name for name, value in given.items() if value is not None]
            if not (isinstance(albedo, (int, float)) and albedo == 1):
                names.append("albedo")
            if multiple_scattering:
                names.append("multiple_scattering")
            if names:
                raise ValueError(f"medium and {names[0]} are both given: set {names[0]} in the "
                                 "medium, or give no medium.")
        settings = Settings(**given, albedo=albedo, multiple_scattering=multiple_scattering,
                            shadows=shadows, lamp=lamp, white=white,
                            anti_aliasing=anti_aliasing, tone_mapping=tone_mapping,
                            color_space=color_space, frames=frames, progressive=progressive)
        subplot.enable(settings, medium)
        return self

    def disable(self) -> AirlightComponent:
        """Draw the active subplot as PyVista does.

        Lamps of add_lamp() and add_sun() stay; the lamp that was derived goes.

        Returns
        -------
        AirlightComponent
            The component.
        """
        self._active().disable()
        return self

    @property
    def enabled(self) -> bool:
        """Whether the active subplot is in a medium."""
        return self._active().enabled

    @property
    def medium(self) -> vtkParticipatingMedium:
        """The medium, which may be changed; the scene shows it from the next frame on.

        Derived values are set at the first frame.
        """
        return self._active().medium

    @property
    def render_pass(self) -> vtkAirlightPass:
        """The pass, for what ``enable`` has no parameter for. Its media are not to be changed."""
        return self._active().render_pass

    @property
    def lamps(self) -> tuple[pv.Light, ...]:
        """The lights that add_lamp() and add_sun() returned, and the derived one, if there is."""
        return tuple(lamp.light for lamp in self._active().lamps)

    def add_lamp(self, position: Any, intensity: Any = None, *, unit: str | None = None,
                 color: Any = "white", target: Any = None, direction: Any = None,
                 cone_angle: float | None = None, exponent: float = 0.0,
                 ies: Any = None, radius: float = 0.0, visible: bool = False) -> pv.Light:
        """Add a lamp to the active subplot, in physical units.

        Parameters
        ----------
        position : sequence[float]
            Where the lamp is.
        intensity : float | sequence[float], optional
            The radiant or luminous intensity, for all colours or for red, green and blue, at least
            0. None: that of the photometric file, or one that lights the scene well. A bare lamp
            of F lumen that emits evenly has F/(4 pi) candela.
        unit : str, default: "W/sr"
            ``"W/sr"`` or ``"cd"``. Lamps in candela make radiances luminances, in cd/m^2; all
            lamps and suns of a subplot have watts or all have lumens. With ``ies`` and without an
            intensity, ``"cd"``.
        color : ColorLike, default: "white"
            Factors of the intensity.
        target : sequence[float], optional
            The point that a spotlight or a photometric file aims at.
        direction : sequence[float], optional
            The direction instead of a target. With neither, down (-z).
        cone_angle : float, optional
            Makes the lamp a spotlight: the angle between its axis and its edge, in degrees, above 0
            and below 90, as ``pyvista.Light.cone_angle``.
        exponent : float, default: 0.0
            The power of the cosine by which a spotlight darkens towards its edge, 0 to 128. Others
            than 0 are slower.
        ies : str | os.PathLike, optional
            A photometric file of IES LM-63, which says how the lamp emits by direction.
        radius : float, default: 0.0
            The radius of the lamp: of a sphere, or of a disc across the axis of a spotlight or a
            photometric file. Its shadows are soft where ``frames`` of enable() is above 1. At
            least 0.
        visible : bool, default: False
            Whether the lamp is seen, as a bright shape of its radius.

        Returns
        -------
        pyvista.Light
            The light, a light of the plotter as others; it may be moved and switched.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid.
        OSError
            If the photometric file cannot be read.
        """
        subplot = self._active()
        lamp = make_lamp(position, intensity, unit, color, target, direction, cone_angle, exponent,
                         ies, radius, subplot.derive_intensity, visible)
        return subplot.add_lamp(lamp)

    def add_sun(self, direction: Any, irradiance: Any = 2.5, *, unit: str = "W/m^2",
                color: Any = "white", angular_diameter: float = 0.0,
                visible: bool = False) -> pv.Light:
        """Add a directional light to the active subplot, in physical units.

        Its light is not attenuated on its way to the scene unless the medium has a region or a
        scale height.

        Parameters
        ----------
        direction : sequence[float]
            The direction in which it shines: (0, 0, -1) is the sun at its zenith.
        irradiance : float | sequence[float], default: 2.5
            The irradiance of a surface that faces it, for all colours or for red, green and blue,
            at least 0. A white surface then has the radiance irradiance/pi.
        unit : str, default: "W/m^2"
            ``"W/m^2"`` or ``"lx"``. See add_lamp().
        color : ColorLike, default: "white"
            Factors of the irradiance.
        angular_diameter : float, default: 0.0
            The diameter of its disc in the sky, in degrees: the sun's is 0.53. Its shadows are soft
            where ``frames`` of enable() is above 1. At least 0, below 180.
        visible : bool, default: False
            Whether it is seen, as a disc of its diameter behind everything. A medium without a
            region or a scale height hides it.

        Returns
        -------
        pyvista.Light
            The light.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid.
        """
        return self._active().add_lamp(make_sun(direction, irradiance, unit, color,
                                                angular_diameter, visible))

    def remove_lamp(self, light: pv.Light) -> AirlightComponent:
        """Remove a light that add_lamp() or add_sun() returned from the active subplot.

        Parameters
        ----------
        light : pyvista.Light
            The light.

        Returns
        -------
        AirlightComponent
            The component.

        Raises
        ------
        ValueError
            If the light is none of these.
        """
        subplot = self._active()
        subplot.remove_lamp(subplot.find_lamp(light))
        subplot.refresh()
        return self

    def buffer(self, name: str = "Radiance", *, light: pv.Light | None = None) -> pv.ImageData:
        """Render a frame, and return a buffer of the active subplot.

        Parameters
        ----------
        name : str, default: "Radiance"
            ``"Radiance"``: what reaches the eye, RGB; ``"Airlight"``: the part that the medium
            scattered into the ray, RGB; ``"Airlight:0"``: that of the first light that is on,
            scattered once; ``"MultipleScattering"``: what was scattered more than once, RGB;
            ``"Surface"``: the part from surfaces, attenuated, RGB; ``"Transmittance"``: from
            the eye to the surface, or through all of the medium, RGB; ``"Depth"``: the distance
            of the surface, -1 without one; ``"LitLength"``: the lit length of the ray;
            ``"BoundaryCount"``: shadow boundaries on the ray; ``"ErrorBound"``: a bound of the
            error of the airlight, RGB.
        light : pyvista.Light, optional
            The light whose airlight is returned, with the name ``"Airlight"``. None: all.

        Returns
        -------
        pyvista.ImageData
            A pixel a point, bottom row first, linear, neither clamped nor quantised. Radiances are
            in W/(m^2 sr) or cd/m^2, whatever is drawn white.

        Raises
        ------
        TypeError, ValueError
            If there is no such buffer.
        RuntimeError
            If there is no medium: not enabled, closed, or OpenGL is too old, as the message says.
        """
        subplot = self._active()
        name = buffers.check_name(name)
        source = name if light is None else subplot.find_airlight(name, light)
        if not subplot.enabled:
            raise RuntimeError("The subplot is in no medium: call plotter.airlight.enable() first.")
        return buffers.read(subplot.plotter, subplot, source, name)

    def describe(self) -> str:
        """Return the settings of the active subplot in a line.

        Returns
        -------
        str
            For example ``'Airlight(visibility=15, anisotropy=0.6, shadows=automatic, 1 lamp)'``;
            derived values are marked, and if the scene is drawn without the medium, it says why.
        """
        subplot = self._active()
        if not subplot.enabled:
            return "Airlight(off)"
        settings, medium = subplot.settings, subplot.medium
        parts = [f"visibility={medium.GetVisibility():.4g}",
                 f"anisotropy={medium.GetAnisotropy():g}"]
        if subplot.own_medium is not None:
            parts.append("own medium")
        else:
            for index, name in enumerate(("visibility", "anisotropy")):
                if getattr(settings, name) is None:
                    parts[index] += " (derived)"
        parts.append(f"shadows={settings.shadows}")
        derived = sum(lamp.is_derived for lamp in subplot.lamps)
        count = len(subplot.lamps)
        parts.append(f"{count} lamp{'' if count == 1 else 's'}" + (" (derived)" if derived else ""))
        if settings.white != 1:
            parts.append(f"white={settings.white:g}")
        if subplot.refused:
            parts.append("not drawn: " + subplot.refused)
        return f"Airlight({', '.join(parts)})"

    def get_state(self) -> dict[str, Any]:
        """Return the settings and the lamps of the active subplot.

        Returns
        -------
        dict[str, Any]
            Numbers, words, tuples and dicts, which can be pickled; a region that is a surface and
            a density are copies of the data sets. Derived values are None.

        Raises
        ------
        ValueError
            If a medium of yours has a phase function, surface or image of its own object.
        """
        subplot = self._active()
        own = subplot.own_medium
        return {
            "enabled": subplot.enabled,
            "settings": subplot.settings.as_dict(),
            "medium": None if own is None else medium_to_dict(own),
            "lamps": [lamp.as_dict() for lamp in subplot.lamps if not lamp.is_derived],
        }

    def set_state(self, state: dict[str, Any]) -> AirlightComponent:
        """Give the active subplot the settings and lamps of get_state().

        Lamps that the subplot has are replaced.

        Parameters
        ----------
        state : dict[str, Any]
            What get_state() returned, of this plotter or of another one.

        Returns
        -------
        AirlightComponent
            The component.

        Raises
        ------
        TypeError, ValueError
            If the state is none of get_state(); nothing changes.
        """
        subplot = self._active()
        expected = {"enabled", "settings", "medium", "lamps"}
        if not isinstance(state, dict) or set(state) != expected:
            raise ValueError(f"state is {state!r}: give what get_state() returned.")
        try:
            settings = Settings(**state["settings"])
        except TypeError as error:
            raise ValueError(f"state: {error}; give what get_state() returned.") from error
        medium = None if state["medium"] is None else medium_from_dict(state["medium"])
        lamps = [Lamp.from_dict(values) for values in state["lamps"]]
        subplot.check(settings, medium, lamps, enabled=state["enabled"])
        for lamp in [lamp for lamp in subplot.lamps if not lamp.is_derived]:
            subplot.remove_lamp(lamp)
        subplot.settings = settings
        for lamp in lamps:
            subplot.add_lamp(lamp)
        if state["enabled"]:
            subplot.enable(settings, medium)
        else:
            subplot.disable()
        return self
