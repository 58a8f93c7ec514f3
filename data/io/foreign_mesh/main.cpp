// thenar-mesh-reader FILE [SECONDS]
//
// The triangles of a glTF, Collada, VRML or Inventor file on the standard output, as
// data/io/mesh/reader_answer.h has them. thenar runs it for each such file: parsers of others run
// here alone, under limits of memory and time, and can open nothing but what they are given.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/error.h"
#include "data/io/foreign_mesh/parsers.h"
#include "data/io/mesh/bounded_process.h"
#include "data/io/mesh/foreign_mesh.h"
#include "data/io/mesh/reader_answer.h"

// Under the address sanitizer, whose own memory has no use for a limit of address space.
extern "C" const char* __asan_default_options();   // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() {  // NOLINT(bugprone-reserved-identifier)
  return "detect_leaks=0:hard_rss_limit_mb=1200";
}

namespace thenar {
namespace {

void limit(decltype(RLIMIT_CPU) what, rlim_t most, rlim_t beyond = 0) {
  const rlimit both{most, most + beyond};
  (void)setrlimit(what, &both);
}

/// What this process has mapped already: its libraries [bytes].
rlim_t mapped() {
  std::ifstream pages("/proc/self/statm");
  rlim_t count = 0;
  pages >> count;
  return count * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// @param seconds  of the processor, if fewer than the limit are left
void set_limits(int seconds) {
  const MeshReaderLimits limits;
  // A second more before SIGKILL follows SIGXCPU, which tells what the trouble was.
  const int most = std::clamp(seconds, 1, limits.processor_seconds);
  limit(RLIMIT_CPU, static_cast<rlim_t>(most), 1);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);  // writes no file
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

/// Nothing that a parser prints may get among the answer.
int keep_output() {
  const int output = dup(1);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) (void)dup2(nowhere, 1);
  return output;
}

bool write_all(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written <= 0) return false;
    done += static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace
}  // namespace thenar

int main(int argc, char** argv) {
  thenar::end_with_parent();
  if (argc != 2 && argc != 3) {
    (void)std::fputs(
        "thenar-mesh-reader FILE [SECONDS]: run by thenar for meshes of other programs\n", stderr);
    return 2;
  }
  const int output = thenar::keep_output();
  constexpr int kAll = 1000;
  thenar::set_limits(argc == 3 ? std::atoi(argv[2]) : kAll);
  // No destructors: scenes of others take long, or crash, to take down.
  _exit(thenar::write_all(output, thenar::answer(argv[1])) ? 0 : 1);
}
