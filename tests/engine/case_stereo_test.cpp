// SPDX-License-Identifier: GPL-3.0-or-later
// A rendered stereo pair is reconstructed and labelled; the case that holds it is saved and opened again.
#include <QTest>

#include <fstream>

#include "complaint.h"
#include "full_disk.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/load_stereo_pair.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/labelling.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/source.h"
#include "rendered_pair.h"
#include "text_calibration.h"

using namespace glisson;
using namespace glisson::engine;
namespace fs = std::filesystem;

namespace {

/// Without the notes that others have changed a file, as these tests do.
std::vector<std::string> of_parts(std::vector<std::string> notes) {
  std::erase_if(notes, [](const std::string& note) { return note.starts_with("case.changed_outside "); });
  return notes;
}

}  // namespace

class CaseStereoTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void PointsComeBackWithTheirPairAndHowTheyWereMade();
  void OtherRegionsNeedNoOtherReconstructionAfterOpening();
  void PointsOfAFormerPairStayThoseOfAFormerPair();
  void ACaseOfBeforeHasACloudOnly();
  void AnImportedCloudHasNoPoints();
  void WhatIsWrongWithThePointsIsNamedAndTheRestIsThere_data();
  void WhatIsWrongWithThePointsIsNamedAndTheRestIsThere();
  void PointsOfOtherPicturesAreRefused();
  void ALostCloudLeavesTheRestAndASaveKeepsIt();
  void ACalibrationThatIsRefusedByNowIsNamedAndTheRestIsThere_data();
  void ACalibrationThatIsRefusedByNowIsNamedAndTheRestIsThere();
  void ADiskThatFillsUpLeavesTheOldPoints();
  void ACalibrationOfWholeViewsFitsACroppedSource();
  void PairAndCalibrationOfAnotherSizeComeInEitherOrder();

 private:
  static stereo::Region square(Feature feature, double x, double y, double side) {
    return {feature, {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}};
  }
  static std::unique_ptr<Engine> engine() {
    Engine::Options options;
    options.runner = Runner::inline_;
    return std::make_unique<Engine>(options);
  }
  /// What the engine holds after these commands, all of which must succeed.
  static CaseState after(Engine& engine, const std::vector<Command>& commands) {
    for (const Command& command : commands) {
      const Outcome outcome = engine.wait(engine.post(command));
      if (outcome.status != Status::done) throw std::runtime_error(outcome.error);
    }
    return engine.snapshot()->state;
  }
  fs::path saved() const { return folder_.path() / "a.glisson"; }
  /// A copy of the saved case that may be damaged.
  fs::path copy() const {
    const fs::path path = folder_.path() / "b.glisson";
    fs::remove_all(path);
    fs::copy(saved(), path, fs::copy_options::recursive);
    return path;
  }

  TemporaryFolder folder_;
  CaseState state_;
};

void CaseStereoTest::initTestCase() {
  const rendered::Pair pair = rendered::pair(
      rendered::plane(Eigen::Vector3d(0, 0, 0.09), Eigen::Vector3d(0.1, 0.2, -1.0).normalized()));
  stereo::write_picture(folder_.path() / "left.png", pair.left);
  stereo::write_picture(folder_.path() / "right.png", pair.right);
  stereo::write_calibration(folder_.path() / "scope.yaml", pair.rig);
  stereo::Regions regions;
  regions.regions = {square(Feature::surface, 200, 150, 200), square(Feature::anterior_margin, 350, 200, 60)};
  Reconstruct reconstruct;
  reconstruct.options.kind = stereo::Features::akaze;
  reconstruct.options.features = 1234;
  const auto maker = engine();
  state_ = after(*maker, {SetCalibration{folder_.path() / "scope.yaml"},
                          LoadStereoPair{folder_.path() / "left.png", folder_.path() / "right.png", {}},
                          SetRegions{regions}, reconstruct, SaveCase{saved()}});
  QVERIFY(state_[part::points]->whole->cloud.size() >
          2 * state_[part::cloud]->size());  // the pair's, not the regions'
}

