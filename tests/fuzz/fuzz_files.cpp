// libFuzzer's view of every reader: THENAR_FUZZ_KIND names the kind of file; the first byte of an
// input chooses among the endings that the kind has, the rest is the file.
//
// fuzz_files seeds FOLDER   writes the corpora that runs begin from, one folder for each kind, and
//                           prints the names of the kinds.

#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "base/file_io.h"
#include "tests/fuzz/fuzz_kinds.h"

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace thenar {
namespace {

/// Files in memory, where every system of ours has them.
std::string own_folder() {
  const std::string folder = "/dev/shm/thenar_fuzz_" + std::to_string(getpid());
  (void)mkdir(folder.c_str(), 0700);
  return folder;
}

const std::string& folder() {
  static const std::string one = own_folder();
  return one;
}

const FuzzKind& kind() {
  static const FuzzKind chosen = [] {
    const char* const name = std::getenv("THENAR_FUZZ_KIND");
    for (FuzzKind& each : fuzz_kinds(folder()))
      if (name != nullptr && each.name == name) return each;
    throw std::runtime_error("THENAR_FUZZ_KIND names no kind of file");
  }();
  return chosen;
}

/// Straight into the file: nothing is to outlive a crash.
void write_quickly(const std::string& path, const std::uint8_t* data, std::size_t size) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) throw std::runtime_error("cannot write " + path);
  (void)std::fwrite(data, 1, size, file);
  (void)std::fclose(file);
}

void write_seeds(const std::string& where) {
  for (const FuzzKind& each : fuzz_kinds(folder())) {
    (void)std::puts(each.name.c_str());
    for (std::size_t i = 0; i < each.seeds.size(); ++i)
      write_file(where + "/" + each.name + "/" + std::to_string(i),
                 std::string(1, static_cast<char>(i)) + each.seeds[i].text);
  }
}

}  // namespace
}  // namespace thenar

int LLVMFuzzerInitialize(int* argc, char*** argv) {
  // A library that crashes in a copy of this process, which readers make for that (trial_run.h), is
  // not to be told of as a crash of the reader.
  (void)pthread_atfork(nullptr, nullptr, [] { __sanitizer_set_death_callback(nullptr); });
  if (*argc == 3 && std::strcmp((*argv)[1], "seeds") == 0) {
    thenar::write_seeds((*argv)[2]);
    std::exit(0);
  }
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const thenar::FuzzKind& kind = thenar::kind();
  const std::string path =
      thenar::folder() + "/input_" + kind.seeds[data[0] % kind.seeds.size()].name;
  thenar::write_quickly(path, data + 1, size - 1);
  thenar::read_harmlessly(kind, path);
  return 0;
}
