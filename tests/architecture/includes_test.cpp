// SPDX-License-Identifier: GPL-3.0-or-later
// Guards the direction of the includes: arrows run downwards only, modules know neither widgets nor VTK
// rendering, and third-party types stay out of public headers.
#include <QtTest>

#include "house.h"

namespace fs = std::filesystem;
using namespace glisson::house;

namespace {

struct Include {
  std::string target;  ///< as written between <> or ""
  int line = 0;
};

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

std::string where(const fs::path& path, const Include& include) {
  return fs::relative(path, source_root()).string() + ":" + std::to_string(include.line) + ": " +
         include.target;
}

}  // namespace

class IncludesTest : public QObject {
  Q_OBJECT
 private slots:
  void TheHouseIsFound();
  void ArrowsRunDownwardsOnly();
  void ModulesKnowNoWidgetsAndNoRendering();
  void ThirdPartyTypesStayOutOfPublicHeaders();
};

void IncludesTest::TheHouseIsFound() {
  QVERIFY2(fs::exists(source_root() / "modules/core"), "GLISSON_SOURCE_DIR must name the checkout");
  QVERIFY(rooms_on_disk().size() >= 4);
}

void IncludesTest::ArrowsRunDownwardsOnly() {
  std::string offences;
  for (const auto& [room, sources] : rooms_on_disk()) {
    const auto allowed = plan().sees.find(room);
    if (allowed == plan().sees.end()) continue;
    for (const fs::path& source : sources)
      for (const Include& include : includes_of(source)) {
        const std::string target = room_of_include(include.target);
        if (!target.empty() && target != room && !allowed->second.contains(target))
          offences += where(source, include) + "\n";
      }
  }
  QVERIFY2(offences.empty(), ("these includes climb:\n" + offences).c_str());
}

void IncludesTest::ModulesKnowNoWidgetsAndNoRendering() {
  static const std::regex kForbidden(
      "^(Q(Widget|MainWindow|Dialog|Application|OpenGLWidget|GraphicsView)|QtWidgets|vtkRender|vtkOpenGL|"
      "vtkActor|vtkGenericOpenGL|opencv2/highgui)");
  std::string offences;
  for (const auto& [room, sources] : rooms_on_disk()) {
    for (const fs::path& source : sources)
      for (const Include& include : includes_of(source)) {
        std::smatch match;
        const bool found = std::regex_search(include.target, match, kForbidden);
        const bool scene_widget = room == "ui/scene" && found && match[1].str().rfind("QW", 0) == 0;
        if ((is_module(room) && found) || scene_widget || include.target.rfind("opencv2/highgui", 0) == 0)
          offences += where(source, include) + "\n";
      }
  }
  QVERIFY2(offences.empty(), ("not allowed here:\n" + offences).c_str());
}

void IncludesTest::ThirdPartyTypesStayOutOfPublicHeaders() {
  static const std::regex kForeign(
      "^(vtk|itk|igtl|opencv2/|CGAL/|embree3/|dlib/|cholmod|nlohmann/json\\.hpp)");
  std::string offences;
  for (const auto& [room, sources] : rooms_on_disk()) {
    if (!is_module(room)) continue;
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
