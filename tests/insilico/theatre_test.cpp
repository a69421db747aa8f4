// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/theatre.h"

#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "glisson/insilico/film.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "theatre_patient.h"

using namespace glisson;
using namespace glisson::insilico;

namespace {

TheatreOptions small_options() {
  TheatreOptions options;
  options.width = 320;
  options.height = 180;
  options.frames = 121;
  options.truth_vertices = 700;
  return options;
}

double grey(const Picture& picture, const Eigen::Vector2d& pixel) {
  const auto x = static_cast<std::size_t>(std::lround(pixel.x())),
             y = static_cast<std::size_t>(std::lround(pixel.y()));
  const std::size_t i = 3 * (y * static_cast<std::size_t>(picture.width) + x);
  return ((*picture.bytes)[i] + (*picture.bytes)[i + 1] + (*picture.bytes)[i + 2]) / 3.0;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<Eigen::Index>(a.size());
  const Eigen::ArrayXd x = Eigen::Map<const Eigen::ArrayXd>(a.data(), n),
                       y = Eigen::Map<const Eigen::ArrayXd>(b.data(), n);
  const Eigen::ArrayXd u = x - x.mean(), v = y - y.mean();
  return (u * v).sum() / std::sqrt(u.square().sum() * v.square().sum());
}

/// Places where the two rays through matching pixels come closest.
Eigen::Vector3d triangulate(const StereoRig& rig, const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
  const auto left_from_right = rig.right_from_left.inverse();
  const Eigen::Vector3d a = rig.left.ray(left), b = left_from_right.rotation * rig.right.ray(right),
                        o = left_from_right.translation;
  Eigen::Matrix<double, 3, 2> system;
  system << a, -b;
  const Eigen::Vector2d t = system.colPivHouseholderQr().solve(o);
  return 0.5 * (t[0] * a + o + t[1] * b);
}

}  // namespace

class TheatreTest : public QObject {
  Q_OBJECT
  std::unique_ptr<Theatre> theatre_;

 private slots:
  void initTestCase() {
    theatre_ = std::move(Theatre::build(test::small_patient(), small_options(), RunContext()).value());
  }

  void TheFirstFrameHasMovedEnoughAndElastically() {
    // Measured here, not taken from the theatre's own figures.
    const Points rest = theatre_->mesh().vertices;
    const Points now = theatre_->camera_from_ct().inverse().apply(theatre_->truth(0).nodes_in_camera);
    const double total = 1e3 * (now - rest).rowwise().norm().mean();
    const auto rigid = fit_rigid<CtFrame, CtFrame>(rest, now);
    const double elastic = 1e3 * (now - rigid.apply(rest)).rowwise().norm().mean();
    QVERIFY2(total >= 20.0 && total < 40.0, qPrintable(QString::number(total)));
    QVERIFY2(elastic >= 8.0 && elastic < 14.0, qPrintable(QString::number(elastic)));
    QVERIFY(std::abs(theatre_->figures().mean_displacement_mm - total) < 1e-6);
    QVERIFY(std::abs(theatre_->figures().elastic_motion_mm - elastic) < 1e-6);
  }

  void NoElementTurnsInsideOutInAnyFrame() {
    for (int frame = 0; frame < theatre_->frame_count(); frame += 5) {
      TetMesh mesh = theatre_->mesh();
      mesh.vertices = theatre_->truth(frame).nodes_in_camera;
      QVERIFY(tetrahedron_volumes(mesh).minCoeff() > 0.0);
    }
  }

