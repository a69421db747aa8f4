// SPDX-License-Identifier: GPL-3.0-or-later
// Lesions and parenchyma of a stiffness of their own: in operations, unforeseen forces, springs and forces.
#include <Eigen/Dense>
#include <QTest>
#include <cmath>
#include <set>
#include <utility>

#include "examine.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/operation_prior.h"
#include "glisson/registration/register_model.h"
#include "lying_phantom.h"

using namespace glisson;
using namespace glisson::registration;

class TissueTest : public QObject {
  Q_OBJECT
 private slots:
  void APoissonRatioThatIsGivenHoldsForForcesAndOperations();
  void initTestCase();
  void ALesionAsTheLiverChangesNoBit();
  void AStiffLesionIsStrainedLessByOperations();
  void AStiffLesionIsStrainedLessByUnforeseenForces();
  void ACirrhoticLiverIsMovedLess();
  void TheErrorModelKnowsOfIt();
  void EveryMethodKnowsOfIt_data();
  void EveryMethodKnowsOfIt();
  void WhatIsKnownOfOtherTissueIsNotTaken();

 private:
  OperationOptions options() const {
    OperationOptions options;
    options.operations = 40;
    options.gravity = 1.4;
    options.gas_pa = 120.0;
    options.bed_m = 0.009;
    return options;
  }
  OperationOptions with(double lesion) const {
    OperationOptions with = options();
    with.lesions[structure::kFirstLesion] = lesion;
    return with;
  }
  /// rms change of the lesion's edges under each mode of these columns, over that of all edges.
  double strain(const fem::NodalColumns& modes) const;
  /// rms relative change of the lesion's edges from rest to these nodes.
  double strain_to(const Points& nodes) const;
  /// Of the lesion, those that lie farthest apart.
  std::pair<int, int> far_nodes() const;

  PatientModel model_;
};

void TissueTest::initTestCase() {
  model_ = phantom::lying(7, 6, 3);
  const Eigen::RowVector3d middle = model_.mesh.vertices.colwise().mean();
  for (int t = 0; t < model_.mesh.tetrahedron_count(); ++t) {
    Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 4; ++k) centre += 0.25 * model_.mesh.vertices.row(model_.mesh.tetrahedra(t, k));
    if ((centre - middle).norm() < 0.03)
      model_.mesh.labels[static_cast<std::size_t>(t)] = structure::kFirstLesion;
  }
}

double TissueTest::strain(const fem::NodalColumns& modes) const {
  double inside = 0.0, all = 0.0;
  for (int t = 0; t < model_.mesh.tetrahedron_count(); ++t)
    for (int k = 1; k < 4; ++k) {
      const int a = model_.mesh.tetrahedra(t, 0), b = model_.mesh.tetrahedra(t, k);
      const Eigen::Vector3d edge = model_.mesh.vertex(b) - model_.mesh.vertex(a);
      const Eigen::RowVectorXd change =
          edge.transpose() * (modes.middleRows<3>(3 * b) - modes.middleRows<3>(3 * a)) / edge.squaredNorm();
      all += change.squaredNorm();
      if (is_lesion(static_cast<Label>(model_.mesh.labels[static_cast<std::size_t>(t)])))
        inside += change.squaredNorm();
    }
  return std::sqrt(inside / all);
}

double TissueTest::strain_to(const Points& nodes) const {
  double sum = 0.0;
  int edges = 0;
  for (int t = 0; t < model_.mesh.tetrahedron_count(); ++t) {
    if (!is_lesion(static_cast<Label>(model_.mesh.labels[static_cast<std::size_t>(t)]))) continue;
    for (int k = 0; k < 4; ++k)
      for (int m = 0; m < k; ++m) {
        const int a = model_.mesh.tetrahedra(t, k), b = model_.mesh.tetrahedra(t, m);
        const double rest = (model_.mesh.vertex(a) - model_.mesh.vertex(b)).norm();
        sum += std::pow((nodes.row(a) - nodes.row(b)).norm() / rest - 1.0, 2);
        ++edges;
      }
  }
  return std::sqrt(sum / edges);
}

