// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/mr_patient.h"

#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/insilico/patient.h"

using namespace glisson;
using insilico::MrOptions;
using insilico::MrPatient;

namespace {

MrPatient coarse(MrOptions options) {
  options.spacing_mm = {3.0, 3.0, 3.0};
  return insilico::make_mr_patient(options, RunContext()).value();
}

struct Spread {
  double mean = 0.0, deviation = 0.0;
};

/// Of a structure's voxels whose six neighbours belong to it too.
Spread inside(const MrPatient& patient, Label label) {
  const Eigen::Vector3i size = patient.mr.grid.size;
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (int k = 1; k + 1 < size.z(); ++k)
    for (int j = 1; j + 1 < size.y(); ++j)
      for (int i = 1; i + 1 < size.x(); ++i) {
        bool deep = patient.truth.voxels.at({i, j, k}) == label;
        for (int axis = 0; axis < 3 && deep; ++axis)
          for (const int step : {-1, 1}) {
            Eigen::Vector3i v(i, j, k);
            v[axis] += step;
            deep = deep && patient.truth.voxels.at(v) == label;
          }
        if (!deep) continue;
        const double value = patient.mr.at({i, j, k});
        sum += value, squares += value * value, ++count;
      }
  return {sum / count, std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)))};
}

}  // namespace

class MrPatientTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void VenousT1OrdersTissuesAsAVenousCt();
  void WithoutContrastAndOnT2BloodIsDark();
  void NoiseAndCoilsAreAsAskedFor();
  void ItsTruthIsThatOfTheSamePatientsCt();
  void TheSameOptionsGiveTheSameBits();
  void BadOptionsAreRefused();

 private:
  MrPatient even_;    ///< without coils
  MrPatient uneven_;  ///< as it comes
};

void MrPatientTest::initTestCase() {
  MrOptions options;
  uneven_ = coarse(options);
  options.coil_variation = 0.0;
  even_ = coarse(options);
}

void MrPatientTest::VenousT1OrdersTissuesAsAVenousCt() {
  const MrPatient& patient = even_;
  QCOMPARE(patient.mr.modality, Modality::mr);
  QVERIFY(patient.truth.voxels.grid().same_as(patient.mr.grid));
  const double liver = inside(patient, structure::kParenchyma).mean,
               cava = inside(patient, structure::kVenaCava).mean,
               lesion = inside(patient, structure::kFirstLesion).mean,
               bladder = inside(patient, structure::kGallbladder).mean;
  QVERIFY(cava > 1.05 * liver);
  QVERIFY(lesion < 0.9 * liver);
  QVERIFY(bladder < 0.6 * lesion);
}

void MrPatientTest::WithoutContrastAndOnT2BloodIsDark() {
  for (const auto sequence : {MrOptions::Sequence::t1_unenhanced, MrOptions::Sequence::t2}) {
    MrOptions options;
    options.coil_variation = 0.0;
    options.sequence = sequence;
    const MrPatient patient = coarse(options);
    QVERIFY(inside(patient, structure::kVenaCava).mean < 0.8 * inside(patient, structure::kParenchyma).mean);
  }
}

void MrPatientTest::NoiseAndCoilsAreAsAskedFor() {
  const Spread quiet = inside(even_, structure::kParenchyma);
  // The parenchyma's own mottle adds to the noise.
  QVERIFY(quiet.deviation > quiet.mean / 25.0 && quiet.deviation < 1.6 * quiet.mean / 25.0);
  const Spread uneven = inside(uneven_, structure::kParenchyma);
  QVERIFY(uneven.deviation / uneven.mean > 1.2 * quiet.deviation / quiet.mean);
  MrOptions noisy;
  noisy.coil_variation = 0.0;
  noisy.liver_snr = 8.0;
  QVERIFY(inside(coarse(noisy), structure::kParenchyma).deviation > 2.0 * quiet.deviation);
}

void MrPatientTest::ItsTruthIsThatOfTheSamePatientsCt() {
  MrOptions options;
  options.spacing_mm = {4.0, 4.0, 4.0};
  insilico::PatientOptions of_ct;
  of_ct.shape_seed = options.shape_seed;
  of_ct.spacing_mm = options.spacing_mm;
  of_ct.surface_spacing_mm = 4.0;
  const LabelVolume mr = insilico::make_mr_patient(options, RunContext()).value().truth.voxels;
  const LabelVolume ct = insilico::make_patient(of_ct, RunContext()).value().truth.voxels;
  QVERIFY(mr.grid().same_as(ct.grid()));
  QVERIFY(mr.dense() == ct.dense());
}

void MrPatientTest::TheSameOptionsGiveTheSameBits() {
  const MrPatient again = coarse({});
  QVERIFY(*uneven_.mr.voxels == *again.mr.voxels);
  QVERIFY(uneven_.truth.voxels == again.truth.voxels);
  MrOptions other;
  other.shape_seed = 2;
  QVERIFY(*uneven_.mr.voxels != *coarse(other).mr.voxels);
}

void MrPatientTest::BadOptionsAreRefused() {
  MrOptions options;
  options.liver_snr = 0.0;
  QVERIFY_THROWS_EXCEPTION(InputError, insilico::make_mr_patient(options, RunContext()));
  options = {};
  options.coil_variation = 1.5;
  QVERIFY_THROWS_EXCEPTION(InputError, insilico::make_mr_patient(options, RunContext()));
  options = {};
  options.spacing_mm.z() = 0.1;
  QVERIFY_THROWS_EXCEPTION(InputError, insilico::make_mr_patient(options, RunContext()));
}

QTEST_APPLESS_MAIN(MrPatientTest)
#include "mr_patient_test.moc"
