"""Writes POV-Ray 3.7 scenes."""
import numpy

from scene_file import read_obj

# color_ambient doesn't depend on color_diffuse, POV-Ray's ambient does: a channel without diffuse gets this
# much, and its ambient is divided by it. A ten-thousandth of a byte's step.
LEAST_DIFFUSE = 1e-7


def vector(values):
    return "<" + ",".join(repr(float(value)) for value in values) + ">"


def write(scene, size, out, lose):
    out.write("#version 3.7;\n"
              "global_settings { assumed_gamma 1.0 max_trace_level 4 ambient_light rgb 1 }\n"
              "background { rgb 0 }\n")
    write_camera(scene.camera, size, out)
    for light in scene.lights:
        out.write(f"light_source {{ {vector(light['position'][:3])}, rgb {vector(light['color'])} }}\n")
    ambient_light = sum(numpy.array(light["color_ambient"], float) for light in scene.lights)
    names = {}
    for material in scene.materials:
        names[material["name"]] = f"material_{len(names)}"
        write_material(names[material["name"]], material, ambient_light, out, lose)
    for shape in scene.shapes:
        out.write(f"{body(shape)} material {{ {names[shape.material['name']]} }} }}\n")


def write_camera(camera, size, out):
    """direction + x right + y up, x and y from -1/2 to 1/2: vectors as given, so off-centre films and skew
    frames too."""
    center = (camera.left + camera.right) / 2 * camera.u + (camera.bottom + camera.top) / 2 * camera.v
    right = (camera.right - camera.left) * camera.u
    up = (camera.top - camera.bottom) * camera.v
    kind, location, direction = (("perspective", camera.eye, center - camera.focal_length * camera.w)
                                 if camera.perspective
                                 else ("orthographic", camera.eye + center, -camera.w))
    out.write(f"camera {{ {kind} location {vector(location)} direction {vector(direction)} "
              f"right {vector(right)} up {vector(up)} }}\n")


def write_material(name, material, ambient_light, out, lose):
    diffuse = numpy.array(material["color_diffuse"], float)
    specular = numpy.array(material["color_specular"], float)
    ambient = numpy.array(material["color_ambient"], float) * ambient_light
    if material["use_diffuse_texture"]:
        lose("textures left out: color_diffuse alone")
    if specular.max() > specular.min():
        lose("coloured highlights are grey: their mean")
    if material["refractive"]:
        lose("refraction: total internal reflection is reflected rather than black, light through glass is "
             "filtered at each surface rather than once, nested glass refracts by the ratio of the two")
        if diffuse.any():
            lose("a refractive material has no diffuse term")
        pigment = f"pigment {{ rgbf <{','.join(repr(float(c)) for c in material['color_refract'])},1> }}"
        interior = f" interior {{ ior {material['index_of_refraction']!r} }}"
        if ambient.any():
            lose("a refractive material has no ambient term")
        ambient = numpy.zeros(3)
    else:
        pigment = f"pigment {{ rgb {vector(numpy.maximum(diffuse, LEAST_DIFFUSE))} }}"
        interior = ""
    reflection = ""
    if material["reflective"]:
        reflection = f" reflection {{ rgb {vector(material['color_reflect'])} }}"
    phong = f" phong {specular.mean()!r} phong_size {material['shininess']!r}" if specular.any() else ""
    out.write(f"#declare {name} = material {{ texture {{ {pigment} finish {{ "
              f"ambient rgb {vector(ambient / numpy.maximum(diffuse, LEAST_DIFFUSE))} diffuse "
              f"1{phong}{reflection} }} }}{interior} }};\n")


def body(shape):
    """The shape without its closing brace. Baked into the primitive where it can be, as a POV-Ray user would
    write it."""
    bake = {"sphere": sphere, "plane": plane, "cylinder": cylinder, "cone": cone, "cube": box, "mesh": mesh}
    return bake[shape.type](shape)


def matrix(shape):
    rows = [*shape.matrix[:3, :3].T, shape.matrix[:3, 3]]
    return "matrix <" + ",".join(repr(float(value)) for row in rows for value in row) + ">"


def sphere(shape):
    scale = shape.similarity_scale()
    if scale is None:
        return f"sphere {{ 0, 1 {matrix(shape)}"
    return f"sphere {{ {vector(shape.point(0, 0, 0))}, {scale!r}"


def plane(shape):
    normal = shape.normals(numpy.array([[0.0, 0.0, 1.0]]))[0]
    return f"plane {{ {vector(normal)}, {float(normal @ shape.point(0, 0, 0))!r}"


def cylinder(shape):
    radius = shape.round_radius()
    if radius is None:
        return f"cylinder {{ 0, z, 1 {matrix(shape)}"
    return f"cylinder {{ {vector(shape.point(0, 0, 0))}, {vector(shape.point(0, 0, 1))}, {radius!r}"


def cone(shape):
    radius = shape.round_radius()
    if radius is None:
        return f"cone {{ 0, 1, z, 0 {matrix(shape)}"
    return f"cone {{ {vector(shape.point(0, 0, 0))}, {radius!r}, {vector(shape.point(0, 0, 1))}, 0"


def box(shape):
    if not shape.axis_aligned():
        return f"box {{ -1, 1 {matrix(shape)}"
    corners = numpy.array([shape.point(-1, -1, -1), shape.point(1, 1, 1)])
    return f"box {{ {vector(corners.min(axis=0))}, {vector(corners.max(axis=0))}"


def mesh(shape):
    vertices, triangles = read_obj(shape.mesh_path)
    points = shape.points(vertices).tolist()
    return (f"mesh2 {{ vertex_vectors {{ {len(points)}," +
            ",\n".join("<%r,%r,%r>" % tuple(p) for p in points) +
            f" }} face_indices {{ {len(triangles)}," +
            ",\n".join("<%d,%d,%d>" % tuple(t) for t in triangles.tolist()) + " }")
