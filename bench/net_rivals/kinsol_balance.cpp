#include "bench/net_rivals/kinsol_balance.h"

#include <cmath>

// Hidden, so that no call ends up in Simbody's own old SUNDIALS.
#pragma GCC visibility push(hidden)
#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#pragma GCC visibility pop

#include "base/error.h"
#include "bench/net_rivals/bone_reaction.h"

namespace thenar::bench {
namespace {

constexpr double kMillimetre =
    1e-3;                       // unit of the unknown places, so that they are of size one [m]
constexpr double kBone = 1e5;   // how deep nodes sink in as they press [N/m]
constexpr double kHold = 1e-6;  // of a node that nothing holds [N/m]

/// What the callbacks need, and the way between nodes and unknowns.
struct Question {
  const PosedNet* net = nullptr;
  const Watch* watch = nullptr;
  std::vector<int> place;  // of a node among the free ones; -1: fixed
  Eigen::Matrix3Xd x;      // all nodes, the free ones as last unpacked

  void unpack(const double* u) {
    for (const int i : net->free_nodes())
      x.col(i) = kMillimetre * Eigen::Map<const Eigen::Vector3d>(u + 3 * place[i]);
  }
};

int balance(N_Vector u, N_Vector F, void* data) {
  Question& ask = *static_cast<Question*>(data);
  ask.unpack(N_VGetArrayPointer(u));
  if (*ask.watch) (*ask.watch)(settled(*ask.net, ask.x));
  const Eigen::Matrix3Xd f = normal_map(*ask.net, ask.x, kBone);
  for (const int i : ask.net->free_nodes())
    Eigen::Map<Eigen::Vector3d>(N_VGetArrayPointer(F) + 3 * ask.place[i]) = f.col(i);
  return 0;
}

/// d F / d u:  -H(P) dP + k (dP - 1), H the Hessian of the bands.
int jacobian(N_Vector u, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector) {
  Question& ask = *static_cast<Question*>(data);
  ask.unpack(N_VGetArrayPointer(u));
  const Sunk at = sunk(*ask.net, ask.x);
  const Eigen::Index n = SUNDenseMatrix_Rows(matrix);
  Eigen::Map<Eigen::MatrixXd> J(SUNDenseMatrix_Data(matrix), n, n);
  J.setZero();
  const auto add = [&](int row, int column, const Eigen::Matrix3d& slope) {
    if (ask.place[row] >= 0 && ask.place[column] >= 0)
      J.block<3, 3>(3 * ask.place[row], 3 * ask.place[column]) +=
          kMillimetre * slope * at.slopes[static_cast<std::size_t>(column)];
  };
  const std::vector<NetBand>& bands = ask.net->net().bands;
  for (std::size_t k = 0; k < bands.size(); ++k) {
    const int a = bands[k].a, b = bands[k].b;
    const Eigen::Matrix<double, 6, 6> H = ask.net->band(static_cast<int>(k), at.outside).slope;
    add(a, a, -H.topLeftCorner<3, 3>());
    add(a, b, -H.topRightCorner<3, 3>());
    add(b, a, -H.bottomLeftCorner<3, 3>());
    add(b, b, -H.bottomRightCorner<3, 3>());
  }
  for (const int i : ask.net->free_nodes()) {
    add(i, i, kBone * Eigen::Matrix3d::Identity());
    J.diagonal().segment<3>(3 * ask.place[i]).array() -= (kBone + kHold) * kMillimetre;
  }
  return 0;
}

/// KINSOL warns on stderr; its return code says as much.
void be_quiet(int, const char*, const char*, char*, void*) {}

}  // namespace

struct [[gnu::visibility("hidden")]] KinsolBalance::Parts {
  SUNContext context = nullptr;
  N_Vector u = nullptr, ones = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver linear = nullptr;
  void* kinsol = nullptr;
  Question ask;
  double tolerance;
};

KinsolBalance::KinsolBalance(const Net& net, double tolerance) : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.tolerance = tolerance;
  int places = 0;
  for (const NetNode& node : net.nodes) p.ask.place.push_back(node.free ? places++ : -1);
  const int n = 3 * places;
  SUNContext_Create(nullptr, &p.context);
  p.u = N_VNew_Serial(n, p.context);
  p.ones = N_VNew_Serial(n, p.context);
  N_VConst(1, p.ones);
  p.matrix = SUNDenseMatrix(n, n, p.context);
  p.linear = SUNLinSol_Dense(p.u, p.matrix, p.context);
  p.kinsol = KINCreate(p.context);
  const bool built = KINInit(p.kinsol, balance, p.u) == KIN_SUCCESS &&
                     KINSetLinearSolver(p.kinsol, p.linear, p.matrix) == KIN_SUCCESS &&
                     KINSetJacFn(p.kinsol, jacobian) == KIN_SUCCESS;
  require(built, "KINSOL could not be set up for {} unknowns", n);
  KINSetUserData(p.kinsol, &p.ask);
  KINSetErrHandlerFn(p.kinsol, be_quiet, nullptr);
  KINSetFuncNormTol(p.kinsol, tolerance);
  KINSetScaledStepTol(p.kinsol, 1e-15);
  KINSetMaxSetupCalls(p.kinsol, 1);  // a new Jacobian every step: exact Newton
  KINSetNumMaxIters(p.kinsol, 500);
}

KinsolBalance::~KinsolBalance() {
  Parts& p = *parts_;
  KINFree(&p.kinsol);
  SUNLinSolFree(p.linear);
  SUNMatDestroy(p.matrix);
  N_VDestroy(p.ones);
  N_VDestroy(p.u);
  SUNContext_Free(&p.context);
}

RivalRest KinsolBalance::solve(const PosedNet& net, const Eigen::Matrix3Xd& start,
                               const Watch& watch) {
  Parts& p = *parts_;
  p.ask.net = &net;
  p.ask.watch = &watch;
  p.ask.x = settled(net, net.from(start));
  // Nodes start as deep in the bone as they press at once.
  for (const BoneProbe& bone : pressed(net, p.ask.x, net.band_forces(p.ask.x)))
    p.ask.x.col(bone.node) +=
        bone.normal.dot(net.band_forces(p.ask.x).col(bone.node)) / kBone * bone.normal;
  double* u = N_VGetArrayPointer(p.u);
  for (const int i : net.free_nodes())
    Eigen::Map<Eigen::Vector3d>(u + 3 * p.ask.place[i]) = p.ask.x.col(i) / kMillimetre;
  const int code = KINSol(p.kinsol, p.u, KIN_LINESEARCH, p.ones, p.ones);
  RivalRest rest;
  p.ask.unpack(u);
  rest.x = settled(net, p.ask.x);
  long iterations = 0;
  KINGetNumNonlinSolvIters(p.kinsol, &iterations);
  KINGetFuncNorm(p.kinsol, &rest.residual);
  rest.iterations = static_cast<int>(iterations);
  rest.balanced = code >= 0 && rest.residual <= p.tolerance;
  return rest;
}

}  // namespace thenar::bench
