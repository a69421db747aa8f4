// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <memory>

#include "block_mesh.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/fem/loads_io.h"
#include "glisson/fem/materials.h"
#include "glisson/fem/simulate.h"
#include "glisson/geometry/mesh_io.h"
#include "stiffness.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

std::shared_ptr<const CompositeModel> bar() {
  CompositeOptions options = composite_preset("healthy_homogeneous");
  return std::make_shared<CompositeModel>(block_mesh({5, 2, 2}, {0.05, 0.02, 0.02}),
                                          std::vector<VesselTree>{}, options);
}

LoadCase parsed(const char* text) { return parse_load_case(text, "test.json"); }

}  // namespace

class LoadsTest : public QObject {
  Q_OBJECT
 private slots:
  void GravityTurnsFromSupineToFlank() {
    const LoadCase load = parsed(R"({"gravity": {"to": "left_flank"}})");
    // Supine pulls to the back (+y in LPS), the left flank down to the left (+x).
    QVERIFY((load.gravity_change - Eigen::Vector3d(9.81, -9.81, 0.0)).norm() < 1e-12);
    const LoadCase same = parsed(R"({"gravity": {"from": [0, 9.81, 0], "to": [9.81, 0, 0]}})");
    QVERIFY((load.gravity_change - same.gravity_change).norm() < 1e-12);
  }

