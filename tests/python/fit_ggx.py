"""The coefficients in crates/bsdf/src/microfacet/compensation.rs, found again: `python tests/python/fit_ggx.py`.

Needs numpy and scipy (tests/python/requirements.txt). Prints the matrix GGX, the greatest distance that is left, and the
polynomial GGX_AVERAGE.
"""

import numpy as np
from scipy.optimize import linprog

WIDTHS = np.concatenate([[0.001, 0.003, 0.01, 0.02, 0.035], np.arange(0.05, 1.0001, 0.05)])
PLACES = (1 - np.cos((np.arange(40) + 0.5) / 40 * np.pi)) / 2
TERMS, POWERS = 7, 6
# Of a coefficient: greater ones would cost digits in single precision.
GREATEST = 60
# The least part of what is missing that the series may leave.
LEAST = 0.3


def center(alpha):
    return (1.8 - 1.3 * alpha) * alpha


def root_lambda(stretched):
    return 0.5 * (np.sqrt(1 + stretched) - 1)


def missing(cosine, alpha, radii=300, angles=400):
    """1 - E by a sum over equal shares of the facets."""
    nodes, weights = np.polynomial.legendre.leggauss(radii)
    t, weights = (nodes + 1) / 2, weights / 2
    share = 1 - (1 - t) ** 3
    weights = weights * 3 * (1 - t) ** 2
    phi = (np.arange(angles) + 0.5) / angles * np.pi
    slope, phi = np.meshgrid(np.sqrt(share / (1 - share)), phi, indexing="ij")
    p, q = slope * np.cos(phi) * alpha, slope * np.sin(phi) * alpha
    sine = np.sqrt(max(1 - cosine**2, 0))
    up = 1 / np.sqrt(1 + p * p + q * q)
    half = (cosine + sine * p) * up
    wi = 2 * half * p * up - sine, 2 * half * q * up, 2 * half * up - cosine
    above = np.maximum(wi[2], 1e-12)
    shares = 1 + root_lambda((alpha * sine / cosine) ** 2) + root_lambda(alpha**2 * (wi[0] ** 2 + wi[1] ** 2) / above**2)
    value = np.where((half > 0) & (wi[2] > 0), half / up / cosine / shares, 0)
    return 1 - float((value.mean(axis=1) * weights).sum())


def least_greatest(columns, low, high, weight=1.0, bound=None):
    """Coefficients whose sum lies within low ... high with the least greatest weighted distance to `high`."""
    n = columns.shape[1]
    goal = np.r_[np.zeros(n), 1]
    under = np.c_[columns, np.zeros(len(high))]
    near = np.c_[-columns * np.reshape(weight, (-1, 1)), -np.ones(len(high))]
    over = np.c_[-columns, np.zeros(len(high))]
    limits = [(None, None) if bound is None else (-bound, bound)] * n + [(0, None)]
    right = np.concatenate([high, -high * weight, -low])
    result = linprog(goal, A_ub=np.vstack([under, near, over]), b_ub=right, bounds=limits, method="highs")
    if result.status != 0:
        raise SystemExit(result.message)
    return result.x[:-1], result.fun


def series(matrix, cosine, alpha):
    x = cosine / (cosine + center(alpha))
    terms = matrix @ alpha ** np.arange(POWERS)
    return np.maximum(x * np.polynomial.polynomial.polyval(1 - x, terms), 0)


def average(matrix, alpha):
    nodes, weights = np.polynomial.legendre.leggauss(16)
    borders = np.linspace(0, 1, 41) ** 3
    cells = zip(borders, borders[1:])
    place = [((a + b) / 2 + (b - a) / 2 * nodes, (b - a) / 2 * weights) for a, b in cells]
    return sum((w * 2 * c * series(matrix, c, alpha)).sum() for c, w in place)


def main():
    x = np.array([PLACES / (1 + center(a)) for a in WIDTHS])
    alpha = np.repeat(WIDTHS[:, None], len(PLACES), 1)
    cosine = center(alpha) * x / (1 - x)
    value = np.array([missing(c, a) for c, a in zip(cosine.ravel(), alpha.ravel())])
    columns = [x * (1 - x) ** k * alpha**j for k in range(TERMS) for j in range(POWERS)]
    columns = np.stack([c.ravel() for c in columns], axis=1)
    found, distance = least_greatest(columns, LEAST * value, value, bound=GREATEST)
    matrix = found.reshape(TERMS, POWERS)
    print("GGX", matrix.tolist(), "distance", distance)

    # The average from above: its inverse must not make energy.
    widths = np.concatenate([np.geomspace(0.001, 0.05, 25), np.arange(0.06, 1.0001, 0.02)])
    averages = np.array([average(matrix, a) for a in widths])
    most = np.array([series(matrix, np.geomspace(1e-4, 1, 60), a).max() for a in widths])
    columns = np.stack([-(widths**2) * np.sqrt(widths) ** j for j in range(5)], axis=1) / averages[:, None]
    ones = -np.ones(len(widths))
    found, distance = least_greatest(columns, 10 * ones, ones, weight=most)
    print("GGX_AVERAGE", found.tolist(), "distance", distance)


if __name__ == "__main__":
    main()
