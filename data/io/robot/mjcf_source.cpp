#include "data/io/robot/mjcf_source.h"

#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/file_io.h"
#include "base/outside_path.h"
#include "base/units.h"
#include "data/io/file_guard.h"

namespace thenar::internal {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxIncludeDepth = 128;  // Most elements around an <include>

/// Kind under which defaults are kept: all actuators share theirs.
std::string default_kind(const std::string& element) {
  static const std::set<std::string> actuators{"motor",       "position", "velocity",
                                               "intvelocity", "damper",   "cylinder",
                                               "muscle",      "adhesion", "dcmotor"};
  if (actuators.count(element) > 0) return "general";
  if (element == "fixed" || element == "spatial") return "tendon";
  return element;
}

int depth_of(pugi::xml_node node) {
  int depth = 0;
  for (node = node.parent(); !node.empty(); node = node.parent()) ++depth;
  return depth;
}

/// Replaces an <include> by the content of its file. @returns the node to go on with
pugi::xml_node expand(const XmlFile& file, const pugi::xml_node& include,
                      std::set<std::string>& open) {
  // The file must be in the model's folder, and included once.
  const std::string name = required_text(file, include, "file");
  if (const auto fault = outside_fault(name, OutsideUse::kRead))
    file.fail(include, "the name of an included file has " + *fault);
  const fs::path wanted = fs::path(file.path()).parent_path() / name;
  const std::string path = wanted.lexically_normal().string();
  if (!is_in_folder_of(file.path(), wanted.string()))
    file.fail(include, fmt::format("'{}' is outside of the model's folder, from which nothing is "
                                   "included: copy it there",
                                   name));
  if (!is_file(path)) file.fail(include, fmt::format("there is no file '{}'", path));
  if (!open.insert(path).second) file.fail(include, fmt::format("'{}' is included twice", path));
  if (depth_of(include) > kMaxIncludeDepth)
    file.fail(include,
              fmt::format("<include> stands more than {} elements deep", kMaxIncludeDepth));
  // Copy its elements, then remove the <include>.
  const XmlFile included(path);
  pugi::xml_node parent = include.parent(), first;
  for (const pugi::xml_node part : included.root().children()) {
    const pugi::xml_node copied = parent.insert_copy_before(part, include);
    if (!first) first = copied;
  }
  if (!first) first = parent.insert_child_before(pugi::node_pcdata, include);
  parent.remove_child(include);
  return first;
}

void read_compiler(MjcfCompiler& compiler, const XmlFile& file, UnreadElements& unread,
                   const pugi::xml_node& node) {
  const auto text = [&](const char* name, const std::string& otherwise) {
    return std::string(node.attribute(name).as_string(otherwise.c_str()));
  };
  // Angles.
  const std::string angle = text("angle", "");
  if (!angle.empty()) compiler.angle = angle == "radian" ? 1 : kDegree;
  compiler.euler_sequence = text("eulerseq", compiler.euler_sequence);
  if (compiler.euler_sequence.size() != 3 ||
      compiler.euler_sequence.find_first_not_of("xyzXYZ") != std::string::npos)
    file.fail(node,
              fmt::format("eulerseq wants three of xyzXYZ, got '{}'", compiler.euler_sequence));
  // Files, limits and masses.
  compiler.mesh_folder = text("meshdir", text("assetdir", compiler.mesh_folder));
  compiler.strip_path = node.attribute("strippath").as_bool(compiler.strip_path);
  compiler.auto_limits = node.attribute("autolimits").as_bool(compiler.auto_limits);
  compiler.inertia_from_geom = text("inertiafromgeom", compiler.inertia_from_geom);
  compiler.bound_mass = number_or(file, node, "boundmass", compiler.bound_mass);
  compiler.total_mass = number_or(file, node, "settotalmass", compiler.total_mass);
  if (const pugi::xml_attribute groups = node.attribute("inertiagrouprange")) {
    const std::vector<double> range =
        parse_numbers(file, node, groups.value(), "inertiagrouprange");
    if (range.size() != 2) file.fail(node, "inertiagrouprange wants two numbers");
    compiler.min_group = range[0];
    compiler.max_group = range[1];
  }
  // Settings that would change the meaning of everything.
  if (text("coordinate", "local") != "local")
    file.fail(node, "coordinate=\"global\" is not read; save the model with local coordinates");
  for (const char* name : {"balanceinertia", "boundinertia", "fusestatic"})
    if (!node.attribute(name).empty())
      unread.note(node, fmt::format("<compiler {}> is not heeded", name));
}

Eigen::Matrix3d euler_rotation(const Eigen::Vector3d& angles, const std::string& sequence) {
  // Lower case rotates with the frame, upper case in the fixed one.
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const std::size_t letter = std::string("xyzXYZ").find(sequence[i]);
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(static_cast<int>(letter % 3));
    const Eigen::Matrix3d turn = rotation_about<double>(axis, angles[i]);
    R = letter < 3 ? Eigen::Matrix3d(R * turn) : Eigen::Matrix3d(turn * R);
  }
  return R;
}

}  // namespace

