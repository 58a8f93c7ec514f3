#include "tendons/net/build_net.h"

#include <algorithm>
#include <optional>

#include <fmt/ranges.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/lists.h"
#include "tendons/net/band_sides.h"
#include "tendons/net/fit_slack.h"
#include "tendons/net/free_digit.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Builds a surface of the description on a finger.
BoneSurface surface_on(const FingerFrame& frame, const NetSurface& plan) {
  // Choose the scale of the cross section: at its place, or the smaller one of a shaft's ends.
  const FingerBone& bone = frame.bone(plan.center.bone);
  const double ratio = plan.shape == SurfaceShape::kCapsule ? std::min(bone.ratio[0], bone.ratio[1])
                                                            : height_ratio(bone, plan.center.along);
  BoneSurface surface;
  surface.name = plan.name;
  surface.link = bone.link;
  surface.shape = plan.shape;
  // Set the size, and axes along or across the bone.
  const double along = plan.across ? ratio : frame.scale;
  surface.size = {plan.radius * ratio, plan.half_length * along, 0};
  const Vector3d flexion = bone.along.cross(bone.dorsal);
  if (plan.across)
    surface.X.R << bone.dorsal, -bone.along, flexion;
  else
    surface.X.R << bone.dorsal, flexion, bone.along;
  surface.X.p = place_position(frame, plan.center);
  return surface;
}

/// Builder of a net: surfaces, nodes, bands and muscles, in this order.
class NetBuilder {
 public:
  NetBuilder(const Subject& subject, const TendonDigit& digit, const NetDescription& plan)
      : subject_(subject), digit_(digit), plan_(plan) {
    // Add the parts in order: each refers to those before it.
    built_.frame = finger_frame(subject, digit, plan);
    built_.net.name = plan.name;
    built_.net.friction = plan.friction;
    for (const NetSurface& surface : plan.surfaces)
      built_.net.surfaces.push_back(surface_on(built_.frame, surface));
    for (const NetNodePlan& node : plan.nodes) add_node(node);
    for (const NetBandPlan& band : plan.bands) add_band(band);
    for (const NetMusclePlan& muscle : plan.muscles) add_role(muscle);
    centre_sides(digit_.skeleton, built_.frame.straight, built_.net);
    // Look up the bands of the slips by name.
    const auto slip = [&](const std::vector<std::string>& names) {
      return transformed(names,
                         [&](const std::string& name) { return place_named(plan.bands, name); });
    };
    built_.central = slip(plan.slips.central);
    built_.radial = slip(plan.slips.radial);
    built_.ulnar = slip(plan.slips.ulnar);
    built_.terminal = slip(plan.slips.terminal);
  }

  /// Returns the result, once.
  BuiltNet take() { return std::move(built_); }

 private:
  /// Returns the point of the first of these strands that the subject has.
  [[nodiscard]] std::optional<PathNode<double>> strand_point(const StrandPoint& at) const {
    const Strand* strand = find_strand(subject_, digit_, at.strands);
    if (strand == nullptr) return std::nullopt;
    const TendonPath<double> points = carried_points(digit_.skeleton, *strand);
    const int n = static_cast<int>(points.size()), k = at.point < 0 ? n + at.point : at.point;
    require(k >= 0 && k < n, "net '{}' asks for point {} of strand '{}', which has {}", plan_.name,
            at.point, strand->name, n);
    return points[k];
  }

  /// Adds a node.
  void add_node(const NetNodePlan& plan) {
    // Choose a point of a strand if the subject has it, otherwise its place on the bone.
    const PathNode<double> at =
        strand_point(plan.strand)
            .value_or(PathNode<double>{built_.frame.bone(plan.place.bone).link,
                                       place_position(built_.frame, plan.place)});
    NetNode node{plan.name, plan.floating, at.link, at.p, {}};
    for (const std::string& surface : plan.surfaces)
      node.surfaces.push_back(place_named(built_.net.surfaces, surface));
    built_.net.nodes.push_back(node);
  }

  /// Computes a direction in the surface's frame, at `angle` about the bone that carries it.
  [[nodiscard]] Vector3d side_on(int surface, double angle) const {
    if (surface < 0) return Vector3d::UnitX();
    const NetSurface& plan = plan_.surfaces[surface];
    return built_.net.surfaces[surface].X.R.transpose() *
           direction_around(built_.frame.bone(plan.center.bone), angle);
  }

  /// Adds a passive band.
  void add_band(const NetBandPlan& plan) {
    NetBand band;
    band.name = plan.name;
    band.a = place_named(built_.net.nodes, plan.from);
    band.b = place_named(built_.net.nodes, plan.to);
    band.over = plan.over.empty() ? -1 : place_named(built_.net.surfaces, plan.over);
    band.side = side_on(band.over, plan.side);
    band.EA = plan.EA;
    band.toe = plan.toe;
    band.max_strain = plan.max_strain;
    built_.net.bands.push_back(band);
  }

