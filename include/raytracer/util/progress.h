// Who is told of progress.
#pragma once

namespace raytracer {

// Called from time to time, by one thread at a time, with the part of the work that is done, from 0 to 1.
class ProgressListener {
  public:
    virtual ~ProgressListener() = default;
    virtual void progress(double fraction) = 0;
};

}  // namespace raytracer
