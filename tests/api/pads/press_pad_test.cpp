// Tests for api/pads/press_pad.cpp and press_rungs.cpp.

#include "api/pads/press_pad.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/pad/law_file.h"
#include "tests/api/pads/small_presses.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

/// Rough and quick: errors of 20 %, three points.
PressRequest quick() {
  PressRequest request;
  request.pad.pad = kData + "/pads/index_pad.toml";
  request.force_error = 0.2;
  request.points = 3;
  request.friction = 0;
  return request;
}

/// A nearly incompressible pad that relaxes to half, so that all forces scale with the modulus.
class RelaxingPad : public TemporaryFolder {
 protected:
  [[nodiscard]] PressRequest request() const {
    std::ofstream(path("pad.toml")) << sample::kPadHead + R"([pulp]
law = "neo-hookean"
shear_modulus_kPa = 12
poisson_ratio = 0.49999
relaxation_share = [0.5]
relaxation_time_s = [0.1]
)";
    PressRequest request = quick();
    request.pad.pad = path("pad.toml");
    request.depth = 1e-3;
    return request;
  }
};

TEST(PressPad, ToADepthAndToItsForceAreTheSame) {
  PressRequest request = quick();
  request.depth = 1.2e-3;
  const PressResult deep = press_pad(request);
  ASSERT_EQ(deep.outcome.status, Status::kSolved) << deep.message;
  ASSERT_EQ(deep.instants.size(), 3U);
  for (int k = 1; k <= 3; ++k)
    EXPECT_NEAR(deep.instants[static_cast<std::size_t>(k - 1)].depth, 0.4e-3 * k, 1e-12);
  // On a mesh that does not refine, as its last one is another by another way. It feels the object
  // before it touches.
  request.force_error = 1e3;
  const PressResult coarse = press_pad(request);
  request.depth.reset();
  request.force = coarse.instants.back().force;
  const PressResult forced = press_pad(request);
  ASSERT_EQ(forced.outcome.status, Status::kSolved) << forced.message;
  EXPECT_NEAR(forced.instants.back().force, *request.force, 1e-8);
  EXPECT_EQ(forced.instants.back().elements, coarse.instants.back().elements);
  EXPECT_NEAR(forced.instants.back().depth, 1.2e-3, 1e-8);
}

TEST(PressPad, ForcesOfAnySizeAreReached) {
  PressRequest request = quick();
  request.force_error = 1e3;
  request.angle = radians(20);
  double deep = -HUGE_VAL;
  for (const double force : {1e-4, 1e-2, 1.0}) {
    request.force = force;
    const PressResult pressed = press_pad(request);
    ASSERT_EQ(pressed.outcome.status, Status::kSolved) << force << ' ' << pressed.message;
    ASSERT_EQ(pressed.instants.size(), 3U);
    for (int k = 1; k <= 3; ++k)
      EXPECT_NEAR(pressed.instants[static_cast<std::size_t>(k - 1)].force,
                  force * std::pow(k / 3.0, 1.5), 2e-9);
    EXPECT_GT(pressed.instants.back().depth, deep);
    deep = pressed.instants.back().depth;
  }
}

TEST(PressPad, ForcesRiseFasterThanHertzAsTheBoneComesNear) {
  PressRequest request = quick();
  request.depth = 1.5e-3;
  const PressResult pressed = press_pad(request);
  ASSERT_EQ(pressed.instants.size(), 3U);
  const std::vector<PressInstant>& at = pressed.instants;
  EXPECT_GT(at[2].force, std::pow(3, 1.5) * at[0].force);
  EXPECT_GT(at[2].area, at[1].area);
  for (const PressInstant& now : at) {
    EXPECT_LE(now.force_error, &now == &at[2] ? 0.2 : 0.6);
    EXPECT_GE(now.pressure, now.force / now.area);                // the largest, above the mean
    EXPECT_EQ(now.stick, 0);                                      // no friction
    EXPECT_EQ(now.time, 0);                                       // at once
    EXPECT_NEAR(-now.push[2], now.force, 1e-9);                   // straight on
    EXPECT_NEAR(now.push.head<2>().norm(), 0, 1e-6 * now.force);  // the pad is symmetric
  }
}

