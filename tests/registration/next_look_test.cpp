// SPDX-License-Identifier: GPL-3.0-or-later
// What one more look would tell of a lesion, before anybody has looked.
#include "glisson/registration/next_look.h"

#include <Eigen/Dense>
#include <QTest>
#include <limits>
#include <set>

#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

constexpr double kNoise = 1e-3;
constexpr Label kLesion = structure::kFirstLesion;

/// A lesion of a few tetrahedra near this place.
PatientModel with_lesion(PatientModel model, const Eigen::Vector3d& at) {
  int nearest = 0;
  double least = 1.0;
  for (int t = 0; t < model.mesh.tetrahedron_count(); ++t) {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 4; ++k) middle += 0.25 * model.mesh.vertices.row(model.mesh.tetrahedra(t, k));
    const double away = (middle - at.transpose()).norm();
    if (away < least) least = away, nearest = t;
  }
  model.mesh.labels[static_cast<std::size_t>(nearest)] = kLesion;
  return model;
}

/// The phantom where the camera sees it, undeformed.
struct Scene {
  PatientModel model;
  LabelledCloud cloud;
  Registration registration;

  explicit Scene(const Eigen::Vector3d& lesion, double share = 0.15)
      : model(with_lesion(phantom::model(9, 8, 4), lesion)) {
    registration.camera_from_ct = phantom::view();
    registration.nodes_in_camera = registration.camera_from_ct.apply(model.mesh.vertices);
    phantom::PatchOptions options;
    options.share = share;
    options.noise = kNoise;
    cloud = phantom::patch(model, registration.nodes_in_camera, options);
  }
  ErrorModel error_after(const LabelledCloud& seen) const {
    return ErrorModel(model, nullptr, {}, registration.camera_from_ct, registration.nodes_in_camera,
                      prepare_cloud(seen, {}), kNoise);
  }
  double expected_after(const LabelledCloud& seen) const {
    const Binding binding = bind_points(model.mesh, lesion_centres(model).front().second.transpose());
    return mean_error(error_after(seen).covariances(model.mesh, binding).front());
  }
  LesionLooks looks() const { return looks_of(model, cloud, registration, error_after(cloud)).front(); }
  Eigen::Vector3d normal_of(int node) const {
    const auto& nodes = model.surface.node_of_vertex;
    const auto v = std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin();
    return registration.camera_from_ct.rotation * vertex_normals(model.surface.mesh).row(v).transpose();
  }
};

/// The cloud with what a look at this node shows besides: points on the surface's triangles, as dense.
LabelledCloud with_look(const Scene& scene, int node) {
  LabelledCloud more = scene.cloud;
  phantom::PatchOptions everything;
  everything.share = 1.0;
  everything.noise = kNoise;
  everything.seed = 7;
  // The whole surface: both halves, seen from before and from behind.
  std::vector<Eigen::RowVector3d> points, normals;
  const Eigen::RowVector3d at = scene.registration.nodes_in_camera.row(node);
  for (const double turn : {0.0, std::numbers::pi}) {
    Rigid<CameraFrame, CameraFrame> other;
    other.rotation = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitX()).toRotationMatrix();
    const Eigen::Vector3d middle = scene.registration.nodes_in_camera.colwise().mean().transpose();
    other.translation = middle - other.rotation * middle;
    const LabelledCloud half =
        phantom::patch(scene.model, other.apply(scene.registration.nodes_in_camera), everything);
    const Points back = other.inverse().apply(half.points), facing = half.normals * other.rotation;
    for (int i = 0; i < half.size(); ++i) {
      const bool is_new =
          (scene.cloud.points.rowwise() - back.row(i)).rowwise().norm().minCoeff() > 8e-3 &&
          (points.empty() || std::none_of(points.begin(), points.end(), [&](const Eigen::RowVector3d& p) {
             return (p - back.row(i)).norm() < 2e-3;
           }));
      if (is_new && (back.row(i) - at).norm() < 30e-3 && facing.row(i).dot(scene.normal_of(node)) > 0.5)
        points.emplace_back(back.row(i)), normals.emplace_back(facing.row(i));
    }
  }
  const auto count = static_cast<Eigen::Index>(points.size()), first = more.points.rows();
  more.points.conservativeResize(first + count, 3);
  more.normals.conservativeResize(first + count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    more.points.row(first + i) = points[static_cast<std::size_t>(i)];
    more.normals.row(first + i) = normals[static_cast<std::size_t>(i)];
    more.features.push_back(Feature::surface);
  }
  return more;
}

}  // namespace

class NextLookTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsExpectedIsWhatTheErrorModelSaysAfterTheLook();
  void NoLookIsExpectedToHarm();
  void ALookHelpsMostAtTheLesion();
  void WhatIsSeenAlreadyTellsNothingNew();
  void TheBackIsNotOffered();
  void ALandmarkThatIsSeenAndNotMarkedIsOffered();
  void TheCamerasPlaceDoesNotMatter();
  void PlacesAreNamedAsAnAnatomistWould();
  void SmallGainsAreNotWorthALook();
  void NotesTellWhereAndHowMuch();
};

