// Waits until files change.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "raytracer/util/progress.h"

namespace raytracer {

// Files by name, as they were when they were added. One that is not there may come to be.
class FileWatch {
  public:
    using Time = std::filesystem::file_time_type;

    // Does nothing where it is watched already. With `readSince`, the file has been read since then: where it
    // has changed since too, it counts as changed.
    void add(const std::string& path, Time readSince = Time::max());

    // Returns once a file is another than when it was added, and no file has changed for a moment: a program
    // that saves may write in several steps. Looks ten times a second, for no portable call tells of a
    // change.
    void wait() const;

    // Whether a file is another than when it was added.
    bool hasChanged() const { return states() != files_; }

    std::size_t count() const { return files_.size(); }

  private:
    struct State {
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;
        bool operator==(const State&) const = default;
    };
    static State stateOf(const std::string& path);
    std::map<std::string, State> states() const;

    std::map<std::string, State> files_;
};

// What is made of files that have changed.
struct OutOfDate {};

// Tells another listener of the progress, and throws OutOfDate where a file has changed. `files` may be null.
class WatchedProgress final : public ProgressListener {
  public:
    WatchedProgress(ProgressListener& listener, const FileWatch* files)
        : listener_(listener), files_(files) {}
    void progress(double fraction) override;

  private:
    ProgressListener& listener_;
    const FileWatch* files_;
};

}  // namespace raytracer
