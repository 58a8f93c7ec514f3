// world.*: content of the world, loading, saving and editing.

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "live/world/imported_files.h"
#include "live/world/world_edits.h"
#include "live/world/world_files.h"
#include "live/world/world_import.h"
#include "server/frame.h"
#include "server/methods/method_table.h"
#include "server/methods/world_requests.h"
#include "server/rpc.h"

namespace thenar::internal {
namespace {

constexpr std::size_t kMaxWorldBytes = 1'000'000;        // largest world as text [bytes]
constexpr std::size_t kMaxFileText = RpcLimits{}.bytes;  // no text is longer than its message
constexpr std::size_t kMaxFilesOfImport = 1000;          // largest number of files of an import

OrderedJson added_json(const AddedThing& added) {
  return {{"name", added.name}, {"warnings", added.warnings}};
}

OrderedJson start_world(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  LiveWorld& live = open_live_world(session);
  if (!live.state().placed.empty() || !live.state().bodies.empty()) new_world(live);
  return {{"name", live.edit_state().name}};
}

OrderedJson load(Session& session, const Json& params, const Progress& progress) {
  const bool by_name = params.contains("world"), by_text = params.contains("text");
  require(by_name != by_text, "params: wanted one of 'world' and 'text'");
  LiveWorld& live = open_live_world(session);
  const std::vector<std::string> warnings =
      by_name ? load_world(live, params["world"].get<std::string>(), progress)
              : load_world_text(live, params["text"].get<std::string>(),
                                params["name"].get<std::string>(), progress);
  return {{"name", live.edit_state().name}, {"warnings", warnings}};
}

OrderedJson text(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  return {{"toml", world_text(live_world(session))}};
}

OrderedJson save(Session& session, const Json& params, const Progress& /*progress*/) {
  LiveWorld& live = live_world(session);
  const std::string file = params["file"].get<std::string>();
  const bool overwrites = params["overwrite"].get<bool>();
  (void)save_live_world(live, file, overwrites ? Overwrite::kAnything : Overwrite::kNothing);
  return {{"file", file}};
}

OrderedJson hand_json(const LiveWorld& live, const PlacedHand& placed) {
  const WorldState& state = live.state();
  // Do not reveal the temporary folder of imported files, whose name is random.
  const std::string imported = imported_hand_file(live, placed);
  OrderedJson out{{"name", placed.name},
                  {"file", imported.empty() ? placed.file : "imported/" + imported},
                  {"position", to_json(placed.X_WH.p)},
                  {"rotation", to_json(quaternion_of(placed.X_WH.R))},
                  {"carrier", placed.carrier},
                  {"carrier_link", placed.carrier_link},
                  {"joints", OrderedJson::object()}};
  // Add the coordinates of the hand or carrier itself, with the names of world files.
  for (const StateHand& hand : state.hands) {
    const WorldHand& built = hand.built->hand;
    for (std::size_t part = 0; part < hand.parts.size(); ++part) {
      if (&state.placed[hand.parts[part]] != &placed) continue;
      for (std::size_t c = 0; c < built.names[part].size(); ++c)
        out["joints"][built.names[part][c]] = hand.placement.q[built.places[part][c]];
    }
  }
  return out;
}

Json mass_json(const WorldState& state, const BodySpec& body) {
  try {
    return body_mass(body, state.header->materials).mass;
  } catch (const InputError&) {
    return nullptr;  // neither mass nor density is stated
  }
}

OrderedJson get(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  const LiveWorld& live = live_world(session);
  const WorldState& state = live.state();
  OrderedJson hands = OrderedJson::array(), bodies = OrderedJson::array();
  for (const PlacedHand& placed : state.placed) hands.push_back(hand_json(live, placed));
  for (const StateBody& body : state.bodies)
    bodies.push_back({{"name", body.built->placed.body.name},
                      {"position", to_json(body.X_WB.p)},
                      {"rotation", to_json(quaternion_of(body.X_WB.R))},
                      {"dynamic", body.built->placed.dynamic},
                      {"material", body.built->body.material},
                      {"mass", mass_json(state, body.built->placed.body)}});
  return {{"name", state.header->name}, {"hands", hands}, {"bodies", bodies}};
}

OrderedJson put_object(Session& session, const Json& params, const Progress& /*progress*/) {
  return added_json(add_object(open_live_world(session), params["object"].get<std::string>(),
                               params["dynamic"].get<bool>(), pose_param(params)));
}

OrderedJson put_hand(Session& session, const Json& params, const Progress& progress) {
  return added_json(add_hand(open_live_world(session), params["hand"].get<std::string>(),
                             pose_param(params), progress));
}

OrderedJson import(Session& session, const Json& params, const Progress& progress) {
  std::vector<DroppedFile> files;
  for (const Json& file : params["files"])
    files.push_back(
        {file["name"].get<std::string>(), from_base64(file["data"].get_ref<const std::string&>())});
  const DroppedAs kind = value_in(kDroppedAsNames, params["as"].get<std::string>(), "role");
  return added_json(
      import_dropped(open_live_world(session), files, kind, progress, text_param(params, "units")));
}

OrderedJson remove(Session& session, const Json& params, const Progress& /*progress*/) {
  const std::string name = params["name"].get<std::string>();
  remove_thing(live_world(session), name);
  return {{"removed", name}};
}

OrderedJson place(Session& session, const Json& params, const Progress& /*progress*/) {
  LiveWorld& live = live_world(session);
  const std::string name = params["name"].get<std::string>();
  place_thing(live, name, position_param(params), rotation_param(params),
              text_param(params, "gesture"));
  return {{"placed", name}};
}

void add_file_rows(MethodTable& table) {
  table.add({"world.new", "Begins an empty world, which undo takes back.", object_schema({}),
             "name: of the world", "{}", start_world});
  table.add(
      {"world.load", "Loads a world by name or file, or from the text of a file.",
       object_schema(
           {{"world", text_schema(kMaxPathLength), "Name of a world, or path of its file."},
            {"text", content_schema(kMaxWorldBytes), "The world itself as TOML."},
            {"name", text_schema(kMaxNameLength), "How messages call the text.", false, "text"}}),
       "name: of the world; warnings: what was assumed", R"({"world": "jaw_box"})", load});
  table.add(
      {"world.text",
       "The world as the text of its file. Refused while hands were imported: no text holds their "
       "files, save the world and load what was saved.",
       object_schema({}), "toml: a text that world.load takes", "{}", text});
  table.add(
      {"world.save", "Saves the world in the working folder, with files of imported hands.",
       object_schema(
           {{"file", saved_file_schema(), "Within the working folder, ending in .toml.", true},
            {"overwrite", flag_schema(), "true: replaces also a file that is not of this world.",
             false, false}}),
       "file: that was written", R"({"file": "my_world.toml"})", save, MethodWrites::kFiles});
  table.add({"world.get", "Everything in the world, and where it is.", object_schema({}),
             "name; hands: name, file, position [m], rotation, carrier, carrier_link, joints [rad "
             "or m]; bodies: name, position [m], rotation, dynamic, material, mass [kg] or null; "
             "poses of mounted hands are relative to the carrier's link",
             "{}", get});
}

void add_thing_rows(MethodTable& table) {
  // Paths may be longer than names.
  const Schema path = text_schema(kMaxPathLength), name = text_schema(kMaxNameLength);
  table.add({"world.add_object",
             "Adds an object, or an obstacle that never moves; without a position at the origin, "
             "or next to what is already there.",
             object_schema({{"object", path, "Name of an object, or path of a file.", true},
                            {"dynamic", flag_schema(), "false: an obstacle.", false, true},
                            position_member(),
                            rotation_member()}),
             "name: the name it was given; warnings: what was assumed or mended",
             R"({"object": "mug", "position": [0.3, 0, 0.1]})", put_object});
  table.add(
      {"world.add_hand",
       "Adds a hand, open; without a position at the origin, or next to what is already there.",
       object_schema({{"hand", path, "Name of a hand, or path of a robot or subject.", true},
                      position_member(),
                      rotation_member()}),
       "name: the name it was given; warnings: what was assumed",
       R"({"hand": "barrett", "position": [0, 0.5, 0.3]})", put_hand});
  const Schema file =
      object_schema({{"name", name, "Path within what was dropped.", true},
                     {"data", content_schema(kMaxFileText), "Its bytes in base64.", true}});
  table.add(
      {"world.import",
       "Adds what was dropped, at the origin or next to what is already there: a robot with its "
       "meshes, an object, a mesh.",
       object_schema(
           {{"files", list_schema(file, 1, kMaxFilesOfImport), "All files.", true},
            {"as", word_schema(names_in(kDroppedAsNames)), "What it is imported as.", true},
            {"units", word_schema({"m", "cm", "mm", "in"}),
             "Unit of the numbers of a mesh; default: m."}}),
       "name: the name it was given; warnings: what was assumed, mended or omitted",
       R"({"files": [{"name": "wedge.obj", "data": "diAwIDAgMAp2IC4wMiAwIDAKdiAwIC4wMiAwCnYgMCAwIC4wMgpmIDEgMyAyCmYgMSAyIDQKZiAxIDQgMwpmIDIgMyA0Cg=="}], "as": "object"})",
       import});
  table.add({"world.place", "Puts an object, an obstacle or a free hand somewhere else.",
             object_schema({{"name", name, "Of what is placed.", true},
                            position_member(),
                            rotation_member(),
                            gesture_member()}),
             "placed: its name", R"({"name": "mug", "position": [0.3, 0.1, 0.1]})", place});
  table.add({"world.remove", "Removes an object, an obstacle or a hand.",
             object_schema({{"name", name, "Of what goes.", true}}), "removed: its name",
             R"({"name": "mug"})", remove});
}

}  // namespace

void add_world_methods(MethodTable& table) {
  add_file_rows(table);
  add_thing_rows(table);
  add_hand_methods(table);
}

}  // namespace thenar::internal
