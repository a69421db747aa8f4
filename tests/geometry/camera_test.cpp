// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/camera.h"

#include <Eigen/LU>
#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "glisson/core/error.h"

using namespace glisson;

namespace {

Camera laparoscope(bool distorted) {
  Camera camera;
  camera.width = 960;
  camera.height = 540;
  camera.matrix << 820, 0.7, 481, 0, 815, 268, 0, 0, 1;
  if (distorted) camera.distortion << -0.28, 0.11, 1e-3, -7e-4, -0.02;
  return camera;
}

struct A {};
struct B {};

Points cloud(int count) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0.0, 0.1);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = normal(random);
  return points;
}

Rigid<B, A> known_motion() {
  Rigid<B, A> motion;
  motion.rotation = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  motion.translation << 0.3, -0.1, 2.0;
  return motion;
}

/// By differences of project() alone: steps outwards from the middle, until one is too short.
double slope_of_shortened_steps(const Camera& camera) {
  constexpr double kStep = 1e-3, kShortest = 0.2;
  const auto along = [&](double slope) {
    return (camera.project({slope, 0.0, 1.0}) - camera.project({0.0, 0.0, 1.0})).x();
  };
  const double first = along(kStep);
  double slope = 0.0;
  while (slope < 4.0 && along(slope + kStep) - along(slope) >= kShortest * first) slope += kStep;
  return slope;
}

}  // namespace

class CameraTest : public QObject {
  Q_OBJECT
 private slots:
  void UndistortedProjectionIsThePinhole();
  void DistortionIsOpenCvs();
  void RayIsTheInverseOfProject();
  void DirectionsAreMappedWhileThePictureGrows();
  void AFoldedPlaceIsNotInThePicture();
  void PixelsHaveTheRaysThatTheLensMaps();
  void BeyondTheFoldAPixelGetsTheOutermostRay();
  void CentreOfTheFirstPixelIsTheOrigin();
  void AReducedCameraHasTheSameRays_data();
  void AReducedCameraHasTheSameRays();
  void BaselineIsTheTranslation();
  void InverseUndoes();
  void CompositionIsOneAfterTheOther();
  void MatrixHoldsTheSame();
  void AMatrixThatIsNoMotionIsRefused();
  void FitFindsTheMotion();
  void FitNeverReflects();
  void FitOfAPlaneIsARotation();
  void WeightsChooseWhatCounts();
  void FitRefusesWhatDoesNotCorrespond();
};

void CameraTest::UndistortedProjectionIsThePinhole() {
  const Eigen::Vector2d pixel = laparoscope(false).project({0.02, -0.01, 0.1});
  QVERIFY((pixel - Eigen::Vector2d(820 * 0.2 + 0.7 * -0.1 + 481, 815 * -0.1 + 268)).norm() < 1e-9);
}

void CameraTest::DistortionIsOpenCvs() {
  // By the formula of OpenCV's calib3d manual, written out.
  const double x = 0.3, y = -0.2, r2 = x * x + y * y;
  const double k1 = -0.28, k2 = 0.11, p1 = 1e-3, p2 = -7e-4, k3 = -0.02;
  const double radial = 1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
  const double xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
               yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
  const Eigen::Vector2d pixel = laparoscope(true).project({0.5 * x, 0.5 * y, 0.5});
  QVERIFY((pixel - Eigen::Vector2d(820 * xd + 0.7 * yd + 481, 815 * yd + 268)).norm() < 1e-9);
}

void CameraTest::RayIsTheInverseOfProject() {
  for (const bool distorted : {false, true}) {
    const Camera camera = laparoscope(distorted);
    for (double u = 0; u < camera.width; u += 97)
      for (double v = 0; v < camera.height; v += 89) {
        const Eigen::Vector3d ray = camera.ray({u, v});
        QCOMPARE(ray.z(), 1.0);
        QVERIFY((camera.project(0.137 * ray) - Eigen::Vector2d(u, v)).norm() < 1e-6);
      }
  }
}

