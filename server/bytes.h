#pragma once

/// Numbers as little-endian bytes, as browsers read them.

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace thenar {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "bytes are written as they lie in memory");

/// Bytes that grow number by number.
class LittleEndian {
 public:
  explicit LittleEndian(std::size_t expected) { bytes_.reserve(expected); }

  /// Appends a number in the type that is named: `writer.add<float>(x)`, [m] or whatever x is in.
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
