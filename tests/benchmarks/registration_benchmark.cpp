// SPDX-License-Identifier: GPL-3.0-or-later
// A registration step by step on the phantom (about 1,000 nodes, 3,700 tetrahedra, 120 modes): rigid start,
// simulated operations, most probable shape, forces, springs, error model, findings, looks, and the whole;
// and what its elastic body does once a stage, a factorisation and a solve for 96 columns, beside what a user
// would run instead on the same matrix: Eigen's SimplicialLDLT and CHOLMOD's supernodal factorisation. One
// thread. The ratios (counters "share" over the whole, "over_eigen", "over_cholmod") are what holds on
// another machine.
#include <benchmark/benchmark.h>

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCholesky>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "elastic.h"
#include "examine.h"
#include "fit_contact_forces.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/next_look.h"
#include "glisson/registration/register_model.h"
#include "lying_phantom.h"
#include "rigid.h"
#include "shape_fits.h"

namespace {

using namespace glisson;
using namespace glisson::registration;

constexpr int kColumns = 96;

RunContext quiet() { return RunContext({}, {}, 1); }

/// What the steps take over from one another.
struct Case {
  PatientModel model = phantom::lying(14, 11, 4);
  LabelledCloud cloud;
  RegisterOptions options;
  std::shared_ptr<const OperationPrior> prior;
  std::optional<ShapeFits> shapes;
  std::optional<ExaminedRegistration> made;
  double whole = 0.0;  ///< seconds

  Case() {
    model.mesh.labels[200] = structure::kFirstLesion;
    options.threads = 1;
    options.operation.gravity = 1.4;
    options.operation.gas_pa = 120.0;
    options.operation.bed_m = 0.009;
    options.operation.threads = options.rigid.threads = options.forces.threads = 1;
    prior = std::make_shared<const OperationPrior>(
        simulate_operations(model, options.operation, quiet()).value());
    Eigen::VectorXd amplitudes = Eigen::VectorXd::Zero(prior->modes.cols());
    amplitudes.head<3>() << 1.2, -0.9, 0.8;
    cloud =
        phantom::patch(model, phantom::lying_view().apply(prior->shape(model.mesh.vertices, amplitudes)), {});
    shapes = fit(quiet());
    whole = seconds([this] { made = register_model(model, cloud, options, quiet()); });
  }
  Cancellable<ShapeFits> fit(const RunContext& context) const {
    ShapeFitOptions alone;
    alone.threads = 1;
    return fit_shapes(model, *prior, cloud, starts_of(phantom::lying_view(), {}), alone, context);
  }
  const Registration& registration() const { return made->registered.registration; }

  static double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
};

Case& example() {
  static Case one;
  return one;
}

/// Times the work; "share" is its time over that of the whole registration.
void run(benchmark::State& state, const std::function<void(Case&)>& work) {
  Case& c = example();
  double spent = 0.0;
  for (auto _ : state) spent += Case::seconds([&] { work(c); });
  state.counters["share"] = spent / static_cast<double>(state.iterations()) / c.whole;
  state.counters["nodes"] = c.model.mesh.vertex_count();
  state.counters["points"] = c.cloud.size();
}

ErrorModel error_of(const Case& c) {
  ErrorModelOptions known;
  known.unforeseen = 0.0;  // the prior knows of them
  return ErrorModel(c.model, c.prior.get(), c.shapes->best().amplitudes, c.shapes->best().camera_from_ct,
                    c.shapes->best().nodes_in_camera, prepare_cloud(c.cloud, {3.9, 600, 30}), 1e-3, known);
}

void add_steps() {
  const auto add = [](const char* name, std::function<void(Case&)> work) {
    benchmark::RegisterBenchmark(name, [work = std::move(work)](benchmark::State& state) {
      run(state, work);
    })->Unit(benchmark::kMillisecond);
  };
  add("rigid_start", [](Case& c) { align_rigid(c.model, c.cloud, c.options.rigid, quiet()); });
  add("operations", [](Case& c) { simulate_operations(c.model, c.options.operation, quiet()); });
  add("shape", [](Case& c) { c.fit(quiet()); });
  add("forces", [](Case& c) {
    ContactForceOptions options = c.options.forces;
    options.prior = c.prior;
    options.amplitudes = c.shapes->best().amplitudes;
    options.patch_reach = 40e-3, options.patch_spacing = 20e-3, options.patch_radius = 30e-3;
    options.patch_price = 1.0;
    options.information = 0.2;
    options.sigmas.assign(3, 3e-3);
    fit_contact_forces(c.model, c.cloud, c.shapes->best().camera_from_ct, options, quiet());
  });
  add("springs", [](Case& c) {
    ElasticOptions options;
    options.prior = c.prior;
    register_elastic(c.model, c.cloud, *c.shapes, options, quiet());
  });
  add("error_model", [](Case& c) { benchmark::DoNotOptimize(error_of(c).expected()); });
  add("findings", [](Case& c) {
    benchmark::DoNotOptimize(examine({c.model, c.cloud, c.registration(), &*c.shapes, *c.made->error}));
  });
  add("looks", [](Case& c) {
    benchmark::DoNotOptimize(looks_of(c.model, c.cloud, c.registration(), *c.made->error));
  });
  add("whole", [](Case& c) { register_model(c.model, c.cloud, c.options, quiet()); });
  add("whole_operations_known", [](Case& c) {
    register_model(c.model, c.cloud, c.options, quiet(), {c.options.operation, c.prior});
  });
}

/// The elastic body's matrix at rest, on springs to the ground.
struct Body {
  fem::ElasticBody body;
  Eigen::VectorXd springs;
  Eigen::SparseMatrix<double> matrix;
  fem::NodalColumns right;

  explicit Body(const Case& c) : body(c.model.mesh, {}) {
    body.set_material({fem::BodyLaw::neo_hookean, 0.45});
    springs = 5.0 * body.node_volumes();
    Eigen::MatrixXd dense = body.hessian(body.rest(), true);
    for (Eigen::Index i = 0; i < dense.rows(); ++i) dense(i, i) += springs[i / 3];
    matrix = dense.sparseView();
    right = fem::NodalColumns::Random(dense.rows(), kColumns);
  }
};

Body& example_body() {
  static Body one(example());
  return one;
}

template <class Solver>
double by(const Body& b) {
  Solver solver;
  solver.analyzePattern(b.matrix);  // once for a body, as ours
  return Case::seconds([&] {
    solver.factorize(b.matrix);
    benchmark::DoNotOptimize(Eigen::MatrixXd(solver.solve(Eigen::MatrixXd(b.right))));
  });
}

void factorise(benchmark::State& state) {
  Body& b = example_body();
  double spent = 0.0;
  for (auto _ : state)
    spent += Case::seconds([&] {
      fem::NodalColumns columns = b.right;
      b.body.factorise(b.body.rest(), b.springs);
      b.body.solve(columns);
      benchmark::DoNotOptimize(columns);
    });
  const double ours = spent / static_cast<double>(state.iterations());
  state.counters["unknowns"] = static_cast<double>(b.matrix.rows());
  state.counters["over_eigen"] = ours / by<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(b);
  state.counters["over_cholmod"] = ours / by<Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>>>(b);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  add_steps();
  benchmark::RegisterBenchmark("factorise_and_solve_96_columns", factorise)->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
