#pragma once

/// Messages that stand on a line each, in bytes that come in pieces.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace thenar {

/// A line without its end; of one that is too long nothing is kept.
struct SplitLine {
  std::string text;
  bool too_long = false;
};

/// Cuts bytes into lines. Memory is bounded by the longest line that is let through.
class LineSplitter {
 public:
  /// @param most  bytes of a line
  explicit LineSplitter(std::size_t most) : most_(most) {}

  void add(const char* bytes, std::size_t count);
  /// The next whole line that is not blank; nothing if more bytes are needed. A line that is too
  /// long is told as soon as that shows, and what follows up to its end is dropped.
  [[nodiscard]] std::optional<SplitLine> next();
  /// Bytes of lines that were not given out yet.
  [[nodiscard]] std::size_t held() const { return bytes_.size() - begin_; }
  /// Returns the bytes behind the last end of a line: the last line of a stream that has ended.
  [[nodiscard]] std::optional<SplitLine> rest();

 private:
  std::size_t most_;
  std::string bytes_;
  std::size_t begin_ = 0, looked_ = 0;  // of the next line; how far no end was found
  bool dropping_ = false;
};

/// Beginning of a stream: white space so far, a request of JSON-RPC ('{' or '['), or anything else:
/// a browser that was sent here by a page of somebody else, TLS, mail.
enum class StreamStart { kBlank, kRequest, kOther };
[[nodiscard]] StreamStart stream_start(std::string_view begin);

}  // namespace thenar
