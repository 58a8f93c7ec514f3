// Questions about motion and deformation: digits with excited muscles, scenes of bodies and hands,
// pads under objects.

#include "api/pads/press_pad.h"
#include "api/scenes/simulate_scene.h"
#include "api/simulate.h"
#include "base/error.h"
#include "questions/digit_params.h"
#include "questions/make_question.h"
#include "questions/question_params.h"
#include "questions/question_rows.h"
#include "report/answers/answer_files.h"
#include "report/answers/simulate.h"
#include "report/answers/simulate_scene.h"
#include "report/pads/press_answer.h"
#include "report/pages/scene_run.h"
#include "report/pages/tendons.h"

namespace thenar {
namespace {

RequestTable<PressRequest> press_params() {
  using Request = PressRequest;
  // Add the pressing object: a shape, or a mesh.
  RequestTable<PressObjectRequest> object;
  object.add("object", text_schema(), &PressObjectRequest::name,
             "Object that presses: " + listed(press_object_names()) + ", or a mesh file.");
  object.add("radius", units::kMillimetre, number_schema("", 0), &PressObjectRequest::radius,
             "Radius of a sphere or cylinder (default: 10 mm), or of an edge's rounding (default: "
             "0.5 mm).");
  object.add("scale", number_schema("", 0), &PressObjectRequest::scale,
             "Scale of a mesh: metres per unit of its file.");
  // Add the pad, and tissue laws in place of those of its file.
  RequestTable<PadRequest> pad;
  pad.add("pad", text_schema(), &PadRequest::pad, "A pad: its name, or its file (TOML).");
  pad.add("law", text_schema(), &PadRequest::law,
          "Law of its tissues: " + listed(tissue_law_names()) + "; default: from the pad's file.");
  pad.add("exponent", number_schema(""), &PadRequest::exponent,
          "Exponent of the laws ogden and veronda-westmann.");
  pad.add(
      "element", text_schema(), &PadRequest::element,
      "Elements of its mesh: " + listed(pad_element_names()) + "; default: from the pad's file.");
  add_data(pad, &PadRequest::data);
  RequestTable<Request> table;
  table.include(object, &Request::object);
  // Add the end of the press: either a force or a depth.
  table.add("force", units::kNewton, number_schema(""), &Request::force,
            "Force at which the press ends.");
  table.add("depth", units::kMillimetre, number_schema(""), &Request::depth,
            "Depth at which the press ends, measured from first touch.");
  // Add the motion of the object: orientation, rate and holding time.
  table.add(
      "angle", units::kDegree, number_schema(""), &Request::angle,
      "Angle of the pad to the object, with the finger's proximal end lifted, -60 to 60 deg.");
  table.add("turn", units::kDegree, number_schema(""), &Request::turn,
            "Rotation of the object about the direction of pressing.");
  table.add("rate", units::kMillimetrePerSecond, number_schema("", 0), &Request::rate,
            "Speed of the object; 0: quasi-static (fully relaxed); default: instantaneous (no "
            "relaxation).");
  table.add("hold", units::kSecond, number_schema("", 0), &Request::hold,
            "Time for which the object is then held still.");
  table.add("friction", number_schema("", 0), &Request::friction,
            "Coefficient of friction of the skin on the object.");
  table.include(pad, &Request::pad);
  table.add("force_error", units::kPercent, number_schema("", 0), &Request::force_error,
            "Estimated error of the force below which the mesh is not refined.", "error");
  table.add("max_elements", integer_schema(1, 1e9), &Request::max_elements,
            "Number of elements at which refinement stops.");
  table.add("points", integer_schema(1, 1e9), &Request::points, "Number of points on the curves.");
  table.add("hold_points", integer_schema(1, 1e9), &Request::hold_points,
            "Number of points on the curves while the object is held still.");
  table.add("rungs", flag_schema(), &Request::rungs,
            "Also compare reduced laws, elements and meshes: error over time; takes minutes.",
            "chart");
  return table;
}

/// Simulates a sweep of scenes; a single process always has the result.
SceneSweepResult sweep(const SceneRequest& request, const Progress& progress) {
  return sweep_scene(request, progress).value();
}

}  // namespace

RequestTable<DigitMotionRequest> digit_motion_params() {
  using Request = DigitMotionRequest;
  RequestTable<Request> table;
  table.include(tendon_params("fractions"), &Request::digit);
  // Add the excitations: constants, or a table over time.
  table
      .add("excitation", map_schema(number_schema("")), &Request::excitation,
           "Excitations of muscles, 0 to 1, from the start on; others are 0.")
      .form = "MUSCLE=0..1";
  table.add("excitation_file", text_schema(), &Request::excitation_file,
            "CSV time_s,MUSCLE,...: straight lines between its rows.");
  // Add the model of muscles; only elastic tendons need slack lengths.
  table.add_word(
      "muscle", kMuscleNames, &Request::muscle,
      "Muscle model; default: rigid-tendon, or bounds if the subject states no fibre lengths.");
  table
      .add("tendon_slack", units::kMillimetre, map_schema(number_schema("")),
           &Request::tendon_slack, "Slack lengths of tendons, for elastic ones.")
      .form = "MUSCLE=mm";
  // Add the damping of soft tissue, and the smoothing of bands at the onset of tension.
  table.add("damping", units::kJointDamping, number_schema("", 0), &Request::damping,
            "Damping of joints whose subject gives none.");
  table.add("blend", number_schema("", 0), &Request::blend,
            "Strain over which the bands of a net go from slack to taut.");
  table.add("gravity", units::kMetrePerSquareSecond, vector_schema(""), &Request::gravity,
            "Gravitational acceleration, in the subject's frame.");
  // Add duration, sampling and the tolerance of the integrator.
  table.add("seconds", number_schema("", 0), &Request::seconds, "Duration.");
  table.add("sample", units::kMillisecond, number_schema("", 0), &Request::sample,
            "Time between the instants kept.", "sample-ms");
  table.add("tolerance", number_schema("", 0), &Request::tolerance, "Relative error of one step.");
  return table;
}

RequestTable<SceneRequest> scene_params() {
  using Request = SceneRequest;
  RequestTable<Request> table;
  table.add_argument("scene", &Request::scene,
                     "A scene of bodies and hands: its name, or its file (TOML).");
  table
      .add_word(
          "method", kSteppingMethodNames, &Request::method,
          "Stepping: " + listed(names_in(kSteppingMethodNames)) + "; default: from the scene.")
      .member.schema = text_schema();
  table.add("pads", text_schema(), &Request::pads,
            "Level of detail of all its pads: " + listed(pad_rung_names()) +
                "; default: from the scene.");
  add_path(table, &Request::path);
  table.add("on_pins", flag_schema(), &Request::on_pins,
            "Replace compliant joints by ideal ones: no joint gives.", "");
  table.add("seconds", number_schema("", 0), &Request::seconds,
            "Duration; default: from the scene.");
  table.add("sample", units::kMillisecond, number_schema("", 0), &Request::sample,
            "Time between the instants kept; default: from the scene.", "sample-ms");
  table.add("step", units::kMillisecond, number_schema("", 0), &Request::step,
            "Length of every step, by time-stepping.", "step-ms");
  table.add("tolerance", number_schema("", 0), &Request::tolerance,
            "Error of one step, in m and rad.");
  add_data(table, &Request::data);
  return table;
}

RequestTable<SceneRequest> scene_sweep_params() {
  using Request = SceneRequest;
  // Add the parameters of a scene.
  RequestTable<Request> table = scene_params();
  const Schema range = object_schema({{"name", text_schema(), "Which number.", true},
                                      {"from", number_schema(""), "First value.", true},
                                      {"to", number_schema(""), "Last value.", true},
                                      {"count", integer_schema(1, kMaxRuns), "Values.", true}});
  Param vary{{"vary", list_schema(range, 1, 20),
              "Numbers that differ from run to run: friction, mass/BODY [kg], force/NAME [N], "
              "drive/NAME [N, N m], step [s], longest [s], tolerance; a run for each combination."},
             units::kOne};
  vary.member.required = true;
  // Add the values that vary; every combination is one run.
  table.add(
      vary,
      [](Request& request, const Json& value) {
        request.vary.clear();
        for (const Json& each : value)
          request.vary.push_back({each["name"].get<std::string>(), each["from"].get<double>(),
                                  each["to"].get<double>(), each["count"].get<int>()});
      },
      [](const Request& request) {
        Json list;
        for (const SceneVariation& each : request.vary)
          list.push_back(
              {{"name", each.name}, {"from", each.from}, {"to", each.to}, {"count", each.count}});
        return list;
      });
  return table;
}

void internal::add_motion_questions(std::vector<Question>& all) {
  add_question(all, "digit_motion", "Simulate a digit with excited muscles.", digit_motion_params(),
               simulate_digit,
               R"({"subject": "an_chao_index", "excitation": {"FDP": 0.1},
                                  "seconds": 0.05})",
               "simulate", QuestionPace::kLasts);
  add_question<SceneRequest, SceneResult>(
      all, "scene", "Simulate a scene of bodies and hands.", scene_params(), simulate_scene,
      R"({"scene": "incline_slide", "seconds": 0.1})", "simulate", QuestionPace::kLasts);
  add_question(
      all, "scene_sweep", "Simulate a scene for ranges of its numbers.", scene_sweep_params(),
      sweep,
      R"({"scene": "incline_slide", "seconds": 0.1, "vary": [{"name": "friction", "from": 0.1,
          "to": 0.3, "count": 2}]})",
      "simulate", QuestionPace::kLasts);
  add_question(all, "press",
               "Compute force, area, pressure and sticking area of a pad under an object.",
               press_params(), press_pad, R"({"depth_mm": 0.5, "points": 2, "max_elements": 500})",
               "pad press", QuestionPace::kLasts);
}

}  // namespace thenar
