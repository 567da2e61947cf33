// A folder of a test's own, gone with it.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "raytracer/util/temporary_folder.h"

class TestFolder : public raytracer::TemporaryFolder {
  public:
    std::string write(const std::string& name, std::string_view bytes) const {
        std::ofstream(file(name), std::ios::binary) << bytes;
        return file(name);
    }

    std::size_t fileCount() const {
        const std::filesystem::directory_iterator begin(file("")), end;
        return static_cast<std::size_t>(std::distance(begin, end));
    }
};

inline std::string bytesOf(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}
