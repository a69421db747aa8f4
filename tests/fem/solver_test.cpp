// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SparseCholesky>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <thread>

#include "cholmod_factorization.h"
#include "ellipsoid_mesh.h"
#include "external_loads.h"
#include "front_tree.h"
#include "glisson/core/error.h"
#include "glisson/fem/integrator.h"
#include "gmres.h"
#include "multifrontal_factorization.h"
#include "stiffness.h"
#include "two_level_solver.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

/// The matrix of a deformed composite, as a step factorises it.
struct Example {
  CompositeModel model;
  BlockSystem system;
  Points force;
  Eigen::VectorXd right;

  Example(int across, std::vector<int> fixed, const BatchKernels& kernels = batch_kernels(),
          Ordering ordering = Ordering::fill_reducing)
      : model(ellipsoid_mesh(across), ellipsoid_vessels(60), {}),
        system(model.impl(), fixed, kernels, ordering),
        right() {
    const Points x = model.mesh().vertices + noise(model.node_count(), 0.002, 7);
    system.assemble(x, 6.0, Tangent::rotated, force);
    system.add_diagonal(model.lumped_mass(), 2505.0);
    right = system.gather(force);
  }
};

/// Iterations of conjugate gradients with the diagonal blocks' inverses alone.
int plain_iterations(const Example& example, double tolerance) {
  const BlockPattern& pattern = example.system.pattern();
  const auto divide = [&](const Eigen::VectorXd& r) {
    Eigen::VectorXd z(r.size());
    for (int c = 0; c < pattern.unknowns; ++c) {
      const Eigen::Map<const Eigen::Matrix3d> block(example.system.values().data() +
                                                    9L * pattern.column_start[static_cast<std::size_t>(c)]);
      z.segment<3>(3 * c) = block.llt().solve(r.segment<3>(3 * c));
    }
    return z;
  };
  Eigen::VectorXd r = example.right, z = divide(r), d = z, q;
  int iterations = 0;
  for (; iterations < 5000 && r.norm() > tolerance * example.right.norm(); ++iterations) {
    example.system.multiply(d, q);
    const double rz = r.dot(z);
    r -= rz / d.dot(q) * q;
    z = divide(r);
    d = z + r.dot(z) / rz * d;
  }
  return iterations;
}

}  // namespace

class SolverTest : public QObject {
  Q_OBJECT
 private slots:
  void FrontsHoldEveryEntryOnce() {
    const Example example(8, {});
    const BlockPattern& pattern = example.system.pattern();
    const std::vector<Front> fronts = build_fronts(pattern);
    int next = 0;
    for (std::size_t f = 0; f < fronts.size(); ++f) {
      QCOMPARE(fronts[f].first, next);
      next += fronts[f].columns;
      QVERIFY(std::is_sorted(fronts[f].rows.begin(), fronts[f].rows.end()));
      QVERIFY(fronts[f].rows.empty() || fronts[f].rows.front() >= next);
      QVERIFY(fronts[f].parent < 0 || fronts[f].parent > static_cast<int>(f));
      for (int c = fronts[f].first; c < next; ++c)
        for (int b = pattern.column_start[static_cast<std::size_t>(c)];
             b < pattern.column_start[static_cast<std::size_t>(c) + 1]; ++b) {
          const int row = pattern.rows[static_cast<std::size_t>(b)];
          QVERIFY(row < next || std::binary_search(fronts[f].rows.begin(), fronts[f].rows.end(), row));
        }
    }
    QCOMPARE(next, pattern.unknowns);
  }

  void MemoryOfLivingFrontsNeverOverlaps() {
    const Example example(8, {});
    const std::vector<Front> fronts = build_fronts(example.system.pattern());
    std::vector<std::size_t> sizes;
    for (const Front& front : fronts) sizes.push_back(front.rows.size());
    for (const FrontGroups& groups : {in_one_go(fronts), share_out(fronts)}) {
      std::size_t total = 0, sum = 0;
      const std::vector<std::size_t> offsets = plan_memory(fronts, groups, sizes, &total);
      std::vector<std::size_t> group_of(fronts.size(), groups.size());
      for (std::size_t k = 0; k < groups.size(); ++k)
        for (const int f : groups[k]) group_of[static_cast<std::size_t>(f)] = k;
      for (std::size_t f = 0; f < fronts.size(); ++f) {
        sum += sizes[f];
        QVERIFY(offsets[f] + sizes[f] <= total);
        for (std::size_t g = 0; g < f; ++g) {
          // Until the parent has taken it in; in groups that are worked on at once, from the start.
          const bool alive = fronts[g].parent >= static_cast<int>(f) || group_of[f] != group_of[g];
          if (!alive || sizes[f] == 0 || sizes[g] == 0) continue;
          QVERIFY(offsets[f] + sizes[f] <= offsets[g] || offsets[g] + sizes[g] <= offsets[f]);
        }
      }
      QVERIFY(total < sum);
    }
  }

