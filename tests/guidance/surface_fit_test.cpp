// SPDX-License-Identifier: GPL-3.0-or-later
// The rigid motion that a seen surface asks for. What is seen is cast here, on the phantom's own surface.
#include "surface_fit.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "filmed_phantom.h"

using namespace glisson;
using namespace glisson::guidance;

class SurfaceFitTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void ARightPlaceAsksForNothing();
  void AnOrganElsewhereIsFoundThere_data();
  void AnOrganElsewhereIsFoundThere();
  void WhatFitsBadlyIsLessSure();
  void NothingSeenTellsNothing();

 private:
  /// What a camera sees of the organ there, a ray in `kEvery` pixels. @param waves metres, of a shape that no
  /// rigid motion gives.
  std::vector<SeenPlace> seen(const Points& nodes, double waves = 0.0) const {
    constexpr int kEvery = 10;
    TriangleMesh surface = film_.model.surface.mesh;
    for (int i = 0; i < surface.vertex_count(); ++i)
      surface.vertices.row(i) = nodes.row(film_.model.surface.node_of_vertex[static_cast<std::size_t>(i)]);
    const ClosestPointTree tree(surface);
    const Camera& camera = film_.rig.left;
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.7e-3);
    std::vector<SeenPlace> places;
    for (int y = kEvery / 2; y < camera.height; y += kEvery)
      for (int x = kEvery / 2; x < camera.width; x += kEvery) {
        const Eigen::Vector3d ray = camera.ray({static_cast<double>(x), static_cast<double>(y)}).normalized();
        const ClosestPoint hit = tree.first_hit(Eigen::Vector3d::Zero(), ray);
        if (hit.triangle < 0) continue;
        const double wave = waves * std::sin(0.05 * x) * std::sin(0.05 * y);
        const double range = hit.point.norm() + noise(random) + wave;
        places.push_back({range * ray, 0.7e-3, 5 * (5 * y / camera.height) + 5 * x / camera.width});
      }
    return places;
  }
  Points moved(const Eigen::Vector3d& by) const { return film_.nodes.rowwise() + by.transpose(); }
  SurfacePull fitted(const Points& nodes, const std::vector<SeenPlace>& places) const {
    registration::MovingSurface surface(film_.model, registration::SurfaceDetail::fine);
    surface.move(nodes);
    registration::NormalMemo normals;
    return fit_to_seen(surface, normals, places, {});
  }
  static QByteArray text(const SurfacePull& found) {
    return QString("pull %1 mm, sigma %2 mm").arg(1e3 * found.pull).arg(1e3 * found.sigma).toUtf8();
  }

  phantom::BreathingFilm film_;
  std::vector<SeenPlace> seen_;
};

void SurfaceFitTest::initTestCase() {
  seen_ = seen(film_.nodes);
  QVERIFY(seen_.size() > 300);
}

void SurfaceFitTest::ARightPlaceAsksForNothing() {
  const SurfacePull found = fitted(film_.nodes, seen_);
  QVERIFY2(found.pull < 1.5e-3 && found.sigma < 4e-3, text(found));
}

void SurfaceFitTest::AnOrganElsewhereIsFoundThere_data() {
  QTest::addColumn<Eigen::Vector3d>("off");
  QTest::newRow("up by 12 mm") << Eigen::Vector3d(0.0, -12e-3, 0.0);
  QTest::newRow("up by 25 mm") << Eigen::Vector3d(0.0, -25e-3, 0.0);
  QTest::newRow("down by 25 mm") << Eigen::Vector3d(0.0, 25e-3, 0.0);
  QTest::newRow("nearer by 20 mm") << Eigen::Vector3d(0.0, 0.0, -20e-3);
  QTest::newRow("farther by 20 mm") << Eigen::Vector3d(0.0, 0.0, 20e-3);
}

void SurfaceFitTest::AnOrganElsewhereIsFoundThere() {
  QFETCH(Eigen::Vector3d, off);
  const SurfacePull found = fitted(moved(off), seen_);
  QVERIFY2(std::abs(found.pull - off.norm()) < 0.25 * off.norm(), text(found));
  QVERIFY2(found.sigma < 0.4 * off.norm(), text(found));
}

void SurfaceFitTest::WhatFitsBadlyIsLessSure() {
  const SurfacePull smooth = fitted(film_.nodes, seen_), wavy = fitted(film_.nodes, seen(film_.nodes, 8e-3));
  QVERIFY2(wavy.sigma > 1.3 * smooth.sigma, text(wavy) + " after " + text(smooth));
}

void SurfaceFitTest::NothingSeenTellsNothing() {
  const SurfacePull found = fitted(film_.nodes, {});
  QVERIFY2(found.pull < 1e-6 && found.sigma > 20e-3, text(found));
}

QTEST_APPLESS_MAIN(SurfaceFitTest)
#include "surface_fit_test.moc"
