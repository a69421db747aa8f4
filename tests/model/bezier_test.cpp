// SPDX-License-Identifier: GPL-3.0-or-later
#include "bezier.h"

#include <Eigen/Geometry>
#include <QTest>
#include <numbers>
#include <random>

#include "glisson/core/error.h"

using namespace glisson::model;

namespace {

std::vector<Eigen::Vector3d> arc(double radius, double angle, int count) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= count; ++i)
    points.emplace_back(radius * std::cos(angle * i / count), radius * std::sin(angle * i / count), 0.2 * i);
  return points;
}

}  // namespace

class BezierTest : public QObject {
  Q_OBJECT
 private slots:
  void DerivativesMatchFiniteDifferences();
  void CurvatureOfACircleIsOneOverItsRadius();
  void EndsAreMet();
  void EveryPointIsWithinTheTolerance();
  void JointsHaveOneTangent();
  void LineNeedsOneCurve();
  void StairsAreSmoothed();
  void TwoPointsAreEnough();
  void OnePointIsRefused();
};

void BezierTest::DerivativesMatchFiniteDifferences() {
  const CubicBezier curve{{Eigen::Vector3d(0, 0, 0), {1, 2, 0}, {3, -1, 2}, {4, 0, 1}}};
  const double h = 1e-5;
  for (const double t : {0.1, 0.5, 0.8}) {
    QVERIFY((curve.derivative(t) - (curve.at(t + h) - curve.at(t - h)) / (2 * h)).norm() < 1e-8);
    QVERIFY(
        (curve.second_derivative(t) - (curve.derivative(t + h) - curve.derivative(t - h)) / (2 * h)).norm() <
        1e-7);
  }
}

void BezierTest::CurvatureOfACircleIsOneOverItsRadius() {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 60; ++i) points.emplace_back(20 * std::cos(0.025 * i), 20 * std::sin(0.025 * i), 0.0);
  const CurveChain chain = fit_curves(points, 0.02, 1.0);
  double turned = 0.0;  // the integral of the curvature is the angle of the arc
  for (const CubicBezier& curve : chain.curves)
    for (int k = 0; k < 200; ++k)
      turned += curve.curvature((k + 0.5) / 200) * curve.derivative((k + 0.5) / 200).norm() / 200;
  QVERIFY(std::abs(turned - 1.5) < 0.05);
}

void BezierTest::EndsAreMet() {
  const auto points = arc(15, 4.0, 80);
  const CurveChain chain = fit_curves(points, 0.5, 2.0);
  QVERIFY((chain.curves.front().at(0) - points.front()).norm() < 1e-12);
  QVERIFY((chain.curves.back().at(1) - points.back()).norm() < 1e-12);
  for (std::size_t i = 1; i < chain.curves.size(); ++i)
    QVERIFY((chain.curves[i].at(0) - chain.curves[i - 1].at(1)).norm() < 1e-12);
}

void BezierTest::EveryPointIsWithinTheTolerance() {
  for (const double tolerance : {0.05, 0.3, 1.0}) {
    const auto points = arc(15, 6.0, 200);
    const CurveChain chain = fit_curves(points, tolerance, 2.0);
    QCOMPARE(chain.parameters.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      QVERIFY((chain.at(chain.parameters[i]) - points[i]).norm() <= tolerance + 1e-9);
  }
  QVERIFY(fit_curves(arc(15, 6.0, 200), 0.05, 2.0).curves.size() >
          fit_curves(arc(15, 6.0, 200), 1.0, 2.0).curves.size());
}

void BezierTest::JointsHaveOneTangent() {
  const CurveChain chain = fit_curves(arc(15, 6.0, 200), 0.05, 2.0);
  QVERIFY(chain.curves.size() > 1);
  for (std::size_t i = 1; i < chain.curves.size(); ++i) {
    const Eigen::Vector3d before = chain.curves[i - 1].derivative(1).normalized(),
                          after = chain.curves[i].derivative(0).normalized();
    QVERIFY(before.cross(after).norm() < 1e-9 && before.dot(after) > 0.0);
  }
}

void BezierTest::LineNeedsOneCurve() {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 50; ++i) points.emplace_back(i, 2 * i, -i);
  const CurveChain chain = fit_curves(points, 1e-6, 3.0);
  QCOMPARE(chain.curves.size(), std::size_t{1});
  QVERIFY(chain.curves[0].curvature(0.4) < 1e-9);
}

void BezierTest::StairsAreSmoothed() {
  // Voxel centres along a slanted line: the curve's length is the line's, not the stairs'.
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 90; ++i) points.emplace_back(i, std::round(0.3 * i), 0);
  const CurveChain chain = fit_curves(points, 0.75, 4.0);
  double length = 0.0;
  for (const CubicBezier& curve : chain.curves)
    for (int k = 0; k < 50; ++k) length += (curve.at((k + 1) / 50.0) - curve.at(k / 50.0)).norm();
  QVERIFY(std::abs(length / std::hypot(90.0, 27.0) - 1.0) < 0.005);
}

void BezierTest::TwoPointsAreEnough() {
  const CurveChain chain = fit_curves({{0, 0, 0}, {3, 0, 0}}, 0.1, 1.0);
  QVERIFY((chain.curves[0].at(0.5) - Eigen::Vector3d(1.5, 0, 0)).norm() < 1e-12);
}

void BezierTest::OnePointIsRefused() {
  QVERIFY_THROWS_EXCEPTION(glisson::PreconditionError, fit_curves({{0, 0, 0}}, 0.1, 1.0));
  QVERIFY_THROWS_EXCEPTION(glisson::PreconditionError, fit_curves({{0, 0, 0}, {0, 0, 0}}, 0.1, 1.0));
}

QTEST_APPLESS_MAIN(BezierTest)
#include "bezier_test.moc"
