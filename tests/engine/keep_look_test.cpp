// SPDX-License-Identifier: GPL-3.0-or-later
// Earlier looks at the organ: kept, forgotten, saved with the case, and joined when the model is registered.
#include "glisson/engine/commands/keep_look.h"

#include <QTest>

#include "../registration/phantom.h"
#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/forget_looks.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "runners.h"

using namespace glisson;
using namespace glisson::engine;

namespace {

std::shared_ptr<const LabelledCloud> look(unsigned seed, double share = 0.25) {
  const PatientModel model = phantom::model(6, 5, 3);
  return std::make_shared<const LabelledCloud>(
      phantom::patch(model, phantom::view().apply(model.mesh.vertices), {.share = share, .seed = seed}));
}

CaseState after(const CaseState& state, const Command& command) {
  return apply(state, command, RunContext()).value().state;
}

}  // namespace

class KeepLookTest : public QObject {
  Q_OBJECT
 private slots:
  void ALookIsKeptOnceAndIsNotJoinedWithItself();
  void TheLookThatAPersonSeesIsKept();
  void ALookOfAFileIsKept();
  void NoMoreThanCanBeJoinedAreKept();
  void ALookOfThePresentPairIsNotJoined();
  void LooksComeBackWithTheCase();
  void AWrongCountIsNamed();
  void RegistrationJoinsThemAndIsStaleWithoutThem();
  void ALookThatWasKeptIsNotOldWhenTheNextCloudComes();
};

void KeepLookTest::ALookIsKeptOnceAndIsNotJoinedWithItself() {
  CaseState state;
  state[part::cloud] = look(1);
  state = after(state, KeepLook{});
  QCOMPARE(state[part::earlier_looks]->clouds.size(), std::size_t{1});
  QVERIFY(looks_to_join(state).empty());
  QVERIFY_THROWS_EXCEPTION(InputError, after(state, KeepLook{}));
  state[part::cloud] = look(2);
  QCOMPARE(looks_to_join(state).size(), std::size_t{1});
  state = after(state, KeepLook{});
  QCOMPARE(state[part::earlier_looks]->clouds.size(), std::size_t{2});
  state = after(state, ForgetLooks{});
  QVERIFY(!state[part::earlier_looks]);
  QVERIFY(looks_to_join(state).empty());
}

void KeepLookTest::TheLookThatAPersonSeesIsKept() {
  KeepLook keep;
  keep.seen = look(1);
  CaseState state;
  state[part::cloud] = look(2);  // has come since
  state = after(state, keep);
  QVERIFY(state[part::earlier_looks]->clouds[0] == keep.seen);
  QCOMPARE(looks_to_join(state).size(), std::size_t{1});
  QVERIFY_THROWS_EXCEPTION(InputError, after(state, keep));
  // A new cloud that is being made is neither waited for nor taken.
  QVERIFY(!keep.traits().reads.has(part::cloud) && keep.traits().lane == Lane::edits);
}

void KeepLookTest::ALookOfAFileIsKept() {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath("look.ply").toStdString();
  write_cloud(file, *look(3));
  const CaseState state = after({}, KeepLook{file, LengthUnit::millimetre});
  QCOMPARE(state[part::earlier_looks]->clouds[0]->size(), look(3)->size());
  QVERIFY_THROWS_EXCEPTION(Error, after({}, KeepLook{folder.filePath("none.ply").toStdString(), {}}));
}

void KeepLookTest::NoMoreThanCanBeJoinedAreKept() {
  CaseState state;
  for (unsigned seed = 1; seed <= kMostLooks; ++seed) {
    state[part::cloud] = look(seed);
    state = after(state, KeepLook{});
  }
  state[part::cloud] = look(99);
  QVERIFY_THROWS_EXCEPTION(InputError, after(state, KeepLook{}));
}

/// Other regions of one pair give another cloud, of the same measurement.
void KeepLookTest::ALookOfThePresentPairIsNotJoined() {
  const QTemporaryDir folder;
  const auto pair = [](const char* identity) {
    PairPoints points;
    points.frame_identity = identity;
    return std::make_shared<const PairPoints>(points);
  };
  CaseState state;
  state[part::cloud] = look(1);
  state[part::points] = pair("first");
  state = after(state, KeepLook{});
  state[part::cloud] = look(2);
  QVERIFY(looks_to_join(state).empty());
  state[part::points] = pair("second");
  QCOMPARE(looks_to_join(state).size(), std::size_t{1});
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  CaseState kept;
  kept[part::earlier_looks] = state[part::earlier_looks];
  QVERIFY(save_case(path, kept, RunContext()));
  CaseState opened = *open_case(path, RunContext());
  opened[part::cloud] = look(3);
  opened[part::points] = pair("first");
  QVERIFY(looks_to_join(opened).empty());
}