  /// Adds all muscles of a role.
  void add_role(const NetMusclePlan& role) {
    const std::vector<std::string> muscles = muscles_of(digit_, role);
    require(role.optional || !muscles.empty(),
            "net '{}' needs muscle '{}' ({}), and none crosses the {} of '{}'", plan_.name,
            role.role, fmt::join(role.names, ", "), digit_.skeleton.tips.front().digit,
            subject_.name);
    for (const std::string& muscle : muscles) add_muscle(role, muscle);
  }

  /// Returns whether the link is this bone's, or nearer to the base.
  [[nodiscard]] bool is_proximal_to(int link, const FingerBone& bone) const {
    for (int i = bone.link; i >= 0; i = digit_.skeleton.tree[i].parent)
      if (i == link) return true;
    return link < 0;
  }

  /// Builds a muscle's path outside the net, from its first point on the bone or nearer to the
  /// wrist.
  [[nodiscard]] TendonPath<double> own_path(const NetMusclePlan& role,
                                            const std::string& muscle) const {
    // Start at the exit if the description places it.
    const Strand& strand = pulled_strand(subject_, muscle);
    const FingerBone& bone = built_.frame.bone(role.exit);
    TendonPath<double> path;
    const NetPullPlan& first = role.pulls.front();
    const bool place = first.exit_place && first.exit.strands.empty();
    if (place) {  // the strand's points on that bone are then left out
      path.push_back(exit_of(first));
    }
    // Append points of its strand from there towards the wrist.
    for (const PathNode<double>& point : carried_points(digit_.skeleton, strand))
      if ((!path.empty() || is_proximal_to(point.link, bone)) &&
          !(place && (point.link == bone.link || !is_proximal_to(point.link, bone))))
        path.push_back(point);
    require(!path.empty(),
            "net '{}' needs a point of strand '{}' of subject '{}' on segment '{}' or nearer to "
            "the wrist",
            plan_.name, strand.name, subject_.name, bone.segment);
    return path;
  }

  /// Returns the share of a muscle that enters the hood, by the subject or by the description.
  [[nodiscard]] double share_of(const NetMusclePlan& role, const std::string& muscle,
                                double stated) const {
    // Prefer the hood of the subject where the description allows it.
    for (const Digit& d : subject_.digits)
      if (role.hood_share && d.hood && d.name == digit_.skeleton.tips.front().digit)
        for (const HoodBranch& branch : d.hood->branches)
          if (branch.muscle == muscle) return branch.into_hood;
    return stated;
  }

  /// Adds a muscle with all its pulls.
  void add_muscle(const NetMusclePlan& role, const std::string& muscle) {
    // Sum the stated shares, without pulls that others relay.
    double stated = 0;
    for (const NetPullPlan& pull : role.pulls) stated += pull.relayed ? 0 : pull.share;
    const int m = place_in(digit_.names.muscles, muscle);
    const double to_net = share_of(role, muscle, stated);
    // Leave out a muscle that does not enter the net.
    if (to_net <= 0) return;
    built_.muscles.push_back({m, to_net, own_path(role, muscle)});
    // Divide its share among its pulls as described.
    for (std::size_t k = 0; k < role.pulls.size(); ++k)
      add_pull(role.pulls[k], m, role.pulls[k].share / stated * to_net,
               role.pulls.size() == 1 ? muscle : fmt::format("{}/{}", muscle, k + 1));
  }

  /// Returns the exit of a pull without a strand point: its own place, or the end of the muscle's
  /// path.
  [[nodiscard]] PathNode<double> exit_of(const NetPullPlan& plan) const {
    if (plan.exit_place)
      return {built_.frame.bone(plan.exit_place->bone).link,
              place_position(built_.frame, *plan.exit_place)};
    return built_.muscles.back().own_path.front();
  }

  /// Adds a pull: a band from a node to the exit.
  void add_pull(const NetPullPlan& plan, int muscle, double share, const std::string& name) {
    Net& net = built_.net;
    // Place a fixed node at the exit as the muscle's end of the band.
    const PathNode<double> exit = strand_point(plan.exit).value_or(exit_of(plan));
    NetBand band;
    band.name = name;
    band.a = place_named(net.nodes, plan.node);
    band.b = static_cast<int>(net.nodes.size());
    band.over = plan.over.empty() ? -1 : place_named(net.surfaces, plan.over);
    band.side = side_on(band.over, 0);
    band.EA = plan.EA;
    band.muscle = static_cast<int>(net.muscles.size());
    net.nodes.push_back({"exit " + name, false, exit.link, exit.p, {}});
    net.bands.push_back(band);
    net.muscles.push_back(name);
    built_.pulls.push_back({muscle, share});
  }

  const Subject& subject_;
  const TendonDigit& digit_;
  const NetDescription& plan_;
  BuiltNet built_;
};