void CaseStereoTest::PointsComeBackWithTheirPairAndHowTheyWereMade() {
  const auto read = open_case(saved(), RunContext());
  QVERIFY((*read)[part::points]);
  const PairPoints &was = *state_[part::points], &is = *(*read)[part::points];
  QVERIFY(is.frame == (*read)[part::frame] && is.rig == (*read)[part::rig]);
  QCOMPARE(is.frame_identity,
           stereo::frame_identity((*read)[part::frame]->frame.left, (*read)[part::frame]->frame.right));
  QVERIFY(is.options == was.options);
  QVERIFY(is.whole->report.method == stereo::Method::sparse);
  QCOMPARE(is.whole->report.matches, was.whole->report.matches);
  QCOMPARE(is.whole->report.row_offset_px, was.whole->report.row_offset_px);
  QCOMPARE(is.whole->report.misfit, was.whole->report.misfit);
  QCOMPARE(is.density_per_cm2, was.density_per_cm2);
  QCOMPARE(is.area_cm2, was.area_cm2);
  QCOMPARE(is.density.per_cm2, was.density.per_cm2);
  QCOMPARE(is.density.columns, was.density.columns);
  QCOMPARE(is.density.covered, was.density.covered);
  const LabelledCloud &before = was.whole->cloud, &after = is.whole->cloud;
  QCOMPARE(after.size(), before.size());
  QVERIFY((after.points - before.points).cwiseAbs().maxCoeff() < 1e-12);
  QVERIFY((after.normals - before.normals).cwiseAbs().maxCoeff() < 1e-6);
  for (std::size_t i = 0; i < before.sigma.size(); ++i)
    QVERIFY(std::abs(after.sigma[i] - before.sigma[i]) < 1e-6 * before.sigma[i]);
  for (std::size_t i = 0; i < was.whole->covariance.size(); ++i)
    QVERIFY((is.whole->covariance[i] - was.whole->covariance[i]).norm() <
            1e-12 * was.whole->covariance[i].norm());
  // The labelled part, and the regions that it came from.
  QCOMPARE((*read)[part::cloud]->features, state_[part::cloud]->features);
  QVERIFY(std::count((*read)[part::cloud]->features.begin(), (*read)[part::cloud]->features.end(),
                     Feature::anterior_margin) > 5);
  QCOMPARE((*read)[part::cloud]->sigma.size(), state_[part::cloud]->sigma.size());
  QCOMPARE((*read)[part::regions]->identity, state_[part::regions]->identity);
  QCOMPARE((*read)[part::regions]->regions.size(), std::size_t{2});
  QCOMPARE(stage_state(*read, part::cloud), StageState::current);
}

void CaseStereoTest::OtherRegionsNeedNoOtherReconstructionAfterOpening() {
  const auto opened = engine();
  const CaseState before = after(*opened, {OpenCase{saved()}});
  stereo::Regions regions;
  regions.regions = {square(Feature::umbilical_notch, 250, 200, 120)};
  Reconstruct again;
  again.options = before[part::points]->options;
  const CaseState now = after(*opened, {SetRegions{regions}, again});
  QVERIFY(now[part::points]->whole == before[part::points]->whole);
  const auto expected = stereo::label(state_[part::points]->whole->cloud, *state_[part::rig],
                                      state_[part::frame]->mask, regions);
  QCOMPARE(now[part::cloud]->size(), expected.cloud.size());
  QCOMPARE(now[part::cloud]->features, expected.cloud.features);
}

void CaseStereoTest::PointsOfAFormerPairStayThoseOfAFormerPair() {
  const fs::path path = folder_.path() / "former.glisson";
  const auto maker = engine();
  after(*maker,
        {OpenCase{saved()}, LoadStereoPair{folder_.path() / "right.png", folder_.path() / "left.png", {}},
         SaveCase{path}});
  for (int round = 0; round < 2; ++round) {  // opened and saved once more they are still the same
    const auto read = open_case(path, RunContext());
    QVERIFY((*read)[part::points] && !(*read)[part::points]->frame);
    QVERIFY((*read)[part::points]->rig == (*read)[part::rig]);
    QCOMPARE((*read)[part::points]->frame_identity, state_[part::points]->frame_identity);
    QCOMPARE(stage_state(*read, part::cloud), StageState::stale);
    QVERIFY(save_case(path, *read, RunContext()));
  }
}

