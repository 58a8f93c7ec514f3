#include "data/io/robot/import_xml.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace thenar::internal {
namespace {

constexpr std::size_t kLinesNamed = 8;  // largest number of lines named in a warning

/// Lists lines: "line 12"; "2 times: lines 12, 30".
std::string listed_lines(std::vector<int> lines) {
  const std::size_t times = lines.size();
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  std::string list = times == 1 ? "" : fmt::format("{} times: ", times);
  list += lines.size() == 1 ? "line " : "lines ";
  for (std::size_t i = 0; i < std::min(lines.size(), kLinesNamed); ++i)
    list += (i == 0 ? "" : ", ") + std::to_string(lines[i]);
  if (lines.size() > kLinesNamed) list += fmt::format(" and {} more", lines.size() - kLinesNamed);
  return list;
}

}  // namespace

std::vector<double> parse_numbers(const XmlFile& file, const pugi::xml_node& node,
                                  const std::string& text, const std::string& what) {
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream in(spaced);
  in.imbue(std::locale::classic());
  std::vector<double> numbers;
  // Words that are numbers as a whole.
  for (std::string word; in >> word;) {
    std::istringstream letters(word);
    letters.imbue(std::locale::classic());
    double value = 0;
    if (!(letters >> value) || letters.peek() != std::istringstream::traits_type::eof() ||
        !std::isfinite(value))
      file.fail(node, fmt::format("{} wants numbers, got '{}'", what, word));
    numbers.push_back(value);
  }
  return numbers;
}

double parse_number(const XmlFile& file, const pugi::xml_node& node, const std::string& text,
                    const std::string& what) {
  const std::vector<double> numbers = parse_numbers(file, node, text, what);
  if (numbers.size() != 1)
    file.fail(node, fmt::format("{} wants one number, got '{}'", what, text));
  return numbers[0];
}

Eigen::Vector3d parse_vector3(const XmlFile& file, const pugi::xml_node& node,
                              const std::string& text, const std::string& what) {
  const std::vector<double> numbers = parse_numbers(file, node, text, what);
  if (numbers.size() != 3)
    file.fail(node, fmt::format("{} wants three numbers, got '{}'", what, text));
  return {numbers[0], numbers[1], numbers[2]};
}

double number_or(const XmlFile& file, const pugi::xml_node& node, const char* attribute,
                 double otherwise) {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) return otherwise;
  return parse_number(file, node, found.value(), fmt::format("<{}> {}", node.name(), attribute));
}

std::string required_text(const XmlFile& file, const pugi::xml_node& node, const char* attribute) {
  std::string text = node.attribute(attribute).value();
  if (text.empty()) file.fail(node, fmt::format("<{}> wants {}=\"..\"", node.name(), attribute));
  return text;
}

std::string add_unique_name(std::set<std::string>& names, const std::string& wanted,
                            const std::string& otherwise) {
  const std::string& name = wanted.empty() ? otherwise : wanted;
  std::string candidate = name;
  for (int i = 2; !names.insert(candidate).second; ++i) candidate = fmt::format("{} {}", name, i);
  return candidate;
}

void UnreadElements::note(const pugi::xml_node& node, const std::string& what) {
  const int line = file_.line(node);
  // The same message once, with all its lines.
  const auto [at, is_new] = by_what_.emplace(what, entries_.size());
  if (is_new) entries_.push_back({what, {}});
  entries_[at->second].lines.push_back(line);
}

std::vector<std::string> UnreadElements::warnings() const {
  std::vector<std::string> list;
  for (const Entry& entry : entries_)
    list.push_back(fmt::format("{} ({})", entry.what, listed_lines(entry.lines)));
  return list;
}

}  // namespace thenar::internal
