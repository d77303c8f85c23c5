"""What every drawing keeps: no label on a line, none on another."""

import itertools
import math

import numpy as np

from mechc.drawing.drawing import Arc


def written(label):
    return "".join(run.text for run in label.runs)


def lettering(drawing):
    return [written(label) for label in drawing.labels]


def places(shape):
    """Return places along a shape, a fifth of a millimetre apart."""
    if isinstance(shape, Arc):
        count = 2 + math.ceil(abs(shape.sweep) * shape.radius / 0.2)
        angles = shape.start + np.linspace(0, shape.sweep, count)
        ring = np.column_stack([np.cos(angles), np.sin(angles)])
        return np.array(shape.centre) + shape.radius * ring
    points = [*shape.points, *(shape.points[:1] if shape.closed else ())]
    pairs = itertools.pairwise(points)
    return np.concatenate(
        [np.linspace(a, b, 2 + math.ceil(math.dist(a, b) / 0.2)) for a, b in pairs]
    )


def assert_readable(drawing):
    boxes = [
        (label.at.x, label.at.y, label.width / 2, label.height / 2, written(label))
        for label in drawing.labels
    ]
    for i, (x, y, w, h, text) in enumerate(boxes):
        for u, v, s, t, other in boxes[:i]:
            assert abs(x - u) >= w + s or abs(y - v) >= h + t, f"{text} touches {other}"
    lines = np.concatenate([places(shape) for shape in drawing.shapes])
    for x, y, w, h, text in boxes:
        on = (abs(lines[:, 0] - x) < w) & (abs(lines[:, 1] - y) < h)
        assert not on.any(), f"{text} is on a line"
    low, high = np.array(drawing.low), np.array(drawing.high)
    assert (lines > low).all()
    assert (lines < high).all()
