// SPDX-License-Identifier: GPL-3.0-or-later
// One implicit step of the composite liver (tetrahedra, capsule, 100 to 400 beams) at 2,000 to 100,000
// tetrahedra, by each of our solvers and by what a user would run instead: Eigen's SimplicialLDLT and
// CHOLMOD's supernodal factorisation, in the same run, fed by our assembly so that only the solver differs.
// One thread. The ratios are what holds on another machine. The meshes are the synthetic patient's;
// --ellipsoid takes regular ones, which need no meshing time; --quick leaves out what takes minutes (Eigen
// above 50,000).
#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "block_matrix.h"
#include "ellipsoid_mesh.h"
#include "factorization.h"
#include "glisson/fem/integrator.h"
#include "glisson/insilico/patient.h"
#include "glisson/model/build.h"

namespace {

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

struct Size {
  const char* name;
  int across;    ///< of the ellipsoid
  int vertices;  ///< of the patient's mesh
  int beams;
};
constexpr Size kSizes[] = {
    {"2k", 12, 540, 100}, {"10k", 20, 2300, 140}, {"50k", 35, 10300, 240}, {"100k", 44, 20300, 400}};

bool& regular_meshes() {
  static bool regular = false;
  return regular;
}

/// The trees as beams of about 6 mm, the thickest of them: what the model module's fit comes to.
std::vector<VesselTree> coarse_trees(const std::vector<VesselTree>& trees, int wanted) {
  std::vector<VesselTree> result;
  std::vector<std::pair<double, std::pair<std::size_t, int>>> by_radius;
  for (const VesselTree& tree : trees) {
    std::vector<std::vector<int>> next(static_cast<std::size_t>(tree.nodes.rows()));
    for (const auto& beam : tree.beams) {
      next[static_cast<std::size_t>(beam[0])].push_back(beam[1]);
      next[static_cast<std::size_t>(beam[1])].push_back(beam[0]);
    }
    VesselTree coarse = tree;
    coarse.beams.clear();
    std::vector<std::array<int, 3>> open{{std::max(0, tree.root), -1, std::max(0, tree.root)}};
    while (!open.empty()) {  // node, where from, last node kept
      auto [node, from, kept] = open.back();
      open.pop_back();
      const auto& around = next[static_cast<std::size_t>(node)];
      if (node != kept &&
          (around.size() != 2 || (tree.nodes.row(node) - tree.nodes.row(kept)).norm() > 0.006)) {
        coarse.beams.push_back({kept, node});
        by_radius.push_back({-0.5 * (tree.radii[kept] + tree.radii[node]),
                             {result.size(), static_cast<int>(coarse.beams.size()) - 1}});
        kept = node;
      }
      for (const int j : around)
        if (j != from) open.push_back({j, node, kept});
    }
    result.push_back(std::move(coarse));
  }
  std::sort(by_radius.begin(), by_radius.end());
  by_radius.resize(std::min(by_radius.size(), static_cast<std::size_t>(wanted)));
  std::vector<std::vector<std::array<int, 2>>> chosen(result.size());
  for (const auto& [radius, where] : by_radius)
    chosen[where.first].push_back({result[where.first].beams[static_cast<std::size_t>(where.second)][0],
                                   result[where.first].beams[static_cast<std::size_t>(where.second)][1]});
  for (std::size_t t = 0; t < result.size(); ++t) result[t].beams.assign(chosen[t].begin(), chosen[t].end());
  return result;
}

std::shared_ptr<const CompositeModel> make_model(const Size& size) {
  if (regular_meshes())
    return std::make_shared<CompositeModel>(ellipsoid_mesh(size.across), ellipsoid_vessels(size.beams),
                                            CompositeOptions{});
  static const auto patient = insilico::make_patient({}, RunContext());
  model::SurfaceSet surfaces;
  for (const NamedSurface& surface : patient->surfaces) {
    if (surface.structure == structure::kParenchyma)
      surfaces.liver = surface.mesh;
    else
      surfaces.others.push_back(surface);
  }
  model::ModelOptions options;
  options.mesh.target_vertices = size.vertices;
  options.vessels = false;
  const auto built = model::build_from_surfaces(surfaces, options, RunContext());
  return std::make_shared<CompositeModel>(built->model.mesh, coarse_trees(patient->trees, size.beams),
                                          CompositeOptions{});
}

/// Whole steps: the organ falls, turns and swings, held by springs at one end.
class Motion {
 public:
  explicit Motion(const CompositeModel& model) {
    const Points& rest = model.mesh().vertices;
    const double left = rest.col(0).minCoeff();
    for (int i = 0; i < rest.rows(); ++i)
      if (rest(i, 0) < left + 0.03) {
        AttachedLoad spring;
        spring.nodes[0] = i;
        spring.weights[0] = 1.0;
        spring.tangent = 20.0 * Eigen::Matrix3d::Identity();
        springs_.push_back(spring);
        anchors_.push_back(rest.row(i).transpose());
      }
  }
  Loads at(int n, const Points& x) {
    Loads loads;
    loads.gravity_change = 3.0 * Eigen::Vector3d(std::sin(0.1 * n), std::cos(0.07 * n), 0.5);
    loads.attached = springs_;
    for (std::size_t k = 0; k < springs_.size(); ++k)
      loads.attached[k].force = springs_[k].tangent * (anchors_[k] - x.row(springs_[k].nodes[0]).transpose());
    return loads;
  }

