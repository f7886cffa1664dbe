# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Adaptive quadrature of many integrals at once, by the Gauss-Kronrod pair of 7 and 15 nodes.

The pair's difference is the error of the coarser rule, and so far above that of the finer one,
which is what is summed up.
"""

import numpy as np

NODES = np.array([
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144691693220, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0.0])
KRONROD = np.array([
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714])
GAUSS = np.array([
    0.0, 0.129484966168869693270611432679082, 0.0, 0.279705391489276667901467771423780,
    0.0, 0.381830050505118944950369775488975, 0.0, 0.417959183673469387755102040816327])
NODES = np.concatenate([-NODES, NODES[-2::-1]])
KRONROD = np.concatenate([KRONROD, KRONROD[-2::-1]])
GAUSS = np.concatenate([GAUSS, GAUSS[-2::-1]])

PANELS_AT_ONCE = 4096
HALVINGS = 60


class NotConverged(ArithmeticError):
    pass


def panels_both_ways(function, group, low, high):
    """Both rules' values [n, channels] on panels [low, high]."""
    kronrod, gauss = [], []
    for first in range(0, len(low), PANELS_AT_ONCE):
        part = slice(first, first + PANELS_AT_ONCE)
        middle, half = (low[part] + high[part]) / 2, (high[part] - low[part]) / 2
        x = middle[:, None] + half[:, None] * NODES
        values = function(np.repeat(group[part], len(NODES)), x.ravel())
        values = values.reshape(*x.shape, -1) * half[:, None, None]
        kronrod.append(np.einsum("pnc,n->pc", values, KRONROD))
        gauss.append(np.einsum("pnc,n->pc", values, GAUSS))
    return np.concatenate(kronrod), np.concatenate(gauss)


def integrate(function, group, low, high, count, tolerance=1e-8, channels=3):
    """The sums [count, channels] over the panels [low, high] of each group of the integral of
    function(group, x), which is nowhere negative. Panels are halved until the differences of both
    rules in a group sum up to less than the tolerance, as a share of its integral."""
    total = np.zeros((count, channels))
    error = np.zeros((count, channels))
    group, low, high = (np.asarray(a) for a in (group, low, high))
    # What a panel may add to the error, as a share: there are rarely more than a hundred.
    share = tolerance / 100
    for _ in range(HALVINGS):
        if not len(group):
            break
        fine, coarse = panels_both_ways(function, group, low, high)
        whole = total.copy()
        np.add.at(whole, group, fine)
        difference = np.abs(fine - coarse)
        good = np.all(difference <= share * whole[group] + 1e-300, axis=1)
        np.add.at(total, group[good], fine[good])
        np.add.at(error, group[good], difference[good])
        group, low, high = group[~good], low[~good], high[~good]
        middle = (low + high) / 2
        group = np.concatenate([group, group])
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    if len(group) or np.any(error > tolerance * total + 1e-290):
        raise NotConverged(f"{len(group)} panels left, error {np.max(error / (total + 1e-300))}")
    return total
