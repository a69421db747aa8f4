// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Eigenvalues>
#include <QTest>
#include <cmath>

#include "block_mesh.h"
#include "membrane.h"
#include "polar.h"
#include "tetrahedron.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

const Material kLiver{3500.0, 0.45};

Eigen::Matrix3d random_matrix(unsigned seed, double noise_size) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-noise_size, noise_size);
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 9; ++i) m(i) += uniform(random);
  return random_rotation(seed + 1000) * m;
}

Tetrahedron sample_tetrahedron(const Material& material = kLiver) {
  Eigen::Matrix<double, 3, 4> rest;
  rest << 0.0, 0.011, 0.002, 0.001, 0.0, 0.001, 0.009, 0.002, 0.0, -0.001, 0.001, 0.012;
  return Tetrahedron({0, 1, 2, 3}, rest, material);
}

/// The force's derivative by central differences of the stress.
Eigen::Matrix<double, 12, 12> numeric_tangent(const Tetrahedron& e, TetrahedronLaw law,
                                              const Eigen::Matrix3d& f) {
  Eigen::Matrix<double, 12, 12> k;
  const double h = 1e-8;  // metres, on an element of 10 mm
  for (int n = 0; n < 4; ++n)
    for (int c = 0; c < 3; ++c) {
      const Eigen::Matrix3d step = h * Eigen::Vector3d::Unit(c) * e.gradients.col(n).transpose();
      const Eigen::Matrix<double, 3, 4> difference =
          e.volume * (stress(e, law, f + step) - stress(e, law, f - step)) * e.gradients / (2.0 * h);
      k.col(3 * n + c) = Eigen::Map<const Eigen::Matrix<double, 12, 1>>(difference.data());
    }
  return k;
}

}  // namespace

class ElementsTest : public QObject {
  Q_OBJECT
 private slots:
  void PolarRotationIsTheNearestOne() {
    for (unsigned seed = 0; seed < 300; ++seed) {
      // From near the identity to anything, inverted ones included.
      const Eigen::Matrix3d f = random_matrix(seed, 0.01 * (seed + 1));
      const Polar p = polar_decomposition(f);
      QVERIFY((p.rotation.transpose() * p.rotation - Eigen::Matrix3d::Identity()).norm() < 1e-13);
      QVERIFY(p.rotation.determinant() > 0.0);
      QVERIFY((p.rotation * p.stretch - f).norm() < 1e-12 * f.norm());
      QVERIFY((p.stretch - p.stretch.transpose()).norm() < 1e-13 * f.norm());
      QVERIFY(std::abs(p.determinant - f.determinant()) < 1e-12);
      for (unsigned other = 0; other < 20; ++other)
        QVERIFY((random_rotation(other) - f).norm() >= (p.rotation - f).norm() - 1e-12);
    }
  }

  void PolarSurvivesDegenerateMatrices() {
    Eigen::Matrix3d flat = Eigen::Matrix3d::Identity();
    flat(2, 2) = 0.0;
    Eigen::Matrix3d line = Eigen::Matrix3d::Zero();
    line(1, 0) = 2.0;
    for (const Eigen::Matrix3d& f :
         {flat, line, Eigen::Matrix3d(Eigen::Matrix3d::Zero()), Eigen::Matrix3d(-Eigen::Matrix3d::Identity()),
          Eigen::Matrix3d(1e-200 * flat), Eigen::Matrix3d(1e8 * line)}) {
      const Polar p = polar_decomposition(f);
      QVERIFY((p.rotation.transpose() * p.rotation - Eigen::Matrix3d::Identity()).norm() < 1e-13);
      QVERIFY(p.rotation.determinant() > 0.0);
      QVERIFY((p.rotation * p.stretch - f).norm() <= 1e-13 * f.norm());
      QVERIFY(rotation_rate(p).allFinite());
    }
    QVERIFY(!polar_decomposition(Eigen::Matrix3d::Constant(std::nan(""))).stretch.allFinite());
  }

  void PlanePolarIsAFrameTimesAStretch() {
    for (unsigned seed = 0; seed < 200; ++seed) {
      Eigen::Matrix<double, 3, 2> f = random_matrix(seed, 0.01 * seed).leftCols<2>();
      if (seed % 10 == 0) f.col(1) = 0.5 * f.col(0);  // collapsed to a line
      if (seed == 50) f.setZero();
      const PlanePolar p = plane_polar_decomposition(f);
      QVERIFY((p.rotation.transpose() * p.rotation - Eigen::Matrix2d::Identity()).norm() < 1e-12);
      QVERIFY((p.rotation * p.stretch - f).norm() <= 1e-12 * f.norm());
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(p.stretch);
      QVERIFY(eigen.eigenvalues()[0] >= -1e-13);
    }
  }

