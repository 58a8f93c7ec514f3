// A whole human hand moved by its muscles over wrapped tendons until its fingertips press on a bar:
// steps of 1 ms in the same run, ours and MuJoCo's on a model of the same size.
//
// Same bones, joints, masses, dampers, wrapping surfaces, fingertips and bar; a muscle of MuJoCo
// for each tendon, with MuJoCo's own curves, is as strong as ours. Postures are not compared:
// muscles and joint stops of the two follow different laws. Prints a row like bench/ratios; exit
// code 1 if it misses.

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "base/error.h"
#include "bench/peers/hand_mjcf.h"
#include "bench/peers/mujoco_model.h"
#include "bench/ratios.h"
#include "dynamics/scene/scene_humans.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/scene_state.h"
#include "hand/skin/skin_body.h"
#include "tendons/wrapping/path_solver.h"

namespace thenar::bench {
namespace {

constexpr double kStep = 1e-3;                     // [s]
constexpr int kSteps = 500;                        // of one turn
constexpr double kExcitation = 0.05;               // of every muscle, flexors twice that [1]
constexpr double kFibre = 0.05;                    // optimal length where the specimen has none [m]
constexpr double kShorter = 0.05, kLonger = 0.02;  // MuJoCo's range of lengths about straight [m]
constexpr double kPad = 8e-3;                      // radius of fingertips [m]
constexpr double kBar = 0.03;                      // radius of the bar [m]
constexpr double kFriction = 0.6;                  // of fingertips on the bar [1]
const Eigen::Vector3d kBarPlace(0.035, -0.115, -0.05);  // middle, hand's frame [m] (3)

/// The specimen's hand, with all that muscles need; origins do not ride, as MuJoCo has none such.
Subject subject_of_both() {
  Subject subject = with_passive(read_subject(THENAR_DATA_DIR "/subjects/mirakhorlo2016.toml"),
                                 PassiveMoments::kOff);
  for (Strand& strand : subject.strands)
    if (!strand.path.empty()) strand.path.back().rides_on.clear();
  for (MuscleUnit& unit : subject.muscles)
    if (unit.fibre_length <= 0) unit.fibre_length = kFibre;
  return subject;
}

bool flexes(const std::string& muscle) {
  return muscle.rfind("FD", 0) == 0 || muscle.rfind("FPL", 0) == 0;
}

double excitation_of(const std::string& muscle) {
  return flexes(muscle) ? 2 * kExcitation : kExcitation;
}

std::shared_ptr<const Solid> solid_of(ShapeKind kind, const Eigen::Vector3d& size) {
  ShapeSpec spec;
  spec.kind = kind;
  spec.size = size;
  return std::make_shared<const Solid>(build_solid({spec}));
}

/// Our scene.
class OurHand {
 public:
  explicit OurHand(const Subject& subject) : built_(build(subject)), step_(built_.scene) {}

  void start() {
    state_ = step_.initial_state();
    last_.clear();
  }

  void step() {
    step_.select_active_forces(state_.t);
    step_.take_midpoint_step(state_, kStep, last_, 0.1, outcome_);
    std::swap(last_, outcome_.active);
    step_.accept_step(state_);
    unsolved_ += outcome_.solved ? 0 : 1;
  }

  [[nodiscard]] int contacts() const {
    return static_cast<int>(std::count_if(last_.begin(), last_.end(), [](const ActiveContact& c) {
      return c.kind == ActiveContact::Kind::kContact && c.mode != ContactMode::kOpen;
    }));
  }
  [[nodiscard]] int unsolved() const { return unsolved_; }
  [[nodiscard]] bool is_finite() const { return state_.q.allFinite(); }
  [[nodiscard]] int muscles() const { return muscles_; }
  [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }

 private:
  BuiltScene build(const Subject& subject) {
    HumanModel model{subject, HumanVersion::kSkewedThumb};
    model.options.cover = Cover::kNone;
    model.options.path = Path::kWrapped;
    SceneHuman human{"hand", human_mechanism(model)};
    skeleton_ = human.hand.skeleton;
    BuiltScene out;
    append(out.scene.mechanism, human.hand.mechanism, "hand/");
    add_solids(out.scene.mechanism);
    const MechanismLayout layout = layout_of(out.scene.mechanism);
    out.scene.q = Eigen::VectorXd::Zero(layout.q);
    out.scene.v = Eigen::VectorXd::Zero(layout.v);
    out.scene.friction.coefficient = kFriction;
    SceneSpec spec;
    SceneMuscleSpec muscle;
    muscle.hand = "hand";
    for (const HumanDigit& digit : human.hand.digits)
      for (const std::string& name : digit.tendons->digit().names.muscles)
        muscle.value[name] = excitation_of(name);
    muscles_ = static_cast<int>(muscle.value.size());
    spec.muscles.push_back(muscle);
    add_human_elements(spec, {human}, out);
    return out;
  }

