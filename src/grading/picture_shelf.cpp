#include "raytracer/grading/picture_shelf.h"

#include <filesystem>
#include <functional>

#include "raytracer/json/json_writer.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/html.h"
#include "raytracer/util/output_file.h"

namespace raytracer {

namespace {

std::string keyOf(std::size_t number) { return "p" + std::to_string(number); }

}  // namespace

PictureShelf::PictureShelf(const std::string& page) {
    const std::filesystem::path path(page);
    link_ = path.stem().string() + "_pictures";
    folder_ = (path.parent_path() / link_).string();
}

std::string PictureShelf::add(const std::string& png) {
    if (png.empty()) return {};
    const std::size_t hash = std::hash<std::string>()(png);
    const std::lock_guard lock(mutex_);
    const auto [first, last] = keys_.equal_range(hash);
    for (auto known = first; known != last; ++known)
        if (has(known->second, png)) return known->second;
    std::string key = keyOf(keys_.size());
    keys_.emplace(hash, key);
    size_ += png.size();
    if (isBeside_) {
        write(key, png);
        return key;
    }
    inPage_[key] = png;
    if (size_ <= mostInPage) return key;
    isBeside_ = true;
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw Error({folder_}, "cannot make the folder of the page's pictures: " + error.message());
    for (const auto& [one, bytes] : inPage_) write(one, bytes);
    inPage_.clear();
    return key;
}

std::string PictureShelf::file(const std::string& key) const { return folder_ + "/" + key + ".png"; }

bool PictureShelf::has(const std::string& key, const std::string& png) const {
    const auto here = inPage_.find(key);
    return here == inPage_.end() ? FileBytes(file(key)).text() == png : here->second == png;
}

void PictureShelf::write(const std::string& key, const std::string& png) const {
    OutputFile(file(key)).write(png);
}

std::string PictureShelf::addresses() const {
    JsonWriter json;
    json.beginObject();
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const std::string key = keyOf(i);
        const auto here = inPage_.find(key);
        json.key(key).value(here == inPage_.end() ? link_ + "/" + key + ".png" : pngUri(here->second));
    }
    json.endObject();
    return json.text();
}

}  // namespace raytracer
