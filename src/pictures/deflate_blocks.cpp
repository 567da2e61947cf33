#include "deflate_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace raytracer {
namespace {

constexpr std::size_t longestCode = 15;  // bits

// A decoding table: the symbol for the next bits of the stream, as many bits as the longest code has.
class PrefixCode {
  public:
    struct Symbol {
        std::uint16_t value, length;  // length: of its code, bits
    };

    // Builds the table from the lengths of the codes (RFC 1951, 3.2.2). Length 0: the symbol has no code.
    void build(std::span<const std::uint8_t> lengths) {
        std::array<std::size_t, longestCode + 1> count{}, next{};
        for (const std::uint8_t length : lengths) ++count[length];
        count[0] = 0;
        for (std::size_t length = 1; length <= longestCode; ++length)
            next[length] = (next[length - 1] + count[length - 1]) << 1;
        size_ = std::size_t{1} << *std::ranges::max_element(lengths);
        for (std::size_t i = 0; i < lengths.size(); ++i)
            if (lengths[i] > 0) fill({static_cast<std::uint16_t>(i), lengths[i]}, next[lengths[i]]++);
    }

    const Symbol& at(std::uint64_t bits) const { return symbols_[bits & (size_ - 1)]; }

  private:
    // A code's highest bit comes first in the stream. The table's index has the stream's first bit lowest, so
    // the code is reversed.
    void fill(const Symbol& symbol, std::size_t code) {
        std::size_t reversed = 0;
        for (int bit = 0; bit < symbol.length; ++bit) reversed = reversed << 1 | (code >> bit & 1);
        for (std::size_t i = reversed; i < size_; i += std::size_t{1} << symbol.length) symbols_[i] = symbol;
    }

    std::size_t size_ = 1;
    std::array<Symbol, 1 << longestCode> symbols_;
};

class BlockReader {
  public:
    explicit BlockReader(const unsigned char* stream) : stream_(stream) {}

    LastBlock toLast() {
        for (;;) {
            const std::size_t begin = position_;
            const bool isLast = take(1);
            skipBlock(take(2));
            if (isLast) return {begin, position_};
        }
    }

  private:
    // The next bits of the stream, at least 57.
    std::uint64_t bits() const {
        std::uint64_t word = 0;
        std::memcpy(&word, stream_ + position_ / 8, sizeof word);
        if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
        return word >> position_ % 8;
    }
    std::size_t take(std::size_t count) {
        const std::size_t value = bits() & ((std::uint64_t{1} << count) - 1);
        position_ += count;
        return value;
    }
    std::size_t takeSymbol(const PrefixCode& code) {
        const PrefixCode::Symbol& symbol = code.at(bits());
        position_ += symbol.length;
        return symbol.value;
    }

    void skipBlock(std::size_t type) {
        if (type == 0) return skipStored();
        if (type == 1) buildFixed();
        else readCodes();
        skipSymbols();
    }
    void skipStored() {
        position_ = (position_ + 7) / 8 * 8;
        const std::size_t bytes = take(16);
        position_ += 16 + 8 * bytes;
    }

    void buildFixed() {
        std::array<std::uint8_t, 288> lengths;
        for (std::size_t i = 0; i < lengths.size(); ++i)
            lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
        literals_.build(lengths);
        constexpr std::array<std::uint8_t, 30> distances = {5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5,
                                                            5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
        distances_.build(distances);
    }
    void readCodes() {  // RFC 1951, 3.2.7
        constexpr std::uint8_t order[] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
        const std::size_t literals = take(5) + 257, distances = take(5) + 1, codes = take(4) + 4;
        std::array<std::uint8_t, 19> codeLengths{};
        for (std::size_t i = 0; i < codes; ++i) codeLengths[order[i]] = static_cast<std::uint8_t>(take(3));
        literals_.build(codeLengths);
        std::array<std::uint8_t, 320> lengths{};
        for (std::size_t i = 0; i < literals + distances;) {
            const std::size_t symbol = takeSymbol(literals_);
            const std::size_t repeats = symbol < 16    ? 1
                                        : symbol == 16 ? 3 + take(2)
                                        : symbol == 17 ? 3 + take(3)
                                                       : 11 + take(7);
            const auto length = symbol < 16    ? static_cast<std::uint8_t>(symbol)
                                : symbol == 16 ? lengths[i - 1]
                                               : 0;
            std::fill_n(lengths.begin() + static_cast<std::ptrdiff_t>(i), repeats, length);
            i += repeats;
        }
        literals_.build(std::span(lengths).first(literals));
        distances_.build(std::span(lengths).subspan(literals, distances));
    }

    // A length and a distance have at most 15 + 5 + 15 + 13 bits: bits() has all of them.
    void skipSymbols() {
        constexpr std::size_t end = 256, longestMatch = 285;
        for (;;) {
            std::uint64_t next = bits();
            const PrefixCode::Symbol& symbol = literals_.at(next);
            position_ += symbol.length;
            if (symbol.value < end) continue;
            if (symbol.value == end) return;
            const int code = symbol.value - 257;
            const int lengthBits = code < 8 || symbol.value == longestMatch ? 0 : code / 4 - 1;
            next >>= symbol.length + lengthBits;
            const PrefixCode::Symbol& distance = distances_.at(next);
            const int distanceBits = distance.value < 4 ? 0 : distance.value / 2 - 1;
            position_ += static_cast<std::size_t>(lengthBits + distance.length + distanceBits);
        }
    }

    const unsigned char* stream_;
    std::size_t position_ = 0;  // bits
    PrefixCode literals_, distances_;
};

}  // namespace

LastBlock lastBlock(std::span<const unsigned char> deflated) { return BlockReader(deflated.data()).toLast(); }

}  // namespace raytracer
