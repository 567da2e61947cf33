// The tracer against a plain one that shares no code with it: plain_tracer.h.
#include <cstdio>
#include <random>

#include <catch2/catch.hpp>

#include "../support/described.h"
#include "../support/slowness.h"
#include "plain_pixels.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

// What two right tracers may differ by: 3 pixels of 250,000 by more than 1, where a ray is tangent to a
// surface or bounces between curved ones until the last bits of double show.
class Comparison {
  public:
    void add(const std::string& name, const SceneDescription& scene, int longEdge) {
        add(name, bytesOf(scene, longEdge), plain::Tracer(scene).render(longEdge));
    }

    void add(const std::string& name, const ByteImage& ours, const ByteImage& plain) {
        REQUIRE(ours.width == plain.width);
        REQUIRE(ours.height == plain.height);
        const int off = differingPixels(ours, plain, 1);
        pixels_ += ours.pixels.size() / 3;
        off_ += off;
        if (off > 0) where_ += "\n  " + name + ": " + std::to_string(off);
    }

    void check(const char* what) const {
        std::printf("%s: %d of %zu pixels are off by more than 1%s\n", what, off_, pixels_, where_.c_str());
        CHECK(off_ <= 3 * std::max(1.0, static_cast<double>(pixels_) / 250000));
    }

  private:
    std::size_t pixels_ = 0;
    int off_ = 0;
    std::string where_;
};

std::size_t triangleCount(const SceneDescription& scene) {
    std::size_t count = 0;
    for (const ShapeDescription& shape : scene.shapes)
        if (shape.mesh) count += shape.mesh->triangleCount();
    return count;
}

// Scenes in the ordinary range of numbers, about the origin. The same on every machine.
class RandomScene {
  public:
    explicit RandomScene(unsigned seed) : bits_(seed) {
        addTextures();
        for (int i = 0; i < 4; ++i) addMaterial();
        const int shapes = chance(0.1) ? whole(30, 60) : whole(3, 12);
        for (int i = 0; i < shapes; ++i) addShape();
        const int lights = whole(1, 3);
        for (int i = 0; i < lights; ++i)
            scene.lights.push_back({6.0 * box(), color(0.7, 1.4), color(0.1, 0.5)});
        addCamera();
    }

    SceneDescription scene;

  private:
    double between(double low, double high) {
        return low + (high - low) * 0x1p-53 * static_cast<double>(bits_() >> 11);
    }
    int whole(int low, int high) { return low + static_cast<int>(bits_() % (high - low + 1)); }
    bool chance(double probability) { return between(0, 1) < probability; }
    glm::dvec3 color(double low, double high) {
        const double r = between(low, high), g = between(low, high);
        return {r, g, between(low, high)};
    }
    glm::dvec3 box() { return color(-1, 1); }
    glm::dvec3 direction() { return normalize(box()); }

    void addTextures() {
        for (const char* name : {"one", "two"}) {
            Texture texture{{whole(1, 9), whole(1, 9)}, {}};
            for (int i = 0; i < 3 * texture.width * texture.height; ++i)
                texture.texels.push_back(static_cast<std::uint8_t>(whole(0, 255)));
            scene.textures.push_back({name, std::make_shared<const Texture>(texture)});
        }
    }

    void addMaterial() {
        MaterialDescription m;
        m.color_ambient = color(0, 0.5);
        m.color_diffuse = color(0.3, 1);
        m.color_specular = color(0, 0.5);
        m.shininess = chance(0.5) ? whole(0, 60) : between(0.2, 60);
        m.reflective = chance(0.4);
        m.color_reflect = color(0.2, 0.8);
        m.refractive = chance(0.3);
        m.color_refract = color(0.2, 0.9);
        m.index_of_refraction = chance(0.1) ? 1 : between(0.6, 2);
        m.use_diffuse_texture = chance(0.6);
        m.texture = chance(0.5) ? 0 : 1;
        m.diffuse_texture = scene.textures[m.texture].name;
        scene.materials.push_back(m);
    }

    // One in five takes the place of the shape before it: surfaces that coincide to the last bit. (Ones that
    // coincide by the geometry alone, as a sphere and the same turned, come in an order that is up to
    // rounding.)
    void addShape() {
        if (scene.shapes.empty() || !chance(0.2)) addTransform();
        static constexpr ShapeType types[] = {ShapeType::Sphere, ShapeType::Cylinder, ShapeType::Cone,
                                              ShapeType::Cube, ShapeType::Mesh};
        const ShapeType type = chance(0.1) ? ShapeType::Plane : types[whole(0, 4)];
        const std::size_t material = static_cast<std::size_t>(whole(0, 3));
        scene.shapes.push_back(
            {type, scene.transforms.size() - 1, material, type == ShapeType::Mesh ? mesh() : nullptr});
    }

