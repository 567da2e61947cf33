// raytracer explain SCENE X Y LONG_EDGE_PIXELS: the rays behind one pixel.
#include <string>

#include "arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/explain/explanation_text.h"
#include "raytracer/util/standard_streams.h"
#include "render_arguments.h"

namespace raytracer::commands {

namespace {

constexpr const char* explainFooter = R"(Prints the ray tree of a pixel, in the symbols of the assignment:
  K_R I_R + K_T I_T
    + sum over lights (K_A I_AL + [K_D I_L (N.L) + K_S I_L (V.R)^n] S_L)
Options that change the picture change the explanation too.

Exit status: 0, or 2 for a wrong command line or scene.

Examples:
  raytracer explain scenes/spheres_cylinder.json 300 200 600
  raytracer explain scenes/refraction.json 300 200 600 --max-recursion 1
  raytracer explain scenes/texture.json 10 590 600 --json)";

int explainPixel(const RenderArguments& arguments, int x, int y, bool json) {
    SceneDescription scene = arguments.load();
    const RenderOptions options = arguments.prepare(scene);
    if (x < 0 || y < 0 || x >= options.size.width || y >= options.size.height)
        throw usageError("expected a pixel inside of the " + std::to_string(options.size.width) + " x " +
                         std::to_string(options.size.height) + " picture, found " + std::to_string(x) + ", " +
                         std::to_string(y));
    const auto renderer = arguments.makeRenderer(scene);
    const RayExplanation explanation = renderer->explain(options, x, y);
    print(json ? explanationJson(explanation, scene) : explanationText(explanation, scene));
    return 0;
}

}  // namespace

int explain(int argc, char** argv) {
    CommandLine line("raytracer explain", "Shows the rays behind one pixel.");
    RenderArguments arguments;
    int x = 0, y = 0;
    bool json = false;
    arguments.addTo(line);
    line.number("X", x, {}, "The pixel's column; 0 is the left one");
    line.number("Y", y, {}, "The pixel's row; 0 is the top one");
    arguments.addLongEdgeTo(line);
    line.flag("--json", json, "Print the rays as JSON");
    line.lacks({"--pass", "--samples", "--adaptive", "--crop"},
               "explain follows the one ray through the pixel's centre");
    line.footer(explainFooter);
    if (const auto status = line.parse(argc, argv)) return *status;
    arguments.check(line);
    return explainPixel(arguments, x, y, json);
}

}  // namespace raytracer::commands