  void SharedSubtreesNeedNothingOfEachOther() {
    const Example example(10, {});
    const std::vector<Front> fronts = build_fronts(example.system.pattern());
    const FrontGroups groups = share_out(fronts);
    QCOMPARE(groups.size(), std::size_t{3});
    std::vector<int> group_of(fronts.size(), -1);
    double work[3] = {0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
      QVERIFY(std::is_sorted(groups[k].begin(), groups[k].end()));
      for (const int f : groups[k]) {
        QCOMPARE(group_of[static_cast<std::size_t>(f)], -1);  // each front once
        group_of[static_cast<std::size_t>(f)] = static_cast<int>(k);
        work[k] += front_work(fronts[static_cast<std::size_t>(f)]);
      }
    }
    for (std::size_t f = 0; f < fronts.size(); ++f) {
      QVERIFY(group_of[f] >= 0);
      for (const int child : fronts[f].children) {
        const int theirs = group_of[static_cast<std::size_t>(child)];
        QVERIFY(theirs == group_of[f] || group_of[f] == 2);
      }
    }
    QVERIFY(std::max(work[0], work[1]) < 1.3 * std::min(work[0], work[1]));
  }

  void TwoThreadsGiveTheSameBits() {
    Example example(16, {0, 1, 2});
    MultifrontalFactorization one(example.system.pattern(), 1), two(example.system.pattern(), 2);
    QCOMPARE(one.threads(), 1);
    QCOMPARE(two.threads(), 2);
    for (int round = 0; round < 5; ++round) {
      QVERIFY(one.factorise(example.system.values()));
      QVERIFY(two.factorise(example.system.values()));
      Eigen::VectorXd x = example.right, y = example.right;
      one.solve(x);
      two.solve(y);
      QVERIFY((x.array() == y.array()).all());
      Eigen::VectorXd product;
      example.system.multiply(x, product);
      QVERIFY((product - example.right).norm() < 1e-9 * example.right.norm());
      example.system.add_diagonal(example.model.lumped_mass(), 1e3);
    }
    example.system.add_diagonal(example.model.lumped_mass(), -1e9);
    QVERIFY(!two.factorise(example.system.values()));
  }

  void SmallMatricesAreLeftToOneThread() {
    const Example example(6, {});
    QCOMPARE(MultifrontalFactorization(example.system.pattern(), 2).threads(), 1);
  }

  void SolversAgreeWithEigen() {
    Example example(10, {3, 4, 5, 40});
    const BlockPattern& pattern = example.system.pattern();
    std::vector<Eigen::Triplet<double>> entries;
    for (int c = 0; c < pattern.unknowns; ++c)
      for (int b = pattern.column_start[static_cast<std::size_t>(c)];
           b < pattern.column_start[static_cast<std::size_t>(c) + 1]; ++b)
        for (int k = 0; k < 9; ++k)
          entries.emplace_back(3 * pattern.rows[static_cast<std::size_t>(b)] + k % 3, 3 * c + k / 3,
                               example.system.values()[static_cast<std::size_t>(9 * b + k)]);
    Eigen::SparseMatrix<double> a(3 * pattern.unknowns, 3 * pattern.unknowns);
    a.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> eigen(a);
    QVERIFY(eigen.info() == Eigen::Success);
    const Eigen::VectorXd expected = eigen.solve(example.right);
    Eigen::VectorXd product;
    example.system.multiply(expected, product);
    QVERIFY((product - example.right).norm() < 1e-10 * example.right.norm());
    for (const LinearSolver kind : {LinearSolver::reference, LinearSolver::direct}) {
      const auto solver = make_factorization(kind, pattern);
      QVERIFY(solver->factorise(example.system.values()));
      Eigen::VectorXd x = example.right;
      solver->solve(x);
      QVERIFY((x - expected).norm() < 1e-10 * expected.norm());
    }
  }

