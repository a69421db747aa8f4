// SPDX-License-Identifier: GPL-3.0-or-later
// Points in public headers say their frame: by their name (nodes_in_camera) or by their type
// (PointsIn<CtFrame>). A single place may also say it in the comment beside it, and so may whatever no other
// room is built on: the window's. Rooms of any frame are those of the plan (house.txt).
#include <QTest>

#include "house.h"

using namespace glisson::house;
namespace fs = std::filesystem;

namespace {

/// Headers and declarations whose points are in any one frame, and why.
const std::map<std::string, std::string>& of_any_frame() {
  static const std::map<std::string, std::string> kReasons = {
      {"atlas/shape_model.h", "brings shapes of whichever frames into one another's"},
      {"atlas/correspond.h: vertices", "of a template on a liver: in the liver's frame"},
      {"atlas/member.h: contact", "in the frame of the liver"},
      {"atlas/member.h: ordered_points", "in the frame of `raw`, which `upright` turns"},
      {"atlas/member.h: raw", "of ordered_points"},
      {"atlas/member.h: notch", "of ordered_points"},
      {"atlas/member.h: resampled", "a line stays in its frame"},
      {"atlas/member.h: line", "of resampled"},
      {"atlas/member.h: points", "of places_of: in the frame of the surface"},
      {"atlas/member.h: points_at", "in the frame of the surface"},
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

bool is_excused(const std::string& room, const std::string& file, const std::string& name) {
  return plan().any_frame.contains(room) || of_any_frame().contains(file) ||
         of_any_frame().contains(file + ": " + name);
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

/// Names of single vectors that are places and no directions, lengths or weights, by what they are called.
std::vector<std::string> places(const std::string& code) {
  static const std::regex kDeclaration(
      "\\bEigen::(?:Row)?Vector3[df]\\b\\s*(?:const\\b)?\\s*[>&*]*\\s*([A-Za-z_]\\w*)"
      "(?:\\s*=[^,;()]*(?:\\(\\))?,\\s*(\\w+))?");
  static const std::regex kPlace(
      "(?:\\w+_)?(?:p|at|to|from|place|point|position|centre|middle|origin|target|root|eye|tip|end|corner)");
  std::vector<std::string> names;
  for (auto match = std::sregex_iterator(code.begin(), code.end(), kDeclaration);
       match != std::sregex_iterator(); ++match)
    for (const std::string& name : {(*match)[1].str(), (*match)[2].str()})
      if (std::regex_match(name, kPlace)) names.push_back(name);
  return names;
}

/// What stands between empty lines of a header: declarations with their comments.
std::vector<std::string> paragraphs_of(const std::string& text) {
  static const std::regex kEmptyLine("\\n[ \\t]*\\n");
  return {std::sregex_token_iterator(text.begin(), text.end(), kEmptyLine, -1), {}};
}

bool says_frame(const std::string& name) {
  static const std::regex kFrame(".+_in_(ct|camera|right_camera)");
  const bool is_private = name.ends_with('_');
  return is_private || std::regex_match(name, kFrame);
}

/// Whether a paragraph says where its places are: in a frame, or that they are voxels.
bool tells_frame(const std::string& paragraph) {
  static const std::regex kFrame("\\b(?:CT|LPS|camera|frame|index)\\b");
  return std::regex_search(paragraph, kFrame);
}

}  // namespace

class FramesTest : public QObject {
  Q_OBJECT
 private slots:
  void PointsSayTheirFrame();
  void SinglePlacesSayTheirFrame();
  void EveryExceptionIsNeeded();
  void DeclarationsAreSeen();
  void SinglePlacesAreSeen();
};

void FramesTest::PointsSayTheirFrame() {
  std::string offences;
  for (const auto& [room, headers] : public_headers(true))
    for (const fs::path& header : headers) {
      const std::string file = room + "/" + header.filename().string();
      for (const std::string& paragraph : paragraphs_of(text_of(header)))
        for (const std::string& name : bare_points(code_in(paragraph)))
          if (!says_frame(name) && !is_excused(room, file, name) &&
              (is_module(room) || !tells_frame(paragraph)))
            offences += file + ": Points " + name + "\n";
    }
  QVERIFY2(offences.empty(),
           ("say the frame, as nodes_in_camera or PointsIn<CtFrame>:\n" + offences).c_str());
}

void FramesTest::SinglePlacesSayTheirFrame() {
  std::string offences;
  int seen = 0;
  for (const auto& [room, headers] : public_headers(true))
    for (const fs::path& header : headers) {
      const std::string file = room + "/" + header.filename().string();
      for (const std::string& paragraph : paragraphs_of(text_of(header)))
        for (const std::string& name : places(code_in(paragraph))) {
          ++seen;
          if (!says_frame(name) && !tells_frame(paragraph) && !is_excused(room, file, name))
            offences += file + ": " + name + "\n";
        }
    }
  QVERIFY2(seen > 30, qPrintable(QString::number(seen)));
  QVERIFY2(offences.empty(),
           ("say the frame in the name (p_in_ct), the type (Point<CtFrame>) or the comment:\n" + offences)
               .c_str());
}

void FramesTest::EveryExceptionIsNeeded() {
  std::set<std::string> unused = plan().any_frame;
  for (const auto& [what, why] : of_any_frame()) unused.insert(what);
  for (const auto& [room, headers] : public_headers(true))
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

void FramesTest::SinglePlacesAreSeen() {
  const std::vector<std::string> paragraphs = paragraphs_of(
      "/// Voxels.\nEigen::Vector3d normal(const Eigen::Vector3d& at, double to) const;\n\n"
      "struct Edit {\n  Eigen::Vector3d at = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  ///< CT "
      "frame\n  std::optional<Eigen::Vector3d> held_centre;\n};");
  QCOMPARE(paragraphs.size(), std::size_t{2});
  QVERIFY((places(code_in(paragraphs[0])) == std::vector<std::string>{"at"}));
  QVERIFY((places(code_in(paragraphs[1])) == std::vector<std::string>{"at", "to", "held_centre"}));
  QVERIFY(!tells_frame(paragraphs[0]) && tells_frame(paragraphs[1]));
}

QTEST_APPLESS_MAIN(FramesTest)
#include "frames_test.moc"
