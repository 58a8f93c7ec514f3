#include "apps/grasp_report.h"

#include <fmt/format.h>

#include "apps/grasp_measures.h"
#include "apps/grasp_robustness.h"
#include "base/provenance.h"
#include "data/io/toml_node.h"
#include "report/page.h"
#include "report/pages/grasp.h"
#include "report/scene/grasp_view.h"

namespace thenar {
namespace {

constexpr double kTouches = 2e-4;  // gap up to which a stop is told with what it touches [m]

Json provenance(const GraspQuestion& question) {
  Json json = Json::object();
  json[question.path] = "sha256 " + sha256(read_text_file(question.path));
  for (const auto& [name, version] : versions()) json[name] = version;
  if (question.starts > 0) json["seed"] = std::to_string(question.seed);
  return json;
}

}  // namespace

std::vector<JointRow> joint_rows(const GraspQuestion& question, const CollisionHand& touching,
                                 const GraspAnswer& answer) {
  const ClosedHand& closed = answer.grasp.closed;
  if (closed.stopped.empty()) return {};
  const Hand& hand = *touching.hand;
  const PosedCollisionHand posed{touching, answer.grasp.approached.X_WH, hand.pose(closed.q)};
  const std::vector<std::string> why =
      stop_words(touching, closed, find_touching(posed, question.scene, kTouches));
  std::vector<JointRow> rows;
  for (std::size_t c = 0; c < why.size(); ++c) {
    const auto i = static_cast<int>(c);
    rows.push_back({hand.layout().coordinates[c], closed.q[i],
                    value_words(closed.q[i], slides(hand, closed.q, i)), name_of(closed.stopped[c]),
                    why[c]});
  }
  return rows;
}

Table contact_table(const CollisionHand& touching, const std::vector<HandContact>& contacts) {
  Table table{{"surface", "x_mm", "y_mm", "z_mm", "nx", "ny", "nz", "friction", "torsion_mm"}, {}};
  for (const HandContact& found : contacts) {
    const Contact& c = found.contact;
    const auto surface = static_cast<std::size_t>(found.surface);
    table.rows.push_back(row({{touching.hand->surfaces()[surface].name},
                              cells(Eigen::Vector3d(1000 * c.p), 2),
                              cells(c.n, 3),
                              {shown(c.friction, 2), shown(1000 * c.torsion, 2)}}));
  }
  return table;
}

void write_grasp_report(const GraspQuestion& question, const CollisionHand& touching,
                        const GraspAnswer& answer, const std::string& path) {
  const Hand& hand = *question.hand.named.hand;
  const Grasp& grasp = answer.grasp;
  const HandPicture picture{hand, grasp.closed.q, grasp.approached.X_WH,
                            question.hand.named.patches, question.hand.carrier_surfaces};
  const Camera& camera = question.world.camera;
  MeshTable meshes;
  GraspStory story{picture,
                   touching,
                   question.scene,
                   grasp,
                   answer.wrenches,
                   question.limit,
                   view_of_contacts(picture, question.scene, grasp.contacts,
                                    {camera.eye - camera.target, Eigen::Vector3d::UnitZ()}),
                   warnings_of(question, answer),
                   {},
                   {}};
  if (answer.measures) story.measures = measure_rows(*answer.measures);
  if (answer.robustness) story.robustness = robustness_rows(*answer.robustness);
  const Json sections = grasp_page(story, meshes);
  write_report(
      {{"title", fmt::format("{} and {}", question.hand.named.name, question.scene.object.name)},
       {"subtitle", question.world.description},
       {"provenance", provenance(question)},
       {"meshes", meshes.json()},
       {"sections", sections}},
      path);
}

}  // namespace thenar
