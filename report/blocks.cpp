#include "report/blocks.h"

namespace thenar {

Json section(const std::string& id, const std::string& title, const std::string& text,
             Json blocks) {
  return {{"id", id}, {"title", title}, {"text", text}, {"blocks", std::move(blocks)}};
}

Json text_block(const std::string& text) { return {{"type", "text"}, {"text", text}}; }

Json row_block(Json blocks) { return {{"type", "row"}, {"blocks", std::move(blocks)}}; }

Json table_block(const std::string& caption, const std::vector<Column>& columns, Json rows) {
  Json heads = Json::array();
  for (const Column& column : columns) {
    Json head{{"name", column.name}};
    if (!column.unit.empty()) head["unit"] = column.unit;
    if (column.digits >= 0) head["digits"] = column.digits;
    heads.push_back(std::move(head));
  }
  return {{"type", "table"}, {"caption", caption}, {"columns", heads}, {"rows", std::move(rows)}};
}

Json layer(const std::string& name, const std::string& color, Json items) {
  return {{"name", name}, {"color", color}, {"items", std::move(items)}};
}

Json in_mm(const Eigen::Vector3d& p) { return list(1000 * p); }

Json list(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

}  // namespace thenar
