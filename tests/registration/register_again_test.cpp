// SPDX-License-Identifier: GPL-3.0-or-later
// Registered once more, with tissue that was seen later.
#include "glisson/registration/register_again.h"

#include <QTest>
#include <algorithm>

#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

class RegisterAgainTest : public QObject {
  Q_OBJECT
 private slots:
  void AWrongOneBecomesBetterByWhatNeitherHasUsed();
  void ARightOneIsNotReplacedByChance();
  void NewDoubtsAreNotTakenUnseen();
  void TissueShowsItsFaceToWhereItWasSeenFrom();
  void TheFirstCloudsMarksTakePart();
  void LittleTissueOrAForeignStartIsRefused();
  void CancelGivesNothing();

 private:
  Registration at(const CameraFromCt& pose) const {
    Registration made;
    made.camera_from_ct = pose;
    made.nodes_in_camera = pose.apply(model_.mesh.vertices);
    return made;
  }
  static CameraFromCt off(double x, double y, double z) {
    CameraFromCt pose = phantom::view();
    pose.translation += Eigen::Vector3d(x, y, z);
    return pose;
  }
  static RegisterOptions plain() {
    RegisterOptions options;
    options.operations = false;
    return options;
  }
  LabelledCloud seen(unsigned seed, double noise = 0.5e-3) const {
    return phantom::patch(model_, truth_, {.share = 0.3, .noise = noise, .seed = seed});
  }
  LabelledCloud tissue(double noise = 0.5e-3) const {
    LabelledCloud cloud;
    cloud.points = seen(7, noise).points;
    return cloud;
  }
  double error(const Registration& made) const { return point_errors(made.nodes_in_camera, truth_).mean; }

  PatientModel model_ = phantom::model(8, 6, 3);
  Points truth_ = phantom::view().apply(model_.mesh.vertices);
};

void RegisterAgainTest::AWrongOneBecomesBetterByWhatNeitherHasUsed() {
  const Registration wrong = at(off(8e-3, -5e-3, 6e-3));
  const auto again = register_again(model_, seen(1), tissue(), wrong, plain(), RunContext());
  QVERIFY(again->is_better);
  QVERIFY(again->kept_out > 20);
  QVERIFY2(again->gap < 0.5 * again->former_gap,
           qPrintable(QString("%1 of %2").arg(1e3 * again->gap).arg(1e3 * again->former_gap)));
  const double after = error(again->examined.registered.registration);
  QVERIFY2(after < 0.3 * error(wrong), qPrintable(QString::number(1e3 * after)));
  QVERIFY(std::abs(again->moved - error(wrong)) < 3e-3);
}

void RegisterAgainTest::ARightOneIsNotReplacedByChance() {
  // The truth itself: no registration lies nearer to what was kept out but by luck.
  const auto again = register_again(model_, seen(1), tissue(), at(phantom::view()), plain(), RunContext());
  QVERIFY2(!again->is_better,
           qPrintable(QString("%1, %2").arg(1e3 * again->gap).arg(1e3 * again->former_gap)));
}

void RegisterAgainTest::NewDoubtsAreNotTakenUnseen() {
  const Registration wrong = at(off(8e-3, -5e-3, 6e-3));
  LabelledCloud unmarked = seen(1);
  unmarked.features.clear();
  const auto again = register_again(model_, unmarked, tissue(), wrong, plain(), RunContext());
  QVERIFY(!again->examined.registered.registration.doubts.empty());
  QVERIFY(!again->is_better);  // no_notch, say: the former had none
  Registration doubted = wrong;
  doubted.doubts = again->examined.registered.registration.doubts;
  const auto once_more = register_again(model_, unmarked, tissue(), doubted, plain(), RunContext());
  QVERIFY(once_more->is_better);
}

void RegisterAgainTest::TissueShowsItsFaceToWhereItWasSeenFrom() {
  // The scope went round to the organ's other side: there the first camera sees nothing of it.
  const Eigen::Vector3d middle = truth_.colwise().mean().transpose();
  Rigid<CameraFrame, CameraFrame> round;  // into the second camera's frame, about the organ
  round.rotation = rotation_by({0.0, 2.4, 0.0});
  round.translation = middle - round.rotation * middle;
  LabelledCloud there;
  there.points =
      round.inverse().apply(phantom::patch(model_, round.apply(truth_), {.share = 0.4, .seed = 7}).points);
  there.seen_from = round.inverse().translation.transpose().replicate(there.points.rows(), 1);
  const Registration wrong = at(off(8e-3, -5e-3, 6e-3));
  const auto doubts_turned = [](const RegisteredAgain& again) {
    const auto& doubts = again.examined.registered.registration.doubts;
    return std::any_of(doubts.begin(), doubts.end(),
                       [](const std::string& doubt) { return doubt.starts_with("points_turned"); });
  };
  const auto again = register_again(model_, seen(1), there, wrong, plain(), RunContext());
  QVERIFY(!doubts_turned(*again));
  QVERIFY(again->is_better);
  QVERIFY2(error(again->examined.registered.registration) < 0.3 * error(wrong),
           qPrintable(QString::number(1e3 * error(again->examined.registered.registration))));
  there.seen_from.resize(0, 3);  // as if the first camera had seen it
  QVERIFY(doubts_turned(*register_again(model_, seen(1), there, wrong, plain(), RunContext())));
}

void RegisterAgainTest::TheFirstCloudsMarksTakePart() {
  const Registration wrong = at(off(6e-3, 0.0, 0.0));
  const auto with = register_again(model_, seen(1), tissue(), wrong, plain(), RunContext());
  const auto without = register_again(model_, {}, tissue(), wrong, plain(), RunContext());
  QVERIFY(with->examined.findings.margin_off < 4e-3 && with->examined.findings.notch_off < 6e-3);
  QVERIFY(std::isnan(without->examined.findings.margin_off));
}

void RegisterAgainTest::LittleTissueOrAForeignStartIsRefused() {
  const Registration former = at(phantom::view());
  LabelledCloud few;
  few.points = tissue().points.topRows(29);
  QVERIFY_THROWS_EXCEPTION(InputError, register_again(model_, seen(1), few, former, plain(), RunContext()));
  Registration foreign = former;
  foreign.nodes_in_camera.conservativeResize(3, 3);
  QVERIFY_THROWS_EXCEPTION(InputError,
                           register_again(model_, seen(1), tissue(), foreign, plain(), RunContext()));
}

void RegisterAgainTest::CancelGivesNothing() {
  auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  const RunContext cancelled({}, cancel, 1);
  QVERIFY(!register_again(model_, seen(1), tissue(), at(phantom::view()), plain(), cancelled));
}

QTEST_APPLESS_MAIN(RegisterAgainTest)
#include "register_again_test.moc"
