// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <QTest>
#include <cmath>
#include <limits>

#include "ellipsoid_mesh.h"
#include "glisson/core/error.h"
#include "glisson/fem/elastic_body.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

constexpr BodyLaw kLaws[] = {BodyLaw::linear, BodyLaw::corotational, BodyLaw::neo_hookean};

TetMesh small_block() {
  TetMesh mesh = block_mesh({2, 2, 2}, {0.04, 0.03, 0.03});
  shake(mesh, 0.003, 5);
  return mesh;
}

ElasticBody body_of(BodyLaw law, double poisson = 0.45, const TetMesh& mesh = small_block(),
                    const std::vector<int>& fixed = {}) {
  ElasticBody body(mesh, fixed);
  body.set_material({law, poisson});
  return body;
}

Eigen::VectorXd flat(const Points& p) { return Eigen::Map<const Eigen::VectorXd>(p.data(), p.size()); }

}  // namespace

class ElasticBodyTest : public QObject {
  Q_OBJECT
 private slots:
  void GradientIsDerivativeOfEnergy() {
    for (const BodyLaw law : kLaws)
      for (const double poisson : {0.3, 0.47})
        for (const double shaken : {0.001, 0.02}) {  // upright, and with inverted elements
          const ElasticBody body = body_of(law, poisson);
          Points x = bent(body.rest()) + noise(body.node_count(), shaken, 11), gradient;
          const double energy = body.energy(x, gradient);
          QCOMPARE(body.energy(x), energy);
          const double h = 1e-8;
          for (Eigen::Index k = 0; k < x.size(); k += 5) {
            const double kept = x.data()[k];
            x.data()[k] = kept + h;
            const double up = body.energy(x);
            x.data()[k] = kept - h;
            const double down = body.energy(x);
            x.data()[k] = kept;
            QVERIFY2(std::abs((up - down) / (2.0 * h) - gradient.data()[k]) < 2e-6 * gradient.norm(),
                     body_law_code(law));
          }
        }
  }

  void HessianIsDerivativeOfGradient() {
    for (const BodyLaw law : kLaws) {
      const ElasticBody body = body_of(law, 0.42);
      Points x = bent(body.rest()) + noise(body.node_count(), 0.001, 3), up, down;
      const Eigen::MatrixXd hessian = body.hessian(x, false);
      const double h = 1e-8;
      for (Eigen::Index k = 0; k < x.size(); k += 7) {
        const double kept = x.data()[k];
        x.data()[k] = kept + h;
        body.energy(x, up);
        x.data()[k] = kept - h;
        body.energy(x, down);
        x.data()[k] = kept;
        const Eigen::VectorXd numeric = flat(up - down) / (2.0 * h);
        QVERIFY2((numeric - hessian.col(k)).norm() < 2e-6 * hessian.norm(), body_law_code(law));
      }
    }
  }

  void ProjectedHessianHasNoNegativeEigenvalueAndIsTheHessianWhereThatHasNone() {
    for (const BodyLaw law : kLaws) {
      const ElasticBody body = body_of(law);
      const Points x = bent(body.rest()) + noise(body.node_count(), 0.006, 3);
      const Eigen::MatrixXd projected = body.hessian(x, true);
      QVERIFY((projected - projected.transpose()).norm() < 1e-12 * projected.norm());
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(projected, Eigen::EigenvaluesOnly);
      QVERIFY2(eigen.eigenvalues()[0] > -1e-10 * eigen.eigenvalues().maxCoeff(), body_law_code(law));
      const Points rest = body.rest();
      QVERIFY((body.hessian(rest, true) - body.hessian(rest, false)).norm() <
              1e-12 * body.hessian(rest, false).norm());
    }
  }

  void RigidMotionLeavesNoForce() {
    for (const BodyLaw law : {BodyLaw::corotational, BodyLaw::neo_hookean}) {
      const ElasticBody body = body_of(law);
      const Points moved =
          (body.rest() * random_rotation(4).transpose()).rowwise() + Eigen::RowVector3d(0.1, -0.2, 0.3);
      Points gradient, bent_gradient;
      QVERIFY(std::abs(body.energy(moved, gradient)) < 1e-18);
      body.energy(bent(body.rest()), bent_gradient);
      QVERIFY(gradient.norm() < 1e-12 * bent_gradient.norm());
    }
    // The linear law knows small turns alone; a shift leaves none there either.
    const ElasticBody body = body_of(BodyLaw::linear);
    Points gradient;
    body.energy(body.rest().rowwise() + Eigen::RowVector3d(0.1, -0.2, 0.3), gradient);
    QVERIFY(gradient.norm() < 1e-14);
  }

  void LawsAgreeForSmallStrains() {
    const Points direction = bent(body_of(BodyLaw::linear).rest()) - body_of(BodyLaw::linear).rest();
    for (const double poisson : {0.2, 0.47}) {
      Points linear, other;
      const ElasticBody reference = body_of(BodyLaw::linear, poisson);
      reference.energy(reference.rest() + 1e-5 * direction, linear);
      for (const BodyLaw law : {BodyLaw::corotational, BodyLaw::neo_hookean}) {
        body_of(law, poisson).energy(reference.rest() + 1e-5 * direction, other);
        QVERIFY2((other - linear).norm() < 1e-3 * linear.norm(), body_law_code(law));
      }
    }
  }

