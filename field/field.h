#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace cydonia {

// The most samples or pixels along a side of anything that is read or made.
inline constexpr int kLargestSide = 16384;

// A 2D grid of samples at cell centres: row 0 is the north edge, x grows east, rows are
// contiguous.
template <class T>
class Field {
  public:
    using value_type = T;

    Field() = default;
    Field(int width, int height, T fill = T{})
        : width_(width),
          height_(height),
          values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                  fill) {
        assert(width >= 0 && height >= 0);
    }

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t size() const { return values_.size(); }
    bool empty() const { return values_.empty(); }
    bool contains(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_ && y < height_;
    }
    template <class U>
    bool same_shape(const Field<U>& other) const {
        return width_ == other.width() && height_ == other.height();
    }

    T& operator()(int x, int y) { return values_[index(x, y)]; }
    const T& operator()(int x, int y) const { return values_[index(x, y)]; }
    T& operator[](std::size_t i) { return values_[i]; }
    const T& operator[](std::size_t i) const { return values_[i]; }

    std::size_t index(int x, int y) const {
        assert(contains(x, y));
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    std::span<T> row(int y) {
        return {data() + index(0, y), static_cast<std::size_t>(width_)};
    }
    std::span<const T> row(int y) const {
        return {data() + index(0, y), static_cast<std::size_t>(width_)};
    }

    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    auto begin() { return values_.begin(); }
    auto end() { return values_.end(); }
    auto begin() const { return values_.begin(); }
    auto end() const { return values_.end(); }

    bool operator==(const Field&) const = default;

  private:
    int width_ = 0;
    int height_ = 0;
    std::vector<T> values_;
};

}  // namespace cydonia
