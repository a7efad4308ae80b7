"""Writes convex-hulls.json: meshes with the volume and the vertex count of their convex hull, by Qhull.

Run: pip install scipy==1.17.1 && python3 tests/support/physics/convex-hulls.py
"""

import json
import pathlib

import numpy
from scipy.spatial import ConvexHull

chance = numpy.random.default_rng(18)


def on_sphere(count):
    points = chance.normal(size=(count, 3))
    return points / numpy.linalg.norm(points, axis=1, keepdims=True)


def grid(nx, ny, height):
    x, y = numpy.meshgrid(numpy.linspace(-0.5, 0.5, nx), numpy.linspace(-0.3, 0.3, ny))
    return numpy.stack([x.ravel(), height(x, y).ravel(), y.ravel()], axis=1)


def box(size, center):
    corners = numpy.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    return corners * size + center


MESHES = {
    "points in a cube": chance.uniform(-0.2, 0.2, size=(60, 3)),
    "a boulder": on_sphere(36) * [0.3, 0.2, 0.25],
    "a dense sphere": on_sphere(300) * 0.2,
    "a thin rod": chance.uniform(-0.5, 0.5, size=(40, 3)) * [0.02, 1.5, 0.02],
    "a saddle": grid(12, 8, lambda x, y: x * x - y * y),
    "a chair of boxes": numpy.concatenate(
        [box([0.4, 0.05, 0.4], [0, 0.45, 0]), box([0.4, 0.5, 0.05], [0, 0.7, -0.2])]
        + [box([0.04, 0.45, 0.04], [x, 0.22, z]) for x in (-0.18, 0.18) for z in (-0.18, 0.18)]
    ),
}

result = []
for name, points in MESHES.items():
    stored = numpy.round(points, 4)
    hull = ConvexHull(stored)
    result.append(
        {"name": name, "points": stored.ravel().tolist(), "volume": hull.volume, "vertices": len(hull.vertices)}
    )
path = pathlib.Path(__file__).with_name("convex-hulls.json")
path.write_text(json.dumps(result) + "\n")
