// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/pulled_organ.h"

#include <QTest>

#include "../registration/phantom.h"
#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"

using namespace glisson;
using namespace glisson::insilico;

class PulledOrganTest : public QObject {
  Q_OBJECT
 private slots:
  void MovesAsFarAsIsAskedAndHoldsWhatIsHeld() {
    PulledOrganOptions options;
    options.mean_motion_mm = 6.0;
    options.frames = 3;
    const PulledOrgan organ = pull(options);
    QVERIFY(organ.frames.size() == 3);
    QVERIFY(organ.mean_motion > 3e-3 && organ.mean_motion < 6.3e-3);
    QVERIFY(organ.largest_motion <= 0.0515);
    const std::vector<int> held = held_nodes(mesh_, organ);
    QVERIFY(held.size() >= 3);
    for (const PulledFrame& frame : organ.frames)
      for (const int node : held) QVERIFY((frame.nodes.row(node) - mesh_.vertices.row(node)).norm() == 0.0);
    QVERIFY((organ.frames[1].nodes - organ.frames[0].nodes).norm() > 0.0);
  }

  void TheCloudLiesOnWhatIsSeenAndCarriesItsNoise() {
    PulledOrganOptions options;
    options.mean_motion_mm = 5.0;
    const auto distance = [&](double noise) {
      options.noise_mm = noise;
      const PulledOrgan organ = pull(options);
      TriangleMesh now = boundary_surface(mesh_).mesh;
      const BoundarySurface surface = boundary_surface(mesh_);
      for (int v = 0; v < now.vertex_count(); ++v)
        now.vertices.row(v) = organ.frames[0].nodes.row(surface.node_of_vertex[static_cast<std::size_t>(v)]);
      const ClosestPointTree tree(now);
      double sum = 0.0;
      for (const auto& p : organ.frames[0].cloud.rowwise()) sum += tree.closest(p.transpose()).distance;
      return sum / static_cast<double>(organ.frames[0].cloud.rows());
    };
    QVERIFY(distance(0.0) < 1e-9);
    const double noisy = distance(1.0);  // the mean of |N(0, 1)| across the surface is 0.8
    QVERIFY(noisy > 0.5e-3 && noisy < 1.1e-3);
  }

  void TheSameSeedGivesTheSameOrgan() {
    PulledOrganOptions options;
    options.mean_motion_mm = 4.0;
    const PulledOrgan a = pull(options), b = pull(options);
    QVERIFY((a.frames[0].nodes.array() == b.frames[0].nodes.array()).all());
    QVERIFY((a.frames[0].cloud.array() == b.frames[0].cloud.array()).all());
    options.seed = 2;
    QVERIFY((pull(options).frames[0].cloud - a.frames[0].cloud).norm() > 1e-3);
  }

  void RefusesUnusableOptions() {
    const auto refused = [&](const auto& change) {
      PulledOrganOptions options;
      change(options);
      QVERIFY_THROWS_EXCEPTION(InputError, pull(options));
    };
    refused([](auto& o) { o.patches = 4; });
    refused([](auto& o) { o.smallest_patch_cm2 = 0.0; });
    refused([](auto& o) { o.mean_motion_mm = 0.0; });
    refused([](auto& o) { o.largest_motion_mm = -1.0; });
    refused([](auto& o) { o.poisson_ratio = 0.5; });
    refused([](auto& o) { o.held_radius_mm = 0.0; });
    refused([](auto& o) { o.seen_share = 0.0; });
    refused([](auto& o) { o.points = 5; });
    refused([](auto& o) { o.noise_mm = -1.0; });
    refused([](auto& o) { o.frames = 0; });
  }

 private:
  PulledOrgan pull(const PulledOrganOptions& options) const {
    return *pull_organ(mesh_, options, RunContext());
  }
  TetMesh mesh_ = phantom::tetrahedra(8, 6, 4);
};

QTEST_APPLESS_MAIN(PulledOrganTest)
#include "pulled_organ_test.moc"
