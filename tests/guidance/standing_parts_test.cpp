// SPDX-License-Identifier: GPL-3.0-or-later
// A part of the picture that stands while the organ goes on, and films in which parts only seem to.
#include <QTest>
#include <functional>

#include "glisson/guidance/tracker.h"
#include "judged_film.h"
#include "standing_parts.h"

using namespace glisson;
using namespace glisson::guidance;

namespace {

constexpr int kFrames = 28, kOnset = 8;

/// One view's picture k, from its film and from what was shown before.
using Show = std::function<Picture(const std::vector<Picture>& film, int k, const Picture& shown_before)>;

Picture put_together(const Picture& a, const Picture& b, const std::function<bool(int x, int y)>& is_b) {
  Picture result = a;
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*a.bytes);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const auto i = static_cast<std::size_t>(y * a.width + x);
      if (is_b(x, y)) (*bytes)[i] = (*b.bytes)[i];
    }
  result.bytes = bytes;
  return result;
}

const Picture& at(const std::vector<Picture>& film, int k) {
  return film[static_cast<std::size_t>(std::max(0, k))];
}

/// What lies left (or right) of a column is that of the onset.
Show stands_beside(int column, bool is_left) {
  return [=](const std::vector<Picture>& film, int k, const Picture&) {
    return put_together(at(film, k), at(film, std::min(k, kOnset)),
                        [=](int x, int) { return (x < column) == is_left; });
  };
}

/// A codec that repeats each block of 16 x 16 that has changed little, and smooths the noise of all others.
Picture coded(const Picture& now, const Picture& before, double skips_below) {
  constexpr int kBlock = 16, kQuantum = 6;
  Picture result = now;
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*now.bytes);
  for (int top = 0; top < now.height; top += kBlock)
    for (int left = 0; left < now.width; left += kBlock) {
      double change = 0.0;
      const auto each = [&](const auto& act) {
        for (int y = top; y < std::min(now.height, top + kBlock); ++y)
          for (int x = left; x < std::min(now.width, left + kBlock); ++x)
            act(static_cast<std::size_t>(y * now.width + x));
      };
      each([&](std::size_t i) { change += std::abs((*now.bytes)[i] - (*before.bytes)[i]); });
      const bool is_same = change < skips_below * kBlock * kBlock;
      each([&](std::size_t i) {
        (*bytes)[i] = is_same
                          ? (*before.bytes)[i]
                          : static_cast<std::uint8_t>(std::min(255, (*now.bytes)[i] / kQuantum * kQuantum));
      });
    }
  result.bytes = bytes;
  return result;
}

double share_of_same(const Picture& a, const Picture& b) {
  double same = 0.0;
  for (std::size_t i = 0; i < a.bytes->size(); ++i) same += (*a.bytes)[i] == (*b.bytes)[i];
  return same / static_cast<double>(a.bytes->size());
}

}  // namespace

class StandingPartsTest : public QObject, private phantom::JudgedFilm {
  Q_OBJECT
 private slots:
  void initTestCase();
  void HalfAPictureThatStandsIsWithdrawn_data();
  void HalfAPictureThatStandsIsWithdrawn();
  void WhatGoesOnIsNotTold_data();
  void WhatGoesOnIsNotTold();

 private:
  struct Film {
    std::vector<Picture> left, right;
    std::vector<Eigen::Vector3d> ways;  ///< of the organ since the first frame, metres
  };
  /// @param rests from this frame on organ and scope stand.
  Film filmed(int rests) const {
    Film film;
    for (int k = 0; k < kFrames; ++k) {
      const int moves = std::min(k, rests);
      film.ways.emplace_back(0.0, 0.5e-3 * moves, -0.2e-3 * moves);
      const StereoFrame one = phantom::film(model_, moved(film.ways.back()), rig_, k);
      film.left.push_back(one.left);
      film.right.push_back(one.right);
    }
    return film;
  }
  /// Frame k as it is shown after `before`.
  static StereoFrame shown(const Film& film, const Show& show, int k, const StereoFrame& before) {
    StereoFrame now;
    now.index = k;
    now.seconds = k / 30.0;
    now.left = show(film.left, k, k > 0 ? before.left : film.left[0]);
    now.right = show(film.right, k, k > 0 ? before.right : film.right[0]);
    return now;
  }
  /// Where the tissue is that lies at these rays in the first frame.
  std::vector<FollowedPoint> truly_followed(const Eigen::Vector3d& way) const {
    std::vector<FollowedPoint> points;
    for (int i = 0; i < static_cast<int>(on_organ_.size()); ++i) {
      FollowedPoint point;
      point.id = i;
      point.p_in_camera = on_organ_[static_cast<std::size_t>(i)] + way;
      point.left = rig_.left.project(point.p_in_camera);
      point.right = rig_.right.project(rig_.right_from_left.rotation * point.p_in_camera +
                                       rig_.right_from_left.translation);
      points.push_back(point);
    }
    return points;
  }