TEST(PressPad, WithFrictionSticksSomewhere) {
  PressRequest request = quick();
  request.depth = 1e-3;
  request.friction = 0.6;
  const PressResult pressed = press_pad(request);
  ASSERT_EQ(pressed.outcome.status, Status::kSolved) << pressed.message;
  EXPECT_GT(pressed.instants.back().stick, 0.1);
  EXPECT_LE(pressed.instants.back().stick, 1);
}

TEST(PressPad, AtAnAngleTouchesTheTip) {
  PressRequest request = quick();
  request.depth = 0.8e-3;
  request.angle = radians(30);
  const PressResult pressed = press_pad(request);
  ASSERT_EQ(pressed.outcome.status, Status::kSolved) << pressed.message;
  // Without friction a plane pushes along its normal, and at its patch, which is distal.
  EXPECT_NEAR(pressed.instants.back().push.norm(), pressed.instants.back().force, 1e-9);
  double x = 0;
  for (Eigen::Index k = 0; k < pressed.skin.places.cols(); ++k)
    x += pressed.skin.normal[k] * pressed.skin.places(0, k) / pressed.skin.normal.sum();
  // Where the ellipsoid's normal has this angle: x = e_x^2 n_x / sqrt(sum (e_i n_i)^2).
  const double nx = 0.5, nz = std::sqrt(0.75);
  EXPECT_NEAR(x, 144e-6 * nx / std::hypot(12e-3 * nx, 10e-3 * nz), 1e-3);
}

TEST_F(RelaxingPad, RelaxesToItsShareAfterAFastPress) {
  PressRequest fast = request();
  fast.rate = 10;  // 1 mm in 0.1 ms
  fast.hold = 0.2;
  fast.hold_points = 5;
  const PressResult pressed = press_pad(fast);
  ASSERT_EQ(pressed.outcome.status, Status::kSolved) << pressed.message;
  ASSERT_EQ(pressed.instants.size(), 8U);
  EXPECT_TRUE(pressed.relaxes());
  const PressInstant &peak = pressed.instants[2], &end = pressed.instants.back();
  EXPECT_EQ(peak.phase, PressPhase::kWay);
  EXPECT_EQ(end.phase, PressPhase::kHold);
  EXPECT_NEAR(peak.time, 1e-4, 1e-12);
  EXPECT_NEAR(end.time, 0.2001, 1e-12);
  EXPECT_NEAR(end.depth, 1e-3, 1e-12);
  // g(t) = 0.5 + 0.5 exp(-t / 0.1); the pulp's volume hardly yields. The way took 0.1 ms.
  EXPECT_NEAR(end.force / peak.force, 0.5 + 0.5 * std::exp(-2.0), 0.01);
}

TEST_F(RelaxingPad, SlowlyIsHalfOfAtOnce) {
  PressRequest slow = request();
  const PressResult at_once = press_pad(slow);
  slow.rate = 0;
  const PressResult slowly = press_pad(slow);
  ASSERT_EQ(slowly.outcome.status, Status::kSolved) << slowly.message;
  EXPECT_NEAR(slowly.instants.back().force / at_once.instants.back().force, 0.5, 0.005);
  EXPECT_FALSE(slowly.relaxes());
}

TEST_F(RelaxingPad, AForceIsReachedAtTheRate) {
  PressRequest timed = request();
  timed.depth.reset();
  timed.force = 0.3;
  timed.rate = 10e-3;
  timed.points = 6;
  const PressResult pressed = press_pad(timed);
  ASSERT_EQ(pressed.outcome.status, Status::kSolved) << pressed.message;
  for (const PressInstant& now : pressed.instants)
    EXPECT_NEAR(now.time * 10e-3 / now.depth, 1, 0.1) << now.depth;
  EXPECT_NEAR(pressed.instants.back().force, 0.3, 1e-8);
}

TEST(PressPad, SaysWhatIsAssumed) {
  PressRequest request = quick();
  request.depth = 0.5e-3;
  EXPECT_THAT(press_pad(request).outcome.warnings,
              testing::Contains(HasSubstr("shear_modulus_kPa")));
}

TEST(PressPad, KeepsWhatItHadWhereAStepFails) {
  PressRequest request = quick();
  request.depth = 9e-3;  // through the bone
  request.points = 6;
  request.force_error = 0.6;
  const PressResult pressed = press_pad(request);
  EXPECT_NE(pressed.outcome.status, Status::kSolved);
  EXPECT_FALSE(pressed.message.empty());
  EXPECT_GE(pressed.instants.size(), 1U);
  EXPECT_LT(pressed.instants.size(), 6U);
  EXPECT_NEAR(pressed.touch.along.dot(pressed.X_PO.p - pressed.touch.X_PO.p),
              pressed.instants.back().depth, 1e-12);
}

