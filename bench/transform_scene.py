#!/usr/bin/python3
"""Moves a scene, and changes its unit of length: every point p becomes scale * p + translation.

    bench/transform_scene.py SCENE.json [--scale 1e6] [--translate X Y Z] [--translate-sizes K] OUT.json

--translate-sizes K moves the scene by K of its sizes, in a direction without round numbers. The picture
should not change.
"""
import argparse
import json
import pathlib

DIRECTION = (0.72, -0.43, 0.545)  # of --translate-sizes, about a unit vector


def moved(point, scale, translation):
    return [scale * x + t for x, t in zip(point, translation)]


def transform_camera(camera, scale, translation):
    """A perspective camera's rays are directions, which stay; an orthographic one's film is a place."""
    camera["eye"] = moved(camera["eye"], scale, translation)
    if camera["type"] == "orthographic":
        for side in ("left", "right", "bottom", "top"):
            camera["film_" + side] *= scale


def transform_scene(scene_path, out_path, scale, translation):
    scene_path = pathlib.Path(scene_path).resolve()
    scene = json.loads(scene_path.read_text())
    transform_camera(scene["camera"], scale, translation)
    for light in scene["lights"]:
        light["position"] = moved(light["position"][:3], scale, translation)
    # translate * rotate * scale * matrix: scaling all scales the first and third
    for transform in scene["transforms"]:
        transform["translate"] = moved(transform.get("translate", [0, 0, 0]), scale, translation)
        transform["scale"] = [scale * s for s in transform.get("scale", [1, 1, 1])]
    for shape in scene["shapes"]:
        if "path" in shape:
            shape["path"] = str(scene_path.parent / shape["path"])
    if "textures" in scene:
        scene["textures"] = {name: str(scene_path.parent / path) for name, path in scene["textures"].items()}
    pathlib.Path(out_path).write_text(json.dumps(scene))


def scene_size(scene_path):
    """The longest side of the box around the eye and every shape but planes, meshes by their transform's
    place alone."""
    import numpy
    from scene_file import read_scene
    scene = read_scene(scene_path)
    cube = numpy.stack(numpy.meshgrid(*[[-1.0, 1.0]] * 3), axis=-1).reshape(-1, 3)
    boxes = [shape.points(cube) for shape in scene.shapes if shape.type not in ("plane", "mesh")]
    boxes += [shape.point(0, 0, 0)[None] for shape in scene.shapes if shape.type == "mesh"]
    points = numpy.concatenate([scene.camera.eye[None], *boxes])
    return float((points.max(axis=0) - points.min(axis=0)).max())


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--translate", type=float, nargs=3, default=[0.0, 0.0, 0.0])
    parser.add_argument("--translate-sizes", type=float, default=0.0)
    parser.add_argument("out")
    arguments = parser.parse_args()
    translation = arguments.translate
    if arguments.translate_sizes:
        distance = arguments.translate_sizes * scene_size(arguments.scene) * arguments.scale
        translation = [t + distance * d for t, d in zip(translation, DIRECTION)]
    transform_scene(arguments.scene, arguments.out, arguments.scale, translation)


if __name__ == "__main__":
    main()
