// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of the house (house.txt) is what stands on the disk: no room more, no room less; and what stands
// there is of a size that can be read.
#include "house.h"

#include <QTest>

using namespace glisson::house;
namespace fs = std::filesystem;

namespace {

template <class Value>
Rooms names_of(const std::map<std::string, Value>& by_room) {
  Rooms names;
  for (const auto& [room, value] : by_room) names.insert(room);
  return names;
}

/// What is in one of the two only, a sentence each.
std::string differences(const Rooms& planned, const Rooms& built) {
  std::string found;
  for (const std::string& room : planned)
    if (!built.contains(room)) found += room + " is in the plan and not on the disk\n";
  for (const std::string& room : built)
    if (!planned.contains(room)) found += room + " is on the disk and not in the plan\n";
  return found;
}

Rooms folders_in(const fs::path& folder) {
  Rooms names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory() && !fs::is_empty(entry)) names.insert(entry.path().filename().string());
  return names;
}

constexpr int kMostLines = 500;  // of a file
constexpr int kMostOfFunction = 80, kMostOfFunctionInApp = 60, kMostOfApply = 10;

std::vector<std::string> lines_of(std::istream&& stream) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Whether what begins after a line is a list: sentences, aims, rows.
bool is_table(const std::vector<std::string>& lines, std::size_t opening) {
  static const std::regex kList("^\\s*(return \\{|static const .* = \\{$)");
  for (std::size_t i = opening + 1; i < std::min(lines.size(), opening + 4); ++i)
    if (std::regex_search(lines[i], kList)) return true;
  return false;
}

/// The first lines of functions that are longer than this, of a formatted source; tables are none.
std::vector<std::string> longer_than(int most, const std::vector<std::string>& lines) {
  std::vector<std::string> found;
  for (const std::size_t indent : {0, 2}) {
    std::size_t opening = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].find_first_not_of(' ') != indent) continue;
      const char first = lines[i][indent];
      if (first != '}' && first != '#' && first != '/') opening = i;
      const bool is_end = lines[i] == std::string(indent, ' ') + "}";
      if (is_end && i - opening >= static_cast<std::size_t>(most) && !is_table(lines, opening))
        found.push_back(lines[opening]);
    }
  }
  return found;
}

Plan plan_of(const std::string& text) {
  std::istringstream stream(text);
  return read_plan(stream);
}

}  // namespace

class HouseTest : public QObject {
  Q_OBJECT
 private slots:
  void TheHouseIsFound();
  void PlanAndDiskAreOne();
  void DifferencesAreFoundBothWays();
  void EveryRoomIsBuilt();
  void TestsMirrorTheRooms();
  void MillimetresAreNamedWhereThePlanSaysSo();
  void ListsStandForTheirRooms();
  void BrokenPlansAreRefused();
  void FilesAndFunctionsCanBeRead();
  void CommandsAreShort();
  void NobodyAsksWhichCommandItIs();
  void LongFunctionsAreFound();
};

void HouseTest::TheHouseIsFound() {
  QVERIFY2(fs::exists(source_root() / "modules/core"), "GLISSON_SOURCE_DIR must name the checkout");
  QVERIFY(rooms_on_disk().size() >= 4);
}

void HouseTest::PlanAndDiskAreOne() {
  const std::string found = differences(names_of(plan().sees), names_of(rooms_on_disk()));
  QVERIFY2(found.empty(), found.c_str());
}

void HouseTest::DifferencesAreFoundBothWays() {
  QVERIFY(differences({"core", "app"}, {"core", "app"}).empty());
  QCOMPARE(differences({"core", "atlas"}, {"core"}),
           std::string("atlas is in the plan and not on the disk\n"));
  QCOMPARE(differences({"core"}, {"core", "app"}), std::string("app is on the disk and not in the plan\n"));
}

void HouseTest::EveryRoomIsBuilt() {
  for (const auto& [room, sees] : plan().sees) {
    const fs::path folder = source_root() / (is_module(room) ? "modules/" + room : room);
    QVERIFY2(fs::exists(folder / "CMakeLists.txt"), room.c_str());
    QVERIFY2(!is_module(room) || fs::exists(folder / "README.md"), room.c_str());
  }
}

void HouseTest::TestsMirrorTheRooms() {
  Rooms expected = {"app", "ui", "architecture", "benchmarks", "data", "fuzz", "stopwatch", "support"};
  for (const auto& [room, sees] : plan().sees)
    if (is_module(room)) expected.insert(room);
  const std::string found = differences(expected, folders_in(source_root() / "tests"));
  QVERIFY2(found.empty(), ("of tests/:\n" + found).c_str());
}

void HouseTest::MillimetresAreNamedWhereThePlanSaysSo() {
  static const std::regex kName("\\b[a-z][a-z0-9_]*_mm[23]?\\b");
  Rooms found;
  for (const auto& [room, headers] : public_headers())
    for (const fs::path& header : headers)
      if (std::regex_search(code_of(header), kName)) found.insert(room);
  const std::string offences = differences(plan().millimetres, found);
  QVERIFY2(offences.empty(), ("rooms with names in _mm:\n" + offences).c_str());
}

