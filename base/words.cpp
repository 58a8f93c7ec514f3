#include "base/words.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/lists.h"

namespace thenar {

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string some_of(const std::vector<std::string>& names, std::size_t named) {
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(named, names.size()));
  std::string text = fmt::format("{}", fmt::join(names.begin(), end, ", "));
  if (names.size() > named) text += fmt::format(" and {} more", names.size() - named);
  return text;
}

std::string quoted_list(const std::string& what, const std::vector<std::string>& names) {
  const std::vector<std::string> quoted =
      transformed(names, [](const std::string& name) { return "'" + name + "'"; });
  return what + (names.size() == 1 ? " " : "s ") + some_of(quoted);
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

char first_sign(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first == std::string::npos ? '\0' : text[first];
}

}  // namespace thenar
