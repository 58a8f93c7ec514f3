#pragma once

/// State that all clients of a server share: the open models, and the model that is shown.

#include <array>
#include <memory>
#include <string>

#include "base/enum_names.h"
#include "base/error.h"
#include "live/live_picture.h"
#include "server/jobs.h"
#include "server/mesh_store.h"
#include "server/session_log.h"

namespace thenar {

/// Kinds of models that a session may show.
enum class LiveMode { kWorld, kMotion, kTendons, kFit };
inline constexpr std::array kLiveModeNames{
    EnumName{LiveMode::kWorld, "world"}, EnumName{LiveMode::kMotion, "motion"},
    EnumName{LiveMode::kTendons, "tendons"}, EnumName{LiveMode::kFit, "fit"}};

/// Folders from which a session reads files, and to which it writes them.
struct SessionFolders {
  std::string data;          // folder with worlds/, robots/ ..; empty: the default ones
  std::string folder = ".";  // working folder: files that clients save are in it or below
};

/// Models by mode, one of which is shown. Not thread-safe.
class Session {
 public:
  explicit Session(SessionFolders folders) : folders_(std::move(folders)) {}

  [[nodiscard]] const SessionFolders& folders() const { return folders_; }
  [[nodiscard]] LiveMode mode() const { return mode_; }
  /// Returns the name of the mode: "world".
  [[nodiscard]] std::string mode_name() const { return name_in(kLiveModeNames, mode_); }
  /// Replaces the model of a mode, and shows it. Pauses a motion that is then no longer shown.
  void open(LiveMode mode, std::shared_ptr<LiveModel> model);
  /// Shows the open model of a mode. @throws InputError if there is none
  void show(LiveMode mode);
  /// Returns the model that is shown; null if none has been opened.
  [[nodiscard]] const LiveModel* shown_model() const { return models_[index_of(mode_)].get(); }
  [[nodiscard]] bool has_model(LiveMode mode) const { return models_[index_of(mode)] != nullptr; }
  /// Returns the model of a mode as its own type: `session.model<LiveWorld>(LiveMode::kWorld)`.
  /// @throws InputError naming the methods that open one, if none of this type is open
  template <typename Model>
  [[nodiscard]] Model& model(LiveMode mode) const {
    auto* found = dynamic_cast<Model*>(models_[index_of(mode)].get());
    require(found != nullptr, "no {} is open: call {}", model_noun(mode), opening_methods(mode));
    return *found;
  }
  /// Returns the model of a mode; null if none of this type is open.
  template <typename Model>
  [[nodiscard]] const Model* find_model(LiveMode mode) const {
    return dynamic_cast<const Model*>(models_[index_of(mode)].get());
  }
  /// Returns a number that increases whenever the shape that is shown changes.
  [[nodiscard]] unsigned long revision() const;
  /// Returns the meshes that clients can fetch.
  [[nodiscard]] MeshStore& meshes() { return meshes_; }
  /// Returns the background jobs.
  [[nodiscard]] Jobs& jobs() { return jobs_; }
  /// Returns the log of all requests so far.
  [[nodiscard]] SessionLog& log() { return log_; }

 private:
  [[nodiscard]] static std::size_t index_of(LiveMode mode) {
    return static_cast<std::size_t>(mode);
  }
  [[nodiscard]] static std::string model_noun(LiveMode mode);
  [[nodiscard]] static std::string opening_methods(LiveMode mode);

  SessionFolders folders_;
  MeshStore meshes_;
  SessionLog log_;
  Jobs jobs_;
  std::array<std::shared_ptr<LiveModel>, kLiveModeNames.size()> models_{};
  LiveMode mode_ = LiveMode::kWorld;
  unsigned long switches_ = 0;  // revision() minus the shape changes of the model that is shown
};

}  // namespace thenar
