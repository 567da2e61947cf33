#include "raytracer/util/nearby_file.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "raytracer/util/error.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

namespace fs = std::filesystem;

bool isFile(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

std::vector<fs::path> filesNear(const fs::path& folder, int depth) {
    constexpr std::size_t most = 1000;
    std::error_code ignored;
    std::vector<fs::path> files = filesIn(folder.empty() ? "." : folder, ignored, depth, most);
    if (folder.empty())
        for (fs::path& file : files) file = file.lexically_relative(".");
    return files;
}

// Of the files, the first with this name, in small or large letters, or with this name and some ending.
fs::path named(const fs::path& name, const std::vector<fs::path>& files) {
    const auto same = [](const std::string& a, const std::string& b) {
        return a.size() == b.size() && endsIn(a, b);
    };
    for (const fs::path& file : files)
        if (same(file.filename().string(), name.string())) return file;
    for (const fs::path& file : files)
        if (same(file.stem().string(), name.string())) return file;
    return {};
}

fs::path likeName(const fs::path& name, const std::vector<fs::path>& files) {
    NearestName nearest(name.string());
    for (const fs::path& file : files) nearest.consider(file.filename().string());
    if (nearest.found()) return named(nearest.name(), files);
    const std::string stem = name.stem().string();
    const bool hasStem = stem != name.string();
    return hasStem ? named(stem, files) : fs::path();
}

}  // namespace

std::string absolutePath(const std::string& path) {
    std::error_code error;
    const fs::path whole = fs::absolute(path, error);
    if (error) throw Error({path}, "cannot find the current folder: " + error.message());
    return whole.string();
}

std::vector<fs::path> filesIn(const fs::path& folder, std::error_code& error, int depth, std::size_t most) {
    std::vector<fs::path> files;
    using enum fs::directory_options;
    fs::recursive_directory_iterator entry(folder, depth > 0 ? skip_permission_denied : none, error), end;
    for (std::size_t seen = 0; !error && entry != end && seen < most; entry.increment(error), ++seen) {
        const bool isHidden = entry->path().filename().string().starts_with('.');
        if (entry.depth() >= depth || isHidden) entry.disable_recursion_pending();
        if (!isHidden && isFile(entry->path())) files.push_back(entry->path());
    }
    std::ranges::sort(files);
    return files;
}

std::string nearbyFile(const std::string& path) {
    std::string slashes = path;
    std::ranges::replace(slashes, '\\', '/');
    if (slashes != path && isFile(slashes)) return slashes;
    const fs::path wanted = slashes, folder = wanted.parent_path(), name = wanted.filename();
    if (name.empty() || folder == "/") return {};  // a whole machine is not searched
    std::error_code error;
    const bool hasFolder = folder.empty() || fs::is_directory(folder, error);
    const fs::path above = folder.parent_path();
    const std::vector<fs::path> here = filesNear(folder, 0);
    if (fs::path found = named(name, here); !found.empty()) return found.generic_string();
    if (fs::path found = likeName(name, here); !found.empty()) return found.generic_string();
    const bool isSearched = hasFolder || above != "/";
    if (!isSearched) return {};
    return named(name, filesNear(hasFolder ? folder : above, 2)).generic_string();
}

std::string hintAt(const std::string& path) {
    const int before = errno;
    const std::string nearby = nearbyFile(path);
    errno = before;
    return nearby.empty() ? "" : "; there is " + inQuotes(nearby);
}

}  // namespace raytracer
