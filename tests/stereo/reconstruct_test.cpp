// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/reconstruct_pair.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/stereo/evaluate.h"
#include "rectification.h"
#include "rendered_pair.h"

using namespace glisson;
using namespace glisson::stereo;

namespace {

const Eigen::Vector3d kTilted = Eigen::Vector3d(0.35, -0.2, -1.0).normalized();

const rendered::Pair& plane_pair() {
  static const rendered::Pair pair = rendered::pair(rendered::plane({0.0, 0.0, 0.1}, kTilted));
  return pair;
}
const rendered::Pair& sphere_pair() {
  static const rendered::Pair pair = rendered::pair(rendered::sphere({0.01, 0.0, 0.16}, 0.06));
  return pair;
}

PairInput input_of(const rendered::Pair& pair) { return {{pair.left, pair.right}, pair.rig, {}, {}}; }

/// The whole pair's points.
Reconstructed run(const rendered::Pair& pair, const ReconstructOptions& options = {},
                  const Picture& mask = {}) {
  PairInput input = input_of(pair);
  input.mask = mask;
  return *reconstruct_pair(input, options, RunContext())->whole;
}
/// Those within regions.
LabelledPart within(const rendered::Pair& pair, const Regions& regions,
                    const ReconstructOptions& options = {}) {
  PairInput input = input_of(pair);
  input.regions = regions;
  return reconstruct_pair(input, options, RunContext())->part;
}

Picture uniform(int width, int height, int channels, std::uint8_t value) {
  return {width, height, channels,
          std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(width * height * channels),
                                                      value)};
}

Region rectangle(Feature feature, double x0, double y0, double x1, double y1) {
  return {feature, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// The picture with white disks; `shift` moves them, as highlights move with the camera.
Picture with_highlights(const Picture& picture, int shift) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture.bytes);
  for (int cy = 60; cy < picture.height; cy += 80)
    for (int cx = 80; cx < picture.width - 40; cx += 90)
      for (int y = -6; y <= 6; ++y)
        for (int x = -6; x <= 6; ++x)
          if (x * x + y * y <= 36)
            for (int c = 0; c < 3; ++c)
              (*bytes)[static_cast<std::size_t>(((cy + y) * picture.width + cx + x + shift) * 3 + c)] = 250;
  return {picture.width, picture.height, 3, std::move(bytes)};
}

}  // namespace

class ReconstructTest : public QObject {
  Q_OBJECT

 private slots:
  void DepthIsTrueAndUnbiased_data() {
    QTest::addColumn<bool>("sphere");
    QTest::addColumn<bool>("dense");
    QTest::addColumn<bool>("smooth");
    for (const bool sphere : {false, true})
      for (const bool dense : {false, true})
        for (const bool smooth : {false, true})
          QTest::addRow("%s %s %s", sphere ? "sphere" : "plane", dense ? "dense" : "sparse",
                        smooth ? "smooth" : "raw")
              << sphere << dense << smooth;
  }
  void DepthIsTrueAndUnbiased() {
    QFETCH(bool, sphere);
    QFETCH(bool, dense);
    QFETCH(bool, smooth);
    const rendered::Pair& pair = sphere ? sphere_pair() : plane_pair();
    ReconstructOptions options;
    options.method = dense ? Method::dense : Method::sparse;
    options.smooth = smooth;
    const Reconstructed result = run(pair, options);
    const CloudErrors errors = cloud_errors(result.cloud, pair.rig.left, pair.depth);
    qInfo("%d points, %.2f per cm2, median %.3f mm, p95 %.3f mm, max %.3f mm, bias %.3f mm, normalised %.2f",
          result.cloud.size(), result.report.density_per_cm2, 1e3 * errors.distance.median,
          1e3 * errors.distance.percentile_95, 1e3 * errors.distance.maximum, 1e3 * errors.bias,
          errors.normalised);
    QVERIFY(result.cloud.size() > 150);
    // A pixel of disparity is 2.9 mm at 100 mm.
    QVERIFY(std::abs(errors.bias) < 0.08e-3);
    QVERIFY(errors.distance.median < (smooth ? 0.1e-3 : 0.15e-3));
    QVERIFY(errors.distance.percentile_95 < 0.7e-3);
    QVERIFY(errors.distance.maximum < 6e-3);
  }

