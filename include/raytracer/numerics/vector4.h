// Vectors of four numbers, by the vector types of GCC and Clang on any processor: one number for each axis,
// and one to spare.
#pragma once

#include <cstdint>

namespace raytracer {

using Float4 [[gnu::vector_size(16)]] = float;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;
using Double4 [[gnu::vector_size(32)]] = double;
using Long4 [[gnu::vector_size(32)]] = std::int64_t;

}  // namespace raytracer
