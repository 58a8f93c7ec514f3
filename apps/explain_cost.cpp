// What each rung and each question costs, measured on the spot.

#include <cmath>

#include "apps/explanation.h"
#include "apps/median_time.h"
#include "base/error.h"
#include "tendons/forces/feasible_force_set.h"
#include "tendons/forces/max_tip_force.h"
#include "tendons/forces/tip_force.h"
#include "tendons/forces/tip_wrench.h"

namespace thenar {
namespace {

/// The middle of every joint's range: no joint is straight there by chance.
Eigen::VectorXd middle(const TendonDigit& digit) {
  Eigen::VectorXd q(digit.model.coordinates);
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const CoordinateLimits& limits = digit.skeleton.limits[static_cast<std::size_t>(i)];
    q[i] = 0.5 * (limits.lower + limits.upper);
  }
  return q;
}

class Clocked {
 public:
  template <typename Call>
  void add(const std::string& what, const std::string& rungs, Call call) {
    const double seconds = median_seconds(call);
    section_.table.rows.push_back({what, rungs, shown(1e6 * seconds), shown(1 / seconds)});
  }

  Section take() { return std::move(section_); }

 private:
  Section section_{"cost",
                   "Cost of one evaluation: medians, one thread, this machine, now",
                   {},
                   {{"question", "rung", "median_us", "per_second"}, {}}};
};

/// Statics by the rung of paths and hood; rungs that the subject has no data for are left out.
void add_rungs(const Subject& subject, const std::string& name, Clocked& clocked) {
  for (const Path path : {Path::kConstant, Path::kViaPoint})
    for (const Hood hood : {Hood::kSeparate, Hood::kFractions}) try {
        const TendonDigit digit = build_tendon_digit(subject, name, {path, hood, {}});
        const bool asked = digit.fidelity.path == path && digit.fidelity.hood == hood;
        if (!asked || digit.names.muscles.empty()) continue;
        const Eigen::VectorXd q = middle(digit);
        const std::vector<RungWords> rungs = explain(digit.fidelity);
        clocked.add("Jacobians and moment arms", rungs[2].rung + ", " + rungs[3].rung,
                    [&] { keep(tip_statics(digit, q)); });
      } catch (const InputError&) {
        continue;  // the subject lacks what this rung needs
      }
}

}  // namespace

Section explain_cost(const Subject& subject, const std::string& name, const TendonDigit& built) {
  const Eigen::VectorXd q = middle(built);
  Clocked clocked;
  clocked.add("pose of every link", "posed", [&] { keep(pose_tree(built.model.tree, q)); });
  add_rungs(subject, name, clocked);
  if (built.names.muscles.empty()) return clocked.take();

  const TipStatics statics = tip_statics(built, q);
  const Eigen::VectorXd t = Eigen::VectorXd::Ones(statics.R.rows());  // [N]
  clocked.add("tip force, pinned", "static", [&] { keep(tip_force(statics, t)); });
  clocked.add("tip wrench, rigid", "static", [&] { keep(tip_wrench(statics, t)); });
  if (statics.max_tension.allFinite()) {
    clocked.add("largest force one way", "static, force bounds",
                [&] { keep(max_tip_force(statics, Eigen::Vector3d::UnitX())); });
    clocked.add("all feasible forces", "static, force bounds",
                [&] { keep(feasible_force_set(statics)); });
  }
  clocked.add("building the digit", "as above", [&] { keep(build_tendon_digit(subject, name)); });
  return clocked.take();
}

}  // namespace thenar
