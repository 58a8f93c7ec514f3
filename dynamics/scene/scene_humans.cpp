#include "dynamics/scene/scene_humans.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/outside_path.h"
#include "base/rung_names.h"
#include "base/units.h"
#include "data/io/toml_node.h"
#include "dynamics/human/digit_pull.h"
#include "tendons/muscle/excitation.h"

namespace thenar {
namespace {

constexpr double kRangeTolerance = 1e-9;  // excess over a joint range by rounding [rad]
constexpr double kForceTolerance = 1e-9;  // excess over a largest force by rounding [1]

/// Prescribed tension or excitation of one muscle of a hand.
struct MuscleDrive {
  std::string muscle;
  MuscleSchedule schedule;  // schedule whose muscle index is not set yet
  int line = 1;             // line of the file
};

/// Returns the names of all muscles of a hand, each once.
std::vector<std::string> muscles_of(const HumanMechanism& hand) {
  std::vector<std::string> names;
  for (const HumanDigit& digit : hand.digits)
    append_new(names, digit.tendons->digit().names.muscles);
  return names;
}

/// Reads the muscle drives of one [[tendon]] or [[muscle]].
std::vector<MuscleDrive> drives_of(const SceneMuscleSpec& spec, const SceneSpec& scene,
                                   const std::vector<std::string>& names) {
  const TimeSpan when{spec.from, spec.to};
  // Constant values of named muscles.
  std::vector<MuscleDrive> out;
  for (const auto& [name, value] : spec.value) {
    const std::string& muscle = names[index_of_name(name, names, "muscle")];
    out.push_back({muscle,
                   {0, when, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, value)},
                   spec.line});
  }
  // Columns of a table; muscles that are 0 throughout are not driven.
  if (spec.file.empty()) return out;
  const std::string path = linked_path(scene.folder, spec.file);
  const double max_value = spec.tensions ? kInfinity : 1;
  const Excitation table = parse_excitation(read_text_file(path), path, names, max_value);
  for (std::size_t m = 0; m < names.size(); ++m) {
    const Eigen::VectorXd column = table.value.col(static_cast<Eigen::Index>(m));
    if (!column.isZero(0)) out.push_back({names[m], {0, when, table.time, column}, spec.line});
  }
  return out;
}

/// Finds the indices of a hand's coordinates in the scene.
CoordinateIndices places_of(const std::string& hand, const std::vector<std::string>& coordinates,
                            const Mechanism& mechanism) {
  const MechanismLayout layout = layout_of(mechanism);
  CoordinateIndices places;
  for (const std::string& own : coordinates) {
    const std::string name = hand + "/" + own;
    for (std::size_t c = 0; c < mechanism.coordinates.size(); ++c)
      if (mechanism.coordinates[c].name == name) {
        places.q.push_back(layout.coordinate_q[c]);
        places.v.push_back(layout.coordinate_v[c]);
      }
  }
  return places;
}

/// Builds the contraction model of the muscles of some digits, with assumed largest forces where
/// the subject states none.
std::shared_ptr<const Contraction> contraction_of(const HumanMechanism& hand,
                                                  const std::vector<const HumanDigit*>& digits,
                                                  const std::vector<std::string>& names,
                                                  Muscle rung) {
  Subject subject = hand.subject;
  std::vector<Musculotendon> muscles;
  for (const HumanDigit* digit : digits) {
    const TendonDigit& tendons = digit->tendons->digit();
    // Fill in missing largest forces.
    for (MuscleUnit& unit : subject.muscles)
      for (std::size_t m = 0; m < tendons.names.muscles.size(); ++m)
        if (unit.name == tendons.names.muscles[m] && !unit.max_force)
          unit.max_force = digit->max_force[m];
    // Append the muscles in the order of the names; those of earlier digits are already there.
    for (Musculotendon& muscle : musculotendons(subject, tendons, rung))
      if (muscles.size() < names.size() && muscle.name == names[muscles.size()])
        muscles.push_back(std::move(muscle));
  }
  return build_contraction(std::move(muscles), rung);
}

/// Builder of the DigitPulls of one hand.
class HandPullBuilder {
 public:
  HandPullBuilder(const SceneSpec& spec, const SceneHuman& human, BuiltScene& built)
      : spec_(spec), human_(human), built_(built), names_(muscles_of(human.hand)) {}

