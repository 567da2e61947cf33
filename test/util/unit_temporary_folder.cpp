#include <catch2/catch.hpp>

#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "raytracer/util/temporary_folder.h"

using namespace raytracer;

namespace {

namespace fs = std::filesystem;

// Few descriptors, while it lives.
class FewDescriptors {
  public:
    FewDescriptors() {
        ::getrlimit(RLIMIT_NOFILE, &before_);
        const rlimit few{32, before_.rlim_max};
        ::setrlimit(RLIMIT_NOFILE, &few);
    }
    FewDescriptors(const FewDescriptors&) = delete;
    ~FewDescriptors() { ::setrlimit(RLIMIT_NOFILE, &before_); }

  private:
    rlimit before_{};
};

}  // namespace

TEST_CASE("temporary folder: it goes with all that is in it, deep, wide, locked") {
    constexpr int depth = 60, width = 3;
    std::optional<TemporaryFolder> folder(std::in_place);
    const fs::path path = fs::path(folder->file("")).parent_path();
    fs::path inner = path;
    for (int i = 0; i < depth; ++i) {
        for (int j = 0; j < width; ++j) {
            fs::create_directories(inner / std::to_string(i * width + j) / "a/b");
            std::ofstream(inner / ("file " + std::to_string(j))) << j;
        }
        std::ofstream(inner / std::to_string(depth * width - i)) << i;  // a name that a folder may get
        inner /= std::to_string(i * width);
    }
    fs::create_directory_symlink("..", inner / "link");
    for (const char* locked : {"0/3", "1", "2/a"}) fs::permissions(path / locked, fs::perms::none);
    const FewDescriptors few;
    folder.reset();
    CHECK_FALSE(fs::exists(path));
}

TEST_CASE("temporary folder: a link in its place goes, and what is behind that stays") {
    const TemporaryFolder other;
    std::ofstream(other.file("kept")) << 1;
    std::optional<TemporaryFolder> folder(std::in_place);
    const fs::path path = fs::path(folder->file("")).parent_path();
    fs::remove(path);
    fs::create_directory_symlink(other.file(""), path);
    folder.reset();
    CHECK_FALSE(fs::exists(fs::symlink_status(path)));
    CHECK(fs::exists(other.file("kept")));
}
