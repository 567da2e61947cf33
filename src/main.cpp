// raytracer SCENE.json IMAGE_OUT LONG_EDGE_PIXELS [options], or raytracer COMMAND ...
#include <exception>
#include <new>
#include <string>

#include "raytracer/commands/commands.h"
#include "raytracer/util/error.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/standard_streams.h"

// What cannot even be told, for want of memory, ends the program by an abort.
int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
    raytracer::prepareStandardStreams();
    try {
        return raytracer::commands::run(argc, argv);
    } catch (const raytracer::Error& error) {
        raytracer::tell(error);
    } catch (const std::bad_alloc&) {
        raytracer::tell("raytracer: not enough memory: " + raytracer::memoryLeft().inWords);
    } catch (const std::exception& error) {
        raytracer::tell(std::string("raytracer: ") + error.what());
    }
    return 2;
}
