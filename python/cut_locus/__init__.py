"""Cut loci and exact geodesics on triangle meshes.

>>> result = cut_locus.compute(V, F, 0)         # V: (n, 3) points, F: (m, 3) vertex indices, a source vertex
>>> result.points[result.edges]                 # the segments of the cut locus
>>> distance = cut_locus.exact_geodesic_distances(V, F, 0)

Lengths are in the unit of the points, angles in radians. Arrays that are returned cannot be written to: copy them
first. A computation releases the GIL, so that threads with objects of their own run at the same time.
"""

from ._core import Cause, InvalidInput
from ._cut_locus import Cells, CutLocus, Result, compute, medial_axis, voronoi
from ._cut_loci import compute_cut_loci
from ._disk import Disk, cut_open
from ._geodesics import (ExactGeodesics, Found, Isoline, Path, Places, exact_geodesic_distances, exp_map, isolines,
                         log_map, shortest_paths)
from ._input import mesh_arrays, weld
from ._surfaces import (LayoutQuality, Refined, Unfolding, flatten_disk, layout_quality, refine_along_polylines,
                        source_unfolding)

__version__ = "0.2.0"

__all__ = [
    "Cause",
    "Cells",
    "CutLocus",
    "Disk",
    "ExactGeodesics",
    "Found",
    "InvalidInput",
    "Isoline",
    "LayoutQuality",
    "Path",
    "Places",
    "Refined",
    "Result",
    "Unfolding",
    "compute",
    "compute_cut_loci",
    "cut_open",
    "exact_geodesic_distances",
    "exp_map",
    "flatten_disk",
    "isolines",
    "layout_quality",
    "log_map",
    "medial_axis",
    "mesh_arrays",
    "refine_along_polylines",
    "shortest_paths",
    "source_unfolding",
    "voronoi",
    "weld",
]
