// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a registration's error, and what speaks against it.
#include "examine.h"

#include <Eigen/Dense>
#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "glisson/core/random.h"
#include "glisson/core/statistics.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

LabelledCloud patch(const PatientModel& model, double share, double noise, unsigned seed = 1) {
  phantom::PatchOptions options;
  options.share = share;
  options.noise = noise;
  options.seed = seed;
  return phantom::patch(model, phantom::view().apply(model.mesh.vertices), options);
}

ErrorModel error_of(const PatientModel& model, const CameraFromCt& pose, const LabelledCloud& cloud,
                    double noise) {
  return ErrorModel(model, nullptr, {}, pose, pose.apply(model.mesh.vertices), prepare_cloud(cloud, {}),
                    noise);
}

Eigen::Vector3d draw(const Eigen::Matrix3d& root, std::mt19937_64& random) {
  const double x = standard_normal(random), y = standard_normal(random), z = standard_normal(random);
  return root * Eigen::Vector3d(x, y, z);
}

}  // namespace

class FindingsTest : public QObject {
  Q_OBJECT
 private slots:
  void RoughnessIsTheCloudsNoise();
  void AMirrorTwiceShowsTheSame();
  void MeanErrorIsThatOfSamples_data();
  void MeanErrorIsThatOfSamples();
  void NinetyFiveOfAHundredSamplesLieInTheEllipsoid();
  void WhatIsNoNumberIsNotCertain();
  void WhatIsSeenIsKnownBetter();
  void MoreOfTheSurfaceLeavesLessUnknownEverywhere();
  void WhatFitsWorseThanItShouldIsKnownWorse();
  void EachNodesCovarianceIsThatOfItsPlace();
  void TheCamerasPlaceDoesNotMatter();
  void ARightPlaceLeavesNothingToFind();
  void AnOrganOfAnotherSizeIsFoundOut();
  void WhatLiesBehindTheModelIsCounted();
  void TheOrgansVolumeIsThatOfItsPlace();

 private:
  PatientModel model_ = phantom::model(7, 6, 3);
};

void FindingsTest::RoughnessIsTheCloudsNoise() {
  for (const double noise : {0.5e-3, 1e-3, 2e-3}) {
    const double found = roughness_of(prepare_cloud(patch(model_, 0.4, noise), {3.9, 1000, 30}));
    QVERIFY2(found > 0.7 * noise && found < 1.5 * noise, qPrintable(QString::number(found / noise)));
  }
}

void FindingsTest::AMirrorTwiceShowsTheSame() {
  const LabelledCloud cloud = patch(model_, 0.3, 1e-3), image = mirrored(cloud);
  QVERIFY((image.points - cloud.points).norm() > 1e-3);
  QCOMPARE(mirrored(image).points, cloud.points);
  QCOMPARE(mirrored(image).normals, cloud.normals);
}

void FindingsTest::MeanErrorIsThatOfSamples_data() {
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("y");
  QTest::addColumn<double>("z");
  QTest::newRow("space") << 1.0 << 1.0 << 1.0;
  QTest::newRow("plane") << 1.0 << 1.0 << 0.0;
  QTest::newRow("line") << 1.0 << 0.0 << 0.0;
  QTest::newRow("askew") << 3.0 << 1.0 << 0.5;
}

/// Student's distribution of three degrees of freedom, made as large as that 95 of 100 samples lie where 95
/// of 100 normal ones do.
void FindingsTest::MeanErrorIsThatOfSamples() {
  QFETCH(double, x);
  QFETCH(double, y);
  QFETCH(double, z);
  const Eigen::Vector3d deviations(x, y, z);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d root = turn * deviations.asDiagonal();
  std::mt19937_64 random(3);
  constexpr std::size_t kSamples = 200000, k95 = kSamples / 20 * 19;
  double sum = 0.0;
  std::vector<double> student, normal;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const Eigen::Vector3d unit = draw(Eigen::Matrix3d::Identity(), random);
    const double tail = std::sqrt(draw(Eigen::Matrix3d::Identity(), random).squaredNorm() / 3.0);
    sum += (root * unit).norm() / tail;
    student.push_back(unit.norm() / tail);
    normal.push_back(unit.norm());
  }
  const double sampled = sum / kSamples * at_rank(normal, k95) / at_rank(student, k95),
               said = mean_error(root * root.transpose());
  QVERIFY2(std::abs(said / sampled - 1.0) < 0.04, qPrintable(QString::number(said / sampled)));
}