void KeepLookTest::LooksComeBackWithTheCase() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  CaseState state;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    state[part::cloud] = look(seed);
    state = after(state, KeepLook{});
  }
  save_case(path, state, RunContext());
  const auto read = open_case(path, RunContext());
  QVERIFY(read.has_value());
  const auto& kept = (*read)[part::earlier_looks];
  QVERIFY(kept != nullptr);
  QCOMPARE(kept->clouds.size(), std::size_t{2});
  for (std::size_t k = 0; k < 2; ++k) {
    const LabelledCloud &was = *state[part::earlier_looks]->clouds[k], &is = *kept->clouds[k];
    QVERIFY((was.points - is.points).cwiseAbs().maxCoeff() < 1e-9);
    QCOMPARE(is.features, was.features);
  }
  // Forgotten, and saved again: nothing of them stays behind.
  save_case(path, after(state, ForgetLooks{}), RunContext());
  QVERIFY(!std::filesystem::exists(path / "looks" / "look_1.ply"));
}

void KeepLookTest::AWrongCountIsNamed() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  CaseState state;
  state[part::cloud] = look(1);
  save_case(path, after(state, KeepLook{}), RunContext());
  std::string text = read_file(path / "case.json");
  const std::string was = "\"count\": 1";
  QVERIFY(text.find(was) != std::string::npos);
  for (const char* count : {"-3", "0", "99999999999"}) {
    std::string wrong = text;
    wrong.replace(text.find(was), was.size(), std::string("\"count\": ") + count);
    write_file_atomically(path / "case.json", wrong);
    const std::string said = test::complaint([&] { open_case(path, RunContext()); });
    QVERIFY2(said.find("earlier_looks") != std::string::npos, said.c_str());
  }
}

void KeepLookTest::RegistrationJoinsThemAndIsStaleWithoutThem() {
  CaseState state;
  auto built = std::make_shared<model::BuiltModel>();
  built->model = phantom::model(6, 5, 3);
  state[part::model] = built;
  state[part::cloud] = look(1, 0.15);
  state = after(state, KeepLook{});
  state[part::cloud] = look(2, 0.3);
  Register command;
  command.start = Register::Start::given;
  command.given = phantom::view();
  command.operation.operations = 40;
  const auto applied = apply(state, command, RunContext());
  QVERIFY(applied->figures.contains("look_1_distance_mm"));
  QVERIFY(applied->figures.contains("look_2_distance_mm"));
  CaseState stamped = applied->state;
  stamped.stamp(part::earlier_looks).revision = 3;
  stamped.stamp(part::registration) = {4, {{part::earlier_looks, 3}}};
  QCOMPARE(stage_state(stamped, part::registration), StageState::current);
  stamped.stamp(part::earlier_looks).revision = 5;
  QCOMPARE(stage_state(stamped, part::registration), StageState::stale);
  CaseState alone = state;
  alone[part::earlier_looks] = nullptr;
  QVERIFY(!apply(alone, command, RunContext())->figures.contains("look_1_distance_mm"));
  QVERIFY(part::registration.spec().made_of.end() != std::find(part::registration.spec().made_of.begin(),
                                                               part::registration.spec().made_of.end(),
                                                               Part(part::earlier_looks)));
}

void KeepLookTest::ALookThatWasKeptIsNotOldWhenTheNextCloudComes() {
  const QTemporaryDir folder;
  const auto write = [&](const char* name, unsigned seed) {
    const std::filesystem::path file = folder.filePath(name).toStdString();
    write_cloud(file, *look(seed));
    return file;
  };
  Engine engine(test::options_of(Runner::inline_));
  const auto done = [&](const Command& command) { return engine.wait(engine.post(command)).status; };
  QCOMPARE(done(ImportCloud{write("first.ply", 1)}), Status::done);
  QCOMPARE(done(KeepLook{}), Status::done);
  QCOMPARE(done(ImportCloud{write("second.ply", 2)}), Status::done);
  QCOMPARE(engine.snapshot()->stage(part::earlier_looks), StageState::current);
  // As a case tells that an earlier program has written.
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  QCOMPARE(done(SaveCase{path}), Status::done);
  std::string text = read_file(path / "case.json");
  const std::size_t entry = text.find("\"earlier_looks\": {");
  const std::string none = "\"made_from\": {}";
  QVERIFY(entry != std::string::npos);
  text.replace(text.find(none, entry), none.size(), "\"made_from\": {\"cloud\": 1}");
  write_file_atomically(path / "case.json", text);
  QCOMPARE(done(OpenCase{path}), Status::done);
  QCOMPARE(engine.snapshot()->stage(part::earlier_looks), StageState::current);
}

QTEST_GUILESS_MAIN(KeepLookTest)
#include "keep_look_test.moc"
