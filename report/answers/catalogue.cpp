#include "report/answers/catalogue.h"

#include "base/lists.h"

namespace thenar {

namespace {

/// Names of one kind; sources where there are some.
Table table_of_kind(const std::vector<CatalogueEntry>& entries) {
  const bool sources = any_of(entries, [](const auto& each) { return !each.source.empty(); });
  Table table{{entries.front().kind, "about"}};
  if (sources) table.header.emplace_back("source");
  for (const CatalogueEntry& entry : entries) {
    table.add({entry.name, or_dash(entry.about)});
    if (sources) table.rows.back().push_back(or_dash(entry.source));
  }
  return table;
}

}  // namespace

std::string text_of(const Catalogue& catalogue) {
  std::string text;
  std::vector<CatalogueEntry> group;
  for (std::size_t i = 0; i < catalogue.entries.size(); ++i) {
    group.push_back(catalogue.entries[i]);
    const bool last = i + 1 == catalogue.entries.size();
    if (!last && catalogue.entries[i + 1].kind == group.front().kind) continue;
    text += (text.empty() ? "" : "\n") + aligned(table_of_kind(group));
    group.clear();
  }
  return text.empty() ? "none\n" : text;
}

OrderedJson json_of(const Catalogue& catalogue) {
  return list_of_each<OrderedJson>(catalogue.entries, [](const CatalogueEntry& entry) {
    return OrderedJson{{"kind", entry.kind},
                       {"name", entry.name},
                       {"about", entry.about},
                       {"source", entry.source},
                       {"file", entry.file}};
  });
}

Table table_of(const Catalogue& catalogue) {
  Table table{{"kind", "name", "about", "source", "file"}};
  for (const CatalogueEntry& entry : catalogue.entries)
    table.add({entry.kind, entry.name, entry.about, entry.source, entry.file});
  return table;
}

}  // namespace thenar
