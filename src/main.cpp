// raytracer SCENE.json IMAGE_OUT LONG_EDGE_PIXELS [options], or raytracer COMMAND ...
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "raytracer/commands/commands.h"
#include "raytracer/util/error.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/standard_streams.h"

namespace {

struct Command {
    std::string_view name;
    int (*run)(int argc, char** argv);
};

constexpr Command commandTable[] = {
    {"compare", raytracer::commands::compare},
    {"explain", raytracer::commands::explain},
    {"grade", raytracer::commands::grade},
    {"tradeoff", raytracer::commands::tradeoff},
};

int dispatch(int argc, char** argv) {
    for (const Command& command : commandTable)
        if (argc > 1 && command.name == argv[1]) return command.run(argc - 1, argv + 1);
    return raytracer::commands::render(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
    raytracer::prepareStandardStreams();
    try {
        return dispatch(argc, argv);
    } catch (const raytracer::Error& error) {
        raytracer::tell(error.what());
    } catch (const std::bad_alloc&) {
        raytracer::tell("raytracer: not enough memory: " + raytracer::memoryLeft().inWords);
    } catch (const std::exception& error) {
        raytracer::tell(std::string("raytracer: ") + error.what());
    }
    return 2;
}