  void PartialPressuresTangentIsASymmetricPartAndTheRest() {
    const CompositeModel model(ellipsoid_mesh(6), {}, {});
    Loads loads;
    loads.pressure = 1000.0;
    const Points normals = triangle_normals(model.surface().mesh);
    for (int t = 0; t < normals.rows(); ++t)
      if (normals(t, 2) > 0.5) loads.pressure_triangles.push_back(t);
    const Points x = bent(model.mesh().vertices), direction = noise(x.rows(), 1.0, 3);
    const double h = 1e-6;
    const Points numeric =
        (external_force(model, loads, x - h * direction) - external_force(model, loads, x + h * direction)) /
        (2.0 * h);
    const Eigen::Map<const Eigen::VectorXd> flat(direction.data(), direction.size());
    const Eigen::VectorXd symmetric = load_stiffness_matrix(model, loads, x, Tangent::exact) * flat;
    Points product = Eigen::Map<const Points>(symmetric.data(), x.rows(), 3);
    const double without = (product - numeric).norm();
    add_pressure_skew_product(model.impl(), loads, x, direction, product);
    QVERIFY((product - numeric).norm() < 1e-7 * numeric.norm());
    QVERIFY(without > 0.01 * numeric.norm());
    // The rest is skew: it gives no work along a direction.
    Points skew = Points::Zero(x.rows(), 3);
    add_pressure_skew_product(model.impl(), loads, x, direction, skew);
    QVERIFY(std::abs(skew.cwiseProduct(direction).sum()) < 1e-12 * skew.norm() * direction.norm());
  }

  void GmresSolvesWhatIsNotSymmetric() {
    // A symmetric matrix and a skew one; the first is inverted, the second is what iterations are for.
    constexpr int kSize = 40;
    const Eigen::MatrixXd r = Eigen::MatrixXd(noise(kSize * kSize / 3 + 1, 1.0, 5))
                                  .reshaped()
                                  .head(kSize * kSize)
                                  .reshaped(kSize, kSize);
    const Eigen::MatrixXd symmetric = r * r.transpose() + Eigen::MatrixXd::Identity(kSize, kSize);
    const Eigen::MatrixXd skew = 0.5 * (r - r.transpose());
    const Eigen::MatrixXd whole = symmetric + skew;
    const Eigen::LLT<Eigen::MatrixXd> factor(symmetric);
    const Eigen::VectorXd b = r.col(3);
    const LinearMap matrix = [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = whole * x; };
    const LinearMap inverse = [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = factor.solve(x); };
    const Eigen::VectorXd x = gmres(matrix, inverse, b, 1e-10, kSize);
    QVERIFY((whole * x - b).norm() < 1e-9 * b.norm());
    const Eigen::VectorXd expected = whole.partialPivLu().solve(b);
    QVERIFY((x - expected).norm() < 1e-7 * expected.norm());
    QVERIFY(gmres(matrix, inverse, 0.0 * b, 1e-10, kSize).isZero(0.0));
  }

  void IndefiniteMatricesAreRefused() {
    Example example(8, {});
    example.system.add_diagonal(example.model.lumped_mass(), -1e7);
    for (const LinearSolver kind : {LinearSolver::reference, LinearSolver::direct})
      QVERIFY(!make_factorization(kind, example.system.pattern())->factorise(example.system.values()));
    std::vector<double> values = example.system.values();
    std::fill(values.begin(), values.end(), std::nan(""));
    QVERIFY(!make_factorization(LinearSolver::direct, example.system.pattern())->factorise(values));
  }