void FindingsTest::NinetyFiveOfAHundredSamplesLieInTheEllipsoid() {
  LesionError lesion;
  const Eigen::Vector3d deviations(3.0, 1.0, 0.5);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d root = turn * deviations.asDiagonal();
  lesion.covariance = root * root.transpose();
  const Eigen::Vector3d axes = lesion.half_axes_95();
  QVERIFY(axes[0] > axes[1] && axes[1] > axes[2]);
  std::mt19937_64 random(4);
  int inside = 0;
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i)
    inside += (turn.transpose() * draw(root, random)).cwiseQuotient(axes).norm() < 1.0;
  QVERIFY(std::abs(inside / static_cast<double>(kSamples) - 0.95) < 0.006);
}

void FindingsTest::WhatIsNoNumberIsNotCertain() {
  Eigen::Matrix3d covariance = 1e-6 * Eigen::Matrix3d::Identity();
  covariance(1, 1) = std::numeric_limits<double>::quiet_NaN();
  QVERIFY(std::isnan(mean_error(covariance)));
  const Eigen::Vector3d axes = half_axes_95(covariance);
  QVERIFY(std::isnan(axes[0]) && std::isnan(axes[1]) && std::isnan(axes[2]));
  QCOMPARE(mean_error(Eigen::Matrix3d::Zero()), 0.0);
}

void FindingsTest::WhatIsSeenIsKnownBetter() {
  // Along the surface's normal, which is what a cloud tells of.
  const CameraFromCt pose = phantom::view();
  const LabelledCloud cloud = patch(model_, 0.2, 1e-3);
  const ErrorModel error = error_of(model_, pose, cloud, 1e-3);
  const Points vertices = pose.apply(model_.surface.mesh.vertices);
  const Points normals = vertex_normals(model_.surface.mesh) * pose.rotation.transpose();
  double near = 0.0, far = 0.0;
  int near_count = 0, far_count = 0;
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) {
    const int node = model_.surface.node_of_vertex[static_cast<std::size_t>(i)];
    const Eigen::Matrix3d covariance = error.covariance({node, -1, -1, -1}, {1.0, 0.0, 0.0, 0.0});
    const double deviation = std::sqrt(normals.row(i).dot(normals.row(i) * covariance));
    const double away = (cloud.points.rowwise() - vertices.row(i)).rowwise().norm().minCoeff();
    if (away < 0.01) near += deviation, ++near_count;
    if (away > 0.06) far += deviation, ++far_count;
  }
  QVERIFY(near_count > 0 && far_count > 0);
  QVERIFY2(far / far_count > 1.2 * near / near_count,
           qPrintable(QString::number(far / far_count / (near / near_count))));
}

void FindingsTest::MoreOfTheSurfaceLeavesLessUnknownEverywhere() {
  const CameraFromCt pose = phantom::view();
  // The same points, and more: weights would change with the density, so both are thinned alike.
  const LabelledCloud much = patch(model_, 0.45, 1e-3), little = patch(model_, 0.15, 1e-3);
  const Eigen::VectorXd of_much = error_of(model_, pose, much, 1e-3).expected(),
                        of_little = error_of(model_, pose, little, 1e-3).expected();
  QVERIFY((of_much.array() < 1.05 * of_little.array()).all());
  QVERIFY(of_much.mean() < 0.8 * of_little.mean());
}

void FindingsTest::WhatFitsWorseThanItShouldIsKnownWorse() {
  const CameraFromCt pose = phantom::view();
  const LabelledCloud fits = patch(model_, 0.3, 1e-3);
  LabelledCloud bent = fits;  // waves of 60 mm, which hardly any force makes
  for (Eigen::Index i = 0; i < bent.points.rows(); ++i)
    bent.points(i, 2) += 8e-3 * std::sin(105.0 * bent.points(i, 0)) * std::cos(105.0 * bent.points(i, 1));
  const double before = error_of(model_, pose, fits, 1e-3).expected().mean(),
               after = error_of(model_, pose, bent, 1e-3).expected().mean();
  QVERIFY2(after > 1.3 * before, qPrintable(QString("%1, %2 mm").arg(1e3 * before).arg(1e3 * after)));
  // A cloud that is noisier than what the fit weighed by is known worse by that.
  const double noisy = error_of(model_, pose, fits, 6e-3).expected().mean();
  QVERIFY2(noisy > 1.1 * before, qPrintable(QString("%1, %2 mm").arg(1e3 * before).arg(1e3 * noisy)));
}

