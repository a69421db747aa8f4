// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic.h"

#include <QTest>
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

std::filesystem::path sequence_folder() {
  const char* data = std::getenv("GLISSON_DATA");
  const char* source = std::getenv("GLISSON_SOURCE_DIR");
  const std::filesystem::path root = data != nullptr     ? std::filesystem::path(data)
                                     : source != nullptr ? std::filesystem::path(source) / "../shared/data"
                                                         : std::filesystem::path();
  const std::filesystem::path folder = root / "elastic_sequence";
  return std::filesystem::exists(folder / "rest.vtk") ? folder : std::filesystem::path();
}

}  // namespace

class ElasticTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsSeenIsReached();
  void LittleSeenRaisesADoubt();
  void MovingTheCloudMovesTheResult();
  void SameInputGivesSameBits();
  void FixedNodesStay();
  void ScheduleRunsToItsLastPlateau();
  void StepLimitIsReported();
  void WhatNeverRestsIsStalled();
  void PrintedFormDoesNotRegister();
  void ForeignDeformationIsRecovered();
  void AnUnsurePieceOfTheMarginPullsLess();
  void CancelIsObeyed();
  void UnusableInputIsRefused();

 private:
  /// The body bent about an axis through the back: a formula, no mechanics, so that the model cannot meet
  /// itself. Metres.
  static Points bend(const Points& points, double most) {
    Points bent = points;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const double x = points(i, 0), sagged = std::max(0.0, x / 0.105);
      bent(i, 2) -= most * sagged * sagged;
      bent(i, 0) -= 0.5 * most * most / 0.105 * sagged * sagged;
    }
    return bent;
  }
  LabelledCloud seen(double most, double share = 0.4) const {
    phantom::PatchOptions options;
    options.share = share;
    return phantom::patch(truth_, phantom::view().apply(bend(truth_.mesh.vertices, most)), options);
  }
  static ElasticOptions brief() {
    ElasticOptions options;
    options.r_surface = 3;
    return options;
  }

  PatientModel model_ = phantom::model(10, 8, 4), truth_ = phantom::model(17, 13, 6);
};

/// A third of the margin lies 20 mm behind where it is.
void ElasticTest::AnUnsurePieceOfTheMarginPullsLess() {
  const LabelledCloud cloud = seen(0.0);
  const auto placed = [&](const PatientModel& model) {
    return register_elastic(model, cloud, phantom::view(), brief(), RunContext())->nodes_in_camera;
  };
  const Points right = placed(model_);
  const auto moved_by = [&](double deviation) {
    PatientModel model = model_;
    Points& margin = model.landmarks.anterior_margin;
    const ClosestPointTree tree(model.surface.mesh);
    constexpr Eigen::Index kPiece = 14;
    for (Eigen::Index k = 0; k < kPiece; ++k)
      margin.row(k) =
          tree.closest(margin.row(k).transpose() + Eigen::Vector3d(0.0, 0.02, 0.0)).point.transpose();
    model.landmarks.margin_deviation = Eigen::VectorXd::Zero(margin.rows());
    model.landmarks.margin_deviation.head(kPiece).setConstant(deviation);
    return (placed(model) - right).rowwise().norm().mean();
  };
  const double sure = moved_by(0.0), unsure = moved_by(15e-3);
  QVERIFY2(unsure < 0.8 * sure, qPrintable(QStringLiteral("%1 %2").arg(unsure).arg(sure)));
  QCOMPARE(moved_by(6e-3), sure);  // as a person's
}

void ElasticTest::LittleSeenRaisesADoubt() {
  for (const double share : {0.08, 0.12, 0.3, 0.4}) {
    const auto registered =
        register_elastic(model_, seen(0.0, share), phantom::view(), brief(), RunContext());
    QVERIFY(registered);
    // The phantom says how much of the surface it sampled; points stand for what is 8 mm around them, too.
    QVERIFY(registered->seen_share > 0.8 * share && registered->seen_share < share + 0.1);
    const auto& doubts = registered->doubts;
    QCOMPARE(std::count(doubts.begin(), doubts.end(), "little_surface_seen"), share < 0.2 ? 1 : 0);
  }
}

