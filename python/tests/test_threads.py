"""Other threads run, functions that are told the progress may raise, and Ctrl-C ends a computation."""

import os
import signal
import threading
import time

import cut_locus
import meshes
import numpy as np
import pytest


@pytest.fixture(scope="module")
def large():
    return meshes.bumpy_sphere(6)


class Stop(Exception):
    pass


def test_stages():
    events = []
    cut_locus.compute(*meshes.octahedron(), 0, progress=lambda stage, ends: events.append((stage, ends)))
    stages = [stage for stage, ends in events if ends]
    assert list(dict.fromkeys(stages)) == ["preprocessing", "distance", "strength", "tree", "homology", "filter"]
    assert events[::2] == [(stage, False) for stage in stages] and events[1::2] == [(stage, True) for stage in stages]


@pytest.mark.parametrize("stage", ["preprocessing", "distance", "strength", "tree", "homology", "filter"])
@pytest.mark.parametrize("ends", [False, True])
def test_progress_that_raises(stage, ends):
    points, faces = meshes.octahedron()
    expected = cut_locus.compute(points, faces, 0)
    is_raised = True

    def progress(*now):
        if is_raised and now == (stage, ends):
            raise Stop(stage)

    if stage == "preprocessing":
        with pytest.raises(Stop, match=stage):
            cut_locus.CutLocus(points, faces, progress=progress)
        return
    computation = cut_locus.CutLocus(points, faces, progress=progress)
    with pytest.raises(Stop, match=stage):
        computation.set_source(0)
        computation.cut_locus()
    is_raised = False
    computation.set_source(0)  # it can be used again
    assert np.array_equal(computation.cut_locus().points, expected.points)


def test_progress_that_uses_its_object():
    def progress(stage, ends):
        if stage == "distance":
            computation.cut_locus()

    computation = cut_locus.CutLocus(*meshes.octahedron(), progress=progress)
    with pytest.raises(RuntimeError, match="can not be used by the progress function"):
        computation.set_source(0)


@pytest.mark.parametrize("work", [
    lambda *mesh: cut_locus.CutLocus(*mesh).set_source(0),
    lambda *mesh: cut_locus.ExactGeodesics(*mesh).compute([0, 1, 2, 3, 4, 5, 6]),
])
def test_gil_is_released(large, work):
    def longest_silence():
        """of this thread, while another one computes, as a share of its time"""
        times = []

        def run():
            times.append(time.monotonic())
            work(*large)
            times.append(time.monotonic())

        ticks = []
        thread = threading.Thread(target=run)
        thread.start()
        while thread.is_alive():
            ticks.append(time.monotonic())
            time.sleep(0.001)
        thread.join()
        start, end = times
        within = [start] + [t for t in ticks if start < t < end] + [end]
        return np.diff(within).max() / (end - start)

    # with the lock held it is silent each time; on a busy machine it may be for once
    assert any(longest_silence() < 0.5 for _ in range(10))


def test_objects_in_threads(large):
    sources = [0, 17, 1234]
    expected = [cut_locus.exact_geodesic_distances(*large, s) for s in sources]
    results = {}

    def work(source):
        results[source] = cut_locus.exact_geodesic_distances(*large, source)

    threads = [threading.Thread(target=work, args=(s,)) for s in sources]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for source, distance in zip(sources, expected):
        assert np.array_equal(results[source], distance)


def test_one_object_in_threads():
    points, faces = meshes.bumpy_sphere(4)
    computation = cut_locus.CutLocus(points, faces)
    computation.set_source(0)
    widths = [0.02, 0.05, 0.1, 0.2]
    expected = [computation.cut_locus(minimum_branch_width=w).points for w in widths]
    faults = []

    def work():
        for _ in range(3):
            for width, right in zip(widths, expected):
                if not np.array_equal(computation.cut_locus(minimum_branch_width=width).points, right):
                    faults.append(width)

    def set_sources():
        for source in range(1, 10):
            computation.set_source(source)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not faults
    threads = [threading.Thread(target=set_sources) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert computation.cut_locus().vertex_distance[9] == 0.


@pytest.mark.skipif(os.name == "nt", reason="signals are sent in the way of POSIX")
def test_ctrl_c(large):
    expected = cut_locus.compute(*large, 0)
    starts = threading.Event()

    def interrupt():
        starts.wait()
        os.kill(os.getpid(), signal.SIGINT)

    computation = cut_locus.CutLocus(*large)
    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        try:
            starts.set()
            computation.set_source(0)
        finally:
            thread.join()
    # it was not done before the signal was looked at
    with pytest.raises(cut_locus.InvalidInput, match="no source"):
        computation.cut_locus()
    computation.set_source(0)
    assert np.array_equal(computation.cut_locus().points, expected.points)