void FindingsTest::EachNodesCovarianceIsThatOfItsPlace() {
  const ErrorModel error = error_of(model_, phantom::view(), patch(model_, 0.2, 1e-3), 1e-3);
  const SymmetricRows rows = error.node_covariances();
  QCOMPARE(rows.rows(), model_.mesh.vertex_count());
  for (const int node : {0, 17, model_.mesh.vertex_count() - 1}) {
    const Eigen::Matrix3d m = error.covariance({node, -1, -1, -1}, {1.0, 0.0, 0.0, 0.0});
    Eigen::Matrix<double, 1, 6> expected;
    expected << m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2);
    QVERIFY((rows.row(node) - expected).norm() < 1e-9 * expected.norm());
  }
}

void FindingsTest::TheCamerasPlaceDoesNotMatter() {
  const CameraFromCt pose = phantom::view();
  const LabelledCloud cloud = patch(model_, 0.3, 1e-3);
  Rigid<CameraFrame, CameraFrame> turned;
  turned.rotation = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  turned.translation = Eigen::Vector3d(0.02, 0.05, -0.03);
  LabelledCloud moved = cloud;
  moved.points = turned.apply(cloud.points);
  moved.normals = cloud.normals * turned.rotation.transpose();
  const Eigen::VectorXd here = error_of(model_, pose, cloud, 1e-3).expected(),
                        there = error_of(model_, turned * pose, moved, 1e-3).expected();
  QVERIFY((here - there).cwiseAbs().maxCoeff() < 1e-6 * here.maxCoeff());
}

void FindingsTest::ARightPlaceLeavesNothingToFind() {
  const CameraFromCt pose = phantom::view();
  const ErrorModel error = error_of(model_, pose, patch(model_, 0.4, 0.2e-3), 0.2e-3);
  QVERIFY(error.misfit() < 0.2e-3);
  QVERIFY(error.held_out().distance < 0.5e-3);
  QVERIFY(error.strangeness() < 1.0);
  QVERIFY(std::abs(error.size().value) < 0.01);
}

void FindingsTest::AnOrganOfAnotherSizeIsFoundOut() {
  const CameraFromCt pose = phantom::view();
  const Points nodes = pose.apply(model_.mesh.vertices);
  const Eigen::RowVector3d middle = nodes.colwise().mean();
  LabelledCloud cloud = patch(model_, 0.5, 0.2e-3);
  cloud.points = (1.1 * (cloud.points.rowwise() - middle)).rowwise() + middle;
  const ErrorModel::Size size = error_of(model_, pose, cloud, 0.2e-3).size();
  QVERIFY2(size.value > 0.03 && size.value < 0.13, qPrintable(QString::number(size.value)));
  QVERIFY(size.value > 2.0 * size.sigma);
}

void FindingsTest::WhatLiesBehindTheModelIsCounted() {
  const CameraFromCt pose = phantom::view();
  LabelledCloud cloud = patch(model_, 0.3, 0.2e-3);
  Registration registration;
  registration.camera_from_ct = pose;
  registration.nodes_in_camera = pose.apply(model_.mesh.vertices);
  const ErrorModel error = error_of(model_, pose, cloud, 0.2e-3);
  QVERIFY(examine({model_, cloud, registration, nullptr, error})->hidden < 0.01);
  for (Eigen::Index i = 0; i < cloud.points.rows(); i += 2) cloud.points.row(i) *= 1.15;
  QVERIFY(std::abs(examine({model_, cloud, registration, nullptr, error})->hidden - 0.5) < 0.1);
}

void FindingsTest::TheOrgansVolumeIsThatOfItsPlace() {
  const CameraFromCt pose = phantom::view();
  const LabelledCloud cloud = patch(model_, 0.3, 0.2e-3);
  const ErrorModel error = error_of(model_, pose, cloud, 0.2e-3);
  Registration registration;
  registration.camera_from_ct = pose;
  registration.nodes_in_camera = pose.apply(model_.mesh.vertices);
  QVERIFY(std::abs(examine({model_, cloud, registration, nullptr, error})->volume_change) < 1e-9);
  registration.nodes_in_camera.col(1) *= 0.9;
  QVERIFY(std::abs(examine({model_, cloud, registration, nullptr, error})->volume_change + 0.1) < 1e-9);
}

QTEST_APPLESS_MAIN(FindingsTest)
#include "findings_test.moc"
