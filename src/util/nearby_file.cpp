#include "raytracer/util/nearby_file.h"

#include <algorithm>
#include <array>
#include <cerrno>

#include "raytracer/util/nearest_name.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

namespace fs = std::filesystem;

bool isFile(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

// The regular files in a folder and, down to `depth`, below it; those in the fewest subfolders first.
std::vector<fs::path> filesNear(const fs::path& folder, int depth) {
    constexpr std::size_t most = 1000;
    std::error_code ignored;
    std::vector<fs::path> files = filesIn(folder.empty() ? "." : folder, ignored, depth, most);
    std::erase_if(files, [](const fs::path& file) { return !isFile(file); });
    if (folder.empty())
        for (fs::path& file : files) file = file.lexically_relative(".");
    std::ranges::stable_sort(files, {},
                             [](const fs::path& file) { return std::distance(file.begin(), file.end()); });
    return files;
}

// The first of the files with this name, ignoring case; else the first with this name and any ending.
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

// The same text for all endings of one kind of file.
std::string kindOf(const std::string& ending) {
    for (const char* const picture : {".png", ".jpg", ".jpeg", ".pfm"})
        if (inLowerCase(ending) == picture) return "picture";
    return inLowerCase(ending);
}

// Whether a file may be meant by a name: it is of the same kind, or the name's ending is missing or
// misspelled.
bool isOfKind(const fs::path& file, const fs::path& name) {
    const std::string wanted = name.extension().string(), found = file.extension().string();
    NearestName nearest(wanted);
    nearest.consider(found);
    constexpr std::array<std::string_view, 4> known{"picture", ".json", ".obj", ".js"};
    const bool isKnown = std::ranges::find(known, kindOf(wanted)) != known.end();
    return wanted.empty() || kindOf(wanted) == kindOf(found) || (!isKnown && nearest.found());
}

// Names without an ending are those of programs. These are
// short and similar to each other, so they must be nearer.
NearestName nearestTo(const fs::path& name, const std::string& part) {
    return NearestName(part, (name.has_extension() ? 1 : 2) * NearestName::lettersAnError);
}

fs::path likeName(const fs::path& name, const std::vector<fs::path>& files) {
    std::vector<fs::path> alike = files;
    const fs::path stem = name.stem();
    const bool isLetter = stem.string().size() == 1;  // then another letter is another name
    std::erase_if(alike, [&](const fs::path& file) {
        return !isOfKind(file, name) || (isLetter && file.stem() != stem);
    });
    NearestName nearest = nearestTo(name, name.string());
    for (const fs::path& file : alike) nearest.consider(file.filename().string());
    if (nearest.found()) return named(nearest.name(), alike);
    return stem != name ? named(stem, alike) : fs::path();
}

// Of the files with this name's ending, the one whose stem is nearest to this name's.
fs::path likeStem(const fs::path& name, const std::vector<fs::path>& files) {
    NearestName nearest = nearestTo(name, name.stem().string());
    const auto isAlike = [&](const fs::path& file) { return file.extension() == name.extension(); };
    for (const fs::path& file : files)
        if (isAlike(file)) nearest.consider(file.stem().string());
    if (!nearest.found()) return {};
    return named(nearest.name() + name.extension().string(), files);
}

fs::path nearbyFolder(const fs::path& path) {
    const fs::path wanted = path.has_filename() ? path : path.parent_path(), above = wanted.parent_path();
    std::vector<std::string> names;
    std::error_code error;
    const auto add = [&](const fs::directory_entry& entry) {
        std::string name = entry.path().filename().string();
        if (entry.is_directory(error) && !name.starts_with('.')) names.push_back(std::move(name));
    };
    fs::directory_iterator entry(above.empty() ? "." : above, error), end;
    for (; !error && entry != end; entry.increment(error)) add(*entry);
    std::ranges::sort(names);
    NearestName nearest(wanted.filename().string());
    for (const std::string& name : names) nearest.consider(name);
    return nearest.found() ? above / nearest.name() : fs::path();
}

// The file with this name in the folder above the path's, which a command line may have meant. The names in a
// scene are not corrected this way: a scene's files lie below it.
std::string fileAbove(const std::string& path) {
    const fs::path wanted = replaced(path, "\\", "/"), folder = wanted.parent_path(),
                   above = folder.parent_path();
    const fs::path file = above / wanted.filename();
    return !folder.empty() && above != "/" && isFile(file) ? file.generic_string() : "";
}

// The last `count` names of a path. In libc++ a path's iterators only go forward.
fs::path lastNames(const fs::path& path, std::ptrdiff_t count) {
    fs::path last;
    auto left = std::distance(path.begin(), path.end());
    for (const fs::path& name : path)
        if (left-- <= count) last /= name;
    return last;
}

// The file in `folder`, or below it, that is meant by a path which was right elsewhere.
fs::path fileBelow(const fs::path& folder, const fs::path& written) {
    const auto count = std::distance(written.begin(), written.end());
    const bool isRooted = written.has_root_path();
    for (std::ptrdiff_t names = count - isRooted; names > 0; --names)
        if (fs::path file = folder / lastNames(written, names); isFile(file)) return file;
    if (isFile(written)) return written;  // from where the program runs
    std::error_code ignored;
    if (!isRooted || fs::is_directory(written.parent_path(), ignored))
        if (fs::path near = nearbyFile((folder / written).string()); !near.empty()) return near;
    for (std::ptrdiff_t names = std::min<std::ptrdiff_t>(2, count - isRooted); names > 0; --names)
        if (fs::path near = nearbyFile((folder / lastNames(written, names)).string()); !near.empty())
            return near;
    return {};
}

// The path of `file` relative to `folder`.
fs::path relativeTo(const fs::path& folder, const fs::path& file) {
    std::error_code error;
    const auto whole = [&](const fs::path& path) { return fs::absolute(path, error).lexically_normal(); };
    const fs::path relative = whole(file).lexically_relative(whole(folder / "."));
    return error || relative.empty() ? file : relative;
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
    std::error_code unknown;
    using enum fs::directory_options;
    fs::recursive_directory_iterator entry(folder, depth > 0 ? skip_permission_denied : none, error), end;
    for (std::size_t seen = 0; !error && entry != end && seen < most; entry.increment(error), ++seen) {
        const bool isHidden = entry->path().filename().string().starts_with('.');
        if (entry.depth() >= depth || isHidden) entry.disable_recursion_pending();
        if (!isHidden && !entry->is_directory(unknown)) files.push_back(entry->path());
    }
    std::ranges::sort(files);
    return files;
}

std::string nearbyFile(const std::string& path) {
    std::string slashes = replaced(path, "\\", "/");
    if (slashes != path && isFile(slashes)) return slashes;
    const fs::path wanted = slashes, folder = wanted.parent_path(), name = wanted.filename();
    if (name.empty() || folder == "/") return {};  // a whole machine is not searched
    std::error_code error;
    const bool hasFolder = folder.empty() || fs::is_directory(folder, error);
    const fs::path above = folder.parent_path();
    const std::vector<fs::path> here = filesNear(folder, 0);
    if (fs::path found = named(name, here); !found.empty()) return found.generic_string();
    const fs::path like = hasFolder ? fs::path() : nearbyFolder(folder);
    if (!like.empty())
        if (fs::path found = named(name, filesNear(like, 0)); !found.empty()) return found.generic_string();
    std::vector<fs::path> below;
    if (hasFolder || above != "/") below = filesNear(hasFolder ? folder : above, 2);
    for (const fs::path& found : {named(name, below), likeName(name, here), likeStem(name, below)})
        if (!found.empty()) return found.generic_string();
    return {};
}

std::string nearbyName(const std::string& folder, std::string_view written) {
    const std::string slashes = replaced(std::string(written), "\\", "/");
    const fs::path file = fileBelow(folder, slashes);
    if (file.empty()) return {};
    const std::string name = relativeTo(folder, file).generic_string();
    const bool isElsewhere = fs::path(slashes).is_absolute() && name.starts_with("..");
    return isElsewhere ? file.generic_string() : name;
}

std::string hintAt(const std::string& path) {
    std::string nearby = nearbyFile(path);
    if (nearby.empty()) nearby = fileAbove(path);
    return nearby.empty() ? "" : "; there is " + inQuotes(nearby);
}

Error folderError(const std::string& folder, std::error_code error) {
    const bool isMissing = error == std::errc::no_such_file_or_directory;
    const fs::path nearby = isMissing ? nearbyFolder(folder) : fs::path();
    const std::string hint = nearby.empty() ? "" : "; there is " + inQuotes(nearby.generic_string());
    const fs::path above = fs::path(folder).parent_path();
    const std::string instead =
        isFile(folder) ? "; name its folder " + inQuotes(above.empty() ? "." : above.generic_string()) : "";
    return {{folder}, "cannot read the folder: " + error.message() + hint + instead};
}

std::string missingFolder(const std::string& path) {
    const int before = errno;
    const fs::path folder = fs::path(path).parent_path();
    std::error_code error;
    const bool isMissing = before == ENOENT && !folder.empty() && !fs::exists(folder, error);
    errno = before;
    return isMissing ? "; there is no folder " + inQuotes(folder.generic_string()) : "";
}

std::string whereLooked(const std::string& path) {
    const int before = errno;
    if (before != ENOENT) return {};
    const std::string missing = missingFolder(path);
    std::string hint = hintAt(path);
    std::error_code error;
    const fs::path wanted = path, here = fs::current_path(error), above = wanted.parent_path();
    errno = before;
    if (!hint.empty() || error || wanted.is_absolute()) return hint;
    const fs::path folder = above.empty() ? here : (here / above).lexically_normal();
    return missing.empty() ? "; looked in " + printable(folder.string()) : missing;
}

}  // namespace raytracer
