"""Writes Tachyon 0.99 scenes.

Tachyon has no transforms: every shape is converted to world space. Its reader stores every number as a float.
"""
import numpy

from scene_file import read_obj

ELLIPSOID_SLICES = 64  # around; half as many from pole to pole


def numbers(values):
    return " ".join(repr(float(value)) for value in values)


def write(scene, size, out, lose):
    out.write(f"BEGIN_SCENE\nRESOLUTION {size[0]} {size[1]}\nSHADER_MODE FULL END_SHADER_MODE\n")
    write_camera(scene.camera, size, out, lose)
    out.write("BACKGROUND 0 0 0\n")
    for light in scene.lights:
        # Its lights are spheres that rays can see; this one is too small for any ray.
        out.write(
            f"LIGHT CENTER {numbers(light['position'][:3])} RAD 1e-30 COLOR {numbers(light['color'])}\n")
    ambient_light = sum(numpy.array(light["color_ambient"], float) for light in scene.lights)
    names = {}
    for material in scene.materials:
        names[material["name"]] = f"m{len(names)}"
        write_material(names[material["name"]], material, ambient_light, out, lose)
    for shape in scene.shapes:
        bake = {"sphere": sphere, "plane": plane, "cylinder": cylinder, "cone": cone, "cube": cube,
                "mesh": mesh}
        bake[shape.type](shape, names[shape.material["name"]], out, lose)
    out.write("END_SCENE\n")


def write_camera(camera, size, out, lose):
    """Its frame is left-handed and of unit vectors: the film is mirrored, and scaled to distance 1."""
    lengths = [numpy.linalg.norm(axis) for axis in (camera.u, camera.v, camera.w)]
    if abs(camera.v @ camera.w) > 1e-6 * lengths[1] * lengths[2]:
        lose("the camera's look and up aren't at right angles: up is turned until they are")
    distance = camera.focal_length * lengths[2] if camera.perspective else 1.0
    x_scale, y_scale = lengths[0] / distance, lengths[1] / distance
    # Its pixels count from 1 and look through their corners: half a pixel back.
    half_x, half_y = (camera.right - camera.left) / size[0] / 2, (camera.top - camera.bottom) / size[1] / 2
    film = [(half_x - camera.left) * x_scale, (half_x - camera.right) * x_scale,
            (camera.bottom - half_y) * y_scale, (camera.top - half_y) * y_scale]
    out.write(
        f"CAMERA PROJECTION {'PERSPECTIVE' if camera.perspective else 'ORTHOGRAPHIC'} ZOOM 1 ASPECTRATIO 1 "
              f"ANTIALIASING 0 RAYDEPTH 4 CENTER {numbers(camera.eye)} VIEWDIR "
              f"{numbers(-camera.w / lengths[2])} UPDIR {numbers(camera.v / lengths[1])} FRUSTUM "
              f"{numbers(film)} END_CAMERA\n")


def grey(color, what, lose):
    color = numpy.array(color, float)
    if color.max() == color.min():
        return float(color[0])
    lose(f"coloured {what} are grey: their mean")
    return float(color.mean())


def write_material(name, material, ambient_light, out, lose):
    diffuse = numpy.array(material["color_diffuse"], float)
    ambient = numpy.array(material["color_ambient"], float) * ambient_light
    if material["use_diffuse_texture"]:
        lose("textures left out: color_diffuse alone")
    # Ambient is a number that multiplies the colour, as diffuse is: exact where both colours have one hue.
    ambient_share = float(ambient @ diffuse / (diffuse @ diffuse)) if diffuse.any() else 0.0
    if abs(ambient - ambient_share * diffuse).max() > 1e-12:
        lose("ambient light has the hue of color_diffuse")
    opacity = 1.0
    if material["refractive"]:
        lose("glass doesn't bend light")
        opacity = 1.0 - grey(material["color_refract"], "glasses", lose)
    mirror = grey(material["color_reflect"], "mirrors", lose) if material["reflective"] else 0.0
    highlight = grey(material["color_specular"], "highlights", lose)
    phong = f"PHONG PLASTIC {highlight!r} PHONG_SIZE {material['shininess']!r} " if highlight else ""
    out.write(f"TEXDEF {name} AMBIENT {ambient_share!r} DIFFUSE {1.0 if diffuse.any() else 0.0!r} SPECULAR "
              f"{mirror!r} OPACITY {opacity!r} {phong}COLOR {numbers(diffuse)} TEXFUNC 0\n")


def sphere(shape, material, out, lose):
    scale = shape.similarity_scale()
    if scale is not None:
        out.write(f"SPHERE CENTER {numbers(shape.point(0, 0, 0))} RAD {float(scale)!r} {material}\n")
        return
    lose(f"ellipsoids are {ELLIPSOID_SLICES * (ELLIPSOID_SLICES - 2)} triangles with smooth normals")
    points = sphere_grid(ELLIPSOID_SLICES)
    smooth_grid(shape, points, points, material, out)


