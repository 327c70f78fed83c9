"""Surfaces for the tests, as arrays of points and of faces."""

import numpy as np


def octahedron():
    points = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=np.float64)
    faces = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    return points, faces


def icosphere(level):
    """A unit sphere of 20 * 4**level faces."""
    g = (1. + 5.**0.5) / 2.
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
              (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    points = [np.array(p) / np.linalg.norm(p) for p in points]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    for _ in range(level):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                p = points[a] + points[b]
                points.append(p / np.linalg.norm(p))
                middles[key] = len(points) - 1
            return middles[key]

        refined = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            refined += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = refined
    return np.array(points), np.array(faces)


def grid(columns, rows, wraps_columns, wraps_rows):
    """The faces of a grid of points, row after row in each column."""
    i, j = np.meshgrid(np.arange(columns if wraps_columns else columns - 1),
                       np.arange(rows if wraps_rows else rows - 1), indexing="ij")

    def at(u, v):
        return ((u % columns) * rows + v % rows).ravel()

    a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def torus(columns, rows, large=2., small=1.):
    u, v = np.meshgrid(np.arange(columns) * 2. * np.pi / columns, np.arange(rows) * 2. * np.pi / rows, indexing="ij")
    radius = large + small * np.cos(v)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), small * np.sin(v)], axis=-1).reshape(-1, 3)
    return points, grid(columns, rows, True, True)


def cylinder(columns, rows, height):
    """A prism without its ends, on `columns` sides of length 1: it is flat within, of the circumference `columns`."""
    radius = 0.5 / np.sin(np.pi / columns)
    u, z = np.meshgrid(np.arange(columns) * 2. * np.pi / columns, np.linspace(0., height, rows), indexing="ij")
    points = np.stack([radius * np.cos(u), radius * np.sin(u), z], axis=-1).reshape(-1, 3)
    return points, grid(columns, rows, True, False)


def cube():
    """The unit cube: vertex x + 2 y + 4 z is at (x, y, z), and faces 0 and 1 are at z = 0."""
    points = np.array([[x, y, z] for z in (0., 1.) for y in (0., 1.) for x in (0., 1.)])
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return points, np.array([face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))])


def bumpy_sphere(level):
    """An icosphere whose radius varies, so that shortest paths have no symmetry."""
    points, faces = icosphere(level)
    x, y, z = points.T
    radius = 1. + 0.2 * np.sin(3. * x + 1.) * np.cos(2. * y - 0.5) + 0.15 * np.sin(4. * z + 0.3 * x)
    return points * radius[:, None], faces


def length_of(points, edges):
    return np.linalg.norm(points[edges[:, 1]] - points[edges[:, 0]], axis=1)