void NextLookTest::WhatIsExpectedIsWhatTheErrorModelSaysAfterTheLook() {
  // Another way to the same number: the points that would be seen are put into the cloud.
  const Scene scene(Eigen::Vector3d(-0.06, -0.01, 0.01));
  const LesionLooks looks = scene.looks();
  QVERIFY(std::abs(looks.now / scene.expected_after(scene.cloud) - 1.0) < 1e-9);
  Eigen::Index best = 0;
  looks.seen.minCoeff(&best);
  std::vector<int> tried{static_cast<int>(best)};
  for (int v = 5; v < scene.model.surface.mesh.vertex_count(); v += 7) {
    const int node = scene.model.surface.node_of_vertex[static_cast<std::size_t>(v)];
    if (looks.seen[node] < 0.97 * looks.now) tried.push_back(node);
  }
  QVERIFY(tried.size() > 3);
  int compared = 0;
  for (const int node : tried) {
    const LabelledCloud after = with_look(scene, node);
    if (after.size() < scene.cloud.size() + 30) continue;  // the sides are seen from neither end
    ++compared;
    const double said = looks.now - looks.seen[node], found = looks.now - scene.expected_after(after);
    // The places are 10 mm apart, the points lie anywhere.
    QVERIFY2(std::abs(said - found) < 0.3 * std::max(said, found) + 0.02 * looks.now,
             qPrintable(QStringLiteral("%1: %2 said, %3 found of %4 mm")
                            .arg(node)
                            .arg(1e3 * said)
                            .arg(1e3 * found)
                            .arg(1e3 * looks.now)));
  }
  QVERIFY(compared > 5);
}

void NextLookTest::NoLookIsExpectedToHarm() {
  const LesionLooks looks = Scene(Eigen::Vector3d(0.05, 0.0, 0.01)).looks();
  QVERIFY(looks.seen.maxCoeff() <= looks.now * (1.0 + 1e-9));
  QVERIFY(looks.seen.minCoeff() > 0.0);
  QVERIFY(looks.margin <= looks.now && looks.notch <= looks.now);
}

void NextLookTest::ALookHelpsMostAtTheLesion() {
  // Forces anywhere: what lies near is moved by the same ones.
  for (const double x : {-0.07, 0.07}) {
    const Scene scene(Eigen::Vector3d(x, 0.0, 0.01));
    const auto best = best_look(scene.looks());
    QVERIFY(best && best->kind == NextLook::Kind::surface);
    const double away = scene.model.mesh.vertices(best->node, 0) - x;
    QVERIFY2(std::abs(away) < 0.05, qPrintable(QString::number(away)));
    QVERIFY(best->after < best->now);
  }
}

void NextLookTest::WhatIsSeenAlreadyTellsNothingNew() {
  const Scene scene(Eigen::Vector3d(0.0, 0.0, 0.01), 0.5);
  const LesionLooks looks = scene.looks();
  int inside = 0;
  for (const int node : scene.model.surface.node_of_vertex) {
    const Eigen::RowVector3d at = scene.registration.nodes_in_camera.row(node);
    // Seen to all sides, farther than a look reaches.
    bool around = true;
    for (const int other : scene.model.surface.node_of_vertex) {
      const Eigen::RowVector3d there = scene.registration.nodes_in_camera.row(other);
      if ((there - at).norm() < 45e-3 && scene.normal_of(other).dot(scene.normal_of(node)) > 0.2)
        around = around && (scene.cloud.points.rowwise() - there).rowwise().norm().minCoeff() < 7e-3;
    }
    if (!around) continue;
    ++inside;
    QVERIFY(std::abs(looks.seen[node] - looks.now) < 1e-12);
  }
  QVERIFY(inside > 0);
}

void NextLookTest::TheBackIsNotOffered() {
  const Scene scene(Eigen::Vector3d(0.0, 0.05, 0.01));
  const LesionLooks looks = scene.looks();
  const Points& cava = scene.model.landmarks.vena_cava;
  int held = 0;
  for (const int node : scene.model.surface.node_of_vertex) {
    const double away = (cava.rowwise() - scene.model.mesh.vertices.row(node)).rowwise().norm().minCoeff();
    if (away > 14e-3) continue;  // its place is at most 10 mm farther
    ++held;
    QVERIFY(looks.seen[node] == looks.now);
  }
  QVERIFY(held > 1);
  QVERIFY(looks.seen.minCoeff() < looks.now);
  const auto best = best_look(looks);
  if (best && best->node >= 0)
    QVERIFY((cava.rowwise() - scene.model.mesh.vertices.row(best->node)).rowwise().norm().minCoeff() > 15e-3);
}