def sphere_grid(slices):
    """Rows from the north pole to the south pole, the first column repeated as the last."""
    polar, around = numpy.linspace(0, numpy.pi, slices // 2 + 1), numpy.linspace(0, 2 * numpy.pi, slices + 1)
    return numpy.stack([numpy.outer(numpy.sin(polar), numpy.cos(around)),
                        numpy.outer(numpy.sin(polar), numpy.sin(around)),
                        numpy.outer(numpy.cos(polar), numpy.ones_like(around))], axis=-1)


def smooth_grid(shape, points, normals, material, out):
    """A grid of rows x columns x 3 as triangles with smooth normals; the empty ones at a pole are left
    out."""
    rows, columns = points.shape[:2]
    position = shape.points(points.reshape(-1, 3)).reshape(points.shape)
    normal = shape.normals(normals.reshape(-1, 3)).reshape(points.shape)
    for row in range(rows - 1):
        for column in range(columns - 1):
            a, b, c, d = (row, column), (row + 1, column), (row + 1, column + 1), (row, column + 1)
            for corners in ((a, b, c), (a, c, d)):
                if any(numpy.allclose(points[corners[i]], points[corners[i - 1]], rtol=0, atol=1e-12)
                       for i in range(3)):
                    continue
                out.write("STRI " + " ".join(f"V{i} {numbers(position[corners[i]])}" for i in range(3)) +
                          " " +
                          " ".join(f"N{i} {numbers(normal[corners[i]])}" for i in range(3)) +
                          f" {material}\n")


def plane(shape, material, out, lose):
    normal = shape.normals(numpy.array([[0.0, 0.0, 1.0]]))[0]
    out.write(f"PLANE CENTER {numbers(shape.point(0, 0, 0))} NORMAL {numbers(normal)} {material}\n")


def disc(shape, z, material, out):
    """A cap: Tachyon's ring without a hole, or a fan of triangles where it is an ellipse."""
    radius = shape.round_radius()
    if radius is not None:
        normal = shape.normals(numpy.array([[0.0, 0.0, 1.0]]))[0]
        out.write(f"RING CENTER {numbers(shape.point(0, 0, z))} NORMAL {numbers(normal)} INNER 0 OUTER "
                  f"{float(radius)!r} {material}\n")
        return
    around = numpy.linspace(0, 2 * numpy.pi, ELLIPSOID_SLICES + 1)
    rim = shape.points(numpy.stack([numpy.cos(around), numpy.sin(around), numpy.full_like(around, z)],
                                   axis=-1))
    center = shape.point(0, 0, z)
    triangles(((center, rim[i], rim[i + 1]) for i in range(ELLIPSOID_SLICES)), material, out)


def triangles(corners, material, out):
    out.writelines("TRI V0 %r %r %r V1 %r %r %r V2 %r %r %r %s\n" % (*a, *b, *c, material)
                   for a, b, c in ([point.tolist() for point in triangle] for triangle in corners))


def cylinder(shape, material, out, lose):
    radius = shape.round_radius()
    if radius is not None:
        out.write(f"FCYLINDER BASE {numbers(shape.point(0, 0, 0))} APEX {numbers(shape.point(0, 0, 1))} "
                  f"RAD {float(radius)!r} {material}\n")
    else:
        lose(f"cylinders with an elliptic base are {4 * ELLIPSOID_SLICES} triangles with smooth normals")
        body(shape, 1.0, material, out)
    disc(shape, 0, material, out)
    disc(shape, 1, material, out)


def cone(shape, material, out, lose):
    lose(f"cones are {3 * ELLIPSOID_SLICES} triangles with smooth normals")
    body(shape, 0.0, material, out)
    disc(shape, 0, material, out)


def body(shape, top_radius, material, out):
    around = numpy.linspace(0, 2 * numpy.pi, ELLIPSOID_SLICES + 1)
    x, y, one = numpy.cos(around), numpy.sin(around), numpy.ones_like(around)
    points = numpy.stack([numpy.stack([x, y, 0 * one], axis=-1),
                          numpy.stack([top_radius * x, top_radius * y, one], axis=-1)])
    normals = numpy.stack([numpy.stack([x, y, (1 - top_radius) * one], axis=-1)] * 2)
    smooth_grid(shape, points, normals, material, out)


def cube(shape, material, out, lose):
    if shape.axis_aligned():
        corners = numpy.array([shape.point(-1, -1, -1), shape.point(1, 1, 1)])
        out.write(f"BOX MIN {numbers(corners.min(axis=0))} MAX {numbers(corners.max(axis=0))} {material}\n")
        return
    faces = []
    for axis in range(3):
        for side in (-1.0, 1.0):
            square = numpy.roll([[side, -1, -1], [side, 1, -1], [side, 1, 1], [side, -1, 1]], axis, axis=1)
            a, b, c, d = shape.points(square.astype(float))
            faces += [(a, b, c), (a, c, d)]
    triangles(faces, material, out)


def mesh(shape, material, out, lose):
    vertices, corners = read_obj(shape.mesh_path)
    points = shape.points(vertices)
    triangles(points[corners], material, out)
