#include "base/nearest_name.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/field_names.h"
#include "base/name_hint.h"

namespace thenar {
namespace {

constexpr std::size_t kMinBeginning = 2;  // fewer letters are no beginning of a name [1]

/// Returns the shortest name that begins with `wanted`; empty if none does, or `wanted` is short.
std::string shortest_beginning_with(const std::string& wanted,
                                    const std::vector<std::string>& names) {
  std::string best;
  if (wanted.size() < kMinBeginning) return best;
  for (const std::string& name : names)
    if (name.rfind(wanted, 0) == 0 && (best.empty() || name.size() < best.size())) best = name;
  return best;
}

}  // namespace

int edit_distance(const std::string& a, const std::string& b) {
  // One row of the table of Wagner and Fischer at a time.
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::string nearest_name(const std::string& wanted, const std::vector<std::string>& names) {
  std::string best = shortest_beginning_with(wanted, names);
  if (!best.empty()) return best;
  // A correction changes at most two letters of a short name, and a third of those of a long one.
  const int letters = static_cast<int>(wanted.size());
  int least = std::max(std::min(2, (letters + 1) / 2), (letters + 2) / 3) + 1;
  for (const std::string& name : names) {
    const int distance = edit_distance(wanted, name);
    if (distance < least) {
      least = distance;
      best = name;
    }
  }
  return best;
}

std::string did_you_mean(const std::string& wanted, const std::vector<std::string>& names) {
  const std::string best = nearest_name(wanted, names);
  return best.empty() ? "" : fmt::format(", did you mean '{}'?", best);
}

std::string listed(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

// NOLINTNEXTLINE(misc-no-recursion): once, by a name that is there
std::size_t index_of_name(const std::string& name, const std::vector<std::string>& names,
                          const std::string& kind, const std::string& field) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string of_field = name_of_field(name, names);
  if (!of_field.empty()) return index_of_name(of_field, names, kind, field);
  throw InputError(fmt::format("no {} '{}'{} there are {}", kind, name,
                               hint_before_list(name, names), listed(names)),
                   field);
}

}  // namespace thenar
