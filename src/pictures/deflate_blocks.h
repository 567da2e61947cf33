// Finds the last block of a deflate stream (RFC 1951).
#pragma once

#include <cstddef>
#include <span>

namespace raytracer {

// Places in bits from the stream's beginning.
struct LastBlock {
    std::size_t begin;  // the place of its BFINAL bit
    std::size_t end;
};

// The stream must be complete and valid, and 8 more bytes behind it must be readable.
LastBlock lastBlock(std::span<const unsigned char> deflated);

}  // namespace raytracer