  void TheScopeTurnsAboutItsTrocar() {
    constexpr int kFrame = 7;
    const Points still = theatre_->truth(kFrame).nodes_in_camera, first = theatre_->truth(0).nodes_in_camera;
    const Picture standing = theatre_->render(kFrame).left;
    theatre_->move_scope({.pivot_deg = 8.0, .roll_deg = 12.0, .period_s = 2.0, .trocar_mm = 140.0});
    const Points turned = theatre_->truth(kFrame).nodes_in_camera;
    QVERIFY((theatre_->truth(0).nodes_in_camera.array() == first.array()).all());
    // The patient moves rigidly before the camera, and the trocar stays where it is behind it.
    const auto motion = fit_rigid<CameraFrame, CameraFrame>(still, turned);
    QVERIFY((motion.apply(still) - turned).rowwise().norm().maxCoeff() < 1e-9);
    QVERIFY((turned - still).rowwise().norm().mean() > 5e-3);
    const Eigen::Vector3d trocar(0.0, 0.0, -0.14);
    QVERIFY((motion.rotation * trocar + motion.translation - trocar).norm() < 1e-9);
    // What is drawn is what is true.
    const std::vector<float> depth = theatre_->depth(kFrame);
    const TriangleMesh surface = theatre_->surface(kFrame);
    const Camera& camera = theatre_->rig().left;
    const std::vector<bool> seen = theatre_->seen(surface.vertices, kFrame);
    int compared = 0, agreeing = 0;
    for (int v = 0; v < surface.vertex_count(); v += 7) {
      if (!seen[static_cast<std::size_t>(v)]) continue;
      const Eigen::Vector2d pixel = camera.project(surface.vertex(v)).array().round();
      if (!camera.sees(pixel)) continue;
      const auto at = static_cast<std::size_t>(pixel.y() * camera.width + pixel.x());
      ++compared;
      agreeing += std::abs(static_cast<double>(depth[at]) - surface.vertex(v).z()) < 3e-3;
    }
    QVERIFY(compared > 50 && agreeing > 0.9 * compared);
    theatre_->move_scope({.slide_mm = 25.0, .period_s = 2.0});
    const auto away = fit_rigid<CameraFrame, CameraFrame>(still, theatre_->truth(kFrame).nodes_in_camera);
    QVERIFY(away.translation.z() > 1e-3 && away.translation.head<2>().norm() < 1e-9);
    QVERIFY_THROWS_EXCEPTION(InputError, theatre_->move_scope({.pivot_deg = 99.0}));
    QVERIFY(*theatre_->render(kFrame).left.bytes != *standing.bytes);
    // A scope that stands again sees what it saw, organ and wall.
    theatre_->move_scope({});
    QVERIFY(*theatre_->render(kFrame).left.bytes == *standing.bytes);
  }

  void BreathingAndHeartbeatMoveTheLiverSmoothly() {
    const Points start = theatre_->truth(0).nodes_in_camera;
    double farthest = 0.0, largest_step = 0.0;
    Points before = start;
    for (int frame = 1; frame < theatre_->frame_count(); ++frame) {
      const Points now = theatre_->truth(frame).nodes_in_camera;
      farthest = std::max(farthest, (now - start).rowwise().norm().mean());
      largest_step = std::max(largest_step, (now - before).rowwise().norm().mean());
      before = now;
    }
    QVERIFY2(farthest > 5e-3 && farthest < 8e-3, qPrintable(QString::number(farthest)));
    QVERIFY2(largest_step < 1e-3, qPrintable(QString::number(largest_step)));
    // one breath later the breath is where it was; only the heart is not
    QVERIFY((theatre_->truth(120).nodes_in_camera - start).rowwise().norm().maxCoeff() < 1.01e-3);
  }

  void TheTruthCarriesItsOwnNodes() {
    const Points carried = theatre_->carry(theatre_->mesh().vertices, 17);
    QVERIFY((carried - theatre_->truth(17).nodes_in_camera).rowwise().norm().maxCoeff() < 1e-9);
  }

  void TheDepthMapLiesOnTheCarriedSurface() {
    const std::vector<float> depth = theatre_->depth(9);
    const TriangleMesh surface = theatre_->surface(9);
    std::vector<Eigen::RowVector3d> points;
    for (int y = 10; y < 180; y += 20)
      for (int x = 10; x < 320; x += 20) {
        const float z = depth[static_cast<std::size_t>(y * 320 + x)];
        if (z > 0.0F)
          points.push_back((static_cast<double>(z) * theatre_->rig().left.ray({x, y})).transpose());
      }
    QVERIFY(points.size() > 20);
    Points all(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) all.row(static_cast<Eigen::Index>(i)) = points[i];
    QVERIFY(distances_to_surface(all, surface).size() == points.size());
    for (const double d : distances_to_surface(all, surface)) QVERIFY(d < 1e-6);
  }

