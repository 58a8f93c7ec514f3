#pragma once

/// Settings of a whole MJCF file: compiler settings, defaults, included files, replicates.

#include <map>
#include <string>
#include <vector>

#include "base/spatial.h"
#include "data/io/graspit/xml_file.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/import_xml.h"

namespace pugi {
struct xml_node_struct;
}  // namespace pugi

namespace thenar::internal {

/// Attributes of <compiler> that matter here.
struct MjcfCompiler {
  double angle = 0;  // size of one unit of angle [rad]
  std::string euler_sequence = "xyz";
  std::string mesh_folder;  // beside the file
  bool strip_path = false;  // strip folders from names of mesh files
  bool auto_limits = true;  // a range alone means limits
  std::string inertia_from_geom = "auto";
  double min_group = 0, max_group = 5;  // groups of geoms with mass
  double bound_mass = 0;                // smallest mass of a moving body [kg]
  double total_mass = -1;               // [kg]; negative: not set
};

/// Default values of attributes that elements leave out.
class MjcfDefaults {
 public:
  /// Reads all <default> under `root`.
  void read(const XmlFile& file, const pugi::xml_node& root);
  /// @param name_of_class  empty: the outermost
  /// @returns null if neither the class nor those around it state the attribute
  [[nodiscard]] const std::string* find(const std::string& name_of_class,
                                        const std::string& element,
                                        const std::string& attribute) const;
  [[nodiscard]] bool has_class(const std::string& name) const { return by_name_.count(name) > 0; }

 private:
  // Index of no class
  static constexpr std::size_t kNoClass = static_cast<std::size_t>(-1);
  /// Values that a class states itself; the class around it states the rest.
  struct Class {
    std::map<std::pair<std::string, std::string>, std::string>
        values;                    // default value by element and attribute
    std::size_t above = kNoClass;  // index of the class around it
  };
  void read_class(const XmlFile& file, const pugi::xml_node& node, std::size_t own);
  std::vector<Class> classes_{1};  // the outermost first
  std::map<std::string, std::size_t> by_name_{{"", 0}};
};

/// An MJCF file while it is read; file, unread and meshes must outlive it.
struct MjcfSource {
  const XmlFile& file;
  UnreadElements& unread;
  MjcfCompiler compiler;
  MjcfDefaults defaults;
  bool incomplete;  // bodies or joints that the file names may be missing here
  MeshReader& meshes;
};

/// Returns true if an element represents bodies that are not read: <attach>, <composite>,
/// <flexcomp>.
[[nodiscard]] bool makes_bodies(const pugi::xml_node& node);

/// Returns whether there are such bodies under an element, or joints other than hinges and slides.
[[nodiscard]] bool lacks_joints(const pugi::xml_node& root);

/// Replaces every <include file=".."> by the content of its file. @returns paths of
/// all files, its own included
/// @throws DataError if a file is missing, includes itself, or is outside of the model's folder,
/// with links resolved.
std::vector<std::string> expand_includes(const XmlFile& file);

/// Reads all <compiler> elements; later ones override earlier ones.
[[nodiscard]] MjcfCompiler read_compiler(const XmlFile& file, UnreadElements& unread);

/// An element with the defaults of its class and of the body around it; the source must outlive it.
class MjcfElement {
 public:
  /// @throws DataError if its class is unknown.
  MjcfElement(const MjcfSource& source, const pugi::xml_node& node, std::string childclass);

  [[nodiscard]] bool has(const char* attribute) const;
  [[nodiscard]] std::string text(const char* attribute, const std::string& otherwise = "") const;
  [[nodiscard]] double number(const char* attribute, double otherwise) const;
  /// Returns the numbers of an attribute; empty if it is absent.
  [[nodiscard]] std::vector<double> numbers(const char* attribute) const;
  [[nodiscard]] Eigen::Vector3d vector3(const char* attribute,
                                        const Eigen::Vector3d& otherwise) const;
  /// Returns the pose from pos and one of quat, axisangle, euler, xyaxes, zaxis.
  [[nodiscard]] Pose<double> pose() const;
  [[noreturn]] void fail(const std::string& what) const;
  [[nodiscard]] int line() const;
  [[nodiscard]] pugi::xml_node node() const;

 private:
  [[nodiscard]] const char* find(const char* attribute) const;
  [[nodiscard]] Eigen::Matrix3d rotation() const;

  const MjcfSource* source_;
  pugi::xml_node_struct* node_;  // pugixml's handle of the element
  std::string kind_;
  std::string class_;
};

/// Returns the rotation that turns z into `direction` by the smallest angle; half a turn about x if
/// it points down.
/// @param direction  not zero (3)
[[nodiscard]] Eigen::Matrix3d rotation_to(const Eigen::Vector3d& direction);

/// Replaces every <replicate count=".." sep=".." offset=".." euler=".."> by copies, copy i in i
/// nested <frame pos="offset" euler="euler">: each is moved and rotated in the frame of the copy
/// before. Names inside get the suffix sep + i, padded with zeros to the digits of count, inner
/// replicates first; tendons, equalities and actuators that name a joint or tendon inside are
/// copied, too.
/// @throws DataError if a count is not in 1..1000, or there are too many copies.
/// Source: the MJCF reference [Todorov2012].
void expand_replicates(const XmlFile& file);

}  // namespace thenar::internal
