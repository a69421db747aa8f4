// SPDX-License-Identifier: GPL-3.0-or-later
// One implicit step of the composite liver (tetrahedra, capsule, 100 beams), beside the same step with
// Eigen's SimplicialLDLT and CHOLMOD's supernodal factorisation on the same matrix, in the same run. The
// ratios are what holds on another machine.
#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>
#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include "block_matrix.h"
#include "ellipsoid_mesh.h"
#include "factorization.h"
#include "glisson/fem/integrator.h"

namespace {

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

/// A patient of a size, and the matrix of its step somewhere off rest.
struct Case {
  std::shared_ptr<const CompositeModel> model;
  BlockSystem system;
  Points x, force;
  Eigen::VectorXd right;

  explicit Case(int across)
      : model(std::make_shared<CompositeModel>(ellipsoid_mesh(across), ellipsoid_vessels(100),
                                               CompositeOptions{})),
        system(model->impl(), {}),
        x(model->mesh().vertices + noise(model->node_count(), 0.0005, 1)) {
    assemble();
  }
  void assemble() {
    system.assemble(x, 6.0, Tangent::rotated, force);
    system.add_diagonal(model->lumped_mass(), 2505.0);
    right = system.gather(force);
  }
};

Case& example(int across) {
  static std::map<int, Case> cases;
  return cases.try_emplace(across, across).first->second;
}

void describe(benchmark::State& state, const Case& c) {
  state.counters["tets"] = c.model->mesh().tetrahedron_count();
  state.counters["unknowns"] = 3.0 * c.model->node_count();
}

void step(benchmark::State& state, int across, LinearSolver solver) {
  Case& c = example(across);
  IntegratorOptions options;
  options.solver = solver;
  Integrator integrator(c.model, options);
  Loads loads;
  loads.gravity_change = {1.0, 1.0, 0.0};
  double residual = 0.0;
  for (auto _ : state) residual = std::max(residual, integrator.step(loads).residual);
  describe(state, c);
  state.counters["residual"] = residual;
}

void step_direct(benchmark::State& state, int across) { step(state, across, LinearSolver::direct); }
void step_cholmod(benchmark::State& state, int across) { step(state, across, LinearSolver::reference); }

/// Eigen's analysis is done once, too; our assembly feeds it, so that only the solver differs.
void step_eigen(benchmark::State& state, int across) {
  Case& c = example(across);
  const BlockPattern& p = c.system.pattern();
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < p.unknowns; ++column)
    for (int b = p.column_start[static_cast<std::size_t>(column)];
         b < p.column_start[static_cast<std::size_t>(column) + 1]; ++b)
      for (int k = 0; k < 9; ++k) {
        const int row = 3 * p.rows[static_cast<std::size_t>(b)] + k % 3;
        if (row >= 3 * column + k / 3) entries.emplace_back(row, 3 * column + k / 3, 9 * b + k);
      }
  Eigen::SparseMatrix<double> a(3 * p.unknowns, 3 * p.unknowns);
  a.setFromTriplets(entries.begin(), entries.end());
  std::vector<std::size_t> source;
  for (Eigen::Index k = 0; k < a.nonZeros(); ++k) source.push_back(static_cast<std::size_t>(a.valuePtr()[k]));
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  solver.analyzePattern(a);
  Eigen::VectorXd x;
  for (auto _ : state) {
    c.assemble();
    for (std::size_t k = 0; k < source.size(); ++k) a.valuePtr()[k] = c.system.values()[source[k]];
    solver.factorize(a);
    x = solver.solve(c.right);
    benchmark::DoNotOptimize(x.data());
  }
  describe(state, c);
}

void assemble(benchmark::State& state, int across) {
  Case& c = example(across);
  for (auto _ : state) c.assemble();
  describe(state, c);
}

void factorise(benchmark::State& state, int across) {
  Case& c = example(across);
  const auto solver = make_factorization(LinearSolver::direct, c.system.pattern());
  for (auto _ : state)
    if (!solver->factorise(c.system.values())) state.SkipWithError("not positive definite");
  describe(state, c);
}

void solve(benchmark::State& state, int across) {
  Case& c = example(across);
  const auto solver = make_factorization(LinearSolver::direct, c.system.pattern());
  solver->factorise(c.system.values());
  Eigen::VectorXd x;
  for (auto _ : state) {
    x = c.right;
    solver->solve(x);
  }
  describe(state, c);
}

/// 1000 steps twice from the same start: 1 when every bit of the end is the same.
void determinism(benchmark::State& state, int across) {
  Case& c = example(across);
  bool same = true;
  for (auto _ : state) {
    Points ends[2];
    for (Points& end : ends) {
      Integrator integrator(c.model, {});
      for (int n = 0; n < 1000; ++n) {
        Loads loads;
        loads.gravity_change = {std::sin(0.1 * n), std::cos(0.07 * n), 0.5};
        integrator.step(loads);
      }
      end = integrator.positions();
    }
    same = same && (ends[0].array() == ends[1].array()).all();
  }
  state.counters["same_bits"] = same ? 1.0 : 0.0;
}

/// Prints as usual and keeps the times of this one thread for the ratios (the clock on the wall counts what
/// else the machine does).
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.iterations > 0 && !run.error_occurred) times_[run.benchmark_name()] = run.GetAdjustedCPUTime();
  }
  void print_ratios() const {
    for (const char* size : {"composite_2k", "composite_10k"}) {
      const std::string base = std::string("step/") + size;
      const auto direct = times_.find(base + "/direct");
      for (const char* peer : {"eigen_ldlt", "cholmod_supernodal"}) {
        const auto other = times_.find(base + "/" + peer);
        if (direct != times_.end() && other != times_.end())
          std::printf("%s: direct is %.1f times faster than %s\n", base.c_str(),
                      other->second / direct->second, peer);
      }
    }
  }

 private:
  std::map<std::string, double> times_;
};

using Function = void (*)(benchmark::State&, int);

void add(const std::string& name, Function function, int across) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    function(state, across);
  })->Unit(benchmark::kMillisecond);
}

void register_all() {
  // 12 cells across make 2,016 tetrahedra, 20 make 9,600.
  for (const auto& [size, across] : {std::pair{"composite_2k", 12}, std::pair{"composite_10k", 20}}) {
    const std::string name = std::string("step/") + size;
    add(name + "/direct", step_direct, across);
    add(name + "/eigen_ldlt", step_eigen, across);
    add(name + "/cholmod_supernodal", step_cholmod, across);
    add(std::string("assemble/") + size, assemble, across);
    add(std::string("factorise/") + size, factorise, across);
    add(std::string("solve/") + size, solve, across);
  }
  add("determinism/composite_2k_1000_steps", determinism, 12);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  register_all();
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_ratios();
  return 0;
}
