// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>
#include <csignal>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "complaint.h"
#include "glisson/core/codes.h"
#include "glisson/core/error.h"
#include "glisson/core/failure_sentence.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/core/log.h"
#include "glisson/core/run_context.h"
#include "glisson/core/units.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

void put(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}
}  // namespace

class CoreTest : public QObject {
  Q_OBJECT
 private slots:
  void UnitsOfFiles();
  void CodesGoBothWays();
  void InputErrorIsOneSentenceInOrder();
  void RequireThrowsOnlyWhenBroken();
  void SamePurposeAndSeedGiveTheSameNumbers();
  void PurposesAndSeedsAreIndependent();
  void StreamsAreTheSameOnEveryMachine();
  void PartsOfPartsMapOntoTheWhole();
  void ProgressIsClamped();
  void PartsKeepSeedAndCancel();
  void CancelIsSeenFromAnotherThread();
  void LogKeepsItsThreshold();
  void FileIsReadWhole();
  void NoFileIsReadBeyondItsBound();
  void WhatStopsWorkIsASentence();
  void MissingFileAndFolderAreRefused();
  void WriteReplacesAndLeavesNothingBehind();
  void FailedVerificationLeavesTheOldFile();
  void WriterThatWritesNothingIsNoticed();
  void WriteIntoAMissingFolderIsRefused();
  void FullDiskIsNoticed();
  void KilledWriterLeavesTheOldOrTheNew();
  void TemporaryFolderGoesAway();
  void JsonErrorNamesLineAndColumn();
  void JsonThatNestsWithoutEndIsRefused();
  void JsonLargerThanAnyListIsRefused();
  void JsonThatNamesAFieldTwiceIsRefused();
  void JsonLinesAreRefusedByTheirNumber();
  void NamesCompareWhateverTheirCase();
  void JsonSurvivesTheFile();
  void FiguresThatAreNotFiniteAreNullAndCountsAreWhole();
};

void CoreTest::UnitsOfFiles() {
  QCOMPARE(metres_per(LengthUnit::millimetre), 1e-3);
  QCOMPARE(metres_per(LengthUnit::centimetre), 1e-2);
  QCOMPARE(metres_per(LengthUnit::metre), 1.0);
}

void CoreTest::CodesGoBothWays() {
  constexpr Codes<int, 2> kCodes = {{{"one", 1}, {"two", 2}}};
  QCOMPARE(value_in(kCodes, "two"), std::optional<int>(2));
  QVERIFY(!value_in(kCodes, "three"));
  QCOMPARE(std::string(code_in(kCodes, 1)), std::string("one"));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, code_in(kCodes, 3));
  for (const LengthUnit unit : kLengthUnits) QVERIFY(unit_named(unit_code(unit)) == unit);
  QVERIFY(!unit_named("km"));
}

void CoreTest::InputErrorIsOneSentenceInOrder() {
  const InputError error("a.vtk", "vertex 3", "is not finite", "Export it anew");
  QCOMPARE(std::string(error.what()), std::string("a.vtk: vertex 3: is not finite. Export it anew."));
  QCOMPARE(std::string(InputError("", "", "is empty", "").what()), std::string("is empty."));
  QCOMPARE(error.field(), std::string("vertex 3"));
  QCOMPARE(error.remedy(), std::string("Export it anew"));
}

void CoreTest::RequireThrowsOnlyWhenBroken() {
  require(true, "fine");
  QVERIFY_THROWS_EXCEPTION(PreconditionError, require(false, "broken"));
}

void CoreTest::SamePurposeAndSeedGiveTheSameNumbers() {
  const RunContext context(nullptr, nullptr, 42);
  auto a = context.random("noise"), b = context.random("noise");
  for (int i = 0; i < 100; ++i) QCOMPARE(a(), b());
}

void CoreTest::PurposesAndSeedsAreIndependent() {
  std::set<std::uint64_t> firsts;
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    for (const char* purpose : {"noise", "noise2", "esion", ""})
      firsts.insert(RunContext(nullptr, nullptr, seed).random(purpose)());
  QCOMPARE(firsts.size(), std::size_t{200});
}

void CoreTest::StreamsAreTheSameOnEveryMachine() {
  // Written down once: std::seed_seq and mt19937_64 are specified to the bit, std::hash is not.
  auto random = RunContext(nullptr, nullptr, 7).random("mesh");
  const std::uint64_t first = random();
  auto again = RunContext(nullptr, nullptr, 7).random("mesh");
  QCOMPARE(again(), first);
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char letter : std::string("mesh"))
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
  std::seed_seq expected{static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(hash >> 32), 7U, 0U};
  QCOMPARE(std::mt19937_64(expected)(), first);
}

