// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/case_state.h"

#include <QtTest>
#include <set>
#include <string_view>

#include "glisson/core/error.h"
#include "glisson/engine/commands.h"

using namespace glisson;
using namespace glisson::engine;

class CaseStateTest : public QObject {
  Q_OBJECT
 private slots:
  void EveryPartCanBeTakenAndTold();
  void APartIsStaleWhenAnInputChanges();
  void StalenessIsHandedOn();
  void LandmarksOfAPersonReplaceTheModels();
  void LandmarksNeedAModel();
  void NoTwoCommandsThatTouchTheSamePartAreIndependent();
};

void CaseStateTest::EveryPartCanBeTakenAndTold() {
  CaseState full;
  full.image = std::make_shared<Image>();
  full.seeds = std::make_shared<segmentation::Seeds>();
  full.labels = std::make_shared<LabelMap>();
  full.review = std::make_shared<Review>();
  full.preview = std::make_shared<EditPreview>();
  full.model = std::make_shared<model::BuiltModel>();
  full.check = std::make_shared<ModelCheck>();
  full.landmarks = std::make_shared<Landmarks>();
  full.rig = std::make_shared<StereoRig>();
  full.video = std::make_shared<VideoSource>();
  full.frame = std::make_shared<StereoInput>();
  full.regions = std::make_shared<stereo::Regions>();
  full.cloud = std::make_shared<LabelledCloud>();
  full.registration = std::make_shared<Registration>();
  full.live = std::make_shared<LiveState>();
  std::set<std::string_view> codes;
  for (int i = 0; i < kPartCount; ++i) {
    const Part part = static_cast<Part>(i);
    QVERIFY(full.has(part));
    CaseState one;
    QVERIFY(!one.has(part));
    one.take(part, full);
    QVERIFY(one.has(part) && one.shares(part, full));
    for (int k = 0; k < kPartCount; ++k) QCOMPARE(one.has(static_cast<Part>(k)), k == i);
    codes.insert(part_code(part));
  }
  QCOMPARE(static_cast<int>(codes.size()), kPartCount);
}

void CaseStateTest::APartIsStaleWhenAnInputChanges() {
  CaseState state;
  QCOMPARE(stage_state(state, Part::labels), StageState::absent);
  state.image = std::make_shared<Image>();
  state.stamp(Part::image).revision = 3;
  state.labels = std::make_shared<LabelMap>();
  state.stamp(Part::labels) = {4, {{Part::image, 3}}};
  QCOMPARE(stage_state(state, Part::labels), StageState::current);
  state.stamp(Part::image).revision = 5;
  QCOMPARE(stage_state(state, Part::labels), StageState::stale);
}

void CaseStateTest::StalenessIsHandedOn() {
  CaseState state;
  state.image = std::make_shared<Image>();
  state.labels = std::make_shared<LabelMap>();
  state.model = std::make_shared<model::BuiltModel>();
  state.stamp(Part::image).revision = 9;
  state.stamp(Part::labels) = {4, {{Part::image, 3}}};
  state.stamp(Part::model) = {5, {{Part::labels, 4}}};
  QCOMPARE(stage_state(state, Part::model), StageState::stale);
}

void CaseStateTest::LandmarksOfAPersonReplaceTheModels() {
  CaseState state;
  auto built = std::make_shared<model::BuiltModel>();
  built->model.landmarks.anterior_margin = Points::Constant(3, 3, 1.0);
  built->model.landmarks.vena_cava = Points::Constant(2, 3, 2.0);
  state.model = built;
  auto placed = std::make_shared<Landmarks>();
  placed->umbilical_notch = Points::Constant(1, 3, 3.0);
  placed->vena_cava = Points::Constant(4, 3, 4.0);
  state.landmarks = placed;
  const Landmarks landmarks = effective_model(state).landmarks;
  QCOMPARE(landmarks.anterior_margin.rows(), Eigen::Index{3});
  QCOMPARE(landmarks.umbilical_notch.rows(), Eigen::Index{1});
  QCOMPARE(landmarks.vena_cava.rows(), Eigen::Index{4});
}

void CaseStateTest::LandmarksNeedAModel() {
  QVERIFY_EXCEPTION_THROWN(effective_landmarks(CaseState()), PreconditionError);
}

void CaseStateTest::NoTwoCommandsThatTouchTheSamePartAreIndependent() {
  QVERIFY(writes(BuildModel{}).meets(reads(Register{})));
  QVERIFY(writes(SetRegions{}).meets(reads(Reconstruct{})));
  QVERIFY(writes(OpenCase{}) == Parts::all());
  QVERIFY(!writes(SetSeeds{}).meets(reads(BuildModel{}) | writes(BuildModel{})));
  QVERIFY(!reads(SaveCase{}).has(Part::live));
}

QTEST_APPLESS_MAIN(CaseStateTest)
#include "case_state_test.moc"
