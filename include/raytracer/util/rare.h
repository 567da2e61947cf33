// An optional value that is mostly missing: a missing one takes only the memory of a pointer.
#pragma once

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace raytracer {

// Has the part of std::optional's interface that the program uses.
template <class T>
class Rare {
  public:
    Rare() = default;
    Rare(const T& value) : value_(std::make_unique<T>(value)) {}
    Rare(const Rare& other) : value_(other ? std::make_unique<T>(*other) : nullptr) {}
    Rare(Rare&&) noexcept = default;
    Rare& operator=(const Rare& other) { return *this = Rare(other); }
    Rare& operator=(Rare&&) noexcept = default;
    template <class U = T>
    requires(!std::same_as<std::remove_cvref_t<U>, Rare>) Rare& operator=(U&& value) {
        return *this = Rare(T(std::forward<U>(value)));
    }
    ~Rare() = default;

    explicit operator bool() const { return value_ != nullptr; }
    const T& operator*() const { return *value_; }
    T& operator*() { return *value_; }
    const T* operator->() const { return value_.get(); }
    T* operator->() { return value_.get(); }
    bool operator==(const T& value) const { return value_ && *value_ == value; }

  private:
    std::unique_ptr<T> value_;
};

}  // namespace raytracer
