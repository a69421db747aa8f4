// SPDX-License-Identifier: GPL-3.0-or-later
// The time of each stage from labels to a model, on the in-silico patient (voxels of 1.5 x 1.5 x 2 mm).
#include <benchmark/benchmark.h>

#include "anatomy.h"
#include "fit_to_surface.h"
#include "glisson/geometry/distance.h"
#include "glisson/insilico/patient.h"
#include "glisson/model/quality.h"
#include "mesh_to_size.h"
#include "vessels.h"

namespace {

using namespace glisson;

const insilico::SyntheticPatient& patient() {
  static const insilico::SyntheticPatient kPatient = *insilico::make_patient({}, RunContext());
  return kPatient;
}

const model::Anatomy& anatomy() {
  static const model::Anatomy kAnatomy = *model::anatomy_of(patient().truth, {}, RunContext());
  return kAnatomy;
}

model::MesherInput mesher_input() {
  model::MesherInput input;
  input.body = anatomy().liver;
  input.body_label = structure::kParenchyma;
  input.inclusions = anatomy().lesions;
  return input;
}

model::MeshOptions of_vertices(long count) {
  model::MeshOptions options;
  options.target_vertices = static_cast<int>(count);
  return options;
}

TetMesh meshed(long vertices) {
  std::vector<std::string> notes;
  return *model::mesh_to_size(mesher_input(), of_vertices(vertices), notes, RunContext());
}

void labels_to_fields_and_surfaces(benchmark::State& state) {
  patient();
  for (auto _ : state) benchmark::DoNotOptimize(model::anatomy_of(patient().truth, {}, RunContext()));
}
BENCHMARK(labels_to_fields_and_surfaces)->Unit(benchmark::kMillisecond);

void tetrahedra(benchmark::State& state) {
  anatomy();
  for (auto _ : state) benchmark::DoNotOptimize(meshed(state.range(0)));
}
BENCHMARK(tetrahedra)->Arg(550)->Arg(2300)->Unit(benchmark::kMillisecond);

void fit_of_the_mesh(benchmark::State& state) {
  const TetMesh mesh = meshed(state.range(0));
  model::FitTargets targets{&anatomy().fine_liver, anatomy().liver_volume, {}};
  for (const auto& [label, field] : anatomy().lesions) targets.inclusions.push_back({label, field.volume()});
  for (auto _ : state) {
    TetMesh fitted = mesh;
    model::fit_to_surface(fitted, targets, model::kLeastDihedral, RunContext());
    benchmark::DoNotOptimize(fitted);
  }
}
BENCHMARK(fit_of_the_mesh)->Arg(550)->Arg(2300)->Unit(benchmark::kMillisecond);

void vessel_skeletons_and_beams(benchmark::State& state) {
  anatomy();
  for (auto _ : state) {
    std::vector<std::string> notes;
    benchmark::DoNotOptimize(model::vessel_trees(anatomy(), {}, notes, RunContext()));
  }
}
BENCHMARK(vessel_skeletons_and_beams)->Unit(benchmark::kMillisecond);

void anterior_margin(benchmark::State& state) {
  anatomy();
  for (auto _ : state)
    benchmark::DoNotOptimize(model::detect_anterior_margin(anatomy().fine_liver, {0.0, -1.0, -1.0}));
}
BENCHMARK(anterior_margin)->Unit(benchmark::kMillisecond);

void quality_of_the_mesh(benchmark::State& state) {
  const BoundarySurface boundary = boundary_surface(meshed(550));
  for (auto _ : state) benchmark::DoNotOptimize(surface_distance(boundary.mesh, anatomy().fine_liver));
}
BENCHMARK(quality_of_the_mesh)->Unit(benchmark::kMillisecond);

void labels_to_model(benchmark::State& state) {
  patient();
  for (auto _ : state) benchmark::DoNotOptimize(model::build_from_labels(patient().truth, {}, RunContext()));
}
BENCHMARK(labels_to_model)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
