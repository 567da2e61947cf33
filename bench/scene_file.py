"""Reads a scene JSON of ours for conversion: matrices multiplied, defaults filled in, meshes as arrays.

It trusts its input; the renderer checks scenes (raytracer --strict).
"""
import json
import pathlib
from dataclasses import dataclass

import numpy

# The defaults of a key that a material or light leaves out (scenes/scene.schema.json).
MATERIAL_DEFAULTS = {
    "color_ambient": [0, 0, 0], "color_diffuse": [1, 1, 1], "color_specular": [1, 1, 1], "shininess": 10,
    "reflective": False, "color_reflect": [1, 1, 1], "refractive": False, "color_refract": [1, 1, 1],
    "index_of_refraction": 1, "use_diffuse_texture": False,
}
LIGHT_DEFAULTS = {"position": [0, 0, 0, 1], "color": [1, 1, 1], "color_ambient": [1, 1, 1]}


@dataclass
class Camera:
    perspective: bool
    eye: numpy.ndarray
    u: numpy.ndarray  # the frame as given, never normalised: v = up, w = -look, u = v x w
    v: numpy.ndarray
    w: numpy.ndarray
    focal_length: float
    left: float
    right: float
    bottom: float
    top: float

    def image_size(self, long_edge):
        """(width, height): the longer film side gets long_edge pixels."""
        width, height = abs(self.right - self.left), abs(self.top - self.bottom)
        short = max(1, int(numpy.floor(long_edge * min(width, height) / max(width, height) + 0.5)))
        return (long_edge, short) if width >= height else (short, long_edge)


@dataclass
class Shape:
    type: str
    matrix: numpy.ndarray  # 4 x 4, object to world
    material: dict
    mesh_path: pathlib.Path | None

    def similarity_scale(self):
        """s where the linear part is s times a rotation or mirroring, else None."""
        linear = self.matrix[:3, :3]
        gram = linear.T @ linear
        scale_squared = numpy.trace(gram) / 3
        return numpy.sqrt(scale_squared) if numpy.allclose(gram, scale_squared * numpy.eye(3), rtol=0,
                                                           atol=1e-12 * scale_squared) else None

    def round_radius(self):
        """r where circles about z stay circles of radius r, across the image of the z axis, else None."""
        x, y, z = self.matrix[:3, :3].T
        r = numpy.linalg.norm(x)
        tilt = 1e-12 * r
        upright = abs(x @ z) <= tilt * numpy.linalg.norm(z) and abs(y @ z) <= tilt * numpy.linalg.norm(z)
        return r if upright and abs(x @ y) <= tilt * r and abs(numpy.linalg.norm(y) - r) <= tilt else None

    def axis_aligned(self):
        """Whether each object axis is mapped onto a world axis."""
        linear = abs(self.matrix[:3, :3])
        return bool((numpy.sort(linear, axis=0)[:2] <= 1e-15 * linear.max(axis=0)).all())

    def point(self, *object_point):
        return self.matrix[:3, :3] @ numpy.array(object_point, float) + self.matrix[:3, 3]

    def points(self, object_points):
        return object_points @ self.matrix[:3, :3].T + self.matrix[:3, 3]

    def normals(self, object_normals):
        # rows times the inverse: the inverse transpose
        world = object_normals @ numpy.linalg.inv(self.matrix[:3, :3])
        return world / numpy.linalg.norm(world, axis=1, keepdims=True)


@dataclass
class Scene:
    camera: Camera
    materials: list
    lights: list
    shapes: list


def rotation(degrees, axis):
    """Rodrigues' formula, 4 x 4."""
    x, y, z = numpy.array(axis, float) / numpy.linalg.norm(axis)
    radians = numpy.radians(degrees)
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    result = numpy.eye(4)
    result[:3, :3] += numpy.sin(radians) * cross + (1 - numpy.cos(radians)) * cross @ cross
    return result


def transform_matrix(transform):
    """translate * rotate * scale * matrix, whatever their order in the file."""
    result = numpy.eye(4)
    result[:3, 3] = transform.get("translate", [0, 0, 0])
    if "rotate" in transform:
        result = result @ rotation(transform["rotate"]["degrees"], transform["rotate"]["axis"])
    result = result @ numpy.diag([*transform.get("scale", [1, 1, 1]), 1.0])
    if "matrix" in transform:
        result = result @ numpy.array(transform["matrix"], float).T  # written as four columns
    return result


def read_camera(camera):
    v, w = numpy.array(camera["up"], float), -numpy.array(camera["look"], float)
    return Camera(camera["type"] == "perspective", numpy.array(camera["eye"], float), numpy.cross(v, w), v, w,
                  camera.get("focal_length", 1.0),
                  *(float(camera["film_" + side]) for side in ("left", "right", "bottom", "top")))


def read_scene(path):
    path = pathlib.Path(path)
    scene = json.loads(path.read_text())
    materials = [MATERIAL_DEFAULTS | material for material in scene["materials"]]
    material_named = {material["name"]: material for material in materials}
    matrix_named = {transform["name"]: transform_matrix(transform) for transform in scene["transforms"]}
    shapes = [Shape(shape["type"], matrix_named[shape["transform"]], material_named[shape["material"]],
                    path.parent / shape["path"] if shape["type"] == "mesh" else None)
              for shape in scene["shapes"]]
    return Scene(read_camera(scene["camera"]), materials,
                 [LIGHT_DEFAULTS | light for light in scene["lights"]], shapes)


def read_obj(path):
    """(vertices n x 3, triangles m x 3 from 0): positions only, faces fanned from their first corner."""
    vertices, triangles = [], []
    with open(path) as file:
        for line in file:
            if line.startswith("v "):
                vertices.append(line.split()[1:4])
            elif line.startswith("f "):
                corners = [int(corner.split("/", 1)[0]) for corner in line.split()[1:]]
                corners = [corner - 1 if corner > 0 else len(vertices) + corner for corner in corners]
                triangles += [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]
    return numpy.array(vertices, float), numpy.array(triangles, numpy.int64).reshape(-1, 3)
