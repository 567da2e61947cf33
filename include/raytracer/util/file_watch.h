// Waits until files change.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "raytracer/util/progress.h"

namespace raytracer {

// Remembers the state of files when they were added. A file may be missing then, and appear later.
class FileWatch {
  public:
    using Time = std::filesystem::file_time_type;

    // Does nothing if the file is watched already. `readSince` is when reading the file began: if the file
    // was written after that, it counts as changed.
    void add(const std::string& path, Time readSince = Time::max());

    // Returns once a file has changed since it was added, and then no file
    // has changed for 30 ms: a program that saves may write in several steps.
    // Looks ten times a second, since no portable call reports changes.
    void wait() const;

    // A file that has changed since it was added; empty if none has.
    std::string changedFile() const;
    bool hasChanged() const { return !changedFile().empty(); }

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

// Thrown to stop work on files that have changed meanwhile.
struct OutOfDate {};

// Passes progress on to another listener, and throws OutOfDate if a file has changed. `files` may be null.
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