  Film moving_, resting_;
  std::vector<Eigen::Vector3d> on_organ_;  ///< in the first frame
};

void StandingPartsTest::initTestCase() {
  make_film();
  moving_ = filmed(kFrames);
  resting_ = filmed(kOnset);
  TriangleMesh surface = model_.surface.mesh;
  for (int i = 0; i < surface.vertex_count(); ++i)
    surface.vertices.row(i) = nodes_.row(model_.surface.node_of_vertex[static_cast<std::size_t>(i)]);
  const ClosestPointTree tree(surface);
  for (int y = 8; y < rig_.left.height; y += 16)
    for (int x = 8; x < rig_.left.width; x += 16) {
      const Eigen::Vector3d ray = rig_.left.ray({static_cast<double>(x), static_cast<double>(y)});
      const ClosestPoint hit = tree.first_hit(Eigen::Vector3d::Zero(), ray);
      if (hit.triangle >= 0) on_organ_.push_back(hit.point);
    }
  QVERIFY(on_organ_.size() > 100);
}

void StandingPartsTest::HalfAPictureThatStandsIsWithdrawn_data() {
  QTest::addColumn<int>("column");
  QTest::addColumn<bool>("is_left");
  QTest::newRow("left half") << 160 << true;
  QTest::newRow("right half") << 160 << false;
  QTest::newRow("left of a column within a part") << 175 << true;
}

void StandingPartsTest::HalfAPictureThatStandsIsWithdrawn() {
  QFETCH(int, column);
  QFETCH(bool, is_left);
  const Show show = stands_beside(column, is_left);
  Registration start;
  start.nodes_in_camera = nodes_;
  TrackerOptions options = JudgedFilm::options();
  options.points = 160;
  Tracker tracker(model_, start, options);
  StereoFrame now = shown(moving_, show, 0, {});
  tracker.begin(rig_, now, {});
  for (int k = 1; k < kFrames; ++k) {
    now = shown(moving_, show, k, now);
    const Validity said = tracker.follow(now).validity;
    if (k <= kOnset) QVERIFY2(said == Validity::valid, validity_code(said));
    if (k >= kOnset + 11) QVERIFY2(said == Validity::picture_stands, validity_code(said));
  }
}

void StandingPartsTest::WhatGoesOnIsNotTold_data() {
  QTest::addColumn<QString>("way");
  QTest::addColumn<bool>("rests");
  for (const char* way :
       {"raw", "torn", "interlaced", "letterboxed", "stutters", "coded", "coded coarsely", "stands"}) {
    QTest::addRow("%s", way) << QString(way) << false;
    QTest::addRow("%s, organ and scope come to rest", way) << QString(way) << true;
  }
}

void StandingPartsTest::WhatGoesOnIsNotTold() {
  QFETCH(QString, way);
  QFETCH(bool, rests);
  const Picture black = phantom::plain(rig_.left, 0);
  const auto show = [&](const std::vector<Picture>& film, int k, const Picture& before) {
    const Picture &now = at(film, k), &last = at(film, k - 1);
    if (way == "torn") return put_together(now, last, [&](int, int y) { return y > 40 + 7 * k; });
    if (way == "interlaced") return put_together(now, last, [](int, int y) { return y % 2 == 1; });
    if (way == "letterboxed") return put_together(now, black, [](int, int y) { return y < 50 || y >= 190; });
    if (way == "stutters") return at(film, k - k % 3);
    if (way == "coded") return coded(now, before, 2.5);
    if (way == "coded coarsely") return coded(now, before, 4.0);
    if (way == "stands") return at(film, std::min(k, kOnset));
    return now;
  };
  StandingParts parts(rig_);
  FrameClock clock;
  StereoFrame now, before;
  double same = 0.0;  // share of grey levels, over all frames
  const Film& film = rests ? resting_ : moving_;
  for (int k = 0; k < kFrames; ++k) {
    before = now;
    now = shown(film, show, k, before);
    if (k > 0) same += share_of_same(now.left, before.left) / (kFrames - 1.0);
    clock.tick(now.seconds);
    const int seen = way == "stutters" ? k - k % 3 : way == "stands" ? std::min(k, kOnset) : k;
    parts.push(now, truly_followed(film.ways[static_cast<std::size_t>(seen)]), clock);
    QVERIFY2(!parts.any(), qPrintable(QString::number(k)));
  }
  if (way.startsWith("coded"))
    QVERIFY2(same > 0.3, qPrintable(QString::number(same)));  // it does repeat blocks
}

QTEST_APPLESS_MAIN(StandingPartsTest)
#include "standing_parts_test.moc"
