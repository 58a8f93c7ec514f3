#pragma once

/// State that all clients of a server share: the models that they move and look at, and the model
/// that is shown.

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
struct SessionPlaces {
  std::string data;          // folder with worlds/, robots/ ..; empty: the usual ones
  std::string folder = ".";  // files that clients save stand in it, or below
};

/// Models by mode, one of which is shown. Not for use by several threads at once.
class Session {
 public:
  explicit Session(SessionPlaces places) : places_(std::move(places)) {}

  [[nodiscard]] const SessionPlaces& places() const { return places_; }
  [[nodiscard]] LiveMode mode() const { return mode_; }
  /// "world"
  [[nodiscard]] std::string mode_name() const { return name_in(kLiveModeNames, mode_); }
  /// Replaces the model of a mode, and shows it. A motion that is shown no longer pauses.
  void open(LiveMode mode, std::shared_ptr<LiveModel> model);
  /// Shows a model that is open. @throws InputError if there is none in that mode.
  void show(LiveMode mode);
  /// The model that is shown; null at the very start.
  [[nodiscard]] const LiveModel* shown() const { return models_[place_of(mode_)].get(); }
  [[nodiscard]] bool has(LiveMode mode) const { return models_[place_of(mode)] != nullptr; }
  /// The model of a mode as what it is: `session.model<LiveWorld>(LiveMode::kWorld)`.
  /// @throws InputError if none is open, saying which method opens one.
  template <typename Model>
  [[nodiscard]] Model& model(LiveMode mode) const {
    auto* found = dynamic_cast<Model*>(models_[place_of(mode)].get());
    require(found != nullptr, "no {} is open: call {}", what_is(mode), opener_of(mode));
    return *found;
  }
  /// Returns the model of a mode; null if none of this type is open.
  template <typename Model>
  [[nodiscard]] const Model* find(LiveMode mode) const {
    return dynamic_cast<const Model*>(models_[place_of(mode)].get());
  }
  /// Goes up whenever shape() of what is shown is another one.
  [[nodiscard]] unsigned long revision() const;
  /// Meshes that clients may fetch; other threads may read them at any time.
  [[nodiscard]] MeshStore& meshes() { return meshes_; }
  /// Questions that are answered beside it.
  [[nodiscard]] Jobs& jobs() { return jobs_; }
  /// Returns the log of all requests so far.
  [[nodiscard]] SessionLog& log() { return log_; }

 private:
  [[nodiscard]] static std::size_t place_of(LiveMode mode) {
    return static_cast<std::size_t>(mode);
  }
  [[nodiscard]] static std::string what_is(LiveMode mode);
  [[nodiscard]] static std::string opener_of(LiveMode mode);

  SessionPlaces places_;
  MeshStore meshes_;
  SessionLog log_;
  Jobs jobs_;
  std::array<std::shared_ptr<LiveModel>, kLiveModeNames.size()> models_{};
  LiveMode mode_ = LiveMode::kWorld;
  unsigned long switches_ = 0;  // of what is shown; with the model's own changes the revision
};

}  // namespace thenar