void CaseStereoTest::ACalibrationOfWholeViewsFitsACroppedSource() {
  const StereoRig whole = rendered::rig();
  const int width = whole.left.width, height = whole.left.height;
  {
    stereo::VideoWriter writer(folder_.path() / "film.mkv", 2 * width, height, 30.0);
    const auto grey =
        std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(6 * width * height), 90);
    writer.write({2 * width, height, 3, grey});
    writer.close();
  }
  stereo::SourceOptions source;
  source.left = "film.mkv";
  source.crop = {40, 20, 320, 400};
  stereo::write_source(folder_.path() / "cropped.json", source);
  fs::create_directories(folder_.path() / "text");
  test::write_text_calibration(folder_.path() / "text", whole);
  for (const char* calibration : {"scope.yaml", "text"}) {
    const auto maker = engine();
    const CaseState state = after(*maker, {SetVideo{folder_.path() / "cropped.json", {}}, LoadVideoFrame{0},
                                           SetCalibration{folder_.path() / calibration}});
    QCOMPARE(state[part::frame]->frame.left.width, 320);
    QCOMPARE(state[part::rig]->left.width, 320);
    QCOMPARE(state[part::rig]->right.height, 400);
    QVERIFY(std::abs(state[part::rig]->left.matrix(0, 2) - (whole.left.matrix(0, 2) - 40.0)) < 1e-3);
    QVERIFY(std::abs(state[part::rig]->right.matrix(1, 2) - (whole.right.matrix(1, 2) - 20.0)) < 1e-3);
  }
  // The source is not opened once more for it: a camera would be in use.
  const auto maker = engine();
  after(*maker, {SetVideo{folder_.path() / "cropped.json", {}}, LoadVideoFrame{0}});
  fs::remove(folder_.path() / "film.mkv");
  const CaseState state = after(*maker, {SetCalibration{folder_.path() / "scope.yaml"}});
  QCOMPARE(state[part::rig]->left.width, 320);
}

void CaseStereoTest::PairAndCalibrationOfAnotherSizeComeInEitherOrder() {
  const auto grey = [this](const char* name, std::uint8_t value) {
    const fs::path path = folder_.path() / name;
    stereo::write_picture(path, {160, 120, 3, std::make_shared<std::vector<std::uint8_t>>(57600UL, value)});
    return path;
  };
  const LoadStereoPair small{grey("small_left.png", 80), grey("small_right.png", 90), {}};
  const auto maker = engine();
  after(*maker, {SetCalibration{folder_.path() / "scope.yaml"}, small});
  const Outcome outcome = maker->wait(maker->post(Reconstruct{}));
  QCOMPARE(outcome.status, Status::failed);
  QVERIFY2(outcome.error.find("160x120") != std::string::npos, outcome.error.c_str());
  // A mask is of its picture.
  LoadStereoPair masked = small;
  masked.mask = folder_.path() / "left.png";
  const Outcome other = maker->wait(maker->post(masked));
  QCOMPARE(other.status, Status::failed);
  QVERIFY2(other.error.find("left.png") != std::string::npos, other.error.c_str());
}

void CaseStereoTest::ACaseOfBeforeHasACloudOnly() {
  const fs::path path = copy();
  fs::remove_all(path / "points");
  std::string text = read_file(path / "case.json");
  const auto at = text.find("\"has_points\": true,");
  QVERIFY(at != std::string::npos);
  text.erase(at, std::string("\"has_points\": true,").size());
  write_file_atomically(path / "case.json", text);
  std::vector<std::string> lost;
  const auto read = open_case(path, RunContext(), &lost);
  QVERIFY(of_parts(lost).empty() && (*read)[part::cloud] && !(*read)[part::points]);
  QCOMPARE((*read)[part::cloud]->size(), state_[part::cloud]->size());
}

void CaseStereoTest::AnImportedCloudHasNoPoints() {
  write_cloud(folder_.path() / "cloud.ply", *state_[part::cloud]);
  const fs::path path = folder_.path() / "imported.glisson";
  const auto maker = engine();
  after(*maker, {OpenCase{saved()}, ImportCloud{folder_.path() / "cloud.ply"}, SaveCase{path}});
  const auto read = open_case(path, RunContext());
  QVERIFY((*read)[part::cloud] && !(*read)[part::points]);
  QVERIFY(!fs::exists(path / "points"));
}

