// SPDX-License-Identifier: GPL-3.0-or-later
// What a simulation leaves behind: meshes with displacement and stress, a table, and the case as it was.
#include <QTest>

#include <fstream>
#include <set>
#include <string>

#include "glisson/core/files.h"
#include "glisson/engine/commands/import_mesh.h"
#include "glisson/engine/commands/set_tissue.h"
#include "glisson/engine/commands/simulate.h"
#include "glisson/engine/parts/model.h"
#include "glisson/geometry/mesh_io.h"
#include "trial_patient.h"

using namespace glisson;
using namespace glisson::engine;

class SimulateTest : public QObject {
  Q_OBJECT
 private slots:
  void WrittenStepsHoldDisplacementAndVonMisesStress();
  void TheTissueIsThatOfTheCase();
  void ASolveThatEndsEarlyIsTold();
};

namespace {

/// An engine whose case is the trials' patient. Only what is simulated and said of its tissue is done.
Engine::Options patients_options() {
  Engine::Options made = options(Runner::inline_);
  made.apply = [](const CaseState& state, const Command& command, const RunContext& context,
                  const Services& services) {
    return command.as<Simulate>() != nullptr || command.as<SetTissue>() != nullptr
               ? engine::apply(state, command, context, services)
               : give_patient(state, command, context, services);
  };
  return made;
}

/// Held on the left, gravity turned.
Simulate turned(const CaseState& state, const std::filesystem::path& folder) {
  Simulate command;
  command.load.gravity_change = {0.0, 9.81, 0.0};
  command.load.fixed_nodes = fem_test::nodes_at(state[part::model]->model.mesh, 0, 0.0);
  command.folder = folder;
  return command;
}

}  // namespace

void SimulateTest::WrittenStepsHoldDisplacementAndVonMisesStress() {
  const TemporaryFolder folder;
  Engine engine(patients_options());
  engine.wait(engine.post(ImportMesh{}));
  const auto before = engine.snapshot();
  Simulate command = turned(before->state, folder.path());
  command.options.steps = 5;
  command.every = 2;
  const Outcome outcome = engine.wait(engine.post(command));
  QVERIFY2(outcome.status == Status::done, outcome.error.c_str());
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    files.insert(entry.path().filename().string());
  // Every second step, and the last.
  QVERIFY(
      (files == std::set<std::string>{"step_00002.vtu", "step_00004.vtu", "step_00005.vtu", "steps.csv"}));

  const PatientModel& model = before->state[part::model]->model;
  const fem::CompositeModel composite(model.mesh, model.vessels, {});
  double peak = 0.0;
  for (const char* name : {"step_00002.vtu", "step_00004.vtu", "step_00005.vtu"}) {
    const TetFile file = read_tet_file(folder.path() / name, LengthUnit::millimetre);
    QVERIFY(file.mesh.tetrahedra == model.mesh.tetrahedra);
    const Points moved = file.mesh.vertices - model.mesh.vertices;
    QVERIFY((file.point_data.at("displacement_mm") - 1e3 * moved).cwiseAbs().maxCoeff() < 1e-9);
    const Eigen::VectorXd stress = composite.von_mises(file.mesh.vertices);
    QVERIFY(stress.maxCoeff() > 1.0);
    QVERIFY((file.cell_data.at("von_mises_pa") - stress).cwiseAbs().maxCoeff() < 1e-6 * stress.maxCoeff());
    peak = 1e3 * moved.rowwise().norm().maxCoeff();
    QCOMPARE(name == std::string("step_00005.vtu"),
             std::abs(outcome.figures.at("displacement_max_mm") - peak) < 1e-9);
  }
  std::ifstream table(folder.path() / "steps.csv");
  std::string line;
  int lines = 0;
  while (std::getline(table, line)) ++lines;
  QCOMPARE(lines, 6);  // a header and a line a step
  QCOMPARE(engine.snapshot()->revision, before->revision);
}

void SimulateTest::TheTissueIsThatOfTheCase() {
  const TemporaryFolder folder;
  Engine engine(patients_options());
  engine.wait(engine.post(ImportMesh{}));
  Simulate command = turned(engine.snapshot()->state, folder.path());
  command.options.static_solve = true;
  const auto moved_mm = [&](const std::optional<fem::CompositeOptions>& materials) {
    command.materials = materials;
    const Outcome outcome = engine.wait(engine.post(command));
    return outcome.status == Status::done ? outcome.figures.at("displacement_mean_mm") : -1.0;
  };
  fem::CompositeOptions stiff;
  stiff.parenchyma.young_modulus = 350e3;
  const double healthy = moved_mm({}), stiffened = moved_mm(stiff);
  QVERIFY(stiffened > 0.0 && stiffened < 0.5 * healthy);
  QCOMPARE(engine.wait(engine.post(SetTissue{fem::tissue_from("parenchyma=350")})).status, Status::done);
  QCOMPARE(moved_mm({}), stiffened);
  // What the command brings of its own holds over that.
  QCOMPARE(moved_mm(fem::CompositeOptions()), healthy);
  // A law of its own does not.
  command.law = fem::TetrahedronLaw::neo_hookean;
  const double other_law = moved_mm({});
  QVERIFY(other_law > 0.0 && std::abs(other_law - stiffened) < 0.2 * stiffened);
}

void SimulateTest::ASolveThatEndsEarlyIsTold() {
  const TemporaryFolder folder;
  Engine engine(patients_options());
  engine.wait(engine.post(ImportMesh{}));
  Simulate command = turned(engine.snapshot()->state, folder.path());
  command.options.static_solve = true;
  for (const int iterations : {1, 300}) {
    command.options.max_iterations = iterations;
    const Outcome outcome = engine.wait(engine.post(command));
    QVERIFY2(outcome.status == Status::done, outcome.error.c_str());
    const bool is_at_rest = iterations > 1;
    QCOMPARE(outcome.figures.at("simulation_converged"), is_at_rest ? 1.0 : 0.0);
    QCOMPARE(outcome.notes.empty(), is_at_rest);
  }
}

QTEST_APPLESS_MAIN(SimulateTest)
#include "simulate_test.moc"
