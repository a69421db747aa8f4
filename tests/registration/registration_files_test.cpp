// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/registration_files.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/geometry/mesh_io.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

class RegistrationFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void AStartIsReadInItsUnit();
  void WhatIsNoRigidMatrixIsRefused();
  void ASurfaceIsCarriedByItsModel();

 private:
  std::filesystem::path written(const std::string& text) const {
    const auto path = folder_.path() / "start.txt";
    write_file_atomically(path, text);
    return path;
  }
  TemporaryFolder folder_;
};

void RegistrationFilesTest::AStartIsReadInItsUnit() {
  const auto path = written("0 -1 0 10\n1 0 0 20\n0 0 1 30\n0 0 0 1\n");
  const CameraFromCt start = read_start(path, LengthUnit::millimetre);
  QVERIFY((start.translation - Eigen::Vector3d(0.01, 0.02, 0.03)).norm() < 1e-12);
  QVERIFY((start.rotation * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm() < 1e-12);
  QVERIFY((read_start(path, LengthUnit::metre).translation - Eigen::Vector3d(10, 20, 30)).norm() < 1e-9);
}

void RegistrationFilesTest::WhatIsNoRigidMatrixIsRefused() {
  for (const char* text :
       {"1 0 0 0 1 0", "one", "2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1", "-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
        "0 1 0 0 -1 0 0 0 0 0 1 0 10 20 30 1",  // column by column
        "1 0 0 0 0 1 0 1e300 0 0 1 0 0 0 0 1",  // outside the world
        "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 5"})
    QVERIFY_THROWS_EXCEPTION(InputError, read_start(written(text), LengthUnit::millimetre));
  QVERIFY_THROWS_EXCEPTION(FileError, read_start(folder_.path() / "none.txt", LengthUnit::millimetre));
}

void RegistrationFilesTest::ASurfaceIsCarriedByItsModel() {
  const PatientModel model = phantom::model(5, 4, 3);
  const TriangleMesh& surface = model.surface.mesh;
  Registration registration;
  registration.camera_from_ct = phantom::view();
  Eigen::Matrix3d stretch;
  stretch << 1.1, 0.2, 0.0, -0.1, 0.9, 0.05, 0.0, 0.1, 1.05;  // what linear tetrahedra carry exactly
  registration.nodes_in_camera = model.mesh.vertices * stretch.transpose();
  const auto path = folder_.path() / "carried.vtp";
  write_carried_surface(path, surface, model, registration, LengthUnit::millimetre);
  const TriangleMesh read = read_triangle_mesh(path, LengthUnit::millimetre);
  QVERIFY(read.triangles == surface.triangles);
  QVERIFY((read.vertices - surface.vertices * stretch.transpose()).cwiseAbs().maxCoeff() < 1e-6);
}

QTEST_APPLESS_MAIN(RegistrationFilesTest)
#include "registration_files_test.moc"
