// SPDX-License-Identifier: GPL-3.0-or-later
// Moments of the live view: kept, renamed, deleted, brought back, saved with the case, and opened one by one.
#include <QTest>

#include <fstream>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/keep_moment.h"
#include "glisson/engine/commands/remove_moment.h"
#include "glisson/engine/commands/rename_moment.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/moments.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/patient/label_map.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/stereo/png.h"

using namespace glisson;
using namespace glisson::engine;
namespace fs = std::filesystem;

namespace {

Picture picture(int first) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(std::size_t{3} * 40 * 24);
  for (std::size_t i = 0; i < bytes->size(); ++i)
    (*bytes)[i] = static_cast<std::uint8_t>(static_cast<std::size_t>(first) + 7 * i);
  return {40, 24, 3, bytes};
}

const Label kLesion = *structure_named("lesion_1");

KeptMoment moment(int frame, Validity validity = Validity::valid) {
  KeptMoment made;
  made.title = "Segment 6, \"before\" the cut: Größe";
  made.kept_at = "2026-01-31T10:20:30Z";
  made.left_png = std::make_shared<const std::string>(stereo::png_of(picture(frame)));
  made.right_png = std::make_shared<const std::string>(stereo::png_of(picture(frame + 100)));
  made.overlay.index = frame;
  made.overlay.seconds = frame / 25.0;
  made.overlay.validity = validity;
  made.overlay.doubtful = true;
  made.overlay.residual = 1.25e-3;
  made.overlay.nodes_in_camera = Points::Random(9, 3) * 0.1;
  made.camera_from_model = Eigen::Matrix4d::Identity();
  made.camera_from_model->topRightCorner<3, 1>() = Eigen::Vector3d(0.01, 0.02, 0.13);
  LesionVerdict verdict;
  verdict.lesion = kLesion;
  verdict.level = Level::degraded;
  verdict.reason = LesionReason::long_unseen;
  verdict.centre = {0.01, 0.02, 0.12};
  verdict.radius = 0.007;
  verdict.covariance = 4e-6 * Eigen::Matrix3d::Identity();
  verdict.expected = 3.2e-3;
  verdict.reach = 6e-3;
  verdict.support = 0.02;
  verdict.unseen = 4.5;
  made.overlay.lesions = {verdict};
  made.chosen = kLesion;
  made.measures = guidance::LesionMeasures{};
  made.measures->lesion = kLesion;
  made.measures->along_sight = 0.021;
  made.measures->shortest = 0.013;
  made.place = guidance::SurfacePlace{17, {0.25, 0.25, 0.5}};
  made.margin = Points::Random(5, 3) * 0.1;
  made.model_unchecked = made.landmarks_from_statistics = true;
  made.model_revision = 12;
  made.rig_revision = 4;
  return made;
}

CaseState after(const CaseState& state, const Command& command) {
  return apply(state, command, RunContext()).value().state;
}

CaseState with(const CaseState& state, const KeptMoment& kept) {
  return after(state, KeepMoment{std::make_shared<const KeptMoment>(kept)});
}

std::vector<int> numbers(const CaseState& state) {
  std::vector<int> list;
  if (state[part::moments])
    for (const auto& one : state[part::moments]->moments) list.push_back(one->number);
  return list;
}

CaseState three() {
  CaseState state;
  for (const int frame : {10, 20, 30}) state = with(state, moment(frame));
  state.stamp(part::moments).revision = 3;
  return state;
}

void overwrite(const fs::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

void change(const fs::path& path, const std::function<void(nlohmann::json&)>& edit) {
  nlohmann::json document = read_json(path);
  edit(document);
  write_json(path, document);
}

}  // namespace

class MomentsTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { std::srand(7); }  // Eigen's Random
  void NumbersAreGivenOnce();
  void WhatIsDeletedComesBackInItsPlace();
  void ATitleIsChangedAndNothingElse();
  void NoMoreThanCanBeKeptAreKept();
  void KeepingWaitsForNothingLong();
  void WhatNoFileCanHoldIsNotKept();
  void MomentsComeBackWithTheCase();
  void ASecondSaveWritesNoPictureAgain();
  void APicturesSumIsThatOfItsFile();
  void AnOlderCaseOpensWithout();
  void ADamagedMomentIsNamedAndTheRestOpens_data();
  void ADamagedMomentIsNamedAndTheRestOpens();
  void AListThatNoSaveWritesOpensNone();
  void WhatDiffersIsSeen();
  void AnotherModelDrawsNoOverlay();
};