std::pair<int, int> TissueTest::far_nodes() const {
  std::set<int> lesion;
  for (int t = 0; t < model_.mesh.tetrahedron_count(); ++t)
    if (is_lesion(static_cast<Label>(model_.mesh.labels[static_cast<std::size_t>(t)])))
      for (int k = 0; k < 4; ++k) lesion.insert(model_.mesh.tetrahedra(t, k));
  std::pair<int, int> farthest{*lesion.begin(), *lesion.begin()};
  const auto apart = [this](int a, int b) { return (model_.mesh.vertex(a) - model_.mesh.vertex(b)).norm(); };
  for (const int a : lesion)
    for (const int b : lesion)
      if (apart(a, b) > apart(farthest.first, farthest.second)) farthest = {a, b};
  return farthest;
}

void TissueTest::ALesionAsTheLiverChangesNoBit() {
  QVERIFY(simulate_operations(model_, with(3500.0), RunContext())->modes ==
          simulate_operations(model_, options(), RunContext())->modes);
  QVERIFY(unknown_operations(model_, with(3500.0)).modes == unknown_operations(model_).modes);
}

void TissueTest::AStiffLesionIsStrainedLessByOperations() {
  OperationOptions soft = options(), stiff = with(70e3);
  soft.unforeseen_m = stiff.unforeseen_m = 0.0;
  const double as_liver = strain(simulate_operations(model_, soft, RunContext())->modes),
               stiffer = strain(simulate_operations(model_, stiff, RunContext())->modes);
  QVERIFY2(stiffer < 0.5 * as_liver, qPrintable(QString("%1, %2").arg(stiffer).arg(as_liver)));
}

void TissueTest::AStiffLesionIsStrainedLessByUnforeseenForces() {
  const double as_liver = strain(unknown_operations(model_).modes),
               stiffer = strain(unknown_operations(model_, with(70e3)).modes),
               softer = strain(unknown_operations(model_, with(500.0)).modes);
  QVERIFY2(stiffer < 0.5 * as_liver, qPrintable(QString("%1, %2").arg(stiffer).arg(as_liver)));
  QVERIFY2(softer > 1.5 * as_liver, qPrintable(QString("%1, %2").arg(softer).arg(as_liver)));
}

void TissueTest::ACirrhoticLiverIsMovedLess() {
  OperationOptions cirrhotic = options();
  cirrhotic.young_modulus = 30e3;
  const double healthy = simulate_operations(model_, options(), RunContext())->mean_motion,
               stiff = simulate_operations(model_, cirrhotic, RunContext())->mean_motion;
  QVERIFY2(stiff < 0.6 * healthy, qPrintable(QString("%1, %2").arg(stiff).arg(healthy)));
}

void TissueTest::TheErrorModelKnowsOfIt() {
  const Points there = phantom::lying_view().apply(model_.mesh.vertices);
  const PreparedCloud cloud = prepare_cloud(phantom::patch(model_, there, {}), {3.9, 600, 30});
  ErrorModelOptions plain, stiff;
  stiff.stiffness = fem::stiffness_over_parenchyma(
      model_.mesh, fem::with_tissue({}, fem::tissue_from("lesion_1=70"), model_.mesh));
  // How one of its nodes may lie to another one: the place, which turns with the liver, and the distance.
  const auto [a, b] = far_nodes();
  const auto between = [&, a = a, b = b](const ErrorModelOptions& options) {
    const ErrorModel known(model_, nullptr, {}, phantom::lying_view(), there, cloud, 1e-3, options);
    const Eigen::Vector4d alone = Eigen::Vector4d::UnitX();
    const Eigen::MatrixXd apart = known.deviations(Eigen::Vector4i::Constant(a), alone) -
                                  known.deviations(Eigen::Vector4i::Constant(b), alone);
    const Eigen::RowVector3d way = (there.row(a) - there.row(b)).normalized();
    return std::pair(apart.norm(), (way * apart).norm());
  };
  const auto [place, distance] = between(plain);
  const auto [stiff_place, stiff_distance] = between(stiff);
  QVERIFY2(stiff_place < 0.95 * place, qPrintable(QString("%1, %2").arg(stiff_place).arg(place)));
  QVERIFY2(stiff_distance < 0.5 * distance, qPrintable(QString("%1, %2").arg(stiff_distance).arg(distance)));
}