  void SigmaIsCalibrated() {
    ReconstructOptions options;
    options.smooth = false;
    for (const auto* pair : {&plane_pair(), &sphere_pair()}) {
      const CloudErrors errors = cloud_errors(run(*pair, options).cloud, pair->rig.left, pair->depth);
      QVERIFY2(errors.normalised > 0.5 && errors.normalised < 2.0,
               QByteArray::number(errors.normalised).constData());
    }
  }

  void EveryKindOfFeatureFindsTheTrueDepth_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("sift") << static_cast<int>(Features::sift);
    QTest::newRow("akaze") << static_cast<int>(Features::akaze);
  }
  void EveryKindOfFeatureFindsTheTrueDepth() {
    QFETCH(int, kind);
    ReconstructOptions options;
    options.kind = static_cast<Features>(kind);
    const Reconstructed result = run(plane_pair(), options);
    const CloudErrors errors = cloud_errors(result.cloud, plane_pair().rig.left, plane_pair().depth);
    qInfo("%d features, %d points, median %.3f mm, p95 %.3f mm", result.report.features_left,
          result.cloud.size(), 1e3 * errors.distance.median, 1e3 * errors.distance.percentile_95);
    QVERIFY(result.cloud.size() > 300);
    QVERIFY(errors.distance.median < 0.15e-3);
    QVERIFY(errors.distance.percentile_95 < 0.6e-3);
    QVERIFY(std::abs(errors.bias) < 0.05e-3);
  }

  void DenserMethodIsChosenWhereFeaturesAreFew() {
    ReconstructOptions options;
    options.method = Method::automatic;
    QVERIFY(run(plane_pair(), options).report.method == Method::sparse);
    options.features = 60;  // too few for the density that is wanted
    options.least_density_per_cm2 = 2.0;
    const Reconstructed result = run(plane_pair(), options);
    QVERIFY(result.report.method == Method::dense);
    QVERIFY(result.report.density_per_cm2 > 2.0);
    // Dense ones that are no denser are no help.
    options.method = Method::sparse;
    const Reconstructed sparse = run(plane_pair(), options);
    options.method = Method::automatic;
    options.least_density_per_cm2 = 1.0001 * sparse.report.density_per_cm2;
    options.points_per_cm2 = 0.5 * sparse.report.density_per_cm2;
    QVERIFY(run(plane_pair(), options).report.method == Method::sparse);
  }

  void CovarianceOfTriangulationIsThatOfItsSamples() {
    const StereoRig rig = rendered::rig();
    const Rectification rectification(rig);
    const Eigen::Vector2d left(420.0, 180.0);
    const double disparity = rectification.disparity_at(0.11), column = 0.2, row = 0.3, sigma = 0.25;
    std::mt19937 random(2);  // NOLINT: the same samples on every run
    std::normal_distribution<double> normal;
    const Eigen::Vector3d middle = rectification.triangulate(left, left.y(), disparity);
    Eigen::Matrix3d sampled = Eigen::Matrix3d::Zero();
    constexpr int kSamples = 40000;
    for (int i = 0; i < kSamples; ++i) {
      const Eigen::Vector2d moved = left + Eigen::Vector2d{column * normal(random), row * normal(random)};
      const Eigen::Vector3d p =
          rectification.triangulate(moved, moved.y(), disparity + sigma * normal(random)) - middle;
      sampled += p * p.transpose() / kSamples;
    }
    const Eigen::Matrix3d expected = rectification.covariance(left, disparity, column, row, sigma);
    QVERIFY((sampled - expected).norm() < 0.05 * expected.norm());
  }

  void CovarianceIsLargestAlongTheRay() {
    ReconstructOptions options;
    options.smooth = false;
    const Reconstructed result = run(plane_pair(), options);
    QCOMPARE(static_cast<int>(result.covariance.size()), result.cloud.size());
    for (int i = 0; i < result.cloud.size(); ++i) {
      const Eigen::Matrix3d& c = result.covariance[static_cast<std::size_t>(i)];
      const Eigen::Vector3d ray = result.cloud.points.row(i).transpose().normalized();
      QVERIFY(std::abs(std::sqrt(ray.dot(c * ray)) / result.cloud.sigma[static_cast<std::size_t>(i)] - 1.0) <
              0.1);
      QVERIFY(ray.dot(c * ray) > 0.8 * c.trace());
    }
  }

  void OutsideOfTheCircleIsLeftOut() {
    rendered::Pair pair = plane_pair();
    const auto with_circle = [](const Picture& picture) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture.bytes);
      for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
          if (std::hypot(x - 320.0, y - 240.0) > 200.0)
            for (int c = 0; c < 3; ++c)
              (*bytes)[static_cast<std::size_t>((y * picture.width + x) * 3 + c)] = 2;
      return Picture{picture.width, picture.height, 3, std::move(bytes)};
    };
    pair.left = with_circle(pair.left);
    pair.right = with_circle(pair.right);
    const Reconstructed result = run(pair);
    QVERIFY(result.cloud.size() > 200);
    for (int i = 0; i < result.cloud.size(); ++i) {
      const Eigen::Vector2d pixel = pair.rig.left.project(result.cloud.points.row(i).transpose());
      QVERIFY((pixel - Eigen::Vector2d(320, 240)).norm() < 199.0);
    }
    const CloudErrors errors = cloud_errors(result.cloud, pair.rig.left, pair.depth);
    QVERIFY(errors.distance.percentile_95 < 0.6e-3);
  }

  void NormalsFaceTheCameraAndFollowTheSurface() {
    const Reconstructed flat = run(plane_pair()), round = run(sphere_pair());
    std::vector<double> angles;
    for (int i = 0; i < flat.cloud.size(); ++i) {
      QVERIFY(flat.cloud.normals.row(i).dot(flat.cloud.points.row(i)) < 0.0);
      QVERIFY(std::abs(flat.cloud.normals.row(i).norm() - 1.0) < 1e-9);
      angles.push_back(std::acos(std::min(1.0, flat.cloud.normals.row(i).dot(kTilted.transpose()))));
    }
    for (int i = 0; i < round.cloud.size(); ++i) {
      const Eigen::Vector3d outwards =
          (round.cloud.points.row(i).transpose() - Eigen::Vector3d(0.01, 0.0, 0.16)).normalized();
      angles.push_back(std::acos(std::min(1.0, round.cloud.normals.row(i).dot(outwards.transpose()))));
    }
    std::sort(angles.begin(), angles.end());
    QVERIFY2(angles[angles.size() / 2] < 0.14, QByteArray::number(angles[angles.size() / 2]).constData());
    QVERIFY2(angles[angles.size() * 9 / 10] < 0.4,
             QByteArray::number(angles[angles.size() * 9 / 10]).constData());
  }

  void PointsTakeTheLabelOfTheirRegion() {
    Regions regions;
    regions.regions = {rectangle(Feature::surface, 150, 100, 500, 400),
                       rectangle(Feature::anterior_margin, 150, 300, 500, 400),
                       rectangle(Feature::umbilical_notch, 300, 330, 400, 400)};
    const LabelledPart result = within(plane_pair(), regions);
    int counts[4] = {0, 0, 0, 0};
    for (int i = 0; i < result.cloud.size(); ++i) {
      const Eigen::Vector2d pixel = plane_pair().rig.left.project(result.cloud.points.row(i).transpose());
      // Rows may have moved by the half of what was left between the two.
      bool near_border = false;
      for (const Eigen::Vector2d& d :
           {Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, -1), Eigen::Vector2d(-1, -1)})
        near_border = near_border || feature_at(regions, pixel + d) != feature_at(regions, pixel);
      if (near_border) continue;
      QVERIFY(feature_at(regions, pixel) == result.cloud.feature(i));
      ++counts[static_cast<int>(result.cloud.feature(i))];
    }
    QVERIFY(counts[1] > 20 && counts[2] > 5 && counts[3] > 3);
    QVERIFY(result.cloud.size() < run(plane_pair()).cloud.size());
  }

  void RegionsOnTheRightPictureLabelTheSamePoints() {
    // What a region of the left picture shows, clicked on the right one: each vertex where the plane puts it.
    Regions on_left, on_right;
    on_left.regions = {rectangle(Feature::surface, 200, 150, 450, 350)};
    on_right = on_left;
    on_right.regions[0].side = Side::right;
    const StereoRig& rig = plane_pair().rig;
    for (Eigen::Vector2d& vertex : on_right.regions[0].polygon) {
      const Eigen::Vector3d ray = rig.left.ray(vertex);
      const Eigen::Vector3d p = ray * (Eigen::Vector3d(0.0, 0.0, 0.1).dot(kTilted) / ray.dot(kTilted));
      vertex = rig.right.project((rig.right_from_left * Point<CameraFrame>(p)).xyz);
    }
    const LabelledPart left = within(plane_pair(), on_left), right = within(plane_pair(), on_right);
    QVERIFY(left.cloud.size() > 100);
    QVERIFY(std::abs(left.cloud.size() - right.cloud.size()) <= left.cloud.size() / 25);
    QVERIFY(std::abs(left.area_cm2 - right.area_cm2) < 0.06 * left.area_cm2);
  }

  void RegionsOfAnotherFrameAreRefused() {
    Regions regions;
    regions.regions = {rectangle(Feature::surface, 150, 100, 500, 400)};
    regions.identity = frame_identity(plane_pair().left, plane_pair().right);
    QVERIFY(within(plane_pair(), regions).cloud.size() > 0);
    QVERIFY_THROWS_EXCEPTION(InputError, within(sphere_pair(), regions));
  }

  void MaskKeepsPointsOut() {
    Picture mask = uniform(640, 480, 1, 0);
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*mask.bytes);
    for (int y = 100; y < 400; ++y)
      for (int x = 100; x < 320; ++x) (*bytes)[static_cast<std::size_t>(y * 640 + x)] = 1;
    mask.bytes = bytes;
    for (const Method method : {Method::sparse, Method::dense}) {
      ReconstructOptions options;
      options.method = method;
      const Reconstructed result = run(plane_pair(), options, mask);
      QVERIFY(result.cloud.size() > 50);
      for (int i = 0; i < result.cloud.size(); ++i) {
        const Eigen::Vector2d pixel = plane_pair().rig.left.project(result.cloud.points.row(i).transpose());
        QVERIFY(pixel.x() > 97 && pixel.x() < 323 && pixel.y() > 97 && pixel.y() < 403);
      }
    }
  }

  void DensityIsPointsPerAreaOfTheSurface() {
    // A plane square to the view at 100 mm: 200 x 200 pixels of f = 700 are 2.857 cm a side.
    const rendered::Pair pair = rendered::pair(rendered::plane({0, 0, 0.1}, {0, 0, 1}));
    Regions regions;
    regions.regions = {rectangle(Feature::surface, 222, 143, 422, 343)};
    const LabelledPart result = within(pair, regions);
    const double expected = std::pow(200.0 / 701.0 * 10.0, 2);
    QVERIFY2(std::abs(result.area_cm2 - expected) < 0.1 * expected,
             QByteArray::number(result.area_cm2).constData());
    QVERIFY(std::abs(result.density_per_cm2 * result.area_cm2 - result.cloud.size()) < 1e-6);
    ReconstructOptions options;
    options.method = Method::dense;
    options.points_per_cm2 = 20.0;
    const double density = within(pair, regions, options).density_per_cm2;
    QVERIFY2(density > 12.0 && density < 24.0, QByteArray::number(density).constData());
  }

  void HighlightsMakeNoPoints() {
    rendered::Pair pair = plane_pair();
    pair.left = with_highlights(pair.left, 0);
    pair.right = with_highlights(pair.right, -12);  // far from where the tissue's disparity puts it
    for (const Method method : {Method::sparse, Method::dense}) {
      ReconstructOptions options;
      options.method = method;
      const CloudErrors errors = cloud_errors(run(pair, options).cloud, pair.rig.left, pair.depth);
      QVERIFY(errors.distance.percentile_95 < 1.5e-3);
      QVERIFY(std::abs(errors.bias) < 0.12e-3);
    }
  }

  void DepthStepIsNotBridged() {
    // A plate 20 mm in front of a wall: points lie on one of them, not between.
    const rendered::Surface plate = [](const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
      const double t = (0.09 - o.z()) / d.z();
      return o.x() + t * d.x() < 0.0 ? t : 0.0;
    };
    const rendered::Pair pair =
        rendered::pair(rendered::both(plate, rendered::plane({0, 0, 0.11}, {0, 0, 1})));
    const Reconstructed result = run(pair);
    int between = 0;
    for (int i = 0; i < result.cloud.size(); ++i)
      between += result.cloud.points(i, 2) > 0.093 && result.cloud.points(i, 2) < 0.105;
    QVERIFY2(between <= result.cloud.size() / 50, QByteArray::number(between).constData());
  }

  void SameInputGivesTheSameBits() {
    for (const Method method : {Method::sparse, Method::dense}) {
      ReconstructOptions options;
      options.method = method;
      const Reconstructed one = run(sphere_pair(), options), two = run(sphere_pair(), options);
      QVERIFY(one.cloud.points == two.cloud.points && one.cloud.normals == two.cloud.normals);
      QVERIFY(one.cloud.sigma == two.cloud.sigma);
    }
  }

  void ImagesOfAnotherSizeAreRefused() {
    const rendered::Pair& pair = plane_pair();
    const Picture small = uniform(320, 240, 3, 100);
    const auto attempt = [&](const Picture& l, const Picture& r, const Picture& mask) {
      reconstruct_pair({{l, r}, pair.rig, mask, {}}, {}, RunContext());
    };
    QVERIFY_THROWS_EXCEPTION(InputError, attempt(small, pair.right, {}));
    QVERIFY_THROWS_EXCEPTION(InputError, attempt(pair.left, small, {}));
    QVERIFY_THROWS_EXCEPTION(InputError, attempt(pair.left, pair.right, uniform(320, 240, 1, 1)));
    QVERIFY_THROWS_EXCEPTION(InputError, attempt({}, pair.right, {}));
  }

  void SwappedImagesAreRecognised() {
    for (const auto* pair : {&plane_pair(), &sphere_pair()}) {
      try {
        reconstruct_pair({{pair->right, pair->left}, pair->rig, {}, {}}, {}, RunContext());
        QFAIL("swapped images were taken");
      } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).contains("swapped"), error.what());
      }
    }
  }

  void OnePictureTwiceIsRefused() {
    const rendered::Pair& pair = plane_pair();
    const Picture copy{pair.left.width, pair.left.height, 3,
                       std::make_shared<std::vector<std::uint8_t>>(*pair.left.bytes)};
    const PairInput twice{{pair.left, copy}, pair.rig, {}, {}};
    QVERIFY_THROWS_EXCEPTION(InputError, reconstruct_pair(twice, {}, RunContext()));
  }

  void KnownPointsAreNotMadeAgain() {
    ReconstructOptions options;
    const PairInput input = input_of(plane_pair());
    const auto first = reconstruct_pair(input, options, RunContext());
    const auto again = reconstruct_pair(input, options, RunContext(), {options, first->whole});
    QVERIFY(again->whole == first->whole);
    QCOMPARE(again->frame_identity, frame_identity(plane_pair().left, plane_pair().right));
    ReconstructOptions other = options;
    other.ratio = 0.7;
    QVERIFY(reconstruct_pair(input, other, RunContext(), {options, first->whole})->whole != first->whole);
  }

  void WithoutRegionsEverythingIsSurfaceAtTheWholesDensity() {
    const auto made = reconstruct_pair(input_of(plane_pair()), {}, RunContext());
    QVERIFY(made->part.cloud.points == made->whole->cloud.points);
    QVERIFY(made->part.cloud.features == made->whole->cloud.features);
    QCOMPARE(made->part.area_cm2, made->whole->report.area_cm2);
    QCOMPARE(made->part.density_per_cm2, made->whole->report.density_per_cm2);
    QVERIFY(made->density.area_cm2 > 0.0);
    QVERIFY(!made->check || made->check->faults.empty());
  }

  void RegionsThatAreThinMakeThePairDenseAndItStaysSo() {
    ReconstructOptions options;
    options.features = 250;
    PairInput input = input_of(plane_pair());
    const auto sparse = reconstruct_pair(input, options, RunContext());
    const double whole = sparse->part.density_per_cm2;
    double thin = whole;
    Regions thin_regions;
    for (double y = 100.0; y < 300.0; y += 40.0)
      for (double x = 150.0; x < 450.0; x += 40.0) {
        Regions square;
        square.regions = {rectangle(Feature::surface, x, y, x + 80.0, y + 80.0)};
        const double density = label(sparse->whole->cloud, input.rig, {}, square).density_per_cm2;
        if (density > 0.0 && density < thin) thin = density, thin_regions = square;
      }
    QVERIFY(thin < 0.9 * whole);
    options.method = Method::automatic;
    options.least_density_per_cm2 = 0.5 * (thin + whole);
    QVERIFY(reconstruct_pair(input, options, RunContext())->whole->report.method == Method::sparse);
    input.regions = thin_regions;
    const auto dense = reconstruct_pair(input, options, RunContext());
    QVERIFY(dense->whole->report.method == Method::dense);
    QVERIFY(dense->part.density_per_cm2 > thin);
    input.regions = {};
    const auto stays = reconstruct_pair(input, options, RunContext(), {options, dense->whole});
    QVERIFY(stays->whole == dense->whole);
  }

  void AFaultOfThePairIsTheBetterAnswer() {
    const Picture black = uniform(640, 480, 3, 0);
    try {
      reconstruct_pair({{plane_pair().left, black}, plane_pair().rig, {}, {}}, {}, RunContext());
      QFAIL("a lost view was taken");
    } catch (const InputError& error) {
      QVERIFY2(QString(error.what()).contains("nothing in the right view"), error.what());
    }
  }

  void PicturesWithoutTissueAreRefused() {
    const rendered::Pair& pair = plane_pair();
    const Picture black = uniform(640, 480, 3, 0);
    const auto attempt = [&](const Picture& l, const Picture& r, const Regions& regions) {
      reconstruct_pair({{l, r}, pair.rig, {}, regions}, {}, RunContext());
    };
    QVERIFY_THROWS_EXCEPTION(InputError, attempt(black, black, {}));
    QVERIFY_THROWS_EXCEPTION(InputError, attempt(pair.left, black, {}));
    QVERIFY_THROWS_EXCEPTION(InputError, attempt(pair.left, uniform(640, 480, 3, 255), {}));
    Regions outside;
    outside.regions = {rectangle(Feature::surface, 1000, 1000, 1100, 1100)};
    QVERIFY_THROWS_EXCEPTION(InputError, attempt(pair.left, pair.right, outside));
  }

  void CancelGivesNothing() {
    const auto cancel = std::make_shared<CancelFlag>();
    cancel->request();
    const rendered::Pair& pair = plane_pair();
    QVERIFY(!reconstruct_pair(input_of(pair), {}, RunContext({}, cancel, 1)));
    const auto later = std::make_shared<CancelFlag>();
    const RunContext context(
        [&](double fraction, std::string_view) {
          if (fraction > 0.5) later->request();
        },
        later, 1);
    QVERIFY(!reconstruct_pair(input_of(pair), {}, context));
  }

  void OptionsOutOfRangeAreRefused() {
    const auto refused = [](auto change) {
      ReconstructOptions options;
      change(options);
      try {
        options.validate();
        return false;
      } catch (const PreconditionError&) {
        return true;
      }
    };
    ReconstructOptions().validate();
    QVERIFY(refused([](auto& o) { o.features = 0; }));
    QVERIFY(refused([](auto& o) { o.ratio = 1.2; }));
    QVERIFY(refused([](auto& o) { o.ratio = 0.0; }));
    QVERIFY(refused([](auto& o) { o.epipolar_px = 0.0; }));
    QVERIFY(refused([](auto& o) { o.reprojection_px = -1.0; }));
    QVERIFY(refused([](auto& o) { o.near = 0.0; }));
    QVERIFY(refused([](auto& o) { o.far = o.near; }));
    QVERIFY(refused([](auto& o) { o.points_per_cm2 = 0.0; }));
    QVERIFY(refused([](auto& o) { o.patch = 1; }));
  }
};

QTEST_APPLESS_MAIN(ReconstructTest)
#include "reconstruct_test.moc"
