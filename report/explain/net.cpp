// Explanation of an extensor net: its parts and assumptions.

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "base/units.h"
#include "base/words.h"
#include "report/explain/explanation.h"

namespace thenar {
namespace {

/// The cells of a place: bone, part of its length, angle about it, height.
std::vector<std::string> cells_of(const NetPlace& place) {
  return {name_in(kBoneRoleNames, place.bone), shown(place.along, 3),
          shown(place.angle / kDegree, 1), shown(place.height / kMm, 2)};
}

std::string list_or_dash(const std::vector<std::string>& names) {
  return names.empty() ? "-" : listed(names);
}

Section explain_header(const NetDescription& net) {
  Section section{
      "net",
      fmt::format("net '{}': {}, {}, {}, {}", net.name, counted(net.nodes.size(), "node"),
                  counted(net.bands.size(), "band"), counted(net.muscles.size(), "muscle"),
                  counted(net.surfaces.size(), "surface")),
      {{"reference", "length_mm"}}};
  section.lines = {
      net.description, "source " + net.source,
      "stated on one reference finger; laid on a subject's by the lengths of its bones "
      "and the heights of its extensor"};
  for (const auto& [bone, length] : net.bone_length)
    section.table.add({name_in(kBoneRoleNames, bone) + " bone", shown(length / kMm, 2)});
  for (const auto& [joint, height] : net.height)
    section.table.add({"height over " + name_in(kFingerJointNames, joint), shown(height / kMm, 2)});
  return section;
}

Section explain_nodes(const NetDescription& net) {
  Section section{
      "nodes",
      "Nodes",
      {{"node", "kind", "bone", "along", "angle_deg", "height_mm", "or_at", "rests_on"}}};
  for (const NetNodePlan& node : net.nodes)
    section.table.add_parts({{node.name, node.floating ? "floats" : "on bone"},
                             cells_of(node.place),
                             {list_or_dash(node.strand.strands), list_or_dash(node.surfaces)}});
  section.lines = {
      "where a node is, or starts if it floats; `or_at`: a point of the first of these "
      "strands that a subject has goes before that"};
  return section;
}

std::string slack_of(const NetBandPlan& band) {
  if (band.slack > 0) return shown(band.slack / kMm, 2);
  return band.strains_like.empty() ? "fitted" : "strains like " + band.strains_like;
}

Section explain_bands(const NetDescription& net) {
  Section section{
      "bands", "Bands", {{"band", "from", "to", "slack_mm", "EA_N", "toe_strain", "bends_over"}}};
  for (const NetBandPlan& band : net.bands)
    section.table.add({band.name, band.from, band.to, slack_of(band), shown(band.EA, 1),
                       shown(band.toe, 3), or_dash(band.over)});
  section.lines = {"fitted: just taut in the straight finger of the subject"};
  return section;
}

Section explain_muscles(const NetDescription& net) {
  Section section{"muscles", "Muscles", {{"role", "names", "pulls_at", "share", "bends_over"}}};
  for (const NetMusclePlan& muscle : net.muscles)
    for (const NetPullPlan& pull : muscle.pulls)
      section.table.add(
          {muscle.role + (muscle.optional ? ", if present" : ""), listed(muscle.names), pull.node,
           shown(pull.share, 3) + (pull.relayed ? ", handed on" : ""), or_dash(pull.over)});
  section.lines = {"shares below 1 leave the rest to the bone, along the muscle's whole path"};
  return section;
}

Section explain_surfaces(const NetDescription& net) {
  Section section{"surfaces",
                  "Surfaces",
                  {{"surface", "shape", "bone", "along", "angle_deg", "height_mm", "radius_mm",
                    "half_length_mm", "axis_along"}}};
  for (const NetSurface& surface : net.surfaces) {
    const bool sphere = surface.shape == SurfaceShape::kSphere;
    section.table.add_parts(
        {{surface.name, name_in(kSurfaceShapeNames, surface.shape)},
         cells_of(surface.center),
         {shown(surface.radius / kMm, 2), sphere ? "-" : shown(surface.half_length / kMm, 2),
          sphere           ? "-"
          : surface.across ? "joint"
                           : "bone"}});
  }
  return section;
}

Section explain_slips(const NetDescription& net) {
  return {"slips",
          "Slips, and the bands whose tensions they are",
          {{"slip", "bands"},
           {{"central", list_or_dash(net.slips.central)},
            {"radial", list_or_dash(net.slips.radial)},
            {"ulnar", list_or_dash(net.slips.ulnar)},
            {"terminal", list_or_dash(net.slips.terminal)}}}};
}

/// Explains the assumptions of a hood that is a net, and of the lower rungs, which it replaces.
Section explain_tiers(const NetDescription& net) {
  Section section{
      "assumes", "Assumptions, by the level of detail of the hood", {{"rung", "assumes"}}};
  for (const Hood hood : {Hood::kSeparate, Hood::kFractions, Hood::kFloatingNet})
    for (const RungWords& words : explain(Fidelity(hood)))
      if (words.ladder == "hood") section.table.add({words.rung, words.assumes});
  section.lines = {
      "bands pull and never push; they have no mass and do not creep",
      net.surfaces.empty() ? "no bone is in the way of a band or a node"
                           : "nodes rest on the surfaces named and bands bend over one each; they "
                             "pass through any other",
      net.friction > 0
          ? fmt::format("nodes rub on bone with friction {:.3g}: tendon commands refuse "
                        "that, solve_net_friction() has it",
                        net.friction)
          : "nodes slide on bone without friction",
      "muscles pull with given tensions; a muscle that the net cannot hold is reported as drawn "
      "in"};
  return section;
}

}  // namespace

Explanation explain(const NetDescription& net) {
  return {explain_header(net),   explain_nodes(net), explain_bands(net), explain_muscles(net),
          explain_surfaces(net), explain_slips(net), explain_tiers(net)};
}

}  // namespace thenar
