#include "data/io/graspit/xml_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <utility>

#include <pugixml.hpp>

#include "base/error.h"
#include "base/file_io.h"
#include "base/words.h"
#include "data/io/file_guard.h"

namespace thenar {
namespace {

/// Text in UTF-8: unchanged, or converted from Latin-1, in which older Windows programs wrote.
std::string in_utf8(std::string text) {
  if (pugi::as_utf8(pugi::as_wide(text)) == text) return text;
  std::wstring wide;
  for (const char c : text) wide += static_cast<wchar_t>(static_cast<unsigned char>(c));
  return pugi::as_utf8(wide);
}

void rename(const pugi::xml_node& top, const std::map<std::string, std::string>& names) {
  for (pugi::xml_node node = top; node; node = internal::next_below(top, node)) {
    const auto found = names.find(lower_case(node.name()));
    if (found != names.end() && found->second != node.name()) node.set_name(found->second.c_str());
  }
}

}  // namespace

struct XmlFile::Document {
  pugi::xml_document xml;
  std::vector<std::ptrdiff_t> line_ends;  // of the text, ascending
};

XmlFile::XmlFile(const std::string& path)
    : XmlFile(read_file(path, limit_of(GuardedKind::kXml).bytes), path) {}

XmlFile::XmlFile(std::string text, std::string path)
    : text_(std::move(text)), path_(std::move(path)), document_(std::make_unique<Document>()) {
  guard_text(text_, path_, GuardedKind::kXml);
  // Guard, convert, parse.
  text_ = in_utf8(std::move(text_));
  const pugi::xml_parse_result result = document_->xml.load_buffer(
      text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) throw DataError(path_, line_of_offset(text_, result.offset), result.description());
  // Positions of line ends, to find lines by bisection.
  for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1))
    document_->line_ends.push_back(static_cast<std::ptrdiff_t>(at));
}

XmlFile::~XmlFile() = default;

pugi::xml_node XmlFile::root() const { return document_->xml.document_element(); }

// NOLINTNEXTLINE(readability-make-member-function-const): it renames elements
void XmlFile::settle_case(const std::string& names) {
  std::map<std::string, std::string> by_lower_case;
  std::istringstream words(names);
  for (std::string name; words >> name;) by_lower_case[lower_case(name)] = name;
  rename(root(), by_lower_case);
}

std::string XmlFile::root_name() const { return root().name(); }

int XmlFile::line(const pugi::xml_node& node) const {
  const std::vector<std::ptrdiff_t>& ends = document_->line_ends;
  return 1 + static_cast<int>(std::lower_bound(ends.begin(), ends.end(), node.offset_debug()) -
                              ends.begin());
}

void XmlFile::fail(const pugi::xml_node& node, const std::string& what) const {
  // Most bytes of a quotation in a message, which may be a whole file [bytes]
  constexpr std::size_t kMaxQuotedBytes = 1000;
  throw DataError(path_, line(node),
                  what.size() > kMaxQuotedBytes ? what.substr(0, kMaxQuotedBytes) + " .." : what);
}

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): asked of a file, as numbers() is
std::string XmlFile::text(const pugi::xml_node& node) const {
  const std::string all = node.text().get();
  const char* const white = " \t\r\n";
  const std::size_t first = all.find_first_not_of(white);
  if (first == std::string::npos) return "";
  return all.substr(first, all.find_last_not_of(white) - first + 1);
}

/// Brackets, commas and white space all separate numbers.
std::vector<double> XmlFile::numbers(const pugi::xml_node& node, int count) const {
  std::string all = text(node);
  for (char& c : all)
    if (std::string("()[],;\t\r\n").find(c) != std::string::npos) c = ' ';
  std::vector<double> found;
  // Read number after number, each finite and complete.
  for (const char* at = all.c_str(); *(at += std::strspn(at, " ")) != '\0';) {
    char* end = nullptr;
    found.push_back(std::strtod(at, &end));
    if (end == at || (*end != ' ' && *end != '\0') || !std::isfinite(found.back()))
      fail(node, fmt::format("wanted finite numbers in <{}>, got '{}'", node.name(), text(node)));
    at = end;
  }
  if (count > 0 && static_cast<int>(found.size()) != count)
    fail(node, fmt::format("wanted {} numbers in <{}>, got {}", count, node.name(), found.size()));
  return found;
}

Eigen::Vector3d XmlFile::vector3(const pugi::xml_node& node) const {
  const std::vector<double> v = numbers(node, 3);
  return {v[0], v[1], v[2]};
}

std::string XmlFile::not_understood(const pugi::xml_node& node) const {
  return fmt::format("{}:{}: <{}> is not understood and was left out", path_, line(node),
                     node.name());
}

}  // namespace thenar
