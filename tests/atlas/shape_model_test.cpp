// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <QTest>
#include <limits>
#include <random>

#include "glisson/atlas/atlas.h"
#include "glisson/atlas/member.h"
#include "glisson/atlas/shape_model.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/random.h"

using namespace glisson;
using namespace glisson::atlas;

namespace {

Points cloud(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = 0.05 * standard_normal(random);
  return points;
}

Similarity some(double scale, double angle, const Eigen::Vector3d& axis, const Eigen::Vector3d& by) {
  return {scale, Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), by};
}

double apart(const Points& a, const Points& b) { return (a - b).cwiseAbs().maxCoeff(); }

}  // namespace

class ShapeModelTest : public QObject {
  Q_OBJECT
 private slots:
  void sharesOfAnAreaLieBetweenNothingAndAll() {
    // An octahedron stands for the mean liver.
    Atlas atlas;
    atlas.shape.mean.resize(6, 3);
    atlas.shape.mean << 0.1, 0, 0, -0.1, 0, 0, 0, 0.08, 0, 0, -0.08, 0, 0, 0, 0.07, 0, 0, -0.07;
    atlas.triangles.resize(8, 3);
    atlas.triangles << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
    atlas.shape.modes.resize(18, 0);
    atlas.usual = atlas.log_size_deviation = 1.0;
    StructureStatistics cava;
    cava.structure = Structure::vena_cava;
    cava.mean = Points::Zero(5, 3);
    cava.slopes.resize(15, 0);
    cava.members = {"a", "b", "c"};
    cava.residuals.assign(3, Points::Zero(5, 3));
    cava.share = Eigen::VectorXd::LinSpaced(6, 0.0, 1.0);
    const auto reread = [&](double share) {
      const TemporaryFolder folder;
      cava.share[2] = share;
      atlas.structures = {cava};
      write_atlas(folder.path(), atlas);
      return read_atlas(folder.path()).structures.front().share;
    };
    QVERIFY((reread(0.4) - cava.share).cwiseAbs().maxCoeff() < 1e-6);
    for (const double share : {1e9, -0.5, std::numeric_limits<double>::quiet_NaN()})
      QVERIFY_THROWS_EXCEPTION(InputError, reread(share));
  }
  void aContactWithoutLengthHasNoMiddleLine() {
    const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();
    const auto line = [&](Structure structure, const Points& contact) {
      return ordered_points(structure, contact, upright, Points(0, 3)).rows();
    };
    Points slice(25, 3);  // all at one height
    for (int i = 0; i < 25; ++i) slice.row(i) << 1e-3 * (i % 5), 1e-3 * (i / 5), 0.12;
    QCOMPARE(line(Structure::vena_cava, slice), Eigen::Index{0});
    const Points one_place = Points::Constant(30, 3, 0.05);
    QCOMPARE(line(Structure::vena_cava, one_place), Eigen::Index{0});
    QCOMPARE(line(Structure::gallbladder_bed, one_place), Eigen::Index{0});
    Points upwards = slice;
    for (int i = 0; i < 25; ++i) upwards(i, 2) += 1e-3 * i;
    QCOMPARE(line(Structure::vena_cava, upwards), Eigen::Index{point_count(Structure::vena_cava)});
  }
  void aKnownSimilarityIsRecovered() {
    const Points source = cloud(1, 40);
    const Similarity truth = some(1.7, 2.6, {1, -2, 0.5}, {0.3, -0.1, 0.2});
    const Similarity found = fit_similarity(source, truth.apply(source));
    QVERIFY(std::abs(found.scale - truth.scale) < 1e-12);
    QVERIFY((found.rotation - truth.rotation).norm() < 1e-12);
    QVERIFY((found.translation - truth.translation).norm() < 1e-12);
    QVERIFY(apart(truth.inverse().apply(truth.apply(source)), source) < 1e-14);
  }
  /// Without det R = +1 a mirrored shape would be "recovered" by a reflection.
  void aMirrorImageIsNoSimilarity() {
    const Points source = cloud(2, 40);
    Points mirrored = source;
    mirrored.col(0) *= -1.0;
    const Similarity found = fit_similarity(source, mirrored);
    QVERIFY(std::abs(found.rotation.determinant() - 1.0) < 1e-12);
    QVERIFY(apart(found.apply(source), mirrored) > 1e-3);
  }
  /// The printed eq. 13 would leave the sizes as they are.
  void oneShapeInManyPlacesAndSizesAlignsToRounding() {
    const Points shape = cloud(3, 60);
    std::vector<Points> members;
    for (int i = 0; i < 5; ++i)
      members.push_back(
          some(0.6 + 0.3 * i, 0.7 * i, {1.0, 0.3 * i, -0.5}, {0.1 * i, -0.2, 0.05 * i}).apply(shape));
    const Procrustes result = align(members, std::vector<double>(5, 1.0), members[2]);
    for (int i = 0; i < 5; ++i)
      QVERIFY(apart(result.mean_from_member[i].apply(members[i]), result.mean) < 1e-12);
    double log_size = 0.0;
    for (const Points& member : members) log_size += std::log(size_of(member)) / 5;
    QVERIFY(std::abs(std::log(size_of(result.mean)) - log_size) < 1e-12);
    // In the gauge's place and orientation.
    QVERIFY((result.mean.colwise().mean() - members[2].colwise().mean()).norm() < 1e-12);
    QVERIFY((fit_similarity(result.mean, members[2]).rotation - Eigen::Matrix3d::Identity()).norm() < 1e-9);
  }
  void motionAndOrderOfMembersChangeNothing() {
    std::vector<Points> members, moved;
    const Points base = cloud(4, 50);
    for (int i = 0; i < 6; ++i) members.push_back(base + 0.1 * cloud(10 + i, 50));
    for (int i = 5; i >= 0; --i)
      moved.push_back(some(1.0, 1.1 * i, {0.2, 1, i - 2.0}, {0.1 * i, 0, 0.3}).apply(members[i]));
    const std::vector<double> weights(6, 1.0);
    const Procrustes one = align(members, weights, base), other = align(moved, weights, base);
    QVERIFY(apart(one.mean, other.mean) < 1e-9);
  }
  void knownModesAreRecoveredToRounding() {
    constexpr int kPoints = 30, kModes = 3, kShapes = 9;
    std::mt19937_64 random(5);
    Eigen::MatrixXd any(3 * kPoints, kModes), b(kShapes, kModes);
    for (Eigen::Index i = 0; i < any.size(); ++i) any.data()[i] = standard_normal(random);
    for (Eigen::Index i = 0; i < b.size(); ++i) b.data()[i] = standard_normal(random);
    const Eigen::MatrixXd modes = Eigen::HouseholderQR<Eigen::MatrixXd>(any).householderQ() *
                                  Eigen::MatrixXd::Identity(3 * kPoints, kModes);
    // Coefficients of no mean, orthogonal among themselves, of known variance.
    b.rowwise() -= b.colwise().mean();
    b = Eigen::HouseholderQR<Eigen::MatrixXd>(b).householderQ() * Eigen::MatrixXd::Identity(kShapes, kModes);
    const Eigen::Vector3d deviations(0.02, 0.01, 0.004);
    b = b * std::sqrt(kShapes - 1.0) * deviations.asDiagonal();
    const Points mean = cloud(6, kPoints);
    std::vector<Points> shapes;
    for (int i = 0; i < kShapes; ++i) {
      Points shape = mean;
      Eigen::Map<Eigen::VectorXd>(shape.data(), shape.size()) += modes * b.row(i).transpose();
      shapes.push_back(shape);
    }
    const ShapeModel model = shape_model(shapes, std::vector<double>(kShapes, 1.0), 1.0);
    QCOMPARE(model.mode_count(), kModes);
    QVERIFY(apart(model.mean, mean) < 1e-14);
    for (int k = 0; k < kModes; ++k) {
      QVERIFY(std::abs(model.variances[k] / (deviations[k] * deviations[k]) - 1.0) < 1e-9);
      QVERIFY(std::abs(std::abs(model.modes.col(k).dot(modes.col(k))) - 1.0) < 1e-9);
    }
    for (const Points& shape : shapes)
      QVERIFY(apart(model.instance(model.coefficients(shape)), shape) < 1e-12);
    // 90 % of the variance: 400 / 516 are too few, 500 / 516 are enough.
    QCOMPARE(shape_model(shapes, std::vector<double>(kShapes, 1.0), 0.9).mode_count(), 2);
  }
  /// A weight of two is the same as the member given twice, but for the number of members.
  void weightsCountAsMembers() {
    std::vector<Points> once, twice;
    for (int i = 0; i < 5; ++i) once.push_back(cloud(20 + i, 12));
    twice = once;
    twice.push_back(once[3]);
    const ShapeModel weighted = shape_model(once, {1, 1, 1, 2, 1}, 1.0);
    const ShapeModel repeated = shape_model(twice, std::vector<double>(6, 1.0), 1.0);
    QVERIFY(apart(weighted.mean, repeated.mean) < 1e-14);
    QVERIFY((weighted.variances.normalized() - repeated.variances.normalized()).norm() < 1e-9);
  }
  void shapesThatDoNotCorrespondAreRefused() {
    QVERIFY_THROWS_EXCEPTION(PreconditionError, fit_similarity(cloud(1, 4), cloud(1, 5)));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, align({cloud(1, 4)}, {1.0}, cloud(1, 4)));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, align({cloud(1, 4), cloud(1, 5)}, {1.0, 1.0}, cloud(1, 4)));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, shape_model({cloud(1, 4), cloud(2, 4)}, {1.0, 1.0}, 1.5));
  }
};

QTEST_APPLESS_MAIN(ShapeModelTest)
#include "shape_model_test.moc"
