#include "data/io/foreign_mesh/parsers.h"

#include <algorithm>
#include <map>
#include <set>

#include <pugixml.hpp>

#include "base/error.h"
#include "data/io/file_guard.h"
#include "data/io/graspit/xml_file.h"

namespace thenar {
namespace {

/// Checks of a Collada document that assimp does not make.
class Check {
 public:
  Check(const std::string& text, const std::string& path) : text_(text), path_(path) {
    const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
    if (!result) fail_at(result.offset, result.description());
  }

  void run() {
    // Lengths of arrays, nodes by id, and references to other files.
    each(document_, [&](const pugi::xml_node& node) {
      const std::string id = "#" + std::string(node.attribute("id").value());
      if (std::string(node.name()) == "float_array") lengths_[id] = whole(node, "count", 0);
      if (std::string(node.name()) == "node") nodes_.emplace(id, node);
      require_own(node);
    });
    // Nodes that stand for others must not multiply.
    if (placed(document_, 0) > kMaxNodes)
      fail_at(0, fmt::format("nodes in nodes stand for more than {} of them", kMaxNodes));
    // Accessors and lists of numbers stay within their arrays.
    each(document_, [&](const pugi::xml_node& node) {
      if (std::string(node.name()) == "accessor") check_accessor(node);
      static const std::set<std::string> lists{"p", "h", "v", "vcount", "int_array"};
      if (lists.count(node.name()) == 1) check_list(node);
    });
  }

 private:
  template <typename Visit>
  // NOLINTNEXTLINE(misc-no-recursion): as deep as nodes may stand for others
  static void each(const pugi::xml_node& top, const Visit& visit) {
    for (pugi::xml_node node = top; node; node = internal::next_below(top, node)) visit(node);
  }

  [[noreturn]] void fail_at(std::ptrdiff_t offset, const std::string& what) const {
    throw DataError(path_, line_of_offset(text_, offset), what);
  }

  [[nodiscard]] double whole(const pugi::xml_node& node, const char* attribute,
                             double otherwise) const {
    constexpr double kMaxAttribute = 1e9;  // Upper bound of counts, strides and offsets [1]
    const double number = node.attribute(attribute).as_double(otherwise);
    if (!(number >= 0 && number < kMaxAttribute))
      fail_at(node.offset_debug(),
              fmt::format("wanted {} of <{}> in 0..{:.0e}, got '{}'", attribute, node.name(),
                          kMaxAttribute, node.attribute(attribute).value()));
    return number;
  }

  /// Refuses a reference to another file; references within the file begin with '#'.
  void require_own(const pugi::xml_node& node) const {
    const std::string url = node.attribute("url").value();
    if (std::string(node.name()).rfind("instance_", 0) == 0 && !url.empty() && url[0] != '#')
      fail_at(node.offset_debug(),
              fmt::format("<{}> names another file, which is not read: '{}'", node.name(), url));
  }

  /// Number of nodes below a node, each <instance_node> with all nodes for which it stands.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as nodes may stand for others
  double placed(const pugi::xml_node& top, int depth) {
    constexpr int kMaxNodeDepth = 100;  // Deepest nesting of nodes
    double count = 0;
    // NOLINTNEXTLINE(misc-no-recursion): as deep as nodes may stand for others
    each(top, [&](const pugi::xml_node& node) {
      count += std::string(node.name()) == "node" ? 1 : 0;
      if (std::string(node.name()) != "instance_node") return;
      // Count the node that it stands for once; a node within itself is refused.
      const auto other = nodes_.find(node.attribute("url").value());
      if (other == nodes_.end()) return;
      const auto [known, is_new] = placed_.emplace(other->first, -1);
      if (!is_new && known->second < 0)
        fail_at(node.offset_debug(), fmt::format("node '{}' contains itself", other->first));
      if (depth > kMaxNodeDepth)
        fail_at(node.offset_debug(), fmt::format("nodes stand more than {} deep", kMaxNodeDepth));
      // Its count is reused wherever it is instantiated again.
      if (is_new) {
        const double inside = placed(other->second, depth + 1);
        placed_[other->first] = inside;
      }
      count += placed_.at(other->first);
    });
    return count;
  }

  /// Refuses an accessor that reads beyond its array: numbers offset, offset + stride .., one for
  /// each parameter.
  void check_accessor(const pugi::xml_node& node) const {
    const auto array = lengths_.find(node.attribute("source").value());
    if (array == lengths_.end()) return;  // of names, or missing: assimp refuses it
    const auto params = std::distance(node.children("param").begin(), node.children("param").end());
    const double count = whole(node, "count", 0), stride = std::max(whole(node, "stride", 1), 1.0);
    // The last number that it reads.
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
  static constexpr double kMaxNodes = 1e5;       // Most nodes after all nodes in nodes are placed
  std::map<std::string, double> lengths_;        // of arrays, by "#id"
  std::map<std::string, pugi::xml_node> nodes_;  // by "#id"
  std::map<std::string, double> placed_;         // nodes below each; negative: being counted
};

}  // namespace

void check_collada(const std::string& text, const std::string& path) { Check(text, path).run(); }

}  // namespace thenar