  /// Fingertips on the last links of the digits, and the bar.
  void add_solids(Mechanism& mechanism) const {
    for (const SkeletonTip& tip : skeleton_.tips) {
      MechanismJoint weld;
      weld.name = tip.digit + " pad";
      weld.kind = JointKind::kWeld;
      weld.parent = tip.link + 1;
      weld.X_PF.p = tip.p;
      mechanism.joints.push_back(weld);
      mechanism.bodies.push_back({tip.digit + " pad",
                                  {0, {0, 0, 0}, Eigen::Matrix3d::Zero()},
                                  solid_of(ShapeKind::kSphere, {kPad, 0, 0}),
                                  ""});
    }
    MechanismJoint weld;
    weld.name = "bar";
    weld.kind = JointKind::kWeld;
    weld.X_PF.p = kBarPlace;
    weld.X_PF.R = rotation_about<double>({0, 1, 0}, 2 * std::atan(1.0));
    mechanism.joints.push_back(weld);
    mechanism.bodies.push_back({"bar",
                                {0, {0, 0, 0}, Eigen::Matrix3d::Zero()},
                                solid_of(ShapeKind::kCylinder, {kBar, 0.2, 0}),
                                ""});
  }

  Skeleton skeleton_;
  int muscles_ = 0, unsolved_ = 0;
  BuiltScene built_;
  ContactStep step_;
  SceneState state_;
  std::vector<ActiveContact> last_;
  StepOutcome outcome_;
};

void replace(const std::string& what, const std::string& by, std::string& text) {
  const std::size_t at = text.find(what);
  require(at != std::string::npos, "the model has no '{}'", what);
  text.replace(at, what.size(), by);
}

std::string three(const Eigen::Vector3d& v) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", v.x(), v.y(), v.z());
}

/// The same for MuJoCo.
class TheirHand {
 public:
  TheirHand(const Subject& subject, const Skeleton& skeleton)
      : model_(mujoco_model(text_of(subject, skeleton))),
        data_(mj_makeData(model_.get()), mj_deleteData) {}

  void start() {
    mj_resetData(model_.get(), data_.get());
    for (int i = 0; i < model_->nu; ++i) {
      const std::string name = mj_id2name(model_.get(), mjOBJ_ACTUATOR, i);
      data_->ctrl[i] = excitation_of(name);
    }
  }
  void step() { mj_step(model_.get(), data_.get()); }
  [[nodiscard]] int contacts() const { return data_->ncon; }
  [[nodiscard]] int muscles() const { return model_->nu; }
  [[nodiscard]] int joints() const { return model_->nv; }

 private:
  static double strength(const Subject& subject, const std::string& strand) {
    for (const MuscleUnit& unit : subject.muscles)
      if (unit.strand == strand && unit.max_force) return *unit.max_force;
    return 50;  // of strands that no muscle pulls by itself [N]
  }

