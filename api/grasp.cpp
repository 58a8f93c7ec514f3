#include "api/grasp.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/progress_parts.h"
#include "base/units.h"
#include "grasp/closing/approach_sampling.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/describe_grasp.h"
#include "grasp/contact/friction_pyramid.h"

namespace thenar {
namespace {

/// Approximate durations of the parts of a grasp by a human hand [s]; other hands take less.
constexpr double kHandTime = 3, kStartTime = 0.3, kMeasuresTime = 0.6, kDrawTime = 0.2;
constexpr int kMaxEdges = 100;  // finer ones change nothing and take seconds that no signal ends

double seconds_of(const GraspRequest& request) {
  return kHandTime + kStartTime * std::max(1, request.starts) + kMeasuresTime +
         kDrawTime * request.robustness.draws;
}

void check_request(const GraspRequest& request) {
  require_field("tolerance", request.tolerance > 0, "wanted a tolerance of epsilon above 0, got {}",
                request.tolerance);
  require_field("approach_distance", request.approach_distance > 0,
                "wanted an approach distance above 0 m, got {}", request.approach_distance);
  require_field("starts", request.starts >= 0, "wanted 0 or more random starts, got {}",
                request.starts);
  require_field("robustness", request.robustness.draws >= 0,
                "wanted 0 or more draws of robustness, got {}", request.robustness.draws);
  // Zero edges mean exact cones; a pyramid has at least three.
  require_field("edges", request.edges == 0 || (request.edges >= 3 && request.edges <= kMaxEdges),
                "wanted 0 edges of friction pyramids (cones), or 3 to {}, got {}", kMaxEdges,
                request.edges);
  require_field("approach", request.approach || request.starts == 0,
                "random starts are clear of the object: they want the approach");
}

/// The world and its hand, which of random starts may be any hand.
WorldCase open_setting(const GraspRequest& request, const Progress& progress) {
  const bool from_elsewhere =
      !request.world.hand.empty() && request.starts > 0 && !has_hand(request.world);
  WorldCase setting = open_world(request.world, from_elsewhere, progress);
  const NamedHand& hand = setting.hand.named;
  require_field("hand", !hand.hand->surfaces().empty(), "hand '{}' has no surface that could touch",
                hand.name);
  require_field("starts", setting.hand.parts.size() <= 1 || request.starts == 0,
                "hand '{}' is mounted: it cannot start anywhere", hand.name);
  return setting;
}

GraspOptions options_of(const GraspResult& result) {
  GraspOptions options;
  options.pads.contact = result.setting.hand.named.contact;
  options.epsilon.limit = result.request.limit;
  options.epsilon.gap = result.request.tolerance;
  options.close.rates = result.setting.hand.named.rates;
  return options;
}

/// Wrenches of contacts, with cones or pyramids.
WrenchSet wrenches_of(const GraspResult& result, const std::vector<HandContact>& contacts) {
  const GraspBody& object = result.setting.setup.object;
  const WrenchSet set =
      wrench_set(contacts_without_hand(contacts), object.com, object.torque_scale);
  return result.request.edges > 0 ? friction_pyramids(set, result.request.edges) : set;
}

// ---- starts

/// Orders grasps: force closures first, then by falling epsilon.
bool is_better(const Grasp& a, const Grasp& b) {
  const bool has = a.outcome == GraspOutcome::kGrasped, had = b.outcome == GraspOutcome::kGrasped;
  return has != had ? has : has && a.quality.lower > b.quality.lower;
}

Grasp grasp_from(const GraspResult& result, const Pregrasp& start) {
  // Close the hand in place if there is no approach.
  const GraspOptions options = options_of(result);
  const GraspSetup& setup = result.setting.setup;
  GraspOptions here = options;
  here.approach_distance = 0;
  Grasp found = start.approach_distance > 0
                    ? attempt_grasp(result.collision_hand, start, setup, options)
                    : grasp(result.collision_hand, start.X_WH, start.q, setup, here);
  // Pyramids replace the cones in epsilon only: the hand closes by exact cones.
  if (result.request.edges > 0 && found.outcome == GraspOutcome::kGrasped)
    found.quality = epsilon(wrenches_of(result, found.contacts), options.epsilon);
  return found;
}

/// Rank of a grasp, lowest first. Grippers that are sent at a ball should hold it between their
/// tips: a pinch of all tips ranks above a force closure by inner links, such as bars.
enum class Standing {
  kNothing,
  kTouched,        // touched by two digits
  kHeld,           // held between two hard points
  kHeldByInner,    // held in force closure by links that are not fingertips
  kHeldByAllTips,  // held between two hard points by all fingertips
  kHeldByTips      // in force closure
};

Standing standing_of(const Hand& hand, const Grasp& grasp) {
  if (grasp.outcome != GraspOutcome::kGrasped) return Standing::kNothing;
  const std::size_t tips = touching_tips(hand, grasp.contacts).size();
  if (grasp.quality.force_closure) return tips > 0 ? Standing::kHeldByTips : Standing::kHeldByInner;
  if (is_held_between_two(grasp.contacts))
    return tips == hand.layout().tips.size() ? Standing::kHeldByAllTips : Standing::kHeld;
  return touching_digits(hand, grasp.contacts).size() > 1 ? Standing::kTouched : Standing::kNothing;
}

/// A start and what came of it.
struct TriedStart {
  Pregrasp start;
  Grasp grasp;
};

/// The grasp from the palm, or, where that holds nothing by fingertips, from farther off if it does
/// there: fingers that are coupled stop as soon as their first link touches, and short ones reach
/// round nothing.
TriedStart own_or_off(const GraspResult& result, const Pregrasp& own) {
  // Begin with the palm as near as it comes to the object.
  const Hand& hand = *result.collision_hand.hand;
  TriedStart best{own, grasp_from(result, own)};
  if (!best.grasp.approached.touches) return best;
  // Stand off farther, step by step, and keep the nearest that holds better.
  Standing standing = standing_of(hand, best.grasp);
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    if (standing == Standing::kHeldByTips) break;
    Pregrasp off = own;
    off.stand_off = share;
    Grasp found = grasp_from(result, off);
    const Standing here = standing_of(hand, found);
    if (here > standing) best = {off, std::move(found)}, standing = here;
  }
  return best;
}

/// Counts a start, and keeps its grasp if it is the best so far.
/// @param number  of a random start; absent: the world's own
void note(GraspResult& result, Grasp grasp, std::optional<int> number, const Pregrasp& start) {
  ++result.outcomes[static_cast<std::size_t>(grasp.outcome)];
  result.closures += grasp.outcome == GraspOutcome::kGrasped && grasp.quality.force_closure ? 1 : 0;
  if (number.value_or(0) > 0 && !is_better(grasp, result.grasp)) return;
  result.grasp = std::move(grasp);
  result.best = number;
  result.start = start;
}

void add_grasps(GraspResult& result, const Progress& progress) {
  // Without random starts the hand closes from where the world puts it.
  const GraspRequest& request = result.request;
  const WorldHand& hand = result.setting.hand;
  if (request.starts == 0) {
    report_or_stop(progress, 0, "closing the hand");
    const bool goes = request.approach && hand.parts.size() <= 1;  // an arm's foot does not fly
    const Pregrasp own{hand.X_WH, hand.q, goes ? request.approach_distance : 0};
    TriedStart tried = goes ? own_or_off(result, own) : TriedStart{own, grasp_from(result, own)};
    note(result, std::move(tried.grasp), {}, tried.start);
  }
  // Otherwise try random starts, at least one of them even where progress says stop, and keep the
  // best.
  for (int i = 0; i < request.starts && (i == 0 || !progress.stop()); ++i) {
    report_or_stop(progress, static_cast<double>(i) / request.starts,
                   fmt::format("start {} of {}", i + 1, request.starts));
    const Pregrasp drawn =
        sample_pregrasp(result.collision_hand, result.setting.setup.object, request.seed, i);
    note(result, grasp_from(result, drawn), i, drawn);
  }
  // Wrenches are those of the best grasp.
  result.wrenches = wrenches_of(result, result.grasp.contacts);
}

// ---- robustness

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
Pose<double> moved(const GraspBody& object, const Eigen::Vector3d& by,
                   const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  const Eigen::Matrix3d R = angle > 0 ? Eigen::Matrix3d(Eigen::AngleAxisd(angle, turn / angle))
                                      : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  const Pose<double> in_body{R, object.com + by - R * object.com};
  return object.X_WB * in_body;
}

RobustnessOptions robustness_options(const GraspResult& result) {
  const GraspBody& object = result.setting.setup.object;
  RobustnessOptions options;
  options.draws = result.request.robustness.draws;
  options.centre = object.com;
  options.torque_scale = object.torque_scale;
  options.limit = result.request.limit;
  options.gap = result.request.tolerance;
  options.edges = result.request.edges;
  return options;
}

/// Measures both parts of robustness, each from a generator of the seed. @throws Stopped where
/// progress says stop
GraspRobustness robustness_of(const GraspResult& result, const Progress& progress) {
  const RobustnessRequest& asked = result.request.robustness;
  const RobustnessOptions options = robustness_options(result);
  int done = 0;
  const auto tick = [&] { report_or_stop(progress, ++done / (2.0 * asked.draws), "robustness"); };
  // The same contacts with other friction, places and normals.
  const std::vector<Contact> contacts = contacts_without_hand(result.grasp.contacts);
  std::mt19937 random(result.request.seed);
  Robustness of_contacts = robustness(
      [&](std::mt19937& rng) {
        tick();
        return disturb_contacts(contacts, asked.contacts, rng);
      },
      random, options);
  // Displace the object and grasp it again from the same start, also without an approach.
  GraspSetup setup = result.setting.setup;
  random.seed(result.request.seed);
  Robustness of_pose = robustness(
      [&](std::mt19937& rng) {
        tick();
        const Eigen::Vector3d by = asked.place * draw_normal(rng);
        setup.object.X_WB = moved(result.setting.setup.object, by, asked.turn * draw_normal(rng));
        const Grasp again =
            attempt_grasp(result.collision_hand, result.start, setup, options_of(result));
        return again.outcome == GraspOutcome::kGrasped ? contacts_without_hand(again.contacts)
                                                       : std::vector<Contact>{};
      },
      random, options);
  return {std::move(of_contacts), std::move(of_pose)};
}

// ---- warnings

/// Returns true if a hand that has a thumb holds the object without the thumb.
bool thumb_is_idle(const Hand& hand, const Grasp& grasp) {
  const std::vector<std::string>& tips = hand.layout().tips;
  if (grasp.outcome != GraspOutcome::kGrasped || !contains(tips, "thumb")) return false;
  return !any_of(grasp.contacts, [&](const HandContact& contact) {
    return hand.surfaces()[static_cast<std::size_t>(contact.surface)].digit == "thumb";
  });
}

/// Returns true if the object touches a surface that belongs to no digit.
bool palm_touches(const GraspResult& result) {
  const std::vector<LinkSurface>& surfaces = result.collision_hand.hand->surfaces();
  return any_of(result.grasp.contacts, [&](const HandContact& contact) {
    return surfaces[static_cast<std::size_t>(contact.surface)].digit.empty();
  });
}

/// Loads and efforts are no better than what the hand says of its torques; empty if that is good.
std::string torque_warning(const Hand& hand, const Grasp& grasp) {
  if (grasp.outcome != GraspOutcome::kGrasped) return "";
  const Actuation here = hand.actuation(grasp.closed.q);
  if (here.status < ActuationStatus::kDoubtful) return "";
  return fmt::format(
      "the joint torques of this posture, and the loads and efforts that follow from them, {}: {}",
      here.status == ActuationStatus::kDoubtful ? "are doubtful" : "must not be used",
      here.warning);
}

void add_measures(GraspResult& result, ProgressParts& schedule) {
  if (result.grasp.outcome != GraspOutcome::kGrasped) return;
  result.measures = grasp_measures_of(result, schedule.next(kMeasuresTime));
  const int draws = result.request.robustness.draws;
  if (draws > 0) result.robustness = robustness_of(result, schedule.next(kDrawTime * draws));
}

}  // namespace