 private:
  std::vector<AttachedLoad> springs_;
  std::vector<Eigen::Vector3d> anchors_;
};

/// A patient of a size, and the matrix of a step from a state that comes up in a motion.
struct Case {
  std::shared_ptr<const CompositeModel> model;
  BlockSystem system;
  Points x, force;
  Eigen::VectorXd right;

  explicit Case(const Size& size) : model(make_model(size)), system(model->impl(), {}), x(moved(model)) {
    assemble();
  }
  static Points moved(const std::shared_ptr<const CompositeModel>& model) {
    IntegratorOptions options;
    options.solver = LinearSolver::fast;
    Integrator integrator(model, options);
    Motion motion(*model);
    for (int n = 0; n < 10; ++n) integrator.step(motion.at(n, integrator.positions()));
    return integrator.positions();
  }
  void assemble() {
    system.assemble(x, 6.0, Tangent::rotated, force);
    system.add_diagonal(model->lumped_mass(), 2505.0);
    right = system.gather(force);
  }
};

Case& example(const Size& size) {
  static std::map<std::string, Case> cases;
  return cases.try_emplace(size.name, size).first->second;
}

void describe(benchmark::State& state, const Case& c) {
  state.counters["tets"] = c.model->mesh().tetrahedron_count();
  state.counters["unknowns"] = 3.0 * c.model->node_count();
  state.counters["beams"] = c.model->beam_count();
}

void step(benchmark::State& state, const Size& size, LinearSolver solver, double tolerance, int threads = 1) {
  Case& c = example(size);
  IntegratorOptions options;
  options.solver = solver;
  options.tolerance = tolerance;
  options.threads = threads;
  Integrator integrator(c.model, options);
  Motion motion(*c.model);
  double residual = 0.0, iterations = 0.0;
  int n = 0;
  std::vector<double> times;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    const StepSummary summary = integrator.step(motion.at(n++, integrator.positions()));
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    if (!summary.ok) state.SkipWithError("a step failed");
    residual = std::max(residual, summary.residual);
    iterations = std::max(iterations, static_cast<double>(summary.iterations));
  }
  describe(state, c);
  state.counters["residual"] = residual;
  std::sort(times.begin(), times.end());
  state.counters["p99_wall_ms"] =
      times[(times.size() * 99) / 100 == times.size() ? times.size() - 1 : (times.size() * 99) / 100];
  if (iterations > 0.0) state.counters["iterations"] = iterations;
}

