// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_contact_forces.h"

#include <QTest>
#include <chrono>
#include <fstream>
#include <memory>
#include <random>

#include "data_folder.h"
#include "glisson/core/error.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/registration/force_follower.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

/// A phantom held at the back and pulled at one place: its forces' equilibrium under the linear law.
struct Pulled {
  PatientModel model = phantom::model(10, 8, 6);
  std::vector<int> fixed;
  Points truth;
  LabelledCloud cloud;

  explicit Pulled(const Eigen::Vector3d& pull = {0.0, 0.004, 0.012}, double radius = 0.018) {
    model.landmarks = {};
    for (int i = 0; i < model.mesh.vertex_count(); ++i)
      if (model.mesh.vertices(i, 1) > 0.055) fixed.push_back(i);
    fem::ElasticBody body(model.mesh, fixed);
    body.set_material({fem::BodyLaw::linear, 0.45});
    Points force = Points::Zero(body.node_count(), 3);
    const Eigen::Vector3d at = phantom::shape(0.2, -0.3, 1.0);
    for (const int node : model.surface.node_of_vertex)
      if ((model.mesh.vertex(node) - at).norm() < radius) force.row(node) = pull.transpose();
    body.factorise(body.rest(), {});
    Points moved = body.solve(force);
    moved *= 0.03 / moved.rowwise().norm().maxCoeff();
    truth = body.rest() + moved;
    see(truth);
  }
  /// Points of the dome.
  void see(const Points& nodes) {
    TriangleMesh now = model.surface.mesh;
    for (int v = 0; v < now.vertex_count(); ++v)
      now.vertices.row(v) = nodes.row(model.surface.node_of_vertex[static_cast<std::size_t>(v)]);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<Eigen::Vector3d> points;
    const Points normals = triangle_normals(model.surface.mesh);
    std::uniform_int_distribution<int> which(0, now.triangle_count() - 1);
    while (points.size() < 300) {
      const int t = which(random);
      if (normals(t, 2) < 0.4) continue;
      double a = uniform(random), b = uniform(random);
      if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
      points.emplace_back((1.0 - a - b) * now.vertex(now.triangles(t, 0)) +
                          a * now.vertex(now.triangles(t, 1)) + b * now.vertex(now.triangles(t, 2)));
    }
    cloud.points.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
      cloud.points.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  }
  ContactForceOptions options() const {
    ContactForceOptions options;
    options.fixed_nodes = fixed;
    options.materials = {{fem::BodyLaw::linear, 0.45}, {fem::BodyLaw::neo_hookean, 0.47}};
    return options;
  }
  ContactForceFit fit(const ContactForceOptions& options, const CameraFromCt& start = {}) const {
    return *fit_contact_forces(model, cloud, start, options, RunContext());
  }
  double error(const ContactForceFit& fit) const {
    return (fit.nodes_in_camera - truth).rowwise().norm().mean();
  }
  /// Isotropic. @param every so many-th point, m.
  void shake(double deviation, int every = 1) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal(0.0, deviation);
    for (int i = 0; i < cloud.size(); i += every)
      for (int c = 0; c < 3; ++c) cloud.points(i, c) += normal(random);
  }
  double motion() const { return (model.mesh.vertices - truth).rowwise().norm().mean(); }
};

}  // namespace

class ContactForcesTest : public QObject {
  Q_OBJECT
 private slots:
  void OnlyAnotherLawInTheSamePlaceIsAmbiguous();
  void FindsHowSmallThePlaceIs() {
    // Fewer nodes than the widest patches hold: those alone leave 0.11 mm.
    const Pulled pulled({0.0, 0.004, 0.012}, 0.009);
    const double error = pulled.error(pulled.fit(pulled.options()));
    QVERIFY2(error < 0.002 * pulled.motion(),
             qPrintable(QString("%1 of %2 mm").arg(1e3 * error).arg(1e3 * pulled.motion())));
  }