int GraspResult::started() const { return std::accumulate(outcomes.begin(), outcomes.end(), 0); }

GraspResult measure_grasp(const GraspRequest& request, const Progress& progress) {
  check_request(request);
  ProgressParts schedule(progress, seconds_of(request));
  // Build the hand, place the object and resolve the materials of both.
  GraspResult result{};
  result.request = request;
  result.setting = open_setting(request, schedule.next(kHandTime));
  result.collision_hand =
      collision_hand(*result.setting.hand.named.hand, result.setting.setup.materials);
  const std::clock_t start = std::clock();
  // The grasp itself: without one there is nothing to return.
  add_grasps(result, schedule.next(kStartTime * std::max(1, request.starts)));
  require(result.grasp.outcome != GraspOutcome::kOverlaps, "{}: {}", result.setting.path,
          describe_outcome(result.grasp));
  // Its measures, as far as they get.
  try {
    add_measures(result, schedule);
  } catch (const Stopped&) {
    result.outcome.status = Status::kStopped;
  }
  // Count the starts that were tried, for the progress of a stopped request.
  result.outcome.count_parts(static_cast<std::size_t>(result.started()),
                             static_cast<std::size_t>(std::max(1, request.starts)), "start");
  result.cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  result.outcome.warnings = grasp_warnings(result);
  return result;
}

