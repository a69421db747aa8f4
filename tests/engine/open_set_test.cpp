// SPDX-License-Identifier: GPL-3.0-or-later
// A part and a command that nothing in the program knows, in this file alone: they are saved, read, outdated,
// cancelled and told as missing like the built-in ones.
#include <QTest>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/command.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/seeds.h"
#include "runners.h"

using namespace glisson;
using namespace glisson::engine;
using test::both_runners;

namespace {

/// The artificial part: a plan of the operation, made of the seeds.
struct Plan {
  std::string text;
};

const PartOf<Plan> plan{
    {.code = "plan",
     .made_of = {part::seeds},
     .remedy = "Write a plan first",
     .files = {"plan.txt"},
     .save = [](const CaseState& state, const CaseFolder& folder) -> nlohmann::json {
       write_file_atomically(folder.path / "plan.txt", state[plan]->text);
       return {{"letters", state[plan]->text.size()}};
     },
     .load =
         [](CaseState& state, const nlohmann::json& entry, const CaseFolder& folder) {
           auto text = read_file(folder.path / "plan.txt");
           if (text.size() != entry.at("letters").get<std::size_t>())
             throw InputError((folder.path / "plan.txt").string(), "letters", "are lost", "Write it again");
           state[plan] = std::make_shared<const Plan>(Plan{std::move(text)});
         },
     .same = [](const CaseState& a, const CaseState& b) { return a[plan]->text == b[plan]->text; }}};
const RegisteredPart registered(plan);

/// The artificial commands.
struct WritePlan {
  using Result = std::string;
  std::string text;
  CommandTraits traits() const {
    return {.code = "write_plan", .reads = {part::seeds}, .writes = {plan}, .needs = {part::seeds}};
  }
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const {
    context.progress(0.5, "plan.write");
    if (context.cancelled()) return {};
    Applied applied{state};
    applied.state[plan] = std::make_shared<const Plan>(Plan{text});
    applied.result = std::make_shared<const Result>("written: " + text);
    return applied;
  }
};
struct FollowPlan {
  CommandTraits traits() const {
    return {.code = "follow_plan", .reads = {plan}, .needs = {plan}, .current = {plan}};
  }
  Cancellable<Applied> apply(const CaseState& state, const RunContext&) const { return Applied{state}; }
};

std::unique_ptr<Engine> make_engine(Runner runner) {
  Engine::Options options;
  options.runner = runner;
  return std::make_unique<Engine>(std::move(options));
}

SetSeeds seeds(double x) {
  SetSeeds command;
  command.seeds.liver = Points::Constant(1, 3, x);
  return command;
}

}  // namespace

class OpenSetTest : public QObject {
  Q_OBJECT
 private slots:
  void TheNewPartStandsBehindWhatItIsMadeOf();
  void ItIsWrittenAndTold_data() { both_runners(); }
  void ItIsWrittenAndTold();
  void ItGoesOutOfDate_data() { both_runners(); }
  void ItGoesOutOfDate();
  void ItIsMissingUntilItIsThere();
  void ItIsSavedAndOpened();
  void DamagedItIsNamed();
  void ItsFileIsTheCases();
  void AForeignFileOfItsNameIsKeptBeside();
  void ItsCommandIsCancelled();
};

void OpenSetTest::TheNewPartStandsBehindWhatItIsMadeOf() {
  const auto& parts = all_parts();
  const auto place = [&](Part part) { return std::find(parts.begin(), parts.end(), part) - parts.begin(); };
  QVERIFY(place(plan) < static_cast<std::ptrdiff_t>(parts.size()));
  QVERIFY(place(part::seeds) < place(plan));
  for (const Part part : parts)
    for (const Part input : part.type().spec().made_of) QVERIFY(place(input) < place(part));
}

void OpenSetTest::ItIsWrittenAndTold() {
  QFETCH(Runner, runner);
  const auto engine = make_engine(runner);
  engine->wait(engine->post(seeds(0.1)));
  const Outcome outcome = engine->wait(engine->post(WritePlan{"left lobe first"}));
  QCOMPARE(outcome.status, Status::done);
  QCOMPARE(outcome.command, std::string("write_plan"));
  QCOMPARE(*outcome.result.as<WritePlan::Result>(), std::string("written: left lobe first"));
  QVERIFY(!outcome.result.as<int>());
  QCOMPARE(engine->snapshot()->state[plan]->text, std::string("left lobe first"));
  QCOMPARE(engine->snapshot()->stage(plan), StageState::current);
}

void OpenSetTest::ItGoesOutOfDate() {
  QFETCH(Runner, runner);
  const auto engine = make_engine(runner);
  engine->post(seeds(0.1));
  engine->wait(engine->post(WritePlan{"x"}));
  QVERIFY(!obstacle(*engine->snapshot(), FollowPlan{}));
  engine->wait(engine->post(seeds(0.2)));
  QCOMPARE(engine->snapshot()->stage(plan), StageState::stale);
  const auto first = obstacle(*engine->snapshot(), FollowPlan{});
  QVERIFY(first && *first == (Obstacle{Obstacle::Kind::stale, plan, part::seeds}));
  const Outcome refused = engine->wait(engine->post(FollowPlan{}));
  QCOMPARE(refused.status, Status::failed);
  QVERIFY2(refused.error.find("plan") != std::string::npos, refused.error.c_str());
}

