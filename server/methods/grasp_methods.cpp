// grasp.*: contacts, quality and pads of the current grasp.

#include <nlohmann/json.hpp>

#include "base/progress_parts.h"
#include "grasp/closing/describe_grasp.h"
#include "grasp/quality/volume.h"
#include "live/world/live_pads.h"
#include "live/world/live_quality.h"
#include "report/answers/grasp.h"
#include "server/methods/method_table.h"
#include "server/methods/world_requests.h"

namespace thenar::internal {
namespace {

OrderedJson contacts(Session& session, const Json& params, const Progress& /*progress*/) {
  const LiveContacts found = current_contacts(live_world(session), pair_param(params));
  std::vector<Fields> list;
  for (std::size_t i = 0; i < found.contacts.size(); ++i) {
    const HandContact& each = found.contacts[i];
    const Contact seen = transform_contact(found.X_WO, each.contact);
    list.push_back({{"link", found.links[i]},
                    {"point", units::kMetreBare, seen.p},
                    {"normal", units::kOne, seen.n},
                    {"friction", seen.friction},
                    {"torsion", units::kMetreBare, seen.torsion},
                    {"patch", seen.patch},
                    {"depth", units::kMetreBare, each.depth}});
  }
  return reply_json({{"contacts", list}, {"warnings", found.warnings}});
}

LiveQualityRequest quality_param(const Json& params) {
  LiveQualityRequest request;
  request.tolerance = params["tolerance"].get<double>();
  request.norm = value_in(kForceNormNames, params["norm"].get<std::string>(), "norm");
  return request;
}

OrderedJson volume_json(const GraspResult& result, const Progress& progress) {
  VolumeOptions options;
  options.limit = result.request.limit;
  options.progress = progress;
  const Volume found = volume(result.wrenches, options);
  // The bounds of a volume that was stopped are too wide to be useful.
  if (progress.stop()) throw Stopped("the volume was stopped");
  return {{"lower", found.lower},
          {"upper", number_or_null(found.upper)},
          {"estimate", number_or_null(found.estimate)}};
}

std::string verdict_of(const Epsilon& e) {
  if (e.force_closure) return "force closure";
  return "unstable: the grasp cannot push with " + direction_words(e.missing_direction);
}

OrderedJson quality(Session& session, const Json& params, const Progress& progress) {
  const GraspResult result =
      show_quality(live_world(session), pair_param(params), quality_param(params));
  const GraspBody& object = result.setting.setup.object;
  OrderedJson out{{"closed", result.grasp.outcome == GraspOutcome::kGrasped},
                  {"hand", result.setting.hand.named.name},
                  {"object", object.name},
                  {"contacts", result.grasp.contacts.size()}};
  // Without contacts return the reason, and null for all measures.
  if (result.grasp.contacts.empty()) {
    out.update({{"reason", "the hand does not touch the object"},
                {"epsilon", nullptr},
                {"force_closure", false},
                {"verdict", "no contact"},
                {"missing_direction", nullptr},
                {"missing_direction_words", nullptr},
                {"worst_wrench", nullptr},
                {"worst_wrench_words", nullptr},
                {"volume", nullptr}});
  } else {
    // Return epsilon with its bounds and the direction that limits it, and the volume.
    const Epsilon& e = result.grasp.quality;
    const bool missing = e.has_missing_direction;
    out.update(
        {{"reason", nullptr},
         {"epsilon", {{"lower", e.lower}, {"upper", e.upper}}},
         {"force_closure", e.force_closure},
         {"verdict", verdict_of(e)},
         {"missing_direction", missing ? to_json(e.missing_direction.vector()) : Json()},
         {"missing_direction_words", missing ? Json(direction_words(e.missing_direction)) : Json()},
         {"worst_wrench", to_json(e.worst_wrench.vector())},
         {"worst_wrench_words", direction_words(e.worst_wrench)},
         {"volume", params["volume"].get<bool>() ? volume_json(result, progress) : OrderedJson()}});
  }
  out["rank"] = result.grasp.quality.rank;
  out.update(reply_json({{"centre_of_mass", units::kMetreBare, object.X_WB * object.com},
                         {"torque_scale", units::kMetreBare, object.torque_scale}}));
  out["warnings"] = result.outcome.warnings;
  return out;
}

OrderedJson wrenches(Session& session, const Json& params, const Progress& /*progress*/) {
  // Read the axes and limits, and compute the mesh.
  const Json& axes = params["axes"];
  const auto limits = value_in(kWrenchLimitsNames, params["limits"].get<std::string>(), "limits");
  const WrenchSetMesh found =
      live_wrench_set(live_world(session), pair_param(params),
                      {axes[0].get<int>(), axes[1].get<int>(), axes[2].get<int>()},
                      value_in(kPictureKindNames, params["kind"].get<std::string>(), "kind"),
                      limits, params["pieces"].get<int>());
  return {{"vertices", to_json(Eigen::MatrixXd(found.mesh.vertices.transpose()))},
          {"triangles", to_json(Eigen::MatrixXi(found.mesh.triangles.transpose()))},
          {"unit", limits == WrenchLimits::kActuated ? "N" : "N per N of normal force"},
          {"failed", found.failed}};
}

/// Returns the answer of `thenar grasp`, without its computing time.
OrderedJson measure(Session& session, const Json& params, const Progress& progress) {
  OrderedJson out = json_of(
      measured_grasp(live_world(session), pair_param(params), quality_param(params), progress));
  out.erase("cpu_s");
  return out;
}

OrderedJson pads(Session& session, const Json& params, const Progress& /*progress*/) {
  const LivePads found =
      press_pads(live_world(session), pair_param(params), params["force"].get<double>());
  std::vector<Fields> list;
  // List the springs of each pad: position, pressure, and whether it sticks.
  for (const LoadedPad& pad : found.pads)
    list.push_back({{"link", pad.link},
                    {"material", pad.material},
                    {"force", units::kNewtonBare, pad.force},
                    {"tangential", units::kNewtonBare, pad.tangential},
                    {"depth", units::kMetreBare, pad.depth},
                    {"area", units::kSquareMetreBare, pad.area},
                    {"stick", pad.stick},
                    {"points", fields_of_each(pad.points, [](const PadPoint& point) {
                       return Fields{{"point", units::kMetreBare, point.p},
                                     {"pressure", units::kPascalBare, point.pressure},
                                     {"sticks", point.sticks}};
                     })}});
  return reply_json({{"pads", list}, {"reasons", found.reasons}});
}

std::vector<SchemaMember> quality_members() {
  return {hand_member(),
          object_member(),
          {"tolerance", number_schema("1", 1e-6, 1), "Of epsilon's certified bounds.", false, 1e-3},
          {"norm", word_schema(names_in(kForceNormNames)),
           "l1: the sum of all normal forces is at most 1; linf: the sum within each patch is at "
           "most 1.",
           false, "l1"}};
}

void add_quality_rows(MethodTable& table) {
  std::vector<SchemaMember> with_volume = quality_members();
  with_volume.push_back({"volume", flag_schema(), "Whether to compute it.", false, false});
  table.add({"grasp.quality",
             "Epsilon with certified bounds, and the disturbance that is resisted least, which is "
             "shown until something moves.",
             object_schema(with_volume),
             "closed: whether anything touches, else reason; contacts: how many; epsilon: lower, "
             "upper [N per N]; force_closure; verdict; missing_direction, worst_wrench (6, torques "
             "over torque_scale, the object's frame), each in words; volume or null; rank; "
             "centre_of_mass_m, of the object in the world; torque_scale_m; warnings",
             "{}", quality});
  table.add({"grasp.measure", "All measures, as `thenar grasp --json` prints them.",
             object_schema(quality_members()),
             "the same as `thenar grasp --json`; each key ends in its unit; centre_of_mass_m is in "
             "the object's frame",
             "{}", measure});
}

}  // namespace

void add_grasp_methods(MethodTable& table) {
  table.add({"grasp.contacts", "Where a hand touches an object.",
             object_schema({hand_member(), object_member()}),
             "contacts: link, point_m and normal (into the object) of the world, friction, "
             "torsion_m, patch, depth_m; warnings: what is deep in something",
             "{}", contacts});
  add_quality_rows(table);
  table.add({"grasp.wrench_set", "Wrenches that the grasp makes, in three of six axes, as a mesh.",
             object_schema(
                 {hand_member(),
                  object_member(),
                  {"axes",
                   list_schema(integer_schema(0, 5), 3, 3),
                   "Three of fx, fy, fz, tx, ty, tz, torques over the object's reach.",
                   false,
                   {0, 1, 2}},
                  {"kind", word_schema(names_in(kPictureKindNames)),
                   "Of all wrenches, or of those whose other axes are zero.", false, "projection"},
                  {"limits", word_schema(names_in(kWrenchLimitsNames)),
                   "1 N of normal forces in all, or what drives the hand.", false, "geometric"},
                  {"pieces", integer_schema(1, 24), "Of each edge of an octahedron.", false, 8}}),
             "vertices (n, 3) in the object's frame; triangles (m, 3); unit; failed: directions "
             "that are not bounded",
             "{}", wrenches});
  table.add(
      {"grasp.pads", "Pressure of soft pads on the object, and where they stick.",
       object_schema({hand_member(),
                      object_member(),
                      {"force", number_schema("N", 1e-3, 1000), "Normal, of each pad.", false, 1}}),
       "pads: link, material, force_N, tangential_N, depth_m, area_m2, stick [1], points: point_m, "
       "pressure_Pa, sticks; reasons: why a contact has no pad",
       "{}", pads});
}

}  // namespace thenar::internal
