#include "raytracer/util/file_hash.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "raytracer/util/file_bytes.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

// As FNV-1a (draft-eastlake-fnv), but eight bytes at a time, and with its high bits carried down.
class Hash {
  public:
    void add(std::uint64_t word) {
        hash_ = (hash_ ^ word) * 0x100000001b3;
        hash_ ^= hash_ >> 32;
    }
    void add(std::string_view text) {
        add(text.size());
        for (; !text.empty(); text.remove_prefix(std::min<std::size_t>(8, text.size()))) {
            std::uint64_t word = 0;
            std::memcpy(&word, text.data(), std::min<std::size_t>(8, text.size()));
            add(word);
        }
    }
    std::string inWords() const { return formatted("%016llx", static_cast<unsigned long long>(hash_)); }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace

std::string hashOfFiles(std::span<const std::string> paths) {
    Hash hash;
    for (const std::string& path : paths) hash.add(FileBytes(path, FileKind::Regular).text());
    return hash.inWords();
}

}  // namespace raytracer
