#include "data/io/mesh/text_lines.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>

#include "base/error.h"

namespace thenar {
namespace {

// Characters between words
constexpr std::string_view kWhiteSpace = " \t\r\n\v\f";

}  // namespace

bool TextLines::next() {
  while (next_ < text_.size()) {
    const std::size_t begin = next_;
    line_ = next_line_;
    std::size_t end = begin;
    // A line that ends in a backslash continues in the next.
    for (bool goes_on = true; goes_on; ++next_line_) {
      end = std::min(text_.find('\n', end), text_.size());
      const std::size_t last = end - (end > begin && text_[end - 1] == '\r' ? 1 : 0);
      goes_on = end < text_.size() && last > begin && text_[last - 1] == '\\';
      if (goes_on) ++end;
    }
    next_ = std::min(end + 1, text_.size());
    // Comments are cut off; empty lines are skipped.
    rest_ = text_.substr(begin, end - begin);
    rest_ = rest_.substr(0, rest_.find('#'));
    if (rest_.find_first_not_of(kWhiteSpace) != std::string_view::npos) return true;
  }
  return false;
}

std::string_view TextLines::word() {
  const auto is_white = [](char c) {
    return kWhiteSpace.find(c) != std::string_view::npos || c == '\\';
  };
  std::size_t begin = 0;
  while (begin < rest_.size() && is_white(rest_[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest_.size() && kWhiteSpace.find(rest_[end]) == std::string_view::npos) ++end;
  const std::string_view word = rest_.substr(begin, end - begin);
  rest_.remove_prefix(end);
  return word;
}

double TextLines::number() {
  const std::string_view text = word();
  double value = 0;
  if (!parse_decimal(text, value))
    fail(fmt::format("wanted a finite number, got {}", in_quotes(text)));
  return value;
}

Eigen::Vector3d TextLines::vector3() {
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

int TextLines::whole(int lower, int upper) {
  const double value = number();
  if (value != std::floor(value) || value < lower || value > upper)
    fail(fmt::format("wanted a whole number in {}..{}, got {}", lower, upper, value));
  return static_cast<int>(value);
}

void TextLines::fail(const std::string& what) const {
  throw DataError(path_, std::max(line_, 1), what);
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongestWord = 40;  // Most bytes of a word in a message [bytes]
  const std::string cut(word.substr(0, kLongestWord));
  return fmt::format("'{}{}'", cut, word.size() > kLongestWord ? ".." : "");
}

bool parse_decimal(std::string_view word, double& value) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  // Out of range: strtod tells underflow to 0 from overflow to infinity.
  if (error == std::errc::result_out_of_range && stop == end)
    value = std::strtod(std::string(word).c_str(), nullptr);
  else if (error != std::errc())
    return false;
  return stop == end && std::isfinite(value);
}

}  // namespace thenar
