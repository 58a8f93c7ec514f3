#include "dynamics/scene/scene_humans.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/outside_path.h"
#include "base/rung_names.h"
#include "base/units.h"
#include "data/io/toml_node.h"
#include "dynamics/human/digit_pull.h"
#include "tendons/muscle/excitation.h"

namespace thenar {
namespace {

/// A posture may be beyond a range by so much, from rounding [rad].
constexpr double kBeyondRange = 1e-9;

/// Values over time of one muscle of a hand.
struct GivenMuscle {
  std::string muscle;
  MuscleSchedule schedule;  // its number of the muscle is not set yet
  int line = 1;             // of the file
};

/// Names of all muscles of a hand, each once.
std::vector<std::string> muscles_of(const HumanMechanism& hand) {
  std::vector<std::string> names;
  for (const HumanDigit& digit : hand.digits)
    for (const std::string& name : digit.tendons->digit().names.muscles)
      if (std::count(names.begin(), names.end(), name) == 0) names.push_back(name);
  return names;
}

/// Returns the muscles that one [[tendon]] or [[muscle]] drives, with their values.
std::vector<GivenMuscle> given_by(const SceneMuscleSpec& spec, const SceneSpec& scene,
                                  const std::vector<std::string>& names) {
  const TimeSpan when{spec.from, spec.to};
  // Constant values of single muscles.
  std::vector<GivenMuscle> out;
  for (const auto& [name, value] : spec.value) {
    const std::string& muscle = names[index_of_name(name, names, "muscle")];
    out.push_back({muscle,
                   {0, when, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, value)},
                   spec.line});
  }
  // Muscles that are 0 throughout a table are not driven.
  if (spec.file.empty()) return out;
  const std::string path = linked_path(scene.folder, spec.file);
  const double most = spec.tensions ? std::numeric_limits<double>::infinity() : 1;
  const Excitation table = parse_excitation(read_text_file(path), path, names, most);
  for (std::size_t m = 0; m < names.size(); ++m) {
    const Eigen::VectorXd column = table.value.col(static_cast<Eigen::Index>(m));
    if (!column.isZero(0)) out.push_back({names[m], {0, when, table.time, column}, spec.line});
  }
  return out;
}

/// Finds the indices of a hand's coordinates in the scene.
CoordinateIndices places_of(const std::string& hand, const std::vector<std::string>& coordinates,
                           const Mechanism& mechanism) {
  // Coordinates are named after the hand.
  const MechanismLayout layout = layout_of(mechanism);
  CoordinateIndices places;
  for (const std::string& name : coordinates)
    for (std::size_t c = 0; c < mechanism.coordinates.size(); ++c)
      if (mechanism.coordinates[c].name == hand + "/" + name) {
        places.q.push_back(layout.coordinate_q[c]);
        places.v.push_back(layout.coordinate_v[c]);
      }
  return places;
}

/// Constants of the muscles of some digits, with the largest tensions that were assumed.
std::shared_ptr<const Contraction> contraction_of(const HumanMechanism& hand,
                                                  const std::vector<const HumanDigit*>& digits,
                                                  const std::vector<std::string>& names,
                                                  Muscle rung) {
  // Muscles without a largest force have that of the digit.
  Subject subject = hand.subject;
  std::vector<Musculotendon> muscles;
  for (const HumanDigit* digit : digits) {
    const TendonDigit& tendons = digit->tendons->digit();
    for (MuscleUnit& unit : subject.muscles)
      for (std::size_t m = 0; m < tendons.names.muscles.size(); ++m)
        if (unit.name == tendons.names.muscles[m] && !unit.max_force)
          unit.max_force = digit->max_force[m];
    // Names are in the order of the digits, each once: what an earlier digit had is passed over.
    for (Musculotendon& muscle : musculotendons(subject, tendons, rung))
      if (muscles.size() < names.size() && muscle.name == names[muscles.size()])
        muscles.push_back(std::move(muscle));
  }
  return build_contraction(std::move(muscles), rung);
}

/// Pulls the digits of one hand.
class HandPuller {
 public:
  HandPuller(const SceneSpec& spec, const SceneHuman& human, BuiltScene& built)
      : spec_(spec), human_(human), built_(built), names_(muscles_of(human.hand)) {}

  /// @return whether anything does
  bool pull() {
    // Read what the file drives, then pull each group of digits.
    for (const SceneMuscleSpec& each : spec_.muscles)
      if (each.hand == human_.name) read(each);
    bool any = false;
    for (const std::vector<const HumanDigit*>& group : groups()) any = add(group) || any;
    warn_of_tensions();
    return any;
  }

