#include "data/io/mesh/stl_mesh.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <regex>

#include "base/error.h"

namespace thenar {
namespace {

constexpr std::size_t kHead = 84, kFacet = 50, kNormal = 12;  // [bytes]

template <typename T>
T number_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));  // little-endian, as every target of ours
  return value;
}

/// Whether the bytes after the heading are as many as it says, or more.
bool holds_bytes(const std::string& text, bool exactly) {
  if (text.size() < kHead) return false;
  const std::size_t size = kHead + kFacet * std::size_t{number_at<std::uint32_t>(text, 80)};
  return exactly ? size == text.size() : size <= text.size();
}

TriangleSoup from_bytes(const std::string& text) {
  TriangleSoup soup;
  const std::size_t count = number_at<std::uint32_t>(text, 80);
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = kHead + kFacet * t + kNormal + 12 * k;
      soup.corners.emplace_back(number_at<float>(text, at), number_at<float>(text, at + 4),
                                number_at<float>(text, at + 8));
    }
  return soup;
}

/// The words of a text in lower case, and their lines.
class Words {
 public:
  Words(const std::string& text, const std::string& path) : text_(text), path_(path) {}

  /// Empty at the end.
  std::string next() {
    const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    for (; at_ < text_.size() && is_space(text_[at_]); ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
    std::string word;
    for (; at_ < text_.size() && !is_space(text_[at_]); ++at_)
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(text_[at_])));
    return word;
  }

  /// The name of a solid, of any words: the rest of the line, or, where all is on one, what stands
  /// before the first facet.
  void skip_name() {
    static const std::regex facet(R"(\sfacet\s+normal\s)", std::regex::icase);
    const auto begin = text_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto end = std::find(begin, text_.end(), '\n');
    std::smatch found;
    at_ += static_cast<std::size_t>(std::regex_search(begin, end, found, facet) ? found.position(0)
                                                                                : end - begin);
  }

  double number() {
    const std::string word = next();
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(value))
      fail(fmt::format("wanted three numbers after 'vertex', got '{}'", word));
    return value;
  }

  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_, line_, what); }

 private:
  const std::string& text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 1;
};

TriangleSoup from_text(const std::string& text, const std::string& path) {
  Words words(text, path);
  if (words.next() != "solid") words.fail("this is no STL, neither in bytes nor as text");
  words.skip_name();
  TriangleSoup soup;
  bool open = true;
  for (std::string word; !(word = words.next()).empty();) {
    const bool heading = word == "solid" || word == "endsolid";
    if (heading) open = word == "solid";
    if (heading) words.skip_name();
    if ((word == "endfacet" || word == "endsolid") && soup.corners.size() % 3 != 0)
      words.fail("a facet has other than three corners");
    if (word != "vertex") continue;
    const double x = words.number(), y = words.number(), z = words.number();
    soup.corners.emplace_back(x, y, z);
  }
  if (open || soup.corners.size() % 3 != 0)
    words.fail("the file is cut off: 'endsolid' is missing");
  return soup;
}

/// Headings before bytes may begin with "solid", too.
bool is_text(const std::string& text) {
  if (text.find('\0') != std::string::npos) return false;
  std::string head = text.substr(0, 200);
  std::transform(head.begin(), head.end(), head.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  return first != std::string::npos && head.compare(first, 5, "solid") == 0;
}

}  // namespace

TriangleSoup parse_stl(const std::string& text, const std::string& path) {
  if (holds_bytes(text, true)) return from_bytes(text);
  if (!is_text(text) && holds_bytes(text, false)) return from_bytes(text);
  if (!is_text(text) && text.size() >= kHead)
    throw DataError(path, 1,
                    fmt::format("wanted {} triangles of {} bytes after the heading, got {} bytes",
                                number_at<std::uint32_t>(text, 80), kFacet, text.size() - kHead));
  return from_text(text, path);
}

}  // namespace thenar
