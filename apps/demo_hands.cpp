#include "apps/demo_hands.h"

#include <utility>
#include <vector>

#include "apps/compare_inputs.h"
#include "apps/compare_report.h"
#include "grasp/compare/compare_hands.h"
#include "report/blocks.h"
#include "report/pages/comparison_tables.h"

namespace thenar {
namespace {

constexpr const char* kPage = "hands.html";

}  // namespace

nlohmann::json compare_hands(const std::string& data, const std::string& output,
                             const Progress& progress) {
  CompareQuestion question;
  question.hands = {"barrett", "shadow", "parallel_jaw"};
  question.objects = {"sphere_70", "cube_50"};
  question.approaches = 8;
  question.data = data;
  const std::vector<BodySpec> objects = objects_of(question);
  const std::vector<NamedHand> hands = named_hands(question);
  const Comparison comparison =
      compare(hands_of(question, hands), objects, options_of(question), progress);
  write_compare_report(comparison, objects, hands, compare_provenance(compare_inputs(question)),
                       output + "/" + kPage);

  Json section = glance_section(comparison);
  section["id"] = "hands";
  section["title"] = "Hands that grasp";
  section["blocks"].push_back({{"type", "text"},
                               {"text", "Pictures of the best grasps and all that was measured:"},
                               {"link", {{"file", kPage}, {"text", "Hands compared"}}}});
  return section;
}

}  // namespace thenar
