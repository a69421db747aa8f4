// SPDX-License-Identifier: GPL-3.0-or-later
// Guards the direction of the includes: arrows run downwards only, modules know neither widgets nor VTK
// rendering, and third-party types stay out of public headers.
#include <QtTest>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Include {
  std::string target;  ///< as written between <> or ""
  int line = 0;
};

/// Rooms that each room may see, beside itself. The order of the house; see DESIGN in the README.
const std::map<std::string, std::set<std::string>>& allowed() {
  static const std::map<std::string, std::set<std::string>> kAllowed = [] {
    std::map<std::string, std::set<std::string>> rooms;
    rooms["core"] = {};
    rooms["geometry"] = {"core"};
    rooms["volume"] = {"core"};
    rooms["patient"] = {"core", "geometry", "volume"};
    const std::set<std::string> vocabulary = {"core", "geometry", "volume", "patient"};
    const auto on = [&](std::set<std::string> extra) {
      extra.insert(vocabulary.begin(), vocabulary.end());
      return extra;
    };
    rooms["fem"] = vocabulary;
    rooms["model"] = vocabulary;
    rooms["segmentation"] = vocabulary;
    rooms["editing"] = vocabulary;
    rooms["stereo"] = vocabulary;
    // The theatre's truth is a finite-element mesh, and its operator writes the stages' own input files.
    rooms["insilico"] = on({"fem", "model", "segmentation", "editing", "stereo"});
    rooms["registration"] = on({"fem"});
    rooms["atlas"] = on({"fem", "registration"});
    rooms["guidance"] = on({"fem", "registration", "stereo"});
    rooms["engine"] =
        on({"fem", "model", "segmentation", "editing", "stereo", "registration", "atlas", "guidance"});
    rooms["experiments"] = on({"fem", "model", "segmentation", "editing", "stereo", "registration", "atlas",
                               "guidance", "insilico", "engine"});
    const std::set<std::string> below_ui = on(
        {"fem", "model", "segmentation", "editing", "stereo", "registration", "atlas", "guidance", "engine"});
    rooms["ui/scene"] = below_ui;
    rooms["ui/common"] = below_ui;
    rooms["ui/common"].insert("ui/scene");
    for (const char* panel : {"segmentation", "model", "atlas", "stereo", "guidance"}) {
      auto& seen = rooms["ui/" + std::string(panel)];
      seen = below_ui;
      seen.insert({"ui/scene", "ui/common"});
    }
    rooms["ui/shell"] = below_ui;
    rooms["ui/shell"].insert(
        {"ui/scene", "ui/common", "ui/segmentation", "ui/model", "ui/atlas", "ui/stereo", "ui/guidance"});
    return rooms;
  }();
  return kAllowed;
}

fs::path source_root() { return fs::path(qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString()); }

bool is_source(const fs::path& path) { return path.extension() == ".h" || path.extension() == ".cpp"; }

std::vector<Include> includes_of(const fs::path& path) {
  static const std::regex kInclude("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
  std::vector<Include> found;
  std::ifstream stream(path);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, kInclude)) found.push_back({match[1], number});
  }
  return found;
}

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

/// Every source of a room, by room.
std::map<std::string, std::vector<fs::path>> rooms_on_disk() {
  std::map<std::string, std::vector<fs::path>> rooms;
  for (const char* floor : {"modules", "ui"}) {
    const fs::path base = source_root() / floor;
    for (const auto& room : fs::directory_iterator(base)) {
      if (!room.is_directory()) continue;
      const std::string name = (std::string(floor) == "ui" ? "ui/" : "") + room.path().filename().string();
      for (const auto& entry : fs::recursive_directory_iterator(room.path()))
        if (entry.is_regular_file() && is_source(entry.path())) rooms[name].push_back(entry.path());
    }
  }
  return rooms;
}

std::string where(const fs::path& path, const Include& include) {
  return fs::relative(path, source_root()).string() + ":" + std::to_string(include.line) + ": " +
         include.target;
}

}  // namespace