void ElasticTest::WhatIsSeenIsReached() {
  const double most = 0.035;
  const Points target = phantom::view().apply(bend(model_.mesh.vertices, most));
  const auto best = fit_rigid<CameraFrame, CtFrame>(model_.mesh.vertices, target);
  const LabelledCloud cloud = seen(most);
  const auto distance = [&](const Points& nodes) {
    TriangleMesh surface = model_.surface.mesh;
    for (int i = 0; i < surface.vertex_count(); ++i)
      surface.vertices.row(i) = nodes.row(model_.surface.node_of_vertex[static_cast<std::size_t>(i)]);
    return summarise(distances_to_surface(cloud.points, surface)).mean;
  };
  const auto registration = register_elastic(model_, cloud, best, {}, RunContext());
  QVERIFY(registration->termination == Termination::converged);
  const double rigid = distance(best.apply(model_.mesh.vertices));
  const double elastic = distance(registration->nodes_in_camera);
  QVERIFY2(rigid > 2e-3 && elastic < 0.9e-3, qPrintable(QString("%1 and %2").arg(rigid).arg(elastic)));
  QVERIFY(std::abs(registration->residual - elastic) < 1e-4);
}

void ElasticTest::MovingTheCloudMovesTheResult() {
  LabelledCloud cloud = seen(0.02);
  CameraFromCt start = phantom::view();
  const auto one = register_elastic(model_, cloud, start, brief(), RunContext());
  Rigid<CameraFrame, CameraFrame> moved;
  moved.rotation = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  moved.translation = {0.05, -0.1, 0.2};
  cloud.points = moved.apply(cloud.points);
  cloud.normals = (cloud.normals * moved.rotation.transpose()).eval();
  const auto other = register_elastic(model_, cloud, moved * start, brief(), RunContext());
  QVERIFY(point_errors(other->nodes_in_camera, moved.apply(one->nodes_in_camera)).maximum < 2e-4);
}

void ElasticTest::SameInputGivesSameBits() {
  const LabelledCloud cloud = seen(0.02);
  const auto a = register_elastic(model_, cloud, phantom::view(), brief(), RunContext());
  const auto b = register_elastic(model_, cloud, phantom::view(), brief(), RunContext());
  QVERIFY(a->nodes_in_camera == b->nodes_in_camera);
  QCOMPARE(a->steps, b->steps);
}

void ElasticTest::FixedNodesStay() {
  ElasticOptions options = brief();
  for (int node = 0; node < model_.mesh.vertex_count(); ++node)
    if (model_.mesh.vertices(node, 0) < -0.07) options.fixed_nodes.push_back(node);
  const CameraFromCt start = phantom::view();
  const auto registration = register_elastic(model_, seen(0.03), start, options, RunContext());
  const Points before = start.apply(model_.mesh.vertices);
  for (const int node : options.fixed_nodes)
    QVERIFY((registration->nodes_in_camera.row(node) - before.row(node)).norm() < 1e-12);
  QVERIFY(point_errors(registration->nodes_in_camera, before).maximum > 0.01);
}

void ElasticTest::ScheduleRunsToItsLastPlateau() {
  ElasticOptions options = brief();
  options.final_stiffening = 1.0;
  const auto paper = register_elastic(model_, seen(0.01), phantom::view(), options, RunContext());
  QCOMPARE(paper->plateaus, 4);  // n = max(r) + 1
  options.final_stiffening = 10.0;
  const auto stiffened = register_elastic(model_, seen(0.01), phantom::view(), options, RunContext());
  QCOMPARE(stiffened->plateaus, 5);
  QVERIFY(stiffened->residual < paper->residual);
}

void ElasticTest::StepLimitIsReported() {
  ElasticOptions options;
  options.max_steps = 7;
  const auto registration = register_elastic(model_, seen(0.02), phantom::view(), options, RunContext());
  QVERIFY(registration->termination == Termination::step_limit);
  QCOMPARE(registration->steps, 7);
  QCOMPARE(std::ranges::count(registration->doubts, "pull_not_at_rest"), 1);
}

