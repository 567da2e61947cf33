// Makes a zlib stream (RFC 1950) on several threads. Its bytes do not depend on the number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raytracer {

using Bytes = std::vector<unsigned char>;

// A part of a stream. Each but the last ends on a byte boundary, as after zlib's Z_SYNC_FLUSH.
struct DeflatedPiece {
    Bytes bytes;
    std::uint32_t adler;  // the checksum of the data before compression
    std::size_t size;     // their number of bytes
};

// Makes the next pieces of a stream; with `isEnd`, the last
// ones. `level` is libdeflate's, 1 to 12. Throws std::bad_alloc.
std::vector<DeflatedPiece> deflatePieces(std::span<const unsigned char> text, bool isEnd, int level,
                                         int threads);

inline constexpr unsigned char zlibHeader[] = {0x78, 0x01};
inline constexpr std::uint32_t adlerOfNothing = 1;

// The checksum of some data and the piece that follows them, from the checksums of both.
std::uint32_t adlerWith(std::uint32_t text, const DeflatedPiece& next);

// Appends a number in the byte order of PNG and zlib.
void appendBigEndian(Bytes& bytes, std::uint32_t number);

// Sets the number of threads that stb's writer uses when called from this thread; 0: one for each processor.
void setDeflateThreads(int threads);

}  // namespace raytracer