void MomentsTest::NumbersAreGivenOnce() {
  CaseState state = three();
  QCOMPARE(numbers(state), (std::vector<int>{1, 2, 3}));
  state = after(state, RemoveMoment{3});
  state = with(state, moment(40));
  QCOMPARE(numbers(state), (std::vector<int>{1, 2, 4}));
  QCOMPARE(moment_of(state, 4)->overlay.index, 40);
  QVERIFY(!moment_of(state, 3));
  QVERIFY_THROWS_EXCEPTION(InputError, after(state, RemoveMoment{3}));
}

void MomentsTest::WhatIsDeletedComesBackInItsPlace() {
  CaseState state = three();
  const auto second = moment_of(state, 2);
  state = after(state, RemoveMoment{2});
  QCOMPARE(numbers(state), (std::vector<int>{1, 3}));
  state = with(state, *second);
  QCOMPARE(numbers(state), (std::vector<int>{1, 2, 3}));
  QVERIFY_THROWS_EXCEPTION(InputError, with(state, *second));
  for (const int number : {1, 2, 3}) state = after(state, RemoveMoment{number});
  QVERIFY(!state[part::moments]);
}

void MomentsTest::ATitleIsChangedAndNothingElse() {
  const CaseState before = three();
  const CaseState state = after(before, RenameMoment{2, "cut"});
  QCOMPARE(moment_of(state, 2)->title, std::string("cut"));
  QVERIFY(moment_of(state, 2)->left_png == moment_of(before, 2)->left_png);
  QVERIFY(moment_of(state, 1) == moment_of(before, 1));
  QVERIFY_THROWS_EXCEPTION(InputError, after(state, RenameMoment{7, "cut"}));
  std::string letters;
  for (int i = 0; i < 200; ++i) letters += "ö";
  QCOMPARE(moment_of(after(state, RenameMoment{2, letters}), 2)->title, letters);
  QVERIFY_THROWS_EXCEPTION(InputError, after(state, RenameMoment{2, letters + "x"}));
}

void MomentsTest::NoMoreThanCanBeKeptAreKept() {
  CaseState state;
  KeptMoment one = moment(1);
  for (std::size_t i = 0; i < kMostMoments; ++i) state = with(state, one);
  try {
    (void)with(state, one);
    QFAIL("one more was kept");
  } catch (const InputError& problem) {
    QVERIFY2(std::string(problem.what()).find("200 that can be kept. Delete") != std::string::npos,
             problem.what());
  }
  state = with(after(state, RemoveMoment{5}), one);
  // Their bytes are counted, too.
  state = CaseState();
  one.left_png = one.right_png = std::make_shared<const std::string>(kMostMomentBytes / 16, 'x');
  for (int i = 0; i < 8; ++i) state = with(state, one);
  QVERIFY_THROWS_EXCEPTION(InputError, with(state, one));
}

void MomentsTest::KeepingWaitsForNothingLong() {
  const CommandTraits traits = KeepMoment{}.traits();
  QCOMPARE(traits.lane, Lane::edits);
  QVERIFY(traits.reads == Parts{part::moments} && traits.writes == Parts{part::moments});
  QVERIFY_THROWS_EXCEPTION(PreconditionError, after({}, KeepMoment{}));
  KeptMoment without = moment(1);
  without.camera_from_model.reset();
  QVERIFY_THROWS_EXCEPTION(PreconditionError, with({}, without));
}

