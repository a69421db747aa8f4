// SPDX-License-Identifier: GPL-3.0-or-later
// What the mechanics cannot use is refused, and named.
#include <QTest>
#include <memory>
#include <numeric>

#include "block_mesh.h"
#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/fem/integrator.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

template <class Call>
QString field_of(Call call) {
  return QString::fromStdString(glisson::test::refused_field(call));
}

}  // namespace

class RefusalTest : public QObject {
  Q_OBJECT
 private slots:
  void UnusableMeshesAreNamed() {
    const TetMesh good = block_mesh({2, 2, 2}, {0.02, 0.02, 0.02});
    const auto refused = [](const TetMesh& mesh) { return field_of([&] { CompositeModel(mesh, {}, {}); }); };
    QCOMPARE(refused(good), QString("none"));
    TetMesh mesh = good;
    std::swap(mesh.tetrahedra(7, 0), mesh.tetrahedra(7, 1));
    QVERIFY(refused(mesh).contains("7"));
    mesh = good;
    mesh.tetrahedra.row(9) = mesh.tetrahedra.row(4);
    QVERIFY(refused(mesh).contains("9"));
    mesh = good;
    mesh.tetrahedra.conservativeResize(mesh.tetrahedron_count() + 1, 4);
    mesh.vertices.conservativeResize(mesh.vertex_count() + 1, 3);
    // A sliver: its fourth node in the plane of the others.
    const int last = mesh.vertex_count() - 1;
    mesh.vertices.row(last) = (mesh.vertices.row(0) + mesh.vertices.row(1) + mesh.vertices.row(3)) / 3.0;
    mesh.tetrahedra.bottomRows<1>() << 0, 1, 3, last;
    QVERIFY(refused(mesh).contains(QString::number(mesh.tetrahedron_count() - 1)));
    mesh = good;
    mesh.vertices.conservativeResize(mesh.vertex_count() + 1, 3);
    mesh.vertices.bottomRows<1>().setConstant(0.5);
    QVERIFY(refused(mesh).contains(QString::number(good.vertex_count())));
    mesh = good;
    mesh.labels = {1, 2};
    QCOMPARE(refused(mesh), QString("labels"));
    QCOMPARE(refused(TetMesh{}), QString("tetrahedra"));
  }

  void UnusableOptionsAreNamed() {
    const auto refused = [](const std::function<void(CompositeOptions&)>& change) {
      CompositeOptions options;
      change(options);
      return field_of([&] { options.validate(); });
    };
    QCOMPARE(refused([](CompositeOptions&) {}), QString("none"));
    QCOMPARE(refused([](CompositeOptions& o) { o.parenchyma.young_modulus = 0.0; }),
             QString("young_modulus"));
    QCOMPARE(refused([](CompositeOptions& o) { o.capsule.poisson_ratio = 0.5; }), QString("poisson_ratio"));
    QCOMPARE(refused([](CompositeOptions& o) { o.by_label[16] = {-1.0, 0.3}; }), QString("young_modulus"));
    QCOMPARE(refused([](CompositeOptions& o) { o.capsule_thickness = 0.0; }), QString("capsule_thickness"));
    QCOMPARE(refused([](CompositeOptions& o) { o.wall_fraction = 1.5; }), QString("wall_fraction"));
    QCOMPARE(refused([](CompositeOptions& o) { o.density = std::nan(""); }), QString("density"));
    QCOMPARE(refused([](CompositeOptions& o) { o.rayleigh_mass = -1.0; }), QString("rayleigh_mass"));
    QCOMPARE(refused([](CompositeOptions& o) { o.rayleigh_stiffness = -1.0; }),
             QString("rayleigh_stiffness"));
    IntegratorOptions step;
    step.time_step = 0.0;
    QVERIFY_THROWS_EXCEPTION(InputError, step.validate());
  }

  void UnusableStaticOptionsAreNamed() {
    const auto refused = [](const std::function<void(StaticOptions&)>& change) {
      StaticOptions options;
      change(options);
      return field_of([&] { options.validate(); });
    };
    QCOMPARE(refused([](StaticOptions&) {}), QString("none"));
    QCOMPARE(refused([](StaticOptions& o) { o.max_iterations = 0; }), QString("max_iterations"));
    QCOMPARE(refused([](StaticOptions& o) { o.tolerance = 0.0; }), QString("tolerance"));
    QCOMPARE(refused([](StaticOptions& o) { o.tolerance = 1.0; }), QString("tolerance"));
    QCOMPARE(refused([](StaticOptions& o) { o.tolerance = std::nan(""); }), QString("tolerance"));
    QCOMPARE(refused([](StaticOptions& o) { o.fixed_nodes = {3, -1}; }), QString("fixed_nodes"));
    QCOMPARE(refused([](StaticOptions& o) { o.threads = 3; }), QString("threads"));
    // The solve looks at them, too.
    const CompositeModel model(block_mesh({2, 2, 2}, {0.02, 0.02, 0.02}), {}, {});
    StaticOptions none;
    none.threads = 0;
    QCOMPARE(field_of([&] {
               (void)solve_static(
                   model, model.mesh().vertices, [](const Points&) { return Loads(); }, none, RunContext());
             }),
             QString("threads"));
  }

