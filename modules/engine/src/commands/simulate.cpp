// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/simulate.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "glisson/core/statistics.h"
#include "glisson/engine/parts/model.h"
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

}  // namespace

CommandTraits Simulate::traits() const {
  return {.code = "simulate", .reads = {part::model}, .needs = {part::model}};
}

Cancellable<Applied> Simulate::apply(const CaseState& state, const RunContext& context) const {
  const PatientModel& patient = state[part::model]->model;
  const auto model = std::make_shared<const fem::CompositeModel>(patient.mesh, patient.vessels, materials);
  double peak = 0.0;
  const auto result = fem::simulate(
      model, load, options, context, [&](const fem::SimulationRecord& record, const Points& positions) {
        peak = std::max(peak, record.displacement_max);
        if (record.step % std::max(1, every) == 0 && record.step != options.steps)
          write_step(*this, *model, record.step, positions);
      });
  if (!result || result->records.empty()) return {};
  const fem::SimulationRecord& last = result->records.back();
  write_step(*this, *model, last.step, result->positions);
  fem::write_simulation_csv(folder / "steps.csv", result->records);
  std::vector<double> milliseconds;
  for (const fem::SimulationRecord& record : result->records) milliseconds.push_back(record.milliseconds);
  Applied applied{state};
  applied.figures["simulation_steps"] = static_cast<double>(result->records.size());
  applied.figures["simulation_converged"] = result->converged ? 1.0 : 0.0;
  applied.figures["simulation_force_residual"] = last.force_residual;
  applied.figures["simulation_solver_residual"] = last.solver_residual;
  applied.figures["simulation_elastic_energy_j"] = last.elastic_energy;
  applied.figures["simulation_kinetic_energy_j"] = last.kinetic_energy;
  applied.figures["simulation_von_mises_max_pa"] = last.von_mises_max;
  applied.figures["simulation_inverted_tetrahedra"] = last.inverted_tetrahedra;
  applied.figures["simulation_beams"] = model->beam_count();
  applied.figures["displacement_mean_mm"] = 1e3 * last.displacement_mean;
  applied.figures["displacement_max_mm"] = 1e3 * last.displacement_max;
  applied.figures["displacement_peak_mm"] = 1e3 * peak;
  applied.figures["step_p50_ms"] = upper_median(std::move(milliseconds));
  if (!result->converged) applied.notes.emplace_back("simulation_not_converged");
  return applied;
}

}  // namespace glisson::engine
