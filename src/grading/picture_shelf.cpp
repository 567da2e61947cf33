#include "raytracer/grading/picture_shelf.h"

#include <filesystem>
#include <functional>

#include "raytracer/json/json_writer.h"
#include "raytracer/util/error.h"
#include "raytracer/util/html.h"
#include "raytracer/util/output_file.h"

namespace raytracer {

PictureShelf::PictureShelf(const std::string& page) {
    const std::filesystem::path path(page);
    link_ = path.stem().string() + "_pictures";
    folder_ = (path.parent_path() / link_).string();
}

std::string PictureShelf::add(const std::string& png) {
    if (png.empty()) return {};
    const std::size_t hash = std::hash<std::string>()(png);
    const std::lock_guard lock(mutex_);
    const auto [known, isNew] = keys_.emplace(std::to_string(hash) + "." + std::to_string(png.size()),
                                              "p" + std::to_string(keys_.size()));
    std::string key = known->second;
    if (!isNew) return key;
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

void PictureShelf::write(const std::string& key, const std::string& png) {
    OutputFile(folder_ + "/" + key + ".png").write(png);
}

std::string PictureShelf::addresses() const {
    JsonWriter json;
    json.beginObject();
    for (const auto& [content, key] : keys_) {
        const auto here = inPage_.find(key);
        json.key(key).value(here == inPage_.end() ? link_ + "/" + key + ".png" : pngUri(here->second));
    }
    json.endObject();
    return json.text();
}

}  // namespace raytracer
