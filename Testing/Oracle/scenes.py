# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes for the oracle and the library, as plain numbers.

Each has besides the tracer's entries a "name" and "by_quadrature", whether the library has no
closed form for one of its integrals (see Documentation/accuracy.md).
"""

import numpy as np

import meshes
from geometry import rotation

EYE = {"position": (0.4, 1.3, 8), "focal_point": (0.1, 0.6, 0), "view_up": (0.05, 1, 0),
       "view_angle_deg": 40}
PARALLEL = {"position": (2.2, 1.7, 6), "focal_point": (0.1, 0.4, 0), "view_up": (0, 1, 0.1),
            "parallel_scale": 2.6}
BOX = {"type": "box", "min": (-3, -1.2, -3.5), "max": (2.5, 3, 4)}
BALL = {"type": "sphere", "center": (0.2, 0.5, -0.3), "radius": 3.1}
BARREL = {"type": "cylinder", "center": (0.3, 0.4, -0.2), "axis": (0.3, 1, -0.2), "radius": 2.6,
          "height": 3.4}
POINT = {"type": "point", "position": (-1.1, 1.9, 0.6), "intensity": (30, 24, 20)}
OUTSIDE = {"type": "point", "position": (-2.1, 3.7, 1.9), "intensity": (60, 50, 40)}
SPOT = {"type": "spot", "position": (1.3, 2.3, 1.1), "intensity": (50, 60, 40), "exponent": 0,
        "direction": (-0.6, -1, -0.4), "cone_half_angle_deg": 35}
SUN = {"type": "directional", "direction": (0.5, -1, -0.35), "irradiance": (9, 8, 6)}


def surface(mesh, albedo):
    points, faces = mesh
    return {"points": points, "faces": faces, "albedo": albedo}


GROUND = surface(meshes.rectangle((-9, -1, 7), (18, 0, 0.2), (0.1, 0, -18)), (0.5, 0.45, 0.4))
BODY = [surface(meshes.box((-0.7, -0.2, -0.5), (0.3, 0.8, 0.6)), (0.6, 0.3, 0.2)),
        surface(meshes.ball((1.2, 0.5, -0.8), 0.6), (0.2, 0.4, 0.7)), GROUND]


def closed_mesh():
    """A ball of flat faces; its upright axis is tilted, so that no ray meets an edge."""
    points, faces = meshes.ball((0, 0, 0), 3)
    return {"type": "mesh", "points": points @ rotation((1, 2, 0.5), 27).T + (0.2, 0.6, -0.4),
            "faces": faces}


def cloud():
    """A turned image of some smooth density, not 0 at its faces."""
    z, y, x = np.mgrid[0:5, 0:6, 0:4]
    return {"type": "image",
            "values": 0.3 + np.sin(x + 0.7 * y)**2 + 0.5 * np.cos(0.8 * z - 0.3 * x * y)**2,
            "origin": (-1.7, -1.1, 1.9), "spacing": (1.3, 0.9, 1.1),
            "direction": rotation((1, 0.3, 0.2), 160) @ rotation((0, 1, 0), 20)}


def table(bow):
    """Forward scattering, with a bow at 140 degrees."""
    angles = np.linspace(0, 180, 361)
    mu = np.cos(np.radians(angles))
    values = np.exp(2 * mu) + bow * np.exp(-((angles - 140) / 20)**2)
    return {"type": "table", "table": np.stack([angles, values], axis=1)}


def medium(scatter, absorb=(0, 0, 0), **rest):
    """phase may be a name alone."""
    if isinstance(rest.get("phase"), str):
        rest["phase"] = {"type": rest["phase"]}
    return {"sigma_s": scatter, "sigma_a": absorb, **rest}


def with_g(kind, g):
    return {"type": kind, "g": g}


def draine(g, alpha):
    return {"type": "draine", "g": g, "alpha": alpha}


def height_fog(scale, reference=0, up=(0, 1, 0)):
    return {"type": "exponential_height", "scale": scale, "reference": reference, "up": up}


GREY = medium((0.08, 0.1, 0.14), (0.02, 0.01, 0.03))


def scene(name, media, sources, surfaces=(), camera=EYE, by_quadrature=False):
    return {"name": name, "media": media, "lights": sources, "surfaces": list(surfaces),
            "camera": camera, "by_quadrature": by_quadrature}


def grey(**rest):
    return medium(GREY["sigma_s"], GREY["sigma_a"], **rest)


def in_shadow(position):
    """An eye behind the box, as the point light sees it."""
    return {**EYE, "position": position, "focal_point": (0.2, 0.3, -0.4)}


def closed_forms():
    lit_box = {**BOX, "max": (2.5, 3, 3)}
    return [
        scene("everywhere, isotropic, point", [GREY], [POINT], BODY),
        scene("the eye in shadow", [GREY], [POINT], BODY, in_shadow((1.6, -0.9, -3.1))),
        scene("no surface, strong extinction", [medium((1.5, 0.3, 0.01), (0.1, 0.2, 0.3))],
              [POINT]),
        scene("sphere, Rayleigh, point inside", [grey(region=BALL, phase="rayleigh")], [POINT],
              BODY),
        scene("cylinder, Rayleigh, point inside", [grey(region=BARREL, phase="rayleigh")], [POINT],
              BODY),
        scene("in the cylinder, spot, no surface", [grey(region=BARREL)], [SPOT],
              camera={**EYE, "position": (0.8, 0.9, 1.1)}),
        scene("everywhere, Draine, point", [grey(phase=draine(0.6, 5))], [POINT], BODY),
        scene("box, Henyey-Greenstein forward, point inside",
              [grey(region=BOX, phase=with_g("henyey_greenstein", 0.7))], [POINT], BODY),
        scene("everywhere, Henyey-Greenstein backward, spot",
              [grey(phase=with_g("henyey_greenstein", -0.45))], [SPOT], BODY),
        scene("everywhere, Schlick, spot", [grey(phase=with_g("schlick", 0.6))], [SPOT], BODY),
        scene("everywhere, Cornette-Shanks, point",
              [grey(phase=with_g("cornette_shanks", 0.4))], [POINT], BODY),
        scene("everywhere, sun", [grey(phase="rayleigh")], [SUN], BODY),
        scene("box, sun, eye outside", [grey(region=lit_box, phase="mie_hazy")], [SUN], BODY),
        scene("height fog, sun", [grey(density=height_fog(1.7, 0.3), phase="mie_murky")], [SUN],
              BODY),
        scene("a channel without extinction", [medium((0, 0.1, 0.2), ambient=(1, 1, 1))], [POINT],
              BODY),
        scene("parallel, everywhere, point", [GREY], [POINT], BODY, PARALLEL),
        scene("parallel, box, sun", [grey(region=lit_box)], [SUN], BODY, PARALLEL),
        scene("sphere, ambient light, a light for surfaces alone",
              [grey(region=BALL, ambient=(0.5, 0.7, 0.9))], [{**POINT, "scatters": False}], BODY),
        scene("mesh, ambient light, a light for surfaces alone",
              [grey(region=closed_mesh(), ambient=(0.5, 0.7, 0.9))], [{**SPOT, "scatters": False}],
              BODY),
        scene("absorption only", [medium((0, 0, 0), (0.1, 0.2, 0.3), ambient=(1, 1, 1))], [POINT],
              BODY),
    ]


def sums():
    """Several media with ambient light, and channels without extinction in height fog."""
    air = medium((0, 0.01, 0.02), density=height_fog(8.5), ambient=(0.3, 0.3, 0.3))
    return [
        scene("height fog, a channel without extinction, sun", [air], [SUN], BODY),
        scene("height fog, a channel without extinction, point", [air], [POINT], BODY,
              by_quadrature=True),
        scene("metres of air, a channel without extinction",
              [medium((0, 1e-5, 2e-5), density=height_fog(8500), ambient=(0.3, 0.3, 0.3))], [SUN]),
        scene("uniform and height fog, ambient",
              [medium((0.05,) * 3, ambient=(1, 1, 1)),
               medium((0.5,) * 3, density=height_fog(2), ambient=(0.5, 1, 0.2))], [],
              by_quadrature=True),
        scene("haze and ground fog in metres, ambient",
              [medium((1e-4,) * 3, ambient=(1, 1, 1)),
               medium((0.1,) * 3, density=height_fog(10), ambient=(1, 1, 1))], [],
              camera={**EYE, "position": (0, 50, 10), "focal_point": (0, 45, 0)},
              by_quadrature=True),
        scene("colours and height fog, ambient",
              [medium((1, 0.1, 0.01), ambient=(1, 1, 1)),
               medium((0.01, 0.1, 1), density=height_fog(5), ambient=(1, 1, 1))], [],
              by_quadrature=True),
        scene("colours and thin high fog, ambient",
              [medium((1, 0.03, 0.001), ambient=(1, 1, 1)),
               medium((0.001,) * 3, density=height_fog(100), ambient=(1, 1, 1))], [],
              by_quadrature=True),
        scene("overlapping box and sphere, two lights, ambient",
              [grey(region=BOX, phase=with_g("henyey_greenstein", 0.5), ambient=(0.2, 0.3, 0.4)),
               medium((0.2, 0.1, 0.05), (0, 0.05, 0.1), region=BALL, phase="rayleigh",
                      ambient=(0.4, 0.2, 0.1))], [POINT, SUN], BODY, by_quadrature=True),
        scene("uniform and height fog, spot",
              [grey(ambient=(0.1, 0.2, 0.3)),
               medium((0.2, 0.1, 0), density=height_fog(1.5), phase="mie_hazy",
                      ambient=(0.3, 0.2, 0.1))], [SPOT], BODY, by_quadrature=True),
    ]


def by_quadrature():
    def add(name, media, sources, surfaces=BODY, camera=EYE):
        return scene(name, media, sources, surfaces, camera, by_quadrature=True)

    return [
        add("box, Schlick, point outside", [grey(region=BOX, phase=with_g("schlick", -0.5))],
            [OUTSIDE]),
        add("cylinder, Schlick, point outside",
            [grey(region=BARREL, phase=with_g("schlick", -0.5))], [OUTSIDE]),
        add("cylinder, sun", [grey(region=BARREL, phase="rayleigh")], [SUN]),
        add("along the cylinder's axis, sun",
            [grey(region={**BARREL, "axis": (0, 0, 1), "radius": 2, "height": 5})], [SUN],
            # From a height at which no ray lies in the ground or meets an edge of the ball.
            camera={**PARALLEL, "position": (0, 0.35, 9), "focal_point": (0, 0.35, 0),
                    "view_up": (0, 1, 0)}),
        add("cylinder of height fog, spot", [grey(region=BARREL, density=height_fog(0.9, 0.2))],
            [SPOT]),
        add("cylinder in fog, two lights", [grey(), grey(region=BARREL)], [OUTSIDE, SUN]),
        add("everywhere, Draine's function of fog, point", [grey(phase=draine(0.95, 30))], [POINT]),
        add("sphere, sun", [grey(region=BALL, phase="rayleigh")], [SUN]),
        add("everywhere, Mie hazy, point", [grey(phase="mie_hazy")], [POINT]),
        add("everywhere, Mie murky, spot with exponent", [grey(phase="mie_murky")],
            [{**SPOT, "exponent": 3}]),
        add("everywhere, table, point", [grey(phase=table(0))], [POINT]),
        add("everywhere, table with a bow, spot", [grey(phase=table(0.4))], [SPOT]),
        add("mesh, point inside", [grey(region=closed_mesh())], [POINT]),
        add("mesh, Cornette-Shanks, sun",
            [grey(region=closed_mesh(), phase=with_g("cornette_shanks", -0.3))], [SUN]),
        add("everywhere, other attenuation", [grey()], [{**POINT, "attenuation": (0.5, 0.3, 0.8)}]),
        add("the light at the eye, without attenuation", [GREY],
            [{**POINT, "position": EYE["position"], "attenuation": (1, 0, 0)}]),
        add("everywhere, attenuation of 1", [grey()], [{**SPOT, "attenuation": (1, 0, 0)}]),
        add("tilted height fog, point",
            [grey(density=height_fog(1.4, -0.4, (0.2, 1, -0.1)), phase="rayleigh")], [POINT]),
        add("sphere of height fog, spot", [grey(region=BALL, density=height_fog(0.9, 0.2))],
            [SPOT]),
        add("parallel, box of height fog, sun",
            [grey(region=BOX, density=height_fog(0.9, 0.2))], [SUN], camera=PARALLEL),
        add("image, point inside", [grey(density=cloud(), ambient=(0.2, 0.1, 0.3))], [POINT]),
        add("image, Henyey-Greenstein, sun",
            [grey(density=cloud(), phase=with_g("henyey_greenstein", 0.5))], [SUN]),
        add("image in a sphere, spot", [grey(region=BALL, density=cloud())], [SPOT]),
        add("parallel, image, spot outside", [grey(density=cloud())],
            [{**SPOT, "position": (2.6, 4.6, 2.2)}], camera=PARALLEL),
    ]


def cut_image():
    return scene("image in a sphere, sun", [grey(region=BALL, density=cloud())], [SUN], BODY,
                 by_quadrature=True)


def everything():
    return closed_forms() + sums() + by_quadrature()