  void StiffnessScalesAnElementsShare() {
    const TetMesh mesh = small_block();
    std::vector<double> stiffness(static_cast<std::size_t>(mesh.tetrahedron_count()), 3.0);
    const ElasticBody stiff(mesh, {}, stiffness), soft(mesh, {});
    const Points x = bent(mesh.vertices);
    QVERIFY(std::abs(stiff.energy(x) - 3.0 * soft.energy(x)) < 1e-12 * stiff.energy(x));
  }

  void SolveIsTheInverseOfHessianAndSprings() {
    const TetMesh mesh = ellipsoid_mesh(8);
    const std::vector<int> fixed{0, 1, 5, 9};
    for (const BodyLaw law : kLaws) {
      ElasticBody body = body_of(law, 0.45, mesh, fixed);
      const Points x = bent(mesh.vertices);
      const Eigen::VectorXd springs = 0.7 * body.node_volumes();
      QVERIFY(body.factorise(x, springs));
      Eigen::MatrixXd hessian = body.hessian(x, true);
      for (int i = 0; i < body.node_count(); ++i)
        for (int c = 0; c < 3; ++c) hessian(3 * i + c, 3 * i + c) += springs[i];
      // A number of columns that fills no whole batch, some of them sparse.
      NodalColumns b = NodalColumns::Zero(3L * body.node_count(), 45);
      for (Eigen::Index k = 0; k < b.cols(); ++k)
        if (k % 3 == 0)
          b((37 * k) % b.rows(), k) = 1.0;
        else
          b.col(k) = flat(noise(body.node_count(), 1.0, static_cast<unsigned>(k)));
      for (const int node : fixed) b.middleRows<3>(3L * node).setZero();
      NodalColumns u = b;
      body.solve(u);
      NodalColumns left = hessian * u;
      for (const int node : fixed) {
        QVERIFY(u.middleRows<3>(3L * node).norm() == 0.0);
        left.middleRows<3>(3L * node).setZero();
      }
      QVERIFY2((left - b).norm() < 1e-9 * b.norm(), body_law_code(law));
      Points one(body.node_count(), 3);
      Eigen::Map<Eigen::VectorXd>(one.data(), one.size()) = b.col(1);
      QVERIFY((flat(body.solve(one)) - u.col(1)).norm() < 1e-9 * u.col(1).norm());
    }
  }

  void NumberingOfNodesIsNoMatter() {
    const TetMesh mesh = small_block();
    TetMesh turned = mesh;
    const int n = mesh.vertex_count();
    turned.vertices = mesh.vertices.colwise().reverse();
    turned.tetrahedra = (n - 1 - mesh.tetrahedra.array()).matrix();
    const Points x = bent(mesh.vertices);
    const Points y = x.colwise().reverse();
    Points gx, gy;
    const ElasticBody a(mesh, {}), b(turned, {});
    QVERIFY(std::abs(a.energy(x, gx) - b.energy(y, gy)) < 1e-12 * a.energy(x));
    QVERIFY((gx - gy.colwise().reverse()).norm() < 1e-12 * gx.norm());
  }

  void ACopyHasAFactorOfItsOwn() {
    ElasticBody body = body_of(BodyLaw::neo_hookean, 0.45, small_block(), {0, 2, 8, 20});
    QVERIFY(body.factorise(body.rest(), {}));
    ElasticBody other(body);
    other.set_material({BodyLaw::linear, 0.3});
    QVERIFY(other.factorise(other.rest(), {}));
    const Points b = noise(body.node_count(), 1.0, 2);
    const Points once = body.solve(b);
    other.solve(b);
    QVERIFY((body.solve(b).array() == once.array()).all());
  }

  void RefusesWhatCannotBear() {
    TetMesh mesh = small_block();
    QVERIFY_THROWS_EXCEPTION(InputError, ElasticBody(mesh, {-1}));
    QVERIFY_THROWS_EXCEPTION(InputError, ElasticBody(mesh, {mesh.vertex_count()}));
    QVERIFY_THROWS_EXCEPTION(InputError, ElasticBody(mesh, {}, {1.0}));
    QVERIFY_THROWS_EXCEPTION(InputError,
                             ElasticBody(mesh, {}, std::vector<double>(mesh.tetrahedra.rows(), -1.0)));
    ElasticBody body(mesh, {});
    for (const double poisson : {0.5, -1.0, std::numeric_limits<double>::quiet_NaN()})
      QVERIFY_THROWS_EXCEPTION(InputError, body.set_material({BodyLaw::linear, poisson}));
    mesh.vertices.row(mesh.tetrahedra(0, 0)) = mesh.vertices.row(mesh.tetrahedra(0, 1));
    QVERIFY_THROWS_EXCEPTION(InputError, ElasticBody(mesh, {}));
  }
};

QTEST_APPLESS_MAIN(ElasticBodyTest)
#include "elastic_body_test.moc"