  /// Adds the DigitPulls of the hand to the scene.
  /// @return true if the file drives any muscle of the hand
  bool build() {
    // Read the muscle drives of the file, then add a pull for each group of digits.
    for (const SceneMuscleSpec& each : spec_.muscles)
      if (each.hand == human_.name) read_drives(each);
    bool any = false;
    for (const std::vector<const HumanDigit*>& group : digit_groups()) any = add_pull(group) || any;
    warn_of_tensions();
    return any;
  }

 private:
  void read_drives(const SceneMuscleSpec& each) {
    const auto fail = [&](const std::string& what) {
      throw DataError(spec_.path, each.line, what);
    };
    if (names_.empty()) fail(fmt::format("hand '{}' has no muscles", human_.name));
    // All drives of a hand must state the same rung; errors name the line.
    try {
      if (!each.rung.empty()) {
        const Muscle rung = muscle_named(each.rung);
        require(!rung_ || rung == *rung_, "all muscles of '{}' pull on one rung", human_.name);
        rung_ = rung;
      }
      append_all(each.tensions ? tensions_ : excitations_, drives_of(each, spec_, names_));
    } catch (const InputError& error) {
      fail(error.what());
    }
  }

  /// Returns the contraction model of digits for which the file states none: rigid tendons, or
  /// bounds alone, with a warning, if the subject lacks a fibre length.
  Muscle default_rung(const std::vector<const HumanDigit*>& group) {
    const Subject& subject = human_.hand.subject;
    for (const HumanDigit* digit : group) {
      const std::string without = muscle_without_fibre(subject, digit->tendons->digit());
      if (without.empty()) continue;
      built_.warnings.push_back(fmt::format(
          "hand '{}': muscles of {} pull by their bounds alone, whatever their length and speed, "
          "as subject '{}' states no 'fibre_length_mm' of '{}'",
          human_.name, digit->name, subject.name, without));
      return Muscle::kBounds;
    }
    return Muscle::kRigidTendon;
  }

  /// Warns of tensions above the largest force of their muscle.
  void warn_of_tensions() {
    for (const std::string& name : names_) {
      // Largest prescribed tension, and largest force of the muscle.
      double max_tension = 0, max_force = kInfinity;
      for (const MuscleDrive& each : tensions_)
        if (each.muscle == name)
          max_tension = std::max(max_tension, each.schedule.value.maxCoeff());
      for (const HumanDigit& digit : human_.hand.digits) {
        const std::vector<std::string>& muscles = digit.tendons->digit().names.muscles;
        for (std::size_t m = 0; m < muscles.size(); ++m)
          if (muscles[m] == name) max_force = digit.max_force[m];
      }
      if (max_tension > max_force * (1 + kForceTolerance))
        built_.warnings.push_back(
            fmt::format("hand '{}': {} is pulled with {:.4g} N, but can make {:.4g} N", human_.name,
                        name, max_tension, max_force));
    }
  }

  /// Returns the schedules of some muscles, from lines of the file up to `last`.
  static std::vector<MuscleSchedule> schedules_of(const std::vector<MuscleDrive>& given,
                                                  const std::vector<std::string>& muscles,
                                                  int last = std::numeric_limits<int>::max()) {
    std::vector<MuscleSchedule> out;
    for (const MuscleDrive& each : given) {
      const int muscle = place_in(muscles, each.muscle);
      if (muscle < 0 || each.line > last) continue;
      out.push_back(each.schedule);
      out.back().muscle = muscle;
    }
    return out;
  }

