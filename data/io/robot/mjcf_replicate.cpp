#include "data/io/robot/mjcf_replicate.h"

#include <map>
#include <set>
#include <string>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "data/io/graspit/xml_walk.h"
#include "data/io/robot/import_xml.h"

namespace thenar::internal {
namespace {

constexpr int kMostCopies = 1000;       // of one element
constexpr long kMostElements = 100000;  // of all copies

using Names = std::map<std::string, std::set<std::string>>;  // of each kind: joint, tendon

/// What an attribute names, if that can be a copy: "joint1" a joint.
std::string kind_named_by(const std::string& attribute) {
  for (const char* kind : {"joint", "tendon"})
    if (attribute == kind || attribute == std::string(kind) + "1" ||
        attribute == std::string(kind) + "2")
      return kind;
  return attribute == "jointinparent" ? "joint" : "";
}

long elements_in(const pugi::xml_node& node) {
  long count = -1;
  for (pugi::xml_node at = node; at; at = next_below(node, at)) ++count;
  return count;
}

void collect_joints(const pugi::xml_node& node, std::set<std::string>& names) {
  for (pugi::xml_node at = node; at; at = next_below(node, at))
    if (std::string(at.name()) == "joint") names.insert(at.attribute("name").value());
}

void append(pugi::xml_attribute attribute, const std::string& suffix) {
  if (attribute) attribute = (attribute.value() + suffix).c_str();
}

void rename(const pugi::xml_node& top, const std::string& suffix) {
  for (pugi::xml_node node = top; node; node = next_below(top, node))
    append(node.attribute("name"), suffix);
}

bool names_one_of(const pugi::xml_node& top, const Names& names) {
  for (pugi::xml_node node = top; node; node = next_below(top, node))
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const auto kind = names.find(kind_named_by(attribute.name()));
      if (kind != names.end() && kind->second.count(attribute.value()) > 0) return true;
    }
  return false;
}

void point_to_copies(const pugi::xml_node& top, const Names& names, const std::string& suffix) {
  for (pugi::xml_node node = top; node; node = next_below(top, node))
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const auto kind = names.find(kind_named_by(attribute.name()));
      if (kind != names.end() && kind->second.count(attribute.value()) > 0)
        append(attribute, suffix);
    }
}

class Replicator {
 public:
  explicit Replicator(const XmlFile& file) : file_(file) {}

  void run() {
    for (const pugi::xml_node world : file_.root().children("worldbody")) expand(world);
  }

 private:
  void expand(pugi::xml_node node) {
    for (pugi::xml_node child = node.first_child(); child;) {
      const pugi::xml_node next = child.next_sibling();
      expand(child);
      if (std::string(child.name()) == "replicate") copy(node, child);
      child = next;
    }
  }

  [[nodiscard]] int count_of(const pugi::xml_node& node) const {
    const double count = number_or(file_, node, "count", 0);
    if (count < 1 || count > kMostCopies || count != static_cast<int>(count))
      file_.fail(node, fmt::format("<replicate> wants count=\"..\" in 1..{}, got '{}'", kMostCopies,
                                   node.attribute("count").value()));
    return static_cast<int>(count);
  }

  void count_elements(const pugi::xml_node& node, long each, std::size_t copies) {
    elements_ += each * static_cast<long>(copies);
    if (elements_ > kMostElements)
      file_.fail(node, fmt::format("<replicate> makes more than {} elements", kMostElements));
  }

  void copy(pugi::xml_node parent, pugi::xml_node node) {
    const int count = count_of(node);
    count_elements(node, elements_in(node) + count, static_cast<std::size_t>(count));
    Names names;
    collect_joints(node, names["joint"]);
    names["joint"].erase("");
    const std::string digits = std::to_string(count), sep = node.attribute("sep").value();
    std::vector<std::string> suffixes;
    for (int i = 0; i < count; ++i)
      suffixes.push_back(fmt::format("{}{:0{}}", sep, i, digits.size()));
    for (int i = 0; i < count; ++i) {
      pugi::xml_node place = parent.insert_child_before("frame", node);
      for (int step = 0; step < i; ++step) place = moved(place, node);
      for (const pugi::xml_node part : node.children())
        rename(place.append_copy(part), suffixes[static_cast<std::size_t>(i)]);
    }
    parent.remove_child(node);
    for (const char* section : {"tendon", "equality", "actuator"})
      for (const pugi::xml_node elements : file_.root().children(section))
        copy_references(elements, names, suffixes, section);
  }

  /// A frame one step further on.
  static pugi::xml_node moved(pugi::xml_node place, const pugi::xml_node& replicate) {
    pugi::xml_node frame = place.append_child("frame");
    if (const pugi::xml_attribute offset = replicate.attribute("offset"))
      frame.append_attribute("pos") = offset.value();
    if (const pugi::xml_attribute euler = replicate.attribute("euler"))
      frame.append_attribute("euler") = euler.value();
    return frame;
  }

  void copy_references(pugi::xml_node section, Names& names,
                       const std::vector<std::string>& suffixes, const std::string& kind) {
    for (pugi::xml_node element = section.first_child(); element;) {
      const pugi::xml_node next = element.next_sibling();
      if (names_one_of(element, names)) {
        if (kind == "tendon") names[kind].insert(element.attribute("name").value());
        count_elements(element, elements_in(element) + 1, suffixes.size());
        for (const std::string& suffix : suffixes) {
          pugi::xml_node copied = section.insert_copy_before(element, element);
          append(copied.attribute("name"), suffix);
          point_to_copies(copied, names, suffix);
        }
        section.remove_child(element);
      }
      element = next;
    }
  }

  const XmlFile& file_;
  long elements_ = 0;
};

}  // namespace

void expand_replicates(const XmlFile& file) { Replicator(file).run(); }

}  // namespace thenar::internal
