#pragma once

/// Rows of plain numbers that sources for different processors may share.

#include <utility>
#include <vector>

namespace thenar::kernel {

/// A vector that never changes. Reading it is always inlined: were it a function, the linker might
/// pick the copy that was compiled for a processor other than this one.
template <typename T>
class Array {
 public:
  explicit Array(std::vector<T> rows = {})
      : rows_(std::move(rows)), first_(rows_.data()), size_(static_cast<int>(rows_.size())) {}
  Array(const Array&) = delete;
  Array& operator=(const Array&) = delete;
  Array& operator=(std::vector<T> rows) {
    rows_ = std::move(rows);
    first_ = rows_.data();
    size_ = static_cast<int>(rows_.size());
    return *this;
  }
  ~Array() = default;

  [[nodiscard]] __attribute__((always_inline)) const T* begin() const { return first_; }
  [[nodiscard]] __attribute__((always_inline)) const T* end() const { return first_ + size_; }
  [[nodiscard]] __attribute__((always_inline)) const T& operator[](int i) const {
    return first_[i];
  }
  [[nodiscard]] __attribute__((always_inline)) int size() const { return size_; }

 private:
  std::vector<T> rows_;
  const T* first_;
  int size_;
};

}  // namespace thenar::kernel
