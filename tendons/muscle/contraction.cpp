#include "tendons/muscle/contraction.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "base/rung_names.h"
#include "tendons/muscle/rigid_tensions.h"

namespace thenar {
namespace {

/// Solver that computes muscle by muscle.
class TensionsInTurn : public TensionSolver {
 public:
  explicit TensionsInTurn(const Contraction& of) : of_(&of) {}
  void tensions(const MuscleStates& at, MuscleTensions& out) override {
    out.tension.resize(at.length.size());
    for (int m = 0; m < at.length.size(); ++m) out.tension[m] = of_->tension(m, at.muscle(m));
  }
  void derivatives(const MuscleStates& at, MuscleTensions& out) override {
    tensions(at, out);
    for (Eigen::VectorXd* each :
         {&out.by_activation, &out.by_length, &out.by_velocity, &out.by_projected_fibre})
      each->resize(at.length.size());
    for (int m = 0; m < at.length.size(); ++m) {
      const TensionDerivatives by = of_->tension_derivatives(m, at.muscle(m));
      out.by_activation[m] = by.by_activation;
      out.by_length[m] = by.by_length;
      out.by_velocity[m] = by.by_velocity;
      out.by_projected_fibre[m] = by.by_projected_fibre;
    }
  }

 private:
  const Contraction* of_;
};

/// Muscle model `bounds`: tension = activation F0.
class Bounds : public Contraction {
 public:
  using Contraction::Contraction;
  [[nodiscard]] Muscle rung() const override { return Muscle::kBounds; }
  [[nodiscard]] double tension(int m, const MuscleState& state) const override {
    return std::max(0.0, state.activation) * muscle(m).F0;  // an integrator may go below 0
  }
  [[nodiscard]] TensionDerivatives tension_derivatives(int m,
                                                       const MuscleState& state) const override {
    return {state.activation < 0 ? 0 : muscle(m).F0, 0, 0, 0};
  }
};

/// Tension law of an elastic tendon beside a constant base tension.
class TendonLaw : public TensionLaw {
 public:
  TendonLaw(const Musculotendon& muscle, double strain, double base)
      : F0_(muscle.F0), slack_(muscle.slack), strain_(strain), base_(base) {}
  [[nodiscard]] BandResponse response_at(double length) const override {
    const double l = length / slack_;
    return {base_ * length + F0_ * slack_ * tendon_energy(l, strain_),
            base_ + F0_ * tendon_force(l, strain_),
            F0_ / slack_ * tendon_force_derivative(l, strain_)};
  }

 private:
  double F0_, slack_, strain_, base_;
};

/// Hill's model with an elastic tendon.
class ElasticTendon : public Contraction {
 public:
  ElasticTendon(std::vector<Musculotendon> muscles, const HillOptions& options)
      : Contraction(std::move(muscles)), options_(options) {}
  [[nodiscard]] Muscle rung() const override { return Muscle::kElasticTendon; }
  [[nodiscard]] bool has_fibre_state() const override { return true; }
  [[nodiscard]] double tension(int m, const MuscleState& state) const override {
    return elastic_tendon_tension(muscle(m), options_, state.length, state.projected_fibre);
  }
  [[nodiscard]] TensionDerivatives tension_derivatives(int m,
                                                       const MuscleState& state) const override {
    return elastic_tendon_derivatives(muscle(m), options_, state.length, state.projected_fibre);
  }
  [[nodiscard]] FibreRateDerivatives fibre_rate_derivatives(
      int m, const MuscleState& state) const override {
    return thenar::fibre_rate_derivatives(muscle(m), options_, state.activation, state.length,
                                          state.projected_fibre);
  }
  [[nodiscard]] double projected_fibre_rate(int m, const MuscleState& state) const override {
    return thenar::projected_fibre_rate(muscle(m), options_, state.activation, state.length,
                                        state.projected_fibre);
  }
  [[nodiscard]] double isometric_projected_fibre(int m, double activation,
                                                 double length) const override {
    return thenar::isometric_projected_fibre(muscle(m), options_, activation, length);
  }
  [[nodiscard]] std::shared_ptr<const TensionLaw> tendon_law(int m, double base) const override {
    return std::make_shared<const TendonLaw>(muscle(m), options_.tendon_strain, base);
  }
  [[nodiscard]] double fibre(int m, const MuscleState& state) const override {
    return normalised_fibre_length(muscle(m), state.projected_fibre);
  }

