// Files are read whole: what becomes of them afterwards is another matter.
#include <filesystem>

#include <catch2/catch.hpp>

#include "../support/test_folder.h"
#include "raytracer/util/file_bytes.h"

using raytracer::FileBytes;

TEST_CASE("a file that is read may be cut short, or removed") {
    const TestFolder folder;
    for (const std::size_t size : {0, 1, 65535, 65536, 3000000}) {
        const std::string path = folder.write("a", std::string(size, 'a'));
        const FileBytes file(path);
        std::filesystem::resize_file(path, 0);
        std::filesystem::remove(path);
        CHECK(file.text().size() == size);
        CHECK(file.text().find_first_not_of('a') == std::string_view::npos);
    }
}
