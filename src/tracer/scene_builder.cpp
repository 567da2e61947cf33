#include "raytracer/tracer/scene_builder.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <span>

#include "raytracer/bvh/spatial_order.h"
#include "raytracer/tracer/packet_tracer.h"
#include "raytracer/util/memory.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

Material buildMaterial(const MaterialDescription& description, const SceneDescription& scene) {
    Material material;
    material.color_ambient = Color(description.color_ambient);
    material.color_diffuse = Color(description.color_diffuse);
    material.color_specular = Color(description.color_specular);
    material.shininess = static_cast<Real>(description.shininess);
    material.reflective = description.reflective;
    material.color_reflect = Color(description.color_reflect);
    material.refractive = description.refractive;
    material.color_refract = Color(description.color_refract);
    material.index_of_refraction = static_cast<Real>(description.index_of_refraction);
    if (description.use_diffuse_texture)
        material.diffuse_texture = scene.textures[description.texture].texture.get();
    return material;
}

Light buildLight(const LightDescription& description, const SceneFrame& frame) {
    return {Vec3(frame.pointToFrame(description.position)), Color(description.color),
            Color(description.color_ambient)};
}

// Shapes that name the same OBJ file share its triangles.
using MeshCache = std::map<const MeshData*, std::shared_ptr<const TriangleMesh>>;

// The order in which shapes are made, and so lie in memory. Many shapes are ordered so that neighbours in
// space, which the same rays hit, lie side by side.
std::vector<std::uint32_t> orderOfMaking(const SceneDescription& description) {
    constexpr std::size_t many = 1000;  // fewer stay in a processor's cache
    std::vector<std::uint32_t> order(description.shapes.size());
    std::iota(order.begin(), order.end(), 0u);
    if (order.size() < many) return order;
    std::vector<glm::vec3> places;
    places.reserve(order.size());
    for (const ShapeDescription& shape : description.shapes) {
        // A matrix may put the shape elsewhere, and the place may be beyond float: then the order is only a
        // worse one.
        const glm::vec3 place(description.transforms[shape.transform].translate.value_or(glm::dvec3(0)));
        places.push_back(
            glm::clamp(place, -std::numeric_limits<float>::max(), std::numeric_limits<float>::max()));
    }
    return spatialOrder(places);
}

LargeVector<Shape> buildShapes(const SceneDescription& description, const SceneFrame& frame,
                               const std::vector<Material>& materials, const BuildOptions& options) {
    LargeVector<Shape> shapes;
    reserveMemory(shapes, description.shapes.size(), {}, "shapes");
    MeshCache meshes;
    const std::vector<std::uint32_t> order = orderOfMaking(description);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const ShapeDescription& shape = description.shapes[order[i]];
        // Composed again: cheaper than to keep what chooseFrame composed.
        const Transform transform(frame.toFrame(worldFromObject(description, shape)));
        std::shared_ptr<const TriangleMesh> triangles;
        if (shape.mesh) {
            triangles = meshes[shape.mesh.get()];
            if (!triangles) triangles = std::make_shared<TriangleMesh>(shape.mesh, options);
            meshes[shape.mesh.get()] = triangles;
        }
        shapes.emplace_back(shape.type, transform, materials[shape.material], order[i], std::move(triangles));
    }
    return shapes;
}

Real brightestOf(const Scene& scene) {
    Color brightest(0);
    for (const Light& light : scene.lights)
        brightest = glm::max(brightest, glm::max(abs(light.color), abs(light.color_ambient)));
    for (const Material& m : scene.materials)
        for (const Color& color :
             {m.color_ambient, m.color_diffuse, m.color_specular, m.color_reflect, m.color_refract})
            brightest = glm::max(brightest, abs(color));
    return maxComponent(brightest);
}

// The width of the picture at a hit. Where the eye touches the shape, at least the shape's size or the
// distance of the nearest light from the hit, whichever is less.
Real pictureWidth(const Scene& scene, const Ray& ray, const Intersection& hit) {
    const Transform& transform = hit.shape->transform();
    const Real width = scene.camera.width(hit.t);
    if (!hit.shape->touches(ray.origin, transform.writtenError(ray.origin), hit.primitive)) return width;
    Real least = transform.largestScale();
    for (const Light& light : scene.lights)
        least = std::min(least, maxComponent(abs(light.position - hit.position)));
    return std::max(least, width);
}

// Whether the position of a hit is known well enough, as its shape sees the ray. Hits are projected onto a
// sphere, a cone or, along x and y, a cylinder: on a very flat one the result may be anywhere, so the error
// in object space must be at most `most`. On a cone an error along one axis causes errors along the others.
// So it does where a ray leaves a mesh (Mesh::toObject).
bool isPlaced(const Ray& ray, const Intersection& hit, const Real& width, const Real& most) {
    const Transform& transform = hit.shape->transform();
    const ShapeType type = hit.shape->type();
    const Vec3 error = unitRoundoff * (abs(ray.origin) + abs(hit.t * ray.direction));
    Vec3 objectError = transform.objectError(hit.position, error);
    const Real largest = maxComponent(objectError), across = std::max(objectError.x, objectError.y);
    if ((type == ShapeType::Sphere || type == ShapeType::Cone) && largest > most) return false;
    if (type == ShapeType::Cylinder && across > most) return false;
    if (type == ShapeType::Cone || type == ShapeType::Mesh) objectError = Vec3(largest);
    const Vec3 worldError = absoluteProduct(transform.linear(), objectError) + hit.positionError;
    return maxComponent(worldError) <= mostPositionError * width;
}

