// Scene and options made of any bytes, from the text of the files to a tiny picture, which has to be one of
// numbers.
#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>

#include "memory_file.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/util/error.h"
#include "raytracer/util/text.h"

namespace {

using namespace raytracer;

// Most numbers are ordinary, so that scenes have something to see.
class Choices {
  public:
    Choices(Bytes data, std::size_t size) : bytes_(data, size) {}

    int whole(int low, int high) { return bytes_.ConsumeIntegralInRange<int>(low, high); }
    bool chance(int oneIn) { return whole(0, oneIn - 1) == oneIn - 1; }

    double number() {
        switch (whole(0, 15)) {
            default: return bytes_.ConsumeIntegral<std::int8_t>() / 16.0;
            case 12: return std::ldexp(whole(0, 1) * 2 - 1, whole(-1074, 1023));
            case 13: return extreme();
            case 14: return bytes_.ConsumeFloatingPointInRange<double>(-10, 10);
            case 15: {
                const auto any = bytes_.ConsumeFloatingPoint<double>();
                return std::isfinite(any) ? any : 0;
            }
        }
    }
    std::string text() { return formatted("%.17g", number()); }
    std::string vector() { return '[' + text() + ',' + text() + ',' + text() + ']'; }
    std::string color() {
        const auto channel = [&] { return chance(8) ? text() : formatted("%g", whole(0, 4) / 4.0); };
        return '[' + channel() + ',' + channel() + ',' + channel() + ']';
    }

  private:
    double extreme() {
        static constexpr double sizes[] = {0,      -0.0,  5e-324, 2.2250738585072014e-308, 1e-308,
                                           1e-100, 1e100, 1e308,  1.7976931348623157e308,  1 - 0x1p-53};
        return (whole(0, 1) * 2 - 1) * sizes[whole(0, std::size(sizes) - 1)];
    }

    FuzzedDataProvider bytes_;
};

template <class Item>
std::string list(int count, Item item) {
    std::string text = "[";
    for (int i = 0; i < count; ++i) text += (i > 0 ? "," : "") + item(i);
    return text + ']';
}

std::string cameraOf(Choices& choose) {
    std::string text = R"({"type":")" + std::string(choose.chance(2) ? "orthographic" : "perspective") + '"';
    const bool plain = choose.chance(2);
    text += R"(,"focal_length":)" + (plain ? "1" : choose.text());
    text += R"(,"eye":)" + (plain ? "[0,0,4]" : choose.vector());
    text += R"(,"look":)" + (plain ? "[0,0,-1]" : choose.vector());
    text += R"(,"up":)" + (plain ? "[0,1,0]" : choose.vector());
    for (const char* side : {"left", "bottom"})
        text += formatted(R"(,"film_%s":)", side) + (plain ? "-1" : choose.text());
    for (const char* side : {"right", "top"})
        text += formatted(R"(,"film_%s":)", side) + (plain ? "1" : choose.text());
    return text + '}';
}

std::string materialOf(Choices& choose, int number) {
    const bool reflective = choose.chance(3), refractive = choose.chance(3), textured = choose.chance(3);
    return formatted(R"({"name":"m%d","reflective":%s,"refractive":%s)", number,
                     reflective ? "true" : "false", refractive ? "true" : "false") +
           (textured ? R"(,"use_diffuse_texture":true,"diffuse_texture":"t")" : "") + R"(,"color_ambient":)" +
           choose.color() + R"(,"color_diffuse":)" + choose.color() + R"(,"color_specular":)" +
           choose.color() + R"(,"color_reflect":)" + choose.color() + R"(,"color_refract":)" +
           choose.color() + R"(,"shininess":)" + choose.text() + R"(,"index_of_refraction":)" +
           choose.text() + '}';
}

std::string transformOf(Choices& choose, int number) {
    std::string text = formatted(R"({"name":"x%d")", number);
    if (choose.chance(2)) text += R"(,"translate":)" + choose.vector();
    if (choose.chance(3))
        text += R"(,"rotate":{"degrees":)" + choose.text() + R"(,"axis":)" + choose.vector() + '}';
    if (choose.chance(2)) text += R"(,"scale":)" + choose.vector();
    if (choose.chance(4))
        text +=
            R"(,"matrix":)" + list(4, [&](int column) {
                return list(4, [&](int row) { return row == 3 ? column == 3 ? "1" : "0" : choose.text(); });
            });
    return text + '}';
}