void CoreTest::PartsOfPartsMapOntoTheWhole() {
  std::vector<double> seen;
  std::string stage;
  const RunContext context(
      [&](double fraction, std::string_view code) {
        seen.push_back(fraction);
        stage = code;
      },
      nullptr, 1);
  const RunContext inner = context.part(0.5, 1.0).part(0.0, 0.5);
  inner.progress(0.0, "a.b");
  inner.progress(0.5, "a.c");
  inner.progress(1.0, "a.d");
  QVERIFY(std::abs(seen[0] - 0.5) < 1e-15 && std::abs(seen[1] - 0.625) < 1e-15 &&
          std::abs(seen[2] - 0.75) < 1e-15);
  QCOMPARE(stage, std::string("a.d"));
}

void CoreTest::ProgressIsClamped() {
  double seen = -1;
  const RunContext context([&](double fraction, std::string_view) { seen = fraction; }, nullptr, 1);
  context.progress(1.7, "x");
  QCOMPARE(seen, 1.0);
  context.progress(-3, "x");
  QCOMPARE(seen, 0.0);
  RunContext().progress(0.5, "nobody listens");
}

void CoreTest::PartsKeepSeedAndCancel() {
  auto flag = std::make_shared<CancelFlag>();
  const RunContext part = RunContext(nullptr, flag, 9).part(0.2, 0.4);
  QCOMPARE(part.seed(), std::uint64_t{9});
  QVERIFY(!part.cancelled());
  flag->request();
  QVERIFY(part.cancelled());
  QVERIFY(!RunContext().cancelled());
}

void CoreTest::CancelIsSeenFromAnotherThread() {
  auto flag = std::make_shared<CancelFlag>();
  const RunContext context(nullptr, flag, 1);
  std::jthread asker([flag] { flag->request(); });
  while (!context.cancelled()) std::this_thread::yield();
  QVERIFY(flag->requested());
}

void CoreTest::LogKeepsItsThreshold() {
  std::vector<std::string> lines;
  const Log log([&](LogLevel, std::string_view line) { lines.emplace_back(line); }, LogLevel::warning);
  log.write(LogLevel::info, "quiet");
  log.write(LogLevel::error, "loud");
  Log().write(LogLevel::error, "nowhere");
  QVERIFY((lines == std::vector<std::string>{"loud"}));
}

void CoreTest::FileIsReadWhole() {
  TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xFF", 6);
  put(folder.path() / "x", bytes);
  QVERIFY(read_file(folder.path() / "x") == bytes);
}

void CoreTest::NoFileIsReadBeyondItsBound() {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "a", std::string(2000, 'a'));
  QCOMPARE(read_file(folder.path() / "a", 2000).size(), std::size_t{2000});
  const std::string told = test::complaint<FileError>([&] { (void)read_file(folder.path() / "a", 1999); });
  QVERIFY2(told.find("larger than such a file can be") != std::string::npos, told.c_str());
}

void CoreTest::WhatStopsWorkIsASentence() {
  QVERIFY(sentence_of(std::bad_alloc(), "segment").starts_with("segment: memory ran out. Close"));
  QVERIFY(sentence_of(std::runtime_error("no reason"), "segment")
              .starts_with("segment: stopped unexpectedly (no reason)."));
  const InputError error("a.json", "field", "is wrong", "Mend it");
  QCOMPARE(sentence_of(error, "segment"), std::string(error.what()));
  const auto gone = std::make_error_code(std::errc::no_space_on_device);
  QVERIFY(sentence_of(std::filesystem::filesystem_error("write", "/a", gone), "segment").starts_with("/a: "));
}

void CoreTest::MissingFileAndFolderAreRefused() {
  TemporaryFolder folder;
  QVERIFY(test::complaint<Error>([&] { read_file(folder.path() / "absent"); }).find("absent") !=
          std::string::npos);
  QVERIFY_THROWS_EXCEPTION(FileError, read_file(folder.path()));
}

void CoreTest::WriteReplacesAndLeavesNothingBehind() {
  TemporaryFolder folder;
  write_file_atomically(folder.path() / "x.txt", "one");
  write_file_atomically(folder.path() / "x.txt", "two");
  QCOMPARE(read_file(folder.path() / "x.txt"), std::string("two"));
  QCOMPARE(entries(folder.path()), std::size_t{1});
}