void MomentsTest::WhatNoFileCanHoldIsNotKept() {
  // It would keep the whole case from being saved.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const std::function<void(KeptMoment&)>& edit) {
    KeptMoment one = moment(1);
    edit(one);
    try {
      (void)with({}, one);
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  QVERIFY(!refused([](KeptMoment&) {}));
  QVERIFY(refused([nan](KeptMoment& m) { m.overlay.nodes_in_camera(2, 1) = nan; }));
  QVERIFY(refused([nan](KeptMoment& m) { m.overlay.residual = nan; }));
  QVERIFY(refused([nan](KeptMoment& m) { m.overlay.lesions[0].covariance(0, 0) = nan; }));
  QVERIFY(refused([nan](KeptMoment& m) { m.margin(0, 0) = nan; }));
  // What is not known is written as unknown.
  const TemporaryFolder folder;
  KeptMoment one = moment(1);
  one.overlay.lesions[0].support = std::numeric_limits<double>::infinity();
  one.overlay.lesions[0].reach = 0.0;
  one.overlay.lesions[0].covariance(0, 0) = nan;
  one.measures->along_sight = nan;
  QVERIFY(save_case(folder.path() / "a.glisson", with({}, one), RunContext()));
}

void MomentsTest::MomentsComeBackWithTheCase() {
  const TemporaryFolder folder;
  CaseState state = three();
  KeptMoment withdrawn = moment(50, Validity::surface_apart);
  withdrawn.overlay.nodes_in_camera.resize(0, 3);
  withdrawn.camera_from_model.reset();
  withdrawn.measures.reset();
  withdrawn.place.reset();
  withdrawn.chosen = 0;
  withdrawn.title.clear();
  state = with(state, withdrawn);
  state = after(state, RemoveMoment{1});
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, state, RunContext()));
  std::vector<std::string> lost;
  const CaseState read = open_case(path, RunContext(), &lost).value();
  QVERIFY2(lost.empty(), lost.empty() ? "" : lost.front().c_str());
  QCOMPARE(numbers(read), (std::vector<int>{2, 3, 4}));
  const auto before = moment_of(state, 2), now = moment_of(read, 2);
  QCOMPARE(now->title, before->title);
  QCOMPARE(now->kept_at, before->kept_at);
  QCOMPARE(now->overlay.index, 20);
  QCOMPARE(now->overlay.seconds, 0.8);
  QVERIFY(now->overlay.doubtful && now->model_unchecked && now->landmarks_from_statistics &&
          !now->landmarks_open);
  QVERIFY((now->overlay.nodes_in_camera - before->overlay.nodes_in_camera).cwiseAbs().maxCoeff() < 1e-6);
  QVERIFY((*now->camera_from_model - *before->camera_from_model).cwiseAbs().maxCoeff() < 1e-9);
  QVERIFY((now->margin - before->margin).cwiseAbs().maxCoeff() < 1e-9);
  QCOMPARE(now->overlay.lesions.size(), std::size_t{1});
  QCOMPARE(now->overlay.lesions[0].reason, LesionReason::long_unseen);
  QVERIFY(std::abs(now->overlay.lesions[0].expected - 3.2e-3) < 1e-9);
  QVERIFY(std::abs(now->measures->along_sight - 0.021) < 1e-9);
  QVERIFY(std::isnan(now->measures->from_place));
  QVERIFY(now->place == before->place && now->chosen == kLesion);
  QCOMPARE(now->model_revision, std::uint64_t{12});
  // Nothing of the pictures is lost.
  stereo::PictureReader reader;
  QVERIFY(*reader.decode(*now->left_png, "left").bytes == *picture(20).bytes);
  QVERIFY(*reader.decode(*now->right_png, "right").bytes == *picture(120).bytes);
  const auto nothing = moment_of(read, 4);
  QCOMPARE(nothing->overlay.validity, Validity::surface_apart);
  QVERIFY(!nothing->measures && !nothing->place && nothing->overlay.nodes_in_camera.rows() == 0);
  // A number that was deleted is not given again.
  QCOMPARE(numbers(with(after(read, RemoveMoment{4}), moment(60))), (std::vector<int>{2, 3, 5}));
}

void MomentsTest::ASecondSaveWritesNoPictureAgain() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson", left = path / "moments/0002_left.png";
  CaseState state = three();
  QVERIFY(save_case(path, state, RunContext()));
  const fs::path mark = folder.path() / "mark";
  fs::create_hard_link(left, mark);
  state = after(state, RenameMoment{2, "another"});
  QVERIFY(save_case(path, state, RunContext()));
  QVERIFY(fs::equivalent(left, mark));
  // What another program has changed is written anew.
  overwrite(left, "changed");
  QVERIFY(save_case(path, state, RunContext()));
  QVERIFY(read_file(left) == *moment_of(state, 2)->left_png);
  state = after(state, RemoveMoment{2});
  QVERIFY(save_case(path, state, RunContext()));
  QVERIFY(!fs::exists(left));
}

