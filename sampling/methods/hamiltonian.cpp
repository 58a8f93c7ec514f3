#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/random_stream.h"
#include "sampling/methods/hamiltonian_trajectory.h"
#include "sampling/methods/hamiltonian_warm_up.h"
#include "sampling/methods/sampler.h"
#include "sampling/methods/saved_shape.h"
#include "sampling/methods/target.h"

namespace thenar::internal {
namespace {

// Purposes of random streams.
constexpr std::uint32_t kStepStream = 0x68616d00, kTrialStream = 0x68616d01;

/// Position of the chain, with the densities there.
struct LanePlace {
  Eigen::VectorXd x, y;   // position, and whitened position (n)
  Eigen::VectorXd slope;  // PhasePoint::slope at y (n)
  Densities at;           // densities at x
  double energy = 0;      // energy with the momentum that led here [1]
};

/// Hamiltonian sampler of one chain, with or without fixed trajectory length.
class Hamiltonian : public Sampler {
 public:
  Hamiltonian(SamplingMethod method, const Eigen::VectorXd& start, const SamplerOptions& options);

  [[nodiscard]] int chains() const override { return 1; }
  [[nodiscard]] WithGradient wants() const override { return WithGradient::kYes; }
  [[nodiscard]] const Eigen::MatrixXd& asks() const override { return asks_; }
  void tell(const Densities& at) override;

  [[nodiscard]] long steps() const override { return steps_; }
  [[nodiscard]] const Eigen::MatrixXd& positions() const override { return positions_; }
  [[nodiscard]] const std::vector<StepStats>& stats() const override { return stats_; }

  void move(int chain, const Eigen::VectorXd& x, const Densities& at) override;
  [[nodiscard]] Densities density(int /*chain*/) const override { return current_.at; }

  void set_beta(double beta) override;

  void save(StateWriter& to) const override;
  void restore(StateReader& from) override;

 private:
  /// Point whose density the sampler waits for.
  enum class Waits { kForStart, kForTrial, kForPoint };

  void begin();
  void begin_trial();
  void begin_trajectory();
  void draw_momentum(RandomStream& random);
  void start_leapfrog(PhasePoint& point, double step);

  void learn_start(const Densities& at);
  double land(const Densities& at, const TemperedDensity& density);
  void follow(const Densities& at, double energy_error);
  void complete(double acceptance, int depth, bool divergent);
  void weigh(const Densities& at);
  bool usable(const Densities& at);
  void whiten();

  SamplerOptions options_;
  bool static_length_;
  std::unique_ptr<HamiltonianTrajectory> doubling_, jittered_;
  WarmUp warm_up_;
  RandomStream random_;

  // State of the chain; `current_` is the selected point of the present trajectory.
  LanePlace current_, candidate_;
  bool known_ = false;   // the density at current_ is known
  bool usable_ = false;  // the density and its gradient are finite
  long steps_ = 0;
  Eigen::MatrixXd positions_;
  std::vector<StepStats> stats_;