 private:
  void read(const SceneMuscleSpec& each) {
    const auto fail = [&](const std::string& what) {
      throw DataError(spec_.path, each.line, what);
    };
    // The rung must be one for the hand; errors name the line.
    if (names_.empty()) fail(fmt::format("hand '{}' has no muscles", human_.name));
    try {
      if (!each.rung.empty()) {
        const Muscle rung = muscle_named(each.rung);
        require(!rung_ || rung == *rung_, "all muscles of '{}' pull on one rung", human_.name);
        rung_ = rung;
      }
      for (GivenMuscle& given : given_by(each, spec_, names_))
        (each.tensions ? tensions_ : excitations_).push_back(std::move(given));
    } catch (const InputError& error) {
      fail(error.what());
    }
  }

  /// The rung of digits that contract, where none is stated: rigid tendons, or bounds where the
  /// subject lacks a fibre length.
  Muscle rung_of(const std::vector<const HumanDigit*>& group) {
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

  /// Tells muscles that are to pull more than they can make.
  void warn_of_tensions() {
    for (const std::string& name : names_) {
      // The largest tension that is given, and the largest force.
      double most = 0, can = std::numeric_limits<double>::infinity();
      for (const GivenMuscle& each : tensions_)
        if (each.muscle == name) most = std::max(most, each.schedule.value.maxCoeff());
      for (const HumanDigit& digit : human_.hand.digits) {
        const std::vector<std::string>& muscles = digit.tendons->digit().names.muscles;
        for (std::size_t m = 0; m < muscles.size(); ++m)
          if (muscles[m] == name) can = digit.max_force[m];
      }
      if (most > can * (1 + 1e-9))
        built_.warnings.push_back(
            fmt::format("hand '{}': {} is pulled with {:.4g} N, but can make {:.4g} N", human_.name,
                        name, most, can));
    }
  }

  /// Schedules of some muscles, from lines of the file up to `last`.
  static std::vector<MuscleSchedule> schedules_of(const std::vector<GivenMuscle>& given,
                                                  const std::vector<std::string>& muscles,
                                                  int last = std::numeric_limits<int>::max()) {
    std::vector<MuscleSchedule> out;
    // Entries of these muscles, with their numbers among them.
    for (const GivenMuscle& each : given) {
      const auto at = std::find(muscles.begin(), muscles.end(), each.muscle);
      if (at == muscles.end() || each.line > last) continue;
      out.push_back(each.schedule);
      out.back().muscle = static_cast<int>(at - muscles.begin());
    }
    return out;
  }

  /// Lines of the file that give these muscles something, rising.
  [[nodiscard]] std::set<int> lines_of(const std::vector<std::string>& muscles) const {
    std::set<int> lines;
    for (const std::vector<GivenMuscle>* given : {&excitations_, &tensions_})
      for (const GivenMuscle& each : *given)
        if (std::count(muscles.begin(), muscles.end(), each.muscle) > 0) lines.insert(each.line);
    return lines;
  }

  /// The pull of a digit. @throws DataError at the first line with which it cannot be built
  std::shared_ptr<const DigitPull> pull_of(DigitPullModel model) const {
    try {
      return std::make_shared<const DigitPull>(model);
    } catch (const InputError& error) {
      // Add the lines one by one, to name the first that cannot be built.
      const std::vector<std::string>& muscles = model.tendons->muscles();
      const std::set<int> lines = lines_of(muscles);
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

  static bool gives(const std::vector<GivenMuscle>& given, const std::string& muscle) {
    return std::any_of(given.begin(), given.end(),
                       [&](const GivenMuscle& each) { return each.muscle == muscle; });
  }

  /// Digits one by one, but those that contract with all that share a muscle with them.
  [[nodiscard]] std::vector<std::vector<const HumanDigit*>> groups() const {
    // Muscles that are not given a tension, and whether any is excited.
    std::vector<std::vector<std::string>> muscles;
    std::vector<bool> excited;
    for (const HumanDigit& digit : human_.hand.digits) {
      const std::vector<std::string>& names = digit.tendons->digit().names.muscles;
      muscles.emplace_back();
      for (const std::string& name : names)
        if (!gives(tensions_, name)) muscles.back().push_back(name);
      excited.push_back(std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return gives(excitations_, name);
      }));
    }
    // Digits that contract with those that share a muscle.
    std::vector<std::vector<const HumanDigit*>> groups;
    for (const std::vector<int>& members : contracting_groups(muscles, excited)) {
      groups.emplace_back();
      for (const int i : members)
        groups.back().push_back(&human_.hand.digits[static_cast<std::size_t>(i)]);
    }
    return groups;
  }

  bool add(const std::vector<const HumanDigit*>& group) {
    // Name, tendons and schedules of the group.
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
    // Excited muscles contract; errors name the first line that excites one of them.
    if (!model.excitations.empty()) {
      const auto excited =
          std::find_if(excitations_.begin(), excitations_.end(), [&](const GivenMuscle& each) {
            return std::count(muscles.begin(), muscles.end(), each.muscle) > 0;
          });
      try {
        model.contraction =
            contraction_of(human_.hand, group, muscles, rung_ ? *rung_ : rung_of(group));
      } catch (const InputError& error) {
        throw DataError(spec_.path, excited->line, error.what());
      }
    }
    built_.scene.elements.push_back(pull_of(std::move(model)));
    return true;
  }

  const SceneSpec& spec_;
  const SceneHuman& human_;
  BuiltScene& built_;
  std::vector<std::string> names_;
  std::vector<GivenMuscle> tensions_, excitations_;
  std::optional<Muscle> rung_;  // that the scene states
};

bool has_torsion(const SceneSpec& spec) {
  return std::any_of(spec.frictions.begin(), spec.frictions.end(),
                     [](const SceneFrictionSpec& friction) { return friction.torsion_radius; });
}

bool has_drive(const SceneSpec& spec, const std::string& hand) {
  return std::any_of(spec.drives.begin(), spec.drives.end(), [&](const SceneDriveSpec& drive) {
    return drive.coordinate.compare(0, hand.size() + 1, hand + "/") == 0;
  });
}

/// The body with a surface that carries a body by a joint; -1: none.
int carrier_of(const Mechanism& mechanism, int body) {
  const auto joint_of = [&](int i) -> const MechanismJoint& {
    return mechanism.joints[static_cast<std::size_t>(i)];
  };
  // Past what is welded to it, to whatever has a surface on the other side of a joint.
  while (body >= 0 && joint_of(body).kind == JointKind::kWeld) body = joint_of(body).parent;
  int carrier = body >= 0 ? joint_of(body).parent : -1;
  while (carrier >= 0 && !mechanism.bodies[static_cast<std::size_t>(carrier)].solid)
    carrier = joint_of(carrier).parent;
  return carrier;
}

}  // namespace

std::vector<double> human_posture(const SceneHandSpec& spec, const HumanMechanism& hand) {
  // Open hand, with the angles that the file states, within their ranges.
  const std::vector<std::string>& names = hand.skeleton.coordinate_names;
  std::vector<double> u(hand.open.data(), hand.open.data() + hand.open.size());
  for (const auto& [name, value] : spec.placed.posture)
    u[index_of_name(name, names, "joint of hand '" + spec.placed.name + "'")] = value;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const CoordinateLimits& limits = hand.skeleton.limits[c];
    require(u[c] >= limits.lower - kBeyondRange && u[c] <= limits.upper + kBeyondRange,
            "joint '{}' of hand '{}' begins at {:.4g} deg, beyond its range {:.4g} to {:.4g} deg",
            names[c], spec.placed.name, u[c] / kDegree, limits.lower / kDegree,
            limits.upper / kDegree);
  }
  return u;
}

