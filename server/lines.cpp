#include "server/lines.h"

#include <utility>

namespace thenar {
namespace {

constexpr const char* kBlanks = " \t\r\n";

bool is_blank(const std::string& text) {
  return text.find_first_not_of(kBlanks) == std::string::npos;
}

}  // namespace

void LineSplitter::add(const char* bytes, std::size_t count) {
  // Remove the lines that were returned.
  if (begin_ > 0) {
    bytes_.erase(0, begin_);
    searched_ -= begin_;
    begin_ = 0;
  }
  bytes_.append(bytes, count);
}

std::optional<SplitLine> LineSplitter::next_line() {
  while (true) {
    // Without a newline, wait for more bytes, up to the limit.
    const std::size_t end = bytes_.find('\n', searched_);
    if (end == std::string::npos) {
      searched_ = bytes_.size();
      if (!dropping_ && searched_ - begin_ <= max_bytes_) return std::nullopt;
      // The line is too long: discard it, and report it once.
      bytes_ = std::string();
      begin_ = searched_ = 0;
      if (std::exchange(dropping_, true)) return std::nullopt;
      return SplitLine{"", true};
    }
    // Return the line unless it is blank.
    SplitLine line{"", end - begin_ > max_bytes_};
    if (!line.too_long) line.text = bytes_.substr(begin_, end - begin_);
    begin_ = searched_ = end + 1;
    if (std::exchange(dropping_, false)) continue;  // end of a line that was reported before
    if (line.too_long || !is_blank(line.text)) return line;
  }
}

std::optional<SplitLine> LineSplitter::take_rest() {
  SplitLine line{bytes_.substr(begin_), false};
  bytes_.clear();
  begin_ = searched_ = 0;
  if (std::exchange(dropping_, false) || is_blank(line.text)) return std::nullopt;
  return line;
}

StreamStart stream_start(std::string_view begin) {
  const std::size_t first = begin.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return StreamStart::kBlank;
  return begin[first] == '{' || begin[first] == '[' ? StreamStart::kRequest : StreamStart::kOther;
}

}  // namespace thenar
