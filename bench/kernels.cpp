// The kernels on their own, by Google Benchmark: what one intersection, one light, one texel, one byte of PNG
// costs.
#include <cmath>
#include <filesystem>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "raytracer/pictures/image.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/scene_builder.h"
#include "raytracer/tracer/shading.h"

using namespace raytracer;

namespace {

constexpr std::size_t rayCount = 1024;  // a power of two: the loops below walk through them in a circle

// A small closed mesh: a sphere of rows x 2 rows quads, each two triangles, the pole's of no area left in.
std::shared_ptr<const MeshData> sphereMesh(int rows) {
    auto mesh = std::make_shared<MeshData>();
    const int columns = 2 * rows;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double polar = M_PI * row / rows, around = 2 * M_PI * column / columns;
            mesh->positions.push_back(
                {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)});
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto corner = [&](int r, int c) {
                return static_cast<std::uint32_t>(r * columns + c % columns);
            };
            const std::uint32_t a = corner(row, column), b = corner(row + 1, column),
                                c = corner(row + 1, column + 1), d = corner(row, column + 1);
            mesh->positionIndex.insert(mesh->positionIndex.end(), {a, b, c, a, c, d});
        }
    mesh->findBounds();
    return mesh;
}

// One shape, turned and a little stretched, in front of a camera whose film is somewhat wider than it; one
// light.
SceneDescription oneShape(ShapeType type, double shininess = 10) {
    SceneDescription scene;
    scene.camera.eye = {0, 0, 5};
    scene.camera.focal_length = 5;
    scene.camera.film_left = scene.camera.film_bottom = -1.5;
    scene.camera.film_right = scene.camera.film_top = 1.5;
    scene.materials.push_back({});
    scene.materials[0].color_ambient = glm::dvec3(0.1);
    scene.materials[0].shininess = shininess;
    scene.lights.push_back({{3, 4, 5}, glm::dvec3(1), glm::dvec3(1)});
    TransformDescription transform;
    transform.rotate = TransformDescription::Rotation{40, {1, 2, 0.5}};
    transform.scale = glm::dvec3(0.9, 1.1, 1.0);
    scene.transforms.push_back(transform);
    ShapeDescription shape;
    shape.type = type;
    if (type == ShapeType::Mesh) shape.mesh = sphereMesh(36);
    scene.shapes.push_back(shape);
    return scene;
}

// The same rays at every run.
std::vector<Ray> cameraRays(const Scene& scene) {
    std::mt19937 dice(1);
    std::uniform_real_distribution<Real> pixel(0, 1000);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < rayCount; ++i) {
        const Real x = pixel(dice), y = pixel(dice);
        rays.push_back(scene.camera.getRay(scene.camera.getPixelUV(x, y, 1000, 1000)));
    }
    return rays;
}

struct RayHit {
    Ray ray;
    Hit hit;
};

std::vector<RayHit> hitsOf(const Scene& scene, const std::vector<Ray>& rays) {
    std::vector<RayHit> hits;
    for (const Ray& ray : rays) {
        HitQuery query;
        scene.shapes[0].intersect(ray, query);
        if (query.found()) hits.push_back({ray, query.nearest()});
    }
    return hits;
}

void intersect(benchmark::State& state, ShapeType type) {
    const auto scene = buildScene(oneShape(type));
    const std::vector<Ray> rays = cameraRays(*scene);
    const Shape& shape = scene->shapes[0];
    std::size_t i = 0, hits = 0;
    for (auto _ : state) {
        HitQuery query;
        shape.intersect(rays[i++ % rayCount], query);
        hits += query.found();
        benchmark::DoNotOptimize(query);
    }
    state.counters["hit"] = benchmark::Counter(static_cast<double>(hits), benchmark::Counter::kAvgIterations);
}

void surface(benchmark::State& state, ShapeType type) {
    const auto scene = buildScene(oneShape(type));
    const std::vector<RayHit> hits = hitsOf(*scene, cameraRays(*scene));
    std::size_t i = 0;
    for (auto _ : state) {
        const RayHit& next = hits[i++ % hits.size()];
        benchmark::DoNotOptimize(next.hit.shape->surface(next.ray, next.hit));
    }
}

