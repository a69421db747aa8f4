// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/patient.h"

#include <QElapsedTimer>
#include <QTest>
#include <map>
#include <numeric>
#include <random>

#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/topology.h"
#include "patient_checks.h"

using namespace glisson;
using namespace glisson::test;
using insilico::make_patient;
using insilico::PatientOptions;

namespace {

double angle_degrees(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)) * 180.0 / M_PI;
}

}  // namespace

class PatientTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void RefusesOptionsOutOfRange();
  void DefaultGridIsAnisotropicAndCoversTheLiver();
  void SurfacesAreClosedWithOutwardNormals();
  void LabelsAndSurfacesAgree();
  void LiverLiesOnThePatientsRight();
  void IntensitiesArePortalVenous();
  void TreesNeverTouch();
  void RadiiFollowMurraysLaw();
  void TreesBranchOverGenerationsAndFillBothLobes();
  void VesselsRunInsideTheLiver();
  void LesionsAreInsideAndClearOfTheVessels();
  void MarginIsAnOrderedLineOnTheSurface();
  void MarginIsTheSharpestRidge();
  void NotchDentsTheMargin();
  void CavaPointsLieOnLiverAndCava();
  void NeighboursTouchTheLiverWithinFifteenHounsfield();
  void ThresholdWithLargestComponentFails();

 private:
  SyntheticPatient patient_;
};

void PatientTest::initTestCase() {
  QElapsedTimer timer;
  timer.start();
  patient_ = *make_patient(PatientOptions(), RunContext());
  qInfo("default patient made in %.1f s", 1e-3 * static_cast<double>(timer.elapsed()));
}

void PatientTest::RefusesOptionsOutOfRange() {
  PatientOptions options;
  options.spacing_mm.y() = 0.0;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  options = {};
  options.spacing_mm.z() = std::nan("");
  QVERIFY_THROWS_EXCEPTION(InputError, make_patient(options, RunContext()));
  options = {};
  options.noise_hu = -1.0;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  options = {};
  options.blur_mm = 1e3;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  options = {};
  options.surface_spacing_mm = 0.0;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  PatientOptions().validate();
}

void PatientTest::DefaultGridIsAnisotropicAndCoversTheLiver() {
  const VolumeGrid& grid = patient_.ct.grid;
  QVERIFY(grid.same_as(patient_.truth.voxels.grid()));
  QCOMPARE(static_cast<long>(patient_.ct.voxels->size()), grid.voxel_count());
  QVERIFY(grid.spacing_mm.x() < grid.spacing_mm.z());
  const TriangleMesh& liver = surface(patient_, structure::kParenchyma);
  for (int i = 0; i < liver.vertex_count(); ++i) {
    const Eigen::Vector3d index = grid.index_of(Point<CtFrame>(liver.vertex(i)));
    QVERIFY((index.array() > 3.0).all() && (index.array() < grid.size.cast<double>().array() - 4.0).all());
  }
}

void PatientTest::SurfacesAreClosedWithOutwardNormals() {
  QVERIFY(patient_.surfaces.size() >= 7);
  for (const NamedSurface& named : patient_.surfaces) {
    QVERIFY2(is_closed(named.mesh), named.name.c_str());
    QVERIFY2(volume(named.mesh) > 0.0, named.name.c_str());
    int pieces = 0;
    connected_components(named.mesh, &pieces);
    QVERIFY2(pieces == 1, named.name.c_str());
  }
  QCOMPARE(patient_.surfaces.front().name, std::string("liver"));
}

