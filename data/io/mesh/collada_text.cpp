#include "data/io/mesh/collada_text.h"

#include <algorithm>
#include <map>
#include <set>

#include <pugixml.hpp>

#include "base/error.h"

namespace thenar {
namespace {

class Check {
 public:
  Check(const std::string& text, const std::string& path) : text_(text), path_(path) {
    const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
    if (!result) fail_at(result.offset, result.description());
  }

  void run() {
    each(document_, [&](const pugi::xml_node& node) {
      if (std::string(node.name()) == "float_array")
        lengths_["#" + std::string(node.attribute("id").value())] = whole(node, "count", 0);
    });
    each(document_, [&](const pugi::xml_node& node) {
      if (std::string(node.name()) == "accessor") check_accessor(node);
      static const std::set<std::string> lists{"p", "h", "v", "vcount", "int_array"};
      if (lists.count(node.name()) == 1) check_list(node);
    });
  }

 private:
  template <typename Visit>
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the file
  static void each(const pugi::xml_node& node, const Visit& visit) {
    visit(node);
    for (const pugi::xml_node& child : node.children()) each(child, visit);
  }

  [[noreturn]] void fail_at(std::ptrdiff_t offset, const std::string& what) const {
    const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(
                                         offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
    throw DataError(path_, 1 + static_cast<int>(std::count(text_.begin(), end, '\n')), what);
  }

  [[nodiscard]] double whole(const pugi::xml_node& node, const char* attribute,
                             double otherwise) const {
    constexpr double kMost = 1e9;
    const double number = node.attribute(attribute).as_double(otherwise);
    if (!(number >= 0 && number < kMost))
      fail_at(node.offset_debug(),
              fmt::format("wanted {} of <{}> in 0..{:.0e}, got '{}'", attribute, node.name(), kMost,
                          node.attribute(attribute).value()));
    return number;
  }

  /// From each of the numbers offset, offset + stride .. of an array on, one for each parameter.
  void check_accessor(const pugi::xml_node& node) const {
    const auto array = lengths_.find(node.attribute("source").value());
    if (array == lengths_.end()) return;  // of names, or none: assimp refuses it
    const auto params = std::distance(node.children("param").begin(), node.children("param").end());
    const double count = whole(node, "count", 0), stride = std::max(whole(node, "stride", 1), 1.0);
    const double last = stride * std::max(count - 1, 0.0);
    const double width = count > 0 ? std::max(static_cast<double>(params), 1.0) : 0.0;
    const double reach = whole(node, "offset", 0) + last + width;
    if (reach > array->second)
      fail_at(node.offset_debug(), fmt::format("<accessor> reaches to {} of {} numbers in '{}'",
                                               reach, array->second, array->first));
  }

  void check_list(const pugi::xml_node& node) const {
    const std::string list = node.text().get();
    const std::size_t other = list.find_first_not_of("0123456789+- \t\r\n");
    if (other != std::string::npos)
      fail_at(node.offset_debug(), fmt::format("wanted whole numbers in <{}>, got '{}'",
                                               node.name(), list.substr(other, 1)));
  }

  const std::string& text_;
  const std::string& path_;
  pugi::xml_document document_;
  std::map<std::string, double> lengths_;  // of the arrays, by "#id"
};

}  // namespace

void check_collada(const std::string& text, const std::string& path) { Check(text, path).run(); }

}  // namespace thenar
