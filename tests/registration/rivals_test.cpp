// SPDX-License-Identifier: GPL-3.0-or-later
// Other places where the organ may be: which are told, and what choosing one does.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/pairs.h"
#include "glisson/registration/refusal.h"
#include "glisson/registration/rivals.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

/// The nodes, all shifted by so many millimetres.
Points shifted(const Points& nodes, double mm) {
  return nodes.rowwise() + Eigen::RowVector3d(1e-3 * mm, 0, 0);
}

Registration with_rival(const PatientModel& model, double away_mm) {
  Registration registration;
  registration.camera_from_ct = phantom::view();
  registration.nodes_in_camera = phantom::view().apply(model.mesh.vertices);
  registration.rivals = {{shifted(registration.nodes_in_camera, away_mm), 0.2}};
  registration.forces = {{3, Eigen::Vector3d(0.1, 0, 0)}};
  registration.doubts = {"few_margin_points"};
  return registration;
}

}  // namespace

class RivalsTest : public QObject {
  Q_OBJECT
 private slots:
  void FitsOfOnePlaceCountOnce();
  void APlaceHasOneVote();
  void WhatIsFarOffIsElsewhere();
  void NearFitsShareWhatTheirPlaceHas();
  void AtMostThreeAreToldAndNoneOutOfQuestion();
  void TheChosenPlaceExplainsItsPoints();
  void ChosenTwiceTheFormerPlaceIsBack();
  void WhatIsKnownOfTheErrorTurnsWithTheChosenPlace();
  void AChosenPlaceIsDoubtedByItsOwnFit();
  void WhatTheRegistrationLeftOutOfTheCloudIsNoMisfit();
  void WhatWasRefusedStaysRefused();
  void ThereMustBeSuchAPlace();
};

void RivalsTest::FitsOfOnePlaceCountOnce() {
  const Points here = phantom::tetrahedra(2, 2, 1).vertices;
  const double even = 0.0, odds = std::log(0.5);
  const auto places = weigh_places(here,
                                   {{shifted(here, 9.0), even},
                                    {shifted(here, 38.0), odds},
                                    {shifted(here, 30.0), even},
                                    {shifted(here, -25.0), odds},
                                    {shifted(here, 33.0), even}},
                                   1.0);
  // The chosen one, 30 mm and -25 mm: 1 : 1 : 1/2.
  QCOMPARE(places.size(), std::size_t{2});
  QCOMPARE(places[0].probability, 0.4);
  QCOMPARE(places[1].probability, 0.2);
  QVERIFY(places[0].nodes_in_camera == shifted(here, 30.0));
}

void RivalsTest::APlaceHasOneVote() {
  // The paper's density, 3.9 points a cm2, on 25 mm by 25 mm: 24.375 points.
  QVERIFY(std::abs(votes_of_a_place(0.2) - 4.875) < 1e-9);
  QCOMPARE(votes_of_a_place(1e-3), 1.0);
  const Points here = phantom::tetrahedra(2, 2, 1).vertices;
  // Odds of 1 to 16 with four votes for each that is due are odds of 1 to 2.
  const auto places = weigh_places(here, {{shifted(here, 40.0), -std::log(16.0)}}, 4.0);
  QVERIFY(std::abs(places.front().probability - 1.0 / 3.0) < 1e-12);
}

void RivalsTest::WhatIsFarOffIsElsewhere() {
  const Points here = phantom::tetrahedra(2, 2, 1).vertices;
  QCOMPARE(elsewhere(here, {}), 0.0);
  QCOMPARE(
      elsewhere(here, {{shifted(here, 19.9), 0.3}, {shifted(here, 20.1), 0.2}, {shifted(here, 90), 0.1}}),
      0.2 + 0.1);
}

