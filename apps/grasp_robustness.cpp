#include "apps/grasp_robustness.h"

#include <cmath>

#include <fmt/format.h>

#include "base/progress_parts.h"
#include "base/units.h"
#include "grasp/closing/approach_sampling.h"
#include "report/answers/grasp_words.h"
#include "report/json.h"

namespace thenar {
namespace {

/// Three normal numbers of standard deviation 1, by Box and Muller.
Eigen::Vector3d draw_normal(std::mt19937& random) {
  Eigen::Vector3d normal;
  for (double& each : normal) {
    const double radius = std::sqrt(-2 * std::log(1 - sample_uniform(random)));
    each = radius * std::cos(2 * kPi * sample_uniform(random));
  }
  return normal;
}

/// The object turned about its centre of mass, and moved. @param turn  axis times angle [rad]
Pose<double> moved(const SceneBody& object, const Eigen::Vector3d& way,
                   const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  const Eigen::Matrix3d R = angle > 0 ? Eigen::Matrix3d(Eigen::AngleAxisd(angle, turn / angle))
                                      : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  const Pose<double> in_body{R, object.com + way - R * object.com};
  return object.X_WB * in_body;
}

/// Counts draws, and stops where it is asked to.
class Watch {
 public:
  Watch(const Progress& progress, int draws) : progress_(progress), all_(2.0 * draws) {}
  void tick() { report_or_stop(progress_, ++done_ / all_, "robustness"); }

 private:
  const Progress& progress_;
  double all_, done_ = 0;
};

/// Null where a miss has part in a quantile.
OrderedJson share_json(const Robustness& found) {
  const auto quantile = [&](double p) {
    const double value = found.quantile(p);
    return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
  };
  return {{"closure", found.closure},
          {"closure_lower", found.closure_lower},
          {"closure_upper", found.closure_upper},
          {"misses", found.misses},
          {"epsilon_5_percent", quantile(0.05)},
          {"epsilon_median", quantile(0.5)},
          {"epsilon_95_percent", quantile(0.95)}};
}

std::string share_words(const Robustness& found) {
  const double median = found.quantile(0.5);
  std::string words =
      fmt::format("force closure in {:.0f} % ({:.0f} to {:.0f} %), median epsilon {}",
                  100 * found.closure, 100 * found.closure_lower, 100 * found.closure_upper,
                  std::isfinite(median) ? fmt::format("{:.3g}", without_rounding(median))
                                        : "none: the hand misses");
  if (found.misses > 0)
    words += fmt::format(", {} of {} draws miss", found.misses, found.epsilon.size());
  return words;
}

}  // namespace

GraspRobustness robustness_of(const GraspQuestion& question, const CollisionHand& touching,
                              const GraspAnswer& answer, const RobustnessQuestion& asked,
                              const Progress& progress) {
  const SceneBody& object = question.scene.object;
  RobustnessOptions options;
  options.draws = asked.draws;
  options.centre = object.com;
  options.torque_scale = object.reach;
  options.limit = question.limit;
  options.gap = question.gap;
  options.edges = question.edges;
  Watch watch(progress, asked.draws);

  const std::vector<Contact> contacts = contacts_without_hand(answer.grasp.contacts);
  std::mt19937 random(asked.seed);
  const Robustness of_contacts = robustness(
      [&](std::mt19937& rng) {
        watch.tick();
        return disturbed(contacts, asked.contacts, rng);
      },
      random, options);

  Scene scene = question.scene;
  random.seed(asked.seed);
  const Robustness of_pose = robustness(
      [&](std::mt19937& rng) {
        watch.tick();
        const Eigen::Vector3d way = asked.place * draw_normal(rng);
        scene.object.X_WB = moved(object, way, asked.turn * draw_normal(rng));
        const Grasp again = regrasp(question, touching, answer, scene);
        return again.outcome == GraspOutcome::kGrasped ? contacts_without_hand(again.contacts)
                                                       : std::vector<Contact>{};
      },
      random, options);
  return {asked, of_contacts, of_pose};
}

OrderedJson robustness_json(const GraspRobustness& robustness) {
  const RobustnessQuestion& asked = robustness.question;
  OrderedJson contacts = share_json(robustness.contacts), pose = share_json(robustness.pose);
  contacts["friction_sd_of_log"] = asked.contacts.friction;
  contacts["place_sd_m"] = asked.contacts.place;
  contacts["tilt_sd_rad"] = asked.contacts.tilt;
  pose["place_sd_m"] = asked.place;
  pose["turn_sd_rad"] = asked.turn;
  return {{"draws", asked.draws}, {"seed", asked.seed}, {"contacts", contacts}, {"pose", pose}};
}

std::vector<MeasureRow> robustness_rows(const GraspRobustness& robustness) {
  const RobustnessQuestion& asked = robustness.question;
  return {
      {"with unsure contacts", share_words(robustness.contacts),
       fmt::format("{} draws of seed {}: friction off by {:.0f} %, places by {:.1f} mm, normals "
                   "by {:.1f} deg",
                   asked.draws, asked.seed, 100 * asked.contacts.friction,
                   1000 * asked.contacts.place, asked.contacts.tilt / kDegree)},
      {"with the object elsewhere", share_words(robustness.pose),
       fmt::format("{} draws of seed {}: moved by {:.1f} mm and turned by {:.1f} deg an axis, "
                   "grasped anew; it yields to jaws, but is not turned flush by them, so that "
                   "flat faces meet along edges or at corners",
                   asked.draws, asked.seed, 1000 * asked.place, asked.turn / kDegree)}};
}

}  // namespace thenar
