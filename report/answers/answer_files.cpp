#include "report/answers/answer_files.h"

#include <utility>
#include <variant>

#include "base/file_io.h"

namespace thenar {
namespace {

FileDigests joined(FileDigests files, FileDigests more) {
  files.merge(more);
  return files;
}

/// The file at a path, if it is one; names of what is built in are none.
FileDigests file_at(const std::string& path) {
  return is_file(path) ? digests_of({path}) : FileDigests();
}

/// Trait of things that list the files they were read from besides their own: meshes, materials,
/// bodies, laws.
template <typename Whole, typename = void>
struct HasFiles : std::false_type {};
template <typename Whole>
struct HasFiles<Whole, std::void_t<decltype(std::declval<Whole>().files)>> : std::true_type {};
template <typename Whole>
FileDigests parts_of(const Whole& whole) {
  if constexpr (HasFiles<Whole>::value)
    return whole.files;
  else
    return {};
}

FileDigests files_of_thing(const std::string& path, const Thing& thing) {
  return joined(std::visit([](const auto& each) { return parts_of(each); }, thing), file_at(path));
}

}  // namespace

FileDigests files_of(const GraspResult& result) { return result.setting.files; }
FileDigests files_of(const CloseResult& result) { return files_of(result.grasp); }

FileDigests files_of(const ThingExplained& explained) {
  FileDigests files = files_of_thing(explained.path, explained.thing);
  return explained.digit ? joined(files, file_at(explained.digit->settings)) : files;
}

FileDigests files_of(const Validation& validation) {
  FileDigests files = file_at(validation.subject);
  for (const FileVerdict& file : validation.files)
    files.merge(file.thing ? files_of_thing(file.path, *file.thing) : file_at(file.path));
  return files;
}

FileDigests files_of(const Imported& imported) {
  return joined(std::visit([](const auto& each) { return parts_of(each); }, imported.thing),
                file_at(imported.request.file));
}

FileDigests files_of(const ContactQualityResult& result) { return file_at(result.contacts); }
FileDigests files_of(const std::vector<ContactQualityResult>& results) {
  FileDigests files;
  for (const ContactQualityResult& result : results) files.merge(files_of(result));
  return files;
}

FileDigests files_of(const SceneResult& scene) { return scene.files; }
FileDigests files_of(const TendonSolveResult& solution) {
  return source_digests(solution.loaded.sources);
}
FileDigests files_of(const TendonSweepResult& sweep) {
  return source_digests(sweep.loaded.sources);
}

FileDigests files_of(const FitResult& result) {
  return source_digests(sources_of(result.fit.inputs));
}

FileDigests files_of(const PredictResult& result) {
  return joined(source_digests(result.sources), file_at(result.request.fit));
}

FileDigests files_of(const PosteriorPrediction& result) { return files_of(result.predicted); }

}  // namespace thenar
