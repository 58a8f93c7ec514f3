#include "data/io/layout_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"

namespace thenar::internal {
namespace {

std::string shape_words(const std::vector<std::size_t>& shape, bool texts) {
  const char* what = texts ? "text" : "number";
  if (shape.empty()) return fmt::format("one {}", what);
  return fmt::format("{} {}s", fmt::join(shape, " x "), what);
}

bool is_fixed_length(const std::string& word) {
  return word.find_first_not_of("0123456789") == std::string::npos;
}

/// Names of lengths as a message has them: " (instant x joint)"; nothing where all are numbers.
std::string length_names(const std::vector<std::string>& shape) {
  if (std::all_of(shape.begin(), shape.end(), is_fixed_length)) return "";
  std::string names = fmt::format(" ({})", fmt::join(shape, " x "));
  names.erase(std::remove(names.begin(), names.end(), '+'), names.end());
  return names;
}

/// Checks one file.
class LayoutCheck {
 public:
  LayoutCheck(const FoundEntries& found, const Layout& layout, const std::string& path)
      : found_(found), layout_(layout), path_(path) {}

  void check() {
    // Entries of no scope first: their lengths are the file's.
    std::set<std::string> scopes;
    for (const LayoutRow& row : layout_)
      if (has_star(row))
        scopes.insert(scope_of(row));
      else
        check_row(row, row.key, of_file_);
    // Then scope by scope, each group with lengths of its own.
    for (const std::string& scope : scopes) check_scope(scope);
  }

 private:
  using Lengths = std::map<std::string, std::size_t>;

  [[noreturn]] void fail(const std::string& key, const std::string& complaint) const {
    throw DataError(path_, 1, fmt::format("'{}': {}", key, complaint));
  }

  static std::string scope_of(const LayoutRow& row) { return row.key.substr(0, row.key.find('*')); }

  static bool has_star(const LayoutRow& row) { return row.key.find('*') != std::string::npos; }

  /// Returns true for a row of entries, not of groups, below a scope.
  static bool is_entry_in(const LayoutRow& row, const std::string& scope) {
    return has_star(row) && scope_of(row) == scope && row.holds != Holds::kGroups;
  }

  /// Returns the text at '*' in a key; nothing if the key is not of this row.
  static std::optional<std::string> name_in(const std::string& key, const LayoutRow& row) {
    const std::size_t star = row.key.find('*');
    const std::string scope = row.key.substr(0, star), rest = row.key.substr(star + 1);
    if (key.size() <= scope.size() + rest.size() || key.compare(0, star, scope) != 0 ||
        key.compare(key.size() - rest.size(), rest.size(), rest) != 0)
      return std::nullopt;
    return key.substr(star, key.size() - scope.size() - rest.size());
  }

  void check_scope(const std::string& scope) {
    // The groups that any entry of the scope tells of.
    std::set<std::string> names;
    for (const LayoutRow& row : layout_) {
      if (!is_entry_in(row, scope)) continue;
      for (const auto& [key, entry] : found_)
        if (const auto name = name_in(key, row)) names.insert(*name);
    }
    for (const LayoutRow& row : layout_)
      if (row.holds == Holds::kGroups && scope_of(row) == scope) count_groups(row, names.size());
    // Each of them whole.
    for (const std::string& name : names) {
      Lengths own;
      bundles_.clear();
      for (const LayoutRow& row : layout_) {
        if (!is_entry_in(row, scope)) continue;
        std::string key = row.key;
        key.replace(key.find('*'), 1, name);
        check_row(row, key, own);
      }
    }
  }

  void count_groups(const LayoutRow& row, std::size_t count) const {
    const std::size_t wanted = of_file_.at(row.shape.front());
    if (count != wanted)
      fail(row.key, fmt::format("wanted {} groups ({}), got {}", wanted, row.shape.front(), count));
  }