  void EveryVectorWidthGivesTheSameBits() {
    const auto kernels = available_dense_kernels();
    const auto batches = available_batch_kernels();
    const Example first(10, {0, 1, 2}, *batches.front());
    MultifrontalFactorization widest(first.system.pattern(), 1, *kernels.front());
    QVERIFY(widest.factorise(first.system.values()));
    Eigen::VectorXd expected = first.right;
    widest.solve(expected);
    for (std::size_t k = 1; k < kernels.size(); ++k) {
      const Example other(10, {0, 1, 2}, *batches[k]);
      QVERIFY(other.system.values() == first.system.values());
      QVERIFY((other.force.array() == first.force.array()).all());
      MultifrontalFactorization narrower(other.system.pattern(), 1, *kernels[k]);
      QVERIFY(narrower.factorise(other.system.values()));
      Eigen::VectorXd x = other.right;
      narrower.solve(x);
      QVERIFY((x.array() == expected.array()).all());
    }
    if (kernels.size() < 3) QSKIP("this machine has not all vector widths; those it has agree");
  }

  void TwoLevelCycleInvertsLikeTheFactor() {
    const Example example(12, {3, 4, 5, 40}, batch_kernels(), Ordering::breadth_first);
    const auto factor = make_factorization(LinearSolver::reference, example.system.pattern());
    QVERIFY(factor->factorise(example.system.values()));
    Eigen::VectorXd expected = example.right;
    factor->solve(expected);
    TwoLevelSolver two_level(example.system.pattern(), example.model.mesh().vertices);
    QVERIFY(two_level.prepare(example.system.values()));
    double last = 1.0;
    for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
      Eigen::VectorXd x = Eigen::VectorXd::Zero(example.right.size()), product;
      const TwoLevelSolver::Result result = two_level.solve(example.right, x, tolerance, 200);
      QVERIFY(result.converged);
      // What it reports is what an independent product finds.
      example.system.multiply(x, product);
      const double residual = (product - example.right).norm() / example.right.norm();
      QVERIFY(std::abs(residual - result.residual) < 1e-3 * result.residual + 1e-14);
      QVERIFY(residual <= 1.1 * tolerance);
      const double error = (x - expected).norm() / expected.norm();
      QVERIFY(error < last);
      last = error;
      // From there nothing is left to do.
      QCOMPARE(two_level.solve(example.right, x, 1.2 * tolerance, 200).iterations, 0);
    }
    QVERIFY(last < 1e-8);
  }

  void TwoLevelIterationsDoNotGrowWithTheMesh() {
    // Eight times the elements: one-level conjugate gradients need twice the iterations, these about as many.
    int iterations[2], plain[2];
    for (int k = 0; k < 2; ++k) {
      const Example example(k == 0 ? 10 : 20, {}, batch_kernels(), Ordering::breadth_first);
      TwoLevelSolver two_level(example.system.pattern(), example.model.mesh().vertices);
      QVERIFY(two_level.prepare(example.system.values()));
      Eigen::VectorXd x = Eigen::VectorXd::Zero(example.right.size());
      const TwoLevelSolver::Result result = two_level.solve(example.right, x, 1e-6, 400);
      QVERIFY(result.converged);
      iterations[k] = result.iterations;
      plain[k] = plain_iterations(example, 1e-6);
    }
    qInfo("iterations to 1e-6: two-level %d and %d, conjugate gradients %d and %d", iterations[0],
          iterations[1], plain[0], plain[1]);
    QVERIFY(iterations[1] <= 1.4 * iterations[0]);
    QVERIFY(5 * iterations[1] < plain[1]);
  }

  void TwoLevelRefusesWhatIsNotPositiveDefinite() {
    Example example(8, {}, batch_kernels(), Ordering::breadth_first);
    TwoLevelSolver two_level(example.system.pattern(), example.model.mesh().vertices);
    example.system.add_diagonal(example.model.lumped_mass(), -1e7);
    QVERIFY(!two_level.prepare(example.system.values()));
    std::vector<double> values = example.system.values();
    std::fill(values.begin(), values.end(), std::nan(""));
    QVERIFY(!two_level.prepare(values));
    QVERIFY_THROWS_EXCEPTION(PreconditionError,
                             make_factorization(LinearSolver::fast, example.system.pattern()));
  }

  void EverySweepWidthGivesTheSameBits() {
    const auto kernels = available_sweep_kernels();
    const Example example(10, {0, 1, 2}, batch_kernels(), Ordering::breadth_first);
    std::vector<Eigen::VectorXd> solutions;
    for (const SweepKernels* k : kernels) {
      TwoLevelSolver two_level(example.system.pattern(), example.model.mesh().vertices, *k);
      QVERIFY(two_level.prepare(example.system.values()));
      solutions.push_back(Eigen::VectorXd::Zero(example.right.size()));
      QVERIFY(two_level.solve(example.right, solutions.back(), 1e-8, 200).converged);
      QVERIFY((solutions.back().array() == solutions.front().array()).all());
    }
    if (kernels.size() < 2) QSKIP("this machine has one vector width");
  }

  void FastStepsFollowTheDirectOnes() {
    const auto model =
        std::make_shared<CompositeModel>(ellipsoid_mesh(12), ellipsoid_vessels(60), CompositeOptions{});
    Loads loads;
    loads.gravity_change = {3.0, -5.0, 1.0};
    loads.pressure = 300.0;
    Points ends[3];
    const std::array<LinearSolver, 3> solvers{LinearSolver::direct, LinearSolver::fast, LinearSolver::fast};
    for (std::size_t run = 0; run < 3; ++run) {
      IntegratorOptions options;
      options.solver = solvers[run];
      options.tolerance = 1e-8;
      options.fixed_nodes = {0, 1, 2, 3};
      Integrator integrator(model, options);
      for (int n = 0; n < 40; ++n) {
        const StepSummary step = integrator.step(loads);
        QVERIFY(step.ok);
        QVERIFY(step.residual < 1.1e-8);
        QCOMPARE(step.iterations > 0, solvers[run] == LinearSolver::fast);
      }
      ends[run] = integrator.positions();
    }
    const double moved = (ends[0] - model->mesh().vertices).rowwise().norm().maxCoeff();
    QVERIFY(moved > 0.005);
    QVERIFY((ends[1] - ends[0]).rowwise().norm().maxCoeff() < 1e-5 * moved);
    QVERIFY((ends[1].array() == ends[2].array()).all());
  }

  void StepsOnTwoThreadsAtOnceGiveTheSameBits() {
    const auto model =
        std::make_shared<CompositeModel>(ellipsoid_mesh(10), ellipsoid_vessels(40), CompositeOptions{});
    for (const LinearSolver solver : {LinearSolver::direct, LinearSolver::fast, LinearSolver::reference}) {
      const auto run = [&] {
        IntegratorOptions options;
        options.solver = solver;
        Integrator integrator(model, options);
        for (int n = 0; n < 30; ++n) {
          Loads loads;
          loads.gravity_change = {std::sin(0.1 * n), std::cos(0.07 * n), 0.5};
          if (!integrator.step(loads).ok) return Points(Points::Zero(1, 3));
        }
        return integrator.positions();
      };
      const Points alone = run();
      QCOMPARE(alone.rows(), static_cast<Eigen::Index>(model->node_count()));
      std::array<Points, 2> beside;
      std::thread first([&] { beside[0] = run(); });
      std::thread second([&] { beside[1] = run(); });
      first.join();
      second.join();
      for (const Points& end : beside) {
        QCOMPARE(end.rows(), alone.rows());
        QVERIFY2((end.array() == alone.array()).all(), solver == LinearSolver::direct      ? "direct"
                                                       : solver == LinearSolver::reference ? "reference"
                                                                                           : "fast");
      }
    }
  }

  void FastStepThatDoesNotConvergeLeavesTheState() {
    const auto model =
        std::make_shared<CompositeModel>(ellipsoid_mesh(8), ellipsoid_vessels(20), CompositeOptions{});
    IntegratorOptions options;
    options.solver = LinearSolver::fast;
    options.max_iterations = 2;
    Integrator integrator(model, options);
    Loads loads;
    loads.gravity_change = {3.0, -5.0, 1.0};
    const StepSummary step = integrator.step(loads);
    QVERIFY(!step.ok);
    QVERIFY(step.residual > options.tolerance);
    QVERIFY((integrator.positions().array() == model->mesh().vertices.array()).all());
    options.max_iterations = 0;
    QVERIFY_THROWS_EXCEPTION(InputError, Integrator(model, options));
    options.max_iterations = 100;
    options.tolerance = 0.0;
    QVERIFY_THROWS_EXCEPTION(InputError, Integrator(model, options));
  }
};

QTEST_APPLESS_MAIN(SolverTest)
#include "solver_test.moc"
