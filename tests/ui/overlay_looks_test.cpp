// SPDX-License-Identifier: GPL-3.0-or-later
// How depth is told: windows, contours, outlines, and what is left out.
#include <QTest>
#include <set>

#include "box_patient.h"
#include "glisson/core/error.h"
#include "glisson/ui/scene/headless_gui.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "glisson/ui/scene/picture_image.h"

using namespace glisson;
using scene::Look;

namespace {

constexpr double kBefore = 0.13;  // metres from the camera to the block's middle

Picture grey_frame(const Camera& camera) {
  return {camera.width, camera.height, 3,
          std::make_shared<std::vector<std::uint8_t>>(
              static_cast<std::size_t>(3 * camera.width * camera.height), std::uint8_t{90})};
}

scene::OverlayStyle style_of(Look look) {
  scene::OverlayStyle style;
  style.look = look;
  style.thin_branches = true;
  style.outline = style.anterior_margin = style.legend = style.status = false;
  return style;
}

/// A straight branch along x at a depth below the near side that changes along it.
VesselTree branch(Label structure, double y, double first_depth, double last_depth, double radius) {
  VesselTree tree;
  tree.structure = structure;
  tree.nodes.resize(9, 3);
  for (int i = 0; i < 9; ++i)
    tree.nodes.row(i) << -0.048 + 0.012 * i, y, -0.025 + first_depth + (last_depth - first_depth) * i / 8.0;
  tree.radii.assign(9, radius);
  for (int i = 0; i < 8; ++i) tree.beams.push_back({i, i + 1});
  tree.root = 0;
  return tree;
}

}  // namespace

class OverlayLooksTest : public QObject {
  Q_OBJECT
 private slots:
  void EveryLookIsAnotherPicture();
  void WithoutAFocusTheWindowIsTubes();
  void OutsideTheWindowVesselsAreOutlines();
  void InTheWindowTheNearerHidesTheFarther_data();
  void InTheWindowTheNearerHidesTheFarther();
  void TheWindowFollowsTheChosenLesion();
  void ALesionThatIsNotDrawnOpensNoWindow();
  void ADegradedOverlayHasNoWindow();
  void LinesLieAtEveryTenMillimetres();
  void ThinEndsAreLeftOutAndThinStretchesAreNot();
  void BadWindowsAreRefused();

 private:
  OverlayFrame overlay(const PatientModel& model) const {
    OverlayFrame overlay;
    overlay.validity = Validity::valid;
    overlay.nodes_in_camera = model.mesh.vertices.rowwise() + Eigen::RowVector3d(0.0, 0.0, kBefore);
    LesionVerdict lesion;
    lesion.lesion = structure::kFirstLesion;
    lesion.level = Level::valid;
    lesion.reason = LesionReason::known;
    lesion.centre = {0.03, 0.0, kBefore};
    lesion.radius = 6e-3;
    overlay.lesions = {lesion};
    return overlay;
  }
  Picture paint(const PatientModel& model, const scene::OverlayStyle& style,
                const std::optional<Eigen::Vector2d>& pointer = {}, Label lesion = 0) const {
    scene::OverlayInterest interest;
    interest.pointer = pointer;
    interest.lesion = lesion;
    return scene::OverlayPainter(model, camera_, style)
        .paint(grey_frame(camera_), overlay(model), {}, interest);
  }
  Eigen::Vector2d pixel(const Eigen::Vector3d& p_in_ct) const {
    return camera_.project(p_in_ct + Eigen::Vector3d(0.0, 0.0, kBefore));
  }
  static std::array<int, 3> colour(const Picture& picture, const Eigen::Vector2d& at) {
    const auto i = static_cast<std::size_t>(3 * (std::lround(at.y()) * picture.width + std::lround(at.x())));
    return {(*picture.bytes)[i], (*picture.bytes)[i + 1], (*picture.bytes)[i + 2]};
  }
  static constexpr std::array<int, 3> kGrey = {90, 90, 90};

  Camera camera_ = laparoscope();
};

