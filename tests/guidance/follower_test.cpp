// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <opencv2/core.hpp>

#include "anchored_points.h"
#include "filmed_phantom.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "stereo_follower.h"
#include "triangulate.h"

using namespace glisson;
using namespace glisson::guidance;

class FollowerTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void TriangulationInvertsProjection();
  void InformationIsWeakAlongTheRay();
  void DivergingRaysAreRefused();
  void APixelBeyondTheFoldIsNoPoint();
  void NewPointsLieOnTheTissue();
  void PointsFollowTheTissue();
  void AViewOfAnotherBrightnessIsFollowed();
  void AHighlightStaysOneWhenTheLightRises();
  void ALightThatComesBackSlowlyHidesNoTissue();
  void TheLevelOfTheFirstFrameIsFoundAgain_data();
  void TheLevelOfTheFirstFrameIsFoundAgain();
  void ALightThatStaysAnotherIsTakenOver();
  void ForgottenFrameLeavesThePointsWhereTheyWere();
  void AFrameThatCannotBeReadChangesNothing();
  void LonelyGapIsInconsistentAndCommonMotionIsNot();
  void PicturesOfAnotherSizeAreRefused();
  void ABeadDoesNotHidePlainTissue();
  void NoiseIsNoTexture();
  void PointsStayInsideTheCircle();

 private:
  StereoFollower::Expected expected() const {
    return [this](const Eigen::Vector2d& pixel) -> std::optional<Eigen::Vector3d> {
      const ClosestPoint hit = tree_.first_hit(Eigen::Vector3d::Zero(), rig_.left.ray(pixel));
      if (hit.triangle < 0) return std::nullopt;
      return hit.point;
    };
  }
  FollowerOptions options() const {
    FollowerOptions options;
    options.points = 80;
    return options;
  }
  StereoRig rig_ = phantom::rig();
  PatientModel model_ = phantom::model(8, 6, 3);
  Points nodes_, moved_;
  StereoFrame first_, second_;
  ClosestPointTree tree_;
  const Eigen::Vector3d way_{1.5e-3, -1.0e-3, 1.0e-3};
};

void FollowerTest::initTestCase() {
  nodes_ = phantom::view().apply(model_.mesh.vertices);
  moved_ = nodes_.rowwise() + way_.transpose();
  first_ = phantom::film(model_, nodes_, rig_, 0);
  second_ = phantom::film(model_, moved_, rig_, 1);
  TriangleMesh surface = model_.surface.mesh;
  for (int i = 0; i < surface.vertex_count(); ++i)
    surface.vertices.row(i) = nodes_.row(model_.surface.node_of_vertex[static_cast<std::size_t>(i)]);
  tree_ = ClosestPointTree(surface);
}

void FollowerTest::TriangulationInvertsProjection() {
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d p(0.03 * std::sin(i), 0.02 * std::cos(2.0 * i), 0.09 + 0.03 * std::sin(0.7 * i));
    const Eigen::Vector3d in_right = rig_.right_from_left.rotation * p + rig_.right_from_left.translation;
    const Triangulated found = triangulate(rig_, rig_.left.project(p), rig_.right.project(in_right));
    QVERIFY(found.good);
    QVERIFY((found.p - p).norm() < 1e-6);
    QVERIFY(found.epipolar_px < 1e-3);
  }
}

void FollowerTest::InformationIsWeakAlongTheRay() {
  const Eigen::Vector3d p(0.01, 0.005, 0.1);
  const Eigen::Vector3d in_right = rig_.right_from_left.rotation * p + rig_.right_from_left.translation;
  const Triangulated found = triangulate(rig_, rig_.left.project(p), rig_.right.project(in_right));
  const Eigen::Vector3d along = p.normalized(), across = along.unitOrthogonal();
  QVERIFY(std::abs(across.dot(found.information * across) - 1.0) < 1e-9);
  QVERIFY(along.dot(found.information * along) < 0.01);
  QVERIFY(along.dot(found.information * along) > 0.0);
}

void FollowerTest::DivergingRaysAreRefused() {
  // The left ray to the left, the right ray to the right: they meet behind the cameras.
  QVERIFY(!triangulate(rig_, {20.0, 120.0}, {300.0, 120.0}).good);
}

/// Newton's method came from there to the middle of the picture, which the right view shows, too.
void FollowerTest::APixelBeyondTheFoldIsNoPoint() {
  StereoRig rig = rig_;
  rig.left.distortion << -2.4, 0.0, 0.0, 0.0, 0.0;
  const Eigen::Vector3d p(0.0, 0.0, 0.1);
  const Eigen::Vector2d right =
      rig.right.project(rig.right_from_left.rotation * p + rig.right_from_left.translation);
  QVERIFY((triangulate(rig, rig.left.project(p), right).p - p).norm() < 1e-9);
  const Eigen::Vector2d beyond = rig.left.project(p) + Eigen::Vector2d(0.275 * rig.left.matrix(0, 0), 0.0);
  QVERIFY(rig.left.sees(beyond));
  QVERIFY(!triangulate(rig, beyond, right).good);
}