  void RotationRateIsTheRotationsDerivative() {
    for (unsigned seed = 0; seed < 50; ++seed) {
      const Eigen::Matrix3d f = random_matrix(seed, 0.4);
      if (f.determinant() < 0.1) continue;
      const Polar p = polar_decomposition(f);
      const Eigen::Matrix3d df = random_matrix(seed + 7, 1.0), g = df * Eigen::Matrix3d::Identity();
      // axial of sum_i (Q grad N_i) x dx_i for dF = sum_i dx_i grad N_i^T: column by column.
      Eigen::Vector3d axial = Eigen::Vector3d::Zero();
      for (int c = 0; c < 3; ++c) axial += p.rotation.col(c).cross(Eigen::Vector3d(g.col(c)));
      const Eigen::Vector3d spin = rotation_rate(p) * axial;
      const double h = 1e-6;
      const Eigen::Matrix3d turn =
          (polar_decomposition(f + h * df).rotation - polar_decomposition(f - h * df).rotation) / (2.0 * h) *
          p.rotation.transpose();
      const Eigen::Vector3d numeric(turn(2, 1), turn(0, 2), turn(1, 0));
      QVERIFY((spin - numeric).norm() < 1e-7 * (1.0 + numeric.norm()));
    }
  }

  void TetrahedronsForceIsThePapers() {
    // R^T K0 (R x - x0) with K0 = V B^T D B in Voigt's notation, R = Q^T: eq. 3 as fem's README reads it.
    const Tetrahedron e = sample_tetrahedron();
    Eigen::Matrix<double, 6, 12> b = Eigen::Matrix<double, 6, 12>::Zero();
    for (int n = 0; n < 4; ++n) {
      const Eigen::Vector3d g = e.gradients.col(n);
      b.block<6, 3>(0, 3 * n) << g.x(), 0, 0, 0, g.y(), 0, 0, 0, g.z(), g.y(), g.x(), 0, 0, g.z(), g.y(),
          g.z(), 0, g.x();
    }
    const double nu = kLiver.poisson_ratio;
    const double factor = kLiver.young_modulus / ((1.0 + nu) * (1.0 - 2.0 * nu));
    Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
    d.topLeftCorner<3, 3>().setConstant(factor * nu);
    d.diagonal() << 1 - nu, 1 - nu, 1 - nu, 0.5 - nu, 0.5 - nu, 0.5 - nu;
    d.diagonal() *= factor;
    const Eigen::Matrix<double, 12, 12> k0 = e.volume * b.transpose() * d * b;
    Eigen::Matrix<double, 3, 4> rest;
    rest << 0.0, 0.011, 0.002, 0.001, 0.0, 0.001, 0.009, 0.002, 0.0, -0.001, 0.001, 0.012;
    for (unsigned seed = 0; seed < 20; ++seed) {
      const Eigen::Matrix3d f = random_matrix(seed, 0.3);
      const Eigen::Matrix<double, 3, 4> x = f * rest;
      const Eigen::Matrix3d q = polar_decomposition(f).rotation;
      const Eigen::Matrix<double, 3, 4> local = q.transpose() * x - rest;
      const Eigen::Matrix<double, 12, 1> u = Eigen::Map<const Eigen::Matrix<double, 12, 1>>(local.data());
      const Eigen::Matrix<double, 12, 1> k0u = k0 * u;
      const Eigen::Matrix<double, 3, 4> expected =
          q * Eigen::Map<const Eigen::Matrix<double, 3, 4>>(k0u.data());
      const Eigen::Matrix<double, 3, 4> force =
          e.volume * stress(e, TetrahedronLaw::corotational, f) * e.gradients;
      QVERIFY((force - expected).norm() < 1e-11 * expected.norm());
      // And R^T K0 R is the rotated tangent.
      Eigen::Matrix<double, 12, 12> turn = Eigen::Matrix<double, 12, 12>::Zero();
      for (int n = 0; n < 4; ++n) turn.block<3, 3>(3 * n, 3 * n) = q;
      const Eigen::Matrix<double, 12, 12> rotated = turn * k0 * turn.transpose();
      QVERIFY((tangent(e, TetrahedronLaw::corotational, f, Tangent::rotated) - rotated).norm() <
              1e-11 * rotated.norm());
    }
  }

