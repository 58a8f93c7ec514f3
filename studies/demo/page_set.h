#pragma once

/// Pages of one folder that lead to each other, and the front page that sums them up.

#include <string>
#include <vector>

#include "report/blocks.h"

namespace thenar {

/// The first paragraph of a page.
struct Opening {
  std::string asked, done, learnt;  // sentences
};

/// A page of a set.
struct SetPage {
  std::string file;   // file name in the folder: "forces.html"
  std::string title;  // title in lists of pages, a question if the page answers one
  Opening opening;
  std::string line;  // summary line on the front page; empty: none
  Json page;         // page for write_page()
  Json figure;       // the block that stands for it on the front page; null: none
};

/// Returns the first block of a type in the sections of a page, also within rows; null if there is
/// none.
[[nodiscard]] Json first_block(const Json& page, const std::string& type);

/// The front page of a set: the lines as its summary, and for each page that has a line a section
/// with what was learnt, its figure and a link. Meshes that figures show are copied.
/// @param front  file, title, opening and page without sections; gets them
void sum_up(const std::vector<SetPage>& pages, SetPage& front);

/// Gives every page its opening and the list of all pages.
void link_pages(std::vector<SetPage>& pages);

}  // namespace thenar
