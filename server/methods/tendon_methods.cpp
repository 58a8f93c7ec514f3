#include <memory>
#include <utility>

#include "base/field_names.h"
#include "base/progress_parts.h"
#include "base/rung_names.h"
#include "live/live_digit.h"
#include "report/answers/passive_words.h"
#include "report/answers/tendon_solve.h"
#include "server/frame.h"
#include "server/methods/method_table.h"

namespace thenar::internal {
namespace {

constexpr double kMaxAngle = 6.3;  // bound of joint angles, above a full turn [rad]

/// Returns numbers as a list, with null for unknown ones.
Json list_of(const Eigen::Ref<const Eigen::VectorXd>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number_or_null(value));
  return list;
}

OrderedJson joints_json(const LiveDigit& digit) {
  // List all hinges with their angles and limits; followers name their leader.
  const std::vector<double> angles =
      hinge_angles(digit.digit_case().bones().model, digit.state().point.q);
  OrderedJson joints = OrderedJson::array();
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const LiveJoint& joint = digit.shape().joints[i];
    joints.push_back(
        {{"name", joint.name},
         {"field", field_name(joint.name)},
         {"value", angles[i]},
         {"lower", number_or_null(joint.lower)},
         {"upper", number_or_null(joint.upper)},
         {"led_by", joint.led_by.empty() ? OrderedJson() : OrderedJson(joint.led_by)}});
  }
  return joints;
}

OrderedJson muscles_json(const LiveDigit& digit) {
  // List the muscles; unknown numbers (NaN) become null.
  const DigitState& now = digit.state();
  const TendonDigit& bones = digit.digit_case().bones();
  OrderedJson muscles = OrderedJson::array();
  for (std::size_t m = 0; m < bones.names.muscles.size(); ++m) {
    OrderedJson muscle{{"name", bones.names.muscles[m]},
                       {"tension", now.tension[m]},
                       {"excitation", number_or_null(now.excitation[m])},
                       {"max_force", number_or_null(bones.max_tension[m])},
                       {"length", number_or_null(now.length[m])}};
    muscle["arms"] = OrderedJson::object();
    for (std::size_t j = 0; j < bones.names.coordinates.size(); ++j)
      muscle["arms"][bones.names.coordinates[j]] = number_or_null(now.arms(m, j));
    muscles.push_back(std::move(muscle));
  }
  return muscles;
}

/// Returns the bands of a net; empty without a net.
OrderedJson bands_json(const LiveDigit& digit) {
  const LiveInstant instant = digit.instant();
  OrderedJson bands = OrderedJson::array();
  for (std::size_t i = 0; i < instant.tensions.size(); ++i) {
    const LiveLine& line = digit.shape().lines[i];
    if (line.band)
      bands.push_back({{"name", line.name},
                       {"tension", number_or_null(instant.tensions[i])},
                       {"slack", instant.tensions[i] == 0}});
  }
  return bands;
}

/// Adds the tip force in the subject's frame and in the tip's axes, and the torques; null if the
/// solution is unreliable.
void add_tip(const LiveDigit& digit, OrderedJson& json) {
  // Add the force in the subject's frame.
  const DigitPoint& point = digit.state().point;
  const TendonModel<double>& model = digit.digit_case().bones().model;
  const bool sound = is_trusted(point.pull.status);
  json["tip_force"] = sound ? OrderedJson(to_json(point.tip.f_W)) : OrderedJson();
  json["tip_force_axes"] = OrderedJson();
  // Add the force in the tip's axes.
  if (sound) {
    Eigen::Matrix3d axes = model.tip_axes;
    const TreeState<double> state = pose_tree(model.tree, point.q);
    if (model.tip_link >= 0) axes = state[model.tip_link].X.R * axes;
    json["tip_force_axes"] =
        to_json({"proximal", "dorsal", "radial"}, axes.transpose() * point.tip.f_W);
  }
  const std::vector<std::string>& joints = digit.digit_case().bones().names.coordinates;
  // Add passive torques, which depend on the posture alone, and the torques of the tendons.
  Fields passive;
  add_passive(digit.digit_case().bones().skeleton, point.q, passive);
  json.update(json_of(passive, UnitSystem::kPrinted));
  json["torques"] = sound ? to_json(joints, point.pull.tau) : OrderedJson();
  json["unbalanced_torques"] = sound ? to_json(joints, point.tip.tau_residual) : OrderedJson();
  json["condition"] = number_or_null(point.tip.condition);
}

