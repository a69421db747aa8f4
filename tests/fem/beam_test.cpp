// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>

#include "beam.h"
#include "block_mesh.h"
#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

const Material kWall{620e3, 0.4};

/// A chain of equal beams along x from the origin, its first node clamped; 6-DoF nodes of its own.
class Cantilever {
 public:
  Cantilever(double length, int beams, const BeamSection& section) {
    for (int i = 0; i <= beams; ++i) {
      nodes_.emplace_back();
      nodes_.back().position = Eigen::Vector3d(length * i / beams, 0.0, 0.0);
    }
    for (int i = 0; i < beams; ++i)
      beams_.emplace_back(nodes_[static_cast<std::size_t>(i)].position,
                          nodes_[static_cast<std::size_t>(i) + 1].position, section);
  }

  /// Newton's iterations with the load (force and moment) on the tip. @return the last step's size.
  double load(const Eigen::Matrix<double, 6, 1>& tip, int iterations) {
    double size = 0.0;
    for (int n = 0; n < iterations; ++n) {
      const auto unknowns = static_cast<Eigen::Index>(6 * beams_.size());
      Eigen::MatrixXd k = Eigen::MatrixXd::Zero(unknowns, unknowns);
      Eigen::VectorXd r = Eigen::VectorXd::Zero(unknowns);
      r.tail<6>() = tip;
      for (std::size_t b = 0; b < beams_.size(); ++b) {
        const BeamElement::Rows rows = beams_[b].stiffness_rows(nodes_[b], nodes_[b + 1]);
        const Eigen::Matrix<double, 12, 12> kb = rows.transpose() * rows;
        const BeamElement::Gradient g = beams_[b].gradient(nodes_[b], nodes_[b + 1]);
        const auto at = static_cast<Eigen::Index>(6 * b);
        k.block<6, 6>(at, at) += kb.bottomRightCorner<6, 6>();
        r.segment<6>(at) -= g.tail<6>();
        if (b == 0) continue;
        k.block<6, 6>(at - 6, at - 6) += kb.topLeftCorner<6, 6>();
        k.block<6, 6>(at - 6, at) += kb.topRightCorner<6, 6>();
        k.block<6, 6>(at, at - 6) += kb.bottomLeftCorner<6, 6>();
        r.segment<6>(at - 6) -= g.head<6>();
      }
      const Eigen::VectorXd step = k.ldlt().solve(r);
      size = step.norm();
      for (std::size_t b = 0; b < beams_.size(); ++b) {
        BeamNodeState& node = nodes_[b + 1];
        node.position += step.segment<3>(static_cast<Eigen::Index>(6 * b));
        const Eigen::Vector3d spin = step.segment<3>(static_cast<Eigen::Index>(6 * b) + 3);
        if (spin.norm() > 0.0)
          node.rotation =
              Eigen::AngleAxisd(spin.norm(), spin.normalized()).toRotationMatrix() * node.rotation;
      }
    }
    return size;
  }

  const BeamNodeState& tip() const { return nodes_.back(); }

 private:
  std::vector<BeamNodeState> nodes_;
  std::vector<BeamElement> beams_;
};

BeamNodeState random_node(unsigned seed, const Eigen::Vector3d& near, double amount) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-amount, amount);
  BeamNodeState node;
  node.position = near + 0.01 * Eigen::Vector3d{uniform(random), uniform(random), uniform(random)};
  const Eigen::Vector3d spin{uniform(random), uniform(random), uniform(random)};
  node.rotation = Eigen::AngleAxisd(spin.norm(), spin.normalized()).toRotationMatrix();
  return node;
}

BeamNodeState moved(const BeamNodeState& node, int component, double h) {
  BeamNodeState result = node;
  if (component < 3)
    result.position[component] += h;
  else
    result.rotation =
        Eigen::AngleAxisd(h, Eigen::Vector3d::Unit(component - 3)).toRotationMatrix() * node.rotation;
  return result;
}

Eigen::Matrix<double, 6, 1> tip_load(int component, double value) {
  Eigen::Matrix<double, 6, 1> load = Eigen::Matrix<double, 6, 1>::Zero();
  load[component] = value;
  return load;
}

}  // namespace

