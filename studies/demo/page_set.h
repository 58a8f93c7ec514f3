#pragma once

/// Linked pages of one folder, and the front page that summarises them.

#include <string>
#include <vector>

#include "report/blocks.h"

namespace thenar {

/// First paragraph of a page.
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
  Json figure;       // block that represents it on the front page; null: none
};

/// Returns the first block of a type in the sections of a page, also within rows; null if there is
/// none.
[[nodiscard]] Json first_block(const Json& page, const std::string& type);

/// Fills the front page of a set: the lines are its summary, and each page with a line gets a
/// section with its result, its figure and a link. Meshes of figures are copied.
/// @param front  file, title, opening and page without sections; receives the sections
void fill_front_page(const std::vector<SetPage>& pages, SetPage& front);

/// Adds to every page its opening and the list of all pages.
void link_pages(std::vector<SetPage>& pages);

}  // namespace thenar