std::vector<std::string> warnings_of(const LiveDigit& digit) {
  std::vector<std::string> warnings = digit.warnings();
  const DigitState& now = digit.state();
  warnings.insert(warnings.end(), now.warnings.begin(), now.warnings.end());
  const std::string note = tip_note(now.point.tip);
  if (!note.empty() && now.tension.maxCoeff() > 0) warnings.push_back(note);
  return warnings;
}

OrderedJson state_json(const LiveDigit& digit) {
  const DigitCase& about = digit.digit_case();
  // Describe the digit as it was built.
  const DigitState& now = digit.state();
  OrderedJson json{
      {"subject", about.subject.name},
      {"digit", about.digit},
      {"built", describe(about.bones().fidelity)},
      {"net", about.net != nullptr ? OrderedJson(about.net->net().net.name) : OrderedJson()},
      {"rotation", to_json(quaternion_of(digit.subject_pose().R))}};
  json["joints"] = joints_json(digit);
  json["muscles"] = muscles_json(digit);
  json["bands"] = bands_json(digit);
  // Add the slips of the extensor hood, and the force of the tip.
  const SlipTension& slips = now.point.pull.slips;
  json["slips"] = {{"central", slips.central},
                   {"radial", slips.radial},
                   {"ulnar", slips.ulnar},
                   {"terminal", slips.terminal}};
  add_tip(digit, json);
  json["status"] = name_of(now.point.pull.status);
  json["trusted"] = is_trusted(now.point.pull.status);
  json["warnings"] = warnings_of(digit);
  return json;
}

OrderedJson open_digit_of(Session& session, const Json& params, const Progress& progress) {
  // Read the request; hood and path are optional.
  DigitRequest request;
  request.data = session.folders().data;
  request.subject = params["subject"].get<std::string>();
  request.digit = params.value("digit", "");
  request.net = params.value("net", "");
  if (params.contains("hood")) request.hood = hood_named(params["hood"].get<std::string>());
  if (params.contains("path")) request.path = path_named(params["path"].get<std::string>());
  request.passive = passive_named(params.value("passive", "on"));
  // Build and show the digit.
  progress(0, "building the digit");
  const auto digit = std::make_shared<LiveDigit>(request);
  session.open(LiveMode::kTendons, digit);
  return state_json(*digit);
}

OrderedJson set_digit(Session& session, const Json& params, const Progress& /*progress*/) {
  auto& digit = session.model<LiveDigit>(LiveMode::kTendons);
  const std::vector<std::string> limited =
      digit.set({named_numbers(params, "posture"), named_numbers(params, "tensions"),
                 named_numbers(params, "excitations")});
  OrderedJson json = state_json(digit);
  json["limited"] = limited;
  return json;
}

OrderedJson sweep_digit_of(Session& session, const Json& params, const Progress& progress) {
  const auto& digit = session.model<LiveDigit>(LiveMode::kTendons);
  // Compute the curves; all other joints keep their angles.
  const DigitCurves curves =
      digit.sweep(params["joint"].get<std::string>(), params["count"].get<int>(), progress);
  if (progress.stop()) throw Stopped("stopped");
  // Return the selected curves of all muscles.
  OrderedJson json{{"joint", curves.joint}, {"x", list_of(curves.angle)}};
  const std::vector<std::string>& muscles = digit.digit_case().bones().names.muscles;
  for (const Json& what : params["what"]) {
    const std::string name = what.get<std::string>();
    const Eigen::MatrixXd& values = name == "arms" ? curves.arms : curves.lengths;
    json[name] = OrderedJson::object();
    for (std::size_t m = 0; m < muscles.size(); ++m)
      json[name][muscles[m]] = list_of(values.row(m).transpose());
  }
  json["warnings"] = curves.warnings;
  return json;
}

