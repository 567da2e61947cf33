// The vector instruction sets that this program has code for, and which of them is used.
//
// CMakeLists.txt lists them and compiles the code that uses Lanes (lanes.h) once for each. Pictures are the
// same with any of them.
#pragma once

#include <string_view>
#include <vector>

namespace raytracer {

// From the least to the best. `scalar` is plain C++.
enum class InstructionSet { RAYTRACER_INSTRUCTION_SETS };

// The sets that this processor has, the best last.
std::vector<InstructionSet> supportedInstructionSets();

// The name in CMakeLists.txt, such as "avx2".
std::string_view nameOf(InstructionSet set);

// The set of this name, if this processor has it; its best one for an empty name. Throws Error for any other.
InstructionSet supportedInstructionSet(std::string_view name);

// The set that the environment variable RAYTRACER_SIMD names, or else the best. Throws Error where it names
// none that this processor has.
InstructionSet defaultInstructionSet();

}  // namespace raytracer