std::string meshOf(Choices& choose) {
    std::string text;
    const int vertices = choose.whole(3, 8), faces = choose.whole(1, 6);
    const bool textured = choose.chance(2);
    for (int i = 0; i < vertices; ++i) {
        text += "v " + choose.text() + ' ' + choose.text() + ' ' + choose.text() + '\n';
        if (textured) text += "vt " + choose.text() + ' ' + choose.text() + '\n';
    }
    for (int i = 0; i < faces; ++i) {
        text += 'f';
        for (int corners = choose.whole(3, 6); corners > 0; --corners) {
            const std::string index = std::to_string(choose.whole(1, vertices));
            text += ' ' + index + (textured ? '/' + index : "");
        }
        text += '\n';
    }
    return text;
}

std::string sceneOf(Choices& choose, const std::string& meshPath, const std::string& texturePath) {
    static constexpr const char* types[] = {"sphere", "plane", "cylinder", "cone", "cube", "mesh"};
    const int materials = choose.whole(1, 3), transforms = choose.whole(1, 4);
    std::string text = R"({"camera":)" + cameraOf(choose);
    text += R"(,"textures":{"t":")" + texturePath + "\"}";
    text += R"(,"materials":)" + list(materials, [&](int i) { return materialOf(choose, i); });
    text += R"(,"lights":)" + list(choose.whole(0, 2), [&](int) {
                return R"({"position":)" + choose.vector() + R"(,"color":)" + choose.color() + '}';
            });
    text += R"(,"transforms":)" + list(transforms, [&](int i) { return transformOf(choose, i); });
    text += R"(,"shapes":)" + list(choose.whole(1, 10), [&](int) {
                const char* const type = types[choose.whole(0, 5)];
                const std::string path = type == types[5] ? R"(,"path":")" + meshPath + '"' : "";
                return formatted(R"({"type":"%s","transform":"x%d","material":"m%d")", type,
                                 choose.whole(0, transforms - 1), choose.whole(0, materials - 1)) +
                       path + '}';
            });
    return text + '}';
}

// Rays double at each bounce where a material both reflects and refracts: so few bounces, samples and pixels.
RenderOptions optionsOf(Choices& choose, const CameraDescription& camera) {
    RenderOptions options;
    options.size = imageSize(camera, choose.whole(1, 3));
    options.crop = {0, 0, options.size.width, options.size.height};
    options.max_recursion = choose.chance(4) ? choose.whole(0, 4) : 2;
    options.pass = static_cast<Pass>(choose.chance(4) ? choose.whole(0, 2) : 0);
    options.shadows = !choose.chance(4);
    options.refraction = !choose.chance(4);
    options.threads = 1;
    options.samples = choose.whole(1, 3);
    if (choose.chance(4)) options.adaptive = 0.02;
    if (choose.chance(4)) options.cutoff = 0.01;
    options.bilinear = choose.chance(2);
    return options;
}

BuildOptions buildOptionsOf(Choices& choose) {
    BuildOptions options;
    options.threads = 1;
    if (choose.chance(3)) options.accelerator = Accelerator::None;
    if (choose.chance(3)) options.instructionSet = InstructionSet{};
    return options;
}

const std::string& aTexture() {
    static const MemoryFile file;
    const std::vector<char> png = encodePng({{2, 2}, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}});
    return file.write(png.data(), png.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(Bytes data, std::size_t size) {
    static const MemoryFile sceneFile, meshFile;
    static const std::string texture = aTexture();
    Choices choose(data, size);
    try {
        meshFile.write(meshOf(choose));
        const SceneDescription scene =
            loadScene(sceneFile.write(sceneOf(choose, meshFile.path(), texture))).description;
        // Extended takes most of the time, and scenes that are too extreme for the others get it anyway.
        const Precision precision = choose.chance(8)   ? Precision::Extended
                                    : choose.chance(2) ? Precision::Float
                                                       : Precision::Double;
        const auto renderer = makeRenderer(scene, precision, buildOptionsOf(choose));
        const RenderOptions options = optionsOf(choose, scene.camera);
        FloatSink sink(options.crop);
        renderer->render(options, sink);
        MemoryFile::require(std::ranges::none_of(sink.image().pixels, [](float c) { return std::isnan(c); }));
    } catch (const Error&) {
    }
    return 0;
}