void TissueTest::EveryMethodKnowsOfIt_data() {
  QTest::addColumn<int>("method");
  QTest::newRow("automatic") << static_cast<int>(Method::automatic);
  QTest::newRow("forces") << static_cast<int>(Method::forces);
  QTest::newRow("springs") << static_cast<int>(Method::springs);
  QTest::newRow("paper") << static_cast<int>(Method::paper);
}

void TissueTest::EveryMethodKnowsOfIt() {
  QFETCH(int, method);
  const OperationPrior other = phantom::simulated(model_, 40, 5);
  Eigen::VectorXd amplitudes = Eigen::VectorXd::Zero(other.modes.cols());
  amplitudes.head<2>() << 1.0, -0.8;
  const Points there = phantom::lying_view().apply(other.shape(model_.mesh.vertices, amplitudes));
  const LabelledCloud cloud = phantom::patch(model_, there, {});
  RegisterOptions plain;
  plain.method = static_cast<Method>(method);
  plain.start = RegisterOptions::Start::given;
  plain.given = phantom::lying_view();
  plain.operation = options();
  RegisterOptions same = plain, stiff = plain, soft = plain;
  same.tissue = fem::tissue_from("parenchyma=3.5,lesion_1=as_liver");
  stiff.tissue = fem::tissue_from("lesion_1=70");
  soft.tissue = fem::tissue_from("lesion_1=0.5");
  const auto nodes = [&](const RegisterOptions& options) {
    return register_model(model_, cloud, options, RunContext())->registered.registration.nodes_in_camera;
  };
  const Points healthy = nodes(plain);
  QVERIFY(nodes(same) == healthy);
  const double as_liver = strain_to(healthy), stiffer = strain_to(nodes(stiff)),
               softer = strain_to(nodes(soft));
  QVERIFY2(stiffer < 0.5 * as_liver, qPrintable(QString("%1, %2").arg(stiffer).arg(as_liver)));
  QVERIFY2(softer > 1.1 * as_liver, qPrintable(QString("%1, %2").arg(softer).arg(as_liver)));
}

void TissueTest::WhatIsKnownOfOtherTissueIsNotTaken() {
  RegisterOptions options;
  options.start = RegisterOptions::Start::given;
  options.given = phantom::lying_view();
  options.operation = this->options();
  const LabelledCloud cloud = phantom::patch(model_, phantom::lying_view().apply(model_.mesh.vertices), {});
  const KnownOperations known{options.operation,
                              std::make_shared<const OperationPrior>(
                                  simulate_operations(model_, options.operation, RunContext()).value())};
  QVERIFY(register_model(model_, cloud, options, RunContext(), known)->registered.operations == known.prior);
  options.tissue = fem::tissue_from("lesions=soft");
  QVERIFY(register_model(model_, cloud, options, RunContext(), known)->registered.operations != known.prior);
  QCOMPARE(operation_of(options, model_).lesions.at(structure::kFirstLesion), 3500.0 / 3.0);
}

void TissueTest::APoissonRatioThatIsGivenHoldsForForcesAndOperations() {
  RegisterOptions options;
  options.materials = fem::CompositeOptions();
  ContactForceOptions forces = forces_with(model_, elastic_of(options, model_), {});
  QCOMPARE(forces.poisson_ratios, ContactForceOptions().poisson_ratios);  // by evidence
  options.materials->ratio_is_given = true;
  forces = forces_with(model_, elastic_of(options, model_), {});
  QVERIFY(forces.poisson_ratios.empty());  // the usual ratio is one, too
  for (const fem::BodyMaterial& material : forces.materials)
    QCOMPARE(material.poisson_ratio, options.materials->parenchyma.poisson_ratio);
  options.materials->parenchyma.poisson_ratio = 0.3;
  forces = forces_with(model_, elastic_of(options, model_), {});
  QVERIFY(forces.poisson_ratios.empty());
  for (const fem::BodyMaterial& material : forces.materials) QCOMPARE(material.poisson_ratio, 0.3);
  QCOMPARE(operation_of(options, model_).poisson_ratio, 0.3);
  QVERIFY(!(operation_of(options, model_) == OperationOptions()));
}

QTEST_APPLESS_MAIN(TissueTest)
#include "tissue_test.moc"
