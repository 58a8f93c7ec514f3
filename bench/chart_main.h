#pragma once

/// What every program that draws a chart does beside drawing it.

#include <cstdio>

#include "bench/run_program.h"
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
  return run_program(name, [&] { write_report(page(), argv[1]); });
}

}  // namespace thenar::bench