  void UnusableVesselsAreNamed() {
    const TetMesh mesh = block_mesh({2, 2, 2}, {0.02, 0.02, 0.02});
    const VesselTree good = straight_vessel({0.001, 0.01, 0.01}, {0.019, 0.01, 0.01}, 3, 0.001);
    const auto refused = [&](const std::function<void(VesselTree&)>& change) {
      VesselTree tree = good;
      change(tree);
      return field_of([&] { CompositeModel(mesh, {tree}, {}); });
    };
    QCOMPARE(refused([](VesselTree&) {}), QString("none"));
    QCOMPARE(refused([](VesselTree& t) { t.radii[1] = 0.0; }), QString("radius 1"));
    QCOMPARE(refused([](VesselTree& t) { t.radii.pop_back(); }), QString("radii"));
    QCOMPARE(refused([](VesselTree& t) { t.beams[2] = {0, 99}; }), QString("beam 2"));
    QCOMPARE(refused([](VesselTree& t) { t.nodes(0, 0) = std::nan(""); }), QString("nodes"));
  }

  void LoadsThatDoNotFitAreRefused() {
    const TetMesh mesh = block_mesh({3, 3, 3}, {0.03, 0.03, 0.03});
    const auto model = std::make_shared<CompositeModel>(mesh, std::vector<VesselTree>{}, CompositeOptions{});
    Integrator integrator(model, {});
    Loads loads;
    AttachedLoad far;  // opposite corners share no element
    far.nodes = {0, mesh.vertex_count() - 1, -1, -1};
    far.weights = {0.5, 0.5, 0.0, 0.0};
    far.tangent = Eigen::Matrix3d::Identity();
    loads.attached = {far};
    QVERIFY_THROWS_EXCEPTION(PreconditionError, integrator.step(loads));
    loads.attached[0].nodes = {0, 1000, -1, -1};
    QVERIFY_THROWS_EXCEPTION(InputError, integrator.step(loads));
    loads.attached.clear();
    loads.pressure = std::nan("");
    QVERIFY_THROWS_EXCEPTION(InputError, integrator.step(loads));
    loads.pressure = 1.0;
    loads.pressure_triangles = {100000};
    QVERIFY_THROWS_EXCEPTION(InputError, integrator.step(loads));
    IntegratorOptions options;
    options.fixed_nodes = {1000};
    QVERIFY_THROWS_EXCEPTION(InputError, Integrator(model, options));
    options.fixed_nodes.resize(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(options.fixed_nodes.begin(), options.fixed_nodes.end(), 0);
    QVERIFY_THROWS_EXCEPTION(InputError, Integrator(model, options));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, integrator.set_state(Points::Zero(3, 3)));
  }

  void PrescribedNodesThatAreFreeAreRefused() {
    const TetMesh mesh = block_mesh({6, 2, 2}, {0.06, 0.02, 0.02});
    const auto model = std::make_shared<CompositeModel>(mesh, std::vector<VesselTree>{}, CompositeOptions{});
    IntegratorOptions options;
    options.fixed_nodes = nodes_at(mesh, 0, 0.0);
    Integrator first(model, options);
    const std::vector<int>& led = options.fixed_nodes;
    // A free node cannot be prescribed, and what is refused changes nothing.
    Loads wrong;
    wrong.prescribed.push_back({led[0], mesh.vertex(led[0]) + Eigen::Vector3d(0.001, 0.0, 0.0)});
    wrong.prescribed.push_back({20, mesh.vertex(20)});
    const Points before = first.positions();
    QVERIFY_THROWS_EXCEPTION(InputError, first.step(wrong));
    QVERIFY((first.positions().array() == before.array()).all());
    wrong.prescribed = {{-1, Eigen::Vector3d::Zero()}};
    QVERIFY_THROWS_EXCEPTION(InputError, first.step(wrong));
  }
};

QTEST_APPLESS_MAIN(RefusalTest)
#include "refusal_test.moc"
