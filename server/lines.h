#pragma once

/// Splitting of a byte stream into lines, one message each.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace thenar {

/// Line without its newline; empty if it was too long.
struct SplitLine {
  std::string text;
  bool too_long = false;
};

/// Splits bytes into lines. Memory is bounded by the largest length of a line.
class LineSplitter {
 public:
  /// @param max_bytes  largest length of a line [bytes]
  explicit LineSplitter(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  void add(const char* bytes, std::size_t count);
  /// Returns the next complete line that is not blank; nothing if more bytes are needed. A line
  /// that is too long is reported as soon as it exceeds the limit, and its remainder is discarded.
  [[nodiscard]] std::optional<SplitLine> next_line();
  /// Returns the number of bytes that were added but not returned [bytes].
  [[nodiscard]] std::size_t pending_bytes() const { return bytes_.size() - begin_; }
  /// Returns the bytes after the last newline: the last line of a stream that has ended.
  [[nodiscard]] std::optional<SplitLine> take_rest();

 private:
  std::size_t max_bytes_;
  std::string bytes_;
  std::size_t begin_ = 0;     // start of the next line in bytes_
  std::size_t searched_ = 0;  // position in bytes_ before which the next line has no newline
  bool dropping_ = false;     // true: the remainder of a long line is being discarded
};

/// Kind of the first characters of a stream: white space, a JSON-RPC request ('{' or '['), or
/// another protocol such as HTTP or TLS.
enum class StreamStart { kBlank, kRequest, kOther };
/// Classifies the first characters of a stream.
[[nodiscard]] StreamStart stream_start(std::string_view begin);

}  // namespace thenar
