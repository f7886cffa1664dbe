# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Phase functions p(mu) in 1/sr, by their textbook formulas; mu = 1 is forward.

A description is a dict with a "type" and what that needs: "g", "alpha" or a "table" of rows
[angle in degrees, value].
"""

import numpy as np


def isotropic(mu):
    return np.full_like(mu, 1 / (4 * np.pi))


def rayleigh(mu):
    return 3 / (16 * np.pi) * (1 + mu**2)


def henyey_greenstein(mu, g):
    return (1 - g**2) / (4 * np.pi * (1 + g**2 - 2 * g * mu)**1.5)


def schlick(mu, k):
    return (1 - k**2) / (4 * np.pi * (1 - k * mu)**2)


def cornette_shanks(mu, g):
    return 1.5 * (1 - g**2) / (2 + g**2) * (1 + mu**2) * henyey_greenstein(mu, g) / (1 - g**2)


def draine(mu, g, alpha):
    return ((1 + alpha * mu**2) / (1 + alpha * (1 + 2 * g**2) / 3)
            * henyey_greenstein(mu, g))


def mie_hazy(mu):
    return (0.5 + 4.5 * ((1 + mu) / 2)**8) / (4 * np.pi)


def mie_murky(mu):
    return (0.5 + 16.5 * ((1 + mu) / 2)**32) / (4 * np.pi)


def monotone_slopes(x, y):
    """Fritsch and Carlson (1980): slopes of parabolas through three points, drawn back to the
    circle of radius 3. The paper leaves the slopes to begin with open: tables of few rows may
    differ from other makers' between the rows."""
    secant = np.diff(y) / np.diff(x)
    slope = np.gradient(y, x, edge_order=2)
    for i, s in enumerate(secant):
        if s == 0:
            slope[i] = slope[i + 1] = 0
            continue
        a, b = slope[i] / s, slope[i + 1] / s
        if a < 0 or b < 0:
            slope[i:i + 2] = np.where([a < 0, b < 0], 0, slope[i:i + 2])
            a, b = max(a, 0), max(b, 0)
        if a * a + b * b > 9:
            slope[i:i + 2] = 3 / np.hypot(a, b) * s * np.array([a, b])
    return slope


class Table:
    """The logarithm of the values is a monotone cubic of the angle; the integral is 1."""

    def __init__(self, rows):
        self.angle, value = np.array(rows, float).T
        self.log = np.log(value)
        self.slope = monotone_slopes(self.angle, self.log)
        # The mean over the sphere, by Gauss-Legendre quadrature between neighbouring rows.
        node, weight = np.polynomial.legendre.leggauss(20)
        ends = np.radians(np.unique(np.concatenate([[0], self.angle, [180]])))
        half, middle = np.diff(ends) / 2, (ends[1:] + ends[:-1]) / 2
        angles = middle[:, None] + half[:, None] * node
        values = np.exp(self.logarithm(np.degrees(angles)))
        integral = 2 * np.pi * np.sum(half[:, None] * weight * np.sin(angles) * values)
        self.log = self.log - np.log(integral)

    def logarithm(self, degrees):
        x = np.clip(degrees, self.angle[0], self.angle[-1])
        i = np.clip(np.searchsorted(self.angle, x, side="right") - 1, 0, len(self.angle) - 2)
        step = self.angle[i + 1] - self.angle[i]
        s = (x - self.angle[i]) / step
        return ((1 + 2 * s) * (1 - s)**2 * self.log[i] + s * (1 - s)**2 * step * self.slope[i]
                + s**2 * (3 - 2 * s) * self.log[i + 1] - s**2 * (1 - s) * step * self.slope[i + 1])

    def __call__(self, mu):
        return np.exp(self.logarithm(np.degrees(np.arccos(np.clip(mu, -1, 1)))))


def make(description):
    """The function of mu that a description stands for."""
    kind = description["type"]
    if kind == "table":
        return Table(description["table"])
    plain = {"isotropic": isotropic, "rayleigh": rayleigh, "mie_hazy": mie_hazy,
             "mie_murky": mie_murky}
    if kind in plain:
        return plain[kind]
    if kind == "draine":
        return lambda mu: draine(mu, description["g"], description["alpha"])
    function = {"henyey_greenstein": henyey_greenstein, "schlick": schlick,
                "cornette_shanks": cornette_shanks}[kind]
    return lambda mu: function(mu, description["g"])
