#include "data/io/mesh/triangle_soup.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>

#include "base/error.h"
#include "base/words.h"
#include "data/io/mesh/text_lines.h"

namespace thenar {
namespace {

// Sizes of the header with its count, of a facet, and of the normal at its start [bytes]
constexpr std::size_t kStlHeadSize = 84, kFacetSize = 50, kNormalSize = 12;

template <typename T>
T number_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));  // little-endian, as every target of ours
  return value;
}

/// Returns whether the number of bytes after the header is what it states, or at least that.
bool holds_bytes(const std::string& text, bool exactly) {
  if (text.size() < kStlHeadSize) return false;
  const std::size_t size =
      kStlHeadSize + kFacetSize * std::size_t{number_at<std::uint32_t>(text, 80)};
  return exactly ? size == text.size() : size <= text.size();
}

void require_few(std::size_t triangles, const std::string& path) {
  if (triangles > kMaxTriangles)
    throw DataError(path, 1,
                    fmt::format("wanted at most {} triangles, got {}", kMaxTriangles, triangles));
}

TriangleSoup from_bytes(const std::string& text, const std::string& path) {
  TriangleSoup soup;
  const std::size_t count = number_at<std::uint32_t>(text, 80);
  require_few(count, path);
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      // Corners follow a normal, which is ignored.
      const std::size_t at = kStlHeadSize + kFacetSize * t + kNormalSize + 12 * k;
      soup.corners.emplace_back(number_at<float>(text, at), number_at<float>(text, at + 4),
                                number_at<float>(text, at + 8));
    }
  return soup;
}

/// Words of a text in lower case, with their lines.
class Words {
 public:
  Words(const std::string& text, const std::string& path) : text_(text), path_(path) {}

  /// The next word; empty at the end.
  std::string next() {
    for (; at_ < text_.size() && is_space(text_[at_]); ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return lower_case(text_.substr(begin, at_ - begin));
  }

  /// Skips the name of a solid, which is any words: the rest of the line, or, if everything is on
  /// one line, the part before the first facet.
  void skip_name() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    for (; at_ < end; ++at_) {
      // White space, "facet", white space, "normal".
      const std::size_t facet = skip_white(at_), normal = skip_white(facet + 5);
      if (facet > at_ && normal > facet + 5 && normal < end && is_word(facet, "facet") &&
          is_word(normal, "normal"))
        return;
      // Otherwise go on behind this white space.
      if (facet > at_) at_ = facet - 1;
    }
    at_ = end;
  }

  double number() {
    const std::string word = next();
    double value = 0;
    if (!parse_decimal(word, value))
      fail(fmt::format("wanted three numbers after 'vertex', got {}", in_quotes(word)));
    return value;
  }

  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_, line_, what); }

 private:
  static bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

  [[nodiscard]] std::size_t skip_white(std::size_t at) const {
    while (at < text_.size() && is_space(text_[at])) ++at;
    return at;
  }

  /// Returns whether `word` is there, in any case.
  [[nodiscard]] bool is_word(std::size_t at, const std::string& word) const {
    return at < text_.size() && lower_case(text_.substr(at, word.size())) == word;
  }

  const std::string& text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 1;
};

TriangleSoup from_text(const std::string& text, const std::string& path) {
  Words words(text, path);
  if (words.next() != "solid") words.fail("this is not STL, neither in bytes nor as text");
  words.skip_name();
  TriangleSoup soup;
  bool open = true;
  // Solids open and close; facets have three corners.
  for (std::string word; !(word = words.next()).empty();) {
    const bool heading = word == "solid" || word == "endsolid";
    if (heading) open = word == "solid";
    if (heading) words.skip_name();
    if ((word == "endfacet" || word == "endsolid") && soup.corners.size() % 3 != 0)
      words.fail("a facet has other than three corners");
    if (word != "vertex") continue;
    const double x = words.number(), y = words.number(), z = words.number();
    soup.corners.emplace_back(x, y, z);
    require_few(soup.corners.size() / 3, path);
  }
  if (open || soup.corners.size() % 3 != 0)
    words.fail("the file is cut off: 'endsolid' is missing");
  return soup;
}

/// Returns whether the file is a text. Headers of binary files may begin with "solid", too.
bool is_text(const std::string& text) {
  if (text.find('\0') != std::string::npos) return false;
  const std::string head = lower_case(text.substr(0, 200));
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  return first != std::string::npos && head.compare(first, 5, "solid") == 0;
}

}  // namespace

TriangleSoup parse_stl(const std::string& text, const std::string& path) {
  // Binary if the size fits, then text, then binary with more bytes behind.
  if (holds_bytes(text, true)) return from_bytes(text, path);
  if (!is_text(text) && holds_bytes(text, false)) return from_bytes(text, path);
  if (!is_text(text) && text.size() >= kStlHeadSize)
    throw DataError(
        path, 1,
        fmt::format("wanted {} triangles of {} bytes after the heading, got {} bytes",
                    number_at<std::uint32_t>(text, 80), kFacetSize, text.size() - kStlHeadSize));
  return from_text(text, path);
}

}  // namespace thenar
