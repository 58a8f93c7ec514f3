#include "server/session.h"

#include <utility>

#include "live/live_abilities.h"

namespace thenar {

std::string Session::what_is(LiveMode mode) {
  switch (mode) {
    case LiveMode::kWorld:
      return "world";
    case LiveMode::kMotion:
      return "scene that moves";
    case LiveMode::kTendons:
      return "digit";
    case LiveMode::kFit:
      break;
  }
  return "fit";
}

std::string Session::opener_of(LiveMode mode) {
  switch (mode) {
    case LiveMode::kWorld:
      return "world.new or world.load";
    case LiveMode::kMotion:
      return "motion.open or motion.record";
    case LiveMode::kTendons:
      return "tendons.open";
    case LiveMode::kFit:
      break;
  }
  return "fit.open";
}

unsigned long Session::revision() const {
  const LiveModel* model = shown();
  return switches_ + (model != nullptr ? model->shape_changes() : 0);
}

void Session::open(LiveMode mode, std::shared_ptr<LiveModel> model) {
  const unsigned long seen = revision();
  auto* clock = dynamic_cast<LiveClock*>(models_[place_of(mode_)].get());
  if (mode != mode_ && clock != nullptr) clock->pause();
  models_[place_of(mode)] = std::move(model);
  mode_ = mode;
  switches_ = 0;
  switches_ = seen + 1 - revision();  // revision() is seen + 1 now; unsigned numbers wrap
}

void Session::show(LiveMode mode) {
  require(has(mode), "no {} is open: call {}", what_is(mode), opener_of(mode));
  if (mode == mode_) return;
  open(mode, models_[place_of(mode)]);
}

}  // namespace thenar
