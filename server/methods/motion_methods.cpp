#include <memory>
#include <optional>

#include "api/named/files.h"
#include "base/field_names.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "live/live_motion.h"
#include "live/recorded_digit_motion.h"
#include "live/recorded_motion.h"
#include "live/world/live_world.h"
#include "report/answers/motion_account.h"
#include "server/frame.h"
#include "server/methods/method_table.h"

namespace thenar::internal {
namespace {

constexpr double kMaxStepsOfRequest = 1e6;  // largest number of steps of one request

// Parameters.

/// Returns the schema of numbers by name. @param lower, upper  bounds in the unit
Schema numbers_by_name(const std::string& unit, double lower, double upper) {
  return map_schema(number_schema(unit, lower, upper));
}

SchemaMember step_member() {
  return {"step", number_schema("s", 1e-6, 0.1),
          "Length of a step; default: from the scene, or 1 ms for a world."};
}

std::vector<SchemaMember> input_members() {
  return {{"efforts", numbers_by_name("N m or N", -kMaxMotionEffort, kMaxMotionEffort),
           "Coordinate -> effort, in place of its drives, cut to their largest."},
          {"targets", numbers_by_name("rad or m", -kMaxMotionTarget, kMaxMotionTarget),
           "Coordinate -> target of its drive, which must have stiffness; one beyond the limits of "
           "a joint presses against its stop."},
          {"tensions", numbers_by_name("N", 0, kMaxMotionTension),
           "Muscle -> tension: human:skewed/index/FDP2."},
          {"excitations", numbers_by_name("1", 0, 1), "Muscle that contracts -> excitation."},
          {"release", list_schema(text_schema(), 0, 1000),
           "Coordinates that go back to the drives of the scene."}};
}

SchemaMember want_member(const Json& default_value) {
  return {"want",
          list_schema(word_schema({"joints", "bodies", "contacts", "energy", "muscles"}), 0, 5),
          "Which parts of the state the reply holds.", false, default_value};
}

MotionParts wanted_parts(const Json& params) {
  const auto wants = [&](const char* part) { return contains(params.at("want"), part); };
  return {wants("joints"), wants("bodies"), wants("contacts"), wants("energy"), wants("muscles")};
}

MotionInputs inputs_of(const Json& params) {
  // Read the maps from names to numbers, and the list of names to release.
  MotionInputs inputs{named_numbers(params, "efforts"),
                      named_numbers(params, "targets"),
                      named_numbers(params, "tensions"),
                      named_numbers(params, "excitations"),
                      {}};
  if (params.contains("release"))
    for (const Json& name : params.at("release")) inputs.release.push_back(name);
  return inputs;
}

bool has_inputs(const Json& params) {
  for (const char* name : {"efforts", "targets", "tensions", "excitations", "release"})
    if (params.contains(name)) return true;
  return false;
}

// Replies.

Fields contact_fields(const ContactSample& contact, const std::vector<std::string>& names) {
  // All vectors are in the world frame; the normal points out of b, and the force acts on a.
  return {{"a", names[contact.a]},
          {"b", names[contact.b]},
          {"point", units::kMetreBare, contact.point},
          {"normal", units::kOne, contact.normal},
          {"force", units::kNewtonBare, contact.force},
          {"torsion", units::kNewtonMetreBare, contact.torsion},
          {"gap", units::kMetreBare, contact.gap},
          {"mode", name_in(kContactModeNames, contact.mode)}};
}

Fields energy_fields(const MotionEnergy& energy) {
  // Parts that a recording does not hold are null.
  Fields out{{"kinetic", units::kJouleBare, energy.kinetic},
             {"weight", units::kJouleBare, energy.weight},
             {"springs", units::kJouleBare, energy.springs},
             {"total", units::kJouleBare, energy.total}};
  if (!energy.balance) return out;
  out.add("work", units::kJouleBare, energy.balance->work);
  out.add("dissipated", units::kJouleBare, energy.balance->dissipated());
  out.add("error", units::kJouleBare, energy.balance->error);
  return out;
}

Fields body_fields(const BodyState& body) {
  return {{"position", units::kMetreBare, body.X_WB.p},
          {"rotation", units::kOne, quaternion_of(body.X_WB.R)},
          {"velocity", units::kMetrePerSecondBare, body.velocity.linear},
          {"spin", units::kRadianPerSecondBare, body.velocity.angular}};
}

/// Returns the selected parts of the state.
Fields state_fields(const LiveTimeline& motion, const MotionParts& parts) {
  const TimelineState state = motion.state(parts);
  Fields out{{"t", units::kSecondBare, state.t}};
  // Add joints, bodies and contacts.
  if (parts.joints) {
    OrderedJson joints = OrderedJson::object();
    for (const CoordinateState& each : state.joints)
      joints[each.name] = {each.value, each.rate,
                           each.effort ? OrderedJson(*each.effort) : OrderedJson()};
    out.add("joints", std::move(joints));
  }
  if (parts.bodies) {
    Fields bodies;
    for (const BodyState& each : state.bodies) bodies.add(each.name, body_fields(each));
    out.add("bodies", std::move(bodies));
  }
  if (parts.contacts)
    out.add("contacts", fields_of_each(state.contacts, [&](const ContactSample& each) {
              return contact_fields(each, state.body_names);
            }));
  // Add energy and the readings of muscles.
  if (state.energy) out.add("energy", energy_fields(*state.energy));
  if (parts.muscles) {
    OrderedJson muscles = OrderedJson::object();
    for (const ElementValue& each : state.muscles) muscles[each.name] = each.value;
    out.add("muscles", std::move(muscles));
  }
  return out;
}

/// Returns the quality of steps; its energy balance is null if it is not recorded.
Fields quality_fields(const MotionQuality& quality) {
  const std::optional<FlowBalance>& balance = quality.balance;
  return {{"steps", quality.steps},
          {"unsolved", quality.unsolved},
          {"worst_residual", quality.worst_residual},
          {"deepest", units::kMetreBare, quality.deepest},
          {"leaps", quality.leaps},
          {"energy_error", units::kJouleBare, balance ? balance->error : kNaN},
          {"energy_turned_over", units::kJouleBare, balance ? balance->turned_over : kNaN},
          {"energy_balances", balance ? OrderedJson(balance->holds()) : OrderedJson()},
          {"limits_passed", limit_fields(quality.limits)},
          {"restitution_ignored", quality.restitution}};
}

/// Returns the reply to a request for the state: the quality of steps, and the selected parts.
OrderedJson state_reply(const LiveTimeline& motion, const MotionQuality& quality,
                        const Json& params) {
  Fields out = quality_fields(quality);
  out.append(state_fields(motion, wanted_parts(params)));
  return reply_json(out);
}

LiveTimeline& timeline_of(const Session& session) {
  return session.model<LiveTimeline>(LiveMode::kMotion);
}

LiveMotion& motion_of(const Session& session) {
  LiveTimeline& timeline = timeline_of(session);
  require(!timeline.live_time().recorded,
          "'{}' is a recorded run: it can be sought and played, but takes no inputs",
          timeline.name());
  return session.model<LiveMotion>(LiveMode::kMotion);
}

/// Returns the description of an opened motion.
OrderedJson opened_json(const LiveTimeline& motion) {
  const LiveTime time = motion.live_time();
  return reply_json({{"name", motion.name()},
                     {"step", units::kSecondBare, time.step},
                     {"duration", units::kSecondBare, time.duration},
                     {"warnings", motion.warnings()}});
}

OrderedJson play_json(const Session& session) {
  const LiveTime time = timeline_of(session).live_time();
  return reply_json(
      {{"t", units::kSecondBare, time.t}, {"playing", time.playing}, {"speed", time.speed}});
}

// Handlers.

MotionSource source_of(const Session& session, const Json& params) {
  // Without a scene, use the open world in its current state.
  const std::string& data = session.folders().data;
  std::optional<double> step;
  if (params.contains("step")) step = params.at("step").get<double>();
  if (!params.contains("scene")) {
    require(!params.contains("pads"), "a world has no pads that deform: open a scene with [[pad]]");
    const std::string drives = params.value("drives", "hold");
    const auto& world = session.model<LiveWorld>(LiveMode::kWorld);
    return world_motion(world_spec(world.state()), data,
                        value_in(kWorldDrivesNames, drives, "drives"), step);
  }
  require(!params.contains("drives"), "'drives' are of a world: a scene has its own");
  // Read the scene as the command does.
  SceneRequest request;
  request.scene = params.at("scene").get<std::string>();
  request.data = data;
  request.step = step;
  if (params.contains("pads")) request.pads = params.at("pads").get<std::string>();
  return scene_motion(request);
}

/// Opens and shows a motion. @return its description
OrderedJson show_motion(Session& session, std::shared_ptr<LiveTimeline> motion) {
  OrderedJson reply = opened_json(*motion);
  session.open(LiveMode::kMotion, std::move(motion));
  return reply;
}

OrderedJson open_motion(Session& session, const Json& params, const Progress& /*progress*/) {
  return show_motion(session, std::make_shared<LiveMotion>(source_of(session, params)));
}

OrderedJson open_record(Session& session, const Json& params, const Progress& /*progress*/) {
  const std::string file = params.at("file").get<std::string>();
  require_kind(file, {"scene run", "motion"});
  if (contents_of(file).kind == "motion")
    return show_motion(session, std::make_shared<RecordedDigitMotion>(read_motion(file)));
  return show_motion(
      session, std::make_shared<RecordedMotion>(read_scene_run(file, session.folders().data)));
}

OrderedJson step_motion(Session& session, const Json& params, const Progress& progress) {
  if (has_inputs(params)) motion_of(session).set(inputs_of(params));
  LiveTimeline& motion = timeline_of(session);
  const MotionQuality quality = motion.step(params.at("steps").get<long>(), progress);
  return state_reply(motion, quality, params);
}

OrderedJson motion_state(Session& session, const Json& params, const Progress& /*progress*/) {
  const LiveTimeline& motion = timeline_of(session);
  return state_reply(motion, motion.quality(), params);
}

OrderedJson set_motion(Session& session, const Json& params, const Progress& /*progress*/) {
  LiveMotion& motion = motion_of(session);
  motion.set(inputs_of(params));
  return reply_json({{"t", units::kSecondBare, motion.live_time().t}});
}

OrderedJson motion_inputs(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  OrderedJson list = OrderedJson::array();
  for (const MotionInput& input : motion_of(session).inputs())
    list.push_back({{"name", input.name},
                    {"field", field_name(input.name)},
                    {"kind", name_in(kMotionInputKindNames, input.kind)},
                    {"unit", input.unit},
                    {"lower", number_or_null(input.lower)},
                    {"upper", number_or_null(input.upper)},
                    {"set", input.set ? OrderedJson(*input.set) : OrderedJson()}});
  return {{"inputs", std::move(list)}};
}

OrderedJson play_motion(Session& session, const Json& params, const Progress& /*progress*/) {
  LiveTimeline& motion = timeline_of(session);
  session.show(LiveMode::kMotion);
  motion.play(params.at("speed").get<double>());
  return play_json(session);
}

OrderedJson pause_motion(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  timeline_of(session).pause();
  return play_json(session);
}

OrderedJson seek_motion(Session& session, const Json& params, const Progress& /*progress*/) {
  (void)timeline_of(session).seek(params.at("t").get<double>());
  return play_json(session);
}

OrderedJson reset_motion(Session& session, const Json& /*params*/, const Progress& /*progress*/) {
  timeline_of(session).reset();
  return play_json(session);
}

// Rows.

const char* const kMotionWords =
    "t_s; as wanted: joints {name: [value, rate, effort]} [rad, rad/s, N m or m, m/s, N], bodies "
    "{name: {position_m, rotation [w, x, y, z], velocity_m_per_s of the centre of mass, "
    "spin_rad_per_s}}, contacts [{a, b, point_m, normal, force_N on a, torsion_N_m, gap_m, mode}], "
    "energy {kinetic_J, weight_J, springs_J, total_J, work_J, dissipated_J, error_J since the "
    "start}, muscles {name: tension [N], or activation}; null: not known";
const char* const kPlayWords = "t_s, playing, speed [1]";

std::string with_quality(const std::string& of) {
  return "steps, unsolved contact problems, worst_residual [1], deepest_m: penetration, leaps "
         "(steps in which surfaces may have gone through each other), limits_passed [{joint, "
         "beyond_rad or beyond_m}] " +
         of +
         "; energy_error_J (below 0: energy was created) and energy_turned_over_J (total energy "
         "exchanged) since the start, energy_balances: whether the error is below 1 % of that; "
         "restitution_ignored, the largest that steps neglect [1]; " +
         kMotionWords;
}

void add_opening_methods(MethodTable& table) {
  // Add the methods that open a simulation or a recording.
  const std::string opened = "name, step_s, duration_s or null, warnings";
  table.add({"motion.open", "Opens a scene, or the world as it is, to be moved step by step.",
             object_schema({{"scene", text_schema(),
                             "Name or file of the scene; default: the world as it is."},
                            step_member(),
                            {"pads", word_schema(pad_rung_names()),
                             "Level of detail of all pads of the scene; default: from the scene."},
                            {"drives", word_schema(names_in(kWorldDrivesNames)),
                             "What moves the hands of a world: drives that hold them in place "
                             "(hold, the default), tendons of human hands, or nothing."}}),
             opened, R"({"scene": "pinch", "step": 0.002})", open_motion});
  table.add(
      {"motion.record",
       "Opens a run of a scene or a motion of a digit that `thenar simulate .. -o run.h5` wrote.",
       object_schema({{"file", text_schema(), "The run.", true}}), opened, R"({"file": "run.h5"})",
       open_record});
}

void add_stepping_methods(MethodTable& table) {
  // A step takes the inputs of motion.set and the parts of motion.state.
  std::vector<SchemaMember> members{
      {"steps", integer_schema(0, kMaxStepsOfRequest), "How many steps.", false, 1}};
  for (const SchemaMember& input : input_members()) members.push_back(input);
  members.push_back(want_member({"joints"}));
  table.add({"motion.step",
             "Sets inputs, takes steps and returns the state. After motion.seek, later instants "
             "are discarded.",
             object_schema(std::move(members)), with_quality("of this call"),
             R"({"steps": 2, "want": ["joints", "contacts"]})", step_motion});
  table.add({"motion.state", "Returns the state that is shown.",
             object_schema({want_member({"joints", "bodies", "contacts", "energy"})}),
             with_quality("since the start"), R"({"want": ["energy"]})", motion_state});
  table.add({"motion.set", "Sets inputs, which stay until they are set again.",
             object_schema(input_members()), "t_s", R"({"efforts": {}})", set_motion});
  table.add({"motion.inputs", "Names what can be set.", object_schema({}),
             "inputs [{name, field (the name in structures of MATLAB, which does for it), kind: "
             "effort, target, tension or excitation, unit, lower, upper, set}]; "
             "null: no limit of its own is known, nothing is set",
             "{}", motion_inputs});
}

void add_playing_methods(MethodTable& table) {
  // Playback is executed by the engine.
  table.add(
      {"motion.play", "Shows the motion, and lets time run.",
       object_schema({{"speed", number_schema("1", 1e-3, 100), "Times real time.", false, 1}}),
       kPlayWords, R"({"speed": 0.5})", play_motion});
  table.add({"motion.pause", "Stops time.", object_schema({}), kPlayWords, "{}", pause_motion});
  table.add({"motion.seek", "Shows the kept instant that is nearest to a time.",
             object_schema({{"t", number_schema("s", 0), "When.", true}}), kPlayWords,
             R"({"t": 0})", seek_motion});
  table.add({"motion.reset", "Goes back to the start; inputs and the past are forgotten.",
             object_schema({}), kPlayWords, "{}", reset_motion});
}

}  // namespace

void add_motion_methods(MethodTable& table) {
  add_opening_methods(table);
  add_stepping_methods(table);
  add_playing_methods(table);
}

}  // namespace thenar::internal
