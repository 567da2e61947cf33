"""The programs of students: test/tracer/plain_tracer.h, changed by hand, with one mistake each.

The changes were made without regard to how `raytracer` names mistakes. One program has them all, behind
flags: STUDENT SCENE.json OUT.png LONG_EDGE [MISTAKE ...].
"""
import re
import subprocess
from pathlib import Path

# Text of plain_tracer.h, and what stands there instead, once M(name) is on.
CHANGES = [
    # Bytes.
    ("const dvec3 color = clamp(rayColor(ray, 3), 0.0, 1.0);",
     """dvec3 color = rayColor(ray, 3);
                if (!M(wrap)) color = clamp(color, 0.0, 1.0);
                if (M(swapped)) std::swap(color.x, color.z);
                if (M(gamma)) color = pow(clamp(color, 0.0, 1.0), dvec3(1 / 2.2));
                if (M(srgb))
                    for (int i = 0; i < 3; ++i)
                        color[i] = color[i] > 0.0031308 ? 1.055 * std::pow(color[i], 1 / 2.4) - 0.055
                                                        : 12.92 * color[i];
                if (M(contrast)) color = color * color * (3.0 - 2.0 * color);"""),
    # Terms.
    ("color += m.color_ambient * light.color_ambient + direct(ray, hit, n, light);",
     """{
            const bool first = &light == &scene_.lights.front(), last = &light == &scene_.lights.back();
            if (M(no_first_light) && first) continue;
            if (M(no_last_light) && last) continue;
            dvec3 ambient = m.color_ambient * light.color_ambient;
            if (M(no_ambient) || (M(ambient_once) && !first)) ambient = dvec3(0);
            if (M(clamp_terms)) ambient = clamp(ambient, 0.0, 1.0);
            if (M(clamp_lights)) color += clamp(ambient + direct(ray, hit, n, light), 0.0, 1.0);
            else color += ambient + direct(ray, hit, n, light);
        }"""),
    ("return (diffuse(m, hit.texCoord) * nl + specular) * light.color * shadow(leaving(ray, p, l), light);",
     """dvec3 d = M(no_diffuse) ? dvec3(0) : diffuse(m, hit.texCoord) * nl;
        dvec3 s = M(no_specular) ? dvec3(0) : specular;
        if (M(half_shininess) && vr > 0) s = m.color_specular * std::pow(vr, m.shininess / 2);
        const dvec3 dark = M(no_shadows) ? dvec3(1) : shadow(leaving(ray, p, l), light);
        if (M(clamp_terms))
            return clamp(d * light.color * dark, 0.0, 1.0) + clamp(s * light.color * dark, 0.0, 1.0);
        const double fall = M(attenuation) ? 1 / dot(light.position - p, light.position - p) : 1.0;
        return (d + s) * light.color * dark * fall;"""),
    ("if (nl <= 0) return dvec3(0);", "if (nl <= 0 && !M(from_behind)) return dvec3(0);"),
    ("const double nl = dot(n, l), vr",
     "const double nl = M(absolute_cosine) ? std::abs(dot(n, l)) : dot(n, l), vr"),
    ("if (m.reflective)", "if (m.reflective && !M(no_reflections))"),
    ("if (!m.refractive || squared < 0) return color;",
     "if (!m.refractive || squared < 0 || M(no_refraction) || M(opaque)) return color;"),
    ("if (m.use_diffuse_texture)", "if (m.use_diffuse_texture && !M(no_textures))"),
    ("rayColor(ray, 3)", "rayColor(ray, M(one_less) ? 2 : M(one_more) ? 4 : M(no_bounce) ? 0 : 3)"),
    # Shadows.
    ("return hit.material->refractive ? hit.material->color_refract : dvec3(0);",
     """if (M(shadow_product)) {
            dvec3 all(1);
            for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
                Hit one;
                const dmat4& m = objectFromWorld_[i];
                const Ray ray{dvec3(m * dvec4(toLight.origin, 1)), dmat3(m) * toLight.direction};
                meet(scene_.shapes[i], ray, one);
                if (one.t >= distance(toLight.origin, light.position)) continue;
                const MaterialDescription& its = scene_.materials[scene_.shapes[i].material];
                all *= its.refractive ? its.color_refract : dvec3(0);
            }
            return all;
        }
        const bool clear = hit.material->refractive && !M(opaque_shadows) && !M(opaque);
        return clear ? hit.material->color_refract : dvec3(0);"""),
    ("if (!hit.material || hit.t >= distance(toLight.origin, light.position)) return dvec3(1);",
     "if (!hit.material || (hit.t >= distance(toLight.origin, light.position) && !M(shadows_from_behind))) "
     "return dvec3(1);"),
    ("return {p + 1e-9 * (length(p) + length(parent.origin)) * unit, unit};",
     "return {p + (M(acne) ? 0.0 : 1e-9) * (length(p) + length(parent.origin)) * unit, unit};"),
    # Normals and transforms.
    ("hit.normal = normalize(transpose(dmat3(m)) * hit.normal);",
     "hit.normal = normalize((M(matrix_normals) ? inverse(dmat3(m)) : transpose(dmat3(m))) * hit.normal);"),
    ("const dvec3 n = entering ? hit.normal : -hit.normal;",
     "const dvec3 n = M(inward_normals) ? -hit.normal : "
     "entering || M(one_sided) ? hit.normal : -hit.normal;"),
    ("if (transform.translate) m = glm::translate(m, *transform.translate);",
     """const dmat4 t = transform.translate ? glm::translate(dmat4(1), *transform.translate) : dmat4(1);
    double angle = transform.rotate ? transform.rotate->degrees : 0;
    angle = (M(rotate_back) ? -1 : 1) * (M(radians) ? angle : angle * 3.14159265358979323846 / 180);
    const dmat4 r = transform.rotate ? glm::rotate(dmat4(1), angle, transform.rotate->axis) : dmat4(1);
    const dmat4 s = transform.scale ? glm::scale(dmat4(1), *transform.scale) : dmat4(1);
    m = M(order_tsr) ? t * s * r : M(order_srt) ? s * r * t : M(order_rst) ? r * s * t
        : M(order_rts) ? r * t * s : M(order_str) ? s * t * r : t * r * s;"""),
    ("if (transform.rotate) m = glm::rotate(m, glm::radians(transform.rotate->degrees), "
     "transform.rotate->axis);", ""),
    ("if (transform.scale) m = glm::scale(m, *transform.scale);", ""),
    # The camera.
    ("const Ray ray = cameraRay((x + 0.5) / image.width, (y + 0.5) / image.height);",
     """double u = (x + 0.5) / image.width, v = (y + 0.5) / image.height;
                if (M(top_left)) u = double(x) / image.width, v = double(y) / image.height;
                if (M(bottom_left)) u = double(x) / image.width, v = double(y + 1) / image.height;
                if (M(edge_to_edge)) u = double(x) / (image.width - 1), v = double(y) / (image.height - 1);
                if (M(flip_up_down)) v = 1 - v;
                if (M(flip_left_right)) u = 1 - u;
                if (M(film_mirrored)) u = 1 - u, v = 1 - v;
                if (M(clockwise)) std::swap(u, v), v = 1 - v;
                if (M(counterclockwise)) std::swap(u, v), u = 1 - u;
                const Ray ray = cameraRay(u, v);"""),
    ("film - camera.focal_length * w",
     "film - (M(focal_mirrored) ? -1 : M(focal_doubled) ? 2 : 1) * camera.focal_length * w"),
    ("image.pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * color[i])));",
     "image.pixels.push_back(static_cast<std::uint8_t>(M(cut) ? static_cast<int>(255 * color[i]) : "
     "std::lround(255 * color[i])));"),
    ("dvec3 rayColor(const Ray& ray, int max_recursion) const {",
     """dvec3 rayColor(const Ray& ray, int max_recursion) const {
        const dvec3 color = openRayColor(ray, max_recursion);
        return M(clamp_rays) ? clamp(color, 0.0, 1.0) : color;
    }
    dvec3 openRayColor(const Ray& ray, int max_recursion) const {"""),
]