TEST(PressPad, StopsWithinAStep) {
  PressRequest request = quick();
  request.depth = 1e-3;
  Progress progress;
  int steps = 0, asked = 0, refused = 0;
  progress.report = [&](double, const std::string&) {
    ++steps;
    asked = 0;
  };
  // At the third iteration of the third step, and never asked again.
  progress.stop_requested = [&] {
    const bool stop = ++asked > 2 && steps == 3;
    refused += stop ? 1 : 0;
    return stop;
  };
  const PressResult pressed = press_pad(request, progress);
  EXPECT_EQ(pressed.outcome.status, Status::kStopped);
  EXPECT_TRUE(pressed.message.empty());
  EXPECT_EQ(refused, 1);
  ASSERT_EQ(pressed.instants.size(), 2U);
  EXPECT_NEAR(pressed.touch.along.dot(pressed.X_PO.p - pressed.touch.X_PO.p),
              pressed.instants.back().depth, 1e-12);
}

TEST_F(RelaxingPad, ComparesRungsAgainstTheFinest) {
  PressRequest compared = request();
  std::ofstream(path("pad.toml"), std::ios::app)
      << "[cells]\nacross = 2\naround = 1\nthrough = 1\n";
  compared.depth = 0.5e-3;
  compared.points = 1;
  compared.rungs = true;
  const PressResult pressed = press_pad(compared);
  ASSERT_FALSE(pressed.rungs.empty());
  EXPECT_TRUE(pressed.rungs.back().finest);
  EXPECT_EQ(pressed.rungs.back().error, 0);
  // No laws were calibrated for this pad, and a hard point has no depth.
  ASSERT_GT(pressed.rungs.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(pressed.rungs[i].reduced);
    EXPECT_THAT(pressed.rungs[i].message, HasSubstr(i == 0 ? "no depth" : "laws/pad.toml"));
  }
  // Plain elements lock at this Poisson's ratio: they fail, or are far too stiff.
  for (const PressRung& rung : pressed.rungs) {
    if (rung.reduced) continue;
    if (!rung.message.empty()) {
      EXPECT_EQ(rung.element, "Q1") << rung.message;
      EXPECT_EQ(rung.error, 0);
      continue;
    }
    EXPECT_NEAR(rung.error, std::abs(rung.force / pressed.rungs.back().force - 1), 1e-15);
    if (rung.element == "Q1") {
      EXPECT_GT(rung.force, 2 * pressed.rungs.back().force);
    }
    EXPECT_GT(rung.cpu, 0);
  }
}

/// Rungs up to the first elements.
std::vector<PressRung> laws_of(const PressResult& pressed) {
  Progress progress;
  progress.stop_requested = [] { return true; };
  return compare_rungs(pressed, progress);
}

// Each law is asked by hand for the depth that was pressed; the bed's force is what it pushes with.
TEST(PressPad, ComparesTheLawsOfItsPad) {
  PressRequest request = quick();
  request.depth = 1e-3;
  request.points = 1;
  request.object.name = "sphere";
  request.friction = 0.5;
  PressResult pressed = press_pad(request);
  ASSERT_EQ(pressed.outcome.status, Status::kSolved) << pressed.message;
  const std::vector<PressRung> rungs = laws_of(pressed);
  ASSERT_EQ(rungs.size(), 5U);
  const CalibratedLaws laws = read_laws(kData + "/pads/laws/index_pad.toml");
  // k (1 mm / 1 mm)^n = k; torsion = share mu a, area = pi a^2.
  EXPECT_NEAR(rungs[1].force, laws.power.force, 1e-12);
  EXPECT_NEAR(*rungs[1].torsion, laws.power.torsion * 0.5 * std::sqrt(*rungs[1].area / kPi), 1e-9);
  // Laws are good to their own worst errors, and elements to what was asked of them.
  const double force = pressed.instants.back().force;
  EXPECT_NEAR(rungs[2].force, force, (laws.soft_finger_error.force.worst + 0.2) * force);
  EXPECT_NEAR(rungs[4].force, force, (laws.bed_error.force.worst + 0.2) * force);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_TRUE(rungs[i].message.empty()) << rungs[i].message;
    EXPECT_THAT(rungs[i].note, HasSubstr("index_pad"));
    EXPECT_GT(rungs[i].cpu, 0);
  }
  // A force that was asked for is one that a hard point bears, without a patch.
  pressed.request.force = force;
  EXPECT_EQ(laws_of(pressed)[0].area, 0);
  // They were fitted to this version of the pad, and no other.
  EXPECT_EQ(laws_warning(pressed), "");
  const PadSpec spec = pressed.pad.spec;
  pressed.pad.spec.pulp.poisson_ratio = 0.48;
  EXPECT_THAT(laws_warning(pressed), HasSubstr("another version of pad 'index_pad'"));
  pressed.pad.spec = spec;
  // Tissue of another law is not what they were calibrated for.
  pressed.request.pad.law = "ogden";
  EXPECT_THAT(laws_of(pressed)[2].message, HasSubstr("another was asked for"));
  // Nor is a pad that relaxes otherwise.
  pressed.request.pad.law.clear();
  pressed.pad.model.tissues.front().relaxation.pop_back();
  EXPECT_THAT(laws_of(pressed)[2].message, HasSubstr("relax otherwise"));
}

