"""One cut locus after another, of many sources."""

from __future__ import annotations

import os
from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from queue import SimpleQueue
from typing import Any, Deque, Dict, Iterator, List, Optional

import numpy.typing as npt

from . import _core
from ._cut_locus import CutLocus, Result
from ._input import Numbers, Sources, read_sources


def compute_cut_loci(vertices: npt.ArrayLike, faces: npt.ArrayLike, sources: Sources, *, threads: int = 1,
                     solver: str = "exact", method: Optional[str] = None, laplacian_operator: Optional[str] = None,
                     edge_lengths: Optional[npt.ArrayLike] = None, snapping_tolerance: float = 1e-10,
                     maximum_relative_error: float = 0., **thresholds: Any) -> Iterator[Result]:
    """Computes one cut locus for each of several sources, such as all vertices, on a mesh that is read once.

    They are computed while they are iterated over, and only a few that nobody has asked for yet are kept: a result has
    the distances of all vertices. (The cut locus of a set of sources is what `compute()` computes.)

    Parameters
    ----------
    vertices, faces, solver, method, laplacian_operator, edge_lengths
        As in `CutLocus`.
    sources : sequence of int or (int, (3,) floats)
        Vertices, or faces and barycentric coordinates, in any component of the mesh.
    threads : int
        How many sources are treated at once; 0: as many as there are processors. The results are the same.
    snapping_tolerance, maximum_relative_error
        As in `CutLocus.set_source()`.
    **thresholds
        As in `CutLocus.cut_locus()`.

    Returns
    -------
    iterator of Result
        One for each source, in their order.

    Raises
    ------
    InvalidInput
        At once if the mesh, a source, its component or a parameter of `CutLocus` cannot be used, and while it is
        iterated over for a threshold.
    """
    unknown = sorted(set(thresholds) - set(CutLocus.cut_locus.__kwdefaults__))
    if unknown:
        raise TypeError(f"compute_cut_loci() got an unexpected keyword argument {unknown[0]!r}")
    if threads < 0:
        raise _core.InvalidInput(f"the number of threads must not be negative, as {threads} is")
    computation = CutLocus(vertices, faces, solver=solver, method=method, laplacian_operator=laplacian_operator,
                           edge_lengths=edge_lengths)
    numbers, _ = read_sources(sources)
    if numbers:
        computation._core.prepare(numbers, snapping_tolerance)
    of_sources = {"snapping_tolerance": snapping_tolerance, "maximum_relative_error": maximum_relative_error}
    if threads == 1:
        return (_compute(computation, source, of_sources, thresholds) for source in numbers)
    return _compute_in_threads(computation, numbers, threads or os.cpu_count() or 1, of_sources, thresholds)


def _compute(computation: CutLocus, source: Numbers, of_sources: Dict[str, Any], thresholds: Dict[str, Any]) -> Result:
    computation.set_source(source, **of_sources)
    return computation.cut_locus(**thresholds)


def _compute_in_threads(computation: CutLocus, sources: List[Numbers], threads: int, of_sources: Dict[str, Any],
                        thresholds: Dict[str, Any]) -> Iterator[Result]:
    free: "SimpleQueue[CutLocus]" = SimpleQueue()
    for _ in range(threads):
        free.put(computation._copy())

    def compute(source: Numbers) -> Result:
        copy = free.get()
        try:
            return _compute(copy, source, of_sources, thresholds)
        finally:
            free.put(copy)

    waiting: Deque[Future[Result]] = deque()
    with ThreadPoolExecutor(threads) as executor:
        try:
            for source in sources:
                waiting.append(executor.submit(compute, source))
                if len(waiting) > 2 * threads:  # so that none is idle while the oldest result is looked at
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        finally:
            for future in waiting:
                future.cancel()