void HouseTest::ListsStandForTheirRooms() {
  const Plan plan = plan_of(
      "core :\nvolume : core  # voxels\n\nBOTH = core volume\nfem : BOTH\nmillimetres = volume\n"
      "any_frame = fem\n");
  QCOMPARE(plan.sees.size(), std::size_t{3});
  QVERIFY(plan.sees.at("core").empty());
  QVERIFY((plan.sees.at("fem") == Rooms{"core", "volume"}));
  QVERIFY(plan.millimetres == Rooms{"volume"});
  QVERIFY(plan.any_frame == Rooms{"fem"});
}

void HouseTest::BrokenPlansAreRefused() {
  const auto complaint = [](const std::string& text) {
    try {
      plan_of(text);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  QCOMPARE(complaint("core :\nfem : core atlas\n"), std::string("line 2: atlas is not above"));
  QCOMPARE(complaint("fem : model\nmodel : fem\n"), std::string("line 1: model is not above"));
  QCOMPARE(complaint("core :\ncore :\n"), std::string("line 2: core is there twice"));
  QCOMPARE(complaint("core volume\n"), std::string("line 1: is neither 'ROOM : ...' nor 'LIST = ...'"));
}

void HouseTest::FilesAndFunctionsCanBeRead() {
  std::string offences;
  auto rooms = rooms_on_disk();
  rooms["tests"] = sources_below(source_root() / "tests");
  for (const auto& [room, sources] : rooms)
    for (const fs::path& source : sources) {
      const std::vector<std::string> lines = lines_of(std::ifstream(source));
      const std::string name = room + "/" + source.filename().string();
      if (lines.size() > kMostLines) offences += name + ": " + std::to_string(lines.size()) + " lines\n";
      if (room == "tests") continue;
      for (const std::string& function :
           longer_than(room == "app" ? kMostOfFunctionInApp : kMostOfFunction, lines))
        offences += name + ": " + function + "\n";
    }
  QVERIFY2(offences.empty(), ("too long to be read at once:\n" + offences).c_str());
}

/// What a command does stands in its module: its apply() calls it and puts the result in its place.
void HouseTest::CommandsAreShort() {
  std::string offences;
  int commands = 0;
  for (const fs::path& source : sources_below(source_root() / "modules" / "engine" / "src")) {
    const std::vector<std::string> lines = lines_of(std::ifstream(source));
    const auto applies = [](const std::string& line) {
      return line.find("::apply(const CaseState&") != line.npos;
    };
    commands += static_cast<int>(std::count_if(lines.begin(), lines.end(), applies));
    for (const std::string& function : longer_than(kMostOfApply, lines))
      if (applies(function)) offences += source.filename().string() + ": " + function + "\n";
  }
  QVERIFY2(commands > 50, qPrintable(QString::number(commands)));
  QVERIFY2(offences.empty(), ("longer than 10 lines:\n" + offences).c_str());
}

/// What becomes of a command is by its traits: another one is added without a place that knows it.
void HouseTest::NobodyAsksWhichCommandItIs() {
  Rooms commands;
  for (const fs::path& header :
       sources_below(source_root() / "modules" / "engine" / "include" / "glisson" / "engine" / "commands")) {
    std::string last;
    for (const std::string& line : lines_of(std::ifstream(header))) {
      static const std::regex kStruct("^struct (\\w+) \\{$");
      std::smatch found;
      if (std::regex_search(line, found, kStruct)) last = found[1];
      if (line == "  CommandTraits traits() const;") commands.insert(last);  // others are results
    }
  }
  QVERIFY2(commands.size() > 50, qPrintable(QString::number(commands.size())));
  std::string offences;
  for (const auto& [room, sources] : rooms_on_disk())
    for (const fs::path& source : sources)
      for (const std::string& line : lines_of(std::ifstream(source))) {
        static const std::regex kAsked("\\bas<(?:engine::)?(\\w+)>\\(");
        std::smatch found;
        if (std::regex_search(line, found, kAsked) && commands.contains(found[1]))
          offences += room + "/" + source.filename().string() + ": " + line + "\n";
      }
  QVERIFY2(offences.empty(), ("asked which command it is:\n" + offences).c_str());
}

void HouseTest::LongFunctionsAreFound() {
  const std::vector<std::string> lines = lines_of(std::istringstream(
      "int f() {\n  g();\n\n  g();\n}\nclass C {\n  void m() {\n    g();\n    g();\n    g();\n  }\n};\n"
      "Rows rows() {\n  static const Rows kRows = {\n      1,\n      2};\n  return kRows;\n}\n"));
  QVERIFY((longer_than(4, lines) == std::vector<std::string>{"int f() {", "  void m() {"}));
  QVERIFY(longer_than(5, lines).empty());
}

QTEST_APPLESS_MAIN(HouseTest)
#include "house_test.moc"
