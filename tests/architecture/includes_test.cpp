// SPDX-License-Identifier: GPL-3.0-or-later
// Guards the direction of the includes: arrows run downwards only, modules know neither widgets nor VTK
// rendering, and third-party types stay out of public headers.
#include <QTest>

#include "house.h"

namespace fs = std::filesystem;
using namespace glisson::house;

namespace {

/// An include of one of the house's sources.
struct Include {
  std::string room;  ///< that it stands in
  fs::path source;
  int line = 0;
  std::string target;  ///< as written between <> or ""
};

std::vector<Include> read_includes() {
  static const std::regex kInclude("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
  std::vector<Include> found;
  for (const auto& [room, sources] : rooms_on_disk())
    for (const fs::path& source : sources) {
      std::ifstream stream(source);
      std::string line;
      for (int number = 1; std::getline(stream, line); ++number) {
        std::smatch match;
        if (line.find('#') != std::string::npos && std::regex_search(line, match, kInclude))
          found.push_back({room, source, number, match[1]});
      }
    }
  return found;
}

/// Of all rooms; those of the tests are not among them.
const std::vector<Include>& includes() {
  static const std::vector<Include> kIncludes = read_includes();
  return kIncludes;
}

bool is_public(const fs::path& source) { return source.string().find("/include/") != std::string::npos; }

/// The room behind an include, or nothing for what is not ours: "glisson/fem/x.h" -> fem,
/// "glisson/ui/scene/x.h" -> ui/scene.
std::string room_of_include(const std::string& target) {
  if (target.rfind("glisson/", 0) != 0) return {};
  const std::string rest = target.substr(8);
  const auto slash = rest.find('/');
  if (slash == std::string::npos) return {};
  const std::string first = rest.substr(0, slash);
  if (first != "ui") return first;
  const auto second = rest.find('/', slash + 1);
  return second == std::string::npos ? "ui" : rest.substr(0, second);
}

std::string where(const Include& include) {
  return fs::relative(include.source, source_root()).string() + ":" + std::to_string(include.line) + ": " +
         include.target;
}

/// A public header as others include it: "glisson/fem/tissue.h".
std::string name_of(const fs::path& header) {
  const std::string path = header.string();
  return path.substr(path.find("/include/") + std::string("/include/").size());
}

/// Public headers that no room but their own reads, and why.
const std::map<std::string, std::string>& for_tests() {
  static const std::map<std::string, std::string> kReasons = {
      {"glisson/insilico/mr_patient.h", "segmentation is tested on it; no study scans it yet"},
  };
  return kReasons;
}

/// What other rooms read of the modules' public headers, or such a header in its turn.
std::set<std::string> read_from_outside() {
  std::set<std::string> read;
  for (const Include& include : includes())
    if (room_of_include(include.target) != include.room) read.insert(include.target);
  for (std::size_t before = 0; before != read.size();) {
    before = read.size();
    for (const Include& include : includes())
      if (is_public(include.source) && read.contains(name_of(include.source))) read.insert(include.target);
  }
  return read;
}

}  // namespace

class IncludesTest : public QObject {
  Q_OBJECT
 private slots:
  void TheHouseIsFound();
  void ArrowsRunDownwardsOnly();
  void EveryArrowIsUsed();
  void PublicHeadersAreReadFromOutside();
  void ModulesKnowNoWidgetsAndNoRendering();
  void ThirdPartyTypesStayOutOfPublicHeaders();
  void NothingReadsQtWhole();
};

void IncludesTest::TheHouseIsFound() {
  QVERIFY2(fs::exists(source_root() / "modules/core"), "GLISSON_SOURCE_DIR must name the checkout");
  QVERIFY(rooms_on_disk().size() >= 4);
}

void IncludesTest::ArrowsRunDownwardsOnly() {
  std::string offences;
  for (const Include& include : includes()) {
    const auto allowed = plan().sees.find(include.room);
    if (allowed == plan().sees.end()) continue;
    const std::string target = room_of_include(include.target);
    if (!target.empty() && target != include.room && !allowed->second.contains(target))
      offences += where(include) + "\n";
  }
  QVERIFY2(offences.empty(), ("these includes climb, or are not in house.txt:\n" + offences).c_str());
}

void IncludesTest::EveryArrowIsUsed() {
  std::map<std::string, Rooms> seen;
  for (const Include& include : includes()) seen[include.room].insert(room_of_include(include.target));
  std::string offences;
  for (const auto& [room, allowed] : plan().sees)
    for (const std::string& target : allowed)
      if (!seen[room].contains(target)) offences += room + " : " + target + "\n";
  QVERIFY2(offences.empty(), ("nothing uses these of house.txt:\n" + offences).c_str());
}

/// What only its own room and tests read belongs into src/.
void IncludesTest::PublicHeadersAreReadFromOutside() {
  const std::set<std::string> read = read_from_outside();
  std::string offences;
  std::set<std::string> excused;
  for (const auto& [room, headers] : public_headers())
    for (const fs::path& header : headers) {
      const std::string name = name_of(header);
      if (read.contains(name)) continue;
      if (for_tests().contains(name))
        excused.insert(name);
      else
        offences += name + "\n";
    }
  QVERIFY2(offences.empty(), ("public, but no other room reads them:\n" + offences).c_str());
  QCOMPARE(excused.size(), for_tests().size());
}

void IncludesTest::ModulesKnowNoWidgetsAndNoRendering() {
  static const std::regex kForbidden(
      "^(Q(Widget|MainWindow|Dialog|Application|OpenGLWidget|GraphicsView)|QtWidgets|vtkRender|vtkOpenGL|"
      "vtkActor|vtkGenericOpenGL|opencv2/highgui)");
  std::string offences;
  for (const Include& include : includes()) {
    std::smatch match;
    const bool found = std::regex_search(include.target, match, kForbidden);
    const bool scene_widget = include.room == "ui/scene" && found && match[1].str().rfind("QW", 0) == 0;
    if ((is_module(include.room) && found) || scene_widget || include.target.rfind("opencv2/highgui", 0) == 0)
      offences += where(include) + "\n";
  }
  QVERIFY2(offences.empty(), ("not allowed here:\n" + offences).c_str());
}

void IncludesTest::ThirdPartyTypesStayOutOfPublicHeaders() {
  static const std::regex kForeign(
      "^(vtk|itk|igtl|opencv2/|CGAL/|embree3/|dlib/|cholmod|nlohmann/json\\.hpp)");
  std::string offences;
  for (const Include& include : includes())
    if (is_module(include.room) && is_public(include.source) && std::regex_search(include.target, kForeign))
      offences += where(include) + "\n";
  QVERIFY2(offences.empty(), ("in a public header:\n" + offences).c_str());
}

/// What the inline functions of Qt's umbrella headers call is instantiated in each unit, used or not.
void IncludesTest::NothingReadsQtWhole() {
  static const std::regex kUmbrella(
      "^\\s*#\\s*include\\s*<Qt(Core|Gui|Widgets|Test|Network)(/Qt[A-Za-z]+)?>");
  std::string offences;
  int read = 0;
  for (const char* folder : {"modules", "ui", "app", "tests"})
    for (const fs::path& source : sources_below(source_root() / folder)) {
      ++read;
      std::ifstream stream(source);
      for (std::string line; std::getline(stream, line);)
        if (std::regex_search(line, kUmbrella)) offences += source.string() + ": " + line + "\n";
    }
  QVERIFY(read > 1000);
  QVERIFY2(offences.empty(), ("name the classes instead:\n" + offences).c_str());
}

QTEST_APPLESS_MAIN(IncludesTest)
#include "includes_test.moc"
