#include "raytracer/util/file_watch.h"

#include <system_error>
#include <thread>
#include <utility>

namespace raytracer {

FileWatch::State FileWatch::stateOf(const std::string& path) {
    std::error_code missing;
    State state;
    state.time = std::filesystem::last_write_time(path, missing);
    if (missing) return {};
    state.size = std::filesystem::file_size(path, missing);
    return state;
}

void FileWatch::add(const std::string& path, Time readSince) {
    if (files_.contains(path)) return;
    const State now = stateOf(path);
    files_[path] = now.time < readSince ? now : State();
}

std::map<std::string, FileWatch::State> FileWatch::states() const {
    std::map<std::string, State> now;
    for (const auto& [path, state] : files_) now[path] = stateOf(path);
    return now;
}

std::string FileWatch::changedFile() const {
    for (const auto& [path, state] : files_)
        if (stateOf(path) != state) return path;
    return {};
}

void FileWatch::wait() const {
    constexpr std::chrono::milliseconds between{100}, moment{30};
    std::map<std::string, State> now = states();
    for (; now == files_; now = states()) std::this_thread::sleep_for(between);
    for (auto before = files_; before != now; now = states()) {
        before = std::exchange(now, {});
        std::this_thread::sleep_for(moment);
    }
}

void WatchedProgress::progress(double fraction) {
    listener_.progress(fraction);
    if (files_ && files_->hasChanged()) throw OutOfDate();
}

}  // namespace raytracer
