#pragma once

/// Writing of numbers as little-endian bytes, the order that browsers read.

#include <cstddef>
#include <string>
#include <type_traits>

namespace thenar {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "bytes are written as they lie in memory");

/// Buffer of little-endian numbers.
class LittleEndianWriter {
 public:
  explicit LittleEndianWriter(std::size_t expected) { bytes_.reserve(expected); }

  /// Appends a value, converted to the given type: `writer.add<float>(x)`.
  template <typename Number, typename Value>
  void add(Value value) {
    static_assert(std::is_arithmetic_v<Number>);
    const auto number = static_cast<Number>(value);
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  void add_text(const std::string& text) { bytes_ += text; }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace thenar
