// Stores the pictures of a page, equal ones once. If they are few, they are in the page itself, else in a
// folder beside it.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <unordered_map>

namespace raytracer {

class PictureShelf {
  public:
    // For the page that will be at this path: "out.html" has the folder "out_pictures".
    explicit PictureShelf(const std::string& page);

    const std::string& folder() const { return folder_; }

    // Adds the bytes of a PNG file and returns their key. Empty bytes have the empty key. Thread-safe. Throws
    // Error if the folder cannot be written.
    std::string add(const std::string& png);

    // A JSON object from keys to addresses for an <img>.
    std::string addresses() const;

  private:
    static constexpr std::size_t mostInPage = std::size_t{20} << 20;  // bytes

    std::string file(const std::string& key) const;
    bool has(const std::string& key, const std::string& png) const;  // whether these are the key's bytes
    void write(const std::string& key, const std::string& png) const;

    std::string folder_, link_;  // the folder's path, and its name
    std::mutex mutex_;
    std::unordered_multimap<std::size_t, std::string> keys_;  // by the bytes' hash
    std::map<std::string, std::string> inPage_;               // the bytes by key, while they are few
    std::size_t size_ = 0;
    bool isBeside_ = false;
};

}  // namespace raytracer
