// SPDX-License-Identifier: GPL-3.0-or-later
// What comes after the shape is found asks whether it is cancelled, too: each step leaves at its first
// question.
#include <QTest>

#include "evidence.h"
#include "examine.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/next_look.h"
#include "glisson/registration/operation_prior.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

class CancelTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void TheErrorModelLeavesUnfinished();
  void UnforeseenForcesLeaveWithoutModes();
  void FindingsLeaveWithNothing();
  void LooksLeaveWithNone();
  void EvidenceStopsWhereItIs();

 private:
  ErrorModel error(const RunContext& context) const {
    return ErrorModel(model_, nullptr, {}, phantom::view(), registration_.nodes_in_camera,
                      prepare_cloud(cloud_, {}), 1e-3, {}, context);
  }

  PatientModel model_ = phantom::model(6, 5, 3);
  LabelledCloud cloud_;
  Registration registration_;
  RunContext cancelled_;
};

void CancelTest::init() {
  model_.mesh.labels[200] = structure::kFirstLesion;
  registration_.camera_from_ct = phantom::view();
  registration_.nodes_in_camera = phantom::view().apply(model_.mesh.vertices);
  cloud_ = phantom::patch(model_, registration_.nodes_in_camera, {});
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  cancelled_ = RunContext({}, flag, 1);
}

void CancelTest::TheErrorModelLeavesUnfinished() {
  QCOMPARE(error(RunContext()).expected().size(), registration_.nodes_in_camera.rows());
  QCOMPARE(error(cancelled_).expected().size(), Eigen::Index{0});
}

void CancelTest::UnforeseenForcesLeaveWithoutModes() {
  QVERIFY(unknown_operations(model_).modes.cols() > 0);
  QCOMPARE(unknown_operations(model_, {}, cancelled_).modes.cols(), Eigen::Index{0});
}

void CancelTest::FindingsLeaveWithNothing() {
  const ErrorModel known = error(RunContext());
  const Examined examined{model_, cloud_, registration_, nullptr, known};
  QVERIFY(examine(examined).has_value());
  QVERIFY(!examine(examined, cancelled_).has_value());
  QCOMPARE(known.held_out(cancelled_).distance, 0.0);
  QCOMPARE(roughness_of(prepare_cloud(cloud_, {3.9, 600, 30}), cancelled_), 0.0);
}

void CancelTest::LooksLeaveWithNone() {
  const ErrorModel known = error(RunContext());
  QCOMPARE(looks_of(model_, cloud_, registration_, known).size(), std::size_t{1});
  QVERIFY(looks_of(model_, cloud_, registration_, known, cancelled_).empty());
}

void CancelTest::EvidenceStopsWhereItIs() {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Identity(9, 9);
  const Eigen::VectorXd y = Eigen::VectorXd::LinSpaced(9, 0.1, 3.0), ones = Eigen::VectorXd::Ones(3);
  const EvidenceProblem problem(a, y, Eigen::VectorXd::Constant(9, 0.5), 3, 3, Eigen::VectorXd());
  QVERIFY(maximise_evidence(problem, ones, 5) != ones);
  QVERIFY(maximise_evidence(problem, ones, 5, 1e-9, cancelled_) == ones);
  QVERIFY(keep_worth(problem, ones, 1e9) != ones);
  QVERIFY(keep_worth(problem, ones, 1e9, cancelled_) == ones);
}

QTEST_APPLESS_MAIN(CancelTest)
#include "cancel_test.moc"