    void addTransform() {
        TransformDescription t;
        if (!scene.transforms.empty() || chance(0.5)) t.translate = 2.5 * box();
        if (chance(0.7)) t.rotate = TransformDescription::Rotation{between(-360, 360), 2.0 * box()};
        if (chance(0.7)) {
            t.scale = color(0.4, 1.4);
            for (int axis = 0; axis < 3; ++axis) (*t.scale)[axis] *= chance(0.2) ? -1 : 1;
        }
        if (chance(0.4)) {
            glm::dmat4 matrix(1);
            for (int column = 0; column < 4; ++column) matrix[column] += glm::dvec4(0.4 * box(), 0);
            t.matrix = matrix;
        }
        scene.transforms.push_back(t);
    }

    // An octahedron with its corners in or out, sometimes with triangles missing, sometimes with texture
    // coordinates.
    std::shared_ptr<const MeshData> mesh() {
        MeshData mesh;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {1.0, -1.0}) {
                glm::dvec3 p = 0.2 * box();
                p[axis] += side * between(0.5, 1.5);
                mesh.positions.push_back(p);
                mesh.texCoords.push_back((3.0 * glm::dvec2(box()) + 1.0) / 2.0);  // -1 to 2
            }
        const bool open = chance(0.3), textured = chance(0.7);
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            if (open && chance(0.3)) continue;
            const std::uint32_t x = octant & 1, y = 2 + (octant >> 1 & 1), z = 4 + (octant >> 2);
            const bool turned = (x + y + z) % 2 == 1;
            for (const std::uint32_t corner : {x, turned ? z : y, turned ? y : z}) {
                mesh.positionIndex.push_back(corner);
                if (textured) mesh.texCoordIndex.push_back(chance(0.9) ? corner : MeshData::noTexCoord);
            }
        }
        mesh.findBounds();
        return std::make_shared<const MeshData>(mesh);
    }

    // Looks from outside, or from among the shapes, with a frame that is neither of unit length nor square.
    void addCamera() {
        CameraDescription& camera = scene.camera;
        const bool perspective = chance(0.6);
        camera.type =
            perspective ? CameraDescription::Type::Perspective : CameraDescription::Type::Orthographic;
        const double distance = chance(0.8) ? between(6, 9) : between(1, 4), unit = between(0.7, 1.4);
        camera.eye = distance * direction();
        camera.look = unit * normalize(box() - camera.eye);
        camera.up = cross(normalize(cross(camera.look, direction())), camera.look);
        camera.up += 0.3 * box();
        camera.focal_length = between(0.5, 2);
        const double size = perspective ? 0.6 * camera.focal_length : 4;
        camera.film_left = -size * between(0.5, 1);
        camera.film_right = size * between(0.5, 1);
        camera.film_bottom = -size * between(0.5, 1);
        camera.film_top = size * between(0.5, 1);
    }

    std::mt19937_64 bits_;
};

}  // namespace

TEST_CASE("the scenes look as a plain tracer of the model has them") {
    Comparison comparison;
    for (const std::string& file : sceneFiles()) {
        const SceneDescription scene = loadScene(file).description;
        const double pixels = (triangleCount(scene) > 500 ? 1500.0 : 15000.0) / slowness;
        comparison.add(file, scene, static_cast<int>(std::sqrt(pixels)));
    }
    comparison.check("scenes");
}

TEST_CASE("random scenes look as a plain tracer of the model has them") {
    Comparison comparison;
    for (unsigned seed = 1; seed <= 300 / slowness; ++seed)
        comparison.add("random scene " + std::to_string(seed), RandomScene(seed).scene, 60);
    comparison.check("random scenes");
}

TEST_CASE("several samples of a pixel look as a plain tracer has their mean") {
    constexpr int edge = 40, samples = 7, most = 32;  // more pixels than a tile has
    constexpr double adaptive = 0.03;
    Comparison fixed, adapted;
    for (unsigned seed = 301; seed <= 300 + 20 / slowness; ++seed) {
        const SceneDescription scene = RandomScene(seed).scene;
        const plain::Pixels plain(scene, edge);
        const std::string name = "random scene " + std::to_string(seed);
        const auto ours = [&](int limit, double error) {
            return bytesOf(scene, edge, Precision::Double, [&](RenderOptions& options) {
                options.samples = limit;
                options.adaptive = error;
            });
        };
        fixed.add(name, ours(samples, 0), plain.render(samples));
        FirstSamples first;
        makeRenderer(scene, Precision::Double)->renderFirst(wholePicture(scene, edge), first);
        std::vector<glm::dvec2> extra;
        for (const ExtraSample& sample : first.extra) extra.push_back(sample.point);
        adapted.add(name, ours(most, adaptive), plain.renderAdaptive(most, adaptive, extra));
    }
    fixed.check("samples");
    adapted.check("adaptive samples");
}