std::vector<std::string> grasp_warnings(const GraspResult& result) {
  const NamedHand& hand = result.setting.hand.named;
  std::vector<std::string> warnings = hand.warnings;
  // Warn of torques beyond the motors, of a hand that overlaps itself and of a thumb that is idle.
  if (const std::string torques = torque_warning(*hand.hand, result.grasp); !torques.empty())
    warnings.push_back(torques);
  if (const std::string own = describe_self_overlaps(result.grasp.closed); !own.empty())
    warnings.insert(warnings.begin(), own);
  if (!result.best && result.start.stand_off > 0)
    warnings.push_back(fmt::format(
        "with the palm on the object fingertips did not hold it: the hand moved back before it "
        "closed, by {:.0f} % of the way to where its tips still close beyond the object's centre",
        100 * result.start.stand_off));
  if (thumb_is_idle(*hand.hand, result.grasp))
    warnings.emplace_back(
        result.grasp.quality.force_closure && palm_touches(result)
            ? "the thumb touches nothing: fingers hold the object against the palm"
            : "the thumb touches nothing");
  return warnings;
}

WorldSpec grasped_world(const GraspResult& result) {
  // Only a grasp that holds is worth a world of its own.
  require(result.grasp.outcome == GraspOutcome::kGrasped, "{}; there is no grasp to save",
          describe_outcome(result.grasp));
  const WorldHand& hand = result.setting.hand;
  const Pose<double>& X_WH = result.grasp.approached.X_WH;
  const Eigen::VectorXd& q = result.grasp.closed.q;
  // Write the closed posture into a copy of the world.
  WorldSpec world = result.setting.world;
  // A hand from elsewhere takes the place of those of the world.
  if (hand.parts.empty()) {
    PlacedHand placed{hand.named.name, "", X_WH, {}, "", ""};
    const std::vector<std::string>& names = hand.named.hand->layout().coordinates;
    for (std::size_t c = 0; c < names.size(); ++c)
      placed.posture[names[c]] = q[static_cast<Eigen::Index>(c)];
    world.hands = {placed};
  }
  return with_hand_at(std::move(world), hand, X_WH, q);
}

}  // namespace thenar