class IncludesTest : public QObject {
  Q_OBJECT
 private slots:
  void TheHouseIsFound();
  void EveryRoomIsInThePlan();
  void ArrowsRunDownwardsOnly();
  void ThePlanHasNoCycle();
  void ModulesKnowNoWidgetsAndNoRendering();
  void ThirdPartyTypesStayOutOfPublicHeaders();
};

void IncludesTest::TheHouseIsFound() {
  QVERIFY2(fs::exists(source_root() / "modules/core"), "GLISSON_SOURCE_DIR must name the checkout");
  QVERIFY(rooms_on_disk().size() >= 4);
}

void IncludesTest::EveryRoomIsInThePlan() {
  for (const auto& [room, sources] : rooms_on_disk())
    QVERIFY2(allowed().contains(room), (room + " is not in the plan of this test").c_str());
}

void IncludesTest::ArrowsRunDownwardsOnly() {
  std::string offences;
  for (const auto& [room, sources] : rooms_on_disk()) {
    const auto plan = allowed().find(room);
    if (plan == allowed().end()) continue;
    for (const fs::path& source : sources)
      for (const Include& include : includes_of(source)) {
        const std::string target = room_of_include(include.target);
        if (!target.empty() && target != room && !plan->second.contains(target))
          offences += where(source, include) + "\n";
      }
  }
  QVERIFY2(offences.empty(), ("these includes climb:\n" + offences).c_str());
}

void IncludesTest::ThePlanHasNoCycle() {
  // Repeatedly takes away rooms that see nothing any more; a cycle is what remains.
  auto left = allowed();
  bool changed = true;
  while (changed) {
    changed = false;
    for (auto room = left.begin(); room != left.end();) {
      bool sees = false;
      for (const std::string& other : room->second) sees = sees || left.contains(other);
      changed = changed || !sees;
      room = sees ? std::next(room) : left.erase(room);
    }
  }
  QVERIFY2(left.empty(), left.empty() ? "" : left.begin()->first.c_str());
}

void IncludesTest::ModulesKnowNoWidgetsAndNoRendering() {
  static const std::regex kForbidden(
      "^(Q(Widget|MainWindow|Dialog|Application|OpenGLWidget|GraphicsView)|QtWidgets|vtkRender|vtkOpenGL|"
      "vtkActor|vtkGenericOpenGL|opencv2/highgui)");
  std::string offences;
  for (const auto& [room, sources] : rooms_on_disk()) {
    const bool is_module = room.rfind("ui/", 0) != 0;
    for (const fs::path& source : sources)
      for (const Include& include : includes_of(source)) {
        std::smatch match;
        const bool found = std::regex_search(include.target, match, kForbidden);
        const bool scene_widget = room == "ui/scene" && found && match[1].str().rfind("QW", 0) == 0;
        if ((is_module && found) || scene_widget || include.target.rfind("opencv2/highgui", 0) == 0)
          offences += where(source, include) + "\n";
      }
  }
  QVERIFY2(offences.empty(), ("not allowed here:\n" + offences).c_str());
}

void IncludesTest::ThirdPartyTypesStayOutOfPublicHeaders() {
  static const std::regex kForeign("^(vtk|itk|opencv2/|CGAL/|embree3/|dlib/|cholmod|nlohmann/json\\.hpp)");
  std::string offences;
  for (const auto& [room, sources] : rooms_on_disk()) {
    if (room.rfind("ui/", 0) == 0) continue;
    for (const fs::path& source : sources) {
      if (source.string().find("/include/") == std::string::npos) continue;
      for (const Include& include : includes_of(source))
        if (std::regex_search(include.target, kForeign)) offences += where(source, include) + "\n";
    }
  }
  QVERIFY2(offences.empty(), ("in a public header:\n" + offences).c_str());
}

QTEST_APPLESS_MAIN(IncludesTest)
#include "includes_test.moc"
