#include "grasp/quality/robustness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/spatial.h"
#include "base/special_functions.h"
#include "base/stop_scope.h"
#include "base/units.h"
#include "grasp/contact/contact.h"
#include "grasp/contact/friction_pyramid.h"
#include "grasp/quality/epsilon.h"

namespace thenar {
namespace {

/// Returns a random number uniform in the open interval (0, 1).
double uniform(std::mt19937& rng) { return (static_cast<double>(rng()) + 0.5) / 4294967296.0; }

/// Returns a standard normal random number by Box and Muller, identical on every platform.
double normal(std::mt19937& rng) {
  const double radius = std::sqrt(-2 * std::log(uniform(rng)));
  return radius * std::cos(2 * kPi * uniform(rng));
}

/// Random disturbance of all points of a region.
struct Disturbance {
  double friction_factor = 1;                       // factor of friction and torsion [1]
  Eigen::Vector3d displacement{0, 0, 0};            // [m] (3)
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // rotation of normals (3, 3)
};

/// Draws a disturbance. @param n  mean normal of the region, unit (3)
Disturbance draw_disturbance(const Eigen::Vector3d& n, const ContactUncertainty& uncertainty,
                             std::mt19937& rng) {
  // Log-normal friction.
  const Tangents t = tangents(n);
  Disturbance drawn;
  drawn.friction_factor = std::exp(uncertainty.friction * normal(rng));
  // Displacement in the tangent plane.
  const double right = normal(rng), up = normal(rng);
  drawn.displacement = uncertainty.position * (right * t.e1 + up * t.e2);
  // Small rotation of the normal about the tangents.
  const double about_e1 = normal(rng), about_e2 = normal(rng);
  const Eigen::Vector3d turn = uncertainty.tilt * (about_e1 * t.e1 + about_e2 * t.e2);
  const double angle = turn.norm();
  drawn.R = Eigen::Matrix3d::Identity();
  if (angle > 0) drawn.R = rotation_about<double>(turn / angle, angle);
  return drawn;
}

Contact disturb_contact(Contact contact, const Disturbance& by) {
  contact.friction *= by.friction_factor;
  contact.torsion *= by.friction_factor;
  contact.p += by.displacement;
  contact.n = (by.R * contact.n).normalized();
  return contact;
}

}  // namespace

std::vector<Contact> disturb_contacts(const std::vector<Contact>& contacts,
                                      const ContactUncertainty& uncertainty, std::mt19937& rng) {
  require(uncertainty.friction >= 0 && uncertainty.position >= 0 && uncertainty.tilt >= 0,
          "standard deviations must be >= 0, got {}, {}, {}", uncertainty.friction,
          uncertainty.position, uncertainty.tilt);
  // Mean normal of each region.
  const std::vector<int> region = contact_regions(contacts);
  std::vector<Eigen::Vector3d> normals;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto number = static_cast<std::size_t>(region[i]);
    if (number == normals.size()) normals.emplace_back(0, 0, 0);
    normals[number] += contacts[i].n;
  }
  // Apply one disturbance to all points of a region.
  std::vector<Disturbance> drawn;
  drawn.reserve(normals.size());
  for (const Eigen::Vector3d& sum : normals)
    drawn.push_back(draw_disturbance(sum.normalized(), uncertainty, rng));
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    result.push_back(disturb_contact(contacts[i], drawn[region[i]]));
  return result;
}

ConfidenceInterval wilson_interval(int hits, int trials) {
  require(trials > 0 && hits >= 0 && hits <= trials, "{} hits in {} trials", hits, trials);
  const double n = trials, p = hits / n, z2 = kNormal95HalfWidth * kNormal95HalfWidth;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half =
      kNormal95HalfWidth / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  return {hits == 0 ? 0 : middle - half, hits == trials ? 1 : middle + half};
}

double fisher_exact_p(const HitCount& a, const HitCount& b) {
  for (const HitCount& each : {a, b})
    require(each.trials > 0 && each.hits >= 0 && each.hits <= each.trials, "{} hits in {} trials",
            each.hits, each.trials);
  // Logarithms of the hypergeometric distribution, up to a constant.
  const int hits = a.hits + b.hits;
  const auto weight = [&](int of_a) {
    const int of_b = hits - of_a;
    return -std::lgamma(of_a + 1.0) - std::lgamma(a.trials - of_a + 1.0) - std::lgamma(of_b + 1.0) -
           std::lgamma(b.trials - of_b + 1.0);
  };
  // Equal probabilities may differ by rounding errors.
  constexpr double kEqualShare = 1e-9;
  const double found = weight(a.hits);
  double all = 0, unlikely = 0;
  for (int of_a = std::max(0, hits - b.trials); of_a <= std::min(hits, a.trials); ++of_a) {
    const double each = weight(of_a) - found;
    all += std::exp(each);
    if (each <= kEqualShare) unlikely += std::exp(each);
  }
  return unlikely / all;
}

double Robustness::quantile(double p) const {
  // Linear interpolation between order statistics; misses count as -infinity.
  require(p >= 0 && p <= 1, "a quantile is in [0, 1], got {}", p);
  const double at = p * static_cast<double>(epsilon.size() - 1);
  const auto below = static_cast<Eigen::Index>(at);
  const Eigen::Index above = std::min(below + 1, epsilon.size() - 1);
  if (std::isinf(epsilon(below))) return epsilon(below);
  return epsilon(below) + (at - static_cast<double>(below)) * (epsilon(above) - epsilon(below));
}

Robustness robustness(const std::function<std::vector<Contact>(std::mt19937&)>& draw,
                      std::mt19937& rng, const RobustnessOptions& options) {
  require(options.draws > 0, "wanted one draw or more, got {}", options.draws);
  EpsilonOptions each;
  each.gap = options.gap;
  each.limit = options.limit;
  Robustness result{0, 0, 0, Eigen::VectorXd(options.draws)};
  int closed = 0;
  for (int i = 0; i < options.draws; ++i) {
    // One possible grasp; without contacts it is a miss.
    end_if_stopped();
    const std::vector<Contact> contacts = draw(rng);
    if (contacts.empty()) {
      ++result.misses;
      result.epsilon(i) = -std::numeric_limits<double>::infinity();
      continue;
    }
    // Epsilon on cones or pyramids.
    const WrenchSet set = wrench_set(contacts, options.centre, options.torque_scale);
    const Epsilon found =
        epsilon(options.edges > 0 ? friction_pyramids(set, options.edges) : set, each);
    closed += found.force_closure ? 1 : 0;
    result.epsilon(i) = found.lower;
  }
  std::sort(result.epsilon.begin(), result.epsilon.end());
  const ConfidenceInterval interval = wilson_interval(closed, options.draws);
  result.closure = static_cast<double>(closed) / options.draws;
  result.closure_lower = interval.lower;
  result.closure_upper = interval.upper;
  return result;
}

}  // namespace thenar