void add_human_elements(const SceneSpec& spec, const std::vector<SceneHuman>& humans,
                        BuiltScene& built) {
  // Robots have no muscles.
  for (const SceneMuscleSpec& each : spec.muscles)
    if (std::none_of(humans.begin(), humans.end(),
                     [&](const SceneHuman& human) { return human.name == each.hand; }))
      throw DataError(spec.path, each.line,
                      fmt::format("hand '{}' is a robot: it has no muscles", each.hand));
  // Stops of the joints, and warnings of what is left free.
  for (const SceneHuman& human : humans) {
    built.scene.elements.push_back(std::make_shared<const JointStops>(
        human.name + "/stops", human.hand.skeleton,
        places_of(human.name, human.hand.skeleton.coordinate_names, built.scene.mechanism)));
    if (human.hand.contact == ContactModel::kSoftFinger && !has_torsion(spec))
      built.warnings.push_back(fmt::format(
          "soft pads of hand '{}' twist freely on what they touch: no [[friction]] has a "
          "'torsion_radius'",
          human.name));
    // Muscles and drives may both be absent.
    if (!HandPuller(spec, human, built).pull() && !has_drive(spec, human.name))
      built.warnings.push_back(
          fmt::format("nothing drives hand '{}': it moves freely", human.name));
  }
}

void part_webs(const std::vector<SceneHuman>& humans, BuiltScene& built) {
  const Mechanism& mechanism = built.scene.mechanism;
  for (const SceneHuman& human : humans) {
    std::vector<std::pair<int, int>> roots;  // links on each carrier: carrier, link
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      if (built.owner[i] != human.name || !mechanism.bodies[i].solid) continue;
      const int carrier = carrier_of(mechanism, static_cast<int>(i));
      if (carrier < 0 || built.owner[static_cast<std::size_t>(carrier)] != human.name) continue;
      // Links on the same carrier are neighbours, whose webs overlap.
      for (const auto& [other, link] : roots)
        if (other == carrier) built.scene.apart.emplace_back(link, static_cast<int>(i));
      roots.emplace_back(carrier, static_cast<int>(i));
    }
  }
}

}  // namespace thenar
