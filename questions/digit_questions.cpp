// Questions about a digit: poses, moment arms, fingertip forces, tensions of its hood.

#include "api/feasible_force.h"
#include "api/moment_arms.h"
#include "api/pose.h"
#include "api/tendon_solve.h"
#include "api/tip_force.h"
#include "questions/digit_params.h"
#include "questions/make_question.h"
#include "questions/question_rows.h"
#include "report/answers/answer_files.h"
#include "report/answers/feasible_force.h"
#include "report/answers/moment_arms.h"
#include "report/answers/pose.h"
#include "report/answers/tendon_solve.h"
#include "report/answers/tip_force.h"
#include "report/pages/digit_page.h"
#include "report/pages/tendons.h"

namespace thenar::internal {
namespace {

template <typename Request>
void add_tension(RequestTable<Request>& table, std::map<std::string, double> Request::*member) {
  Param& tension = table.add("tension", units::kNewton, map_schema(number_schema("")), member,
                             "Tensions of muscles; others are slack.");
  tension.form = "MUSCLE=newton";
  tension.member.required = true;
}

RequestTable<DigitRequest> moment_arm_params() {
  RequestTable<DigitRequest> table = linear_digit_params();
  table.add_word("hood", kHoodNames, &DigitRequest::hood, "Extensor hood; default: fractions.");
  return table;
}

RequestTable<TipForceRequest> tip_force_params() {
  RequestTable<TipForceRequest> table;
  // Tensions first, then the model of the contact at the tip.
  table.include(linear_digit_params(), &TipForceRequest::digit);
  add_tension(table, &TipForceRequest::tension);
  table.add_word("hold", kTipConstraintNames, &TipForceRequest::hold,
                 "Constraint of the tip: pinned (no moment) or rigid (clamped).");
  // A rigid hold needs a length to compare moments with forces.
  table.add(
      "hold_length", units::kMillimetre, number_schema(""), &TipForceRequest::hold_length,
      "Length by which moments are divided when the force and the moment of a clamped tip are "
      "combined in one norm.");
  return table;
}

/// Adds the bound of the loads of the other kind.
void add_other_load(RequestTable<FeasibleForceRequest>& table, TipLoad load, const std::string& key,
                    const FieldUnit& unit, const std::string& about) {
  // A force may come with moments and a moment with forces; each has its own key, as their units
  // differ.
  table.add(
      {{key, infinite_number_schema("", 0), about}, unit},
      [=](FeasibleForceRequest& request, const Json& value) {
        require_field(key.c_str(), request.load == load,
                      "{} are asked for beside {} alone, and {} is wanted", key,
                      load == TipLoad::kForce ? "a force" : "a moment",
                      load == TipLoad::kForce ? "a moment" : "a force");
        read_value(value, request.max_other);
      },
      [=](const FeasibleForceRequest& request) {
        return request.load == load ? value_json(request.max_other) : Json();
      });
}

RequestTable<FeasibleForceRequest> feasible_force_params() {
  using Request = FeasibleForceRequest;
  RequestTable<Request> table;
  // The load and its direction; without a direction the answer is the set of all loads.
  table.include(linear_digit_params(), &Request::digit);
  table.add_word("load", kTipLoadNames, &Request::load, "Kind of load that is asked for.", "");
  table.add(
      "direction", vector_schema(""), &Request::direction,
      "Direction x y z of the wanted force, or axis of the wanted moment; default: the whole set.");
  // Bounds of the load of the other kind, where a contact is neither a hinge nor a clamp.
  add_other_load(table, TipLoad::kForce, "moments", units::kNewtonMetre,
                 "Largest moment allowed about each axis in addition to the force: 0 = pinned tip, "
                 "inf = clamped tip.");
  add_other_load(table, TipLoad::kMoment, "forces", units::kNewton,
                 "Largest force allowed along each axis in addition to the moment.");
  table.add("tolerance", units::kDegree, number_schema(""), &Request::tolerance,
            "Half-angle of the cone in which the force or moment may lie.", "tolerance-deg");
  table.add_word("frame", kDirectionFrameNames, &Request::frame,
                 "Axes of directions: world: the subject's frame; tip: proximal, dorsal, radial.",
                 "axes");
  table.add("whole_set", flag_schema(), &Request::whole_set,
            "Compute the whole set even if a direction is given.", "set");
  table.add("without", list_schema(text_schema(), 0, 100), &Request::without,
            "Muscles that are paralysed, as under a nerve block; the resulting loss of force is "
            "reported.");
  table
      .add("weakened", units::kNewton, map_schema(number_schema("")), &Request::weakened,
           "Upper tension limits of weakened muscles; the resulting loss of force is reported.")
      .form = "MUSCLE=newton";
  // Reactions of the wrist and of joints at the end of their range.
  table.add_word("wrist", kWristLoadNames, &Request::wrist,
                 "Wrist: held (welded), free (moves and carries the load with the muscles across "
                 "it) or pinch (moves freely, the load is internal to the hand).");
  Param& stops = table.add("stops", units::kNewtonMetre,
                           map_schema(infinite_number_schema("", -kInfinity)), &Request::stops,
                           "Joints at the end of their range and the largest torque of the stop; "
                           "positive: flexion; inf: unlimited.");
  stops.option = "stop";
  stops.form = "JOINT=N_m";
  return table;
}

RequestTable<TendonRequest> tension_params() {
  RequestTable<TendonRequest> table;
  table.include(tendon_params("net"), &TendonRequest::digit);
  add_tension(table, &TendonRequest::tension);
  return table;
}

RequestTable<PoseRequest> pose_params() {
  using Request = PoseRequest;
  RequestTable<Request> table;
  table.add_argument("model", &Request::model, "A subject or a robot: its name, or its file.");
  table.add("digits", list_schema(text_schema(), 0, 100), &Request::digits,
            "Digits of a subject to keep; default: all.", "digit");
  add_posture(table, "posture", &Request::posture,
              "Angles by joint, or in the order of the joints; others stay at 0. Robots: degrees "
              "of freedom or joints, slides in mm.");
  add_posture(table, "frozen", &Request::frozen, "Joints to weld, and their angles.");
  add_vary(table, &Request::vary, &Request::posture);
  add_data(table, &Request::data);
  return table;
}

}  // namespace

void add_digit_questions(std::vector<Question>& all) {
  add_question(all, "pose", "Compute joints, segments or links, and tips at a posture.",
               pose_params(), compute_poses,
               R"({"model": "synek2019_middle", "posture_deg": {"PIP3": 30}})", "pose");
  add_question<DigitRequest, MomentArmResult>(
      all, "moment_arms", "Compute moment arms and length changes of a digit's tendons.",
      moment_arm_params(), compute_moment_arms,
      R"({"subject": "synek2019_middle", "posture_deg": {"MCP3_FE": 20}})", "moment-arms");
  add_question(all, "tip_force", "Compute the force of a fingertip from tendon tensions.",
               tip_force_params(), compute_tip_force,
               R"({"subject": "synek2019_middle", "posture_deg": {"MCP3_FE": 40,
                                  "PIP3": 55}, "tension_N": {"FDP": 10}})",
               "tip-force");
  add_question(
      all, "feasible_force",
      "Compute the largest feasible force or moment of a fingertip, or the whole feasible set.",
      feasible_force_params(), compute_feasible_force,
      R"({"subject": "an_chao_index", "posture_deg": {"MCP2_FE": 45,
                                  "PIP2": 45, "DIP2": 10}, "frame": "tip",
                                  "direction": [0, -1, 0]})",
      "feasible-force");
  add_question(all, "tendons", "Compute bands, slips, torques and tip force of a digit.",
               tension_params(), solve_tendons,
               R"({"subject": "an_chao_index", "net": "chao_an", "posture_deg":
                                  {"MCP2_FE": 20, "PIP2": 30}, "tension_N": {"EDC": 2.9}})",
               "tendon solve");
  add_question(all, "tendon_sweep",
               "Compute bands, slips, torques and tip force of a digit over a grid of postures.",
               tension_params(), sweep_tendons,
               R"({"subject": "synek2019_middle", "tension_N": {"EDC": 2.9},
                                  "vary_deg": [{"joint": "PIP3", "from": 0, "to": 20,
                                  "step": 10}]})",
               "tendon sweep");
}

}  // namespace thenar::internal