  void ExactTangentIsTheForcesDerivative_data() {
    QTest::addColumn<bool>("neo_hookean");
    QTest::newRow("corotational") << false;
    QTest::newRow("neo-Hookean") << true;
  }
  void ExactTangentIsTheForcesDerivative() {
    QFETCH(bool, neo_hookean);
    const TetrahedronLaw law = neo_hookean ? TetrahedronLaw::neo_hookean : TetrahedronLaw::corotational;
    const Tetrahedron e = sample_tetrahedron();
    int inverted = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
      const Eigen::Matrix3d f = random_matrix(seed, 0.02 * seed);
      // Where two stretches cancel the co-rotational law has a kink; there the tangent is a bounded stand-in.
      Eigen::Matrix3d u, v;
      Eigen::Vector3d s;
      rotation_svd(f, u, s, v);
      if (s[1] + s[2] < 0.1) continue;
      inverted += f.determinant() < 0.0;
      const Eigen::Matrix<double, 12, 12> exact = tangent(e, law, f, Tangent::exact);
      const Eigen::Matrix<double, 12, 12> numeric = numeric_tangent(e, law, f);
      QVERIFY2((exact - numeric).norm() < 1e-6 * numeric.norm(), qPrintable(QString::number(seed)));
      const Eigen::Matrix<double, 12, 12> projected = tangent(e, law, f, Tangent::projected);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(projected);
      QVERIFY(eigen.eigenvalues()[0] > -1e-12 * eigen.eigenvalues()[11]);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> difference(projected - exact);
      QVERIFY(difference.eigenvalues()[0] > -1e-9 * eigen.eigenvalues()[11]);
    }
    QVERIFY(inverted > 3);
    // At rest all three agree, and with linear elasticity: both laws see the same small strains.
    const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity();
    const auto linear = tangent(e, TetrahedronLaw::corotational, rest, Tangent::rotated);
    for (const Tangent kind : {Tangent::projected, Tangent::exact})
      QVERIFY((tangent(e, law, rest, kind) - linear).norm() < 1e-10 * linear.norm());
  }

  void MembranesExactTangentIsTheForcesDerivative() {
    Eigen::Matrix3d rest;
    rest << 0.0, 0.01, 0.003, 0.0, 0.001, 0.008, 0.0, 0.002, -0.001;
    const Membrane e({0, 1, 2}, rest, {8e6, 0.45}, 20e-6);
    for (unsigned seed = 0; seed < 50; ++seed) {
      const Eigen::Matrix<double, 3, 2> f = random_matrix(seed, 0.006 * seed).leftCols<2>();
      Eigen::Matrix<double, 9, 9> numeric;
      const double h = 1e-8;
      for (int n = 0; n < 3; ++n)
        for (int c = 0; c < 3; ++c) {
          const Eigen::Matrix<double, 3, 2> step =
              h * Eigen::Vector3d::Unit(c) * e.gradients.col(n).transpose();
          const Eigen::Matrix3d difference =
              e.volume * (stress(e, f + step) - stress(e, f - step)) * e.gradients / (2.0 * h);
          numeric.col(3 * n + c) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(difference.data());
        }
      const auto exact = tangent(e, f, Tangent::exact);
      QVERIFY2((exact - numeric).norm() < 1e-6 * numeric.norm(), qPrintable(QString::number(seed)));
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(tangent(e, f, Tangent::projected));
      QVERIFY(eigen.eigenvalues()[0] > -1e-12 * eigen.eigenvalues()[8]);
    }
  }

  void MembranePatchInTensionFollowsEh() {
    // Uniaxial tension in the plane, turned somehow in space: E h strain newtons a metre of width, nothing
    // across.
    const Material capsule{8e6, 0.45};
    Eigen::Matrix3d rest;
    rest << 0.0, 0.01, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.0;
    const Membrane e({0, 1, 2}, rest, capsule, 20e-6);
    const double strain = 0.07;
    Eigen::Matrix<double, 3, 2> f = Eigen::Matrix<double, 3, 2>::Zero();
    f(0, 0) = 1.0 + strain;
    f(1, 1) = 1.0 - capsule.poisson_ratio * strain;
    const Eigen::Matrix3d turn = random_rotation(4);
    const Eigen::Matrix<double, 3, 2> p = turn.transpose() * stress(e, turn * f);
    QVERIFY(std::abs(p(0, 0) * 20e-6 - 8e6 * 20e-6 * strain) < 1e-9);
    QVERIFY(p.col(1).norm() * 20e-6 < 1e-9);
  }

  void NeoHookeanUniaxialFollowsTheClosedForm() {
    // The density of Smith et al. 2018, eq. 14, as a function of the stretches; the lateral stretch minimises
    // it; the axial stress is the minimum's derivative.
    const Tetrahedron e = sample_tetrahedron();
    const double mu = 4.0 / 3.0 * e.mu, lambda = e.lambda + 5.0 / 6.0 * e.mu;
    const double alpha = 1.0 + mu / lambda - mu / (4.0 * lambda);
    const auto density = [&](double a, double b) {
      const double ic = a * a + 2.0 * b * b, j = a * b * b;
      return 0.5 * mu * (ic - 3.0) + 0.5 * lambda * (j - alpha) * (j - alpha) - 0.5 * mu * std::log(ic + 1.0);
    };
    const auto lateral = [&](double a) {
      double low = 0.3, high = 2.0;
      for (int n = 0; n < 200; ++n) {
        const double p = low + (high - low) / 3.0, q = high - (high - low) / 3.0;
        (density(a, p) < density(a, q) ? high : low) = density(a, p) < density(a, q) ? q : p;
      }
      return 0.5 * (low + high);
    };
    for (const double a : {0.6, 0.9, 1.1, 1.5, 2.0}) {
      const double b = lateral(a), h = 1e-4;
      const double axial = (density(a + h, lateral(a + h)) - density(a - h, lateral(a - h))) / (2.0 * h);
      const Eigen::Matrix3d f = Eigen::Vector3d(a, b, b).asDiagonal();
      const Eigen::Matrix3d p = stress(e, TetrahedronLaw::neo_hookean, f);
      QVERIFY(std::abs(p(0, 0) - axial) < 1e-4 * kLiver.young_modulus);
      // The minimum is found to the square root of round-off.
      QVERIFY(std::abs(p(1, 1)) < 1e-3 * kLiver.young_modulus);
    }
    // Small strains: Young's modulus and Poisson's ratio.
    const double strain = 1e-4;
    const Eigen::Matrix3d f =
        Eigen::Vector3d(1.0 + strain, 1.0 - 0.45 * strain, 1.0 - 0.45 * strain).asDiagonal();
    const Eigen::Matrix3d p = stress(e, TetrahedronLaw::neo_hookean, f);
    QVERIFY(std::abs(p(0, 0) / strain - 3500.0) < 5.0);
    QVERIFY(std::abs(p(1, 1) / strain) < 5.0);
  }

  void NeoHookeanFollowsYoungAndPoissonFromZeroOn() {
    // The law has a term of volume of its own (lambda + 5/6 mu): a ratio of 0 is no exception.
    for (const double ratio : {0.0, 0.2, 0.45, 0.49}) {
      CompositeOptions options;
      options.law = TetrahedronLaw::neo_hookean;
      options.parenchyma.poisson_ratio = ratio;
      options.validate();
      const Tetrahedron e = sample_tetrahedron(options.parenchyma);
      const double strain = 1e-5, narrows = -ratio * strain;
      const Eigen::Matrix3d f = Eigen::Vector3d(1.0 + strain, 1.0 + narrows, 1.0 + narrows).asDiagonal();
      const Eigen::Matrix3d p = stress(e, TetrahedronLaw::neo_hookean, f);
      QVERIFY(std::abs(p(0, 0) / strain - 3500.0) < 5.0);
      QVERIFY(std::abs(p(1, 1) / strain) < 5.0 && std::abs(p(2, 2) / strain) < 5.0);
    }
  }

  void VonMisesOfUniaxialTensionIsTheTension() {
    const Tetrahedron e = sample_tetrahedron();
    const Eigen::Matrix3d f = Eigen::Vector3d(1.01, 1.0 - 0.0045, 1.0 - 0.0045).asDiagonal();
    QVERIFY(std::abs(von_mises(e, TetrahedronLaw::corotational, random_rotation(3) * f) - 35.0) < 1e-9);
    QVERIFY(std::abs(von_mises(e, TetrahedronLaw::neo_hookean, random_rotation(3) * f) - 35.0) < 0.8);
  }
};

QTEST_APPLESS_MAIN(ElementsTest)
#include "elements_test.moc"