void MomentsTest::APicturesSumIsThatOfItsFile() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, three(), RunContext()));
  const nlohmann::json listed = read_json(path / "case.json").at("files"),
                       sums = read_json(path / "moments/0002.json").at("sums");
  QCOMPARE(sums.size(), std::size_t{2});
  for (const auto& [side, sum] : sums.items()) QVERIFY(listed.at("moments/0002_" + side + ".png") == sum);
}

void MomentsTest::AnOlderCaseOpensWithout() {
  const TemporaryFolder folder;
  CaseState state;
  segmentation::Seeds seeds;
  seeds.liver = Points::Constant(1, 3, 0.01);
  state[part::seeds] = std::make_shared<const segmentation::Seeds>(seeds);
  state.stamp(part::seeds).revision = 1;
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, state, RunContext()));
  std::vector<std::string> lost;
  QVERIFY(!open_case(path, RunContext(), &lost).value()[part::moments]);
  QVERIFY(lost.empty());
}

void MomentsTest::ADamagedMomentIsNamedAndTheRestOpens_data() {
  using Damage = std::function<void(const fs::path&)>;
  QTest::addColumn<Damage>("damage");
  const auto in_json = [](const char* name, const std::function<void(nlohmann::json&)>& edit) {
    QTest::newRow(name) << Damage([edit](const fs::path& moments) { change(moments / "0002.json", edit); });
  };
  const auto file = [](const char* name, const char* which, const char* content) {
    QTest::newRow(name) << Damage([which, content](const fs::path& moments) {
      content == nullptr ? void(fs::remove(moments / which)) : overwrite(moments / which, content);
    });
  };
  file("no description", "0002.json", nullptr);
  file("no overlay", "0002.jsonl", nullptr);
  file("no left picture", "0002_left.png", nullptr);
  file("another right picture", "0002_right.png", "\x89PNG");
  file("an empty description", "0002.json", "");
  file("a list for a description", "0002.json", "[]");
  file("half an overlay", "0002.jsonl", "{\"frame\": 20,");
  file("no frame", "0002.jsonl", "{\"complete\": true, \"frames\": 0}\n");
  QTest::newRow("the pictures of the other side") << Damage([](const fs::path& moments) {
    fs::rename(moments / "0002_left.png", moments / "0002_right.png");
    fs::copy(moments / "0001_left.png", moments / "0002_left.png");
  });
  QTest::newRow("nodes in a file beside it") << Damage([](const fs::path& moments) {
    nlohmann::json line = nlohmann::json::parse(read_file(moments / "0002.jsonl"));
    line["mesh"] = "mesh.vtu";
    overwrite(moments / "0002.jsonl", line.dump());
  });
  QTest::newRow("the description of another") << Damage([](const fs::path& moments) {
    fs::copy_file(moments / "0001.json", moments / "0002.json", fs::copy_options::overwrite_existing);
  });
  in_json("a negative number", [](nlohmann::json& d) { d["number"] = -2; });
  in_json("a number that wraps", [](nlohmann::json& d) { d["number"] = 4294967298; });
  in_json("no title", [](nlohmann::json& d) { d.erase("title"); });
  in_json("a title without an end", [](nlohmann::json& d) { d["title"] = std::string(100000, 'x'); });
  in_json("a revision below none", [](nlohmann::json& d) { d["model_revision"] = -1; });
  in_json("a margin far away", [](nlohmann::json& d) { d["anterior_margin_mm"][0][1] = 1e30; });
  in_json("a lesion that is none", [](nlohmann::json& d) { d["chosen_lesion"] = "liver"; });
  in_json("a depth below none", [](nlohmann::json& d) { d["measures"]["shortest_mm"] = -4.0; });
  in_json("a mark beside its triangle", [](nlohmann::json& d) { d["mark"]["weights"] = {9.0, -4.0, -4.0}; });
  in_json("a mark on no triangle", [](nlohmann::json& d) { d["mark"]["triangle"] = -1; });
  in_json("sums of another kind", [](nlohmann::json& d) { d["sums"] = 7; });
}

