// session.*, catalogue.* and picture.*: the session, names, and the picture as data.

#include <nlohmann/json.hpp>

#include "api/named/catalogue.h"
#include "base/provenance.h"
#include "live/live_abilities.h"
#include "report/answers/catalogue.h"
#include "server/frame.h"
#include "server/gltf.h"
#include "server/methods/method_table.h"
#include "server/rpc.h"
#include "server/scene_message.h"

namespace thenar::internal {
namespace {

constexpr int kProtocol = 1;  // version of the protocol; increases with incompatible changes

OrderedJson hello(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  OrderedJson mode;
  if (session.shown_model() != nullptr) mode = session.mode_name();
  const auto* edits = session.find_model<LiveEdits>(LiveMode::kWorld);
  return {{"program", "thenar"},
          {"version", versions().at("thenar")},
          {"protocol", kProtocol},
          {"mode", mode},
          {"world", edits == nullptr ? OrderedJson() : OrderedJson(edits->edit_state().name)}};
}

OrderedJson methods(Session& /*session*/, const Json& /*params*/, const Progress& /*progress*/) {
  OrderedJson list = OrderedJson::array();
  const MethodTable table = method_table();
  for (const RpcMethod& method : table.methods())
    list.push_back({{"name", method.name},
                    {"about", method.description},
                    {"params", json_schema(method.params)},
                    {"returns", method.returns},
                    {"example", OrderedJson::parse(method.example)}});
  return list;
}

/// Handles session.stop in a batch; the engine handles all others. Nothing else is running then.
OrderedJson stop(Session& /*session*/, const Json& /*params*/, const Progress& /*progress*/) {
  return {{"asked", false}};
}

/// Handles session.status behind other requests of its client. Nothing else is running then.
OrderedJson status(Session& /*session*/, const Json& /*params*/, const Progress& /*progress*/) {
  return status_json("", 0, 0, "", 0);
}

OrderedJson undo(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  return {{"did", session.model<LiveEdits>(LiveMode::kWorld).undo()}};
}

OrderedJson redo(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  return {{"did", session.model<LiveEdits>(LiveMode::kWorld).redo()}};
}

OrderedJson show_mode(Session& session, const Json& params, const Progress& /*progress*/) {
  session.show(value_in(kLiveModeNames, params["mode"].get<std::string>(), "mode"));
  return {{"mode", session.mode_name()}};
}

OrderedJson log_text(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  return {{"log", session.log().text()}};
}

OrderedJson catalogue(Session& session, const Json& params, const Progress& /*progress*/) {
  require(!params.contains("of") || params.contains("what"),
          "params: 'of' has parts of several kinds: 'what' is missing, such as 'joints'");
  CatalogueRequest request;
  request.what = params.value("what", "");
  request.of = params.value("of", "");
  request.data = session.folders().data;
  const Catalogue found = list_names(request);
  return {{"entries", json_of(found)}, {"warnings", found.warnings}};
}

const LiveModel& shown(const Session& session) {
  require(
      session.shown_model() != nullptr,
      "nothing is shown yet: call world.new, world.load, motion.open, tendons.open or fit.open");
  return *session.shown_model();
}

OrderedJson picture_scene(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  return scene_message(session);
}

OrderedJson picture_instant(Session& session, const Json& /*params*/,
                            const Progress& /*progress*/) {
  const LiveModel& model = shown(session);
  const LiveInstant instant = model.instant();
  check_instant(model.shape(), instant);
  return frame_json(model.shape(), instant, session.revision());
}

OrderedJson picture_gltf(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  const LiveModel& model = shown(session);
  const LiveInstant instant = model.instant();
  check_instant(model.shape(), instant);
  return {{"gltf", gltf_text(model.shape(), instant)}};
}

void add_picture_methods(MethodTable& table) {
  table.add({"picture.scene",
             "Returns the static part of the picture, in the form that pages receive.",
             object_schema({}),
             "revision, mode, up, eye and target [m], bodies, joints, lines, arrows, clouds; "
             "meshes by the id under which GET /mesh/ID returns them",
             "{}", picture_scene});
  table.add({"picture.instant", "Returns the moving part of the picture at this instant.",
             object_schema({}),
             "revision, time [s]; bodies with position [m] and rotation [w, x, y, z]; joints with "
             "value [rad or m]; lines with tension [N] and points [m]; contacts with point [m], "
             "normal, force [N] and friction; arrows with from [m] and vector",
             "{}", picture_instant});
  table.add({"picture.gltf", "Returns the picture at this instant as glTF 2.0, for other programs.",
             object_schema({}),
             "gltf: a text to be saved as .gltf; y is up in it, lengths are in m", "{}",
             picture_gltf});
}

}  // namespace

void add_session_methods(MethodTable& table) {
  table.add(
      {"session.hello", "Identifies the server; must be the first request if a token is required.",
       object_schema({{"token", text_schema(200), "The token that was printed at the start."}}),
       "program, version, protocol (1), mode and world (null: none yet)", "{}", hello});
  table.add({"session.methods", "Lists all methods with their parameters.", object_schema({}),
             "a list of name, about, params (JSON Schema, units as x-unit), returns, example", "{}",
             methods});
  table.add({"session.stop",
             "Asks the running request to stop and keep its results so far; does not wait for "
             "other requests.",
             object_schema({}), "asked: whether one was running", "{}", stop});
  table.add({"session.status",
             "Reports what is running; waits for it only if the same client has requested it.",
             object_schema({}),
             "runs (the running method, or null), seconds since it started, fraction and text as "
             "last reported, and waiting (queued requests)",
             "{}", status});
  table.add({"session.undo", "Undoes the last edit of the world.", object_schema({}),
             "did: what was undone", "{}", undo});
  table.add({"session.redo", "Redoes what was undone last.", object_schema({}),
             "did: what was redone", "{}", redo});
  table.add(
      {"session.mode", "Shows the world, the motion, the digit or the fit that is open.",
       object_schema({{"mode", word_schema(names_in(kLiveModeNames)), "Which.", true, nullptr}}),
       "mode", R"({"mode": "world"})", show_mode});
  table.add({"session.log", "Returns all requests so far, as thenar serve --replay reads them.",
             object_schema({}),
             "log: lines of JSON, each with client, request and the SHA-256 of its reply", "{}",
             log_text});
  table.add({"catalogue.list", "Lists names that other methods accept.",
             object_schema({{"what", word_schema(catalogue_words()),
                             "Which kind; default: all but parts of subjects."},
                            {"of", text_schema(), "Subject, or robot, whose parts are listed."}}),
             "entries: kind, name, about, source, file; warnings", R"({"what": "worlds"})",
             catalogue});
  add_picture_methods(table);
}

}  // namespace thenar::internal
