// An optional value that hardly anyone has: where there is none, it takes the room of a pointer.
#pragma once

#include <memory>
#include <utility>

namespace raytracer {

// Of std::optional's interface, what is asked of it.
template <class T>
class Rare {
  public:
    Rare() = default;
    Rare(const T& value) : value_(std::make_unique<T>(value)) {}
    Rare(const Rare& other) : value_(other ? std::make_unique<T>(*other) : nullptr) {}
    Rare(Rare&&) noexcept = default;
    Rare& operator=(Rare other) noexcept { return value_ = std::move(other.value_), *this; }
    ~Rare() = default;

    explicit operator bool() const { return value_ != nullptr; }
    const T& operator*() const { return *value_; }
    T& operator*() { return *value_; }
    const T* operator->() const { return value_.get(); }
    T* operator->() { return value_.get(); }

  private:
    std::unique_ptr<T> value_;
};

}  // namespace raytracer