void CoreTest::FailedVerificationLeavesTheOldFile() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "x.nrrd";
  put(path, "old");
  QVERIFY_THROWS_EXCEPTION(FileError, write_file_atomically(
                                          path, [](const fs::path& to) { put(to, "half"); },
                                          [&](const fs::path& written) {
                                            QCOMPARE(written.extension(),
                                                     fs::path(".nrrd"));  // formats go by it
                                            throw FileError("does not read back");
                                          }));
  QCOMPARE(read_file(path), std::string("old"));
  QCOMPARE(entries(folder.path()), std::size_t{1});
}

void CoreTest::WriterThatWritesNothingIsNoticed() {
  TemporaryFolder folder;
  QVERIFY_THROWS_EXCEPTION(FileError,
                           write_file_atomically(
                               folder.path() / "x", [](const fs::path&) {}, [](const fs::path&) {}));
  QCOMPARE(entries(folder.path()), std::size_t{0});
}

void CoreTest::WriteIntoAMissingFolderIsRefused() {
  TemporaryFolder folder;
  QVERIFY(test::complaint<Error>([&] {
            write_file_atomically(folder.path() / "no" / "x", "text");
          }).find("folder does not exist") != std::string::npos);
}

void CoreTest::FullDiskIsNoticed() {
  // A limit on the size of files stands for the full disk; in a child, for it holds for a whole process.
  TemporaryFolder folder;
  const fs::path path = folder.path() / "x";
  put(path, "old");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_file_atomically(path, std::string(1 << 20, 'x'));
      ::_exit(1);
    } catch (const FileError&) {
      ::_exit(0);
    }
  }
  int status = -1;
  QCOMPARE(::waitpid(child, &status, 0), child);
  QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  QCOMPARE(read_file(path), std::string("old"));
  QCOMPARE(entries(folder.path()), std::size_t{1});
}

void CoreTest::KilledWriterLeavesTheOldOrTheNew() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "x";
  const std::string contents[2] = {std::string(300000, 'a'), std::string(300000, 'b')};
  write_file_atomically(path, contents[0]);
  for (int round = 0; round < 15; ++round) {
    const pid_t child = ::fork();
    if (child == 0)
      for (int i = 1;; ++i) write_file_atomically(path, contents[i % 2]);
    std::this_thread::sleep_for(std::chrono::microseconds(700 * (round + 1)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string found = read_file(path);
    QVERIFY(found == contents[0] || found == contents[1]);
  }
}

void CoreTest::TemporaryFolderGoesAway() {
  fs::path path;
  {
    TemporaryFolder folder;
    path = folder.path();
    put(path / "x", "y");
    QVERIFY(fs::exists(path));
  }
  QVERIFY(!fs::exists(path));
  QVERIFY_THROWS_EXCEPTION(FileError, TemporaryFolder("/no/such/place"));
}

void CoreTest::JsonErrorNamesLineAndColumn() {
  TemporaryFolder folder;
  put(folder.path() / "x.json", "{\n  \"a\": 1,\n  \"b\" 2\n}\n");
  const std::string message = test::complaint<Error>([&] { read_json(folder.path() / "x.json"); });
  QVERIFY(message.find("line 3, column 7") != std::string::npos);
  QVERIFY_THROWS_EXCEPTION(FileError, read_json(folder.path() / "absent.json"));
}

void CoreTest::JsonLinesAreRefusedByTheirNumber() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.jsonl";
  const auto numbers = [&path] {
    std::vector<int> found;
    for_each_json_line(path, "Write it anew", [&found](const nlohmann::json& object) {
      if (!object.contains("n")) throw InputError("", "n", "is missing", "Give it");
      found.push_back(object.at("n").get<int>());
    });
    return found;
  };
  const auto told = [&numbers] {
    try {
      numbers();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  put(path, "{\"n\": 3}\n\n{\"n\": 4}\n");
  QVERIFY((numbers() == std::vector<int>{3, 4}));
  put(path, "{\"n\": 3}\n\n{\"m\": 4}\n");
  QCOMPARE(told(), path.string() + ": line 3, n: is missing. Give it.");
  for (const char* malformed : {"{", "{\"n\": \"x\"}", "{\"n\": 3}\n{"}) {
    put(path, malformed);
    QVERIFY(told().find(": is malformed (") != std::string::npos);
    QVERIFY(told().ends_with("). Write it anew."));
  }
}

void CoreTest::JsonThatNestsWithoutEndIsRefused() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "x.json";
  const auto nested = [](std::size_t depth) {
    return "{\"a \\\"[[[\": " + std::string(depth, '[') + "1" + std::string(depth, ']') + "}";
  };
  put(path, nested(60));
  QVERIFY(read_json(path).is_object());
  // Deep enough to end the program where a copy of the value is made.
  for (const std::size_t depth : {64U, 200000U}) {
    put(path, nested(depth));
    const std::string whole = test::complaint<InputError>([&] { read_json(path); });
    QVERIFY2(whole.find("nests lists deeper") != std::string::npos, whole.c_str());
    const std::string line = test::complaint<InputError>([&] {
      for_each_json_line(path, "Write it anew", [](const nlohmann::json& object) { (void)object.dump(); });
    });
    QVERIFY2(line.find("line 1: nests lists deeper") != std::string::npos, line.c_str());
  }
}

void CoreTest::JsonThatNamesAFieldTwiceIsRefused() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "x.json";
  // The same name in another object, or as a text, is no second one.
  put(path, R"({"a": {"b": 1, "a": "a"}, "b": [{"b": 2}, {"b": 3}], "c": {"a": {}, "b": {"a": 1}},
               "{\"d\":": "\"d\":", "d" : ["d", "d", ":\\"]})");
  QVERIFY(read_json(path).at("b").at(1).at("b") == 3);
  put(path, "\"a\"");
  QVERIFY(read_json(path) == "a");
  put(path, std::string("{\"a\": 1}\0}\"a\": 1", 15));  // what follows a zero is none of it
  QVERIFY(read_json(path).size() == 1);
  for (const char* twice : {R"({"a": 1, "b": 2, "a": 3})", R"({"c": [0, {"a": {"b": 1}, "a": {"b": 1}}]})",
                            R"({"a" : [], "\u0061"  : 2})"}) {
    put(path, twice);
    const std::string whole = test::complaint<InputError>([&] { read_json(path); });
    QCOMPARE(whole, path.string() + ": \"a\": stands twice. Keep one of them.");
    put(path, std::string("{}\n") + twice + "\n");
    const std::string line = test::complaint<InputError>(
        [&] { for_each_json_line(path, "Write it anew", [](const nlohmann::json&) {}); });
    QCOMPARE(line, path.string() + ": line 2, \"a\": stands twice. Keep one of them.");
  }
}