void OverlayLooksTest::EveryLookIsAnotherPicture() {
  const PatientModel model = box_patient();
  std::set<std::vector<std::uint8_t>> pictures;
  std::set<std::string> codes;
  for (const Look look : scene::kLooks) {
    const Picture picture = paint(model, style_of(look), pixel({0.0, -0.02, 0.0}));
    pictures.insert(*picture.bytes);
    codes.insert(scene::look_code(look));
    if (qEnvironmentVariableIsSet("GLISSON_SAVE_PICTURES"))
      scene::view_as_image(picture).save(qEnvironmentVariable("GLISSON_SAVE_PICTURES") + "/look_" +
                                         scene::look_code(look) + ".png");
  }
  QCOMPARE(pictures.size(), std::size(scene::kLooks));
  QCOMPARE(codes.size(), std::size(scene::kLooks));
}

void OverlayLooksTest::WithoutAFocusTheWindowIsTubes() {
  const PatientModel model = box_patient();
  QVERIFY(*paint(model, style_of(Look::focus)).bytes == *paint(model, style_of(Look::tubes)).bytes);
}

void OverlayLooksTest::OutsideTheWindowVesselsAreOutlines() {
  PatientModel model = box_patient();
  model.vessels = {branch(structure::kPortalVein, 0.0, 0.015, 0.015, 5e-3)};
  model.surfaces.pop_back();  // the lesion
  const Eigen::Vector3d left(-0.03, 0.0, -0.015), right(0.03, 0.0, -0.015), rim(0.03, -4.6e-3, -0.01);
  const Picture picture = paint(model, style_of(Look::focus), pixel(left));
  QVERIFY(colour(picture, pixel(left)) != kGrey);
  QCOMPARE(colour(picture, pixel(right)), kGrey);
  int rim_drawn = 0;
  for (int down = -6; down <= 6; ++down)
    rim_drawn += colour(picture, pixel(rim) + Eigen::Vector2d(0.0, down)) != kGrey;
  QVERIFY(rim_drawn > 0);
  // Opaque inside: of the frame below nothing is left but a trace.
  const auto solid = colour(picture, pixel(left));
  const auto tubes = colour(paint(model, style_of(Look::tubes)), pixel(left));
  QVERIFY(solid != tubes);
}

void OverlayLooksTest::InTheWindowTheNearerHidesTheFarther_data() {
  QTest::addColumn<double>("vessel_depth");
  QTest::addColumn<bool>("vessel_wins");
  QTest::newRow("vessel before the lesion") << 0.008 << true;
  QTest::newRow("vessel behind it") << 0.042 << false;
}

void OverlayLooksTest::InTheWindowTheNearerHidesTheFarther() {
  QFETCH(double, vessel_depth);
  QFETCH(bool, vessel_wins);
  PatientModel with_vessel = box_patient(), alone = with_vessel;
  with_vessel.vessels = {branch(structure::kPortalVein, 0.0, vessel_depth, vessel_depth, 3e-3)};
  alone.vessels.clear();
  const Eigen::Vector2d at = pixel({0.03, 0.0, 0.0});
  const auto lesion = colour(paint(alone, style_of(Look::focus), at), at);
  const auto both = colour(paint(with_vessel, style_of(Look::focus), at), at);
  QVERIFY(lesion[2] > 150 && lesion[0] < 120);  // yellow
  if (vessel_wins)
    QVERIFY2(both[0] > both[2], "the vessel is blue, and nothing yellow shines through");
  else
    QVERIFY2(both[2] > 150 && both[0] < 120, "the lesion is before it");
}

void OverlayLooksTest::TheWindowFollowsTheChosenLesion() {
  const PatientModel model = box_patient();
  scene::OverlayStyle style = style_of(Look::focus);
  style.ruler = false;
  const auto free = colour(paint(model, style), pixel({0.03, -0.02, 0.0}));
  const auto chosen = colour(paint(model, style, {}, structure::kFirstLesion), pixel({0.015, 0.0, -0.02}));
  for (const int value : chosen) QVERIFY(std::abs(value - 49.5) <= 1.0);  // tissue steps back by 0.45
  QVERIFY(free != kGrey);
  // The pointer goes before the lesion.
  const auto elsewhere = colour(paint(model, style, pixel({-0.05, 0.0, 0.0}), structure::kFirstLesion),
                                pixel({0.015, 0.0, -0.02}));
  QCOMPARE(elsewhere, kGrey);
}

