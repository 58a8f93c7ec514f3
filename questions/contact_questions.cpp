// Questions about contacts: contact sets, grasps in worlds, comparisons of hands.

#include "api/compare.h"
#include "api/grasp.h"
#include "api/quality.h"
#include "questions/digit_params.h"
#include "questions/make_question.h"
#include "questions/question_params.h"
#include "questions/question_rows.h"
#include "report/answers/answer_files.h"
#include "report/answers/comparison.h"
#include "report/answers/grasp.h"
#include "report/answers/quality.h"
#include "report/pages/comparison.h"
#include "report/pages/grasp.h"

namespace thenar {
namespace {

constexpr std::size_t kMaxContactText = 1'000'000;  // Bytes of a contact set in a request

ContactQualityResult measure(const ContactQualityRequest& request, const Progress& /*progress*/) {
  return measure_contacts(request);
}

}  // namespace

RequestTable<ContactQualityRequest> contact_params() {
  // The contacts come from a file or a name, or as text; on the command line the text is a file.
  using Request = ContactQualityRequest;
  RequestTable<Request> table;
  table
      .add("contacts", text_schema(), &Request::contacts,
           "Contact set: a file (JSON), or a name of contacts/.")
      .is_positional = true;
  table.add("text", content_schema(kMaxContactText), &Request::text,
            "The contact set itself (JSON), in place of a file.", "");
  table.add(
      "edges", integer_schema(0, 1e9), &Request::edges,
      "Number of edges of friction pyramids, 3 to 1000, in place of cones; 0: the true cones. "
      "Soft fingers get double pyramids with poles at their torsion.");
  table.add("first_edge", units::kDegree, number_schema(""), &Request::first_edge,
            "Angle of the pyramids' first edges about the normals.");
  // Add the limits of the forces, and the accuracy of epsilon and volume.
  table.add_word("norm", kForceNormNames, &Request::norm,
                 "Limit of contact forces: l1: the sum of all normal forces is at most 1; linf: "
                 "the sum within each patch is at most 1.");
  table.add(
      "gap", number_schema(""), &Request::gap,
      "Largest difference between the certified bounds of epsilon, in units of normal force.");
  table
      .add("volume", flag_schema(), &Request::volume,
           "Compute the volume, which takes 80 to 5,000 times as long as epsilon.", "!no-volume")
      .off_description = "Skip the volume, which takes 80 to 5,000 times as long as epsilon.";
  add_data(table, &Request::data);
  return table;
}

RequestTable<WorldRequest> world_params() {
  // Add the world, which may have several hands and objects.
  RequestTable<WorldRequest> table;
  table.add_argument("world", &WorldRequest::world, "A world: its name, or its file (TOML).");
  table.add("hand", text_schema(), &WorldRequest::hand, "Hand to use, where there are several.");
  table.add("object", text_schema(), &WorldRequest::object,
            "Object to grasp, where there are several.");
  // Add options of human hands, which robots ignore.
  table.add_word("passive", kPassiveNames, &WorldRequest::passive,
                 "Include the passive moments of human joints that the subject states.");
  add_path(table, &WorldRequest::path);
  add_data(table, &WorldRequest::data);
  return table;
}

RequestTable<GraspRequest> grasp_params() {
  using Request = GraspRequest;
  RequestTable<Request> table;
  // The world states where hand and object begin.
  table.include(world_params(), &Request::world);
  table
      .add("approach", flag_schema(), &Request::approach,
           "Approach along the palm's direction before closing (default).", "approach,!no-approach")
      .off_description = "Close the hand where it is, without approaching first.";
  table.add("approach_distance", units::kMetre, number_schema("", 0), &Request::approach_distance,
            "Farthest approach.", "approach-distance,way");
  table.add("starts", integer_schema(0, 1e9), &Request::starts,
            "Number of random pregrasps to try, drawn as in comparisons; the best is kept. 0: the "
            "world's own pregrasp. With random pregrasps the hand may be any hand by name.",
            "random");
  table.add("seed", integer_schema(0, 4294967295.0), &Request::seed,
            "Seed of random starts and of robustness.");
  // Add robustness: repeated grasps with random friction, contacts and pose.
  RequestTable<RobustnessRequest> robustness;
  robustness.add("robustness", integer_schema(0, 1e9), &RobustnessRequest::draws,
                 "Draws of uncertain friction, contacts and pose of the object; 0: none.");
  table.include(robustness, &Request::robustness);
  // Add the norm of the contact forces, and the certified gap of epsilon.
  table.add_word("norm", kForceNormNames, &Request::limit,
                 "Limit of contact forces: l1: the sum of all normal forces is at most 1; linf: "
                 "the sum within each patch is at most 1.");
  table.add("tolerance", number_schema(""), &Request::tolerance,
            "Largest difference of the certified bounds of epsilon, also of robustness.",
            "tolerance,gap");
  table.add(
      "edges", integer_schema(0, 1e9), &Request::edges,
      "Number of edges of friction pyramids in epsilon, volume, robustness and wrench sets; 0: "
      "cones, as all other measures have.");
  table.add("wrench_meshes", flag_schema(), &Request::wrench_meshes,
            "With JSON, also the wrench set as meshes: projected and cut.", "wrenches");
  return table;
}

RequestTable<CompareRequest> compare_params() {
  using Request = CompareRequest;
  const Schema names = list_schema(text_schema(), 1, 100);
  RequestTable<Request> table;
  // Add the hands and objects, all of which are combined, and the tasks.
  table.add(
      "hands", names, &Request::hands,
      "Hands: human:orthogonal, human:skewed, human:soft, human:tendons; names of robots/; or "
      "files.");
  table.add("objects", names, &Request::objects, "Objects: names of objects/, or files.");
  table.add_words("tasks", names, "task", kGraspTaskNames, &Request::tasks,
                  "Tasks: some of force-closure, hold-weight, pull, turn.");
  // Add the effort of the search, and its seed.
  table.add("approaches", integer_schema(1, 1e9), &Request::approaches,
            "Random approaches of each hand to each object.");
  table.add("best", integer_schema(0, 1e9), &Request::best,
            "Grasps of each pair whose loads are computed.");
  table.add("seed", integer_schema(0, 4294967295.0), &Request::seed,
            "Seed of the random approaches.");
  table.add(
      "threads", integer_schema(0, 1e9), &Request::threads,
      "Number of threads; 0: as many as there are processors; the answer is the same with any "
      "number.");
  table.add("normalise_size", flag_schema(), &Request::normalise_size,
            "Scale objects by each hand's digit reach relative to the first hand's.");
  // Add the models: paths of tendons, materials and friction.
  add_path(table, &Request::path);
  table.add("materials", text_schema(), &Request::materials,
            "File of materials and friction of your own (TOML), over the built-in table.");
  add_data(table, &Request::data);
  table.add("output", saved_file_schema(), &Request::file,
            "File (.json) that is written after every pair; an existing one is continued.", "");
  return table;
}

void internal::add_contact_questions(std::vector<Question>& all) {
  add_question(all, "contacts",
               "Compute the quality (epsilon, volume, task margin) of a set of contacts.",
               contact_params(), measure, R"({"contacts": "two_soft_fingers"})", "quality");
  add_question(
      all, "grasp", "Approach and grasp the object of a world, and compute the grasp quality.",
      grasp_params(), measure_grasp, R"({"world": "jaw_box"})", "grasp", QuestionPace::kLasts);
  add_question(
      all, "compare", "Compare hands on the same objects and tasks.", compare_params(),
      compare_hands,
      R"({"hands": ["barrett", "parallel_jaw"], "objects": ["sphere_70"], "approaches": 2})",
      "compare", QuestionPace::kLasts);
}

}  // namespace thenar