void CaseStereoTest::WhatIsWrongWithThePointsIsNamedAndTheRestIsThere_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("from");
  QTest::addColumn<QString>("to");
  QTest::addColumn<QString>("mentions");
  const auto row = [](const char* name, const char* file, const char* from, const char* to,
                      const char* mentions) {
    QTest::newRow(name) << QString(file) << QString(from) << QString(to) << QString(mentions);
  };
  row("no points.json", "points/points.json", "", "", "points/points.json");
  row("no whole.ply", "points/whole.ply", "", "", "points/whole.ply");
  row("cut ply", "points/whole.ply", "end_header", "", "points/whole.ply");
  row("no json", "points/points.json", "{", "[", "points/points.json");
  row("unknown method", "points/points.json", "\"sparse\"", "\"thick\"", "method: is \"thick\"");
  row("text for a number", "points/points.json", "\"ratio\": 0.8", "\"ratio\": \"much\"",
      "options.ratio: is not of the right kind");
  row("an option out of range", "points/points.json", "\"ratio\": 0.8", "\"ratio\": 8.5", "options: ");
  row("a field is gone", "points/points.json", "\"matches\"", "\"catches\"", "report.matches: is missing");
  row("a group is gone", "points/points.json", "\"density\":", "\"sparsity\":", "density: is missing");
  row("fewer cells", "points/points.json", "\"columns\": ", "\"columns\": 1", "density.per_cm2: holds");
  row("too few covariances", "points/whole.ply", "element vertex ", "element vertex 1", "points/whole.ply");
  row("no normals", "points/whole.ply", "property float nx\nproperty float ny\nproperty float nz",
      "property float mx\nproperty float my\nproperty float mz", "nx, ny, nz: are missing");
  row("half a normal", "points/whole.ply", "property float nx", "property float mx", "no property \"nx\"");
}

void CaseStereoTest::WhatIsWrongWithThePointsIsNamedAndTheRestIsThere() {
  QFETCH(QString, file);
  QFETCH(QString, from);
  QFETCH(QString, to);
  QFETCH(QString, mentions);
  const fs::path path = copy();
  const fs::path damaged = path / file.toStdString();
  if (from.isEmpty()) {
    fs::remove(damaged);
  } else {
    std::string text = read_file(damaged);
    const auto at = text.find(from.toStdString());
    QVERIFY(at != std::string::npos);
    text.replace(at, static_cast<std::size_t>(from.size()), to.toStdString());
    write_file_atomically(damaged, text);
  }
  const std::string thrown = test::complaint<Error>([&] { open_case(path, RunContext()); });
  QVERIFY2(thrown.find(mentions.toStdString()) != std::string::npos, thrown.c_str());
  QVERIFY2(thrown.ends_with('.'), thrown.c_str());  // the remedy
  QVERIFY(std::all_of(thrown.begin(), thrown.end(), [](char letter) { return letter >= ' '; }));
  std::vector<std::string> lost;
  const auto read = open_case(path, RunContext(), &lost);
  lost = of_parts(std::move(lost));
  QCOMPARE(lost.size(), std::size_t{1});
  QCOMPARE(lost[0], "case.points_lost " + thrown);
  QVERIFY(!(*read)[part::points] && (*read)[part::rig] && (*read)[part::frame] && (*read)[part::regions]);
  QCOMPARE((*read)[part::cloud]->features, state_[part::cloud]->features);
}

void CaseStereoTest::PointsOfOtherPicturesAreRefused() {
  const fs::path path = copy();
  fs::copy_file(path / "frame/right.png", path / "frame/left.png", fs::copy_options::overwrite_existing);
  const std::string thrown = test::complaint<Error>([&] { open_case(path, RunContext()); });
  QVERIFY2(thrown.find("frame_identity") != std::string::npos, thrown.c_str());
}