void FollowerTest::NewPointsLieOnTheTissue() {
  StereoFollower follower(rig_, options());
  follower.begin(first_, {});
  const int added = follower.replenish(expected());
  QVERIFY2(added >= 60, qPrintable(QString::number(added)));
  std::vector<double> off;
  for (const FollowedPoint& point : follower.points())
    off.push_back(tree_.closest(point.p_in_camera).distance);
  const double median = upper_median(off);
  QVERIFY2(median < 1.5e-3, qPrintable(QString::number(median)));
}

void FollowerTest::PointsFollowTheTissue() {
  StereoFollower follower(rig_, options());
  follower.begin(first_, {});
  follower.replenish(expected());
  const std::vector<FollowedPoint> before = follower.points();
  const auto counts = follower.follow(second_);
  QVERIFY(counts.left >= 60 && counts.right >= 60);
  QVERIFY(follower.points().size() >= 55);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const FollowedPoint& point : follower.points())
    for (const FollowedPoint& old : before)
      if (old.id == point.id) mean += point.p_in_camera - old.p_in_camera;
  mean /= static_cast<double>(follower.points().size());
  QVERIFY2((mean - way_).norm() < 0.4e-3, qPrintable(QString::number(1e3 * (mean - way_).norm())));
}

void FollowerTest::AViewOfAnotherBrightnessIsFollowed() {
  const auto changed = [](Picture picture, double gain, double gamma) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture.bytes);
    for (std::uint8_t& byte : *bytes)
      byte = static_cast<std::uint8_t>(255.0 * gain * std::pow(byte / 255.0, gamma));
    picture.bytes = std::move(bytes);
    return picture;
  };
  for (const auto& [gain, gamma] : {std::pair{0.5, 1.0}, {1.0, 0.45}, {1.0, 2.2}})
    for (const bool is_left : {true, false}) {
      StereoFrame first = first_, second = second_;
      for (StereoFrame* frame : {&first, &second}) {
        Picture& view = is_left ? frame->left : frame->right;
        view = changed(view, gain, gamma);
      }
      StereoFollower follower(rig_, options());
      follower.begin(first, {});
      const int added = follower.replenish(expected());
      QVERIFY2(added >= 60, qPrintable(QString::number(added)));
      std::vector<double> off;
      for (const FollowedPoint& point : follower.points())
        off.push_back(tree_.closest(point.p_in_camera).distance);
      QVERIFY(upper_median(off) < 1.5e-3);
      follower.follow(second);
      QVERIFY2(follower.points().size() >= 50, qPrintable(QString::number(follower.points().size())));
    }
}

void FollowerTest::ForgottenFrameLeavesThePointsWhereTheyWere() {
  StereoFollower follower(rig_, options());
  follower.begin(first_, {});
  follower.replenish(expected());
  const std::size_t count = follower.points().size();
  StereoFrame black = second_;
  black.left = phantom::plain(rig_.left, 0);
  black.right = phantom::plain(rig_.right, 0);
  follower.follow(black);
  QVERIFY(follower.points().size() < count / 4);
  follower.forget_last();
  QCOMPARE(follower.points().size(), count);
  follower.follow(second_);
  QVERIFY(follower.points().size() > 0.7 * static_cast<double>(count));
}

void FollowerTest::AFrameThatCannotBeReadChangesNothing() {
  StereoFollower undisturbed(rig_, options()), disturbed(rig_, options());
  StereoFrame broken = second_;
  broken.right = {};
  for (StereoFollower* follower : {&undisturbed, &disturbed}) {
    follower->begin(first_, {});
    follower->replenish(expected());
  }
  QVERIFY_THROWS_EXCEPTION(InputError, disturbed.follow(broken));
  QCOMPARE(disturbed.points().size(), undisturbed.points().size());
  undisturbed.follow(second_);
  disturbed.follow(second_);
  QCOMPARE(disturbed.points().size(), undisturbed.points().size());
  for (std::size_t i = 0; i < disturbed.points().size(); ++i)
    QVERIFY(disturbed.points()[i].left == undisturbed.points()[i].left);
}