  void EveryKeyArrivesInMetres() {
    const LoadCase load = parsed(R"({
      "pressure": {"pascal": 1600, "region": {"normal": [0, -2, 0], "angle_deg": 60}},
      "forces": [{"point_mm": [50, 10, 10], "newton": [0, 0, 0.5]}],
      "springs": [{"node": 3, "newton_per_metre": 50, "target_mm": [1, 2, 3]},
                  {"region": {"centre_mm": [50, 10, 10], "radius_mm": 12},
                   "structure": {"pascal": 20e6, "area_mm2": 2, "length_mm": 40}}],
      "fixed": {"nodes": [6], "region": {"low_mm": [-1, -1, -1], "high_mm": [1, 30, 30]}},
      "ramp_s": 0.5})");
    QCOMPARE(load.pressure, 1600.0);
    QVERIFY((*load.pressure_region->normal - Eigen::Vector3d(0, -1, 0)).norm() < 1e-12);
    QVERIFY((*load.forces[0].place.point - Eigen::Vector3d(0.05, 0.01, 0.01)).norm() < 1e-12);
    QVERIFY((*load.springs[0].target - Eigen::Vector3d(1e-3, 2e-3, 3e-3)).norm() < 1e-12);
    QVERIFY(std::abs(load.springs[1].stiffness - 20e6 * 2e-6 / 0.04) < 1e-9);
    const auto model = bar();
    const AppliedLoad applied(load, *model);
    QCOMPARE(applied.fixed_nodes(), nodes_at(model->mesh(), 0, 0.0));
    const Loads whole = applied.at(model->mesh().vertices);
    // The face y = 0 of five by two cells, two triangles each.
    QCOMPARE(whole.pressure_triangles.size(), std::size_t{20});
    double stiffness = 0.0;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (std::size_t k = 1; k < whole.attached.size(); ++k) stiffness += whole.attached[k].tangent(0, 0);
    for (const AttachedLoad& a : whole.attached)
      if (a.tangent.isZero(0.0)) force += a.force;
    QVERIFY(std::abs(stiffness - 1000.0) < 1e-9);
    QVERIFY((force - Eigen::Vector3d(0, 0, 0.5)).norm() < 1e-12);
    QCOMPARE(applied.at(model->mesh().vertices, 0.25).pressure, 800.0);
  }

  void ATriangleThatIsNamedTwiceBearsItsPressureOnce() {
    const auto model = bar();
    const auto pressed = [&](const char* text) {
      return AppliedLoad(parsed(text), *model).at(model->mesh().vertices).pressure_triangles;
    };
    QCOMPARE(pressed(R"({"pressure": {"pascal": 1, "triangles": [3, 1, 3, 3]}})"), (std::vector{3, 1}));
    QCOMPARE(pressed(R"({"pressure": {"pascal": 1, "triangles": [3, 1]}})"), (std::vector{3, 1}));
  }

  void MalformedFilesAreRefused_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("field");
    QTest::newRow("not JSON") << "{"
                              << "";
    QTest::newRow("nothing in it") << "{}"
                                   << "";
    QTest::newRow("not an object") << "[1]"
                                   << "";
    QTest::newRow("misspelt key") << R"({"gravty": {"to": "prone"}})"
                                  << "gravty";
    QTest::newRow("unknown posture") << R"({"gravity": {"to": "upside_down"}})"
                                     << "gravity.to";
    QTest::newRow("two numbers") << R"({"gravity": {"change": [0, 1]}})"
                                 << "gravity.change";
    QTest::newRow("both ways") << R"({"gravity": {"change": [0, 1, 0], "to": "prone"}})"
                               << "gravity.change";
    QTest::newRow("text for pressure") << R"({"pressure": {"pascal": "high"}})"
                                       << "pressure.pascal";
    QTest::newRow("absurd force") << R"({"forces": [{"node": 0, "newton": [0, 1e300, 0]}]})"
                                  << "forces[0].newton";
    QTest::newRow("absurd gravity") << R"({"gravity": {"change": [0, 1e20, 0]}})"
                                    << "gravity.change";
    QTest::newRow("absurd place") << R"({"forces": [{"point_mm": [0, 0, 1e300], "newton": [0, 1, 0]}]})"
                                  << "forces[0].point_mm";
    QTest::newRow("absurd move") << R"({"moved": [{"nodes": [0], "by_mm": [-1e9, 0, 0]}]})"
                                 << "moved[0].by_mm";
    QTest::newRow("absurd spring") << R"({"springs": [{"node": 0, "newton_per_metre": 1e300}]})"
                                   << "springs[0].newton_per_metre";
    QTest::newRow("a ramp without end") << R"({"gravity": {"to": "prone"}, "ramp_s": 1e300})"
                                        << "ramp_s";
    QTest::newRow("absurd pressure") << R"({"pressure": {"pascal": 1e9}})"
                                     << "pressure.pascal";
    QTest::newRow("no place") << R"({"forces": [{"newton": [0, 0, 1]}]})"
                              << "forces[0]";
    QTest::newRow("negative node") << R"({"forces": [{"node": -1, "newton": [0, 0, 1]}]})"
                                   << "forces[0].node";
    QTest::newRow("no stiffness") << R"({"springs": [{"node": 1}]})"
                                  << "springs[0].newton_per_metre";
    QTest::newRow("slack spring") << R"({"springs": [{"node": 1, "newton_per_metre": 0}]})"
                                  << "springs[0].newton_per_metre";
    QTest::newRow("region of nothing") << R"({"pressure": {"pascal": 1, "region": {}}})"
                                       << "pressure.region";
    QTest::newRow("box inside out")
        << R"({"pressure": {"pascal": 1, "region": {"low_mm": [1, 0, 0], "high_mm": [0, 1, 1]}}})"
        << "pressure.region.low_mm";
    QTest::newRow("nothing moved") << R"({"moved": [{"by_mm": [1, 0, 0]}]})"
                                   << "moved[0]";
    QTest::newRow("moved nowhere") << R"({"moved": [{"nodes": [1]}]})"
                                   << "moved[0].by_mm";
    QTest::newRow("node beyond any mesh") << R"({"forces": [{"node": 4294967297, "newton": [0, 0, 1]}]})"
                                          << "forces[0].node";
    QTest::newRow("angle beyond all directions")
        << R"({"pressure": {"pascal": 1, "region": {"normal": [0, 0, 1], "angle_deg": 270}}})"
        << "pressure.region.angle_deg";
    QTest::newRow("two ramps") << R"({"gravity": {"to": "prone"}, "ramp_s": 1, "ramp_s": 2})"
                               << "\"ramp_s\"";
    QTest::newRow("negative ramp") << R"({"gravity": {"to": "prone"}, "ramp_s": -1})"
                                   << "ramp_s";
  }
  void MalformedFilesAreRefused() {
    QFETCH(QString, text);
    QFETCH(QString, field);
    try {
      parse_load_case(text.toStdString(), "test.json");
      QFAIL("accepted");
    } catch (const InputError& error) {
      QCOMPARE(QString::fromStdString(error.field()), field);
      QCOMPARE(QString::fromStdString(error.file()), QString("test.json"));
      QVERIFY(!error.remedy().empty());
    }
  }

  void LoadsThatTheMeshDoesNotHaveAreRefused() {
    const auto model = bar();
    for (const char* text : {R"({"forces": [{"node": 100000, "newton": [0, 0, 1]}]})",
                             R"({"pressure": {"pascal": 1, "triangles": [100000]}})",
                             R"({"gravity": {"to": "prone"}, "fixed": {"nodes": [100000]}})",
                             R"({"moved": [{"nodes": [100000], "by_mm": [1, 0, 0]}]})",
                             R"({"fixed": {"nodes": [5]}, "moved": [{"nodes": [5], "by_mm": [1, 0, 0]}]})",
                             R"({"gravity": {"to": "prone"},
                                 "fixed": {"region": {"centre_mm": [900, 0, 0], "radius_mm": 1}}})"})
      QVERIFY_THROWS_EXCEPTION(InputError, AppliedLoad(parsed(text), *model));
  }

  void ExamplesAreWhatTheReadmeSays() {
    const QString folder = qEnvironmentVariable("GLISSON_SOURCE_DIR") + "/resources/loads";
    QVERIFY(!folder.isEmpty());
    const std::filesystem::path path = folder.toStdString();
    const LoadCase flank = read_load_case(path / "supine_to_left_flank.json");
    QVERIFY((flank.gravity_change - Eigen::Vector3d(9.81, -9.81, 0.0)).norm() < 1e-12);
    QCOMPARE(flank.springs.size(), std::size_t{4});
    const LoadCase gas = read_load_case(path / "pneumoperitoneum.json");
    QVERIFY(gas.pressure > 0.0 && gas.pressure <= 1600.0);
    QVERIFY(gas.pressure_region->normal->y() < -0.99);  // forward
    const LoadCase pull = read_load_case(path / "ligament_pull.json");
    QVERIFY(std::abs(pull.forces.at(0).force.norm() - 5.0) < 1e-12);
    QVERIFY(pull.springs.size() == 2 && pull.ramp == 1.0);
  }

  void MissingFileIsNamed() { QVERIFY_THROWS_EXCEPTION(FileError, read_load_case("/nowhere/load.json")); }

  void StaticSimulationBalancesAForceByTheBarsStiffness() {
    // A bar of 50 x 20 x 20 mm pulled along by 0.01 N: about F L / (E A) longer, a little less as its held
    // end cannot narrow.
    const auto model = bar();
    const LoadCase load = parsed(R"({
      "forces": [{"region": {"low_mm": [49.9, -1, -1], "high_mm": [51, 21, 21]}, "newton": [0.01, 0, 0]}],
      "fixed": {"region": {"low_mm": [-1, -1, -1], "high_mm": [0.1, 21, 21]}}})");
    SimulationOptions options;
    options.static_solve = true;
    const auto result = simulate(model, load, options, RunContext());
    QVERIFY(result && result->termination == Termination::converged);
    QVERIFY(result->records.front().force_residual < 1e-8);
    const double expected = 0.01 * 0.05 / (3500.0 * 0.02 * 0.02);
    double moved = 0.0;
    const std::vector<int> end = nodes_at(model->mesh(), 0, 0.05);
    for (const int node : end) moved += (result->positions(node, 0) - 0.05) / static_cast<double>(end.size());
    QVERIFY2(moved > 0.85 * expected && moved < 1.02 * expected,
             qPrintable(QString::number(moved / expected)));
  }

  void MovedNodesStretchTheBar() {
    // Led 1 mm apart and back in line with the bar's stiffness: statically at once, dynamically by a ramp.
    const auto model = bar();
    const LoadCase load = parsed(R"({
      "moved": [{"region": {"low_mm": [49.9, -1, -1], "high_mm": [51, 21, 21]}, "by_mm": [1, 0, 0]}],
      "fixed": {"region": {"low_mm": [-1, -1, -1], "high_mm": [0.1, 21, 21]}}, "ramp_s": 0.2})");
    const std::vector<int> end = nodes_at(model->mesh(), 0, 0.05);
    SimulationOptions options;
    options.static_solve = true;
    const auto at_once = simulate(model, load, options, RunContext());
    QVERIFY(at_once && at_once->termination == Termination::converged);
    double pull = 0.0;
    const Points force = model->internal_force(at_once->positions);
    for (const int node : end) {
      QVERIFY(std::abs(at_once->positions(node, 0) - 0.051) < 1e-15);
      pull -= force(node, 0);
    }
    // Its ends cannot narrow, and ten cells are few: stiffer than E A / L by a quarter.
    const double expected = 3500.0 * 0.02 * 0.02 * 0.001 / 0.05;
    QVERIFY2(pull > expected && pull < 1.3 * expected, qPrintable(QString::number(pull / expected)));
    options.static_solve = false;
    options.steps = 200;
    const auto ramped = simulate(model, load, options, RunContext());
    QVERIFY(ramped);
    QVERIFY(std::abs(ramped->records[4].displacement_max - 0.0005) < 1e-12);
    QVERIFY((ramped->positions - at_once->positions).rowwise().norm().maxCoeff() < 1e-6);
  }

  void SpringsThatCarryTheBarLetGoOfIt() {
    // Each pulls its corner by the same way: the bar goes along as it is, and nothing pulls any more.
    const auto model = bar();
    const LoadCase load = parsed(R"({"springs": [
      {"node": 0, "newton_per_metre": 50, "target_mm": [3, -2, 4]},
      {"node": 5, "newton_per_metre": 80, "target_mm": [53, -2, 4]},
      {"node": 12, "newton_per_metre": 50, "target_mm": [3, 18, 4]},
      {"node": 36, "newton_per_metre": 20, "target_mm": [3, -2, 24]}]})");
    SimulationOptions options;
    options.static_solve = true;
    const auto result = simulate(model, load, options, RunContext());
    QVERIFY(result && result->termination == Termination::converged);
    const Points gone = model->mesh().vertices.rowwise() + Eigen::RowVector3d(3e-3, -2e-3, 4e-3);
    QVERIFY((result->positions - gone).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY(result->records.front().force_residual < 1e-8);
  }

  void TheLastStepOfAStaticSolveIsLookedAt() {
    // So small a force that one step of Newton's is nearly all.
    const auto model = bar();
    const AppliedLoad load(parsed(R"({"forces": [{"node": 5, "newton": [0, 0, 1e-6]}],
      "fixed": {"region": {"low_mm": [-1, -1, -1], "high_mm": [0.1, 21, 21]}}})"),
                           *model);
    StaticOptions options;
    options.fixed_nodes = load.fixed_nodes();
    options.max_iterations = 1;
    const auto solve = [&] {
      return *solve_static(
          *model, model->mesh().vertices, [&](const Points& x) { return load.at(x); }, options, RunContext());
    };
    const StaticSummary stopped = solve();
    Points left = model->internal_force(stopped.positions);
    left(5, 2) += 1e-6;
    for (const int node : options.fixed_nodes) left.row(node).setZero();
    QCOMPARE(stopped.iterations, 1);
    QVERIFY(stopped.termination == Termination::step_limit);
    QVERIFY(stopped.residual < 1e-2);
    QVERIFY(std::abs(stopped.residual - left.norm() / 1e-6) < 1e-3 * stopped.residual);
    options.tolerance = 2.0 * stopped.residual;
    QVERIFY(solve().converged());
  }

  void TetrahedraThatAStaticLoadInvertsAreCounted() {
    // One end is put behind the other.
    const auto model = bar();
    const LoadCase load = parsed(R"({
      "moved": [{"region": {"low_mm": [49.9, -1, -1], "high_mm": [51, 21, 21]}, "by_mm": [-70, 0, 0]}],
      "fixed": {"region": {"low_mm": [-1, -1, -1], "high_mm": [0.1, 21, 21]}}})");
    SimulationOptions options;
    options.static_solve = true;
    const auto result = simulate(model, load, options, RunContext());
    QVERIFY(result);
    int inverted = 0;
    const Tetrahedra& all = model->mesh().tetrahedra;
    for (Eigen::Index t = 0; t < all.rows(); ++t) {
      Eigen::Matrix4d corners = Eigen::Matrix4d::Ones();
      for (int k = 0; k < 4; ++k) corners.block<3, 1>(1, k) = result->positions.row(all(t, k)).transpose();
      inverted += corners.determinant() <= 0.0;
    }
    QVERIFY(inverted > 0);
    QCOMPARE(result->records.front().inverted_tetrahedra, inverted);
  }

  void SpringsTangentIsTheForcesDerivative() {
    const auto model = bar();
    const LoadCase load = parsed(R"({"springs": [
      {"point_mm": [21, 7, 9], "newton_per_metre": 40, "target_mm": [25, 3, 12]},
      {"region": {"centre_mm": [50, 10, 10], "radius_mm": 12}, "newton_per_metre": 70}]})");
    const AppliedLoad applied(load, *model);
    const Points x = bent(model->mesh().vertices), direction = noise(x.rows(), 1.0, 4);
    const auto force = [&](const Points& y) { return external_force(*model, applied.at(y), y); };
    const double h = 1e-4;  // linear in x: only round-off
    const Points numeric = (force(x - h * direction) - force(x + h * direction)) / (2.0 * h);
    const Eigen::VectorXd product = load_stiffness_matrix(*model, applied.at(x), x, Tangent::rotated) *
                                    Eigen::Map<const Eigen::VectorXd>(direction.data(), direction.size());
    const Eigen::Map<const Eigen::VectorXd> expected(numeric.data(), numeric.size());
    QVERIFY((product - expected).norm() < 1e-10 * expected.norm());
  }

  void MeshesInMillimetresAndMetresGiveTheSameAnswer() {
    // One organ in two files; the load file is in millimetres whatever the mesh's unit.
    TemporaryFolder folder;
    TetMesh mesh = block_mesh({5, 2, 2}, {0.05, 0.02, 0.02});
    shake(mesh, 0.001, 2);
    const LoadCase load = parsed(R"({"gravity": {"to": "left_flank"}, "pressure": {"pascal": 200},
      "springs": [{"point_mm": [40, 10, 10], "newton_per_metre": 20, "target_mm": [42, 8, 10]}],
      "fixed": {"region": {"low_mm": [-1, -1, -1], "high_mm": [0.1, 21, 21]}}})");
    SimulationOptions options;
    options.steps = 10;
    Points results[2];
    for (int k = 0; k < 2; ++k) {
      const LengthUnit unit = k == 0 ? LengthUnit::millimetre : LengthUnit::metre;
      const auto path = folder.path() / (k == 0 ? "mm.vtu" : "m.vtu");
      write_tet_mesh(path, mesh, unit);
      const auto model = std::make_shared<const CompositeModel>(
          read_tet_mesh(path, unit), std::vector<VesselTree>{}, composite_preset("healthy"));
      const auto result = simulate(model, load, options, RunContext());
      QVERIFY(result);
      results[k] = result->positions;
    }
    QVERIFY((results[0] - mesh.vertices).norm() > 1e-3);
    QVERIFY((results[0] - results[1]).cwiseAbs().maxCoeff() < 1e-12);
  }

  void DynamicSimulationWritesOneLineAStep() {
    const auto model = bar();
    const LoadCase load = parsed(R"({"gravity": {"to": "left_flank"}, "fixed": {"nodes": [0, 1, 6]}})");
    SimulationOptions options;
    options.steps = 5;
    int seen = 0;
    const auto result = simulate(model, load, options, RunContext(),
                                 [&](const SimulationRecord& r, const Points&) { QCOMPARE(r.step, ++seen); });
    QVERIFY(result);
    QCOMPARE(seen, 5);
    TemporaryFolder folder;
    write_simulation_csv(folder.path() / "steps.csv", result->records);
    const std::string text = read_file(folder.path() / "steps.csv");
    QCOMPARE(std::count(text.begin(), text.end(), '\n'), std::ptrdiff_t{6});
  }

  void CancelLeavesNoResult() {
    const auto flag = std::make_shared<CancelFlag>();
    flag->request();
    const RunContext context({}, flag, 1);
    const LoadCase load = parsed(R"({"gravity": {"to": "prone"}, "fixed": {"nodes": [0, 1, 6]}})");
    SimulationOptions options;
    QVERIFY(!simulate(bar(), load, options, context));
    options.static_solve = true;
    QVERIFY(!simulate(bar(), load, options, context));
  }

  void NothingHeldInAStaticSolveIsRefused() {
    SimulationOptions options;
    options.static_solve = true;
    QVERIFY_THROWS_EXCEPTION(
        InputError, simulate(bar(), parsed(R"({"gravity": {"to": "prone"}})"), options, RunContext()));
  }

  void PresetsAreThePapers() {
    QCOMPARE(composite_preset("healthy").parenchyma.young_modulus, 3500.0);
    QCOMPARE(composite_preset("cirrhotic").parenchyma.young_modulus, 30e3);
    QVERIFY(composite_preset("cirrhotic").with_vessels);
    QVERIFY(!composite_preset("cirrhotic_homogeneous").with_vessels);
    QVERIFY_THROWS_EXCEPTION(InputError, composite_preset("stone"));
    QVERIFY(!composite_preset("healthy_homogeneous").with_capsule);
    QCOMPARE(composite_preset_names().size(), std::size_t{4});
  }
};

QTEST_APPLESS_MAIN(LoadsTest)
#include "loads_test.moc"
