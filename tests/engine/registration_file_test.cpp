// SPDX-License-Identifier: GPL-3.0-or-later
// A registration as a file of its own: what is known of it travels with it, and what cannot be is refused.
#include <QTest>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/geometry/mesh_io.h"
#include "small_case.h"

using namespace glisson;
using namespace glisson::engine;
using test::small_case;

namespace {

std::string error_of(const std::function<void()>& action) { return test::complaint<Error>(action); }

}  // namespace

class RegistrationFileTest : public QObject {
  Q_OBJECT
 private slots:
  void ARegistrationOfAnotherModelIsRefused();
  void ARegistrationThatTurnsAnElementInsideOutIsKept();
  void ARegistrationsDoubtsTravelWithItsFile();
  void WhatWasNotedOfARegistrationStaysInItsCase();
  void WhereARegistrationMayBeWrongTravelsWithItsFile();
  void ARigidPartIsReadHoweverItsNumbersStand();
  void WhatIsNoErrorAndNoProbabilityIsRefused();
  void WhatIsNoCovarianceIsRefused();
};

void RegistrationFileTest::ARegistrationOfAnotherModelIsRefused() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  write_registration(folder.path() / "r.vtu", state[part::model]->model, *state[part::registration],
                     LengthUnit::millimetre);
  PatientModel other = state[part::model]->model;
  other.mesh.tetrahedra.row(0).swap(other.mesh.tetrahedra.row(1));
  QVERIFY(error_of([&] {
            read_registration(folder.path() / "r.vtu", other, LengthUnit::millimetre);
          }).find("is not this model's") != std::string::npos);
  const Registration same =
      read_registration(folder.path() / "r.vtu", state[part::model]->model, LengthUnit::millimetre);
  QVERIFY((same.nodes_in_camera - state[part::registration]->nodes_in_camera).norm() < 1e-9);
}

/// As linear elasticity does where a tool pulls hard.
void RegistrationFileTest::ARegistrationThatTurnsAnElementInsideOutIsKept() {
  const TemporaryFolder folder;
  CaseState state = small_case();
  Registration turned = *state[part::registration];
  const PatientModel& model = state[part::model]->model;
  TetMesh deformed = model.mesh;
  turned.nodes_in_camera.row(4) = -turned.nodes_in_camera.row(4);
  deformed.vertices = turned.nodes_in_camera;
  QVERIFY(tetrahedron_volumes(deformed).minCoeff() < 0.0 && tetrahedron_volumes(deformed).maxCoeff() > 0.0);
  state[part::registration] = std::make_shared<const Registration>(turned);
  write_registration(folder.path() / "r.vtu", model, turned, LengthUnit::millimetre);
  const Registration read = read_registration(folder.path() / "r.vtu", model, LengthUnit::millimetre);
  QVERIFY((read.nodes_in_camera - turned.nodes_in_camera).norm() < 1e-9);
  QVERIFY(save_case(folder.path() / "a.glisson", state, RunContext()));
  const auto opened = open_case(folder.path() / "a.glisson", RunContext());
  QVERIFY(((*opened)[part::registration]->nodes_in_camera - turned.nodes_in_camera).norm() < 1e-9);
}