void CameraTest::DirectionsAreMappedWhileThePictureGrows() {
  std::mt19937 random(8);
  std::normal_distribution<double> normal(0.0, 1.0);
  Camera camera = laparoscope(false);
  int folded = 0;
  for (int n = 0; n < 200; ++n) {
    // Of one, two and three terms; real calibrations have coefficients of 3 and -15.
    camera.distortion << 0.5 * normal(random), n % 3 > 0 ? 2.0 * normal(random) : 0.0, 0.0, 0.0,
        n % 3 > 1 ? 8.0 * normal(random) : 0.0;
    const double expected = slope_of_shortened_steps(camera), found = camera.widest_slope();
    QVERIFY2(std::abs(found - expected) < 3e-3,
             qPrintable(QString("%1: %2 for %3").arg(n).arg(found).arg(expected)));
    folded += found < 3.9;
    const Eigen::Vector3d side = Eigen::Vector3d(0.6, -0.8, 0.0);
    for (const double share : {0.5, 0.99, 1.01, 1.7}) {
      const Eigen::Vector3d p = 0.1 * (Eigen::Vector3d::UnitZ() + share * found * side);
      QCOMPARE(camera.maps(p), share < 1.0);
    }
  }
  QVERIFY(folded > 50);
  QVERIFY(!camera.maps({0.0, 0.0, -0.1}) && !camera.maps({0.0, 0.0, 0.0}));
  QVERIFY(!camera.shows({0.0, 0.0, -0.1}));
}

void CameraTest::AFoldedPlaceIsNotInThePicture() {
  Camera camera = laparoscope(false);
  camera.distortion << -0.4, 0.0, 0.0, 0.0, 0.0;
  const Eigen::Vector3d aside(0.15, 0.0, 0.1);
  QVERIFY(camera.sees(camera.project(aside)));  // where something else is
  QVERIFY(!camera.shows(aside));
  QVERIFY(camera.shows({0.03, 0.0, 0.1}));
  QVERIFY(camera.maps({0.08, 0.0, 0.1}));
  QVERIFY(!camera.shows({0.08, 0.0, 0.1}));  // beside the picture
}

/// By the image of the widest slope: what lies farther out has no ray, what lies nearer has one.
void CameraTest::PixelsHaveTheRaysThatTheLensMaps() {
  std::mt19937 random(12);
  std::normal_distribution<double> normal(0.0, 1.0);
  int with = 0, without = 0;
  for (int n = 0; n < 200; ++n) {
    Camera camera = laparoscope(false);
    camera.matrix << 800, 0, 480, 0, 800, 270, 0, 0, 1;
    const double k1 = 0.5 * normal(random), k2 = n % 3 > 0 ? 2.0 * normal(random) : 0.0,
                 k3 = n % 3 > 1 ? 8.0 * normal(random) : 0.0;
    camera.distortion << k1, k2, 0.0, 0.0, k3;
    const double widest = camera.widest_slope();
    const double reach = camera.project({widest, 0.0, 1.0}).x() - 480.0;
    for (double u = 3; u < camera.width; u += 53)
      for (double v = 2; v < camera.height; v += 47) {
        const Eigen::Vector2d pixel(u, v), out = pixel - Eigen::Vector2d(480.0, 270.0);
        if (std::abs(out.norm() - reach) < 0.1) continue;
        const Eigen::Vector3d ray = camera.ray(pixel);
        const auto mapped = camera.mapped_ray(pixel);
        QVERIFY(ray.allFinite());
        // Never through the axis to the other side.
        QVERIFY(ray.head<2>().dot(out) > 0.999 * ray.head<2>().norm() * out.norm());
        QCOMPARE(mapped.has_value(), out.norm() < reach);
        if (mapped) {
          QVERIFY(camera.maps(*mapped) && *mapped == ray);
          QVERIFY((camera.project(ray) - pixel).norm() < 1e-4);
          ++with;
        } else {
          QVERIFY(ray.head<2>().norm() > widest - 1e-9);
          ++without;
        }
      }
  }
  QVERIFY(with > 10000 && without > 1000);
}