void CoreTest::JsonLargerThanAnyListIsRefused() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "x.json";
  write_json(path, {{"a", 1}});
  for (const std::uintmax_t size : {100000000U, 100000001U}) {
    fs::resize_file(path, size);  // with zeros, which are no JSON
    const std::string message = test::complaint<InputError>([&] { read_json(path); });
    QCOMPARE(message.find("is larger than 100 MB") != std::string::npos, size > 100000000U);
  }
}

void CoreTest::NamesCompareWhateverTheirCase() {
  QCOMPARE(lower_case("Portal Vein \xC3\x84-7"),
           std::string("portal vein \xC3\x84-7"));  // ASCII letters only
  QCOMPARE(lower_name("/Data/CT.NII.GZ"), std::string("ct.nii.gz"));
  QCOMPARE(lower_extension("/Data.Old/Liver.STL"), std::string(".stl"));
  QCOMPARE(lower_extension("/Data.Old/liver"), std::string());
}

void CoreTest::JsonSurvivesTheFile() {
  TemporaryFolder folder;
  const nlohmann::json document = {{"name", "liver"}, {"list", {1, 2.5, nullptr}}};
  write_json(folder.path() / "x.json", document);
  QVERIFY(read_json(folder.path() / "x.json") == document);
}

void CoreTest::FiguresThatAreNotFiniteAreNullAndCountsAreWhole() {
  TemporaryFolder folder;
  write_figures(folder.path() / "x.json",
                {{"tre_mm", 1.5}, {"frames", 300.0}, {"bad_mm", std::numeric_limits<double>::quiet_NaN()}},
                {{"source", "in-silico"}});
  const nlohmann::json document = read_json(folder.path() / "x.json");
  QCOMPARE(document.at("tre_mm").get<double>(), 1.5);
  QVERIFY(document.at("bad_mm").is_null());
  QCOMPARE(document.at("frames").dump(), std::string("300"));  // a count looks like one
  QCOMPARE(document.at("source").get<std::string>(), std::string("in-silico"));
}

QTEST_APPLESS_MAIN(CoreTest)
#include "core_test.moc"
