#include "server/session.h"

#include <utility>

#include "live/live_abilities.h"

namespace thenar {

std::string Session::model_noun(LiveMode mode) {
  constexpr std::array kThings{
      EnumName{LiveMode::kWorld, "world"}, EnumName{LiveMode::kMotion, "scene that moves"},
      EnumName{LiveMode::kTendons, "digit"}, EnumName{LiveMode::kFit, "fit"}};
  return name_in(kThings, mode);
}

std::string Session::opening_methods(LiveMode mode) {
  constexpr std::array kOpeners{EnumName{LiveMode::kWorld, "world.new or world.load"},
                                EnumName{LiveMode::kMotion, "motion.open or motion.record"},
                                EnumName{LiveMode::kTendons, "tendons.open"},
                                EnumName{LiveMode::kFit, "fit.open"}};
  return name_in(kOpeners, mode);
}

unsigned long Session::revision() const {
  const LiveModel* model = shown_model();
  return switches_ + (model != nullptr ? model->shape_changes() : 0);
}

void Session::open(LiveMode mode, std::shared_ptr<LiveModel> model) {
  const unsigned long seen = revision();
  auto* clock = dynamic_cast<LiveClock*>(models_[index_of(mode_)].get());
  if (mode != mode_ && clock != nullptr) clock->pause();
  models_[index_of(mode)] = std::move(model);
  mode_ = mode;
  switches_ = 0;
  switches_ = seen + 1 - revision();  // revision() is seen + 1 now; unsigned numbers wrap
}

void Session::show(LiveMode mode) {
  require(has_model(mode), "no {} is open: call {}", model_noun(mode), opening_methods(mode));
  if (mode == mode_) return;
  open(mode, models_[index_of(mode)]);
}

}  // namespace thenar