/// Newton's method alone came to the middle of the picture, to its other side, or to nothing there.
void CameraTest::BeyondTheFoldAPixelGetsTheOutermostRay() {
  Camera camera = laparoscope(false);
  camera.matrix << 800, 0, 480, 0, 800, 270, 0, 0, 1;
  camera.distortion << -2.4, 0.0, 0.0, 0.0, 0.0;  // turns back at 0.2485 focal lengths from the axis
  QVERIFY(camera.mapped_ray({480.0 + 0.24 * 800.0, 270.0}));
  for (const double out : {0.26, 0.275, 0.3, 0.35, 0.4, 0.575, 2.0}) {
    const Eigen::Vector3d ray = camera.ray({480.0 + out * 800.0, 270.0});
    QVERIFY2((ray - Eigen::Vector3d(camera.widest_slope(), 0.0, 1.0)).norm() < 1e-9, QByteArray::number(out));
    QVERIFY(!camera.mapped_ray({480.0 + out * 800.0, 270.0}));
  }
}

void CameraTest::CentreOfTheFirstPixelIsTheOrigin() {
  const Camera camera = laparoscope(false);
  QVERIFY(camera.sees({0, 0}) && camera.sees({-0.5, -0.5}) && camera.sees({959.4, 539.4}));
  QVERIFY(!camera.sees({-0.6, 10}) && !camera.sees({959.5, 10}) && !camera.sees({10, 539.5}));
}

void CameraTest::AReducedCameraHasTheSameRays_data() {
  QTest::addColumn<int>("width");
  QTest::addColumn<int>("times");
  QTest::newRow("960") << 960 << 1;
  QTest::newRow("1280") << 1280 << 1;
  QTest::newRow("1920") << 1920 << 2;
  QTest::newRow("odd") << 1921 << 2;
  QTest::newRow("3840") << 3840 << 4;
}

void CameraTest::AReducedCameraHasTheSameRays() {
  QFETCH(int, width);
  QFETCH(int, times);
  QCOMPARE(reduction_of(width), times);
  Camera whole = laparoscope(true);
  whole.matrix.topRows<2>() *= width / 960.0;
  whole.width = width;
  whole.height = 541;
  const Camera small = reduced(whole, times);
  QCOMPARE(small.width, width / times);
  QCOMPARE(small.height, 541 / times);
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0.01, -0.02, 0.12), Eigen::Vector3d(-0.04, 0.01, 0.15),
                                   Eigen::Vector3d(0.03, 0.015, 0.08)}) {
    // From the picture's edge, not from the first pixel's centre, in pixels that are so much wider.
    const Eigen::Vector2d from_edge = whole.project(p).array() + 0.5,
                          reduced_from_edge = small.project(p).array() + 0.5;
    QVERIFY((from_edge / times - reduced_from_edge).norm() < 1e-9);
  }
  QVERIFY_THROWS_EXCEPTION(PreconditionError, reduced(whole, 0));
}

void CameraTest::BaselineIsTheTranslation() {
  StereoRig rig;
  rig.right_from_left.translation << -0.003, 0.004, 0.0;
  QVERIFY(std::abs(rig.baseline() - 0.005) < 1e-15);
}

void CameraTest::InverseUndoes() {
  const Rigid<B, A> motion = known_motion();
  const Point<A> p(0.1, 0.2, -0.3);
  QVERIFY(((motion.inverse() * (motion * p)).xyz - p.xyz).norm() < 1e-14);
}

void CameraTest::CompositionIsOneAfterTheOther() {
  const Rigid<B, A> first = known_motion();
  Rigid<A, B> second;
  second.rotation = Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY()).toRotationMatrix();
  second.translation << 1, 2, 3;
  const Point<A> p(0.1, 0.2, -0.3);
  QVERIFY((((second * first) * p).xyz - (second * (first * p)).xyz).norm() < 1e-14);
}

