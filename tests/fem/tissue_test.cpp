// SPDX-License-Identifier: GPL-3.0-or-later
// What a person says of stiffness: read, written, checked, and put into materials.
#include "glisson/fem/tissue.h"

#include <QTest>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"

using namespace glisson;
using namespace glisson::fem;
using Kind = Stiffness::Kind;

class TissueTest : public QObject {
  Q_OBJECT
 private slots:
  void AListIsReadAndWrittenTheSame();
  void EveryNumberComesBackToTheBit();
  void OfAFormerModelsLesionsThoseThatAreGoneAreDropped();
  void SlipsAreNamed_data();
  void SlipsAreNamed();
  void LesionsGetWhatIsSaidOfThem();
  void NothingSaidLeavesTheMaterials();
  void NumbersThatAreNoLabelsAreNoLesion();
  void WhatIsSaidLaterHolds();
  void LesionsThatAreNotThereAreNamed();
};

namespace {

constexpr Label kFirst = structure::kFirstLesion, kSecond = structure::kFirstLesion + 1;

/// Two tetrahedra with a common face, of these labels.
PatientModel of_two(int a, int b) {
  PatientModel model;
  model.mesh.vertices.resize(5, 3);
  model.mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1;
  model.mesh.tetrahedra.resize(2, 4);
  model.mesh.tetrahedra << 0, 1, 2, 3, 1, 2, 3, 4;
  model.mesh.labels = {a, b};
  return model;
}

}  // namespace

void TissueTest::AListIsReadAndWrittenTheSame() {
  const Tissue tissue = tissue_from("parenchyma=cirrhotic,lesion_1=20.3,lesion_3=soft,lesions=12");
  QCOMPARE(*tissue.parenchyma, 30e3);
  QVERIFY(tissue.of(kFirst) == (Stiffness{Kind::given, 20300.0}));
  QVERIFY(tissue.of(kSecond) == (Stiffness{Kind::given, 12e3}));
  QVERIFY(tissue.of(kSecond + 1) == (Stiffness{Kind::soft, 0.0}));
  QVERIFY(tissue_from(tissue_list(tissue)) == tissue);
  QVERIFY(tissue_from("").empty());
  QVERIFY(tissue_from("lesions=as_liver").empty());
}

void TissueTest::EveryNumberComesBackToTheBit() {
  for (int tenths = 1; tenths <= 10000; ++tenths) {
    Tissue tissue;
    tissue.parenchyma = 1e3 * (tenths / 10.0);  // as the window's spin box gives it
    tissue.lesions[kFirst] = {Kind::given, 100.0 * tenths};
    const Tissue kept = rounded(tissue);
    QVERIFY2(tissue_from(tissue_list(kept)) == kept, tissue_list(kept).c_str());
    QVERIFY(std::abs(*kept.parenchyma - *tissue.parenchyma) < 1e-9);
  }
}

void TissueTest::OfAFormerModelsLesionsThoseThatAreGoneAreDropped() {
  PatientModel model = of_two(structure::kParenchyma, kFirst);
  model.surfaces.push_back({kFirst, structure_name(kFirst), boundary_surface(model.mesh).mesh});
  const Tissue former = tissue_from("parenchyma=20,lesion_1=30,lesion_2=stiff,lesions=12");
  QCOMPARE(lesions_not_there(former, model), std::vector<Label>{kSecond});
  QVERIFY(still_there(former, model) == tissue_from("parenchyma=20,lesion_1=30,lesions=12"));
  QVERIFY(still_there(former, of_two(1, 1)) == tissue_from("parenchyma=20"));
}

void TissueTest::SlipsAreNamed_data() {
  QTest::addColumn<QString>("list");
  QTest::addColumn<QString>("named");
  QTest::newRow("no value") << "lesion_1"
                            << "lesion_1";
  QTest::newRow("no such tissue") << "bone=20"
                                  << "bone";
  QTest::newRow("a vessel") << "portal_vein=20"
                            << "portal_vein";
  QTest::newRow("no number") << "lesion_1=hard"
                             << "hard";
  QTest::newRow("pascals") << "lesion_2=20000"
                           << "kPa";
  QTest::newRow("negative") << "lesions=-3"
                            << "lesions";
  QTest::newRow("with a unit") << "parenchyma=3kPa"
                               << "3kPa";
  QTest::newRow("twice") << "lesion_1=3,lesion_1=4"
                         << "twice";
  QTest::newRow("not a number") << "lesion_1=nan"
                                << "nan";
}

