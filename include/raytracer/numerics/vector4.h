// Four numbers that are added and compared together, by GCC's and Clang's vectors on any processor: three
// axes' and one that is not used.
#pragma once

#include <cstdint>

namespace raytracer {

using Float4 [[gnu::vector_size(16)]] = float;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;
using Double4 [[gnu::vector_size(32)]] = double;
using Long4 [[gnu::vector_size(32)]] = std::int64_t;

}  // namespace raytracer
