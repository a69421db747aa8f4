// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to a handled liver, read from its shape: where even tissue so bent would be without force, and
// where it would not. The forces are fem's, which has tests of its own.
#include <QTest>
#include <cmath>
#include <set>

#include "glisson/fem/composite_model.h"
#include "glisson/geometry/topology.h"
#include "glisson/insilico/handled_liver.h"
#include "theatre_anatomy.h"
#include "theatre_patient.h"

using namespace glisson;
using namespace glisson::insilico;

namespace {

constexpr int kVertices = 400;
const Eigen::Vector3d kAnterior(0.0, -1.0, 0.0);

/// A handled liver's nodes, and the forces by which even tissue would hold against what was done.
struct Held {
  TetMesh mesh;          ///< at rest, CT frame
  Points force;          ///< internal, N, one a node
  Eigen::VectorXd mass;  ///< kg, one a node
  BoundarySurface surface;
  Points area;  ///< of the handled surface's vertices, outward, m2
  Points cava;
};

Held held(const PatientModel& patient, Handling handling) {
  HandlingOptions options;
  options.handling = handling;
  options.truth_vertices = kVertices;
  const auto handled = HandledLiver::build(patient, options, RunContext());
  Held found{*truth_mesh(liver_of(patient), kVertices, RunContext()),
             {},
             {},
             {},
             {},
             handled->landmarks().vena_cava};
  const Points now = handled->camera_from_ct().inverse().apply(handled->carry(found.mesh.vertices));
  fem::CompositeOptions even;
  even.with_capsule = even.with_vessels = false;
  even.law = fem::TetrahedronLaw::neo_hookean;
  even.parenchyma = {6200.0, 0.47};
  const fem::CompositeModel model(found.mesh, {}, even);
  found.force = model.internal_force(now);
  found.mass = model.lumped_mass();
  found.surface = boundary_surface(found.mesh);
  TriangleMesh outside = found.surface.mesh;
  for (int v = 0; v < outside.vertex_count(); ++v)
    outside.vertices.row(v) = now.row(found.surface.node_of_vertex[static_cast<std::size_t>(v)]);
  found.area = Points::Zero(outside.vertex_count(), 3);
  for (int t = 0; t < outside.triangle_count(); ++t) {
    const Eigen::Vector3d a = outside.vertex(outside.triangles(t, 0));
    const Eigen::Vector3d sixth =
        (outside.vertex(outside.triangles(t, 1)) - a).cross(outside.vertex(outside.triangles(t, 2)) - a) /
        6.0;
    for (int k = 0; k < 3; ++k) found.area.row(outside.triangles(t, k)) += sixth.transpose();
  }
  return found;
}

/// Root mean square over nodes, N.
double size(const Points& force, const std::set<int>& nodes) {
  double sum = 0.0;
  for (const int node : nodes) sum += force.row(node).squaredNorm();
  return std::sqrt(sum / static_cast<double>(nodes.size()));
}

std::set<int> outer(const Held& liver) {
  return {liver.surface.node_of_vertex.begin(), liver.surface.node_of_vertex.end()};
}
std::set<int> inner(const Held& liver) {
  std::set<int> nodes;
  const std::set<int> outside = outer(liver);
  for (int node = 0; node < liver.mesh.vertex_count(); ++node)
    if (!outside.contains(node)) nodes.insert(node);
  return nodes;
}

double from_cava(const Held& liver, const Eigen::Vector3d& p) {
  return (liver.cava.rowwise() - p.transpose()).rowwise().norm().minCoeff();
}

}  // namespace

class HandledForcesTest : public QObject {
  Q_OBJECT
 private slots:
  /// No tool and no gas reaches inner nodes: what pulls there is that tissue differs from place to place.
  void StiffenedTissueIsNotEven() {
    const auto share = [this](Handling handling) {
      const Held liver = held(patient_, handling);
      return size(liver.force, inner(liver)) / size(liver.force, outer(liver));
    };
    const double lifted = share(Handling::lifted), stiffened = share(Handling::stiffened);
    qInfo("inner over outer forces: lifted %.4f, stiffened %.4f", lifted, stiffened);
    QVERIFY(lifted < 0.02);
    QVERIFY(stiffened > 0.1);
  }

  /// The same pressure on all of the front, across the surface as it lies now.
  void GasPressesTheFrontEvenly() {
    const Held liver = held(patient_, Handling::inflated);
    double sum = 0.0, squares = 0.0, aside = 0.0, n = 0.0;
    for (int v = 0; v < liver.surface.mesh.vertex_count(); ++v) {
      const Eigen::Vector3d area = liver.area.row(v).transpose();
      if (area.normalized().dot(kAnterior) < 0.5 || from_cava(liver, liver.surface.mesh.vertex(v)) < 0.06)
        continue;
      const Eigen::Vector3d force =
          liver.force.row(liver.surface.node_of_vertex[static_cast<std::size_t>(v)]).transpose();
      const double pressure = force.dot(area) / area.squaredNorm();
      sum += pressure;
      squares += pressure * pressure;
      aside += (force - pressure * area).squaredNorm() / area.squaredNorm();
      n += 1.0;
    }
    const double mean = sum / n, deviation = std::sqrt(std::max(0.0, squares / n - mean * mean));
    qInfo("%.0f Pa, deviation %.1f, along the surface %.1f", mean, deviation, std::sqrt(aside / n));
    QVERIFY(mean > 100.0 && mean < 3000.0);
    QVERIFY(deviation < 0.1 * mean && std::sqrt(aside / n) < 0.1 * mean);
  }

  /// But for its weight nothing holds a loosened liver behind and above the vena cava; a turned one hangs
  /// there.
  void ALoosenedOneHasLostItsBareArea() {
    const Eigen::Vector3d behind_and_above = Eigen::Vector3d(-0.3, 0.6, 0.75).normalized();
    const auto hanging = [&](Handling handling) {
      const Held liver = held(patient_, handling);
      Eigen::RowVector3d pull = Eigen::RowVector3d::Zero();  // of weight, by what inner nodes feel of it
      double squares = 0.0;
      for (const int node : inner(liver)) {
        pull -= liver.mass[node] * liver.force.row(node);
        squares += liver.mass[node] * liver.mass[node];
      }
      pull /= squares;
      const Points rest = liver.force + liver.mass * pull;
      const Points normals = vertex_normals(liver.surface.mesh);
      std::set<int> bare;
      for (int v = 0; v < liver.surface.mesh.vertex_count(); ++v) {
        const double away = from_cava(liver, liver.surface.mesh.vertex(v));
        if (away > 0.017 && away < 0.054 && normals.row(v).dot(behind_and_above) > 0.52)
          bare.insert(liver.surface.node_of_vertex[static_cast<std::size_t>(v)]);
      }
      return bare.size() < 3 ? -1.0 : size(rest, bare) / (pull.norm() * liver.mass.mean());
    };
    const double loosened = hanging(Handling::loosened), turned = hanging(Handling::turned);
    // -1: there are no such nodes.
    qInfo("held at the bare area, over a node's weight: loosened %.3f, turned %.3f", loosened, turned);
    QVERIFY(loosened >= 0.0 && loosened < 0.05);
    QVERIFY(turned > 0.3);
  }

 private:
  PatientModel patient_ = insilico::test::small_patient();
};

QTEST_APPLESS_MAIN(HandledForcesTest)
#include "handled_forces_test.moc"