  void check_row(const LayoutRow& row, const std::string& key, Lengths& own) {
    const auto entry = found_.find(key);
    if (entry == found_.end()) return check_absent(row, key, own);
    if (!row.presence.empty() && row.presence != "?") check_bundle(row, key, true);
    const FoundEntry& found = entry->second;
    const bool texts = row.holds == Holds::kTexts;
    if (texts != (found.numbers == nullptr))
      fail(key, texts ? "wanted texts, got numbers" : "wanted numbers, got texts");
    check_shape(row, key, found, own);
    if (!texts) check_numbers(row, key, *found.numbers);
  }

  void check_absent(const LayoutRow& row, const std::string& key, Lengths& own) {
    if (row.presence.empty()) fail(key, "it is missing");
    if (row.presence != "?") return check_bundle(row, key, false);
    // A list of names that was not written has none.
    if (row.holds == Holds::kTexts && row.shape.size() == 1) (void)length_of(row.shape[0], 0, own);
  }

  /// Checks that either all entries of a bundle (one word of `presence`) are there, or none.
  void check_bundle(const LayoutRow& row, const std::string& key, bool there) {
    const auto [first, added] = bundles_.emplace(row.presence, std::make_pair(there, key));
    if (first->second.first == there) return;
    const std::string& other = first->second.second;
    fail(there ? other : key,
         fmt::format("it is missing, while '{}' is there", there ? key : other));
  }

  /// The length of a name, which is the one found if it is the first.
  std::size_t length_of(const std::string& word, std::size_t found, Lengths& own) {
    if (is_fixed_length(word)) return static_cast<std::size_t>(std::stoul(word));
    const bool some = word.back() == '+';
    const std::string name = some ? word.substr(0, word.size() - 1) : word;
    if (const auto known = of_file_.find(name); known != of_file_.end()) return known->second;
    const std::size_t length = own.emplace(name, found).first->second;
    return some ? std::max<std::size_t>(length, 1) : length;
  }

  void check_shape(const LayoutRow& row, const std::string& key, const FoundEntry& found,
                   Lengths& own) {
    const bool open = !row.shape.empty() && row.shape.back() == "..";
    const std::size_t rank = row.shape.size() - (open ? 1 : 0);
    // Lengths that are not known yet are those found, where there is such a dimension.
    std::vector<std::size_t> wanted;
    for (std::size_t k = 0; k < rank; ++k)
      wanted.push_back(length_of(row.shape[k], k < found.shape.size() ? found.shape[k] : 0, own));
    const bool long_enough = open ? found.shape.size() >= rank : found.shape.size() == rank;
    if (long_enough && std::equal(wanted.begin(), wanted.end(), found.shape.begin())) return;
    const bool texts = found.numbers == nullptr;
    fail(key, fmt::format("wanted {}{}, got {}", shape_words(wanted, texts),
                          length_names(row.shape), shape_words(found.shape, texts)));
  }

  void check_numbers(const LayoutRow& row, const std::string& key,
                     const std::vector<double>& numbers) const {
    if (row.holds == Holds::kAny) return;
    const bool whole = row.holds != Holds::kFinite;
    const double below = row.holds == Holds::kCount ? 2147483648.0 : 4294967296.0;
    for (const double number : numbers) {
      if (!std::isfinite(number)) fail(key, "it has numbers that are not finite");
      if (whole && !(number >= 0 && number < below && number == std::floor(number)))
        fail(key, fmt::format("wanted whole numbers from 0 and below {}, got {}", below, number));
    }
  }

  const FoundEntries& found_;
  const Layout& layout_;
  const std::string& path_;
  Lengths of_file_;
  std::map<std::string, std::pair<bool, std::string>> bundles_;  // by word: there?, the first key
};

}  // namespace

void check_entries(const FoundEntries& found, const Layout& layout, const std::string& path) {
  LayoutCheck(found, layout, path).check();
}

}  // namespace thenar::internal
