// How long work tells of its progress.
#pragma once

namespace raytracer {

// Told from time to time how much of the work is done, from one thread at a time.
class ProgressListener {
  public:
    virtual ~ProgressListener() = default;
    virtual void progress(double fraction) = 0;
};

}  // namespace raytracer
