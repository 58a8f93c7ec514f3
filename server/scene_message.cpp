#include "server/scene_message.h"

#include <vector>

#include <nlohmann/json.hpp>

#include "live/live_abilities.h"
#include "report/picture/mesh_table.h"

namespace thenar {
namespace {

OrderedJson body_json(const LiveBody& body, MeshStore& meshes) {
  return {{"name", body.name},
          {"owner", body.owner},
          {"digit", body.digit},
          {"material", body.material},
          {"role", name_in(kLiveRoleNames, body.role)},
          {"movable", body.movable},
          {"mesh", body.mesh == nullptr ? OrderedJson() : OrderedJson(meshes.add(body.mesh))},
          {"crease", body.crease}};
}

OrderedJson joint_json(const LiveJoint& joint) {
  return {{"name", joint.name},
          {"hand", joint.hand},
          {"body", joint.body},
          {"axis", to_json(joint.axis)},
          {"point", to_json(joint.point)},
          {"slides", joint.slides},
          {"lower", number_or_null(joint.lower)},
          {"upper", number_or_null(joint.upper)},
          {"led_by", joint.led_by}};
}

/// Segments as base64 of f32, six numbers each [m].
OrderedJson cloud_json(const LiveCloud& cloud) {
  std::vector<float> numbers;
  for (const Eigen::Vector3d& point : cloud.segments)
    for (const double coordinate : point) numbers.push_back(static_cast<float>(coordinate));
  const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  return {{"name", cloud.name},
          {"body", cloud.body},
          {"segments", base64(bytes, numbers.size() * sizeof(float))}};
}

OrderedJson motion_json(const Session& session) {
  const auto* clock = session.find_model<LiveClock>(LiveMode::kMotion);
  if (clock == nullptr) return nullptr;
  const LiveTime now = clock->live_time();
  return {{"t", now.t},
          {"playing", now.playing},
          {"speed", now.speed},
          {"duration", now.duration ? OrderedJson(*now.duration) : OrderedJson()},
          {"recorded", now.recorded},
          {"shown", session.mode() == LiveMode::kMotion}};
}

OrderedJson text_or_null(const std::optional<std::string>& text) {
  return text ? OrderedJson(*text) : OrderedJson();
}

}  // namespace

OrderedJson scene_message(const LiveShape& shape, unsigned long revision, LiveMode mode,
                          MeshStore& meshes) {
  meshes.begin_scene();
  OrderedJson out{{"revision", static_cast<std::uint32_t>(revision)},
                  {"mode", name_in(kLiveModeNames, mode)},
                  {"up", {0, 0, 1}},
                  {"eye", to_json(shape.eye)},
                  {"target", to_json(shape.target)}};
  for (const char* list : {"bodies", "joints", "lines", "arrows", "clouds"})
    out[list] = OrderedJson::array();
  for (const LiveBody& body : shape.bodies) out["bodies"].push_back(body_json(body, meshes));
  for (const LiveJoint& joint : shape.joints) out["joints"].push_back(joint_json(joint));
  for (const LiveLine& line : shape.lines)
    out["lines"].push_back(
        {{"name", line.name}, {"owner", line.owner}, {"band", line.band}, {"points", line.points}});
  for (const LiveArrow& arrow : shape.arrows)
    out["arrows"].push_back(
        {{"name", arrow.name}, {"kind", name_in(kLiveArrowKindNames, arrow.kind)}});
  for (const LiveCloud& cloud : shape.clouds) out["clouds"].push_back(cloud_json(cloud));
  return out;
}

OrderedJson scene_message(Session& session) {
  const LiveModel* model = session.shown_model();
  return scene_message(model == nullptr ? LiveShape() : model->shape(), session.revision(),
                       session.mode(), session.meshes());
}

OrderedJson state_message(const Session& session, std::size_t clients) {
  const auto* edits = session.find_model<LiveEdits>(LiveMode::kWorld);
  const LiveEditState edited = edits == nullptr ? LiveEditState() : edits->edit_state();
  return {{"mode", session.mode_name()},
          {"world", {{"name", edited.name}, {"file", edited.file}, {"unsaved", edited.unsaved}}},
          {"undo", text_or_null(edited.undo)},
          {"redo", text_or_null(edited.redo)},
          {"motion", motion_json(session)},
          {"busy", nullptr},
          {"clients", clients}};
}

}  // namespace thenar