  /// Returns the lines of the file that drive any of these muscles, rising.
  [[nodiscard]] std::set<int> drive_lines(const std::vector<std::string>& muscles) const {
    std::set<int> lines;
    for (const std::vector<MuscleDrive>* given : {&excitations_, &tensions_})
      for (const MuscleDrive& each : *given)
        if (contains(muscles, each.muscle)) lines.insert(each.line);
    return lines;
  }

  /// Builds a pull from its model. @throws DataError at the first line that makes it invalid
  [[nodiscard]] std::shared_ptr<const DigitPull> build_pull(DigitPullModel model) const {
    try {
      return std::make_shared<const DigitPull>(model);
    } catch (const InputError& error) {
      // Add the lines one by one to find the first invalid one.
      const std::vector<std::string>& muscles = model.tendons->muscles();
      const std::set<int> lines = drive_lines(muscles);
      for (const int line : lines) {
        model.tensions = schedules_of(tensions_, muscles, line);
        model.excitations = schedules_of(excitations_, muscles, line);
        try {
          (void)DigitPull(model);
        } catch (const InputError& first) {
          throw DataError(spec_.path, line, first.what());
        }
      }
      throw DataError(spec_.path, *lines.rbegin(), error.what());
    }
  }

  static bool is_driven_by(const std::vector<MuscleDrive>& given, const std::string& muscle) {
    return any_of(given, [&](const MuscleDrive& each) { return each.muscle == muscle; });
  }

  /// Returns the groups of digits that need a common pull, see contracting_groups().
  [[nodiscard]] std::vector<std::vector<const HumanDigit*>> digit_groups() const {
    // Muscles without a prescribed tension, and whether any is excited.
    std::vector<std::vector<std::string>> muscles;
    std::vector<bool> excited;
    for (const HumanDigit& digit : human_.hand.digits) {
      const std::vector<std::string>& names = digit.tendons->digit().names.muscles;
      muscles.emplace_back();
      for (const std::string& name : names)
        if (!is_driven_by(tensions_, name)) muscles.back().push_back(name);
      excited.push_back(
          any_of(names, [&](const std::string& name) { return is_driven_by(excitations_, name); }));
    }
    // Group the digits that share a contracting muscle.
    std::vector<std::vector<const HumanDigit*>> digit_groups;
    for (const std::vector<int>& members : contracting_groups(muscles, excited)) {
      digit_groups.emplace_back();
      for (const int i : members) digit_groups.back().push_back(&human_.hand.digits[i]);
    }
    return digit_groups;
  }

  /// Adds the pull of a group. @return false if the file drives none of its muscles
  bool add_pull(const std::vector<const HumanDigit*>& group) {
    // Collect name, tendons and schedules of the group.
    DigitPullModel model;
    std::vector<std::shared_ptr<const DigitTendons>> tendons;
    for (const HumanDigit* digit : group) {
      model.name += (model.name.empty() ? human_.name + "/" : "-") + digit->name;
      tendons.push_back(digit->tendons);
    }
    model.tendons = std::make_shared<const TendonGroup>(std::move(tendons));
    const std::vector<std::string>& muscles = model.tendons->muscles();
    model.tensions = schedules_of(tensions_, muscles);
    model.excitations = schedules_of(excitations_, muscles);
    if (model.tensions.empty() && model.excitations.empty()) return false;
    model.indices = places_of(human_.name, model.tendons->coordinates(), built_.scene.mechanism);
    // Excited muscles need a contraction model; errors name the first line that excites one.
    if (!model.excitations.empty()) {
      const MuscleDrive* excited = find_where(
          excitations_, [&](const MuscleDrive& each) { return contains(muscles, each.muscle); });
      try {
        model.contraction =
            contraction_of(human_.hand, group, muscles, rung_ ? *rung_ : default_rung(group));
      } catch (const InputError& error) {
        throw DataError(spec_.path, excited->line, error.what());
      }
    }
    built_.scene.elements.push_back(build_pull(std::move(model)));
    return true;
  }

