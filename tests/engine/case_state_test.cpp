// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/case_state.h"

#include <QTest>
#include <set>
#include <string_view>

#include "glisson/core/error.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/keeping.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/moments.h"
#include "glisson/engine/parts/named_video.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/parts/operations.h"
#include "glisson/engine/parts/other_registration.h"
#include "glisson/engine/parts/preview.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/review.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/parts/source.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/engine/parts/video.h"

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
  full[part::image] = std::make_shared<Image>();
  full[part::source] = std::make_shared<DicomSource>();
  full[part::seeds] = std::make_shared<segmentation::Seeds>();
  full[part::labels] = std::make_shared<LabelMap>();
  full[part::review] = std::make_shared<Review>();
  full[part::locks] = std::make_shared<std::set<Label>>();
  full[part::preview] = std::make_shared<EditPreview>();
  full[part::offer] = std::make_shared<SegmentationOffer>();
  full[part::model] = std::make_shared<model::BuiltModel>();
  full[part::check] = std::make_shared<ModelCheck>();
  full[part::landmarks] = std::make_shared<Landmarks>();
  full[part::proposals] = std::make_shared<atlas::Transfer>();
  full[part::rig] = std::make_shared<StereoRig>();
  full[part::video] = std::make_shared<VideoSource>();
  full[part::named_video] = std::make_shared<VideoSource>();
  full[part::frame] = std::make_shared<StereoInput>();
  full[part::regions] = std::make_shared<stereo::Regions>();
  full[part::cloud] = std::make_shared<LabelledCloud>();
  full[part::earlier_looks] = std::make_shared<EarlierLooks>();
  full[part::tissue] = std::make_shared<fem::Tissue>();
  full[part::former_registration] = std::make_shared<FormerRegistration>();
  full[part::operations] = std::make_shared<SimulatedOperations>();
  full[part::registration] = std::make_shared<Registration>();
  full[part::live] = std::make_shared<LiveState>();
  full[part::moments] = std::make_shared<KeptMoments>();
  full[part::other_registration] = std::make_shared<OtherRegistration>();
  full[part::keeping] = std::make_shared<Keeping>();
  std::set<std::string_view> codes;
  for (const Part part : all_parts()) {
    QVERIFY2(full.has(part), std::string(part.code()).c_str());
    CaseState one;
    QVERIFY(!one.has(part));
    one.take(part, full);
    QVERIFY(one.has(part) && one.shares(part, full));
    for (const Part other : all_parts()) QCOMPARE(one.has(other), other == part);
    codes.insert(part.code());
  }
  QCOMPARE(codes.size(), all_parts().size());
}

void CaseStateTest::APartIsStaleWhenAnInputChanges() {
  CaseState state;
  QCOMPARE(stage_state(state, part::labels), StageState::absent);
  state[part::image] = std::make_shared<Image>();
  state.stamp(part::image).revision = 3;
  state[part::labels] = std::make_shared<LabelMap>();
  state.stamp(part::labels) = {4, {{part::image, 3}}};
  QCOMPARE(stage_state(state, part::labels), StageState::current);
  state.stamp(part::image).revision = 5;
  QCOMPARE(stage_state(state, part::labels), StageState::stale);
}

void CaseStateTest::StalenessIsHandedOn() {
  CaseState state;
  state[part::image] = std::make_shared<Image>();
  state[part::labels] = std::make_shared<LabelMap>();
  state[part::model] = std::make_shared<model::BuiltModel>();
  state.stamp(part::image).revision = 9;
  state.stamp(part::labels) = {4, {{part::image, 3}}};
  state.stamp(part::model) = {5, {{part::labels, 4}}};
  QCOMPARE(stage_state(state, part::model), StageState::stale);
}

void CaseStateTest::LandmarksOfAPersonReplaceTheModels() {
  CaseState state;
  auto built = std::make_shared<model::BuiltModel>();
  built->model.landmarks.anterior_margin = Points::Constant(3, 3, 1.0);
  built->model.landmarks.vena_cava = Points::Constant(2, 3, 2.0);
  state[part::model] = built;
  auto placed = std::make_shared<Landmarks>();
  placed->umbilical_notch = Points::Constant(1, 3, 3.0);
  placed->vena_cava = Points::Constant(4, 3, 4.0);
  state[part::landmarks] = placed;
  const Landmarks landmarks = effective_model(state).landmarks;
  QCOMPARE(landmarks.anterior_margin.rows(), Eigen::Index{3});
  QCOMPARE(landmarks.umbilical_notch.rows(), Eigen::Index{1});
  QCOMPARE(landmarks.vena_cava.rows(), Eigen::Index{4});
}

void CaseStateTest::LandmarksNeedAModel() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError, effective_landmarks(CaseState()));
}

void CaseStateTest::NoTwoCommandsThatTouchTheSamePartAreIndependent() {
  QVERIFY(Command(BuildModel{}).traits().writes.meets(Command(Register{}).traits().reads));
  QVERIFY(Command(SetRegions{}).traits().writes.meets(Command(Reconstruct{}).traits().reads));
  QVERIFY(Command(OpenCase{}).traits().writes == Parts::all());
  QVERIFY(!Command(SetSeeds{})
               .traits()
               .writes.meets(Command(BuildModel{}).traits().reads | Command(BuildModel{}).traits().writes));
  QVERIFY(!Command(SaveCase{}).traits().reads.has(part::live));
}

QTEST_APPLESS_MAIN(CaseStateTest)
#include "case_state_test.moc"