void OpenSetTest::ItIsMissingUntilItIsThere() {
  const auto engine = make_engine(Runner::inline_);
  const auto first = obstacle(*engine->snapshot(), FollowPlan{});
  QVERIFY(first && *first == (Obstacle{Obstacle::Kind::missing, plan, part::seeds}));
  const Outcome refused = engine->wait(engine->post(FollowPlan{}));
  QCOMPARE(refused.error, std::string("case: plan: there is none yet. Write a plan first."));
}

void OpenSetTest::ItIsSavedAndOpened() {
  const TemporaryFolder folder;
  const auto engine = make_engine(Runner::inline_);
  engine->post(seeds(0.1));
  engine->post(WritePlan{"left lobe first"});
  const Outcome saved = engine->wait(engine->post(SaveCase{folder.path() / "a.glisson"}));
  QVERIFY2(saved.status == Status::done, saved.error.c_str());
  QVERIFY(saved.result.as<CaseOnDisk>()->editions.contains(plan));
  const auto other = make_engine(Runner::inline_);
  const Outcome opened = other->wait(other->post(OpenCase{folder.path() / "a.glisson"}));
  QVERIFY2(opened.status == Status::done, opened.error.c_str());
  QCOMPARE(other->snapshot()->state[plan]->text, std::string("left lobe first"));
  QCOMPARE(other->snapshot()->stage(plan), StageState::current);
  other->wait(other->post(seeds(0.2)));
  QCOMPARE(other->snapshot()->stage(plan), StageState::stale);
}

void OpenSetTest::DamagedItIsNamed() {
  const TemporaryFolder folder;
  const auto engine = make_engine(Runner::inline_);
  engine->post(seeds(0.1));
  engine->post(WritePlan{"left lobe first"});
  engine->wait(engine->post(SaveCase{folder.path() / "a.glisson"}));
  write_file_atomically(folder.path() / "a.glisson/plan.txt", "left");
  const Outcome opened = engine->wait(engine->post(OpenCase{folder.path() / "a.glisson"}));
  QCOMPARE(opened.status, Status::failed);
  QVERIFY2(opened.error.find("plan.txt: letters: are lost") != std::string::npos, opened.error.c_str());
  QCOMPARE(engine->snapshot()->state[plan]->text, std::string("left lobe first"));
}

/// Changed by others, it is told; led out of the case, it is not opened.
void OpenSetTest::ItsFileIsTheCases() {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.glisson";
  const auto engine = make_engine(Runner::inline_);
  engine->post(seeds(0.1));
  engine->post(WritePlan{"left lobe first"});
  engine->wait(engine->post(SaveCase{path}));
  write_file_atomically(path / "plan.txt", "left lobe after");  // as long as it was
  std::vector<std::string> told;
  const auto opened = open_case(path, RunContext(), &told);
  QVERIFY(opened && (*opened)[plan]->text == "left lobe after");
  QCOMPARE(told, std::vector<std::string>{"case.changed_outside plan.txt"});
  write_file_atomically(folder.path() / "another's.txt", "right lobe only");
  std::filesystem::remove(path / "plan.txt");
  std::filesystem::create_symlink(folder.path() / "another's.txt", path / "plan.txt");
  QVERIFY_THROWS_EXCEPTION(InputError, (void)open_case(path, RunContext()));
}

void OpenSetTest::AForeignFileOfItsNameIsKeptBeside() {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.glisson", kept = path / "plan.txt.kept-1";
  const auto engine = make_engine(Runner::inline_);
  engine->post(seeds(0.1));
  QCOMPARE(engine->wait(engine->post(SaveCase{path})).status, Status::done);
  write_file_atomically(path / "plan.txt", "a letter");
  // Though no plan comes in its place: it would be one for whoever opens the case.
  engine->post(seeds(0.2));
  const Outcome saved = engine->wait(engine->post(SaveCase{path}));
  QVERIFY2(saved.status == Status::done, saved.error.c_str());
  QCOMPARE(saved.notes, std::vector<std::string>{"case.kept_changed " + kept.string()});
  QCOMPARE(read_file(kept), std::string("a letter"));
  QVERIFY(!std::filesystem::exists(path / "plan.txt"));
  engine->post(WritePlan{"left lobe first"});
  QCOMPARE(engine->wait(engine->post(SaveCase{path})).status, Status::done);
  QCOMPARE(read_file(path / "plan.txt"), std::string("left lobe first"));
  QCOMPARE(read_file(kept), std::string("a letter"));
}

void OpenSetTest::ItsCommandIsCancelled() {
  Engine::Options options;
  options.runner = Runner::inline_;
  Engine* self = nullptr;
  options.progress = [&](const Progress& progress) {
    if (progress.stage == "plan.write") self->cancel(progress.id);
  };
  Engine engine(std::move(options));
  self = &engine;
  engine.post(seeds(0.1));
  QCOMPARE(engine.wait(engine.post(WritePlan{"x"})).status, Status::cancelled);
  QCOMPARE(engine.snapshot()->stage(plan), StageState::absent);
}

QTEST_APPLESS_MAIN(OpenSetTest)
#include "open_set_test.moc"