class BeamTest : public QObject {
  Q_OBJECT
 private slots:
  void SectionFollowsTheBooks() {
    const BeamSection tube = BeamSection::hollow(0.004, 0.0004, kWall);
    const double area = std::numbers::pi * (16e-6 - 3.6e-3 * 3.6e-3);
    const double inertia = std::numbers::pi / 4.0 * (256e-12 - std::pow(3.6e-3, 4));
    QVERIFY(std::abs(tube.axial - 620e3 * area) < 1e-9 * tube.axial);
    QVERIFY(std::abs(tube.bending - 620e3 * inertia) < 1e-9 * tube.bending);
    QVERIFY(std::abs(tube.torsion - 620e3 / 2.8 * 2.0 * inertia) < 1e-9 * tube.torsion);
    // Cowper's limits: 6 (1 + nu) / (7 + 6 nu) for a solid circle, 2 (1 + nu) / (4 + 3 nu) for a thin tube.
    const BeamSection solid = BeamSection::hollow(0.004, 0.004, kWall);
    QVERIFY(std::abs(solid.shear / (solid.axial / 2.8) - 8.4 / 9.4) < 1e-12);
    const BeamSection thin = BeamSection::hollow(0.004, 4e-9, kWall);
    QVERIFY(std::abs(thin.shear / (thin.axial / 2.8) - 2.8 / 5.2) < 1e-5);
    QVERIFY_THROWS_EXCEPTION(PreconditionError, BeamSection::hollow(0.0, 0.1, kWall));
    QVERIFY_THROWS_EXCEPTION(PreconditionError,
                             BeamElement(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), solid));
  }

  void StiffnessAtRestIsTimoshenkosMatrix_data() {
    QTest::addColumn<double>("length");
    QTest::newRow("slender") << 0.2;
    QTest::newRow("stocky") << 0.005;
  }
  void StiffnessAtRestIsTimoshenkosMatrix() {
    QFETCH(double, length);
    const BeamSection s = BeamSection::hollow(0.004, 0.0004, kWall);
    const BeamElement beam(Eigen::Vector3d::Zero(), Eigen::Vector3d(length, 0.0, 0.0), s);
    BeamNodeState a, b;
    b.position.x() = length;
    const BeamElement::Rows rows = beam.stiffness_rows(a, b);
    const Eigen::Matrix<double, 12, 12> k = rows.transpose() * rows;
    const double l = length, phi = 12.0 * s.bending / (s.shear * l * l), c = s.bending / (1.0 + phi);
    Eigen::Matrix<double, 12, 12> expected = Eigen::Matrix<double, 12, 12>::Zero();
    const auto set = [&](int i, int j, double value) { expected(i, j) = expected(j, i) = value; };
    for (const auto& [i, stiffness] : {std::pair{0, s.axial}, std::pair{3, s.torsion}}) {
      set(i, i, stiffness / l);
      set(i + 6, i + 6, stiffness / l);
      set(i, i + 6, -stiffness / l);
    }
    // Deflections y and z with rotations z and y: z carries the opposite sign.
    for (const auto& [w, t, sign] : {std::tuple{1, 5, 1.0}, std::tuple{2, 4, -1.0}}) {
      set(w, w, 12.0 * c / (l * l * l));
      set(w + 6, w + 6, 12.0 * c / (l * l * l));
      set(w, w + 6, -12.0 * c / (l * l * l));
      set(w, t, sign * 6.0 * c / (l * l));
      set(w, t + 6, sign * 6.0 * c / (l * l));
      set(w + 6, t, -sign * 6.0 * c / (l * l));
      set(w + 6, t + 6, -sign * 6.0 * c / (l * l));
      set(t, t, (4.0 + phi) * c / l);
      set(t + 6, t + 6, (4.0 + phi) * c / l);
      set(t, t + 6, (2.0 - phi) * c / l);
    }
    QVERIFY((k - expected).cwiseAbs().maxCoeff() < 1e-12 * expected.cwiseAbs().maxCoeff());
  }

  void GradientIsTheEnergysDerivativeAtAnyRotation() {
    const BeamSection s = BeamSection::hollow(0.004, 0.0004, kWall);
    const Eigen::Vector3d p(0.001, 0.002, 0.003), q(0.009, 0.0, 0.006);
    const BeamElement beam(p, q, s);
    for (unsigned seed = 0; seed < 60; ++seed) {
      const double amount = 0.02 * (seed + 1);  // up to 2 radians between the nodes and more
      const BeamNodeState a = random_node(seed, p, amount), b = random_node(seed + 500, q, amount);
      const BeamElement::Gradient g = beam.gradient(a, b);
      for (int c = 0; c < 12; ++c) {
        const double h = c % 6 < 3 ? 1e-8 : 1e-6;
        const double high = c < 6 ? beam.energy(moved(a, c, h), b) : beam.energy(a, moved(b, c - 6, h));
        const double low = c < 6 ? beam.energy(moved(a, c, -h), b) : beam.energy(a, moved(b, c - 6, -h));
        const double scale = g.segment<3>(3 * (c / 3)).norm() + 1e-6 * g.norm();
        QVERIFY2(std::abs((high - low) / (2.0 * h) - g[c]) < 2e-6 * scale + 1e-10,
                 qPrintable(QString("seed %1 component %2").arg(seed).arg(c)));
      }
    }
  }

  void GradientRateIsTheGradientsDerivative() {
    const BeamSection s = BeamSection::hollow(0.004, 0.0004, kWall);
    const Eigen::Vector3d p(0.001, 0.002, 0.003), q(0.009, 0.0, 0.006);
    const BeamElement beam(p, q, s);
    for (unsigned seed = 0; seed < 60; ++seed) {
      // From no turn at all over small ones (another branch) to 2 radians and more between the nodes.
      const double amount = seed == 0 ? 0.0 : seed < 10 ? 1e-5 * seed : 0.02 * seed;
      const BeamNodeState a = random_node(seed, p, amount), b = random_node(seed + 500, q, amount);
      const Eigen::Matrix<double, 12, 12> rate = beam.gradient_rate(a, b);
      for (int c = 0; c < 12; ++c) {
        const double h = c % 6 < 3 ? 1e-8 : 1e-6;
        const auto at = [&](double step) {
          return c < 6 ? beam.gradient(moved(a, c, step), b) : beam.gradient(a, moved(b, c - 6, step));
        };
        const Eigen::Matrix<double, 12, 1> numeric = (at(h) - at(-h)) / (2.0 * h);
        // Forces and moments apart: newtons and newton metres differ by the length.
        for (int part = 0; part < 4; ++part) {
          const double scale = numeric.segment<3>(3 * part).norm() + 1e-3 * (part % 2 == 0 ? 1.0 : 0.01);
          QVERIFY2((rate.block<3, 1>(3 * part, c) - numeric.segment<3>(3 * part)).norm() < 2e-6 * scale,
                   qPrintable(QString("seed %1 column %2 part %3").arg(seed).arg(c).arg(part)));
        }
      }
    }
  }

  void RigidMotionLeavesNoForce() {
    const Eigen::Vector3d p(0.001, 0.002, 0.003), q(0.009, 0.0, 0.006);
    const BeamElement beam(p, q, BeamSection::hollow(0.004, 0.0004, kWall));
    for (unsigned seed = 0; seed < 20; ++seed) {
      const Eigen::Matrix3d r = random_rotation(seed);
      const BeamNodeState a{r * p + Eigen::Vector3d(1, 2, 3), r}, b{r * q + Eigen::Vector3d(1, 2, 3), r};
      QVERIFY(beam.gradient(a, b).norm() < 1e-11);
    }
  }

  void CantileversTipFollowsTimoshenko_data() {
    QTest::addColumn<double>("length");
    QTest::addColumn<int>("beams");
    QTest::newRow("thin, one beam") << 0.2 << 1;
    QTest::newRow("thin, ten beams") << 0.2 << 10;
    QTest::newRow("thick, one beam") << 0.008 << 1;
    QTest::newRow("thick, four beams") << 0.008 << 4;
  }
  void CantileversTipFollowsTimoshenko() {
    QFETCH(double, length);
    QFETCH(int, beams);
    const BeamSection s = BeamSection::hollow(0.004, 0.0004, kWall);
    const double l = length, f = 1e-8 / (l * l);  // small: the linear answer is wanted
    {
      Cantilever c(l, beams, s);
      c.load(tip_load(1, f), 3);
      const double expected = f * l * l * l / (3.0 * s.bending) + f * l / s.shear;
      QVERIFY(std::abs(c.tip().position.y() / expected - 1.0) < 1e-5);
      const double turned = f * l * l / (2.0 * s.bending);
      QVERIFY(std::abs(c.tip().rotation(1, 0) / turned - 1.0) < 1e-5);
    }
    {
      Cantilever c(l, beams, s);
      c.load(tip_load(3, 1e-7), 3);
      QVERIFY(std::abs(c.tip().rotation(2, 1) / (1e-7 * l / s.torsion) - 1.0) < 1e-6);
    }
    {
      Cantilever c(l, beams, s);
      c.load(tip_load(0, 1e-5), 3);
      QVERIFY(std::abs((c.tip().position.x() - l) / (1e-5 * l / s.axial) - 1.0) < 1e-6);
    }
  }

  void EndMomentRollsABeamIntoAnArc() {
    // A moment M on the tip bends a beam into a circle of radius E I / M, at any angle.
    const BeamSection s = BeamSection::hollow(0.004, 0.0004, kWall);
    const double length = 0.3;
    double errors[2];
    for (int refine = 0; refine < 2; ++refine) {
      Cantilever c(length, 12 << refine, s);
      const double angle = std::numbers::pi / 2.0, moment = s.bending * angle / length;
      double last = 0.0;
      for (int n = 1; n <= 10; ++n) last = c.load(tip_load(5, moment * n / 10.0), 25);
      QVERIFY(last < 1e-9);
      const double radius = length / angle;
      errors[refine] = (c.tip().position - Eigen::Vector3d(radius, radius, 0.0)).norm() / length;
      QVERIFY(std::abs(std::atan2(c.tip().rotation(1, 0), c.tip().rotation(0, 0)) - angle) < 1e-6);
    }
    QVERIFY(errors[0] < 2e-3);
    QVERIFY(errors[0] / errors[1] > 3.5);  // second order
  }
};

QTEST_APPLESS_MAIN(BeamTest)
#include "beam_test.moc"