void NextLookTest::ALandmarkThatIsSeenAndNotMarkedIsOffered() {
  Scene scene(Eigen::Vector3d(0.02, -0.03, 0.005), 0.3);
  const LesionLooks marked = scene.looks();
  QVERIFY(std::abs(marked.notch - marked.now) < 1e-12);
  scene.cloud.features.assign(scene.cloud.features.size(), Feature::surface);
  const LesionLooks unmarked = scene.looks();
  QVERIFY(unmarked.notch < unmarked.now && unmarked.margin < unmarked.now);
  // Nothing can be marked where nothing is seen.
  scene.cloud.points.rowwise() += Eigen::RowVector3d(0.0, 0.0, 1.0);
  const LesionLooks unseen = looks_of(scene.model, scene.cloud, scene.registration,
                                      scene.error_after(Scene(Eigen::Vector3d::Zero()).cloud))
                                 .front();
  QVERIFY(unseen.notch == unseen.now && unseen.margin == unseen.now);
}

void NextLookTest::TheCamerasPlaceDoesNotMatter() {
  const Scene scene(Eigen::Vector3d(-0.06, -0.01, 0.01));
  Rigid<CameraFrame, CameraFrame> turned;
  turned.rotation = Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  turned.translation = Eigen::Vector3d(0.02, -0.01, 0.05);
  Scene other = scene;
  other.registration.camera_from_ct = turned * scene.registration.camera_from_ct;
  other.registration.nodes_in_camera = turned.apply(scene.registration.nodes_in_camera);
  other.cloud.points = turned.apply(scene.cloud.points);
  other.cloud.normals = scene.cloud.normals * turned.rotation.transpose();
  const LesionLooks one = scene.looks(), two = other.looks();
  QVERIFY((one.seen - two.seen).cwiseAbs().maxCoeff() < 1e-4 * one.now);
}

void NextLookTest::PlacesAreNamedAsAnAnatomistWould() {
  PatientModel model = phantom::model(9, 8, 4);  // LPS: +x left, -y front, +z head
  const auto place_nearest = [&](const Eigen::Vector3d& p) {
    int best = -1;
    double least = 1.0;
    for (const int node : model.surface.node_of_vertex) {
      const double away = (model.mesh.vertices.row(node) - p.transpose()).norm();
      if (away < least) least = away, best = node;
    }
    return place_on_liver(model, best);
  };
  QCOMPARE(place_nearest({0.06, 0.0, 0.1}), std::string("left_dome"));
  QCOMPARE(place_nearest({-0.06, 0.0, 0.1}), std::string("right_dome"));
  QCOMPARE(place_nearest({0.06, 0.0, -0.1}), std::string("left_underside"));
  QCOMPARE(place_nearest({-0.5, 0.0, 0.0}), std::string("right_side"));
  model.landmarks.umbilical_notch.resize(0, 3);
  QCOMPARE(place_nearest({0.06, 0.0, 0.1}), std::string("liver_dome"));
  const std::vector<std::string> places = places_on_liver();
  const std::set<std::string> all(places.begin(), places.end());
  QCOMPARE(all.size(), places.size());
  for (const int node : model.surface.node_of_vertex) QVERIFY(all.count(place_on_liver(model, node)) == 1);
}

void NextLookTest::SmallGainsAreNotWorthALook() {
  LesionLooks looks{kLesion, 6e-3, Eigen::VectorXd::Constant(4, 6e-3), 6e-3, 6e-3};
  QVERIFY(!best_look(looks));
  looks.seen[2] = 5.3e-3;
  QVERIFY(!best_look(looks));
  looks.seen[2] = 4.9e-3;
  QCOMPARE(best_look(looks)->node, 2);
  looks.notch = 3e-3;
  QVERIFY(best_look(looks)->kind == NextLook::Kind::notch);
  looks.now = 0.9e-3, looks.seen.setConstant(0.5e-3), looks.margin = looks.notch = 0.9e-3;
  QVERIFY(!best_look(looks));  // under half a millimetre nobody can tell
  looks.now = std::numeric_limits<double>::quiet_NaN();
  QVERIFY(!best_look(looks));  // nor is anything told of what is not known
}

void NextLookTest::NotesTellWhereAndHowMuch() {
  const Scene scene(Eigen::Vector3d(-0.06, -0.01, 0.01));
  Registration registration = scene.registration;
  registration.looks = {scene.looks()};
  const std::vector<std::string> notes = look_notes(scene.model, registration);
  QCOMPARE(notes.size(), std::size_t{1});
  QVERIFY2(notes.front().starts_with("look.surface lesion_1 right_"), notes.front().c_str());
  registration.looks.clear();
  QVERIFY(look_notes(scene.model, registration).empty());
}

QTEST_GUILESS_MAIN(NextLookTest)
#include "next_look_test.moc"
