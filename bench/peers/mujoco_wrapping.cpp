// Lengths and moment arms of all tendons of a whole hand, against MuJoCo on the same model.
//
// The tendon stage alone, then with the pose before it. Prints rows like bench/ratios; exit code 1
// if a row misses.

#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "bench/peers/hand_mjcf.h"
#include "bench/peers/mujoco_model.h"
#include "bench/ratios.h"
#include "tendons/wrapping/path_arms.h"

namespace thenar::bench {
namespace {

constexpr int kPostures = 64;

/// Everything about one posture on both sides.
struct Posed {
  Eigen::VectorXd q;
  TreeState<double> state;
  MujocoData data{nullptr, mj_deleteData};
};

class Scene {
 public:
  Scene(const Skeleton& skeleton, PathSet set)
      : tree_(skeleton.tree),
        set_(std::move(set)),
        model_(mujoco_model(hand_mjcf(tree_, set_))),
        solver_(set_),
        R_(set_.paths.size(), skeleton.coordinates()) {
    std::mt19937 rng(3);
    for (int i = 0; i < kPostures; ++i) posed_.push_back(pose(skeleton, rng));
  }

  /// The tendon stage alone.
  Row tendons(const std::string& name, double required) {
    Duel duel{name, {}, {}, required, difference(), 1e-6};
    duel.ours = [&, i = 0U]() mutable { ours(posed_[i++ % kPostures].state); };
    duel.rival = [&, i = 0U]() mutable {
      mj_tendon(model_.get(), posed_[i++ % kPostures].data.get());
    };
    return measure(duel);
  }

  /// From the angles to the arms.
  Row whole(const std::string& name) {
    Duel duel{name, {}, {}, 0, difference(), 1e-6};
    duel.ours = [&, i = 0U]() mutable { ours(pose_tree(tree_, posed_[i++ % kPostures].q)); };
    duel.rival = [&, i = 0U]() mutable { theirs(posed_[i++ % kPostures].data.get()); };
    return measure(duel);
  }

 private:
  Posed pose(const Skeleton& skeleton, std::mt19937& rng) {
    Posed posed;
    posed.q.resize(skeleton.coordinates());
    for (int j = 0; j < skeleton.coordinates(); ++j) {
      const CoordinateLimits& limit = skeleton.limits[static_cast<std::size_t>(j)];
      // Joints without a range move a little: the wrist.
      const double low = std::max(limit.lower, -0.5), high = std::min(limit.upper, 1.2);
      posed.q[j] = std::uniform_real_distribution<double>(low, std::min(high, low + 1.4))(rng);
    }
    posed.state = pose_tree(tree_, posed.q);
    posed.data.reset(mj_makeData(model_.get()));
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, fmt::format("hinge{}", i).c_str());
      posed.data->qpos[model_->jnt_qposadr[joint]] =
          tree_[i].ratio * posed.q[tree_[i].coordinate] + tree_[i].offset;
    }
    theirs(posed.data.get());
    return posed;
  }

  void theirs(mjData* data) {
    mj_kinematics(model_.get(), data);
    mj_comPos(model_.get(), data);  // the Jacobians of mj_tendon need it
    mj_tendon(model_.get(), data);
  }

  void ours(const TreeState<double>& state) {
    path_arms(tree_, state, set_, solver_.solve(state), R_);
    keep(R_);
  }

  /// Greatest difference of any length at any posture [m].
  double difference() {
    double most = 0;
    for (const Posed& posed : posed_) {
      const auto& shapes = solver_.solve(posed.state);
      for (std::size_t k = 0; k < shapes.size(); ++k)
        most = std::max(most, std::abs(shapes[k].length - posed.data->ten_length[k]));
    }
    return most;
  }

  const Tree<double>& tree_;
  PathSet set_;
  MujocoModel model_;
  PathSolver solver_;
  Eigen::MatrixXd R_;
  std::vector<Posed> posed_;
};

/// The specimen's hand; origins do not ride, as MuJoCo has no such thing.
Subject hand() {
  Subject subject = read_subject(THENAR_DATA_DIR "/subjects/mirakhorlo2016.toml");
  for (Strand& strand : subject.strands)
    if (!strand.path.empty()) strand.path.back().rides_on.clear();
  return subject;
}

/// Balls instead of cylinders, as wide, on the axis beside the first strand that bends over them.
Subject with_balls(Subject subject) {
  for (Surface& surface : subject.surfaces) {
    surface.shape = SurfaceShape::kSphere;
    for (const Strand& strand : subject.strands)
      for (std::size_t k = 0; k < strand.path.size(); ++k)
        if (strand.path[k].surface == surface.name) {
          const Eigen::Vector3d middle = 0.5 * (strand.path[k - 1].p + strand.path[k + 1].p);
          const Eigen::Vector3d axis = surface.axes.col(2);
          surface.center += axis * axis.dot(middle - surface.center);
        }
  }
  return subject;
}

bool print(const Row& row) {
  fmt::print("{:<44}{:>11.3f}{:>12.2f}{:>9.1f}{:>10}{:>10.1e}{:>11}\n", row.name, row.ours,
             row.rival, row.ratio, row.required > 0 ? fmt::format("{:.0f}", row.required) : "none",
             row.error, row.pass() ? "PASS" : "MISS");
  return row.pass();
}

bool compare(const std::string& what, const Subject& subject) {
  const Skeleton skeleton = build_skeleton(subject);
  const PathSet set = build_paths(subject, skeleton);
  const std::string name = fmt::format("{} tendons over {}", set.paths.size(), what);
  Scene scene(skeleton, set);
  const bool tendons = print(scene.tendons(name, 3));
  return print(scene.whole("the same with the pose of the hand")) && tendons;
}

}  // namespace
}  // namespace thenar::bench

int main() {
  using namespace thenar::bench;
  try {
    const bool cylinders = compare("14 cylinders", hand());
    const bool balls = compare("14 balls", with_balls(hand()));
    fmt::print(
        "Rival: MuJoCo {} as Debian packages it; lengths and moment arms on both sides,\n"
        "error in lengths [m].\n",
        mj_versionString());
    return cylinders && balls ? 0 : 1;
  } catch (const thenar::Error& error) {
    fmt::print(stderr, "mujoco_wrapping: {}\n", error.what());
    return 2;
  }
}
