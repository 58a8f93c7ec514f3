// thenar-mesh-reader FILE [SECONDS]
//
// Writes the triangles of a glTF, Collada, VRML or Inventor file to the standard output, in the
// form of data/io/mesh/reader_answer.h. thenar runs it for each such file: third-party parsers run
// only here, under limits of memory and time, and can open no file but those they are given.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "data/io/foreign_mesh/parsers.h"
#include "data/io/mesh/bounded_process.h"
#include "data/io/mesh/foreign_mesh.h"
#include "data/io/mesh/reader_answer.h"

// The address sanitizer reserves address space, so that memory is limited by residence instead.
// NOLINTNEXTLINE(bugprone-reserved-identifier, readability-identifier-naming): ASan asks for it
extern "C" const char* __asan_default_options();
// NOLINTNEXTLINE(bugprone-reserved-identifier, readability-identifier-naming): ASan asks for it
extern "C" const char* __asan_default_options() { return "detect_leaks=0:hard_rss_limit_mb=1200"; }

namespace thenar {
namespace {

void limit(decltype(RLIMIT_CPU) what, rlim_t most, rlim_t beyond = 0) {
  const rlimit both{most, most + beyond};
  (void)setrlimit(what, &both);
}

#ifndef __SANITIZE_ADDRESS__
/// Address space that this process has mapped already: its libraries [bytes].
rlim_t mapped() {
  std::ifstream pages("/proc/self/statm");
  rlim_t count = 0;
  pages >> count;
  return count * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}
#endif

/// @param seconds  of the processor, if fewer than the limit are left [s]
void set_limits(int seconds) {
  const MeshReaderLimits limits;
  // SIGKILL follows a second after SIGXCPU, which tells the reason.
  const int most = std::clamp(seconds, 1, limits.processor_seconds);
  limit(RLIMIT_CPU, static_cast<rlim_t>(most), 1);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);  // it writes no file
#ifndef __SANITIZE_ADDRESS__
  limit(RLIMIT_AS, mapped() + limits.memory);
#endif
}

std::string answer(const std::string& path) {
  try {
    const MeshFormat format = mesh_format(path);
    const bool inventor = format == MeshFormat::kVrml || format == MeshFormat::kInventor;
    return answer_of(inventor ? read_inventor_mesh(path) : read_assimp_mesh(path));
  } catch (const std::bad_alloc&) {
    return answer_of("needs more memory than a mesh is given");
  } catch (const std::exception& error) {
    return answer_of(error.what());
  }
}

/// Moves the standard output away, so that nothing printed by a parser mixes with the answer.
int keep_output() {
  const int output = dup(1);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) (void)dup2(nowhere, 1);
  return output;
}

bool write_all(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    // A pipe may take less than all.
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written <= 0) return false;
    done += static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace
}  // namespace thenar

int main(int argc, char** argv) {
  // It must not outlive thenar.
  thenar::end_with_parent();
  if (argc != 2 && argc != 3) {
    (void)std::fputs(
        "thenar-mesh-reader FILE [SECONDS]: run by thenar for meshes of other programs\n", stderr);
    return 2;
  }
  // The output and the limits, before any parser runs.
  const int output = thenar::keep_output();
  // Processor time without SECONDS, above every limit [s]
  constexpr int kUnlimitedTime = 1000;
  thenar::set_limits(argc == 3 ? std::atoi(argv[2]) : kUnlimitedTime);
  // Without destructors: taking down foreign scenes is slow, or crashes.
  _exit(thenar::write_all(output, thenar::answer(argv[1])) ? 0 : 1);
}