void MomentsTest::ADamagedMomentIsNamedAndTheRestOpens() {
  QFETCH(std::function<void(const fs::path&)>, damage);
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, three(), RunContext()));
  damage(path / "moments");
  std::vector<std::string> lost;
  const CaseState read = open_case(path, RunContext(), &lost).value();
  QCOMPARE(numbers(read), (std::vector<int>{1, 3}));
  const auto told = std::count_if(lost.begin(), lost.end(), [](const std::string& note) {
    return note.starts_with("case.moment_lost ") && note.find("0002") != std::string::npos;
  });
  QCOMPARE(told, 1);
  QCOMPARE(read[part::moments]->last, 3);
}

void MomentsTest::AListThatNoSaveWritesOpensNone() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, three(), RunContext()));
  const std::string good = read_file(path / "case.json");
  for (const char* numbers : {"7", "[]", "[1, 1]", "[\"../../secret\"]", "[-1]", "[1.5]", "[99999999999]"}) {
    overwrite(path / "case.json", good);
    change(path / "case.json", [numbers](nlohmann::json& document) {
      document["parts"]["moments"]["numbers"] = nlohmann::json::parse(numbers);
    });
    std::vector<std::string> lost;
    const CaseState read = open_case(path, RunContext(), &lost).value();
    QVERIFY2(!read[part::moments], numbers);
    QVERIFY2(!lost.empty() && lost.front().starts_with("case.moment_lost "), numbers);
  }
  // A link out of the case's folder is not followed.
  overwrite(path / "case.json", good);
  overwrite(folder.path() / "secret.png", "secret");
  fs::remove(path / "moments/0001_left.png");
  fs::create_symlink(folder.path() / "secret.png", path / "moments/0001_left.png");
  std::vector<std::string> lost;
  QVERIFY_THROWS_EXCEPTION(InputError, (void)open_case(path, RunContext(), &lost));
}

void MomentsTest::WhatDiffersIsSeen() {
  const CaseState good = three();
  const auto same = part::moments.spec().same;
  QVERIFY(same(good, good));
  const auto differs = [&](const std::function<void(KeptMoment&)>& edit) {
    CaseState other = good;
    KeptMoments kept = *good[part::moments];
    auto changed = std::make_shared<KeptMoment>(*kept.moments[1]);
    edit(*changed);
    kept.moments[1] = changed;
    other[part::moments] = std::make_shared<const KeptMoments>(kept);
    return !same(good, other);
  };
  QVERIFY(differs([](KeptMoment& m) { m.title += "x"; }));
  QVERIFY(differs([](KeptMoment& m) { m.right_png = m.left_png; }));
  QVERIFY(differs([](KeptMoment& m) { m.overlay.nodes_in_camera(3, 1) += 1e-5; }));
  QVERIFY(differs([](KeptMoment& m) { m.overlay.validity = Validity::stale; }));
  QVERIFY(differs([](KeptMoment& m) { m.overlay.lesions.clear(); }));
  QVERIFY(differs([](KeptMoment& m) { m.measures->shortest += 1e-4; }));
  QVERIFY(differs([](KeptMoment& m) { m.margin(0, 0) += 1e-4; }));
  QVERIFY(differs([](KeptMoment& m) { m.model_revision += 1; }));
  CaseState fewer = after(good, RemoveMoment{3});
  QVERIFY(!same(good, fewer));
}

void MomentsTest::AnotherModelDrawsNoOverlay() {
  CaseState state = three();
  QVERIFY(!is_drawn_as_it_was(state, *moment_of(state, 1)));  // there is no model
  KeptMoment kept = moment(1);
  PatientModel model;
  model.mesh.vertices = Points::Zero(9, 3);
  model::BuiltModel built;
  built.model = model;
  state[part::model] = std::make_shared<const model::BuiltModel>(built);
  state[part::rig] = std::make_shared<const StereoRig>();
  state.stamp(part::model).revision = 12;
  state.stamp(part::rig).revision = 4;
  QVERIFY(is_drawn_as_it_was(state, kept));
  kept.model_revision = 11;
  QVERIFY(!is_drawn_as_it_was(state, kept));
  kept.model_revision = 12;
  kept.rig_revision = 5;
  QVERIFY(!is_drawn_as_it_was(state, kept));
  kept.rig_revision = 4;
  kept.overlay.nodes_in_camera = Points::Zero(8, 3);
  QVERIFY(!is_drawn_as_it_was(state, kept));
}

QTEST_GUILESS_MAIN(MomentsTest)
#include "moments_test.moc"