  static std::string text_of(const Subject& subject, const Skeleton& skeleton) {
    const PathSet set = build_paths(subject, skeleton);
    std::string text = hand_mjcf(skeleton.tree, set);
    replace("<compiler angle=\"radian\"/>",
            fmt::format("<compiler angle=\"radian\" boundmass=\"0\" boundinertia=\"1e-12\"/>"
                        "<option timestep=\"{}\" gravity=\"0 0 -9.81\"/>"
                        "<default><geom contype=\"0\" conaffinity=\"0\"/></default>",
                        kStep),
            text);
    // Masses, dampers and ranges.
    for (std::size_t i = 0; i < skeleton.tree.size(); ++i) {
      const LinkMass& mass = skeleton.masses[i];
      const Eigen::Matrix3d& I = mass.inertia;
      const double m = std::max(mass.mass, 1e-4);  // MuJoCo wants some for the middle of a joint
      const Eigen::Vector3d least(1e-8, 1e-8, 1e-8);
      const Eigen::Matrix3d J = mass.mass > 0 ? I : Eigen::Matrix3d(least.asDiagonal());
      replace(fmt::format("<body name=\"link{}\"><inertial pos=\"0 0 0\" mass=\"1\" "
                          "diaginertia=\"1 1 1\"/>",
                          i),
              fmt::format("<body name=\"link{}\"><inertial pos=\"{}\" mass=\"{:.9g}\" "
                          "fullinertia=\"{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\"/>",
                          i, three(mass.mass > 0 ? mass.com : skeleton.tree[i].point), m, J(0, 0),
                          J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2)),
              text);
      const CoordinateLimits& range =
          skeleton.limits[static_cast<std::size_t>(skeleton.tree[i].coordinate)];
      replace(fmt::format("name=\"hinge{}\" type=\"hinge\"", i),
              fmt::format("name=\"hinge{}\" type=\"hinge\" damping=\"0.002\" limited=\"true\" "
                          "range=\"{:.9g} {:.9g}\"",
                          i, range.lower, range.upper),
              text);
    }
    // Fingertips and the bar.
    for (const SkeletonTip& tip : skeleton.tips)
      replace(fmt::format("<joint name=\"hinge{}\"", tip.link),
              fmt::format("<geom type=\"sphere\" size=\"{}\" pos=\"{}\" mass=\"0\" contype=\"1\" "
                          "conaffinity=\"2\" friction=\"{} 0 0\"/><joint name=\"hinge{}\"",
                          kPad, three(tip.p), kFriction, tip.link),
              text);
    replace(
        "<worldbody>",
        fmt::format("<worldbody><geom type=\"cylinder\" size=\"{} 0.1\" pos=\"{}\" "
                    "euler=\"0 1.5707963 0\" contype=\"2\" conaffinity=\"1\" friction=\"{} 0 0\"/>",
                    kBar, three(kBarPlace), kFriction),
        text);
    // Muscles.
    std::string muscles;
    PathSolver solver(set);
    const std::vector<PathShape>& shapes = solver.solve(
        pose_tree(skeleton.tree, Eigen::VectorXd(Eigen::VectorXd::Zero(skeleton.coordinates()))));
    for (std::size_t k = 0; k < set.paths.size(); ++k)
      muscles += fmt::format(
          "<muscle name=\"{0}\" tendon=\"{0}\" force=\"{1:.9g}\" lengthrange=\"{2:.9g} {3:.9g}\"/>",
          set.paths[k].name, strength(subject, set.paths[k].name), shapes[k].length - kShorter,
          shapes[k].length + kLonger);
    replace("</tendon>", "</tendon><actuator>" + muscles + "</actuator>", text);
    return text;
  }

  MujocoModel model_;
  MujocoData data_;
};

}  // namespace
}  // namespace thenar::bench

int main() {
  using namespace thenar::bench;
  try {
    const thenar::Subject subject = thenar::with_skin_masses(subject_of_both());
    OurHand ours(subject);
    TheirHand theirs(subject, ours.skeleton());
    Duel duel{"500 steps of a hand, muscles, contacts", {}, {}, 4, 0, 0};
    duel.ours = [&] {
      ours.start();
      for (int i = 0; i < kSteps; ++i) ours.step();
    };
    duel.rival = [&] {
      theirs.start();
      for (int i = 0; i < kSteps; ++i) theirs.step();
    };
    const Row row = measure(duel, {11, 0.01});
    fmt::print("{:<44}{:>11.1f}{:>12.1f}{:>9.2f}{:>10.0f}{:>11}\n", row.name, row.ours, row.rival,
               row.ratio, row.required, row.pass() ? "PASS" : "MISS");
    fmt::print(
        "Times in us. Ours: {} muscles, {} contacts at the end, {} steps unsolved, {}.\n"
        "Rival: MuJoCo {}, {} joints, {} muscles, {} contacts at the end.\n",
        ours.muscles(), ours.contacts(), ours.unsolved(),
        ours.is_finite() ? "finite" : "NOT FINITE", mj_versionString(), theirs.joints(),
        theirs.muscles(), theirs.contacts());
    return row.pass() ? 0 : 1;
  } catch (const thenar::Error& error) {
    fmt::print(stderr, "mujoco_muscles: {}\n", error.what());
    return 2;
  }
}
