// A new empty folder that is deleted with its owner.
#pragma once

#include <filesystem>
#include <string>

namespace raytracer {

class TemporaryFolder {
  public:
    TemporaryFolder();  // throws Error
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string file(const std::string& name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_;
};

}  // namespace raytracer
