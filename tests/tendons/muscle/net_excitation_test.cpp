// Random excitations from rest under every net of data/nets, 0.5 s each: whether motions come to
// their end, and what the others say. THENAR_EXCITATIONS asks for more of each net than the few of
// every day. A program that is stopped goes on from where it was: motions are kept beside the
// program, in a file that a new program begins anew.

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "tendons/muscle/simulate.h"
#include "tendons/net/build_tendons.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
namespace fs = std::filesystem;

/// What became of a motion.
struct MotionEnd {
  MotionStatus status = MotionStatus::kCompleted;
  bool told = true;           // a motion that does not end, or snaps, says why
  long effort = 0;            // evaluations of the net's energy
  int snaps = 0;              // of the net
  double least_released = 0;  // by a snap [J]
  double energy_error = 0;    // of what was turned over [1]
  double cpu = 0;             // [s]
};

std::ostream& operator<<(std::ostream& out, const MotionEnd& o) {
  return out << static_cast<int>(o.status) << ' ' << o.told << ' ' << o.effort << ' ' << o.snaps
             << ' ' << o.least_released << ' ' << o.energy_error << ' ' << o.cpu;
}

std::istream& operator>>(std::istream& in, MotionEnd& o) {
  int status = 0;
  in >> status >> o.told >> o.effort >> o.snaps >> o.least_released >> o.energy_error >> o.cpu;
  o.status = static_cast<MotionStatus>(status);
  return in;
}

/// Outcomes so far of one net, on disk as long as the program is the same.
class Kept {
 public:
  Kept(const std::string& net, bool on_disk) {
    if (!on_disk) return;
    const fs::path program = fs::read_symlink("/proc/self/exe");
    path_ = program.parent_path() / ("excitations_" + net + ".txt");
    std::ostringstream build;
    build << fs::file_size(program) << ' '
          << fs::last_write_time(program).time_since_epoch().count();
    // Lines of the same build.
    std::ifstream in(path_);
    std::string line;
    if (std::getline(in, line) && line == build.str()) {
      int k = 0;
      for (MotionEnd outcome; in >> k >> outcome;) outcomes[k] = outcome;
    } else {
      std::ofstream(path_) << build.str() << '\n';
    }
  }

  void add(int k, const MotionEnd& outcome) {
    outcomes[k] = outcome;
    if (!path_.empty()) std::ofstream(path_, std::ios::app) << k << ' ' << outcome << '\n';
  }

  std::map<int, MotionEnd> outcomes;

 private:
  fs::path path_;
};

/// The k-th excitation: a few muscles or all of them, anywhere in 0..1 or mostly little.
VectorXd excitation_of(int k, Eigen::Index muscles) {
  sample::Draw draw(70000 + static_cast<unsigned>(k));
  VectorXd e = VectorXd::Zero(muscles);
  const bool few = k % 2 == 0, little = k / 2 % 2 == 1;
  for (double& each : e) {
    const double asked = draw.number(0, 1), size = draw.number(0, 1);
    if (few && asked > 0.35) continue;
    each = little ? std::pow(10, -3 * size) : size;
  }
  return e;
}

/// Half a second.
SimulateOptions motion_options() {
  SimulateOptions options;
  options.seconds = 0.5;
  return options;
}

class NetExcitation : public testing::TestWithParam<const char*> {
 protected:
  NetExcitation()
      : subject_(sample::index_finger()),
        tendons_(build_net_tendons(
            subject_, "index", {Path::kViaPoint, Hood::kFloatingNet},
            read_net(THENAR_DATA_DIR "/nets/" + std::string(GetParam()) + ".toml"))) {}

  [[nodiscard]] MotionEnd outcome_of(int k) const {
    const Muscle rung = k / 4 % 2 == 0 ? Muscle::kRigidTendon : Muscle::kBounds;
    const auto contraction =
        build_contraction(musculotendons(subject_, tendons_->digit(), rung), rung);
    const VectorXd excitation = excitation_of(k, 7);
    const std::clock_t start = std::clock();
    const Trajectory path = simulate({*tendons_, *contraction}, constant_excitation(excitation),
                                     {VectorXd::Zero(4), {}, VectorXd::Zero(7)}, motion_options());
    MotionEnd out;
    out.cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    out.status = path.status;
    const bool plain = path.status == MotionStatus::kCompleted && path.snaps.empty();
    out.told = plain || !path.warning.empty();
    out.effort = path.effort;
    out.snaps = static_cast<int>(path.snaps.size());
    for (const MotionSnap& snap : path.snaps)
      out.least_released = std::min(out.least_released, snap.released);
    out.energy_error = path.balance.error / std::max(path.balance.turned_over, 1e-9);
    return out;
  }

  Subject subject_;
  std::unique_ptr<DigitTendons> tendons_;
};

TEST_P(NetExcitation, MovesToTheEndOrSaysWhyNot) {
  const char* wanted = std::getenv("THENAR_EXCITATIONS");
  const int count = wanted ? std::atoi(wanted) : 6;
  Kept kept(GetParam(), wanted != nullptr);
  for (int k = 0; k < count; ++k)
    if (kept.outcomes.count(k) == 0) kept.add(k, outcome_of(k));
  // Verdict on each, and the sum of all.
  const long most = allowed_effort(motion_options());
  int ended = 0, snapped = 0;
  double error = 0, cpu = 0;
  long effort = 0;
  for (int k = 0; k < count; ++k) {
    const MotionEnd& outcome = kept.outcomes[k];
    SCOPED_TRACE(k);
    EXPECT_TRUE(outcome.told);
    EXPECT_LT(outcome.effort, 1.01 * static_cast<double>(most));  // and the search under way
    EXPECT_GE(outcome.least_released, -1e-7);  // of slopes over a step of a snap [J]
    if (outcome.status != MotionStatus::kCompleted) continue;
    ++ended;
    snapped += outcome.snaps > 0 ? 1 : 0;
    error = std::max(error, outcome.energy_error);
    effort = std::max(effort, outcome.effort);
    cpu = std::max(cpu, outcome.cpu);
  }
  fmt::print(
      "{}: {} of {} motions end, {} with snaps; energy of nothing at most {:.2g} of what "
      "was turned over; at most {} evaluations, {:.3g} s of a core\n",
      GetParam(), ended, count, snapped, error, effort, cpu);
  EXPECT_GE(ended, std::floor(0.97 * count));
}

INSTANTIATE_TEST_SUITE_P(Nets, NetExcitation,
                         testing::Values("extensor_hood", "winslow", "dogadov2017", "chao_an"),
                         [](const auto& net) { return std::string(net.param); });

}  // namespace
}  // namespace thenar