void RivalsTest::NearFitsShareWhatTheirPlaceHas() {
  const Points here = phantom::tetrahedra(2, 2, 1).vertices;
  const std::vector<OtherFit> fits = {{shifted(here, 4.0), 0.0},
                                      {shifted(here, 4.2), -1.0},   // the same end once more
                                      {shifted(here, 0.3), 0.0},    // the chosen one's end
                                      {shifted(here, 30.0), -1.0},  // another place
                                      {shifted(here, -6.0), std::log(0.5)}};
  const auto near = weigh_near(here, fits, 1.0);
  QCOMPARE(near.size(), std::size_t{2});
  QVERIFY(std::abs(near[0].probability - 1.0 / 2.5) < 1e-12);
  QVERIFY(std::abs(near[1].probability - 0.5 / 2.5) < 1e-12);
  QVERIFY(near[0].nodes_in_camera == fits[0].nodes_in_camera);
  QCOMPARE(weigh_places(here, fits, 1.0).size(), std::size_t{1});  // which they do not dilute
}

void RivalsTest::AtMostThreeAreToldAndNoneOutOfQuestion() {
  const Points here = phantom::tetrahedra(2, 2, 1).vertices;
  std::vector<RegistrationRival> many;
  for (int k = 5; k >= 1; --k) many.push_back({shifted(here, 10.0 * k), 0.01 * k});
  const auto told = plausible_rivals(many);
  QCOMPARE(told.size(), std::size_t{3});
  QCOMPARE(told[0].probability, 0.05);
  QVERIFY(plausible_rivals({{shifted(here, 30.0), 0.0099}}).empty());
}

void RivalsTest::TheChosenPlaceExplainsItsPoints() {
  const PatientModel model = phantom::model(6, 5, 3);
  const Registration registration = with_rival(model, 9.0);
  const LabelledCloud cloud =
      phantom::patch(model, registration.rivals[0].nodes_in_camera, {.share = 0.3, .noise = 0.0});
  const Registration chosen = choose_rival(registration, 0, model, cloud);
  QVERIFY(chosen.nodes_in_camera == registration.rivals[0].nodes_in_camera);
  QVERIFY2(chosen.residual < 1e-6, qPrintable(QString::number(chosen.residual)));
  QVERIFY(chosen.seen_share > 0.05 && chosen.seen_share < 0.6);
  QVERIFY(
      (chosen.camera_from_ct.translation - phantom::view().translation - Eigen::Vector3d(9e-3, 0, 0)).norm() <
      1e-9);
  QVERIFY(chosen.forces.empty());
  QCOMPARE(chosen.doubts, (std::vector<std::string>{"few_margin_points", "rival_chosen 20"}));
  QCOMPARE(chosen.rivals.size(), std::size_t{1});
  QVERIFY(std::abs(chosen.rivals[0].probability - 0.8) < 1e-12);
}

void RivalsTest::ChosenTwiceTheFormerPlaceIsBack() {
  const PatientModel model = phantom::model(6, 5, 3);
  const Registration registration = with_rival(model, 9.0);
  const LabelledCloud cloud = phantom::patch(model, registration.nodes_in_camera, {});
  const Registration back = choose_rival(choose_rival(registration, 0, model, cloud), 0, model, cloud);
  QVERIFY(back.nodes_in_camera == registration.nodes_in_camera);
  QVERIFY(std::abs(back.rivals[0].probability - 0.2) < 1e-12);
  QCOMPARE(back.doubts.back(), std::string("rival_chosen 80"));
  QCOMPARE(back.doubts.size(), std::size_t{2});
}

void RivalsTest::AChosenPlaceIsDoubtedByItsOwnFit() {
  const PatientModel model = phantom::model(6, 5, 3);
  const Registration registration = with_rival(model, 30.0);
  const LabelledCloud cloud = phantom::patch(model, registration.nodes_in_camera, {});
  const auto doubts = [](const Registration& chosen, const char* code) {
    return std::count(chosen.doubts.begin(), chosen.doubts.end(), code);
  };
  const Registration far = choose_rival(registration, 0, model, cloud);
  QVERIFY(far.residual > kLargeResidual);
  QCOMPARE(doubts(far, "residual_large"), 1L);
  QCOMPARE(doubts(choose_rival(far, 0, model, cloud), "residual_large"), 0L);
}