TEST(PressPad, RefusesNonsense) {
  const auto refusal = [](const auto& change) {
    PressRequest request = quick();
    request.depth = 1e-3;
    change(request);
    return message_of([&] { (void)press_pad(request); });
  };
  using R = PressRequest;
  EXPECT_EQ(refusal([](R& r) { r.force = 1; }), "wanted a force or a depth, got both");
  EXPECT_EQ(refusal([](R& r) { r.depth.reset(); }), "wanted a force or a depth, got none");
  EXPECT_THAT(refusal([](R& r) { r.depth = NAN; }), HasSubstr("wanted a depth above 0 mm"));
  EXPECT_THAT(refusal([](R& r) { r.depth = -1e-3; }), HasSubstr("wanted a depth above 0 mm"));
  EXPECT_THAT(refusal([](R& r) {
                r.depth.reset();
                r.force = 0;
              }),
              HasSubstr("a force above 0 N"));
  EXPECT_THAT(refusal([](R& r) { r.rate = -1; }), HasSubstr("wanted a rate of 0"));
  EXPECT_THAT(refusal([](R& r) { r.hold = 1; }), HasSubstr("after a rate above 0 only"));
  EXPECT_THAT(refusal([](R& r) { r.friction = NAN; }), HasSubstr("friction of at least 0"));
  EXPECT_THAT(refusal([](R& r) { r.points = 0; }), HasSubstr("wanted 1 to 1000 points"));
  EXPECT_THAT(refusal([](R& r) { r.force_error = 0; }), HasSubstr("error of the force above 0"));
  EXPECT_THAT(refusal([](R& r) { r.angle = 2; }), HasSubstr("within 60 deg"));
  EXPECT_THAT(refusal([](R& r) { r.pad.pad = "thumb_bad"; }), HasSubstr("there is no pad"));
  EXPECT_THAT(refusal([](R& r) { r.pad.law = "ogden"; }), HasSubstr("needs an exponent"));
  EXPECT_THAT(refusal([](R& r) { r.pad.exponent = 2; }), HasSubstr("has no exponent"));
  EXPECT_THAT(refusal([](R& r) { r.pad.element = "Q9"; }), HasSubstr("no element 'Q9'"));
}

TEST(PressPad, RefusesPinsBeforeItPresses) {
  PressRequest request = quick();
  request.depth = 1e-3;
  request.object.name = "cylinder";
  request.object.radius = 0.1e-3;
  EXPECT_THAT(message_of([&] { (void)press_pad(request); }),
              HasSubstr("wanted an object of at least 0.4 mm across its way into a pad of 24 mm"));
}

TEST(PressPad, TakesAnotherLaw) {
  PressRequest request = quick();
  request.depth = 0.5e-3;
  const double neo = press_pad(request).instants.back().force;
  // Ogden's law of exponent 2 is the neo-Hookean one.
  request.pad.law = "ogden";
  request.pad.exponent = 2;
  EXPECT_NEAR(press_pad(request).instants.back().force / neo, 1, 1e-6);
}

}  // namespace
}  // namespace thenar
