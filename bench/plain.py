"""Reduces a scene of ours to what all programs can express, so that all draw the same picture: no textures,
grey mirrors and highlights, ambient light of color_diffuse's hue. Glass stays."""
import json
import pathlib


def grey(color):
    return [sum(color) / 3] * 3


def simplify(material, lose):
    if material.pop("use_diffuse_texture", False):
        lose("without its textures")
    for key in ("color_specular", "color_reflect"):
        if len(set(material.get(key, [1]))) > 1:
            lose("with grey mirrors and highlights")
            material[key] = grey(material[key])
    diffuse, ambient = material.get("color_diffuse", [1, 1, 1]), material.get("color_ambient", [0, 0, 0])
    share = sum(a * d for a, d in zip(ambient, diffuse)) / (sum(d * d for d in diffuse) or 1)
    hued = [share * d for d in diffuse]
    if max(abs(a - h) for a, h in zip(ambient, hued)) > 1e-12:
        lose("with ambient light of color_diffuse's hue")
        material["color_ambient"] = hued


def write_plain(scene_path, out, lose):
    scene_path = pathlib.Path(scene_path).resolve()
    scene = json.loads(scene_path.read_text())
    scene.pop("textures", None)
    for material in scene["materials"]:
        simplify(material, lose)
    ambients = {tuple(light["color_ambient"]) for light in scene["lights"] if "color_ambient" in light}
    for light in scene["lights"]:
        if any(len(set(ambient)) > 1 for ambient in ambients):
            lose("with grey ambient light")
            light["color_ambient"] = grey(light.get("color_ambient", [1, 1, 1]))
    for shape in scene["shapes"]:
        if "path" in shape:
            shape["path"] = str(scene_path.parent / shape["path"])
    json.dump(scene, out)