void RegistrationFileTest::ARegistrationsDoubtsTravelWithItsFile() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  Registration doubted = *state[part::registration];
  doubted.doubts = {"cloud_noisy 6.25 3", "lesion_2.error_large 9.5 8", "little_surface_seen",
                    "rival_chosen 1"};
  doubted.notes = {"landmarks.not_reviewed", "look.surface lesion_1 left_front 6.0 3.0"};
  doubted.termination = Termination::stalled;
  doubted.residual = 2.5e-3;
  doubted.seen_share = 0.125;
  Eigen::Matrix3d covariance;
  covariance << 4.0, 1.0, 0.5, 1.0, 9.0, -2.0, 0.5, -2.0, 16.0;
  doubted.lesions = {{structure::kFirstLesion, 1e-6 * covariance},
                     {static_cast<Label>(structure::kFirstLesion + 11), 2e-6 * covariance}};
  doubted.forks = {{structure::kPortalVein, 1, 5e-3, {0.01, 0.02, 0.1}, 3e-6 * covariance},
                   {structure::kPortalVein, 2, 2e-3, {0.03, 0.02, 0.1}, 1e-6 * covariance},
                   {structure::kHepaticVeins, 1, 4e-3, {0.0, 0.01, 0.12}, 2e-6 * covariance}};
  doubted.covariances.resize(doubted.nodes_in_camera.rows(), 6);
  for (Eigen::Index i = 0; i < doubted.covariances.rows(); ++i)
    doubted.covariances.row(i) = (1.0 + static_cast<double>(i)) * 1e-6 * symmetric_row(covariance);
  write_registration(folder.path() / "r.vtu", state[part::model]->model, doubted, LengthUnit::millimetre);
  const Registration read =
      read_registration(folder.path() / "r.vtu", state[part::model]->model, LengthUnit::millimetre);
  QCOMPARE(read.doubts, doubted.doubts);
  QCOMPARE(read.notes, doubted.notes);
  QVERIFY(read.termination == doubted.termination);
  QCOMPARE(read.residual, doubted.residual);
  QCOMPARE(read.seen_share, doubted.seen_share);
  QCOMPARE(read.lesions.size(), std::size_t{2});
  for (const LesionSpread& spread : read.lesions) {
    const double factor = spread.lesion == structure::kFirstLesion ? 1e-6 : 2e-6;
    QVERIFY(spread.covariance.isApprox(factor * covariance, 1e-9));
  }
  QCOMPARE(read.forks.size(), doubted.forks.size());
  for (std::size_t i = 0; i < read.forks.size(); ++i) {
    const ForkSpread &is = read.forks[i], &was = doubted.forks[i];
    QCOMPARE(fork_name(is), fork_name(was));
    QVERIFY(std::abs(is.radius - was.radius) < 1e-9 && (is.centre - was.centre).norm() < 1e-9);
    QVERIFY(is.covariance.isApprox(was.covariance, 1e-9));
  }
  QVERIFY(read.covariances.isApprox(doubted.covariances, 1e-9));
}

void RegistrationFileTest::WhatWasNotedOfARegistrationStaysInItsCase() {
  const TemporaryFolder folder;
  CaseState state = small_case();
  Registration noted = *state[part::registration];
  noted.notes = {"landmarks.not_reviewed", "look.surface lesion_1 left_front 6.0 3.0"};
  state[part::registration] = std::make_shared<const Registration>(noted);
  QVERIFY(save_case(folder.path() / "a.glisson", state, RunContext()));
  const auto opened = open_case(folder.path() / "a.glisson", RunContext());
  QCOMPARE((*opened)[part::registration]->notes, noted.notes);
  QCOMPARE((*opened)[part::registration]->doubts, noted.doubts);
}

void RegistrationFileTest::WhereARegistrationMayBeWrongTravelsWithItsFile() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  const PatientModel& model = state[part::model]->model;
  Registration registration = *state[part::registration];
  registration.expected = Eigen::VectorXd::LinSpaced(5, 1e-3, 9e-3);
  registration.forces = {{4, Eigen::Vector3d(0.0, 0.5, -1.0)},
                         {1, Eigen::Vector3d(0.25, 0.0, 0.0)},
                         {4, Eigen::Vector3d(0.0, 0.1, 0.1)}};  // of a smaller patch there
  registration.looks = {{static_cast<Label>(structure::kFirstLesion + 1), 6e-3,
                         Eigen::VectorXd::LinSpaced(5, 2e-3, 6e-3), 5e-3, 4e-3}};
  const Points there = registration.nodes_in_camera.rowwise() + Eigen::RowVector3d(0.01, -0.02, 0.03);
  registration.rivals = {{there, 0.25}, {2.0 * there, 0.01}};
  // Whatever the file's unit, what is said of the nodes is in millimetres.
  for (const LengthUnit unit : {LengthUnit::millimetre, LengthUnit::metre}) {
    write_registration(folder.path() / "r.vtu", model, registration, unit);
    const Registration read = read_registration(folder.path() / "r.vtu", model, unit);
    QVERIFY((read.expected - registration.expected).norm() < 1e-9);
    QCOMPARE(read.looks.size(), std::size_t{1});
    QCOMPARE(read.looks[0].lesion, registration.looks[0].lesion);
    QVERIFY((read.looks[0].seen - registration.looks[0].seen).norm() < 1e-9);
    QVERIFY(std::abs(read.looks[0].now - 6e-3) < 1e-9 && std::abs(read.looks[0].margin - 5e-3) < 1e-9 &&
            std::abs(read.looks[0].notch - 4e-3) < 1e-9);
    QCOMPARE(read.forces.size(), std::size_t{2});
    QCOMPARE(read.forces[0].node, 4);
    QVERIFY((read.forces[0].force - Eigen::Vector3d(0.0, 0.6, -0.9)).norm() < 1e-9);
    QVERIFY((read.forces[1].force - registration.forces[1].force).norm() < 1e-9);
    QCOMPARE(read.rivals.size(), std::size_t{2});
    QVERIFY((read.rivals[0].nodes_in_camera - there).norm() < 1e-9);
    QCOMPARE(read.rivals[1].probability, 0.01);
  }
}