  const SceneSpec& spec_;
  const SceneHuman& human_;
  BuiltScene& built_;
  std::vector<std::string> names_;
  std::vector<MuscleDrive> tensions_, excitations_;
  std::optional<Muscle> rung_;  // contraction model that the file states
};

bool has_torsion_radius(const SceneSpec& spec) {
  return any_of(spec.frictions, [](const SceneFrictionSpec& friction) {
    return friction.torsion_radius.has_value();
  });
}

bool has_drive(const SceneSpec& spec, const std::string& hand) {
  return any_of(spec.drives, [&](const SceneDriveSpec& drive) {
    return drive.coordinate.compare(0, hand.size() + 1, hand + "/") == 0;
  });
}

/// Returns the body with a surface that carries a body by a joint; -1: none.
int carrier_of(const Mechanism& mechanism, int body) {
  // Skip welds up to the joint, then bodies without a surface.
  body = carrier_by_welds(mechanism, body);
  int carrier = body >= 0 ? mechanism.joints[body].parent : -1;
  while (carrier >= 0 && !mechanism.bodies[carrier].solid)
    carrier = mechanism.joints[carrier].parent;
  return carrier;
}

}  // namespace

std::vector<double> human_posture(const SceneHandSpec& spec, const HumanMechanism& hand) {
  // Replace angles of the open hand by those of the file, and check their ranges.
  const std::vector<std::string>& names = hand.skeleton.coordinate_names;
  std::vector<double> u(hand.open.data(), hand.open.data() + hand.open.size());
  for (const auto& [name, value] : spec.placed.posture)
    u[index_of_name(name, names, "joint of hand '" + spec.placed.name + "'")] = value;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const CoordinateLimits& limits = hand.skeleton.limits[c];
    require(u[c] >= limits.lower - kRangeTolerance && u[c] <= limits.upper + kRangeTolerance,
            "joint '{}' of hand '{}' begins at {:.4g} deg, beyond its range {:.4g} to {:.4g} deg",
            names[c], spec.placed.name, u[c] / kDegree, limits.lower / kDegree,
            limits.upper / kDegree);
  }
  return u;
}

void add_human_elements(const SceneSpec& spec, const std::vector<SceneHuman>& humans,
                        BuiltScene& built) {
  // Refuse muscles of robots.
  for (const SceneMuscleSpec& each : spec.muscles)
    if (find_named(humans, each.hand) == nullptr)
      throw DataError(spec.path, each.line,
                      fmt::format("hand '{}' is a robot: it has no muscles", each.hand));
  // Add joint stops and pulls, and warn of motions that nothing resists or drives.
  for (const SceneHuman& human : humans) {
    built.scene.elements.push_back(std::make_shared<const JointStops>(
        human.name + "/stops", human.hand.skeleton,
        places_of(human.name, human.hand.skeleton.coordinate_names, built.scene.mechanism)));
    if (human.hand.contact == ContactModel::kSoftFinger && !has_torsion_radius(spec))
      built.warnings.push_back(fmt::format(
          "soft pads of hand '{}' twist freely on what they touch: no [[friction]] has a "
          "'torsion_radius'",
          human.name));
    if (!HandPullBuilder(spec, human, built).build() && !has_drive(spec, human.name))
      built.warnings.push_back(
          fmt::format("nothing drives hand '{}': it moves freely", human.name));
  }
}

void exclude_web_contacts(const std::vector<SceneHuman>& humans, BuiltScene& built) {
  const Mechanism& mechanism = built.scene.mechanism;
  for (const SceneHuman& human : humans) {
    std::vector<std::pair<int, int>> roots;  // (carrier, link) of all links so far
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      if (built.owner[i] != human.name || !mechanism.bodies[i].solid) continue;
      const int carrier = carrier_of(mechanism, static_cast<int>(i));
      if (carrier < 0 || built.owner[carrier] != human.name) continue;
      // Exclude contacts with all earlier links on the same carrier.
      for (const auto& [other, link] : roots)
        if (other == carrier) built.scene.excluded_pairs.emplace_back(link, static_cast<int>(i));
      roots.emplace_back(carrier, static_cast<int>(i));
    }
  }
}

}  // namespace thenar