  /// The first stage explains the cloud, the second tells nothing and goes back to the prior's mean.
  void TornIsWhatItIsInTheShapeThatIsKept() {
    Pulled pulled;
    auto prior = std::make_shared<OperationPrior>();
    Points longer = Points::Zero(pulled.model.mesh.vertex_count(), 3);
    const Points& rest = pulled.model.mesh.vertices;
    for (Eigen::Index i = 0; i < rest.rows(); ++i) longer(i, 1) = 1.6 * std::min(0.0, rest(i, 1) - 0.055);
    prior->modes = Eigen::Map<const fem::NodalColumns>(longer.data(), longer.size(), 1);
    pulled.see(rest + longer);
    pulled.shake(0.3e-3);
    ContactForceOptions options = pulled.options();
    options.prior = prior;
    options.amplitudes = Eigen::VectorXd::Ones(1);
    options.materials = {{fem::BodyLaw::neo_hookean, 0.45}};
    options.poisson_ratios = {};
    options.sigmas = {0.5e-3, 500.0};
    options.max_step = 1.0;
    const ContactForceFit fit = pulled.fit(options);
    QVERIFY2(std::abs(fit.amplitudes[0] - 1.0) < 0.1, qPrintable(QString::number(fit.amplitudes[0])));
    QVERIFY2(fit.torn < 0.02, qPrintable(QString::number(fit.torn)));
  }

  void FindsTheShapeTheLawAndThePlace() {
    const Pulled pulled;
    const ContactForceFit fit = pulled.fit(pulled.options());
    QVERIFY2(pulled.error(fit) < 0.12 * pulled.motion(),
             qPrintable(QString("%1 of %2 mm").arg(1e3 * pulled.error(fit)).arg(1e3 * pulled.motion())));
    QVERIFY(fit.laws[static_cast<std::size_t>(fit.chosen)].material.law == fem::BodyLaw::linear);
    QVERIFY(!fit.forces.empty() && static_cast<int>(fit.forces.size()) < fit.patches);
    const Eigen::Vector3d at = phantom::shape(0.2, -0.3, 1.0);
    QVERIFY((pulled.model.mesh.vertex(fit.forces.front().node) - at).norm() < 0.02);
    for (const int node : pulled.fixed)
      QVERIFY((fit.nodes_in_camera.row(node) - pulled.model.mesh.vertices.row(node)).norm() < 1e-12);
  }

  void OneThreadAndTwoGiveTheSameBits() {
    const Pulled pulled;
    ContactForceOptions options = pulled.options();
    const ContactForceFit two = pulled.fit(options);
    options.threads = 1;
    const ContactForceFit one = pulled.fit(options);
    QVERIFY((one.nodes_in_camera.array() == two.nodes_in_camera.array()).all());
    QVERIFY((one.expected_error.array() == two.expected_error.array()).all());
    for (std::size_t k = 0; k < one.laws.size(); ++k)
      QVERIFY(one.laws[k].log_evidence == two.laws[k].log_evidence);
  }

  void AnotherFrameIsNoMatter() {
    Pulled pulled;
    const ContactForceFit plain = pulled.fit(pulled.options());
    const CameraFromCt pose = phantom::view(0.7);
    pulled.cloud.points = pose.apply(pulled.cloud.points);
    const ContactForceFit posed = pulled.fit(pulled.options(), pose);
    QVERIFY((posed.nodes_in_camera - pose.apply(plain.nodes_in_camera)).rowwise().norm().maxCoeff() < 1e-5);
    // And both turned together, model and cloud.
    PatientModel turned = pulled.model;
    turned.mesh.vertices = pose.apply(turned.mesh.vertices);
    turned.surface = boundary_surface(turned.mesh);
    const auto fit = fit_contact_forces(turned, pulled.cloud, {}, pulled.options(), RunContext());
    QVERIFY((fit->nodes_in_camera - pose.apply(plain.nodes_in_camera)).rowwise().norm().mean() < 2e-4);
    QVERIFY(fit->chosen == plain.chosen);
  }

  void NumberingOfNodesIsNoMatter() {
    const Pulled pulled;
    const ContactForceFit plain = pulled.fit(pulled.options());
    Pulled other = pulled;
    const int n = pulled.model.mesh.vertex_count();
    other.model.mesh.vertices = pulled.model.mesh.vertices.colwise().reverse();
    other.model.mesh.tetrahedra = (n - 1 - pulled.model.mesh.tetrahedra.array()).matrix();
    other.model.surface = boundary_surface(other.model.mesh);
    for (int& node : other.fixed) node = n - 1 - node;
    const ContactForceFit fit = other.fit(other.options());
    const Points back = fit.nodes_in_camera.colwise().reverse();
    QVERIFY((back - plain.nodes_in_camera).rowwise().norm().mean() < 2e-4);
  }

