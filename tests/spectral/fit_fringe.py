#!/usr/bin/env python3
"""Fits the sampler-free fringes of shaders/nacre_fringe.glsl and prints their constants.

    python3 fit_fringe.py        needs numpy and scipy

The fringe of an RGB channel, C(x) = integral of S(w) exp(2 pi i x / w), for Rec.709 under equal-energy
light adapted to D65, is fitted by spectral lines with Gaussian profiles that the three channels share:
C(x) = sum of weight * exp(2 pi i x / line) * exp(-(x / width)^2). Lines and widths by nonlinear least
squares, the weights by linear least squares inside (variable projection); C(0) = 1 is held. The path
counts less the longer it is, as 1 / (1 + (x / 1 um)^2), since longer paths have less contrast and are rarer.
"""
import pathlib
import re

import numpy as np
from scipy.optimize import least_squares

LINES = 4
RGB_FROM_XYZ_WHITE = np.array([0.3127 / 0.3290, 1.0, (1 - 0.3127 - 0.3290) / 0.3290])
BRADFORD = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])


def observer():
    """CIE 1931 at 1 nm, from the library's own data."""
    text = (pathlib.Path(__file__).parents[2] / "lib/src/data/cie1931.hpp").read_text()
    rows = re.findall(r"\{([-\d.e]+), ([-\d.e]+), ([-\d.e]+)\}", text)
    return np.arange(360, 831) / 1000, np.array(rows, float)


def curves(xyz):
    """The channels' curves, each with the sum 1."""
    corners = np.array([[x / y, 1, (1 - x - y) / y] for x, y in ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06))]).T
    to_xyz = corners * np.linalg.solve(corners, RGB_FROM_XYZ_WHITE)
    white = xyz.sum(0) / xyz[:, 1].sum()
    adapt = np.linalg.inv(BRADFORD) @ np.diag((BRADFORD @ RGB_FROM_XYZ_WHITE) / (BRADFORD @ white)) @ BRADFORD
    return xyz / xyz[:, 1].sum() @ adapt.T @ np.linalg.inv(to_xyz).T


def main():
    wavelength, xyz = observer()
    path = np.arange(0, 6, 0.01)
    fringe = np.exp(2j * np.pi * path[:, None] / wavelength) @ curves(xyz)
    importance = (1 / (1 + path**2))[:, None]

    def basis(parameters):
        line, width = parameters.reshape(2, -1)
        return np.exp(2j * np.pi * path[:, None] / line - (path[:, None] / width) ** 2)

    def solve(parameters):
        b, y = basis(parameters) * importance, fringe * importance
        a = np.vstack([b.real, b.imag, 30 * np.ones((1, LINES))])
        target = np.vstack([y.real, y.imag, 30 * np.ones((1, 3))])
        weights = np.linalg.lstsq(a, target, rcond=None)[0]
        return weights, a @ weights - target

    start = np.concatenate([[0.450, 0.520, 0.560, 0.605], [2.0] * LINES])
    best = least_squares(lambda p: solve(p)[1].ravel(), start, x_scale=np.repeat([0.01, 0.1], LINES), xtol=1e-12, ftol=1e-12)
    weights, _ = solve(best.x)
    line, width = best.x.reshape(2, -1)
    residual = np.abs(basis(best.x) @ weights - fringe)

    def vector(values):
        return "vec4(" + ", ".join(f"{value:.9g}" for value in values) + ")"

    print("lines, um:         ", line)
    print("e-folding, um:     ", width)
    print("residual, at most: ", residual.max(0), "up to 0.45 um:", residual[path <= 0.45].max())
    luminance = np.linalg.norm((fringe @ [0.2126, 0.7152, 0.0722])[:, None], axis=1)
    print("second line's profile against |C| of the luminance:", np.abs(np.exp(-(path / width[1]) ** 2) - luminance).max())
    print("nacre_fringeLines ", vector(1 / line))
    print("nacre_fringeDecay ", vector(-np.log2(np.e) / width**2))
    for name, channel in zip(("Red", "Green", "Blue"), weights.T):
        print(f"nacre_fringe{name} ", vector(channel))


if __name__ == "__main__":
    main()
