#include "solvers/stiff_ode.h"

#include <cmath>
#include <exception>
#include <utility>

// Simbody exports functions of an older SUNDIALS with the same names. Hidden symbols are never
// resolved to a shared library.
#pragma GCC visibility push(hidden)
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#pragma GCC visibility pop

#include "base/error.h"

namespace thenar {
namespace {

Eigen::Map<Eigen::VectorXd> values(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<Eigen::Index>(N_VGetLength(v))};
}

OdeStatus status_of(int flag) {
  switch (flag) {
    case CV_SUCCESS:
    case CV_TSTOP_RETURN:
    case CV_WARNING:
      return OdeStatus::kStepped;
    case CV_TOO_MUCH_WORK:
      return OdeStatus::kLimit;
    case CV_ERR_FAILURE:
    case CV_CONV_FAILURE:
      return OdeStatus::kTooStiff;
    case CV_RHSFUNC_FAIL:
    case CV_FIRST_RHSFUNC_ERR:
    case CV_REPTD_RHSFUNC_ERR:
    case CV_UNREC_RHSFUNC_ERR:
      return OdeStatus::kNotFinite;
    case CV_LINIT_FAIL:
    case CV_LSETUP_FAIL:
    case CV_LSOLVE_FAIL:
      return OdeStatus::kSingular;
    case CV_TOO_MUCH_ACC:
    case CV_TOO_CLOSE:
      return OdeStatus::kImpossible;
    default:
      return OdeStatus::kFailed;
  }
}

void silent(int, const char*, const char*, char*, void*) {}

}  // namespace

struct __attribute__((visibility("hidden"))) StiffOde::Parts {
  Parts(OdeRightHandSide f, double t, const Eigen::VectorXd& y, const StiffOdeOptions& o)
      : slope(std::move(f)),
        jacobian(o.jacobian),
        relative(o.relative),
        absolute(o.absolute),
        max_steps(o.max_steps),
        time(t) {
    require(SUNContext_Create(nullptr, &context) == 0, "CVODE has no memory");
    // Create vectors, matrix and linear solver.
    state = N_VNew_Serial(y.size(), context);
    scratch = N_VNew_Serial(y.size(), context);
    matrix = SUNDenseMatrix(y.size(), y.size(), context);
    solver = SUNLinSol_Dense(state, matrix, context);
    cvode = CVodeCreate(CV_BDF, context);
    values(state) = y;
    values(scratch) = o.absolute;
    // Set tolerances, Jacobian and callbacks.
    const bool ready =
        CVodeInit(cvode, &Parts::evaluate_slope, time, state) == CV_SUCCESS &&
        CVodeSVtolerances(cvode, o.relative, scratch) == CV_SUCCESS &&
        CVodeSetLinearSolver(cvode, solver, matrix) == CV_SUCCESS &&
        (!jacobian || CVodeSetJacFn(cvode, &Parts::evaluate_jacobian) == CV_SUCCESS) &&
        CVodeSetUserData(cvode, this) == CV_SUCCESS &&
        CVodeSetErrHandlerFn(cvode, silent, nullptr) == CV_SUCCESS;
    require(ready, "CVODE could not be set up for {} states", y.size());
  }

  ~Parts() {
    CVodeFree(&cvode);
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    N_VDestroy(scratch);
    N_VDestroy(state);
    SUNContext_Free(&context);
  }

  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  /// Evaluates a function at y for CVODE. No exception may propagate through its C code.
  /// @param evaluate  returns whether the result is finite
  template <typename Evaluate>
  static int guarded(void* user, N_Vector y, const Evaluate& evaluate) {
    auto& parts = *static_cast<Parts*>(user);
    try {
      const Eigen::VectorXd at = values(y);
      return at.allFinite() && evaluate(parts, at) ? 0 : 1;  // 1: try a shorter step
    } catch (...) {
      parts.thrown = std::current_exception();
      return -1;
    }
  }

  static int evaluate_slope(double t, N_Vector y, N_Vector y_dot, void* user) {
    return guarded(user, y, [&](const Parts& parts, const Eigen::VectorXd& at) {
      values(y_dot) = parts.slope(t, at);
      return values(y_dot).allFinite();
    });
  }