void TissueTest::SlipsAreNamed() {
  QFETCH(QString, list);
  QFETCH(QString, named);
  const std::string said = test::complaint([&] { (void)tissue_from(list.toStdString()); });
  QVERIFY2(said.find("stiffness") != std::string::npos && said.find(named.toStdString()) != std::string::npos,
           said.c_str());
}

void TissueTest::LesionsGetWhatIsSaidOfThem() {
  const PatientModel model = of_two(kFirst, kSecond);
  const CompositeOptions materials =
      with_tissue({}, tissue_from("parenchyma=7,lesion_1=stiff,lesion_2=2"), model.mesh);
  QCOMPARE(materials.parenchyma.young_modulus, 7e3);
  QCOMPARE(materials.by_label.at(kFirst).young_modulus, 35e3);
  QCOMPARE(materials.by_label.at(kSecond).young_modulus, 2e3);
  const std::vector<double> over = stiffness_over_parenchyma(model.mesh, materials);
  QCOMPARE(over.at(0), 5.0);
  QCOMPARE(over.at(1), 2.0 / 7.0);
}

void TissueTest::NothingSaidLeavesTheMaterials() {
  const PatientModel model = of_two(structure::kParenchyma, kFirst);
  QVERIFY(with_tissue({}, {}, model.mesh).by_label.empty());
  QVERIFY(with_tissue({}, tissue_from("lesion_1=as_liver"), model.mesh).by_label.empty());
  QCOMPARE(stiffness_over_parenchyma(model.mesh, {}), (std::vector<double>{1.0, 1.0}));
}

/// 65552 is 16 in sixteen bits.
void TissueTest::NumbersThatAreNoLabelsAreNoLesion() {
  const PatientModel model = of_two(65552, kFirst);
  const CompositeOptions materials = with_tissue({}, tissue_from("lesion_1=35"), model.mesh);
  QCOMPARE(stiffness_over_parenchyma(model.mesh, materials), (std::vector<double>{1.0, 10.0}));
  QVERIFY(with_tissue({}, tissue_from("lesion_1=35"), of_two(65552, 1).mesh).by_label.empty());
}

void TissueTest::WhatIsSaidLaterHolds() {
  const Tissue former = tissue_from("parenchyma=7,lesion_1=20,lesion_2=soft");
  QVERIFY(said_over(former, tissue_from("lesion_1=30")) ==
          tissue_from("parenchyma=7,lesion_1=30,lesion_2=soft"));
  QVERIFY(said_over(former, tissue_from("lesions=stiff")) == tissue_from("parenchyma=7,lesions=stiff"));
}

void TissueTest::LesionsThatAreNotThereAreNamed() {
  const PatientModel with = of_two(structure::kParenchyma, kFirst), without = of_two(1, 1);
  require_lesions_of(tissue_from("lesion_1=20,lesions=3"), with);
  const std::string said = test::complaint([&] { require_lesions_of(tissue_from("lesion_2=20"), with); });
  QVERIFY2(said.find("lesion_2") != std::string::npos && said.find("lesion_1") != std::string::npos,
           said.c_str());
  QVERIFY_THROWS_EXCEPTION(InputError, require_lesions_of(tissue_from("lesions=20"), without));
  QVERIFY(lesions_without_elements(tissue_from("lesion_1=20"), with).empty());
  PatientModel small = without;
  small.surfaces.push_back({kFirst, "lesion_1", boundary_surface(without.mesh).mesh});
  QCOMPARE(lesions_without_elements(tissue_from("lesion_1=20"), small), std::vector<Label>{kFirst});
  QVERIFY(lesions_without_elements(tissue_from("lesion_1=as_liver"), small).empty());
}

QTEST_APPLESS_MAIN(TissueTest)
#include "tissue_test.moc"