# What `raytracer` is to say of each, in part. Of those it cannot know: nothing.
KNOWN = {
    "no_ambient": "without ambient light", "no_diffuse": "without diffuse light",
    "no_specular": "without specular light",
    "no_shadows": "without shadows", "no_reflections": "without reflections",
    "no_refraction": "without refraction",
    "no_textures": "without textures", "one_less": "one bounce less", "one_more": "one bounce more",
    "no_bounce": "without any reflected or refracted ray", "opaque": "glass is opaque",
    "order_tsr": "translate * scale * rotate", "order_srt": "scale * rotate * translate",
    "order_rst": "rotate * scale * translate", "order_rts": "rotate * translate * scale",
    "order_str": "scale * translate * rotate", "radians": "degrees as radians",
    "rotate_back": "in the other sense",
    "matrix_normals": "by the matrix", "inward_normals": "normals point inwards",
    "no_first_light": "without light 0", "no_last_light": "without light ", "ambient_once": "added once",
    "opaque_shadows": "glass casts opaque shadows", "shadow_product": "product over all hits",
    "focal_mirrored": "looks back", "film_mirrored": "turned by 180 degrees",
    "flip_up_down": "flipped up and down",
    "flip_left_right": "flipped left and right", "clockwise": "turned clockwise",
    "counterclockwise": "turned counter-clockwise",
    "top_left": "top left corners", "bottom_left": "bottom left corners", "swapped": "red and blue exchanged",
    "gamma": "gamma of 2.2", "srgb": "sRGB", "wrap": "bytes wrap", "clamp_terms": "each term clamped",
    "cut": "cut instead of rounded",
    "acne": "acne",
}
# Named too, though no one asked.
MORE = {"clamp_lights": "each light's sum clamped",
        "clamp_rays": "each reflected and refracted ray clamped", "edge_to_edge": "from edge to edge",
        "from_behind": "light from behind"}