void RegistrationFileTest::ARigidPartIsReadHoweverItsNumbersStand() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  const PatientModel& model = state[part::model]->model;
  Registration registration = *state[part::registration];
  registration.camera_from_ct.rotation = rotation_by({0.1, -0.2, 0.3});
  registration.camera_from_ct.translation << 0.01, 0.02, 0.03;
  const auto file_path = folder.path() / "r.vtu";
  write_registration(file_path, model, registration, LengthUnit::millimetre);
  TetFile file = read_tet_file(file_path, LengthUnit::millimetre, MeshShape::deformed);
  const Eigen::MatrixXd square = file.field_data["cloud_from_model"];
  Eigen::MatrixXd row(1, 16);
  for (Eigen::Index n = 0; n < 16; ++n) row(0, n) = square(n / 4, n % 4);
  const auto read_with = [&](const Eigen::MatrixXd& table) {
    file.field_data["cloud_from_model"] = table;
    write_tet_mesh(file_path, file, LengthUnit::millimetre);
    return read_registration(file_path, model, LengthUnit::millimetre).camera_from_ct;
  };
  for (const Eigen::MatrixXd& table : {square, row, Eigen::MatrixXd(row.transpose())}) {
    const CameraFromCt read = read_with(table);
    QVERIFY((read.rotation - registration.camera_from_ct.rotation).norm() < 1e-12);
    QVERIFY((read.translation - registration.camera_from_ct.translation).norm() < 1e-12);
  }
  const Eigen::MatrixXd in_columns = square.transpose();
  for (const Eigen::MatrixXd& table :
       {Eigen::MatrixXd(square.reshaped(2, 8)), Eigen::MatrixXd(square.reshaped(8, 2)),
        Eigen::MatrixXd(2.0 * square), in_columns})
    QVERIFY_THROWS_EXCEPTION(InputError, read_with(table));
}

void RegistrationFileTest::WhatIsNoErrorAndNoProbabilityIsRefused() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  const PatientModel& model = state[part::model]->model;
  const auto error_with = [&](auto spoil) {
    Registration registration = *state[part::registration];
    registration.expected = Eigen::VectorXd::Constant(5, 1e-3);
    registration.rivals = {{registration.nodes_in_camera, 0.5}};
    spoil(registration);
    write_registration(folder.path() / "r.vtu", model, registration, LengthUnit::millimetre);
    return error_of([&] { read_registration(folder.path() / "r.vtu", model, LengthUnit::millimetre); });
  };
  QVERIFY(error_with([](Registration&) {}).empty());
  QVERIFY(error_with([](Registration& r) { r.expected[2] = -1e-3; }).find("expected_error_mm") !=
          std::string::npos);
  QVERIFY(error_with([](Registration& r) { r.rivals[0].probability = 1.5; }).find("rival_1_probability") !=
          std::string::npos);
}

void RegistrationFileTest::WhatIsNoCovarianceIsRefused() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  Registration registration = *state[part::registration];
  registration.lesions = {
      {structure::kFirstLesion, 1e-6 * Eigen::Vector3d(4.0, -1.0, 1.0).asDiagonal().toDenseMatrix()}};
  write_registration(folder.path() / "r.vtu", state[part::model]->model, registration,
                     LengthUnit::millimetre);
  const std::string error = error_of(
      [&] { read_registration(folder.path() / "r.vtu", state[part::model]->model, LengthUnit::millimetre); });
  QVERIFY(error.find("lesion_1_covariance_mm2") != std::string::npos);
}

QTEST_APPLESS_MAIN(RegistrationFileTest)
#include "registration_file_test.moc"
