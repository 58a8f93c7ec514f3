#include "data/io/file_guard.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "base/error.h"
#include "base/file_io.h"

namespace thenar {
namespace {

constexpr std::size_t kMega = 1000 * 1000;  // Factor of a million, of bytes or of values [1]

// Sizes and counts keep the memory of a parser below 1 GB, depths keep its recursion below 1 MB of
// stack. The right column states what real files need.
constexpr std::array<FileLimit, 8> kLimits{{
    // kind, name, bytes, depth, values             largest real file known; memory at the limit
    {GuardedKind::kToml, "TOML", 8 * kMega, 32, 500'000},          // 50 kB, 5 deep; 500 B a value
    {GuardedKind::kJson, "JSON", 64 * kMega, 32, 2 * kMega},       // 5 MB, 8 deep; 100 B a value
    {GuardedKind::kXml, "XML", 16 * kMega, 128, 2 * kMega},        // 1 MB, 25 deep; 100 B a value
    {GuardedKind::kScene, "a scene", 64 * kMega, 128, 8 * kMega},  // 20 MB, 15 deep
    {GuardedKind::kMesh, "a mesh", 128 * kMega, 0, 0},             // 50 MB of a million triangles
    {GuardedKind::kResult, "HDF5", 256 * kMega, 0, 0},             // 10 MB
    {GuardedKind::kInference, "netCDF", 512 * kMega, 0, 0},  // 100 MB: 326 parameters, 16,000 draws
    {GuardedKind::kCollada, "Collada", 128 * kMega, 128, 2 * kMega},  // 50 MB, 15 deep
}};

/// Counts nesting and values along a text, and refuses the first place beyond a limit.
class Counter {
 public:
  Counter(std::string_view text, const std::string& path, const FileLimit& limit, int first_line)
      : text_(text), path_(path), limit_(limit), first_line_(first_line) {}

  void deeper(std::size_t at, int levels = 1) {
    depth_ += levels;
    if (depth_ > limit_.depth)
      refuse(at, fmt::format("wanted {} that nests at most {} deep, got more", limit_.name,
                             limit_.depth));
  }
  void higher(int levels = 1) { depth_ = std::max(0, depth_ - levels); }

  void value(std::size_t at) {
    if (++values_ > limit_.values)
      refuse(at,
             fmt::format("wanted {} of at most {} values, got more", limit_.name, limit_.values));
  }

 private:
  [[noreturn]] void refuse(std::size_t at, const std::string& what) const {
    const int line = first_line_ - 1 + line_of_offset(text_, static_cast<std::ptrdiff_t>(at));
    throw DataError(path_, line, what);
  }

  std::string_view text_;
  const std::string& path_;
  const FileLimit& limit_;
  int first_line_;
  int depth_ = 0;
  std::size_t values_ = 0;
};

/// Position of the next such text at or behind `at`, or the end of the text.
std::size_t find(std::string_view text, std::string_view wanted, std::size_t at) {
  return std::min(text.find(wanted, at), text.size());
}

/// Position of the closing quote of a quoted text that starts at `at`.
std::size_t end_of_quoted(std::string_view text, std::size_t at, std::string_view quote,
                          bool escapes, bool lines) {
  for (std::size_t i = at + quote.size(); i < text.size(); ++i) {
    if (escapes && text[i] == '\\')
      ++i;
    else if (!lines && text[i] == '\n')
      return i - 1;  // not closed: the parser will say so
    else if (text.compare(i, quote.size(), quote) == 0)
      return i + quote.size() - 1;
  }
  return text.size();
}

bool opens(char c) { return c == '[' || c == '{'; }
bool closes(char c) { return c == ']' || c == '}'; }

/// Counts brackets outside of texts and comments: JSON, VRML and Inventor.
void count_brackets(std::string_view text, Counter& counter, bool comments) {
  bool word = false;  // within a number or a name
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    // A value begins where a word does.
    const bool ends = closes(c) || std::string_view(" ,:\n\t\r").find(c) != std::string_view::npos;
    if (!ends && !word) counter.value(i);
    word = !ends && !opens(c) && c != '"';
    // Skip texts and comments, then count the nesting.
    if (c == '"') i = end_of_quoted(text, i, "\"", true, true);
    if (comments && c == '#') i = find(text, "\n", i), word = false;
    if (opens(c)) counter.deeper(i);
    if (closes(c)) counter.higher();
  }
}

/// Counts nesting of TOML: brackets, and the dots of keys and headers, each of which nests a table.
class TomlNesting {
 public:
  TomlNesting(std::string_view text, Counter& counter) : text_(text), counter_(counter) {}

  void count() {
    for (at_ = 0; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '#')
        at_ = find(text_, "\n", at_) - 1;
      else if (c == '"' || c == '\'')
        skip_quoted(c);
      else if (opens(c))
        open();
      else if (closes(c))
        close();
      else if (c == '.')
        dot();
      else if (c == ',' || c == '\n')
        end_of_value();
    }
  }