void ElasticTest::WhatNeverRestsIsStalled() {
  ElasticOptions options = brief();
  options.plateau_motion = 1e-15;  // nothing comes to rest by this
  const auto registration = register_elastic(model_, seen(0.01), phantom::view(), options, RunContext());
  QVERIFY(registration->termination == Termination::stalled);
  QVERIFY(registration->steps < options.max_steps);
}

void ElasticTest::PrintedFormDoesNotRegister() {
  ElasticOptions options = brief();
  options.max_steps = 100;
  const auto corrected = register_elastic(model_, seen(0.02), phantom::view(), options, RunContext());
  options.form = PenaltyForm::printed;
  const auto printed = register_elastic(model_, seen(0.02), phantom::view(), options, RunContext());
  QVERIFY(printed->termination == Termination::diverged || printed->residual > 3.0 * corrected->residual);
}

void ElasticTest::ForeignDeformationIsRecovered() {
  // Mestdagh and Cotin's sequence: mesh, cloud and truth were not made here; the truth is linear elasticity.
  const std::filesystem::path folder = sequence_folder();
  if (folder.empty()) QSKIP("the elastic sequence is not there: set GLISSON_DATA to the data folder");
  PatientModel model;
  model.mesh = read_tet_mesh(folder / "rest.vtk", LengthUnit::millimetre);
  model.surface = boundary_surface(model.mesh);
  ElasticOptions options = options_for(model);
  options.fixed_nodes = read_node_numbers(folder / "fixed_vertices.txt", model.mesh.vertex_count());
  const auto registration =
      register_elastic(model, read_cloud(folder / "cloud_00.ply"), CameraFromCt(), options, RunContext());
  const Points truth = read_node_list(folder / "truth_00.xyz", LengthUnit::millimetre);
  const double before = point_errors(model.mesh.vertices, truth).mean;
  const double after = point_errors(registration->nodes_in_camera, truth).mean;
  QVERIFY(registration->termination == Termination::converged);
  QVERIFY2(after < 1.15e-3 && before > 5e-3, qPrintable(QString("mean error %1 mm").arg(1e3 * after)));
}

void ElasticTest::CancelIsObeyed() {
  const auto flag = std::make_shared<CancelFlag>();
  int calls = 0;
  const RunContext context(
      [&](double, std::string_view) {
        if (++calls == 5) flag->request();
      },
      flag, 1);
  QVERIFY(!register_elastic(model_, seen(0.02), phantom::view(), {}, context).has_value());
  QVERIFY(calls < 8);
}

void ElasticTest::UnusableInputIsRefused() {
  const LabelledCloud cloud = seen(0.02);
  const auto refused = [&](auto change) {
    ElasticOptions options;
    change(options);
    QVERIFY_THROWS_EXCEPTION(InputError,
                             register_elastic(model_, cloud, phantom::view(), options, RunContext()));
  };
  refused([](ElasticOptions& o) { o.s = 0.0; });
  refused([](ElasticOptions& o) { o.k_surface_min = 1.0; });
  refused([](ElasticOptions& o) { o.r_surface = 0; });
  refused([](ElasticOptions& o) { o.time_step = -1.0; });
  refused([](ElasticOptions& o) { o.final_stiffening = 0.5; });
  refused([](ElasticOptions& o) { o.tangential = 2.0; });
  refused([](ElasticOptions& o) { o.reference_density_per_cm2 = 0.0; });
  refused([](ElasticOptions& o) { o.fixed_nodes = {100000}; });
  refused([](ElasticOptions& o) { o.materials.parenchyma.poisson_ratio = 0.5; });
  LabelledCloud few = cloud;
  few.points.conservativeResize(5, 3);
  few.normals.conservativeResize(5, 3);
  few.features.resize(5);
  QVERIFY_THROWS_EXCEPTION(InputError, register_elastic(model_, few, phantom::view(), {}, RunContext()));
  // Without a single pair nothing is known: that is no residual of zero.
  LabelledCloud turned = cloud;
  turned.normals = -turned.normals;
  turned.features.clear();  // landmarks are found without normals
  QVERIFY_THROWS_EXCEPTION(InputError,
                           register_elastic(model_, turned, phantom::view(), brief(), RunContext()));
}

QTEST_APPLESS_MAIN(ElasticTest)
#include "elastic_test.moc"
