#include "raytracer/numerics/instruction_set.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "raytracer/util/error.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

#define RAYTRACER_TEXT(...) #__VA_ARGS__
#define RAYTRACER_TEXT_OF(...) RAYTRACER_TEXT(__VA_ARGS__)

// Such as "scalar,sse2".
constexpr std::string_view builtSets = RAYTRACER_TEXT_OF(RAYTRACER_INSTRUCTION_SETS);

// A set that every processor of its architecture has needs no line here.
bool isSupported([[maybe_unused]] InstructionSet set) {
#if defined(__x86_64__)
    if (nameOf(set) == "avx2") return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (nameOf(set) == "avx512")
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("fma");
#endif
    return true;
}

}  // namespace

std::string_view nameOf(InstructionSet set) {
    std::string_view rest = builtSets;
    for (auto before = static_cast<int>(set); before > 0; --before) rest.remove_prefix(rest.find(',') + 1);
    return rest.substr(0, rest.find(','));
}

std::vector<InstructionSet> supportedInstructionSets() {
    using enum InstructionSet;
    std::vector<InstructionSet> sets{RAYTRACER_INSTRUCTION_SETS};
    std::erase_if(sets, [](InstructionSet set) { return !isSupported(set); });
    return sets;
}

InstructionSet supportedInstructionSet(std::string_view name) {
    const std::vector<InstructionSet> sets = supportedInstructionSets();
    if (name.empty()) return sets.back();
    const auto found = std::ranges::find(sets, name, nameOf);
    if (found != sets.end()) return *found;
    std::vector<std::string> known;
    known.reserve(sets.size());
    for (const InstructionSet set : sets) known.emplace_back(nameOf(set));
    throw Error({"raytracer"}, "RAYTRACER_SIMD: expected " + listed(known) +
                                   ", which this processor has, found " + inQuotes(name));
}

InstructionSet defaultInstructionSet() {
    static const InstructionSet chosen = [] {
        const char* name = std::getenv("RAYTRACER_SIMD");
        return supportedInstructionSet(name ? name : "");
    }();
    return chosen;
}

}  // namespace raytracer
