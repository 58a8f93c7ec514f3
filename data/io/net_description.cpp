#include "data/io/net_description.h"

#include <cmath>

#include "data/io/subject_parts.h"

namespace thenar {
namespace {

using internal::check_reference;
using internal::new_name;
using internal::reference;

/// Fraction of a bone's length, at most one length beyond either end: farther off lie other bones.
double read_along(TomlTable& table) {
  const double along = table.number(Dimension::kNumber, "along");
  if (along < -1 || along > 2)
    table.fail(fmt::format("wanted 'along' in -1..2 bone lengths, got {}", along), "along");
  return along;
}

NetPlace read_place(TomlTable& table) {
  NetPlace place;
  place.bone = table.choice("bone", kBoneRoleNames);
  place.along = read_along(table);
  place.angle = table.number_or(Dimension::kAngle, "angle", 0);
  place.height = table.number(Dimension::kLength, "height", Range::kNotNegative);
  return place;
}

StrandPoint read_strand_point(TomlTable& table) {
  StrandPoint at;
  at.strands = table.texts("strand");
  // Points are counted in whole numbers.
  const double point = table.number(Dimension::kNumber, "point");
  if (point != std::floor(point) || std::abs(point) > 1e6)
    table.fail(fmt::format("wanted 'point' to be a whole number, got {}", point), "point");
  at.point = static_cast<int>(point);
  return at;
}

void read_reference(TomlTable& top, NetDescription& net) {
  // Bone lengths and heights of the reference finger.
  TomlTable bones =
      needed_table(top, "bone_lengths", "wanted a table [bone_lengths] of the reference finger");
  for (const auto& [bone, name] : kBoneRoleNames)
    net.bone_length[bone] = bones.number(Dimension::kLength, name, Range::kPositive);
  bones.done();
  TomlTable heights = needed_table(top, "extensor_heights",
                                   "wanted a table [extensor_heights] of the reference finger");
  for (const auto& [joint, name] : kFingerJointNames)
    net.height[joint] = heights.number(Dimension::kLength, name, Range::kPositive);
  heights.done();
  // Strands whose moment arms give the heights in a subject.
  std::optional<TomlTable> strands = top.table("height_strands");
  if (!strands) return;
  for (const auto& [joint, name] : kFingerJointNames)
    if (strands->has(name)) net.height_strands[joint] = strands->texts(name);
  strands->done();
}

NetSurface read_surface(TomlTable& table, const NetDescription& net) {
  NetSurface surface;
  // Name and shape.
  surface.name = new_name(table, names_of(net.surfaces));
  const std::string shape = table.choice("shape", {"sphere", "cylinder", "capsule"});
  surface.shape = value_in(kSurfaceShapeNames, shape, "shape");
  // Place on its bone, and sizes.
  surface.center.bone = table.choice("bone", kBoneRoleNames);
  surface.center.along = read_along(table);
  surface.center.angle = table.number_or(Dimension::kAngle, "angle", 0);
  surface.center.height = table.number_or(Dimension::kLength, "height", 0, Range::kNotNegative);
  surface.radius = table.number(Dimension::kLength, "radius", Range::kPositive);
  if (surface.shape != SurfaceShape::kSphere) {
    surface.across = table.choice("axis", {"bone", "joint"}) == "joint";
    surface.half_length = table.number(Dimension::kLength, "half_length", Range::kNotNegative);
  }
  return surface;
}

NetNodePlan read_node(TomlTable& table, const NetDescription& net) {
  NetNodePlan node;
  node.name = new_name(table, names_of(net.nodes));
  node.floating = table.choice("kind", {"floating", "bone"}) == "floating";
  node.place = read_place(table);
  // A node may follow a point of the subject, and rest on surfaces.
  if (table.has("strand")) node.strand = read_strand_point(table);
  if (table.has("surfaces")) node.surfaces = table.texts("surfaces");
  for (const std::string& surface : node.surfaces)
    check_reference(table, "surfaces", "surface", surface, names_of(net.surfaces));
  if (!node.floating && !node.surfaces.empty())
    table.fail("only a floating node rests on surfaces", "surfaces");
  return node;
}

/// Surface over which a band bends; "" if it is straight.
std::string read_over(TomlTable& table, const NetDescription& net) {
  if (!table.has("over")) return "";
  std::string over = reference(table, "over", "surface", names_of(net.surfaces));
  if (find_named(net.surfaces, over)->shape == SurfaceShape::kCapsule)
    table.fail(fmt::format("bands bend over spheres and cylinders, and '{}' is a capsule", over),
               "over");
  return over;
}

/// Stiffness EA [N], as stated or as modulus times area.
double read_stiffness(TomlTable& table) {
  if (table.has(Dimension::kForce, "EA"))
    return table.number(Dimension::kForce, "EA", Range::kPositive);
  return table.number(Dimension::kStress, "modulus", Range::kPositive) *
         table.number(Dimension::kArea, "area", Range::kPositive);
}

NetBandPlan read_band(TomlTable& table, const NetDescription& net) {
  NetBandPlan band;
  const std::vector<std::string> nodes = names_of(net.nodes);
  band.name = new_name(table, names_of(net.bands));
  // Its two ends.
  band.from = reference(table, "from", "node", nodes);
  band.to = reference(table, "to", "node", nodes);
  if (band.from == band.to)
    table.fail(fmt::format("band '{}' begins and ends at node '{}'", band.name, band.to), "to");
  // Slack length: stated, fitted like another band, or fitted to the straight finger.
  band.slack = table.number_or(Dimension::kLength, "slack", 0, Range::kPositive);
  if (table.has("strains_like")) {
    band.strains_like = reference(table, "strains_like", "earlier band", names_of(net.bands));
    if (band.slack > 0) table.fail("give 'slack_mm' or 'strains_like', not both", "strains_like");
  }
  // Elasticity, and the surface it bends over.
  band.EA = read_stiffness(table);
  band.toe = table.number_or(Dimension::kNumber, "toe_strain", 0, Range::kNotNegative);
  band.max_strain =
      table.number_or(Dimension::kNumber, "max_strain", band.max_strain, Range::kPositive);
  band.over = read_over(table, net);
  band.side = table.number_or(Dimension::kAngle, "side", 0);
  return band;
}

NetPullPlan read_pull(TomlTable& table, const NetDescription& net) {
  NetPullPlan pull;
  // Where the muscle pulls, and how strongly.
  pull.node = reference(table, "node", "node", names_of(net.nodes));
  pull.share = table.number_or(Dimension::kNumber, "share", 1, Range::kFraction);
  pull.relayed = table.has("relayed") && table.choice("relayed", {"yes", "no"}) == "yes";
  // Where its run leaves the net.
  if (table.has("strand")) pull.exit = read_strand_point(table);
  if (table.has("bone")) pull.exit_place = read_place(table);
  pull.over = read_over(table, net);
  if (table.has(Dimension::kForce, "EA") || table.has(Dimension::kStress, "modulus"))
    pull.EA = read_stiffness(table);
  table.done();
  return pull;
}

NetMusclePlan read_muscle(TomlTable& table, const NetDescription& net) {
  NetMusclePlan muscle;
  // The role is unique; several names may have it.
  muscle.role = table.text("role");
  for (const NetMusclePlan& other : net.muscles)
    if (other.role == muscle.role)
      table.fail(fmt::format("[[muscle]] '{}' is given twice", muscle.role), "role");
  muscle.names = table.texts("names");
  muscle.exit = table.choice("exit", kBoneRoleNames);
  muscle.optional = table.has("optional") && table.choice("optional", {"yes", "no"}) == "yes";
  muscle.hood_share = table.has("hood_share") && table.choice("hood_share", {"yes", "no"}) == "yes";
  // Shares of the tension that enter the net, at most all of it.
  double shares = 0;
  for (TomlTable& pull : table.tables("pulls")) {
    muscle.pulls.push_back(read_pull(pull, net));
    if (!muscle.pulls.back().relayed) shares += muscle.pulls.back().share;
  }
  if (shares <= 0) table.fail("a muscle needs at least one entry with a share in 'pulls'");
  if (shares > 1 + 1e-9)
    table.fail(fmt::format("wanted shares of at most 1 in all, got {}", shares), "pulls");
  return muscle;
}

void read_slips(TomlTable& top, NetDescription& net) {
  std::optional<TomlTable> table = top.table("slips");
  if (!table) return;
  const std::vector<std::string> bands = names_of(net.bands);
  // Names of bands under each key.
  const auto read = [&](const std::string& key) {
    std::vector<std::string> names;
    if (table->has(key)) names = table->texts(key);
    for (const std::string& name : names) check_reference(*table, key, "band", name, bands);
    return names;
  };
  net.slips = {read("central"), read("radial"), read("ulnar"), read("terminal")};
  table->done();
}

}  // namespace

NetDescription parse_net(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  // Header and reference finger.
  TomlTable top = file.top();
  NetDescription net;
  net.name = top.text("name");
  net.description = top.text_or("description", "");
  net.source = top.source();
  net.friction = top.number_or(Dimension::kNumber, "friction", 0, Range::kFraction);
  read_reference(top, net);
  // Parts in an order in which references point backwards.
  read_each(top, "surface", net.surfaces, read_surface, net);
  read_each(top, "node", net.nodes, read_node, net);
  read_each(top, "band", net.bands, read_band, net);
  read_each(top, "muscle", net.muscles, read_muscle, net);
  read_slips(top, net);
  top.done();
  return net;
}

NetDescription read_net(const std::string& path) { return parse_net(read_text_file(path), path); }

}  // namespace thenar
