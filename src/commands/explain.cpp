// raytracer explain SCENE X Y LONG_EDGE_PIXELS: the rays behind one pixel.
#include <cstdio>
#include <string>

#include "arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/explain/explanation_text.h"
#include "render_arguments.h"

namespace raytracer::commands {

namespace {

constexpr const char* footer = R"(The tree of rays behind a pixel, in the symbols of the assignment:
  K_R I_R + K_T I_T + sum over lights (K_A I_AL + [K_D I_L (N.L) + K_S I_L (V.R)^n] S_L)
and the options that change a picture change the explanation too.

Examples:
  raytracer explain scenes/spheres_cylinder.json 300 200 600
  raytracer explain scenes/refraction.json 300 200 600 --max-recursion 1
  raytracer explain scenes/texture.json 10 590 600 --json)";

int explainPixel(const RenderArguments& arguments, int x, int y, bool json) {
    if (arguments.pass != "color" || arguments.samples != 1)
        throw std::invalid_argument(
            "explain follows the light along the ray through the pixel's centre: no --pass, no --samples");
    SceneDescription scene = arguments.load();
    const RenderOptions options = arguments.prepare(scene);
    if (x < 0 || y < 0 || x >= options.size.width || y >= options.size.height)
        throw std::invalid_argument("expected a pixel inside of the " + std::to_string(options.size.width) +
                                    " x " + std::to_string(options.size.height) + " picture, found " +
                                    std::to_string(x) + ", " + std::to_string(y));
    const auto renderer = makeRenderer(scene, arguments.precisionChosen(), arguments.buildOptions());
    const RayExplanation explanation = renderer->explain(options, x, y);
    const std::string text = json ? explanationJson(explanation, scene) : explanationText(explanation, scene);
    std::fputs(text.c_str(), stdout);
    return 0;
}

}  // namespace

int explain(int argc, char** argv) {
    CLI::App app("Shows the rays behind one pixel.", "raytracer explain");
    RenderArguments arguments;
    int x = 0, y = 0;
    bool json = false;
    arguments.addTo(app);
    app.add_option("X", x, "The pixel's column, 0 at the left")->required();
    app.add_option("Y", y, "The pixel's row, 0 at the top")->required();
    app.add_option("LONG_EDGE_PIXELS", arguments.longEdge, "Pixels along the longer side of the film")
        ->required()
        ->check(CLI::Range(1, 65536));
    app.add_flag("--json", json, "As JSON");
    app.footer(footer);
    if (const auto status = parseArguments(app, argc, argv)) return *status;
    return reportErrors([&] { return explainPixel(arguments, x, y, json); });
}

}  // namespace raytracer::commands
