#include "studies/demo/page_set.h"

namespace thenar {
namespace {

Json first_among(const Json& blocks, const std::string& type) {
  for (const Json& block : blocks) {
    if (block.at("type") == type) return block;
    if (block.at("type") != "row") continue;
    Json inner = first_among(block.at("blocks"), type);
    if (!inner.is_null()) return inner;
  }
  return nullptr;
}

/// The blocks of a row, or the block itself.
std::vector<Json*> parts_of(Json& block) {
  if (block["type"] != "row") return {&block};
  std::vector<Json*> parts;
  for (Json& inner : block["blocks"]) parts.push_back(&inner);
  return parts;
}

/// Copies the meshes that a figure shows from the page that has them. Each page has names of its
/// own, so that a prefix tells them apart.
void take_meshes(const Json& from, const std::string& prefix, Json& figure, Json& meshes) {
  for (Json* block : parts_of(figure)) {
    if ((*block)["type"] != "scene") continue;
    for (Json& layer : (*block)["layers"])
      for (Json& item : layer["items"]) {
        if (item["kind"] != "mesh") continue;
        const auto name = item["mesh"].get<std::string>();
        meshes[prefix + name] = from.at("meshes").at(name);
        item["mesh"] = prefix + name;
      }
  }
}

std::string stem_of(const std::string& file) { return file.substr(0, file.rfind('.')); }

}  // namespace

Json first_block(const Json& page, const std::string& type) {
  for (const Json& section : page.at("sections")) {
    Json found = first_among(section.at("blocks"), type);
    if (!found.is_null()) return found;
  }
  return nullptr;
}

void fill_front_page(const std::vector<SetPage>& pages, SetPage& front) {
  Json lines = Json::array(), sections = Json::array(), meshes = Json::object();
  // Each page gives one line, one figure and a link to the whole.
  for (const SetPage& page : pages) {
    if (page.line.empty()) continue;
    lines.push_back({{"text", page.line}, {"file", page.file}, {"link", "More"}});
    Json blocks = Json::array();
    if (!page.figure.is_null()) {
      Json figure = page.figure;
      take_meshes(page.page, stem_of(page.file) + "-", figure, meshes);
      blocks.push_back(std::move(figure));
    }
    blocks.push_back({{"type", "text"},
                      {"text", ""},
                      {"link", {{"file", page.file}, {"text", "Full page: " + page.title}}}});
    sections.push_back(
        section("about-" + stem_of(page.file), page.title, page.opening.learnt, std::move(blocks)));
  }
  front.page["summary"] = std::move(lines);
  front.page["sections"] = std::move(sections);
  front.page["meshes"] = std::move(meshes);
}

void link_pages(std::vector<SetPage>& pages) {
  const Json list = list_of_each(pages, [](const SetPage& page) {
    return Json{{"file", page.file}, {"title", page.title}};
  });
  for (SetPage& page : pages) {
    page.page["file"] = page.file;
    page.page["pages"] = list;
    page.page["opening"] = opening_json(page.opening.asked, page.opening.done, page.opening.learnt);
  }
}

}  // namespace thenar
