// A zlib stream (RFC 1950) made on several threads; its bytes do not depend on their number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raytracer {

using Bytes = std::vector<unsigned char>;

// A part of a stream. Each but the last ends on a byte, as zlib's Z_SYNC_FLUSH makes it.
struct DeflatedPiece {
    Bytes bytes;
    std::uint32_t adler;  // the checksum of what was deflated, and how much that was
    std::size_t size;
};

// The next pieces of a stream; where `isEnd`, the last. `level` is libdeflate's, 1 to 12. Throws
// std::bad_alloc.
std::vector<DeflatedPiece> deflatePieces(std::span<const unsigned char> text, bool isEnd, int level,
                                         int threads);

inline constexpr unsigned char zlibHeader[] = {0x78, 0x01};
inline constexpr std::uint32_t adlerOfNothing = 1;

// The checksum of a text and what follows it.
std::uint32_t adlerWith(std::uint32_t text, const DeflatedPiece& next);

// A number as PNG and zlib have it.
void appendBigEndian(Bytes& bytes, std::uint32_t number);

// What stb's writer uses in this thread; 0 is one for each processor.
void setDeflateThreads(int threads);

}  // namespace raytracer