 private:
  void skip_quoted(char c) {
    // Three quotes begin a text of several lines.
    const std::string_view three = c == '"' ? R"(""")" : "'''";
    const bool lines = text_.compare(at_, 3, three) == 0;
    at_ = end_of_quoted(text_, at_, lines ? three : three.substr(0, 1), c == '"', lines);
    // Texts of several lines may end with two quotes of their own.
    for (int own = 0; lines && own < 2 && at_ + 1 < text_.size() && text_[at_ + 1] == c; ++own)
      ++at_;
  }

  void dot() {
    counter_.deeper(at_);
    counter_.value(at_);
    ++dots_;
  }

  void open() {
    // A header replaces the previous one, and holds for the lines below it.
    if (open_.empty() && begins_line()) {
      counter_.higher(header_);
      header_ = 0;
      in_header_ = true;
    }
    // The bracket nests one level deeper than its key.
    counter_.deeper(at_);
    counter_.value(at_);
    open_.push_back(dots_);  // of the key whose value opens here
    dots_ = 0;
  }

  void close() {
    if (open_.empty()) return;
    counter_.higher();
    // Dots of a header last until the next header, others end with their value.
    if (in_header_)
      header_ += dots_;
    else
      counter_.higher(dots_);
    dots_ = open_.back();
    open_.pop_back();
    if (open_.empty()) in_header_ = false;
  }

  void end_of_value() {
    counter_.value(at_);
    // A line may end within brackets, where it ends nothing.
    counter_.higher(dots_);
    dots_ = 0;
  }

  [[nodiscard]] bool begins_line() const {
    const std::size_t before =
        at_ == 0 ? std::string_view::npos : text_.find_last_not_of(" \t", at_ - 1);
    return before == std::string_view::npos || text_[before] == '\n';
  }

  std::string_view text_;
  Counter& counter_;
  std::size_t at_ = 0;
  std::vector<int> open_;  // dots of the keys around each open bracket
  int dots_ = 0;           // of the key or number at hand
  int header_ = 0;         // dots of the header in force
  bool in_header_ = false;
};

/// Position of the end of a tag that starts at `at`. Quoted values may contain such an end.
std::size_t end_of_tag(std::string_view text, std::size_t at, Counter& counter) {
  for (++at; at < text.size() && text[at] != '>'; ++at) {
    if (text[at] != '"' && text[at] != '\'') continue;
    counter.value(at);
    at = find(text, text.substr(at, 1), at + 1);
  }
  return at;
}

/// Counts tags outside of comments and character data. Declarations end at their first `>`, because
/// not all parsers heed quotes in them: this counts too much rather than too little.
void count_tags(std::string_view text, Counter& counter) {
  for (std::size_t i = find(text, "<", 0); i < text.size(); i = find(text, "<", i)) {
    const std::size_t begin = i;
    const auto starts = [&](std::string_view with) {
      return text.compare(begin, with.size(), with) == 0;
    };
    counter.value(begin);
    // Comments, data and declarations are skipped; start and end tags nest.
    if (starts("<!--")) {
      i = find(text, "-->", i + 4);
    } else if (starts("<![CDATA[")) {
      i = find(text, "]]>", i);
    } else if (starts("<?") || starts("<!")) {
      i = find(text, ">", i);
    } else if (starts("</")) {
      counter.higher();
      i = find(text, ">", i);
    } else {
      i = end_of_tag(text, i, counter);
      if (i < text.size() && text[i - 1] != '/') counter.deeper(begin);
    }
  }
}

}  // namespace

int line_of_offset(std::string_view text, std::ptrdiff_t offset) {
  const auto size = static_cast<std::ptrdiff_t>(text.size());
  const auto end = text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, size);
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

const FileLimit& limit_of(GuardedKind kind) { return kLimits.at(static_cast<std::size_t>(kind)); }

std::string read_guarded(const std::string& path, GuardedKind kind) {
  std::string text = read_file(path, limit_of(kind).bytes);
  guard_text(text, path, kind);
  return text;
}

void guard_text(std::string_view text, const std::string& path, GuardedKind kind, int first_line) {
  const FileLimit& limit = limit_of(kind);
  // First the size, then one pass by the grammar of the kind.
  if (text.size() > limit.bytes)
    throw DataError(
        path, first_line,
        fmt::format("wanted {} of at most {} bytes, got {}", limit.name, limit.bytes, text.size()));
  Counter counter(text, path, limit, first_line);
  if (kind == GuardedKind::kToml) TomlNesting(text, counter).count();
  if (kind == GuardedKind::kJson) count_brackets(text, counter, false);
  if (kind == GuardedKind::kScene) count_brackets(text, counter, true);
  if (kind == GuardedKind::kXml || kind == GuardedKind::kCollada) count_tags(text, counter);
}

bool is_in_folder_of(const std::string& path, const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code none;
  // Compare the real paths, with links resolved.
  const fs::path folder = fs::canonical(fs::absolute(path).parent_path(), none);
  if (none) return false;
  const fs::path real = fs::weakly_canonical(fs::absolute(file), none);
  if (none) return false;
  return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first ==
         folder.end();
}

}  // namespace thenar
