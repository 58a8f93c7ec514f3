#pragma once

/// What every program that draws a chart does beside drawing it.

#include <cstdio>
#include <exception>

#include "report/blocks.h"
#include "report/page.h"

namespace thenar::bench {

/// NAME PAGE.html: writes the page, or says why not. @returns the exit code
template <typename Page>
int write_chart(const char* name, int argc, char** argv, Page page) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s PAGE.html\n", name);
    return 2;
  }
  try {
    write_report(page(), argv[1]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", name, e.what());
    return 1;
  }
  return 0;
}

}  // namespace thenar::bench