/// Eigen's analysis is done once, too; our assembly feeds it, so that only the solver differs.
void step_eigen(benchmark::State& state, const Size& size) {
  Case& c = example(size);
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

void assemble(benchmark::State& state, const Size& size) {
  Case& c = example(size);
  for (auto _ : state) c.assemble();
  describe(state, c);
}

void factorise(benchmark::State& state, const Size& size) {
  Case& c = example(size);
  const auto solver = make_factorization(LinearSolver::direct, c.system.pattern());
  for (auto _ : state)
    if (!solver->factorise(c.system.values())) state.SkipWithError("not positive definite");
  describe(state, c);
}

void solve(benchmark::State& state, const Size& size) {
  Case& c = example(size);
  const auto solver = make_factorization(LinearSolver::direct, c.system.pattern());
  solver->factorise(c.system.values());
  Eigen::VectorXd x;
  for (auto _ : state) {
    x = c.right;
    solver->solve(x);
  }
  describe(state, c);
}

Points after_1000_steps(const Case& c, LinearSolver solver, int threads) {
  IntegratorOptions options;
  options.solver = solver;
  options.threads = threads;
  Integrator integrator(c.model, options);
  Motion motion(*c.model);
  for (int n = 0; n < 1000; ++n) integrator.step(motion.at(n, integrator.positions()));
  return integrator.positions();
}

/// By one thread and by two: 1 when every bit of both ends is the same.
void determinism_of_threads(benchmark::State& state, const Size& size) {
  const Case& c = example(size);
  bool same = true;
  for (auto _ : state)
    same = same && (after_1000_steps(c, LinearSolver::direct, 1).array() ==
                    after_1000_steps(c, LinearSolver::direct, 2).array())
                       .all();
  state.counters["same_bits"] = same ? 1.0 : 0.0;
}

/// Twice from the same start, the second time beside another thread that does the same: 1 when
/// every bit of all three ends is the same.
void determinism(benchmark::State& state, const Size& size, LinearSolver solver) {
  Case& c = example(size);
  const auto run = [&] { return after_1000_steps(c, solver, 1); };
  bool same = true;
  for (auto _ : state) {
    const Points alone = run();
    Points beside;
    std::thread other([&] { beside = run(); });
    const Points meanwhile = run();
    other.join();
    same = same && (alone.array() == beside.array()).all() && (alone.array() == meanwhile.array()).all();
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
      if (run.iterations > 0 && !run.error_occurred) {
        times_[run.benchmark_name()] = run.GetAdjustedCPUTime();
        wall_[run.benchmark_name()] = run.GetAdjustedRealTime();
      }
  }
  /// The rows of the table: milliseconds of one thread, and how much faster ours are than the peers.
  void print_table() const {
    std::printf("\n%-16s %10s %10s %10s %10s %12s %12s %12s %12s\n", "step", "direct", "fast 1e-6",
                "fast 1e-3", "assemble", "Eigen LDLT", "CHOLMOD", "x Eigen", "x CHOLMOD");
    for (const Size& size : kSizes) {
      const std::string base = std::string("step/composite_") + size.name;
      const double ours = time(times_, base + "/direct"), eigen = time(times_, base + "/eigen_ldlt"),
                   cholmod = time(times_, base + "/cholmod_supernodal");
      std::printf("composite_%-6s %10.2f %10.2f %10.2f %10.2f %12.2f %12.2f %12.1f %12.1f\n", size.name, ours,
                  time(times_, base + "/fast_1e-6"), time(times_, base + "/fast_1e-3"),
                  time(times_, std::string("assemble/composite_") + size.name), eigen, cholmod, eigen / ours,
                  cholmod / ours);
    }
    std::printf("milliseconds of processor time, one thread; nan: not run\n");
    std::printf("\n%-16s %14s %14s %10s\n", "direct, wall", "one thread", "two threads", "x");
    for (const Size& size : kSizes) {
      const std::string base = std::string("step/composite_") + size.name;
      const double one = time(wall_, base + "/direct"), two = time(wall_, base + "/direct_2_threads");
      std::printf("composite_%-6s %14.2f %14.2f %10.2f\n", size.name, one, two, one / two);
    }
  }

 private:
  using Times = std::map<std::string, double>;
  static double time(const Times& times, const std::string& name) {
    for (const auto& [key, value] : times)
      if (key == name || key.starts_with(name + "/")) return value;
    return std::numeric_limits<double>::quiet_NaN();
  }
  Times times_, wall_;
};

template <class Function>
benchmark::internal::Benchmark* add(const std::string& name, const Function& function) {
  return benchmark::RegisterBenchmark(name.c_str(), function)->Unit(benchmark::kMillisecond);
}

void register_all(bool quick) {
  for (const Size& size : kSizes) {
    const bool large = size.vertices > 5000;
    const std::string name = std::string("composite_") + size.name;
    const auto by = [&size](LinearSolver solver, double tolerance) {
      return [&size, solver, tolerance](benchmark::State& state) { step(state, size, solver, tolerance); };
    };
    add("step/" + name + "/direct", by(LinearSolver::direct, 1e-6));
    add("step/" + name + "/direct_2_threads", [&size](benchmark::State& state) {
      step(state, size, LinearSolver::direct, 1e-6, 2);
    })->UseRealTime();
    add("step/" + name + "/fast_1e-6", by(LinearSolver::fast, 1e-6));
    add("step/" + name + "/fast_1e-3", by(LinearSolver::fast, 1e-3));
    add("step/" + name + "/cholmod_supernodal", by(LinearSolver::reference, 1e-6));
    if (!quick || !large) {
      auto* eigen =
          add("step/" + name + "/eigen_ldlt", [&size](benchmark::State& state) { step_eigen(state, size); });
      if (large) eigen->Iterations(1);  // a quarter of a minute each, and more
    }
    add("assemble/" + name, [&size](benchmark::State& state) { assemble(state, size); });
    add("factorise/" + name, [&size](benchmark::State& state) { factorise(state, size); });
    add("solve/" + name, [&size](benchmark::State& state) { solve(state, size); });
  }
  for (const auto& [name, solver] :
       {std::pair{"direct", LinearSolver::direct}, std::pair{"fast", LinearSolver::fast}})
    add(std::string("determinism/composite_2k_1000_steps/") + name, [solver =
                                                                         solver](benchmark::State& state) {
      determinism(state, kSizes[0], solver);
    })->Iterations(1);
  add("determinism/composite_10k_1000_steps/direct_1_and_2_threads", [](benchmark::State& state) {
    determinism_of_threads(state, kSizes[1]);
  })->Iterations(1);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  bool quick = false;
  for (int k = 1; k < argc; ++k) {
    if (std::strcmp(argv[k], "--quick") == 0) quick = true;
    if (std::strcmp(argv[k], "--ellipsoid") == 0) regular_meshes() = true;
  }
  register_all(quick);
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_table();
  return 0;
}