  /// Computation in progress: a trial of a step size, or the trajectory of a step.
  struct UnderWay {
    Waits waits = Waits::kForStart;
    HamiltonianTrajectory* trajectory = nullptr;
    PhasePoint from, trial;
    PhasePoint* moving_point = nullptr;  // point whose leapfrog step waits for a gradient
    double leapfrog_length = 0;  // length of that leapfrog step; negative: backward in time [1]
    double start_energy = 0, energy = 0;  // energies at the start, and at the moving point
    int evaluations = 0,
        broken = 0;  // number of requested densities, and of those that are not finite
  };
  UnderWay now_;
  Eigen::VectorXd gradient_;   // gradient of the tempered density (n)
  Eigen::VectorXd requested_;  // requested point (n)
  Eigen::MatrixXd asks_;       // requested point (n, 1)
};

Hamiltonian::Hamiltonian(SamplingMethod method, const Eigen::VectorXd& start,
                         const SamplerOptions& options)
    : options_(options),
      static_length_(method == SamplingMethod::kHmc),
      doubling_(no_u_turn_trajectory(static_cast<int>(start.size()), options.max_depth)),
      jittered_(jittered_trajectory()),
      warm_up_(start, target_acceptance_of(options), options),
      random_(options.seed, static_cast<std::uint32_t>(options.first_chain), 0, kStepStream),
      positions_(start),
      stats_(1) {
  current_.x = start;
  current_.y = warm_up_.whitening().to_whitened(start);
  now_.from.r.resize(start.size());
  begin();
}

// Requests the next density: of the start, a trial of a step size, or a point of a trajectory.
void Hamiltonian::begin() {
  if (!usable_) {
    now_.waits = Waits::kForStart;
    asks_ = current_.x;
  } else if (warm_up_.searching()) {
    begin_trial();
  } else {
    begin_trajectory();
  }
}

void Hamiltonian::begin_trial() {
  now_.waits = Waits::kForTrial;
  // Take one leapfrog step with a new momentum.
  RandomStream random(options_.seed, static_cast<std::uint32_t>(options_.first_chain),
                      stream_step(steps_),
                      kTrialStream + static_cast<std::uint32_t>(warm_up_.trial_count()));
  draw_momentum(random);
  now_.trial = now_.from;
  start_leapfrog(now_.trial, warm_up_.step());
}

void Hamiltonian::begin_trajectory() {
  now_.waits = Waits::kForPoint;
  random_ = RandomStream(options_.seed, static_cast<std::uint32_t>(options_.first_chain),
                         stream_step(steps_), kStepStream);
  draw_momentum(random_);
  current_.energy = now_.start_energy;
  // Trajectories of fixed length are useless until the metric is known; use doubling before.
  now_.trajectory =
      static_length_ && warm_up_.metric_settled(steps_) ? jittered_.get() : doubling_.get();
  now_.trajectory->start(now_.from, warm_up_.step(), random_);
  start_leapfrog(now_.trajectory->moving_point(), now_.trajectory->leapfrog_length());
}

void Hamiltonian::draw_momentum(RandomStream& random) {
  // Draw the momentum, and compute the energy at the chain's position.
  now_.from.y = current_.y;
  now_.from.slope = current_.slope;
  for (Eigen::Index i = 0; i < now_.from.r.size(); ++i) now_.from.r[i] = random.normal();
  now_.start_energy =
      0.5 * now_.from.r.squaredNorm() - tempered_density(current_.at, 0, options_.beta).value;
}

void Hamiltonian::start_leapfrog(PhasePoint& point, double step) {
  now_.moving_point = &point;
  now_.leapfrog_length = step;
  begin_leapfrog(point, warm_up_.whitening(), step);
  warm_up_.whitening().to_position(point.y, requested_);
  asks_ = requested_;
}

void Hamiltonian::tell(const Densities& at) {
  ++now_.evaluations;
  const TemperedDensity density = tempered_density(at, 0, options_.beta);
  if (density.non_finite) ++now_.broken;
  if (now_.waits == Waits::kForStart) return learn_start(at);
  const double energy_error = land(at, density);
  if (now_.waits == Waits::kForPoint) return follow(at, energy_error);
  warm_up_.learn_trial(energy_error);
  begin();
}

// Handles the density at the start. A chain at zero density stays, and reports it at every step.
void Hamiltonian::learn_start(const Densities& at) {
  const bool stays = known_;
  known_ = true;
  current_.at = at;
  usable_ = usable(at);
  whiten();
  if (stays && !usable_) return complete(0, 0, true);
  begin();
}

// Returns the energy error at the end of a leapfrog step; +inf if the density is zero or not
// finite.
double Hamiltonian::land(const Densities& at, const TemperedDensity& density) {
  if (density.value == -kInfinity) return kInfinity;
  weigh(at);
  end_leapfrog(*now_.moving_point, warm_up_.whitening(), gradient_, now_.leapfrog_length);
  now_.energy = 0.5 * now_.moving_point->r.squaredNorm() - density.value;
  if (std::isfinite(now_.energy)) return now_.energy - now_.start_energy;
  if (!gradient_.allFinite()) ++now_.broken;
  return kInfinity;
}

void Hamiltonian::follow(const Densities& at, double energy_error) {
  // Update the candidate and the selected point.
  const PointVerdict verdict = now_.trajectory->assess_point(energy_error, random_);
  if (verdict.is_candidate) {
    candidate_.x = requested_;
    candidate_.y = now_.moving_point->y;
    candidate_.slope = now_.moving_point->slope;
    candidate_.at = at;
    candidate_.energy = now_.energy;
  }
  if (verdict.selects_candidate) std::swap(current_, candidate_);
  // Complete the step, or take another leapfrog step.
  if (verdict.is_complete)
    complete(now_.trajectory->acceptance(), now_.trajectory->depth(),
             energy_error > kMaxEnergyError);
  else
    start_leapfrog(now_.trajectory->moving_point(), now_.trajectory->leapfrog_length());
}

void Hamiltonian::complete(double acceptance, int depth, bool divergent) {
  // Record position and statistics.
  ++steps_;
  positions_.col(0) = current_.x;
  stats_[0] = {current_.at.log_prior[0],
               current_.at.log_likelihood[0],
               acceptance,
               warm_up_.step(),
               current_.energy,
               depth,
               now_.evaluations,
               now_.broken,
               divergent};
  // Adapt during warm-up, then start the next step.
  now_.evaluations = now_.broken = 0;
  if (usable_ && steps_ <= options_.warm_up) {
    weigh(current_.at);
    if (warm_up_.learn(steps_, current_.x, gradient_, acceptance)) {
      current_.y = warm_up_.whitening().to_whitened(current_.x);
      whiten();
    }
  }
  warm_up_.freeze_after_warm_up(steps_);
  begin();
}

// Computes the gradient of the tempered density.
void Hamiltonian::weigh(const Densities& at) {
  gradient_ = at.prior_gradient.col(0);
  if (options_.beta > 0) gradient_ += options_.beta * at.likelihood_gradient.col(0);
}

bool Hamiltonian::usable(const Densities& at) {
  weigh(at);
  return std::isfinite(tempered_density(at, 0, options_.beta).value) && gradient_.allFinite();
}

// Computes the slope at the chain's position.
void Hamiltonian::whiten() {
  weigh(current_.at);
  warm_up_.whitening().whiten_gradient(current_.y, gradient_, current_.slope);
}

void Hamiltonian::move(int /*chain*/, const Eigen::VectorXd& x, const Densities& at) {
  require(x.size() == current_.x.size() && at.prior_gradient.size() == x.size() &&
              at.likelihood_gradient.size() == x.size(),
          "chain of {} coordinates cannot move to {}, with gradients of {} and {}",
          current_.x.size(), x.size(), at.prior_gradient.size(), at.likelihood_gradient.size());
  // Store the known density.
  current_.x = x;
  current_.y = warm_up_.whitening().to_whitened(x);
  current_.at = at;
  positions_.col(0) = x;
  known_ = true;
  usable_ = usable(at);
  whiten();
  begin();
}

void Hamiltonian::set_beta(double beta) {
  options_.beta = beta;
  if (!known_) return;
  usable_ = usable(current_.at);
  whiten();
  begin();
}

void Hamiltonian::save(StateWriter& to) const {
  to.write(std::int64_t{steps_});
  to.write(std::int64_t{known_ ? 1 : 0});
  to.write(current_.x);
  to.write(current_.y);
  to.write(current_.at.log_prior);
  to.write(current_.at.log_likelihood);
  to.write(current_.at.prior_gradient);
  to.write(current_.at.likelihood_gradient);
  warm_up_.save(to);
}

void Hamiltonian::restore(StateReader& from) {
  // Restore steps, position and densities.
  steps_ = from.integer();
  known_ = from.integer() != 0;
  // There is no density before the first one is known.
  const Eigen::Index n = positions_.rows(), one = known_ ? 1 : 0;
  current_.x = saved_vector(from, "position", n);
  current_.y = saved_vector(from, "whitened position", n);
  current_.at.log_prior = saved_vector(from, "log prior", one);
  current_.at.log_likelihood = saved_vector(from, "log likelihood", one);
  current_.at.prior_gradient = saved_matrix(from, "gradient of the log prior", one * n, one);
  current_.at.likelihood_gradient =
      saved_matrix(from, "gradient of the log likelihood", one * n, one);
  // Restore metric and step size; everything else follows from the position.
  warm_up_.restore(from);
  positions_.col(0) = current_.x;
  usable_ = known_ && usable(current_.at);
  if (known_) whiten();
  now_.evaluations = now_.broken = 0;
  begin();
}

}  // namespace

std::unique_ptr<Sampler> hamiltonian(SamplingMethod method, const Eigen::MatrixXd& starts,
                                     const SamplerOptions& options) {
  require(starts.cols() == 1, "{} moves one chain, got {} starts", name_of(method), starts.cols());
  require(options.max_depth <= 30, "depth of trees must be <= 30, got {}", options.max_depth);
  return std::make_unique<Hamiltonian>(method, starts.col(0), options);
}

}  // namespace thenar::internal