void CaseStereoTest::ALostCloudLeavesTheRestAndASaveKeepsIt() {
  const fs::path path = copy();
  write_file_atomically(path / "cloud.ply", "ply\nthis is none\n");
  const auto opened = engine();
  const Outcome outcome = opened->wait(opened->post(OpenCase{path}));
  QVERIFY2(outcome.status == Status::done, outcome.error.c_str());
  QCOMPARE(outcome.notes.size(), std::size_t{2});
  QVERIFY(outcome.notes[0].starts_with("case.cloud_lost ") &&
          outcome.notes[0].find("cloud.ply") != std::string::npos);
  QCOMPARE(outcome.notes[1], std::string("case.changed_outside cloud.ply"));
  const CaseState state = opened->snapshot()->state;
  QVERIFY(!state[part::cloud] && !state[part::points] && state[part::frame] && state[part::rig] &&
          state[part::regions]);
  Reconstruct again;
  again.options = state_[part::points]->options;
  const CaseState now = after(*opened, {again, SaveCase{}});
  QCOMPARE(now[part::cloud]->features, state_[part::cloud]->features);  // made again as it was
  QVERIFY((*open_case(path, RunContext()))[part::points]);
}

void CaseStereoTest::ACalibrationThatIsRefusedByNowIsNamedAndTheRestIsThere_data() {
  QTest::addColumn<QString>("mentions");
  QTest::addRow("skew") << "M1: has a skew of 5";
  QTest::addRow("transposed") << "M1: is transposed";
  QTest::addRow("missing") << "calibration.yaml";
}

void CaseStereoTest::ACalibrationThatIsRefusedByNowIsNamedAndTheRestIsThere() {
  QFETCH(QString, mentions);
  const fs::path path = copy(), file = path / "calibration.yaml";
  StereoRig rig = *state_[part::rig];
  const std::string damage = QTest::currentDataTag();
  if (damage == "skew") rig.left.matrix(0, 1) = 5.0;
  if (damage == "transposed") rig.left.matrix.transposeInPlace();
  stereo::write_calibration(file, rig);
  if (damage == "missing") fs::remove(file);
  const std::string thrown = test::complaint<Error>([&] { open_case(path, RunContext()); });
  QVERIFY2(thrown.find(mentions.toStdString()) != std::string::npos && thrown.ends_with('.'), thrown.c_str());
  const auto opened = engine();
  const Outcome outcome = opened->wait(opened->post(OpenCase{path}));
  QVERIFY2(outcome.status == Status::done, outcome.error.c_str());
  QCOMPARE(of_parts(outcome.notes), std::vector<std::string>{"case.calibration_lost " + thrown});
  const auto snapshot = opened->snapshot();
  const CaseState& state = snapshot->state;
  QVERIFY(!state[part::rig] && state[part::frame] && state[part::regions] && state[part::cloud]);
  QVERIFY(state[part::points] && !state[part::points]->rig);
  // What was made with it does not hold.
  QCOMPARE(snapshot->stage(part::cloud), StageState::stale);
  after(*opened, {SetCalibration{folder_.path() / "scope.yaml"}});
  QCOMPARE(opened->snapshot()->stage(part::cloud), StageState::stale);
  Reconstruct again;
  again.options = state_[part::points]->options;
  const CaseState now = after(*opened, {again, SaveCase{}});
  QCOMPARE(now[part::cloud]->features, state_[part::cloud]->features);
  QVERIFY((*open_case(path, RunContext()))[part::rig]);
}

void CaseStereoTest::ADiskThatFillsUpLeavesTheOldPoints() {
  const fs::path path = copy();
  const std::string before = read_file(path / "points/points.json");
  CaseState next = state_;
  auto points = std::make_shared<PairPoints>(*state_[part::points]);
  points->density_per_cm2 = 77.0;
  next[part::points] = points;
  for (const auto bytes :
       {fs::file_size(path / "points/points.json") - 1, fs::file_size(path / "points/whole.ply") - 1}) {
    const auto refused = [&] {
      const test::FullDisk disk(bytes);
      save_case(path, next, RunContext());
    };
    QVERIFY(!test::complaint<FileError>(refused).empty());
    QCOMPARE(read_file(path / "points/points.json"), before);
  }
  QVERIFY(save_case(path, next, RunContext()));
  QCOMPARE((*open_case(path, RunContext()))[part::points]->density_per_cm2, 77.0);
}

QTEST_APPLESS_MAIN(CaseStereoTest)
#include "case_stereo_test.moc"