 private:
  HillOptions options_;
};

/// Hill's model with a rigid tendon.
class RigidTendon : public Contraction {
 public:
  RigidTendon(std::vector<Musculotendon> muscles, const HillOptions& options)
      : Contraction(std::move(muscles)), options_(options) {}
  [[nodiscard]] Muscle rung() const override { return Muscle::kRigidTendon; }
  [[nodiscard]] bool depends_on_velocity() const override { return true; }
  [[nodiscard]] double tension(int m, const MuscleState& state) const override {
    return rigid_tendon_tension(muscle(m), options_, state.activation, state.length,
                                state.velocity);
  }
  [[nodiscard]] TensionDerivatives tension_derivatives(int m,
                                                       const MuscleState& state) const override {
    return rigid_tendon_derivatives(muscle(m), options_, state.activation, state.length,
                                    state.velocity);
  }
  [[nodiscard]] std::unique_ptr<TensionSolver> tension_solver() const override {
    return rigid_tensions(muscles(), options_);
  }
  [[nodiscard]] double fibre(int m, const MuscleState& state) const override {
    return normalised_fibre_length(muscle(m), state.length - muscle(m).slack);
  }
  [[nodiscard]] std::unique_ptr<Contraction> with_compliant_tendon(double strain) const override {
    // Set the slack length to the optimal fibre length.
    std::vector<Musculotendon> short_ones = muscles();
    for (Musculotendon& m : short_ones) m.slack = m.optimal_fibre_length;
    HillOptions options = options_;
    options.tendon_strain = strain;
    return std::make_unique<ElasticTendon>(std::move(short_ones), options);
  }

 private:
  HillOptions options_;
};

/// Returns a muscle of the subject. @throws InputError if there is none
const MuscleUnit& muscle_unit(const Subject& subject, const std::string& name) {
  const MuscleUnit* found = find_named(subject.muscles, name);
  require(found != nullptr, "subject '{}' has no muscle '{}'", subject.name, name);
  return *found;
}

/// Returns "; 'bounds' does without", if a key is first needed by this model.
std::string lower_rung(Muscle rung) {
  if (rung == Muscle::kBounds) return "";
  return fmt::format("; '{}' does without",
                     name_in(kMuscleNames, static_cast<Muscle>(static_cast<int>(rung) - 1)));
}

}  // namespace

void MuscleStates::clear(Eigen::Index muscles) {
  for (Eigen::VectorXd* each : {&activation, &length, &velocity, &projected_fibre})
    each->setZero(muscles);
}

std::unique_ptr<TensionSolver> Contraction::tension_solver() const {
  return std::make_unique<TensionsInTurn>(*this);
}

std::unique_ptr<Contraction> build_contraction(std::vector<Musculotendon> muscles, Muscle rung,
                                               const HillOptions& options) {
  require(options.max_velocity > 0 && options.damping > 0 && options.tendon_strain > 0,
          "largest speed, damping and tendon strain must be positive, got {}, {}, {}",
          options.max_velocity, options.damping, options.tendon_strain);
  if (rung == Muscle::kElasticTendon)
    return std::make_unique<ElasticTendon>(std::move(muscles), options);
  if (rung == Muscle::kRigidTendon)
    return std::make_unique<RigidTendon>(std::move(muscles), options);
  return std::make_unique<Bounds>(std::move(muscles));
}

std::string muscle_without_fibre(const Subject& subject, const TendonDigit& digit) {
  for (const std::string& name : digit.names.muscles)
    if (!(muscle_unit(subject, name).fibre_length > 0)) return name;
  return "";
}

std::vector<Musculotendon> musculotendons(const Subject& subject, const TendonDigit& digit,
                                          Muscle rung) {
  std::vector<Musculotendon> muscles;
  for (const std::string& name : digit.names.muscles) {
    const MuscleUnit& muscle = muscle_unit(subject, name);
    const auto require_key = [&](bool known, const char* key, Muscle first) {
      require(known, "muscle '{}' of subject '{}' needs '{}' to pull as '{}'{}", name, subject.name,
              key, name_in(kMuscleNames, rung), lower_rung(first));
    };
    // Require the keys of this model and of those below it.
    require_key(muscle.max_force.has_value(), "max_force_N", Muscle::kBounds);
    if (rung >= Muscle::kRigidTendon)
      require_key(muscle.fibre_length > 0, "fibre_length_mm", Muscle::kRigidTendon);
    if (rung >= Muscle::kElasticTendon)
      require_key(muscle.tendon_slack > 0, "tendon_slack_mm", Muscle::kElasticTendon);
    muscles.push_back(
        {name, *muscle.max_force, muscle.fibre_length, muscle.tendon_slack, muscle.pennation});
  }
  return muscles;
}

}  // namespace thenar
