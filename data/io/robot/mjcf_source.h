#pragma once

/// What holds for a whole MJCF file: settings of its compiler, defaults, included files.

#include <map>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "base/spatial.h"
#include "data/io/graspit/xml_file.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/import_xml.h"

namespace thenar::internal {

/// The attributes of <compiler> that matter here.
struct MjcfCompiler {
  double angle = 0;  // of one unit of angle [rad]
  std::string euler_sequence = "xyz";
  std::string mesh_folder;  // beside the file
  bool strip_path = false;  // of mesh files
  bool auto_limits = true;  // a range alone limits
  std::string inertia_from_geom = "auto";
  double min_group = 0, max_group = 5;  // of geoms that have mass
  double bound_mass = 0;                // least mass of a moving body [kg]
  double total_mass = -1;               // [kg]; negative: as it comes
};

/// Values of attributes that elements leave out.
class MjcfDefaults {
 public:
  /// Reads all <default> under `root`.
  void read(const XmlFile& file, const pugi::xml_node& root);
  /// @param name_of_class  empty: the outermost
  /// @return null if the class says nothing about it.
  [[nodiscard]] const std::string* find(const std::string& name_of_class,
                                        const std::string& element,
                                        const std::string& attribute) const;
  [[nodiscard]] bool has_class(const std::string& name) const { return by_name_.count(name) > 0; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  /// What a class says itself; the class around it says the rest.
  struct Class {
    std::map<std::pair<std::string, std::string>, std::string> values;  // by element and attribute
    std::size_t above = kNone;                                          // among the classes
  };
  void read_class(const XmlFile& file, const pugi::xml_node& node, std::size_t own);
  std::vector<Class> classes_{1};  // the outermost first
  std::map<std::string, std::size_t> by_name_{{"", 0}};
};

struct MjcfSource {
  const XmlFile& file;
  UnreadElements& unread;
  MjcfCompiler compiler;
  MjcfDefaults defaults;
  bool incomplete;  // joints that the file names may be none here
  MeshReader& meshes;
};

/// Whether an element stands for bodies that are not read: <attach>, <composite>, <flexcomp>.
[[nodiscard]] bool makes_bodies(const pugi::xml_node& node);

/// Whether there are such bodies under an element, or joints that are no hinge or slide.
[[nodiscard]] bool lacks_joints(const pugi::xml_node& root);

/// Puts the content of included files in the place of <include file="..">.
/// @throws DataError if a file is missing, includes itself, or is outside of the model's folder,
/// wherever links lead.
void expand_includes(const XmlFile& file);

[[nodiscard]] MjcfCompiler read_compiler(const XmlFile& file, UnreadElements& unread);

/// An element with what its class and the body around it say.
class MjcfElement {
 public:
  /// @throws DataError if its class is unknown.
  MjcfElement(const MjcfSource& source, const pugi::xml_node& node, std::string childclass);

  [[nodiscard]] bool has(const char* attribute) const;
  [[nodiscard]] std::string text(const char* attribute, const std::string& otherwise = "") const;
  [[nodiscard]] double number(const char* attribute, double otherwise) const;
  /// Empty if absent.
  [[nodiscard]] std::vector<double> numbers(const char* attribute) const;
  [[nodiscard]] Eigen::Vector3d vector3(const char* attribute,
                                        const Eigen::Vector3d& otherwise) const;
  /// From pos and one of quat, axisangle, euler, xyaxes, zaxis.
  [[nodiscard]] Pose<double> pose() const;
  [[noreturn]] void fail(const std::string& what) const;
  [[nodiscard]] int line() const;

 private:
  [[nodiscard]] const char* find(const char* attribute) const;
  [[nodiscard]] Eigen::Matrix3d rotation() const;

  const MjcfSource* source_;
  pugi::xml_node node_;
  std::string kind_;
  std::string class_;
};

/// Turns z into `direction` the short way; half a turn about x if it points down.
/// @param direction  not zero (3)
[[nodiscard]] Eigen::Matrix3d rotation_to(const Eigen::Vector3d& direction);

// Copies of what <replicate> of an MJCF file encloses.

/// Puts copies in the place of every <replicate count=".." sep=".." offset=".." euler="..">, copy i
/// in i nested <frame pos="offset" euler="euler">: each is moved and turned in the frame of the one
/// before. Names within get the suffix sep + i, padded with zeros to the digits of count, inner
/// replicates first; tendons, equalities and actuators that name a joint or tendon within are
/// copied along.
/// @throws DataError if a count is not in 1..1000, or copies become too many.
/// Source: the MJCF reference [Todorov2012].
void expand_replicates(const XmlFile& file);

}  // namespace thenar::internal