void PatientTest::LabelsAndSurfacesAgree() {
  const double voxel = patient_.truth.voxels.grid().voxel_volume_mm3() * 1e-9;
  const std::vector<long> histogram = patient_.truth.voxels.histogram();
  for (const Label label : {structure::kVenaCava, structure::kGallbladder, structure::kPortalVein,
                            structure::kHepaticVeins, structure::kFirstLesion}) {
    const double counted = static_cast<double>(histogram.at(label)) * voxel;
    const double meshed = volume(surface(patient_, label));
    // The stump of the hepatic veins in the cava is labelled cava.
    const double tolerance =
        label == structure::kPortalVein || label == structure::kHepaticVeins ? 0.12 : 0.04;
    QVERIFY2(std::abs(counted / meshed - 1.0) < tolerance, qPrintable(QString::number(label)));
  }
  // The liver's surface encloses exactly the voxels of its body: checked voxel by voxel away from the
  // surface.
  const TriangleMesh& liver = surface(patient_, structure::kParenchyma);
  const VolumeGrid& grid = patient_.truth.voxels.grid();
  std::mt19937_64 random(7);
  Points places(400, 3);
  std::vector<Label> labels;
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    const Eigen::Vector3i v{20 + static_cast<int>(random() % 180), 20 + static_cast<int>(random() % 160),
                            10 + static_cast<int>(random() % 130)};
    places.row(i) = grid.p_in_ct(v.cast<double>()).xyz.transpose();
    labels.push_back(patient_.truth.voxels.at(v));
  }
  const std::vector<double> distances = distances_to_surface(places, liver);
  int checked = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == structure::kPortalVein || labels[i] == structure::kHepaticVeins) continue;
    if (distances[i] < 1e-4) continue;
    QCOMPARE(inside_mesh(liver, places.row(static_cast<Eigen::Index>(i)).transpose()), of_liver(labels[i]));
    ++checked;
  }
  QVERIFY(checked > 300);
}

void PatientTest::LiverLiesOnThePatientsRight() {
  const Eigen::Vector3d liver = centroid(surface(patient_, structure::kParenchyma));
  const Eigen::Vector3d cava = centroid(surface(patient_, structure::kVenaCava));
  const Eigen::Vector3d bladder = centroid(surface(patient_, structure::kGallbladder));
  QVERIFY(liver.x() < -0.02);            // LPS: the patient's right
  QVERIFY(cava.y() > liver.y() + 0.02);  // the cava runs behind it
  QVERIFY(bladder.z() < liver.z() - 0.02);
  // The spleen: what has its density at the left flank, behind.
  const Eigen::Vector3i v =
      patient_.ct.grid.index_of(Point<CtFrame>(0.105, 0.04, 0.03)).array().round().cast<int>();
  QVERIFY(std::abs(patient_.ct.at(v) - 120) < 50);
}

void PatientTest::IntensitiesArePortalVenous() {
  std::map<Label, std::pair<double, long>> sums;
  const VolumeGrid& grid = patient_.ct.grid;
  for (int k = 1; k + 1 < grid.size.z(); ++k)
    for (int j = 1; j + 1 < grid.size.y(); ++j)
      for (int i = 1; i + 1 < grid.size.x(); ++i) {
        const Label label = patient_.truth.voxels.at({i, j, k});
        if (label == structure::kBackground) continue;
        // Only voxels whose neighbours are alike: the others share their intensity.
        bool alike = true;
        for (int a = 0; a < 3 && alike; ++a)
          for (const int step : {-1, 1}) {
            const Eigen::Vector3i n = Eigen::Vector3i(i, j, k) + step * Eigen::Vector3i::Unit(a);
            alike = alike && patient_.truth.voxels.at(n) == label;
          }
        if (!alike) continue;
        sums[label].first += patient_.ct.at({i, j, k});
        ++sums[label].second;
      }
  const auto mean = [&](Label label) { return sums[label].first / static_cast<double>(sums[label].second); };
  QVERIFY(std::abs(mean(structure::kParenchyma) - 110.0) < 4.0);
  QVERIFY(std::abs(mean(structure::kPortalVein) - 170.0) < 12.0);
  QVERIFY(std::abs(mean(structure::kHepaticVeins) - 160.0) < 12.0);
  QVERIFY(std::abs(mean(structure::kVenaCava) - 150.0) < 4.0);
  QVERIFY(std::abs(mean(structure::kFirstLesion) - 65.0) < 6.0);
  QVERIFY(std::abs(mean(structure::kGallbladder) - 10.0) < 20.0);
}

