// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the way of a command: the first part that is missing, or where being out of date begins.
#include "glisson/engine/obstacle.h"

#include <QTest>

#include "glisson/engine/commands/accept_registration.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/choose_rival.h"
#include "glisson/engine/commands/export_surfaces.h"
#include "glisson/engine/commands/import_registration.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/register_again.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/take_registration.h"
#include "glisson/engine/commands/undo_registration.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/other_registration.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/video.h"
#include "glisson/registration/refusal.h"

using namespace glisson;
using namespace glisson::engine;

namespace {

using Kind = Obstacle::Kind;

/// A case in which a registration is current: labels -> model -> landmarks; video -> frame -> regions; rig,
/// frame, regions -> cloud.
CaseState registered_case() {
  CaseState state;
  state[part::image] = std::make_shared<Image>();
  state[part::labels] = std::make_shared<LabelMap>();
  state[part::model] = std::make_shared<model::BuiltModel>();
  state[part::landmarks] = std::make_shared<Landmarks>();
  state[part::rig] = std::make_shared<StereoRig>();
  state[part::video] = std::make_shared<VideoSource>();
  state[part::frame] = std::make_shared<StereoInput>();
  state[part::regions] = std::make_shared<stereo::Regions>();
  state[part::cloud] = std::make_shared<LabelledCloud>();
  state[part::registration] = std::make_shared<Registration>();
  state.stamp(part::image) = {1, {}};
  state.stamp(part::labels) = {2, {{part::image, 1}}};
  state.stamp(part::model) = {3, {{part::labels, 2}}};
  state.stamp(part::landmarks) = {4, {{part::model, 3}}};
  state.stamp(part::rig) = {5, {}};
  state.stamp(part::video) = {6, {}};
  state.stamp(part::frame) = {7, {{part::video, 6}}};
  state.stamp(part::regions) = {8, {{part::frame, 7}}};
  state.stamp(part::cloud) = {9, {{part::rig, 5}, {part::frame, 7}, {part::regions, 8}}};
  state.stamp(part::registration) = {10, {{part::model, 3}, {part::landmarks, 4}, {part::cloud, 9}}};
  return state;
}

}  // namespace

class ObstacleTest : public QObject {
  Q_OBJECT
 private slots:
  void NothingStandsInTheWayOfWhatIsWhole();
  void TheFirstMissingPartIsNamed();
  void BeingOutOfDateIsFollowedToWhereItBegins_data();
  void BeingOutOfDateIsFollowedToWhereItBegins();
  void WhatIsRefusedIsInTheWayUntilSomebodyAcceptsIt();
  void TheVideoIsNeededWhereItIsFollowed();
  void BelowARunningOverlayNoOtherRegistrationIsPut();
  void OneOfTwoPartsIsEnoughWhereEitherDoes();
  void ErrorsNamePartAndRemedy();
};

void ObstacleTest::NothingStandsInTheWayOfWhatIsWhole() {
  const CaseState state = registered_case();
  QVERIFY(!obstacle(state, Register{}));
  QVERIFY(!obstacle(state, StartTracking{}));
  QVERIFY(!obstacle(state, Reconstruct{}));
}

void ObstacleTest::TheFirstMissingPartIsNamed() {
  CaseState state;
  const auto first = [&](const Command& command) { return obstacle(state, command).value(); };
  QVERIFY(first(Segment{}) == (Obstacle{Kind::missing, part::image, std::nullopt}));
  QVERIFY(first(BuildModel{}) == (Obstacle{Kind::missing, part::labels, part::image}));
  QVERIFY(first(Register{}).part == Part(part::model));
  state = registered_case();
  state[part::cloud] = nullptr;
  QVERIFY(first(Register{}) == (Obstacle{Kind::missing, part::cloud, std::nullopt}));
  state[part::rig] = nullptr;
  QVERIFY(first(Register{}) == (Obstacle{Kind::missing, part::cloud, part::rig}));
  QVERIFY(first(Reconstruct{}) == (Obstacle{Kind::missing, part::rig, std::nullopt}));
}

void ObstacleTest::BeingOutOfDateIsFollowedToWhereItBegins_data() {
  QTest::addColumn<QString>("changed");
  QTest::addColumn<QString>("part");
  QTest::newRow("another CT") << "image"
                              << "labels";
  QTest::newRow("labels were edited") << "labels"
                                      << "model";
  QTest::newRow("another model") << "model"
                                 << "landmarks";
  QTest::newRow("another calibration") << "rig"
                                       << "cloud";
  QTest::newRow("another video") << "video"
                                 << "frame";
  QTest::newRow("another frame") << "frame"
                                 << "regions";
  QTest::newRow("other points") << "cloud"
                                << "registration";
}

