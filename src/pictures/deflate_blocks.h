// Where the blocks of a deflate stream are (RFC 1951).
#pragma once

#include <cstddef>
#include <span>

namespace raytracer {

// Places in bits from the stream's beginning.
struct LastBlock {
    std::size_t begin;  // this bit says that the block is the last
    std::size_t end;
};

// Of a whole, sound stream, behind which 8 more bytes can be read.
LastBlock lastBlock(std::span<const unsigned char> deflated);

}  // namespace raytracer
