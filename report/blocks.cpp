#include "report/blocks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "base/lists.h"

namespace thenar {

BlockColumn::BlockColumn(const char* text) : name(text) {
  if (const std::size_t at = name.rfind(':'); at != std::string::npos && at + 2 == name.size()) {
    digits = name.back() - '0';
    name.resize(at);
  }
  if (const std::size_t at = name.find(" ["); at != std::string::npos) {
    unit = name.substr(at + 2, name.size() - at - 3);
    name.resize(at);
  }
}

Json opening_json(const std::string& asked, const std::string& done, const std::string& learnt) {
  return {{"asked", asked}, {"done", done}, {"learnt", learnt}};
}

Json section(const std::string& id, const std::string& title, const std::string& text,
             Json blocks) {
  return {{"id", id}, {"title", title}, {"text", text}, {"blocks", std::move(blocks)}};
}

Json text_block(const std::string& text) { return {{"type", "text"}, {"text", text}}; }

Json row_block(Json blocks) { return {{"type", "row"}, {"blocks", std::move(blocks)}}; }

Json lines_block(const std::string& caption, const std::string& x_label, const std::string& y_label,
                 Json series) {
  return {{"type", "lines"},
          {"caption", caption},
          {"x_label", x_label},
          {"y_label", y_label},
          {"series", std::move(series)}};
}

Json interval_block(const std::string& caption, const std::string& x_label, Json rows) {
  return {
      {"type", "interval"}, {"caption", caption}, {"x_label", x_label}, {"rows", std::move(rows)}};
}

Json table_block(const std::string& caption, const std::vector<BlockColumn>& columns, Json rows) {
  Json heads = Json::array();
  for (const BlockColumn& column : columns) {
    Json head{{"name", column.name}};
    if (!column.unit.empty()) head["unit"] = column.unit;
    if (column.digits >= 0) head["digits"] = column.digits;
    heads.push_back(std::move(head));
  }
  return {{"type", "table"}, {"caption", caption}, {"columns", heads}, {"rows", std::move(rows)}};
}

Json json_of_cell(const std::string& cell) {
  if (cell == "-" || cell == "inf" || cell == "-inf" || cell == "nan") return nullptr;
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  return !cell.empty() && *end == '\0' ? Json(value) : Json(cell);
}

std::vector<BlockColumn> columns_of(const Table& table) {
  return transformed(table.header, [](const std::string& name) { return BlockColumn(name, ""); });
}

Json table_block(const std::string& caption, const Table& table) {
  const auto line = [](const auto& cells) { return list_of_each(cells, json_of_cell); };
  return table_block(caption, columns_of(table), list_of_each(table.rows, line));
}

Json banner_block(const std::string& title, Json reasons, bool ok) {
  return {{"type", "banner"}, {"ok", ok}, {"title", title}, {"reasons", std::move(reasons)}};
}

Json refusal_banner(const std::string& refusal, const std::vector<std::string>& warnings,
                    const std::string& failed_title, const std::string& title) {
  std::vector<std::string> reasons = warnings;
  if (!refusal.empty()) reasons.insert(reasons.begin(), refusal);
  const bool ok = refusal.empty();
  return with(banner_block(ok ? title : failed_title, reasons, ok),
              {{"caution", ok && !reasons.empty()}});
}

Json with(Json block, const Json& more) {
  block.update(more);
  return block;
}

Json joined(Json list, const Json& more) {
  for (const Json& each : more) list.push_back(each);
  return list;
}

Json curve_json(const std::string& name, Json x, Json y, const std::string& style) {
  Json curve{{"name", name}, {"x", std::move(x)}, {"y", std::move(y)}};
  if (!style.empty()) curve["style"] = style;
  return curve;
}

Json& entry_named(Json& list, const char* key, const std::string& name, const char* parts) {
  for (Json& entry : list)
    if (entry[key] == name) return entry;
  list.push_back({{key, name}, {parts, Json::array()}});
  return list.back();
}

Json layer(const std::string& name, const std::string& color, Json items) {
  return {{"name", name}, {"color", color}, {"items", std::move(items)}};
}

Json in_mm(const Eigen::Vector3d& p) { return numbers3(1000 * p); }

Json numbers3(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

std::vector<Eigen::Index> spread(Eigen::Index count, Eigen::Index most) {
  std::vector<Eigen::Index> chosen;
  const Eigen::Index wanted = std::min(count, most);
  for (Eigen::Index k = 0; k < wanted; ++k) chosen.push_back(k * count / wanted);
  return chosen;
}

Json rounded(const Eigen::Ref<const Eigen::VectorXd>& values, double scale) {
  const bool usable = std::isfinite(scale) && scale > 0;
  const int decimals =
      usable ? std::clamp(3 - static_cast<int>(std::floor(std::log10(scale))), 0, 15) : 6;
  return list_of_each(values, [&](double value) {
    return std::isfinite(value) ? Json(std::stod(fmt::format("{:.{}f}", value, decimals))) : Json();
  });
}

}  // namespace thenar