  // NOLINTNEXTLINE(readability-function-size): the signature is CVODE's
  static int evaluate_jacobian(double t, N_Vector y, N_Vector, SUNMatrix J, void* user, N_Vector,
                               N_Vector, N_Vector) {
    return guarded(user, y, [&](const Parts& parts, const Eigen::VectorXd& at) {
      Eigen::Map<Eigen::MatrixXd> out(SUNDenseMatrix_Data(J), at.size(), at.size());
      out = parts.jacobian(t, at);
      return out.allFinite();
    });
  }

  [[nodiscard]] OdeCounts counts() const {
    long steps = 0, slopes = 0, by_jacobian = 0, jacobians = 0, inaccurate = 0, unsolved = 0;
    CVodeGetNumSteps(cvode, &steps);
    CVodeGetNumRhsEvals(cvode, &slopes);
    CVodeGetNumLinRhsEvals(cvode, &by_jacobian);
    CVodeGetNumJacEvals(cvode, &jacobians);
    CVodeGetNumErrTestFails(cvode, &inaccurate);
    CVodeGetNumStepSolveFails(cvode, &unsolved);
    return {counts_before.steps + steps, counts_before.slopes + slopes + by_jacobian,
            counts_before.jacobians + jacobians, counts_before.rejected + inaccurate + unsolved};
  }

  OdeRightHandSide slope;
  OdeJacobian jacobian;
  double relative;           // relative tolerance of a step [1]
  Eigen::VectorXd absolute;  // absolute tolerance of each state, in its unit (n)
  int max_steps;
  double time;
  std::exception_ptr thrown;
  OdeCounts counts_before;  // counts before the last restart
  SUNContext context = nullptr;
  N_Vector state = nullptr;
  N_Vector scratch = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver solver = nullptr;
  void* cvode = nullptr;
};

StiffOde::StiffOde(OdeRightHandSide slope, double time, const Eigen::VectorXd& y,
                   const StiffOdeOptions& options) {
  // Check the state and the tolerances.
  require(y.size() > 0 && y.allFinite(), "wanted a state of finite numbers, got {} entries",
          y.size());
  require(options.relative > 0, "relative tolerance must be positive, got {}", options.relative);
  require(options.absolute.size() == y.size(), "{} absolute tolerances for {} states",
          options.absolute.size(), y.size());
  require((options.absolute.array() > 0).all(), "absolute tolerances must be positive, least is {}",
          options.absolute.minCoeff());
  parts_ = std::make_unique<Parts>(std::move(slope), time, y, options);
}
StiffOde::~StiffOde() = default;
StiffOde::StiffOde(StiffOde&&) noexcept = default;
StiffOde& StiffOde::operator=(StiffOde&&) noexcept = default;

OdeStatus StiffOde::step(double stop) {
  require(stop > parts_->time, "cannot step from {} s to {} s", parts_->time, stop);
  if (counts().steps >= parts_->max_steps) return OdeStatus::kLimit;
  CVodeSetStopTime(parts_->cvode, stop);
  const int flag = CVode(parts_->cvode, stop, parts_->state, &parts_->time, CV_ONE_STEP);
  if (parts_->thrown) std::rethrow_exception(std::exchange(parts_->thrown, nullptr));
  return status_of(flag);
}

void StiffOde::restart(double tolerance_factor) {
  require(tolerance_factor > 0 && std::isfinite(tolerance_factor),
          "errors of steps must be positive, got {} times", tolerance_factor);
  parts_->counts_before = parts_->counts();
  values(parts_->scratch) = tolerance_factor * parts_->absolute;
  require(CVodeReInit(parts_->cvode, parts_->time, parts_->state) == CV_SUCCESS &&
              CVodeSVtolerances(parts_->cvode, tolerance_factor * parts_->relative,
                                parts_->scratch) == CV_SUCCESS,
          "CVODE could not start anew at {} s", parts_->time);
}

double StiffOde::time() const { return parts_->time; }

Eigen::VectorXd StiffOde::state() const { return values(parts_->state); }

Eigen::VectorXd StiffOde::state_at(double time) const {
  if (time == parts_->time) return state();
  require(CVodeGetDky(parts_->cvode, time, 0, parts_->scratch) == CV_SUCCESS,
          "{} s is not within the last step, which ended at {} s", time, parts_->time);
  return values(parts_->scratch);
}

OdeCounts StiffOde::counts() const { return parts_->counts(); }

}  // namespace thenar