void FollowerTest::LonelyGapIsInconsistentAndCommonMotionIsNot() {
  std::vector<FollowedPoint> points(100);
  std::vector<Eigen::Vector3d> gaps(100);
  for (int i = 0; i < 100; ++i) {
    points[static_cast<std::size_t>(i)].p_in_camera = {0.005 * (i % 10), 0.005 * (i / 10), 0.1};
    gaps[static_cast<std::size_t>(i)] = {0.008, 1e-4 * (i % 10), 0.0};
  }
  gaps[37] += Eigen::Vector3d(0.0, 0.006, 0.0);
  const std::vector<char> good = consistent(points, gaps, 4.0, 1.5e-3);
  for (std::size_t i = 0; i < 100; ++i) QCOMPARE(good[i] != 0, i != 37);
}

void FollowerTest::PicturesOfAnotherSizeAreRefused() {
  StereoFollower follower(rig_, options());
  StereoFrame wrong = first_;
  wrong.right.width = 160;
  wrong.right.height = 480;
  QVERIFY_THROWS_EXCEPTION(InputError, follower.begin(wrong, {}));
  wrong = first_;
  wrong.left = {};
  QVERIFY_THROWS_EXCEPTION(InputError, follower.begin(wrong, {}));
  Picture mask = phantom::plain(rig_.left, 255);
  mask.height = 120;
  QVERIFY_THROWS_EXCEPTION(InputError, seen_parts(first_, rig_, mask));
  follower.begin(first_, {});
  QVERIFY_THROWS_EXCEPTION(PreconditionError, follower.keep({1}));
}

namespace {

/// @param gain what the light is multiplied by, in both views.
StereoFrame lit(StereoFrame frame, double gain) {
  for (Picture* view : {&frame.left, &frame.right}) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*view->bytes);
    for (std::uint8_t& byte : *bytes) byte = static_cast<std::uint8_t>(std::min(255.0, gain * byte));
    view->bytes = std::move(bytes);
  }
  return frame;
}

/// How bright the views are that are followed in, over what the camera gave.
double gain_of(const StereoFollower& follower, const StereoFrame& frame) {
  double sum = 0.0;
  for (const std::uint8_t byte : *frame.left.bytes) sum += byte;
  return cv::mean(follower.grey(true))[0] * static_cast<double>(frame.left.bytes->size()) / sum;
}

/// New points on all of the tissue.
int looked_for_again(StereoFollower& follower, const StereoFollower::Expected& expected) {
  follower.keep(std::vector<char>(follower.points().size(), 0));
  return follower.replenish(expected);
}

template <class Change>
Picture changed(const Picture& picture, Change change) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture.bytes);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      std::uint8_t& grey = (*bytes)[static_cast<std::size_t>(y * picture.width + x)];
      grey = static_cast<std::uint8_t>(std::clamp(change(x, y, static_cast<double>(grey)), 0.0, 255.0));
    }
  return {picture.width, picture.height, 1, std::move(bytes)};
}

}  // namespace

void FollowerTest::AHighlightStaysOneWhenTheLightRises() {
  // The lamp is mirrored at one place of the tissue, and then the light rises by a fifth.
  const Eigen::Vector2d at_left(160.0, 120.0);
  const Eigen::Vector3d place = *expected()(at_left);
  const Eigen::Vector2d at_right =
      rig_.right.project(rig_.right_from_left.rotation * place + rig_.right_from_left.translation);
  constexpr double kRadius = 14.0;
  const auto mirrored = [&](StereoFrame frame) {
    for (Picture* view : {&frame.left, &frame.right}) {
      const Eigen::Vector2d middle = view == &frame.left ? at_left : at_right;
      *view = changed(*view, [&](int x, int y, double grey) {
        return (Eigen::Vector2d(x, y) - middle).norm() < kRadius ? 255.0 : grey;
      });
    }
    return frame;
  };
  StereoFollower follower(rig_, options());
  follower.begin(mirrored(lit(first_, 0.8)), {});
  const auto on_highlight = [&] {
    looked_for_again(follower, expected());
    int count = 0;
    for (const FollowedPoint& point : follower.points())
      count += (point.left - at_left).norm() < kRadius + 3.0;
    return count;
  };
  QCOMPARE(on_highlight(), 0);
  follower.follow(mirrored(first_));
  QCOMPARE(on_highlight(), 0);
}

void FollowerTest::ALightThatComesBackSlowlyHidesNoTissue() {
  StereoFollower followed(rig_, options()), fresh(rig_, options());
  followed.begin(first_, {});
  followed.replenish(expected());
  for (double light = 0.5; light < 1.0; light *= 1.04) followed.follow(lit(first_, light));
  followed.follow(first_);
  fresh.begin(first_, {});
  // Brighter than it is, bright tissue would have no texture left, and pass for highlights.
  QVERIFY2(std::abs(gain_of(followed, first_) - 1.0) < 0.01,
           qPrintable(QString::number(gain_of(followed, first_))));
  const int found = looked_for_again(followed, expected()), wanted = looked_for_again(fresh, expected());
  QVERIFY2(found >= 0.9 * wanted, qPrintable(QString("%1 of %2").arg(found).arg(wanted)));
}

