// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SparseCholesky>
#include <QtTest>
#include <algorithm>

#include "cholmod_factorization.h"
#include "ellipsoid_mesh.h"
#include "front_tree.h"
#include "multifrontal_factorization.h"

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

  Example(int across, std::vector<int> fixed, const BatchKernels& kernels = batch_kernels())
      : model(ellipsoid_mesh(across), ellipsoid_vessels(60), {}),
        system(model.impl(), fixed, kernels),
        right() {
    const Points x = model.mesh().vertices + noise(model.node_count(), 0.002, 7);
    system.assemble(x, 6.0, Tangent::rotated, force);
    system.add_diagonal(model.lumped_mass(), 2505.0);
    right = system.gather(force);
  }
};

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
    std::size_t total = 0, sum = 0;
    const std::vector<std::size_t> offsets = plan_memory(fronts, sizes, &total);
    for (std::size_t f = 0; f < fronts.size(); ++f) {
      sum += sizes[f];
      for (std::size_t g = 0; g < f; ++g) {
        const bool alive = fronts[g].parent >= static_cast<int>(f);
        if (!alive || sizes[f] == 0 || sizes[g] == 0) continue;
        QVERIFY(offsets[f] + sizes[f] <= offsets[g] || offsets[g] + sizes[g] <= offsets[f]);
      }
    }
    QVERIFY(total < sum);
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
    MultifrontalFactorization widest(first.system.pattern(), *kernels.front());
    QVERIFY(widest.factorise(first.system.values()));
    Eigen::VectorXd expected = first.right;
    widest.solve(expected);
    for (std::size_t k = 1; k < kernels.size(); ++k) {
      const Example other(10, {0, 1, 2}, *batches[k]);
      QVERIFY(other.system.values() == first.system.values());
      QVERIFY((other.force.array() == first.force.array()).all());
      MultifrontalFactorization narrower(other.system.pattern(), *kernels[k]);
      QVERIFY(narrower.factorise(other.system.values()));
      Eigen::VectorXd x = other.right;
      narrower.solve(x);
      QVERIFY((x.array() == expected.array()).all());
    }
    if (kernels.size() < 3) QSKIP("this machine has not all vector widths; those it has agree");
  }
};

QTEST_APPLESS_MAIN(SolverTest)
#include "solver_test.moc"