  void TheCameraIsAtTheWantedDistanceAndSeesMarginAndBackground() {
    const std::vector<float> depth = theatre_->depth(0);
    std::vector<float> hits;
    for (const float z : depth)
      if (z > 0.0F) hits.push_back(z);
    QVERIFY(hits.size() > depth.size() / 5 && hits.size() < depth.size());
    QVERIFY(std::abs(upper_median(hits) - 0.120F) < 0.008F);
    const Points margin = theatre_->carry(theatre_->landmarks().anterior_margin, 0);
    const std::vector<bool> seen = theatre_->seen(margin, 0);
    QVERIFY(std::count(seen.begin(), seen.end(), true) >= 5);
    const double share = theatre_->visible_share(0);
    QVERIFY2(share > 0.05 && share < 0.5, qPrintable(QString::number(share)));
  }

  void BothPicturesShowTheSameMaterial() {
    // Material points of the surface, projected into either picture: the same brightness there, and none at
    // other places (the negative control: shifted by 8 pixels).
    const StereoFrame frame = theatre_->render(3);
    const TriangleMesh surface = theatre_->surface(3);
    const StereoRig& rig = theatre_->rig();
    const std::vector<bool> seen = theatre_->seen(surface.vertices, 3);
    std::vector<double> left, right, elsewhere;
    double worst = 0.0;
    for (int v = 0; v < surface.vertex_count(); v += 3) {
      if (!seen[static_cast<std::size_t>(v)]) continue;
      const Eigen::Vector3d p = surface.vertex(v);
      const Eigen::Vector2d a = rig.left.project(p), b = rig.right.project(rig.right_from_left.rotation * p +
                                                                           rig.right_from_left.translation);
      if (a.x() < 12 || a.y() < 5 || a.x() > 305 || a.y() > 175 || !rig.right.sees(b) || b.x() > 310)
        continue;
      worst = std::max(worst, (triangulate(rig, a, b) - p).norm());
      left.push_back(grey(frame.left, a));
      right.push_back(grey(frame.right, b));
      elsewhere.push_back(grey(frame.right, b + Eigen::Vector2d(8.0, 0.0)));
    }
    QVERIFY(left.size() > 100);
    QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
    const double same = correlation(left, right), other = correlation(left, elsewhere);
    QVERIFY2(same > 0.6 && same > other + 0.1, qPrintable(QString("%1 %2").arg(same).arg(other)));
  }

  void TheTextureSticksToTheMovingMaterial() {
    // A quarter of a breath apart the liver has moved by many pixels; carried along, the same texture is
    // seen.
    const StereoFrame first = theatre_->render(0), later = theatre_->render(45);
    const TriangleMesh before = theatre_->surface(0), after = theatre_->surface(45);
    const Camera& camera = theatre_->rig().left;
    const std::vector<bool> seen = theatre_->seen(before.vertices, 0),
                            still = theatre_->seen(after.vertices, 45);
    std::vector<double> a, b, unmoved;
    double way = 0.0;
    for (int v = 0; v < before.vertex_count(); v += 3) {
      if (!seen[static_cast<std::size_t>(v)] || !still[static_cast<std::size_t>(v)]) continue;
      const Eigen::Vector2d p = camera.project(before.vertex(v)), q = camera.project(after.vertex(v));
      if (p.x() < 3 || p.y() < 3 || p.x() > 316 || p.y() > 176) continue;
      way += (p - q).norm();
      a.push_back(grey(first.left, p));
      b.push_back(grey(later.left, q.cwiseMax(0.0).cwiseMin(Eigen::Vector2d(319, 179))));
      unmoved.push_back(grey(later.left, p));
    }
    QVERIFY(a.size() > 100);
    QVERIFY(way / static_cast<double>(a.size()) > 3.0);
    const double carried = correlation(a, b), fixed = correlation(a, unmoved);
    QVERIFY2(carried > 0.55 && carried > fixed + 0.1, qPrintable(QString("%1 %2").arg(carried).arg(fixed)));
  }