void MjcfDefaults::read(const XmlFile& file, const pugi::xml_node& root) {
  for (const pugi::xml_node node : root.children("default")) {
    read_class(file, node, 0);
    by_name_[node.attribute("class").as_string("main")] = 0;
  }
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as classes nest
void MjcfDefaults::read_class(const XmlFile& file, const pugi::xml_node& node, std::size_t own) {
  // The class's own values, then nested classes.
  for (const pugi::xml_node element : node.children())
    if (std::string(element.name()) != "default")
      for (const pugi::xml_attribute attribute : element.attributes())
        classes_[own].values[{default_kind(element.name()), attribute.name()}] = attribute.value();
  for (const pugi::xml_node nested : node.children("default")) {
    const std::size_t index = classes_.size();
    classes_.push_back({{}, own});
    by_name_[required_text(file, nested, "class")] = index;
    read_class(file, nested, index);
  }
}

const std::string* MjcfDefaults::find(const std::string& name_of_class, const std::string& element,
                                      const std::string& attribute) const {
  const auto start = by_name_.find(name_of_class);
  if (start == by_name_.end()) return nullptr;
  const std::pair<std::string, std::string> wanted{default_kind(element), attribute};
  // The class and all classes around it, from inside out.
  for (std::size_t at = start->second; at != kNoClass; at = classes_[at].above) {
    const auto value = classes_[at].values.find(wanted);
    if (value != classes_[at].values.end()) return &value->second;
  }
  return nullptr;
}

bool makes_bodies(const pugi::xml_node& node) {
  const std::string name = node.name();
  return name == "attach" || name == "composite" || name == "flexcomp";
}

bool lacks_joints(const pugi::xml_node& root) {
  for (pugi::xml_node node = root; node; node = next_below(root, node)) {
    const std::string type = node.attribute("type").value();
    const bool other_joint =
        std::string(node.name()) == "freejoint" ||
        (std::string(node.name()) == "joint" && (type == "ball" || type == "free"));
    if (other_joint || makes_bodies(node)) return true;
  }
  return false;
}

std::vector<std::string> expand_includes(const XmlFile& file) {
  // Included files may include others: go on at their first element.
  std::set<std::string> open{fs::path(file.path()).lexically_normal().string()};
  const pugi::xml_node root = file.root();
  for (pugi::xml_node node = root; node;)
    node = std::string(node.name()) == "include" && node != root ? expand(file, node, open)
                                                                 : next_below(root, node);
  return {open.begin(), open.end()};
}

MjcfCompiler read_compiler(const XmlFile& file, UnreadElements& unread) {
  MjcfCompiler compiler;
  compiler.angle = kDegree;
  for (const pugi::xml_node node : file.root().children("compiler"))
    read_compiler(compiler, file, unread, node);
  return compiler;
}

MjcfElement::MjcfElement(const MjcfSource& source, const pugi::xml_node& node,
                         std::string childclass)
    : source_(&source),
      node_(node.internal_object()),
      kind_(node.name()),
      class_(std::move(childclass)) {
  // An element's own class comes before that of the body around it.
  const pugi::xml_attribute own = node.attribute("class");
  if (own) class_ = own.value();
  if (!source.defaults.has_class(class_))
    fail(fmt::format("there is no default class '{}'", class_));
}

pugi::xml_node MjcfElement::node() const { return pugi::xml_node(node_); }

/// The element's own value, otherwise that of its class; null if there is none.
const char* MjcfElement::find(const char* attribute) const {
  if (const pugi::xml_attribute own = node().attribute(attribute)) return own.value();
  const std::string* by_class = source_->defaults.find(class_, kind_, attribute);
  return by_class == nullptr ? nullptr : by_class->c_str();
}

bool MjcfElement::has(const char* attribute) const { return find(attribute) != nullptr; }

std::string MjcfElement::text(const char* attribute, const std::string& otherwise) const {
  const char* found = find(attribute);
  return found == nullptr ? otherwise : found;
}

std::vector<double> MjcfElement::numbers(const char* attribute) const {
  const char* found = find(attribute);
  if (found == nullptr) return {};
  return parse_numbers(source_->file, node(), found, fmt::format("<{}> {}", kind_, attribute));
}

double MjcfElement::number(const char* attribute, double otherwise) const {
  const char* found = find(attribute);
  if (found == nullptr) return otherwise;
  return parse_number(source_->file, node(), found, fmt::format("<{}> {}", kind_, attribute));
}

Eigen::Vector3d MjcfElement::vector3(const char* attribute,
                                     const Eigen::Vector3d& otherwise) const {
  const char* found = find(attribute);
  if (found == nullptr) return otherwise;
  return parse_vector3(source_->file, node(), found, fmt::format("<{}> {}", kind_, attribute));
}

void MjcfElement::fail(const std::string& what) const { source_->file.fail(node(), what); }

int MjcfElement::line() const { return source_->file.line(node()); }

Pose<double> MjcfElement::pose() const {
  return {rotation(), vector3("pos", Eigen::Vector3d::Zero())};
}

Eigen::Matrix3d MjcfElement::rotation() const {
  // Numbers of an attribute, in the right count and not all zero.
  const auto of_size = [&](const char* attribute, std::size_t count) {
    std::vector<double> v = numbers(attribute);
    if (v.size() != count)
      fail(fmt::format("<{}> {} wants {} numbers, got {}", kind_, attribute, count, v.size()));
    if (Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(count)).norm() == 0 &&
        std::string(attribute) != "euler")
      fail(fmt::format("<{}> {} has no length", kind_, attribute));
    return v;
  };
  // Each of MuJoCo's ways to state a rotation.
  if (has("euler"))
    return euler_rotation(source_->compiler.angle * vector3("euler", Eigen::Vector3d::Zero()),
                          source_->compiler.euler_sequence);
  if (has("axisangle")) {
    const std::vector<double> v = of_size("axisangle", 4);
    const Eigen::Vector3d axis(v[0], v[1], v[2]);
    if (axis.isZero(0)) fail("axisangle has no axis");
    return rotation_about<double>(axis.normalized(), v[3] * source_->compiler.angle);
  }
  // Two axes, the second made perpendicular to the first.
  if (has("xyaxes")) {
    const std::vector<double> v = of_size("xyaxes", 6);
    const Eigen::Vector3d x = Eigen::Vector3d(v[0], v[1], v[2]).normalized();
    Eigen::Vector3d y(v[3], v[4], v[5]);
    y = (y - y.dot(x) * x).normalized();
    Eigen::Matrix3d R;
    R << x, y, x.cross(y);
    if (!(R.determinant() > 0.5)) fail("xyaxes wants two directions that are not parallel");
    return R;
  }
  if (has("zaxis")) {
    const std::vector<double> v = of_size("zaxis", 3);
    return rotation_to({v[0], v[1], v[2]});
  }
  if (!has("quat")) return Eigen::Matrix3d::Identity();
  const std::vector<double> q = of_size("quat", 4);
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

Eigen::Matrix3d rotation_to(const Eigen::Vector3d& direction) {
  // Shortest rotation from z; half a turn about x if it points down.
  const Eigen::Vector3d z = direction.normalized(), axis = Eigen::Vector3d::UnitZ().cross(z);
  const double sine = axis.norm();
  if (sine < 1e-12)
    return z.z() > 0 ? Eigen::Matrix3d::Identity()
                     : rotation_about<double>(Eigen::Vector3d::UnitX(), kPi);
  return rotation_about<double>(axis / sine, std::atan2(sine, z.z()));
}

namespace {

constexpr int kMaxCopies = 1000;       // largest number of copies of one element
constexpr long kMaxElements = 100000;  // largest number of elements in all copies
using Names = std::map<std::string, std::set<std::string>>;  // by kind: joint, tendon

/// Kind of object that an attribute names, if it can be a copy: "joint1" names a joint.
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

/// Returns the attributes below an element that name one of some joints and tendons.
std::vector<pugi::xml_attribute> attributes_naming(const pugi::xml_node& top, const Names& names) {
  std::vector<pugi::xml_attribute> found;
  for (pugi::xml_node node = top; node; node = next_below(top, node))
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const auto kind = names.find(kind_named_by(attribute.name()));
      if (kind != names.end() && kind->second.count(attribute.value()) > 0)
        found.push_back(attribute);
    }
  return found;
}

/// Expands <replicate> elements.
class Replicator {
 public:
  explicit Replicator(const XmlFile& file) : file_(file) {}

  void run() {
    for (const pugi::xml_node world : file_.root().children("worldbody")) expand(world);
  }

 private:
  /// Expands the innermost elements first.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the file
  void expand(pugi::xml_node parent) {
    for (pugi::xml_node child = parent.first_child(); child;) {
      const pugi::xml_node next = child.next_sibling();
      expand(child);
      if (std::string(child.name()) == "replicate") copy(parent, child);
      child = next;
    }
  }

  [[nodiscard]] int count_of(const pugi::xml_node& node) const {
    const double count = number_or(file_, node, "count", 0);
    if (count < 1 || count > kMaxCopies || count != static_cast<int>(count))
      file_.fail(node, fmt::format("<replicate> wants count=\"..\" in 1..{}, got '{}'", kMaxCopies,
                                   node.attribute("count").value()));
    return static_cast<int>(count);
  }

  void count_elements(const pugi::xml_node& node, long each, std::size_t copies) {
    elements_ += each * static_cast<long>(copies);
    if (elements_ > kMaxElements)
      file_.fail(node, fmt::format("<replicate> makes more than {} elements", kMaxElements));
  }

  void copy(pugi::xml_node parent, pugi::xml_node node) {
    // Limits first, then the names that copies will change.
    const int count = count_of(node);
    count_elements(node, elements_in(node) + count, static_cast<std::size_t>(count));
    Names names;
    collect_joints(node, names["joint"]);
    names["joint"].erase("");
    // Suffixes with leading zeros.
    const std::string digits = std::to_string(count), sep = node.attribute("sep").value();
    std::vector<std::string> suffixes;
    suffixes.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
      suffixes.push_back(fmt::format("{}{:0{}}", sep, i, digits.size()));
    // Copy i stands in i nested frames.
    for (int i = 0; i < count; ++i) {
      pugi::xml_node place = parent.insert_child_before("frame", node);
      for (int step = 0; step < i; ++step) place = moved(place, node);
      for (const pugi::xml_node part : node.children())
        rename(place.append_copy(part), suffixes[i]);
    }
    parent.remove_child(node);
    // Tendons, equalities and actuators of copied joints are copied, too.
    for (const char* section : {"tendon", "equality", "actuator"})
      for (const pugi::xml_node elements : file_.root().children(section))
        copy_references(elements, names, suffixes, section);
  }

  /// Appends a frame that is one step farther.
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
      // Copies refer to the copies of joints and tendons.
      if (!attributes_naming(element, names).empty()) {
        // Copied tendons may be named by later sections.
        if (kind == "tendon") names[kind].insert(element.attribute("name").value());
        count_elements(element, elements_in(element) + 1, suffixes.size());
        for (const std::string& suffix : suffixes) {
          pugi::xml_node copied = section.insert_copy_before(element, element);
          append(copied.attribute("name"), suffix);
          for (const pugi::xml_attribute attribute : attributes_naming(copied, names))
            append(attribute, suffix);
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