void CameraTest::MatrixHoldsTheSame() {
  const Rigid<B, A> motion = known_motion();
  const Points points = cloud(5);
  const Points moved = motion.apply(points);
  for (Eigen::Index i = 0; i < 5; ++i)
    QVERIFY(((motion.matrix() * points.row(i).transpose().homogeneous()).head<3>() - moved.row(i).transpose())
                .norm() < 1e-14);
  const Rigid<B, A> back = Rigid<B, A>::from_matrix(motion.matrix(), "test");
  QVERIFY(back.rotation == motion.rotation && back.translation == motion.translation);
}

void CameraTest::AMatrixThatIsNoMotionIsRefused() {
  const Eigen::Matrix4d good = known_motion().matrix();
  Eigen::Matrix4d scaled = good, mirrored = good, not_a_number = good, endless = good;
  scaled.topLeftCorner<3, 3>() *= 1.1;
  mirrored.col(0) *= -1.0;
  not_a_number(1, 1) = std::numeric_limits<double>::quiet_NaN();
  endless(2, 3) = std::numeric_limits<double>::infinity();
  for (const Eigen::Matrix4d& matrix : {scaled, mirrored, not_a_number, endless})
    QVERIFY_THROWS_EXCEPTION(InputError, (Rigid<B, A>::from_matrix(matrix, "a.vtu")));
}

void CameraTest::FitFindsTheMotion() {
  const Points source = cloud(30);
  const Rigid<B, A> truth = known_motion(), found = fit_rigid<B, A>(source, truth.apply(source));
  QVERIFY((found.rotation - truth.rotation).norm() < 1e-12 &&
          (found.translation - truth.translation).norm() < 1e-12);
}

void CameraTest::FitNeverReflects() {
  const Points source = cloud(30);
  Points mirrored = source;
  mirrored.col(0) *= -1.0;
  const Rigid<B, A> found = fit_rigid<B, A>(source, mirrored);
  QVERIFY(std::abs(found.rotation.determinant() - 1.0) < 1e-12);
  // The best rotation by trying many.
  const auto misfit = [&](const Eigen::Matrix3d& rotation) {
    const Eigen::RowVector3d centre = source.colwise().mean(), target = mirrored.colwise().mean();
    return (((source.rowwise() - centre) * rotation.transpose()).rowwise() + target - mirrored).squaredNorm();
  };
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Quaterniond q{normal(random), normal(random), normal(random), normal(random)};
    QVERIFY(misfit(found.rotation) <= misfit(q.normalized().toRotationMatrix()) + 1e-12);
  }
}

void CameraTest::FitOfAPlaneIsARotation() {
  Points source = cloud(12);
  source.col(2).setZero();
  const Rigid<B, A> truth = known_motion(), found = fit_rigid<B, A>(source, truth.apply(source));
  QVERIFY((found.rotation - truth.rotation).norm() < 1e-9);
}

void CameraTest::WeightsChooseWhatCounts() {
  const Points source = cloud(20);
  Points target = known_motion().apply(source);
  target.row(7) += Eigen::RowVector3d(5, 5, 5);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(20);
  weights[7] = 0.0;
  QVERIFY((fit_rigid<B, A>(source, target, weights).rotation - known_motion().rotation).norm() < 1e-12);
}

void CameraTest::FitRefusesWhatDoesNotCorrespond() {
  const Points source = cloud(20), target = known_motion().apply(source);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, (fit_rigid<B, A>(source, target.topRows(19))));
  // As many as others have: they would count for nothing, without a word.
  QVERIFY_THROWS_EXCEPTION(PreconditionError, (fit_rigid<B, A>(source, target, Eigen::VectorXd::Ones(19))));
}

QTEST_APPLESS_MAIN(CameraTest)
#include "camera_test.moc"