void RivalsTest::WhatTheRegistrationLeftOutOfTheCloudIsNoMisfit() {
  const PatientModel model = phantom::model(6, 5, 3);
  const Registration registration = with_rival(model, 9.0);
  LabelledCloud cloud =
      phantom::patch(model, registration.rivals[0].nodes_in_camera, {.share = 0.3, .noise = 0.0});
  const Registration sound = choose_rival(registration, 0, model, cloud);
  // Pixels without a depth, as an organised cloud has them.
  const Eigen::Index count = cloud.points.rows(), without = count / 2;
  cloud.points.conservativeResize(count + without, 3);
  cloud.points.bottomRows(without).setZero();
  cloud.normals.resize(0, 3);
  cloud.features.clear();
  cloud.sigma.clear();
  const Registration chosen = choose_rival(registration, 0, model, cloud);
  QVERIFY(std::abs(chosen.residual - sound.residual) < 1e-9);
  QCOMPARE(chosen.doubts, sound.doubts);
  // Where the cloud is one of several looks, what all of them saw is not forgotten.
  Registration of_many = registration;
  of_many.seen_share = 0.7;
  QCOMPARE(choose_rival(of_many, 0, model, cloud, true).seen_share, 0.7);
  QCOMPARE(choose_rival(of_many, 0, model, cloud).seen_share, sound.seen_share);
}

void RivalsTest::WhatWasRefusedStaysRefused() {
  const PatientModel model = phantom::model(6, 5, 3);
  Registration registration = with_rival(model, 9.0);
  registration.doubts.insert(registration.doubts.begin(), kRefused);
  const LabelledCloud cloud = phantom::patch(model, registration.nodes_in_camera, {});
  QVERIFY(is_refused(choose_rival(registration, 0, model, cloud)));
}

void RivalsTest::ThereMustBeSuchAPlace() {
  const PatientModel model = phantom::model(6, 5, 3);
  const Registration registration = with_rival(model, 9.0);
  const LabelledCloud cloud = phantom::patch(model, registration.nodes_in_camera, {});
  QVERIFY_THROWS_EXCEPTION(InputError, choose_rival(registration, 1, model, cloud));
}

void RivalsTest::WhatIsKnownOfTheErrorTurnsWithTheChosenPlace() {
  const PatientModel model = phantom::model(7, 6, 3);
  Registration registration = with_rival(model, 9.0);
  const Eigen::Matrix3d along_x = Eigen::Vector3d(9e-6, 1e-6, 1e-6).asDiagonal(),
                        along_y = Eigen::Vector3d(1e-6, 9e-6, 1e-6).asDiagonal();
  registration.lesions = {{structure::kFirstLesion, along_x}};
  registration.covariances = symmetric_row(along_x).replicate(model.mesh.vertex_count(), 1);
  Points& turned = registration.rivals[0].nodes_in_camera;  // by a quarter about the line of sight
  turned.col(0) = -registration.nodes_in_camera.col(1);
  turned.col(1) = registration.nodes_in_camera.col(0);
  const LabelledCloud cloud = phantom::patch(model, turned, {.share = 0.3, .noise = 0.0});
  const Registration chosen = choose_rival(registration, 0, model, cloud);
  QVERIFY((chosen.lesions[0].covariance - along_y).norm() < 1e-12);
  QVERIFY((chosen.covariances.row(5) - symmetric_row(along_y)).norm() < 1e-12);
  const Registration back = choose_rival(chosen, 0, model, cloud);
  QVERIFY((back.lesions[0].covariance - along_x).norm() < 1e-12);
}

QTEST_APPLESS_MAIN(RivalsTest)
#include "rivals_test.moc"