void ObstacleTest::BeingOutOfDateIsFollowedToWhereItBegins() {
  QFETCH(QString, changed);
  QFETCH(QString, part);
  CaseState state = registered_case();
  for (const Part input : all_parts())
    if (input.code() == changed.toStdString()) state.stamp(input).revision += 100;
  const auto first = obstacle(state, StartTracking{});
  QVERIFY(first && first->kind == Kind::stale);
  QCOMPARE(QString::fromStdString(std::string(first->part.code())), part);
  QCOMPARE(QString::fromStdString(std::string(first->input->code())), changed);
  QCOMPARE(obstacle(state, Register{}).has_value(), part != "registration");
}

void ObstacleTest::WhatIsRefusedIsInTheWayUntilSomebodyAcceptsIt() {
  CaseState state = registered_case();
  Registration refused;
  refused.doubts = {registration::kRefused};
  state[part::registration] = std::make_shared<const Registration>(refused);
  const auto first = obstacle(state, StartTracking{});
  QVERIFY(first == (Obstacle{Kind::refused, part::registration, std::nullopt}));
  const std::string sentence = error_of(*first).what();
  QVERIFY2(sentence.find("registration: was refused") != std::string::npos, sentence.c_str());
  QVERIFY(!obstacle(state, AcceptRegistration{}));
  QVERIFY(!obstacle(state, ChooseRival{}));
  registration::accept_refusal(refused);
  state[part::registration] = std::make_shared<const Registration>(refused);
  QVERIFY(!obstacle(state, StartTracking{}));
}

void ObstacleTest::TheVideoIsNeededWhereItIsFollowed() {
  CaseState state = registered_case();
  StartTracking command;
  command.source = StartTracking::Source::video;
  QVERIFY(!obstacle(state, command));
  state[part::video] = nullptr;
  QVERIFY(obstacle(state, command) == (Obstacle{Kind::missing, part::video, std::nullopt}));
  command.source = StartTracking::Source::frames;
  state.stamp(part::frame).made_from.clear();  // from another source
  QVERIFY(!obstacle(state, command));
}

void ObstacleTest::BelowARunningOverlayNoOtherRegistrationIsPut() {
  CaseState state = registered_case();
  state[part::former_registration] = std::make_shared<FormerRegistration>();
  state[part::other_registration] = std::make_shared<OtherRegistration>();
  const std::vector<Command> others = {Register{}, ChooseRival{}, UndoRegistration{}, ImportRegistration{}};
  for (const Command& other : others) QVERIFY(!obstacle(state, other));
  state[part::live] = std::make_shared<LiveState>();
  for (const Command& other : others) {
    const auto first = obstacle(state, other);
    QVERIFY2(first == (Obstacle{Kind::followed, part::registration, std::nullopt}), other.code().data());
  }
  const std::string sentence = error_of(*obstacle(state, Register{})).what();
  QVERIFY2(sentence.find("Stop tracking first") != std::string::npos, sentence.c_str());
  QVERIFY_THROWS_EXCEPTION(InputError, engine::apply(state, Register{}, RunContext()));
  // What the follower learns of goes on.
  QVERIFY(!obstacle(state, RegisterAgain{}));
  QVERIFY(!obstacle(state, TakeRegistration{}));
  // Of two reasons, the one that stays when tracking has ended.
  state[part::cloud] = nullptr;
  QCOMPARE(obstacle(state, Register{})->kind, Kind::missing);
}

/// Surfaces are written of the labels or of a model, whichever there is.
void ObstacleTest::OneOfTwoPartsIsEnoughWhereEitherDoes() {
  const CaseState both = registered_case();
  QVERIFY(both.has(part::labels) && both.has(part::model));
  QVERIFY(!obstacle(both, ExportSurfaces{}));
  CaseState labels = both, model = both;
  labels[part::model] = nullptr;
  model[part::labels] = nullptr;
  QVERIFY(!obstacle(labels, ExportSurfaces{}) && !obstacle(model, ExportSurfaces{}));
  const auto first = obstacle(CaseState(), ExportSurfaces{});
  QVERIFY(first && first->kind == Kind::missing && first->part == part::labels);
}

void ObstacleTest::ErrorsNamePartAndRemedy() {
  QCOMPARE(error_of({Kind::missing, part::labels, std::nullopt}).what(),
           std::string("case: labels: there is none yet. Segment the CT or import labels first."));
  const std::string stale = error_of({Kind::stale, part::model, part::labels}).what();
  QVERIFY2(stale.find("model: is out of date: its labels changed") != std::string::npos, stale.c_str());
}

QTEST_APPLESS_MAIN(ObstacleTest)
#include "obstacle_test.moc"