  void NothingFixedThePoseIsFoundToo() {
    Pulled pulled;
    CameraFromCt off;
    off.rotation = Eigen::AngleAxisd(0.06, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    off.translation = Eigen::Vector3d(0.003, -0.004, 0.002);
    ContactForceOptions options = pulled.options();
    options.fixed_nodes.clear();
    const ContactForceFit fit = pulled.fit(options, off);
    const double before = (off.apply(pulled.model.mesh.vertices) - pulled.truth).rowwise().norm().mean();
    QVERIFY2(pulled.error(fit) < 0.5 * before,
             qPrintable(QString("%1 of %2 mm").arg(1e3 * pulled.error(fit)).arg(1e3 * before)));
    // Grounds under one law, the other laws with the best of them, then Poisson's ratios.
    QVERIFY(fit.laws.size() ==
            options.grounds.size() + options.materials.size() - 1 + options.poisson_ratios.size());
  }

  void AShapeThatOperationsMakeIsFoundTogetherWithTheForces() {
    Pulled pulled;
    const Points& rest = pulled.model.mesh.vertices;
    auto prior = std::make_shared<OperationPrior>();
    prior->modes = Eigen::MatrixXd::Zero(rest.size(), 2);
    for (Eigen::Index i = 0; i < rest.rows(); ++i) {
      prior->modes(3 * i + 2, 0) = 0.6 * rest(i, 0) * rest(i, 0);
      prior->modes(3 * i + 1, 1) = 0.4 * rest(i, 2) * rest(i, 0);
    }
    pulled.truth += prior->shape(rest, Eigen::Vector2d(1.8, -1.5)) - rest;
    pulled.see(pulled.truth);
    ContactForceOptions options = pulled.options();
    options.fixed_nodes.clear();
    options.grounds = {0.3};
    const double without = pulled.error(pulled.fit(options));
    options.prior = prior;
    const ContactForceFit fit = pulled.fit(options);
    QVERIFY(fit.amplitudes.size() == 2);
    QVERIFY2(pulled.error(fit) < without,
             qPrintable(QString("%1, without %2 mm").arg(1e3 * pulled.error(fit)).arg(1e3 * without)));
    options.amplitudes = Eigen::VectorXd::Zero(3);
    QVERIFY_THROWS_EXCEPTION(PreconditionError, pulled.fit(options));
  }

  void ExpectedErrorGrowsAwayFromWhatIsSeen() {
    const Pulled pulled;
    const ContactForceFit fit = pulled.fit(pulled.options());
    QVERIFY(fit.expected_error.allFinite() && fit.expected_error.minCoeff() >= 0.0);
    for (const int node : pulled.fixed) QVERIFY(fit.expected_error[node] == 0.0);
    QVERIFY(fit.expected_error.maxCoeff() > 0.0);
  }

  void CancelEndsIt() {
    const Pulled pulled;
    const auto flag = std::make_shared<CancelFlag>();
    std::chrono::steady_clock::time_point asked;
    const RunContext context(
        [&](double, std::string_view) {
          if (!flag->requested()) asked = std::chrono::steady_clock::now();
          flag->request();
        },
        flag, 1);
    QVERIFY(!fit_contact_forces(pulled.model, pulled.cloud, {}, pulled.options(), context));
    QVERIFY(std::chrono::steady_clock::now() - asked < std::chrono::seconds(2));
  }

  void RefusesUnusableInput() {
    const Pulled pulled;
    const auto refused = [&](const auto& change) {
      ContactForceOptions options = pulled.options();
      change(options);
      QVERIFY_THROWS_EXCEPTION(InputError, pulled.fit(options));
    };
    refused([](auto& o) { o.materials.clear(); });
    refused([](auto& o) { o.materials.front().poisson_ratio = 0.5; });
    refused([](auto& o) { o.poisson_ratios = {0.6}; });
    refused([](auto& o) { o.sigmas.clear(); });
    refused([](auto& o) { o.sigmas.front() = 0.0; });
    refused([](auto& o) { o.grounds.clear(); });
    refused([](auto& o) { o.grounds.front() = -1.0; });
    refused([](auto& o) { o.patch_spacing = 0.0; });
    refused([](auto& o) { o.patch_radius = 0.0; });
    refused([](auto& o) { o.patch_reach = 0.0; });
    refused([](auto& o) { o.iterations = 0; });
    refused([](auto& o) { o.outlier_distance = 0.0; });
    refused([](auto& o) { o.max_step = 0.0; });
    refused([](auto& o) { o.most_points = 9; });
    refused([](auto& o) { o.threads = 3; });
    refused([](auto& o) { o.fixed_nodes = {-1}; });
    Pulled few;
    few.cloud.points.conservativeResize(9, 3);
    QVERIFY_THROWS_EXCEPTION(InputError, few.fit(few.options()));
    few.cloud.points = Points::Constant(20, 3, std::nan(""));
    QVERIFY_THROWS_EXCEPTION(InputError, few.fit(few.options()));
  }

  void ASeriesOfCloudsIsFollowed() {
    Pulled pulled;
    const Points full = pulled.truth - pulled.model.mesh.vertices;
    ForceFollower follower(pulled.model, {}, pulled.options());
    for (const double share : {0.3, 0.6, 1.0, 0.5}) {
      pulled.truth = pulled.model.mesh.vertices + share * full;
      pulled.see(pulled.truth);
      const auto fit = follower.follow(pulled.cloud, RunContext());
      const double error = pulled.error(*fit), motion = share * full.rowwise().norm().mean();
      QVERIFY2(error < 0.15 * motion, qPrintable(QString("%1 of %2 mm").arg(1e3 * error).arg(1e3 * motion)));
      // The first motion is too small to tell the laws apart.
      if (share > 0.5)
        QVERIFY(fit->laws[static_cast<std::size_t>(fit->chosen)].material.law == fem::BodyLaw::linear);
      // A cloud that is none changes nothing for the next one.
      LabelledCloud few = pulled.cloud;
      few.points.conservativeResize(9, 3);
      QVERIFY_THROWS_EXCEPTION(InputError, follower.follow(few, RunContext()));
    }
  }

  void TheLawIsChosenByTheCloudThatTellsMost() {
    Pulled pulled;
    ForceFollower follower(pulled.model, {}, pulled.options());
    pulled.shake(4e-3);
    follower.follow(pulled.cloud, RunContext());
    pulled.see(pulled.truth);
    const auto clean = follower.follow(pulled.cloud, RunContext());
    QVERIFY(clean->laws[static_cast<std::size_t>(clean->chosen)].material.law == fem::BodyLaw::linear);
    QVERIFY2(pulled.error(*clean) < 0.05 * pulled.motion(),
             qPrintable(QString("%1 of %2 mm").arg(1e3 * pulled.error(*clean)).arg(1e3 * pulled.motion())));
    // A noisy one after it changes nothing for the next; nor is the law sought again by what tells no more.
    pulled.shake(4e-3);
    QVERIFY(follower.follow(pulled.cloud, RunContext())->laws.size() == 1);
    pulled.see(pulled.truth);
    const auto last = follower.follow(pulled.cloud, RunContext());
    QVERIFY(last->laws.size() == 1);
    QVERIFY(last->laws.front().material == clean->laws[static_cast<std::size_t>(clean->chosen)].material);
    QVERIFY(pulled.error(*last) < 0.05 * pulled.motion());
  }

  void AWrongCloudIsToldAndForgotten() {
    Pulled pulled;
    const ContactForceOptions options = pulled.options();
    ForceFollower follower(pulled.model, {}, options);
    follower.follow(pulled.cloud, RunContext());
    const Eigen::RowVector3d middle = pulled.cloud.points.colwise().mean();
    const LabelledCloud right = pulled.cloud;
    const auto told = [&](const LabelledCloud& cloud) {
      try {
        follower.follow(cloud, RunContext());
      } catch (const NumericalError&) {
        return true;
      }
      return false;
    };
    LabelledCloud wrong = right;  // mirrored
    wrong.points.col(0) = 2.0 * middle.x() - wrong.points.col(0).array();
    QVERIFY(told(wrong));
    wrong.points = right.points.rowwise() + Eigen::RowVector3d(0.025, 0.0, 0.0);  // slid
    QVERIFY(told(wrong));
    const auto next = follower.follow(right, RunContext());
    QVERIFY2(pulled.error(*next) < 0.05 * pulled.motion(),
             qPrintable(QString::number(1e3 * pulled.error(*next))));
  }

  void WhatACloudTellsOfItsNoiseIsBelieved() {
    Pulled pulled;
    pulled.shake(6e-3, 2);
    const ContactForceFit untold = pulled.fit(pulled.options());
    for (int i = 0; i < pulled.cloud.size(); ++i) pulled.cloud.sigma.push_back(i % 2 == 0 ? 6e-3 : 0.2e-3);
    const ContactForceFit told = pulled.fit(pulled.options());
    QVERIFY2(pulled.error(told) < 0.5 * pulled.error(untold),
             qPrintable(
                 QString("%1, untold %2 mm").arg(1e3 * pulled.error(told)).arg(1e3 * pulled.error(untold))));
    // What is told is the least that is taken, and nothing is known better than that allows.
    Pulled clean;
    const double known = clean.fit(clean.options()).expected_error.mean();
    clean.cloud.sigma.assign(static_cast<std::size_t>(clean.cloud.size()), 4e-3);
    const ContactForceFit doubted = clean.fit(clean.options());
    QVERIFY(doubted.laws[static_cast<std::size_t>(doubted.chosen)].sigma >= 4e-3);
    QVERIFY(doubted.expected_error.mean() > 2.0 * known);
  }

  void FollowingIsCancelled() {
    const Pulled pulled;
    ForceFollower follower(pulled.model, {}, pulled.options());
    QVERIFY(follower.follow(pulled.cloud, RunContext()));
    const auto cancel = std::make_shared<CancelFlag>();
    cancel->request();
    QVERIFY(!follower.follow(pulled.cloud, RunContext({}, cancel, 1)));
    QVERIFY(follower.follow(pulled.cloud, RunContext()));
  }

  void ForeignSequence() {
    const std::filesystem::path folder = test::data_folder() / "elastic_sequence";
    if (!std::filesystem::exists(folder)) QSKIP("elastic_sequence is not here (set GLISSON_DATA)");
    PatientModel model;
    model.mesh = read_tet_mesh(folder / "rest.vtk", LengthUnit::millimetre);
    model.surface = boundary_surface(model.mesh);
    ContactForceOptions options;
    std::ifstream fixed(folder / "fixed_vertices.txt");
    for (int node = 0; fixed >> node;) options.fixed_nodes.push_back(node);
    const LabelledCloud cloud = read_cloud(folder / "cloud_00.ply");
    std::ifstream file(folder / "truth_00.xyz");
    Points truth(model.mesh.vertex_count(), 3);
    for (double& value : truth.reshaped<Eigen::RowMajor>()) file >> value, value *= 1e-3;
    const auto fit = fit_contact_forces(model, cloud, {}, options, RunContext());
    const double error = 1e3 * (fit->nodes_in_camera - truth).rowwise().norm().mean();
    QVERIFY2(error < 0.02, qPrintable(QString("%1 mm").arg(error)));  // 0.04 where the last stage ends
    QVERIFY(fit->termination == Termination::converged);
    QVERIFY(fit->laws[static_cast<std::size_t>(fit->chosen)].material.law == fem::BodyLaw::linear);
  }
};

void ContactForcesTest::OnlyAnotherLawInTheSamePlaceIsAmbiguous() {
  const fem::BodyMaterial soft{fem::BodyLaw::neo_hookean, 0.45};
  ContactForceFit fit;
  fit.chosen = 0;
  LawFit one;
  one.material = soft;
  one.ground = 0.2;
  one.log_evidence = 100.0;
  LawFit other = one;
  other.log_evidence = 98.0;
  other.away = 8e-3;
  const auto is_ambiguous = [&](const LawFit& rival) {
    fit.laws = {one, rival};
    return is_law_ambiguous(fit);
  };
  QVERIFY(!is_ambiguous(other));  // another place's end
  LawFit supports = other;
  supports.ground = 0.9;
  QVERIFY(!is_ambiguous(supports));
  LawFit law = other;
  law.material.poisson_ratio = 0.41;
  QVERIFY(is_ambiguous(law));
  LawFit elsewhere = law;
  elsewhere.place = 2;
  QVERIFY(!is_ambiguous(elsewhere));
  LawFit near = law;
  near.away = 4e-3;
  QVERIFY(!is_ambiguous(near));
  LawFit improbable = law;
  improbable.log_evidence = 94.0;
  QVERIFY(!is_ambiguous(improbable));
  LawFit linear = law;  // has odds of 1 to 20 beforehand
  linear.material.law = fem::BodyLaw::linear;
  linear.log_evidence = 97.0;
  QVERIFY(!is_ambiguous(linear));
}

QTEST_APPLESS_MAIN(ContactForcesTest)
#include "contact_forces_test.moc"
