#include "data/io/toml_text.h"

#include <cmath>
#include <map>
#include <regex>
#include <string_view>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {

std::string toml_number(double value) {
  require(std::isfinite(value), "only finite numbers are written to files, got {}", value);
  const std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string toml_quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    // Quotes and control characters are escaped.
    if (c == '"' || c == '\\')
      quoted += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      quoted += fmt::format("\\u{:04X}", static_cast<int>(c));
    else
      quoted += c;
  }
  return quoted + "\"";
}

std::string toml_list(const std::vector<double>& values) {
  return fmt::format("[{}]", fmt::join(transformed(values, toml_number), ", "));
}

std::string toml_list(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(transformed(values, toml_quoted), ", "));
}

std::string toml_list(const Eigen::Vector3d& values) {
  return toml_list(std::vector<double>{values.x(), values.y(), values.z()});
}

std::string toml_rows(const Eigen::Matrix3d& matrix) {
  return fmt::format("[{}, {}, {}]", toml_list(Eigen::Vector3d(matrix.row(0).transpose())),
                     toml_list(Eigen::Vector3d(matrix.row(1).transpose())),
                     toml_list(Eigen::Vector3d(matrix.row(2).transpose())));
}

std::vector<std::string> keys_in(const std::string& keys) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  // Keys are separated by a comma and a space.
  for (std::size_t at; (at = keys.find(", ", begin)) != std::string::npos; begin = at + 2)
    parts.push_back(keys.substr(begin, at - begin));
  parts.push_back(keys.substr(begin));
  return parts;
}

std::string toml_keys(const std::string& keys) { return toml_list(keys_in(keys)); }

namespace internal {
const std::map<std::string, std::string_view>& citations();  // made by cmake/embed.cmake
}

std::vector<std::string> citation_keys(const std::string& bibtex) {
  // Entries begin with @type{key,
  static const std::regex entry("@[a-zA-Z]+\\{([^,\\s]+),");
  std::vector<std::string> keys;
  for (std::sregex_iterator it(bibtex.begin(), bibtex.end(), entry), end; it != end; ++it)
    keys.push_back((*it)[1]);
  return keys;
}

const std::vector<std::string>& known_sources() {
  static const std::vector<std::string> keys =
      citation_keys(std::string(internal::citations().at("sources.bib")));
  return keys;
}

}  // namespace thenar
