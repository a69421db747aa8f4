// SPDX-License-Identifier: GPL-3.0-or-later
// Points in public headers say their frame: by their name (nodes_in_camera) or by their type
// (PointsIn<CtFrame>).
#include <QTest>

#include "house.h"

using namespace glisson::house;
namespace fs = std::filesystem;

namespace {

/// Rooms and declarations whose points are in any one frame, and why.
const std::map<std::string, std::string>& of_any_frame() {
  static const std::map<std::string, std::string> kReasons = {
      {"atlas", "brings livers, templates and means into one another's frames; a patient's is the CT"},
      {"geometry", "measures meshes and points where they are; whoever owns them knows the frame"},
      {"fem", "a body is at rest and moves in the frame of its mesh, whichever that is"},
      {"experiments/evaluate.h", "estimate and truth in one frame, whichever"},
      {"model/build.h: detect_anterior_margin", "in the frame of the surface"},
      {"insilico/ray_caster.h", "rays and organ in one frame, whichever"},
      {"insilico/pulled_organ.h", "an organ pulled in the frame of its rest shape"},
      {"patient/patient_model.h: apply", "carries points from one frame into another"},
      {"patient/patient_model.h: nodes", "of apply"},
      {"patient/patient_model.h: points", "of bind_points: in the frame of the mesh that they are bound to"},
      {"registration/moving_surface.h: nodes", "queries are in the frame of the nodes that were given last"},
      {"registration/register.h: nodes", "a model moved into any frame"},
      {"registration/pairs.h: cloud", "of seen_share: surface and cloud in one frame, whichever"},
      {"registration/operation_prior.h: shape", "modes turn with nothing: the frame of the rest shape"},
      {"registration/operation_prior.h: rest", "of shape"},
  };
  return kReasons;
}

/// Names that are declared with the bare type Points in a header's code; "" for one without a name.
std::vector<std::string> bare_points(const std::string& code) {
  static const std::regex kDeclaration("\\bPoints\\b\\s*(?:const\\b)?\\s*[&*]*\\s*([A-Za-z_][A-Za-z0-9_]*)?");
  std::vector<std::string> names;
  for (auto match = std::sregex_iterator(code.begin(), code.end(), kDeclaration);
       match != std::sregex_iterator(); ++match)
    names.push_back((*match)[1]);
  return names;
}

bool says_frame(const std::string& name) {
  static const std::regex kFrame(".+_in_(ct|camera|right_camera)");
  const bool is_private = name.ends_with('_');
  return is_private || std::regex_match(name, kFrame);
}

}  // namespace

class FramesTest : public QObject {
  Q_OBJECT
 private slots:
  void PointsSayTheirFrame();
  void EveryExceptionIsNeeded();
  void DeclarationsAreSeen();
};

void FramesTest::PointsSayTheirFrame() {
  std::string offences;
  for (const auto& [room, headers] : public_headers()) {
    if (of_any_frame().contains(room)) continue;
    for (const fs::path& header : headers) {
      const std::string file = room + "/" + header.filename().string();
      if (of_any_frame().contains(file)) continue;
      for (const std::string& name : bare_points(code_of(header)))
        if (!says_frame(name) && !of_any_frame().contains(file + ": " + name))
          offences += file + ": Points " + name + "\n";
    }
  }
  QVERIFY2(offences.empty(),
           ("say the frame, as nodes_in_camera or PointsIn<CtFrame>:\n" + offences).c_str());
}

void FramesTest::EveryExceptionIsNeeded() {
  std::set<std::string> unused;
  for (const auto& [what, why] : of_any_frame()) unused.insert(what);
  for (const auto& [room, headers] : public_headers())
    for (const fs::path& header : headers)
      for (const std::string& name : bare_points(code_of(header))) {
        const std::string file = room + "/" + header.filename().string();
        unused.erase(room);
        unused.erase(file);
        unused.erase(file + ": " + name);
      }
  QVERIFY2(unused.empty(), unused.empty() ? "" : unused.begin()->c_str());
}

void FramesTest::DeclarationsAreSeen() {
  const auto found = bare_points(
      "Points a; void f(const Points& b, const Points c_in_ct); Points g();\n"
      "std::vector<Points> d; PointsIn<CtFrame> e; BoundPoints h;");
  QVERIFY((found == std::vector<std::string>{"a", "b", "c_in_ct", "g", ""}));
  QVERIFY(says_frame("nodes_in_camera") && says_frame("rest_") && !says_frame("nodes") && !says_frame(""));
}

QTEST_APPLESS_MAIN(FramesTest)
#include "frames_test.moc"