void FollowerTest::TheLevelOfTheFirstFrameIsFoundAgain_data() {
  QTest::addColumn<double>("change");
  QTest::newRow("darker") << 0.55;
  QTest::newRow("brighter") << 1.0 / 0.55;
}

void FollowerTest::TheLevelOfTheFirstFrameIsFoundAgain() {
  QFETCH(double, change);
  // Two changes that together are more than is made up for, and back.
  const StereoFrame start = lit(first_, change > 1.0 ? 0.3 : 1.0);
  StereoFollower follower(rig_, options());
  follower.begin(start, {});
  for (const double gain : {change, change * change, change}) follower.follow(lit(start, gain));
  follower.follow(start);
  QVERIFY2(std::abs(gain_of(follower, start) - 1.0) < 0.03,
           qPrintable(QString::number(gain_of(follower, start))));
}

void FollowerTest::ALightThatStaysAnotherIsTakenOver() {
  const StereoFrame dark = lit(first_, 0.6);
  StereoFollower follower(rig_, options());
  follower.begin(first_, {});
  const int began = follower.replenish(expected());
  follower.follow(dark);
  double gain = gain_of(follower, dark);
  QVERIFY2(std::abs(gain - 1.0 / 0.6) < 0.05, qPrintable(QString::number(gain)));
  for (int k = 0; k < 100; ++k) follower.follow(dark);
  gain = gain_of(follower, dark);
  QVERIFY2(std::abs(gain - 1.0) < 0.01, qPrintable(QString::number(gain)));
  // Slowly enough that no point moves.
  QVERIFY2(follower.points().size() > 0.9 * began, qPrintable(QString::number(follower.points().size())));
  for (const FollowedPoint& point : follower.points())
    QVERIFY2(tree_.closest(point.p_in_camera).distance < 8e-3,
             qPrintable(QString::number(1e3 * tree_.closest(point.p_in_camera).distance)));
}

void FollowerTest::ABeadDoesNotHidePlainTissue() {
  // A real liver's texture is faint, and what lies on it (a clip, the rim of a highlight) is not.
  const auto faint = [](int, int, double grey) { return 80.0 + 0.25 * (grey - 80.0); };
  const auto bead = [](int x, int y, double grey) {
    return std::hypot(x - 160, y - 120) < 6.0 ? 240.0 : grey;
  };
  StereoFrame plain = first_;
  plain.left = changed(first_.left, faint);
  plain.right = changed(first_.right, faint);
  StereoFrame beaded = plain;
  beaded.left = changed(plain.left, bead);
  StereoFollower without(rig_, options()), with(rig_, options());
  without.begin(plain, {});
  with.begin(beaded, {});
  const int found = without.replenish(expected()), beside = with.replenish(expected());
  QVERIFY2(found >= 40 && beside >= found - 8, qPrintable(QString("%1, %2").arg(found).arg(beside)));
}

void FollowerTest::NoiseIsNoTexture() {
  StereoFrame noise = first_;
  const auto random = [](int x, int y, double) { return 80.0 + 20.0 * phantom::hashed(x, y, 3); };
  noise.left = changed(first_.left, random);
  noise.right = changed(first_.right, random);
  StereoFollower follower(rig_, options());
  follower.begin(noise, {});
  const int found = follower.replenish(expected());
  QVERIFY2(found <= 2, qPrintable(QString::number(found)));
}

void FollowerTest::PointsStayInsideTheCircle() {
  // The rim of the laparoscope's picture is sharp, and stands whatever the tissue does.
  const auto inside = [](double x, double y) { return std::hypot(x - 160.0, y - 120.0) < 85.0; };
  const auto scope = [&](int x, int y, double grey) { return inside(x, y) ? grey + 30.0 : 2.0; };
  const auto seen = [&](const StereoFrame& frame) {
    StereoFrame round = frame;
    round.left = changed(frame.left, scope);
    round.right = changed(frame.right, scope);
    return round;
  };
  const StereoFrame first = seen(first_);
  StereoFollower follower(rig_, options());
  follower.begin(first, seen_parts(first, rig_, {}));
  QVERIFY(follower.replenish(expected()) >= 20);
  follower.follow(seen(second_));
  QVERIFY(follower.points().size() >= 15);
  for (const FollowedPoint& point : follower.points())
    QVERIFY(inside(point.left.x(), point.left.y()) && inside(point.right.x(), point.right.y()));
}

QTEST_APPLESS_MAIN(FollowerTest)
#include "follower_test.moc"
