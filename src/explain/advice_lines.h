// Collects lines of advice: as many as fit a terminal, and the number of the others.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace raytracer {

class AdviceLines {
  public:
    void add(const std::string& line) {
        constexpr std::size_t most = 20;  // fit on a terminal
        if (lines_.size() < most) lines_.push_back(line);
        else ++notShown_;
    }

    std::vector<std::string> take() {
        if (notShown_ > 0) lines_.push_back("and " + std::to_string(notShown_) + " more");
        return std::move(lines_);
    }

  private:
    std::vector<std::string> lines_;
    std::size_t notShown_ = 0;
};

}  // namespace raytracer
