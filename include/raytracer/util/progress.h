// The interface through which work reports its progress.
#pragma once

namespace raytracer {

// progress() is called from time to time, by one thread at a time, with the fraction of the work that is
// done, from 0 to 1.
class ProgressListener {
  public:
    virtual ~ProgressListener() = default;
    virtual void progress(double fraction) = 0;
};

}  // namespace raytracer