  void PicturesAreWellExposed() {
    const Picture picture = theatre_->render(0).left;
    std::size_t white = 0;
    for (const std::uint8_t level : *picture.bytes) white += level >= 250 ? 1 : 0;
    QVERIFY(static_cast<double>(white) < 0.05 * static_cast<double>(picture.bytes->size()));
    const std::vector<float> depth = theatre_->depth(0);
    double red = 0.0, blue = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
      if (depth[i] == 0.0F) continue;
      blue += (*picture.bytes)[3 * i];
      red += (*picture.bytes)[3 * i + 2];
      ++count;
    }
    QVERIFY(red / count > 80 && red / count < 190 && red > 1.3 * blue);
  }

  void TheSameOptionsGiveTheSameBits() {
    TheatreOptions options = small_options();
    options.truth_vertices = 400;
    const auto one = Theatre::build(test::small_patient(), options, RunContext()).value();
    const auto two = Theatre::build(test::small_patient(), options, RunContext()).value();
    QVERIFY(one->truth(7).nodes_in_camera == two->truth(7).nodes_in_camera);
    const StereoFrame a = one->render(7);
    static_cast<void>(two->render(90));  // what was drawn before does not matter
    QVERIFY(*a.left.bytes == *two->render(7).left.bytes && *a.right.bytes == *two->render(7).right.bytes);
    QVERIFY(one->patch(2, PatchOptions{}).cloud.points == two->patch(2, PatchOptions{}).cloud.points);
    QVERIFY(*one->render(8).left.bytes != *a.left.bytes);
  }

  void APatchCoversItsShareWithLabelsAndNoise() {
    PatchOptions options;
    options.noise_mm = 0.0;
    const Patch exact = theatre_->patch(0, options);
    QVERIFY(std::abs(exact.share - 0.3) < 0.01);
    const TriangleMesh surface = theatre_->surface(0);
    const double cm2 = 1e4 * area(surface);
    QVERIFY(std::abs(exact.cloud.size() - 0.3 * cm2 * options.density_per_cm2) < 0.03 * exact.cloud.size());
    for (const double d : distances_to_surface(exact.cloud.points, surface)) QVERIFY(d < 1e-9);
    const Points margin = theatre_->carry(theatre_->landmarks().anterior_margin, 0);
    int labelled = 0;
    for (int i = 0; i < exact.cloud.size(); ++i) {
      if (exact.cloud.feature(i) != Feature::anterior_margin) continue;
      ++labelled;
      QVERIFY((margin.rowwise() - exact.cloud.points.row(i)).rowwise().norm().minCoeff() < 0.009);
    }
    QVERIFY(labelled > 10);
    options.noise_mm = 1.0;
    std::vector<double> off = distances_to_surface(theatre_->patch(0, options).cloud.points, surface);
    double mean = 0.0;
    for (const double d : off) mean += d / static_cast<double>(off.size());
    QVERIFY(mean > 0.6e-3 && mean < 1.0e-3);  // E|N(0, 1 mm)| = 0.8 mm across the surface
    options.holes = 4;
    QVERIFY(theatre_->patch(0, options).cloud.size() < exact.cloud.size());
  }

  void AFilmHoldsWhatTheTheatreShowed() {
    const TemporaryFolder folder;
    FilmOptions options;
    options.frames = 4;
    options.picture_frames = {2};
    const Film made = film(*theatre_, folder.path(), options, RunContext()).value();
    QCOMPARE(made.frames, 4);
    stereo::StereoVideo video(made.video);
    StereoFrame frame;
    int read = 0;
    while (video.read(frame)) ++read;
    QCOMPARE(read, 4);
    const StereoRig rig = stereo::read_calibration(made.calibration);
    QVERIFY((rig.right_from_left.translation - theatre_->rig().right_from_left.translation).norm() < 1e-9);
    const Points nodes = read_node_list(made.truth / "nodes_0003.xyz", LengthUnit::millimetre);
    QVERIFY((nodes - theatre_->truth(3).nodes_in_camera).cwiseAbs().maxCoeff() < 1e-7);
    int width = 0, height = 0;
    const std::vector<float> depth = read_depth(made.truth / "depth_0002.pfm", width, height);
    const std::vector<float> expected = theatre_->depth(2);
    QCOMPARE(width, 320);
    QCOMPARE(height, 180);
    for (std::size_t i = 0; i < depth.size(); ++i) QVERIFY(std::abs(depth[i] - expected[i]) < 1e-7F);
    QVERIFY(*stereo::read_picture(made.left_pictures.at(0)).bytes == *theatre_->render(2).left.bytes);
  }

  void ATruncatedDepthMapIsRefused() {
    const TemporaryFolder folder;
    write_file_atomically(folder.path() / "d.pfm", "Pf\n4 4\n-1.0\nabc");
    int width = 0, height = 0;
    QVERIFY_THROWS_EXCEPTION(InputError,
                             static_cast<void>(read_depth(folder.path() / "d.pfm", width, height)));
  }

  void ACancelledTheatreIsNotBuilt() {
    auto cancel = std::make_shared<CancelFlag>();
    const RunContext context(
        [&](double, std::string_view stage) {
          if (stage.starts_with("theatre.gas")) cancel->request();
        },
        cancel, 1);
    QVERIFY(!Theatre::build(test::small_patient(), small_options(), context).has_value());
  }
  void ACancelledFilmLeavesNoVideo() {
    const TemporaryFolder folder;
    auto cancel = std::make_shared<CancelFlag>();
    cancel->request();
    QVERIFY(!film(*theatre_, folder.path(), {}, RunContext({}, cancel, 1)).has_value());
    QVERIFY(!std::filesystem::exists(folder.path() / "stereo.mkv"));
  }

  void UnusableOptionsAreRefused() {
    const auto refused = [](auto change) {
      TheatreOptions options;
      change(options);
      try {
        options.validate();
      } catch (const InputError&) {
        return true;
      }
      return false;
    };
    QVERIFY(!refused([](TheatreOptions&) {}));
    QVERIFY(refused([](TheatreOptions& o) { o.camera_distance_mm = 40.0; }));
    QVERIFY(refused([](TheatreOptions& o) { o.mean_displacement_mm = 10.0; }));
    QVERIFY(refused([](TheatreOptions& o) { o.width = 0; }));
    QVERIFY(refused([](TheatreOptions& o) { o.frames = 0; }));
    QVERIFY(refused([](TheatreOptions& o) { o.noise = std::nan(""); }));
    PatchOptions patch;
    patch.share = 0.0;
    QVERIFY_THROWS_EXCEPTION(InputError, theatre_->patch(0, patch));
  }
  void AFrameBeyondTheEndThrows() {
    QVERIFY_THROWS_EXCEPTION(PreconditionError, theatre_->render(theatre_->frame_count()));
  }
  void APatientWithoutALiverIsRefused() {
    QVERIFY_THROWS_EXCEPTION(InputError,
                             static_cast<void>(Theatre::build({}, small_options(), RunContext())));
  }
  void AnOpenLiverIsRefused() {
    PatientModel patient = test::small_patient();
    patient.surfaces[0].mesh.triangles.conservativeResize(patient.surfaces[0].mesh.triangles.rows() - 3, 3);
    QVERIFY_THROWS_EXCEPTION(InputError,
                             static_cast<void>(Theatre::build(patient, small_options(), RunContext())));
  }
};

QTEST_APPLESS_MAIN(TheatreTest)
#include "theatre_test.moc"