Schema open_params() {
  return object_schema(
      {{"subject", text_schema(), "Name of a subject, or its file.", true},
       {"digit", text_schema(), "Which digit; default: the only one."},
       {"hood", word_schema(hood_names()),
        "How tensions spread over the extensor hood; default: a net where the digit can have one, "
        "else fixed fractions."},
       {"path", word_schema(path_names()),
        "Level of detail of tendon paths; default: wrapped where tendons of the subject name "
        "surfaces, else via."},
       {"net", text_schema(), "Name or file of the net; default: extensor_hood."},
       {"passive", word_schema(names_in(kPassiveNames)),
        "Whether passive moments of the subject's joints are counted.", false, "on"}});
}

Schema set_params() {
  return object_schema(
      {{"posture", map_schema(number_schema("rad", -kMaxAngle, kMaxAngle)),
        "Joint -> angle; others stay. Angles end at the limits of their joints."},
       {"tensions", map_schema(number_schema("N", 0, kMaxTension)),
        "Muscle -> tension; others stay."},
       {"excitations", map_schema(number_schema("", 0, 1)),
        "Muscle -> excitation in steady state, from which its tension follows: rigid tendon, "
        "fibres still and of optimal length with all joints at 0."}});
}

Schema sweep_params() {
  return object_schema({{"joint", text_schema(), "Which joint turns through its range.", true},
                        {"count", integer_schema(2, 1000), "Postures.", false, 61},
                        {"what", list_schema(word_schema({"arms", "lengths"}), 1, 2),
                         "Which curves.", false, Json::array({"arms", "lengths"})}});
}

constexpr const char* kStateWords =
    "subject, digit, built; rotation of the picture against the subject's frame; joints: name, "
    "field (the name in structures of MATLAB, which does for it), value, lower, upper [rad], "
    "led_by; muscles: name, tension [N], excitation or null, max_force "
    "[N], length: longer than with all joints at 0 [m], arms: joint -> moment arm, flexion and "
    "radial positive [m]; bands of a net: name, tension [N], slack; slips [N]; tip_force in the "
    "subject's frame and tip_force_axes [N]; passive_moment_Nm of joints, where they have some; "
    "torques of tendons and unbalanced_torques [N m]; condition; status, trusted, warnings. What "
    "is "
    "not to be trusted is null.";

}  // namespace

void add_tendon_methods(MethodTable& table) {
  // Add the methods that open, change and query the digit.
  table.add({"tendons.open", "Opens a digit of a subject with its tendons, and shows it.",
             open_params(), std::string("As tendons.state: ") + kStateWords,
             R"({"subject": "synek2019_middle"})", open_digit_of});
  table.add({"tendons.set",
             "Changes angles, tensions or excitations of the digit, and solves its tendons.",
             set_params(),
             "limited: joints that were asked beyond their limits; and all of tendons.state.",
             R"({"posture": {"PIP3": 0.5}, "tensions": {"EDC": 3}})", set_digit});
  table.add({"tendons.state", "Returns the posture of the digit and the state of its tendons.",
             object_schema({}), kStateWords, "{}",
             [](Session& session, const Json&, const Progress&) {
               return state_json(session.model<LiveDigit>(LiveMode::kTendons));
             }});
  // Add the sweep, which does not change the digit.
  table.add({"tendons.sweep",
             "Moment arms and lengths of every muscle over one joint, the others as they are.",
             sweep_params(),
             "joint; x: angles [rad]; arms: muscle -> moment arms about the joint [m]; lengths: "
             "muscle -> longer than with all joints at 0 [m]; null where there is no answer; "
             "warnings. Those of a net are under the present tensions.",
             R"({"joint": "PIP3", "count": 31})", sweep_digit_of});
}

}  // namespace thenar::internal