void PatientTest::TreesNeverTouch() {
  const double least =
      wall_distance(tree(patient_, structure::kPortalVein), tree(patient_, structure::kHepaticVeins));
  qInfo("least distance between the trees' walls: %.2f mm", 1e3 * least);
  QVERIFY(least > 2.0e-3);
  // And not in the label map either, corners included.
  const LabelVolume& labels = patient_.truth.voxels;
  const VolumeGrid& grid = labels.grid();
  int touching = 0;
  for (int k = 1; k + 1 < grid.size.z(); ++k)
    for (int j = 1; j + 1 < grid.size.y(); ++j)
      for (int i = 1; i + 1 < grid.size.x(); ++i) {
        if (labels.at({i, j, k}) != structure::kPortalVein) continue;
        for (int n = 0; n < 27; ++n)
          if (labels.at({i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1}) == structure::kHepaticVeins)
            ++touching;
      }
  QCOMPARE(touching, 0);
}

void PatientTest::RadiiFollowMurraysLaw() {
  for (const VesselTree& vessels : patient_.trees) {
    std::vector<double> cubes(vessels.radii.size(), 0.0);
    for (const auto& [parent, child] : vessels.beams)
      cubes[static_cast<std::size_t>(parent)] += std::pow(vessels.radii[static_cast<std::size_t>(child)], 3);
    for (std::size_t i = 0; i < cubes.size(); ++i)
      if (cubes[i] > 0.0) QVERIFY(std::abs(std::cbrt(cubes[i]) / vessels.radii[i] - 1.0) < 1e-9);
    const auto [thinnest, widest] = std::minmax_element(vessels.radii.begin(), vessels.radii.end());
    QVERIFY(*widest > 5e-3 && *widest < 8e-3);
    QVERIFY(*thinnest > 0.7e-3 && *thinnest < 1.6e-3);
  }
}