// The least distance from a light within which a whole shape lies, of every step-th shape. The error of a ray
// that comes there from afar shows, relative to this distance, in the shape's shadow and in its mirror image.
Real nearestToLight(const Scene& scene, std::size_t step) {
    Real nearest = infinity;
    for (const Light& light : scene.lights)
        for (std::size_t i = 0; i < scene.shapes.size(); i += step) {
            FloatBox box;
            if (!scene.shapes[i].bounds(box)) continue;
            Real farthest = 0;  // of the box's corners, along one axis
            for (int axis = 0; axis < 3; ++axis) {
                const Real low = box.low[axis], high = box.high[axis], place = light.position[axis];
                farthest = std::max({farthest, abs(low - place), abs(high - place)});
            }
            nearest = std::min(nearest, farthest);
        }
    return nearest;
}

// The most that a hit may be wrong by, relative to that distance: a fifth of the digits, so 2^-10 in double.
// Of float it asks for 1/16 only: few pixels of a picture lie at such a shadow's edge.
constexpr Real mostShadowError = 1 / powerOfTwo(std::numeric_limits<Real>::digits / 5);

// A small shape, such as a wire, shows less of an error relative to its size.
constexpr Real mostSmallError = 64 * mostPositionError;

// Whether the hits of some camera rays are known well enough: of rays all over the picture, and of rays to
// the middle of some shapes, which may be small.
bool isSharp(const Scene& scene) {
    constexpr int rays = 8;  // along an edge
    const RenderOptions options;
    RenderCounts counts;
    const RenderContext context{&options, nullptr, &counts};
    const std::size_t step = scene.shapes.size() / (rays * rays) + 1;
    const Real nearest = nearestToLight(scene, step) * (mostShadowError / mostPositionError);
    const auto isSharpAt = [&](const Vec2& uv, const Real& most, const Real& leastSize) {
        const Ray ray = scene.camera.getRay(uv);
        const Intersection hit = scene.closestIntersection(ray, context);
        if (!hit.valid || hit.shape->transform().largestScale() < leastSize * scene.camera.width(hit.t))
            return true;
        const Real width = std::min(pictureWidth(scene, ray, hit), nearest);
        return isPlaced(ray, hit, width, most);
    };
    for (int y = 0; y < rays; ++y)
        for (int x = 0; x < rays; ++x) {
            const Vec2 centre(static_cast<Real>(x) + Real(0.5), static_cast<Real>(y) + Real(0.5));
            if (!isSharpAt(scene.camera.getPixelUV(centre.x, centre.y, rays, rays), mostPositionError, 0))
                return false;
        }
    for (std::size_t i = 0; i < scene.shapes.size(); i += step) {
        const auto uv = scene.camera.uvOf(scene.shapes[i].transform().translation());
        if (uv && !isSharpAt(*uv, mostSmallError, mostPositionError)) return false;  // dust need not be sharp
    }
    return true;
}

// Whether Real's range of exponents is wide enough for the scene's numbers.
bool fits(const Scene& scene) {
    Real finest = 1, farthest = std::max(Real(1), scene.camera.farthest()), flattest = 1;
    for (const Light& light : scene.lights) farthest = std::max(farthest, maxComponent(abs(light.position)));
    for (const Shape& shape : scene.shapes) {
        finest = std::max(finest, shape.transform().finest());
        farthest = std::max(farthest, shape.transform().farthest());
        if (shape.type() == ShapeType::Mesh)
            flattest = std::min(flattest, static_cast<Real>(shape.triangles().data().finest));
    }
    return scene.frame.eyeDistance <= farthestEye && scene.camera.reach() <= farthestEye &&
           finest * farthest <= widestRange && flattest * flattest >= 1 / widestRange &&
           brightestOf(scene) <= brightestFactor;
}

// A light's buffer takes up to 48 KiB; of so many the caches hold the parts in use.
constexpr std::size_t mostBuffers = 16;

// That of the best set up to this one for which Real has packets; null where there is none. The sets are
// listed from the least to the best.
template <InstructionSet... sets>
TracePacket* bestUpTo([[maybe_unused]] InstructionSet most) {
    TracePacket* best = nullptr;
    ((best = sets <= most ? tracePacket<sets> : best), ...);
    return best;
}

}  // namespace

std::unique_ptr<const Scene> buildScene(const SceneDescription& description, const BuildOptions& options) {
    auto scene = std::make_unique<Scene>();
    scene->frame = chooseFrame(description);
    scene->camera = Camera(description.camera, scene->frame);
    for (const TextureDescription& texture : description.textures) scene->textures.push_back(texture.texture);
    reserveMemory(scene->materials, description.materials.size(), {}, "materials");
    for (const MaterialDescription& material : description.materials)
        scene->materials.push_back(buildMaterial(material, description));
    reserveMemory(scene->lights, description.lights.size(), {}, "lights");
    for (const LightDescription& light : description.lights)
        scene->lights.push_back(buildLight(light, scene->frame));
    scene->shapes = buildShapes(description, scene->frame, scene->materials, options);
    scene->tree = ShapeTree(scene->shapes, options);
    if (scene->camera.isPerspective()) scene->fromEye = scene->tree.fromEye(-scene->camera.viewOf(Vec3(0)));
    for (const Light& light : std::span(scene->lights).first(std::min(mostBuffers, scene->lights.size())))
        scene->toLights.push_back(scene->tree.toLight(light.position));
    scene->hasRefractiveShape = std::any_of(scene->shapes.begin(), scene->shapes.end(),
                                            [](const Shape& shape) { return shape.material().refractive; });
    scene->fits = fits(*scene) && isSharp(*scene);
    using enum InstructionSet;
    if (options.accelerator == Accelerator::Bvh)
        scene->tracePacket =
            bestUpTo<RAYTRACER_PACKET_SETS>(options.instructionSet);  // CMakeLists.txt's list
    return scene;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
