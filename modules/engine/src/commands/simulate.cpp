// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/simulate.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "glisson/core/statistics.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/geometry/mesh_io.h"

namespace glisson::engine {
namespace {

std::string step_name(int step) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "step_%05d.vtu", step);
  return name.data();
}

void write_step(const Simulate& command, const fem::CompositeModel& model, int step,
                const Points& positions) {
  TetFile file;
  file.mesh = model.mesh();
  file.point_data[std::string("displacement_") + unit_code(command.unit)] =
      (positions - file.mesh.vertices) / metres_per(command.unit);
  file.cell_data["von_mises_pa"] = model.von_mises(positions);
  file.mesh.vertices = positions;
  write_tet_mesh(command.folder / step_name(step), file, command.unit);
}

/// Writes steps on the way. @param[out] peak metres, how far anything went on it.
Cancellable<fem::SimulationResult> simulated(const Simulate& command,
                                             const std::shared_ptr<const fem::CompositeModel>& model,
                                             const RunContext& context, double& peak) {
  return fem::simulate(
      model, command.load, command.options, context,
      [&](const fem::SimulationRecord& record, const Points& positions) {
        peak = std::max(peak, record.displacement_max);
        if (record.step % std::max(1, command.every) == 0 && record.step != command.options.steps)
          write_step(command, *model, record.step, positions);
      });
}

/// @param peak metres. @pre there are records.
Figures figures_of(const fem::CompositeModel& model, const fem::SimulationResult& result, double peak) {
  Figures figures;
  const fem::SimulationRecord& last = result.records.back();
  figures["simulation_steps"] = static_cast<double>(result.records.size());
  figures["simulation_converged"] = result.termination == Termination::converged ? 1.0 : 0.0;
  figures["simulation_force_residual"] = last.force_residual;
  figures["simulation_solver_residual"] = last.solver_residual;
  figures["simulation_elastic_energy_j"] = last.elastic_energy;
  figures["simulation_kinetic_energy_j"] = last.kinetic_energy;
  figures["simulation_von_mises_max_pa"] = last.von_mises_max;
  figures["simulation_inverted_tetrahedra"] = last.inverted_tetrahedra;
  figures["simulation_beams"] = model.beam_count();
  figures["displacement_mean_mm"] = 1e3 * last.displacement_mean;
  figures["displacement_max_mm"] = 1e3 * last.displacement_max;
  std::vector<double> milliseconds;
  for (const fem::SimulationRecord& record : result.records) milliseconds.push_back(record.milliseconds);
  figures["step_p50_ms"] = upper_median(std::move(milliseconds));
  figures["displacement_peak_mm"] = 1e3 * peak;
  return figures;
}

fem::CompositeOptions materials_of(const Simulate& command, const CaseState& state) {
  fem::CompositeOptions materials = command.materials.value_or(fem::CompositeOptions());
  if (command.law) materials.law = *command.law;
  return fem::with_tissue(materials, tissue_of(state, !command.materials), state[part::model]->model.mesh);
}

std::shared_ptr<const fem::CompositeModel> model_of(const Simulate& command, const CaseState& state) {
  const PatientModel& patient = state[part::model]->model;
  return std::make_shared<const fem::CompositeModel>(patient.mesh, patient.vessels,
                                                     materials_of(command, state));
}

/// The last step, and the table of all. @pre there are records.
void write_end(const Simulate& command, const fem::CompositeModel& model,
               const fem::SimulationResult& result) {
  write_step(command, model, result.records.back().step, result.positions);
  fem::write_simulation_csv(command.folder / "steps.csv", result.records);
}

}  // namespace

CommandTraits Simulate::traits() const {
  return {.code = "simulate", .reads = {part::model, part::tissue}, .needs = {part::model}};
}

Cancellable<Applied> Simulate::apply(const CaseState& state, const RunContext& context) const {
  const auto model = model_of(*this, state);
  double peak = 0.0;
  const auto result = simulated(*this, model, context, peak);
  if (!result || result->records.empty()) return {};
  write_end(*this, *model, *result);
  Applied applied{state, figures_of(*model, *result, peak)};
  if (result->termination != Termination::converged) applied.notes.emplace_back("simulation_not_converged");
  return applied;
}

}  // namespace glisson::engine
