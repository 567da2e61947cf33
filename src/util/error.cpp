#include "raytracer/util/error.h"

#include <cerrno>
#include <system_error>
#include <utility>

namespace raytracer {
namespace {

std::string within(const Place& place) {
    if (place.pointer) return *place.pointer;
    if (place.column > 0) return std::to_string(place.line) + ":" + std::to_string(place.column);
    return place.line > 0 ? "line " + std::to_string(place.line) : "";
}

std::string joined(const std::string& before, const char* separator, const std::string& after) {
    return before.empty() ? after : before + separator + after;
}

std::string afterFile(const Place& place, const std::string& message) {
    return joined(within(place), ": ", message);
}

}  // namespace

Error::Error(Place place, const std::string& message)
    : std::runtime_error(
          joined(place.file, !place.pointer && place.column > 0 ? ":" : ": ", afterFile(place, message))),
      place_(std::move(place)),
      inFile_(afterFile(place_, message)) {}

Error systemError(const std::string& file, const std::string& purpose) {
    return {{file}, joined(purpose, ": ", std::generic_category().message(errno))};
}

}  // namespace raytracer