void light(benchmark::State& state, double shininess) {
    const auto scene = buildScene(oneShape(ShapeType::Sphere, shininess));
    std::vector<Ray> rays;
    std::vector<Intersection> hits;
    for (const RayHit& hit : hitsOf(*scene, cameraRays(*scene))) {
        rays.push_back(hit.ray);
        hits.push_back(hit.hit.shape->surface(hit.ray, hit.hit));
    }
    std::size_t i = 0;
    for (auto _ : state) {
        const std::size_t next = i++ % hits.size();
        benchmark::DoNotOptimize(directLight(ShadingPoint(rays[next], hits[next], false), scene->lights[0]));
    }
}

void texel(benchmark::State& state, Color (*look)(const Texture&, const Vec2&)) {
    Texture texture{{256, 256}, LargeVector<std::uint8_t>(256 * 256 * 3, 100)};
    Real u = 0;
    for (auto _ : state) {
        u = u < 1 ? u + Real(0.001) : 0;
        benchmark::DoNotOptimize(look(texture, Vec2(u, 1 - u)));
    }
}

// A rendered picture of 1000 x 1000, as a PNG is usually asked to hold.
void writePicture(benchmark::State& state) {
    const SceneDescription scene = oneShape(ShapeType::Cylinder);
    RenderOptions options;
    options.size = {1000, 1000};
    options.crop = {0, 0, 1000, 1000};
    ByteSink sink(options.crop);
    makeRenderer(scene, Precision::Double)->render(options, sink);
    const std::string path = (std::filesystem::temp_directory_path() / "raytracer_kernels.png").string();
    for (auto _ : state) writePng(path, sink.image());
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(sink.image().pixels.size()));
    std::filesystem::remove(path);
}

void quantise(benchmark::State& state) {
    ByteSink sink({0, 0, 1000, 1});
    std::vector<glm::dvec3> row;
    for (int x = 0; x < 1000; ++x) row.push_back(glm::dvec3(x / 900.0, 1 - x / 900.0, 0.5));
    for (auto _ : state) sink.write(0, 0, row);
    state.SetItemsProcessed(state.iterations() * 1000);
}

void parseMesh(benchmark::State& state) {
    std::string text;
    const auto mesh = sphereMesh(100);
    for (const glm::dvec3& p : mesh->positions)
        text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    for (std::size_t i = 0; i < mesh->positionIndex.size(); i += 3)
        text += "f " + std::to_string(mesh->positionIndex[i] + 1) + " " +
                std::to_string(mesh->positionIndex[i + 1] + 1) + " " +
                std::to_string(mesh->positionIndex[i + 2] + 1) + "\n";
    for (auto _ : state) benchmark::DoNotOptimize(parseObj(text));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

constexpr struct {
    const char* name;
    ShapeType type;
} shapes[] = {{"sphere", ShapeType::Sphere},     {"plane", ShapeType::Plane},
              {"cylinder", ShapeType::Cylinder}, {"cone", ShapeType::Cone},
              {"cube", ShapeType::Cube},         {"mesh of 5k triangles", ShapeType::Mesh}};

void addBenchmarks() {
    for (const auto& [name, type] : shapes)
        benchmark::RegisterBenchmark((std::string("intersect/") + name).c_str(), intersect, type);
    for (const auto& [name, type] : shapes)
        benchmark::RegisterBenchmark((std::string("surface/") + name).c_str(), surface, type);
    benchmark::RegisterBenchmark("directLight/shininess 10", light, 10.0);
    benchmark::RegisterBenchmark("directLight/shininess 10.5", light, 10.5);
    benchmark::RegisterBenchmark("lookUp/nearest", texel, lookUp);
    benchmark::RegisterBenchmark("lookUp/bilinear", texel, [](const Texture& texture, const Vec2& uv) {
        return lookUpBilinear(texture, uv, {.u = true, .v = true});
    });
    benchmark::RegisterBenchmark("quantise", quantise);
    benchmark::RegisterBenchmark("writePng/1 megapixel", writePicture)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
    benchmark::RegisterBenchmark("parseObj/40k triangles", parseMesh)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

}  // namespace

int main(int argc, char** argv) {
    addBenchmarks();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