# No names of ours; what may be said all the same, as it is true.
UNKNOWN = {"half_shininess": None, "attenuation": None, "absolute_cosine": "acne", "focal_doubled": None,
           "contrast": None,
           "shadows_from_behind": "all that could be lit is in shadow",
           "one_sided": "not turned to the ray|equals the picture"}

MAIN = """
int main(int argc, char** argv) {
    for (int i = 4; i < argc; ++i) {
        const auto known = std::find(std::begin(names), std::end(names), std::string(argv[i]));
        if (known == std::end(names)) return 9;
        mistaken[known - std::begin(names)] = true;
    }
    const auto scene = raytracer::loadScene(argv[1]).description;
    raytracer::writePng(argv[2], raytracer::plain::Tracer(scene).render(std::stoi(argv[3])));
}
"""


def source(plain):
    """The students' program, made of the text of plain_tracer.h."""
    for old, new in CHANGES:
        assert plain.count(old) == 1, old
        plain = plain.replace(old, new)
    names = sorted(set(re.findall(r"\bM\((\w+)\)", plain)))
    assert set(names) == {*KNOWN, *MORE, *UNKNOWN}, set(names) ^ {*KNOWN, *MORE, *UNKNOWN}
    flags = "".join(f"{name}, " for name in names)
    listed = "".join(f'"{name}", ' for name in names)
    head = ("#include <string>\n#include \"include/raytracer/scene/scene_loader.h\"\n"
            f"enum class Mistaken {{ {flags}count }};\ninline bool "
            "mistaken[static_cast<int>(Mistaken::count)];\ninline const char* const names[] = "
            f"{{ {listed} }};\n#define M(name) mistaken[static_cast<int>(Mistaken::name)]\n")
    return plain.replace("#pragma once\n", head) + MAIN


def build(compiler, sources, libraries, out):
    """Compiles the students' program to `out`, unless it is there and newer than what it is made of."""
    plain = Path(sources) / "test/tracer/plain_tracer.h"
    made_of = [plain, Path(__file__),
               *map(Path, (library for library in libraries if Path(library).exists()))]
    if out.exists() and out.stat().st_mtime > max(path.stat().st_mtime for path in made_of):
        return
    code = out.with_suffix(".cpp")
    code.write_text(source(plain.read_text()))
    subprocess.run([compiler, "-std=c++20", "-O2", f"-I{sources}", f"-I{sources}/include", str(code), "-o",
                    str(out), *libraries], check=True)