void PatientTest::TreesBranchOverGenerationsAndFillBothLobes() {
  const double notch = patient_.landmarks.umbilical_notch(0, 0);
  for (const VesselTree& vessels : patient_.trees) {
    std::vector<int> children(vessels.radii.size(), 0), generation(vessels.radii.size(), 0);
    for (const auto& [parent, child] : vessels.beams) ++children[static_cast<std::size_t>(parent)];
    for (const auto& [parent, child] : vessels.beams)  // from the root outwards
      generation[static_cast<std::size_t>(child)] = generation[static_cast<std::size_t>(parent)] +
                                                    (children[static_cast<std::size_t>(parent)] > 1 ? 1 : 0);
    QVERIFY(*std::max_element(generation.begin(), generation.end()) >= 6);
    QVERIFY(std::count(children.begin(), children.end(), 0) >= 100);

    const LabelVolume& labels = patient_.truth.voxels;
    long total[2] = {0, 0}, near[2] = {0, 0};
    for (int k = 0; k < labels.grid().size.z(); k += 4)
      for (int j = 0; j < labels.grid().size.y(); j += 5)
        for (int i = 0; i < labels.grid().size.x(); i += 5) {
          if (labels.at({i, j, k}) != structure::kParenchyma) continue;
          const Eigen::Vector3d p = labels.grid().p_in_ct(Eigen::Vector3d(i, j, k)).xyz;
          const int lobe = p.x() > notch ? 1 : 0;
          ++total[lobe];
          near[lobe] +=
              std::sqrt((vessels.nodes.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff()) < 0.018;
        }
    for (const int lobe : {0, 1}) {
      QVERIFY(total[lobe] > 300);
      QVERIFY2(static_cast<double>(near[lobe]) > 0.9 * static_cast<double>(total[lobe]),
               qPrintable(QString("lobe %1: %2 of %3").arg(lobe).arg(near[lobe]).arg(total[lobe])));
    }
  }
}

void PatientTest::VesselsRunInsideTheLiver() {
  const TriangleMesh& liver = surface(patient_, structure::kParenchyma);
  for (const VesselTree& vessels : patient_.trees) {
    long outside = 0;
    for (Eigen::Index i = 0; i < vessels.nodes.rows(); i += 3) {
      const Eigen::Vector3d p = vessels.nodes.row(i).transpose();
      if (inside_mesh(liver, p)) continue;
      ++outside;
      // Only the trunk before the hilum, and the stump in the cava.
      QVERIFY(vessels.radii[static_cast<std::size_t>(i)] > 2.5e-3);
    }
    QVERIFY(3 * outside < 25);
  }
}

void PatientTest::LesionsAreInsideAndClearOfTheVessels() {
  const TriangleMesh& liver = surface(patient_, structure::kParenchyma);
  const double expected_mm[] = {25.0, 15.0};
  for (int lesion = 0; lesion < 2; ++lesion) {
    const TriangleMesh& mesh = surface(patient_, static_cast<Label>(structure::kFirstLesion + lesion));
    const double diameter_mm = 2e3 * std::cbrt(volume(mesh) * 3.0 / (4.0 * M_PI));
    QVERIFY2(std::abs(diameter_mm - expected_mm[lesion]) < 2.0, qPrintable(QString::number(diameter_mm)));
    for (const double distance : distances_to_surface(mesh.vertices, liver)) QVERIFY(distance > 4e-3);
    QVERIFY(inside_mesh(liver, centroid(mesh)));
    for (const VesselTree& vessels : patient_.trees) {
      const std::vector<double> distances = distances_to_surface(vessels.nodes, mesh);
      for (std::size_t i = 0; i < distances.size(); ++i) {
        QVERIFY(distances[i] > vessels.radii[i]);
        QVERIFY(!inside_mesh(mesh, vessels.nodes.row(static_cast<Eigen::Index>(i)).transpose()));
      }
    }
  }
}

void PatientTest::MarginIsAnOrderedLineOnTheSurface() {
  const Points& margin = patient_.landmarks.anterior_margin;
  QVERIFY(margin.rows() > 60);
  const DistanceSummary off =
      summarise(distances_to_surface(margin, surface(patient_, structure::kParenchyma)));
  qInfo("margin to surface: mean %.2f, most %.2f mm", 1e3 * off.mean, 1e3 * off.maximum);
  QVERIFY(off.mean < 0.3e-3 && off.maximum < 0.8e-3);
  for (Eigen::Index i = 1; i < margin.rows(); ++i) {
    const double step = (margin.row(i) - margin.row(i - 1)).norm();
    QVERIFY(step > 1e-3 && step < 7e-3);
  }
  QVERIFY(margin(0, 0) < -0.10);                 // from the right flank
  QVERIFY(margin(margin.rows() - 1, 0) > 0.05);  // to the left lobe's tip
}

void PatientTest::MarginIsTheSharpestRidge() {
  // The largest angle between two normals within 7 mm of a place: near the margin, and in the rest of the
  // surface.
  const TriangleMesh& liver = surface(patient_, structure::kParenchyma);
  const Points normals = vertex_normals(liver);
  const Points& margin = patient_.landmarks.anterior_margin;
  const auto bend = [&](const Eigen::Vector3d& p) {
    std::vector<Eigen::Vector3d> around;
    for (int i = 0; i < liver.vertex_count(); i += 2)
      if ((liver.vertex(i) - p).norm() < 7e-3) around.push_back(normals.row(i).transpose());
    double largest = 0.0;
    for (std::size_t i = 0; i < around.size(); i += 2)
      for (std::size_t j = i + 1; j < around.size(); j += 2)
        largest = std::max(largest, angle_degrees(around[i], around[j]));
    return largest;
  };
  std::vector<double> on_margin, elsewhere;
  for (Eigen::Index i = 0; i < margin.rows(); i += 3) on_margin.push_back(bend(margin.row(i).transpose()));
  for (int i = 0; i < liver.vertex_count(); i += 211) {
    const Eigen::Vector3d p = liver.vertex(i);
    if (std::sqrt((margin.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff()) > 15e-3)
      elsewhere.push_back(bend(p));
  }
  std::sort(on_margin.begin(), on_margin.end());
  std::sort(elsewhere.begin(), elsewhere.end());
  const double margin_median = on_margin[on_margin.size() / 2];
  const double rest_90 = elsewhere[elsewhere.size() * 9 / 10];
  qInfo("bend within 7 mm: margin median %.0f, tenth %.0f; elsewhere median %.0f, nine tenths %.0f degrees",
        margin_median, on_margin[on_margin.size() / 10], elsewhere[elsewhere.size() / 2], rest_90);
  QVERIFY(margin_median > 90.0);
  QVERIFY(on_margin[on_margin.size() / 10] > rest_90);
}

void PatientTest::NotchDentsTheMargin() {
  const Points& margin = patient_.landmarks.anterior_margin;
  const Eigen::RowVector3d notch = patient_.landmarks.umbilical_notch.row(0);
  Eigen::Index nearest = 0;
  const double off = std::sqrt((margin.rowwise() - notch).rowwise().squaredNorm().minCoeff(&nearest));
  QVERIFY(off < 2.5e-3);
  // Depth below the chord between the margin's points 20 mm to either side.
  Eigen::Index left = nearest, right = nearest;
  while (left > 0 && (margin.row(left) - notch).norm() < 0.03) --left;
  while (right + 1 < margin.rows() && (margin.row(right) - notch).norm() < 0.03) ++right;
  const Eigen::RowVector3d chord = (margin.row(right) - margin.row(left)).normalized();
  const Eigen::RowVector3d to = notch - margin.row(left);
  const double depth = (to - to.dot(chord) * chord).norm();
  qInfo("notch depth %.1f mm", 1e3 * depth);
  QVERIFY(depth > 8e-3);
}

void PatientTest::CavaPointsLieOnLiverAndCava() {
  const Points& contact = patient_.landmarks.vena_cava;
  QVERIFY(contact.rows() >= 12);
  for (const double d : distances_to_surface(contact, surface(patient_, structure::kParenchyma)))
    QVERIFY(d < 1e-6);
  for (const double d : distances_to_surface(contact, surface(patient_, structure::kVenaCava)))
    QVERIFY(d < 1.5e-3);
}

void PatientTest::NeighboursTouchTheLiverWithinFifteenHounsfield() {
  PatientOptions options;
  options.spacing_mm = {2.0, 2.0, 2.0};
  options.noise_hu = options.blur_mm = 0.0;
  options.surface_spacing_mm = 3.0;
  const auto clean = make_patient(options, RunContext());
  const VolumeGrid& grid = clean->ct.grid;
  long shell = 0, alike = 0;
  for (int k = 2; k + 2 < grid.size.z(); ++k)
    for (int j = 2; j + 2 < grid.size.y(); ++j)
      for (int i = 2; i + 2 < grid.size.x(); ++i) {
        if (!of_liver(clean->truth.voxels.at({i, j, k}))) continue;
        for (int a = 0; a < 3; ++a)
          for (const int step : {-2, 2}) {
            const Eigen::Vector3i n = Eigen::Vector3i(i, j, k) + step * Eigen::Vector3i::Unit(a);
            if (clean->truth.voxels.at(n) != structure::kBackground) continue;
            ++shell;
            alike += std::abs(clean->ct.at(n) - 110) <= 15;
          }
      }
  const double share = static_cast<double>(alike) / static_cast<double>(shell);
  qInfo("share of the liver's surroundings within 15 HU of it: %.1f %%", 100.0 * share);
  QVERIFY(share > 0.03);
}

void PatientTest::ThresholdWithLargestComponentFails() {
  const VolumeGrid& grid = patient_.ct.grid;
  const std::vector<std::uint8_t> truth = patient_.truth.voxels.mask(of_liver);
  const long liver = std::accumulate(truth.begin(), truth.end(), 0L);
  const std::vector<std::int16_t>& ct = *patient_.ct.voxels;
  double best = 0.0;
  int best_low = 0, best_high = 0;
  std::vector<int> of;
  for (const int low : {70, 80, 85, 90, 95})
    for (const int high : {125, 130, 140, 190}) {
      std::vector<std::uint8_t> mask(ct.size());
      for (std::size_t i = 0; i < ct.size(); ++i) mask[i] = ct[i] >= low && ct[i] <= high;
      const std::vector<long> sizes = components(grid, mask, of);
      const int largest = static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
      long both = 0;
      for (std::size_t i = 0; i < of.size(); ++i) both += of[i] == largest && truth[i];
      const double dice = 2.0 * static_cast<double>(both) /
                          static_cast<double>(sizes[static_cast<std::size_t>(largest)] + liver);
      if (dice > best) best = dice, best_low = low, best_high = high;
    }
  qInfo("best threshold band [%d, %d] HU: Dice %.3f", best_low, best_high, best);
  QVERIFY(best > 0.3);  // the liver is in it
  QVERIFY(best < 0.8);
}

QTEST_APPLESS_MAIN(PatientTest)
#include "patient_test.moc"
