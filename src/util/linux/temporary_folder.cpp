#include "raytracer/util/temporary_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include "../descriptor.h"
#include "../leftover.h"
#include "../posix/signals.h"
#include "raytracer/util/error.h"
#include "raytracer/util/nearby_file.h"

namespace raytracer {

TemporaryFolder::TemporaryFolder() {
    const char* const wanted = ::getenv("TMPDIR");
    const std::string parent = wanted && *wanted ? wanted : "/tmp";
    path_ = absolutePath(parent) + "/raytracer-XXXXXX";  // mkdtemp's placeholder
    const SignalsWait wait;
    if (!::mkdtemp(path_.data())) throw systemError(parent, "cannot make a temporary folder");
    leftover_ = std::make_unique<Leftover>(removeFolder, path_.c_str());
}

TemporaryFolder::~TemporaryFolder() { leftover_->clear(); }

void TemporaryFolder::requireRoom(std::size_t bytes) const {
    const std::string probe = file("room");
    const Descriptor descriptor(::open(probe.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    if (descriptor) errno = ::posix_fallocate(descriptor.get(), 0, static_cast<off_t>(bytes));
    const bool hasRoom = descriptor && errno == 0;
    if (!hasRoom) throw systemError(path_, "no room for a picture");
    ::unlink(probe.c_str());
}

}  // namespace raytracer
