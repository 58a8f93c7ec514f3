#include "data/io/foreign_mesh/parsers.h"

#include <sys/resource.h>

#include "base/file_io.h"
#include "data/io/file_guard.h"

namespace thenar {
namespace {

/// Sets the number of files that may be open: none, or the system's maximum.
void set_open_files(bool any) {
  rlimit files{};
  if (getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = any ? files.rlim_max : 0;
  (void)setrlimit(RLIMIT_NOFILE, &files);
}

}  // namespace

void forbid_opening_files() { set_open_files(false); }

std::string read_permitted_file(const std::string& path) {
  // Open this one file, and restore the limit.
  rlimit before{};
  (void)getrlimit(RLIMIT_NOFILE, &before);
  set_open_files(true);
  std::string text = read_guarded(path, GuardedKind::kMesh);
  (void)setrlimit(RLIMIT_NOFILE, &before);
  return text;
}

bool is_file_beside(const std::string& path, const std::string& file) {
  return is_in_folder_of(path, file) && is_file(file);
}

}  // namespace thenar