/// Computes the length of each described band in the reference finger [m].
std::vector<double> reference_lengths(const NetDescription& plan) {
  // Build the same parts on the reference finger.
  const FingerFrame frame = reference_finger(plan);
  Net net;
  for (const NetSurface& surface : plan.surfaces)
    net.surfaces.push_back(surface_on(frame, surface));
  for (const NetNodePlan& node : plan.nodes)
    net.nodes.push_back({node.name, false, -1, place_position(frame, node.place), {}});
  for (const NetBandPlan& band : plan.bands) {
    const int over = band.over.empty() ? -1 : place_named(net.surfaces, band.over);
    net.bands.push_back({band.name, place_named(net.nodes, band.from),
                         place_named(net.nodes, band.to), over, Vector3d::UnitX()});
  }
  return start_lengths(net, {});
}

/// Returns the description with straight bands.
NetDescription straightened(NetDescription plan) {
  for (NetBandPlan& band : plan.bands) band.over.clear();
  for (NetMusclePlan& muscle : plan.muscles)
    for (NetPullPlan& pull : muscle.pulls) pull.over.clear();
  return plan;
}

// Largest tension of a band over the sum of pulls, our choice; a larger one means that a locked-in
// strain, not a muscle, loads the band [1]
constexpr double kMaxLoadRatio = 3;
// Largest strain error of fitted bands: 0.1 um for a band of 10 mm [1]
constexpr double kMaxSlackStrainError = 1e-5;

/// Returns the index of a named part. @throws InputError listing the parts of the net
}  // namespace

// NOLINTNEXTLINE(misc-no-recursion): one level, for straight lines
BuiltNet build_net(const Subject& subject, const TendonDigit& digit,
                   const NetDescription& description, const NetBuildOptions& options) {
  // Check the options.
  require(options.taut_load > 0, "taut_load must be > 0, got {}", options.taut_load);
  require(options.prestrain >= 0 && options.prestrain < 1, "prestrain must be in 0..1, got {}",
          options.prestrain);
  // Build straight bands from a description without surfaces to bend over.
  if (options.paths == NetPaths::kStraightLines) {
    NetBuildOptions bent = options;
    bent.paths = NetPaths::kWrapped;
    return build_net(subject, digit, straightened(description), bent);
  }
  // Build the parts, and measure the bands in the straight finger and the reference finger.
  const TendonDigit whole = free_digit(subject, digit);
  BuiltNet built = NetBuilder(subject, whole, description).take();
  const TreeState<double> straight = pose_tree(whole.model.tree, built.frame.straight);
  const std::vector<double> here = start_lengths(built.net, straight);
  const std::vector<double> there = reference_lengths(description);
  // Scale stated slack lengths with the finger, and list the others for fitting.
  std::vector<FittedBand> fitted;
  for (std::size_t b = 0; b < description.bands.size(); ++b) {
    NetBand& band = built.net.bands[b];
    const bool stated = options.slack == NetSlack::kStated && description.bands[b].slack > 0;
    if (!stated)
      fitted.push_back(
          {static_cast<int>(b), place_named(description.bands, description.bands[b].strains_like)});
    band.slack = stated ? description.bands[b].slack * here[b] / there[b]
                        : here[b] / (1 + options.prestrain);
  }
  // Fit slack lengths under an even load of the muscles.
  Eigen::VectorXd load(built.net.muscles.size());
  for (Eigen::Index p = 0; p < load.size(); ++p) load[p] = options.taut_load * built.pulls[p].share;
  const double off = fit_slack(built.net, straight, load, fitted);
  require(off < kMaxSlackStrainError,
          "slack lengths of net '{}' could not be fitted to the finger of '{}': strains differ "
          "by {:.2g} in the straight finger",
          description.name, subject.name, off);
  built.net.max_load = kMaxLoadRatio;
  return transferred(std::move(built), whole, digit);
}

BuiltNet cut(const BuiltNet& built, const std::string& band) {
  // Check that the band is passive.
  const int gone = band_index(built.net, band);
  require(built.net.bands[gone].muscle < 0, "band '{}' is a muscle's: give it no tension instead",
          band);
  // Remove the band, and shift the indices of the slips.
  BuiltNet left = built;
  left.net.bands.erase(left.net.bands.begin() + gone);
  for (std::vector<int>* slip : {&left.central, &left.radial, &left.ulnar, &left.terminal}) {
    erase_where(*slip, [&](int b) { return b == gone; });
    for (int& b : *slip) b -= b > gone ? 1 : 0;
  }
  return left;
}

int band_index(const Net& net, const std::string& name) {
  const int found = place_named(net.bands, name);
  require(found >= 0, "net '{}' has no band '{}'; there are {}", net.name, name,
          fmt::join(names_of(net.bands), ", "));
  return found;
}

}  // namespace thenar