void OverlayLooksTest::ALesionThatIsNotDrawnOpensNoWindow() {
  const PatientModel model = box_patient();
  scene::OverlayPainter painter(model, camera_, style_of(Look::focus));
  OverlayFrame frame = overlay(model);
  scene::OverlayInterest interest;
  interest.lesion = structure::kFirstLesion;
  for (const Level level : {Level::degraded, Level::withdrawn}) {
    frame.lesions[0].level = level;
    QCOMPARE(colour(painter.paint(grey_frame(camera_), frame, {}, interest), pixel({0.015, 0.0, -0.02})),
             kGrey);
  }
}

void OverlayLooksTest::ADegradedOverlayHasNoWindow() {
  const PatientModel model = box_patient();
  scene::OverlayPainter painter(model, camera_, style_of(Look::focus));
  OverlayFrame frame = overlay(model);
  frame.validity = Validity::partly_covered;
  scene::OverlayInterest interest;
  interest.pointer = pixel({-0.03, 0.03, -0.025});
  const Picture picture = painter.paint(grey_frame(camera_), frame, {}, interest);
  QCOMPARE(colour(picture, *interest.pointer), kGrey);
}

void OverlayLooksTest::LinesLieAtEveryTenMillimetres() {
  PatientModel model = box_patient();
  model.surfaces.pop_back();
  // The upper side of the tube, which the camera sees, lies a radius nearer: 4 mm to 44 mm.
  model.vessels = {branch(structure::kPortalVein, 0.0, 0.006, 0.046, 2e-3)};
  const Picture picture = paint(model, style_of(Look::contours));
  std::vector<double> lines;  // metres below the near side along the line of sight, in each one's middle
  double first_dark = 0.0;
  bool was_dark = false;
  for (double x = -0.044; x < 0.044; x += 1e-4) {
    const double share = (x + 0.048) / 0.096, below = 0.006 + 0.04 * share - 2e-3;
    const Eigen::Vector3d p(x, 0.0, below - 0.025);
    const auto here = colour(picture, pixel(p));
    const bool is_dark = here[0] < 85;  // a band between lines has 110 and more
    const double sight = below * std::hypot(x, p.z() + kBefore) / (p.z() + kBefore);
    if (is_dark && !was_dark) first_dark = sight;
    if (!is_dark && was_dark) lines.push_back(0.5 * (first_dark + sight));
    was_dark = is_dark;
  }
  QCOMPARE(lines.size(), std::size_t{4});
  for (std::size_t i = 0; i < 4; ++i)
    QVERIFY2(std::abs(lines[i] - 0.01 * double(i + 1)) < 6e-4, qPrintable(QString::number(1e3 * lines[i])));
}

void OverlayLooksTest::ThinEndsAreLeftOutAndThinStretchesAreNot() {
  PatientModel model = box_patient();
  model.surfaces.pop_back();
  VesselTree tree = branch(structure::kPortalVein, 0.0, 0.01, 0.01, 3e-3);
  tree.radii[2] = 1e-3;  // thin, but a thick one follows
  tree.radii[6] = tree.radii[7] = tree.radii[8] = 1e-3;
  model.vessels = {tree};
  scene::OverlayStyle style = style_of(Look::tubes);
  const auto at = [&](int node) {
    return colour(paint(model, style), pixel(tree.nodes.row(node).transpose()));
  };
  for (const int node : {2, 4, 8}) QVERIFY(at(node) != kGrey);
  style.thin_branches = false;
  QVERIFY(at(2) != kGrey && at(4) != kGrey);
  QCOMPARE(at(8), kGrey);
}

void OverlayLooksTest::BadWindowsAreRefused() {
  scene::OverlayStyle style;
  for (const double window : {0.0, -0.1, 1.1}) {
    style.window = window;
    QVERIFY_THROWS_EXCEPTION(InputError, style.validate());
  }
}

int main(int argc, char** argv) {
  const scene::HeadlessGui gui;
  OverlayLooksTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "overlay_looks_test.moc"
