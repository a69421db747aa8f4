// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/aims.h"

#include <QTest>
#include <cmath>
#include <set>

#include "exit_code.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "patient_proof.h"
#include "patient_proof_trials.h"
#include "stereo_proof.h"

using namespace glisson;
using namespace glisson::experiments;
namespace fs = std::filesystem;

namespace {

const std::vector<Aim>& tiny_aims() {
  static const std::vector<Aim> kAims = {
      {"dice", "Dice of a ball", Evidence::in_silico, Aim::Sense::at_least, 0.9, 3},
      {"error_mm", "its distance, mm", Evidence::real, Aim::Sense::at_most, 0.5, 2}};
  return kAims;
}

ProofPage page_with(const Figures& figures, const std::vector<std::string>& absent = {}) {
  ProofPage page;
  page.title = "A ball";
  page.introduction = "Measured on a ball.";
  page.command = "glisson prove ball --seed 1";
  page.aims = tiny_aims();
  page.figures = figures;
  page.absent = absent;
  page.table = {"trial  points", "near      100"};
  return page;
}

/// What the program leaves with.
int left_with(const Figures& figures, const std::vector<std::string>& absent = {}) {
  return app::exit_code(verdict(page_with(figures, absent)));
}

std::string page_of(const Figures& figures, const std::vector<std::string>& absent = {}) {
  const TemporaryFolder folder;
  write_page(folder.path() / "ball.md", page_with(figures, absent));
  return read_file(folder.path() / "ball.md");
}

}  // namespace

class AimsTest : public QObject {
  Q_OBJECT
 private slots:
  void BoundsAreMetThemselves();
  void OneMissedAimFailsTheProof();
  void WhatWasNotMeasuredIsNotMet();
  void WhatWasAbsentIsNotMet();
  void ThePageSaysFigureAimAndVerdict();
  void ThePageHoldsNoTimes();
  void ThePageHoldsTimesThatAreAims();
  void ThePageNamesWhatWasAbsent();
  void ClicksInSilicoDependOnNoCt();
  void UnusedCtsAreNamed();
  void AFolderThatCannotBeWrittenIsRefused();
  void OnlyACheckoutHasAPlaceForFigures();
  void EveryAimIsNamedOnce();
};

void AimsTest::BoundsAreMetThemselves() {
  QVERIFY(verdict(tiny_aims()[0], {{"dice", 0.9}}) == Verdict::met);
  QVERIFY(verdict(tiny_aims()[0], {{"dice", 0.899}}) == Verdict::missed);
  QVERIFY(verdict(tiny_aims()[1], {{"error_mm", 0.5}}) == Verdict::met);
  QVERIFY(verdict(tiny_aims()[1], {{"error_mm", 0.501}}) == Verdict::missed);
}

void AimsTest::OneMissedAimFailsTheProof() {
  QCOMPARE(left_with({{"dice", 0.95}, {"error_mm", 0.2}}), 0);
  QCOMPARE(left_with({{"dice", 0.95}, {"error_mm", 0.9}}), 1);
  QCOMPARE(left_with({{"error_mm", 0.9}}), 1);
}

void AimsTest::WhatWasNotMeasuredIsNotMet() {
  QCOMPARE(left_with({{"dice", 0.95}}), 3);
  QCOMPARE(left_with({}), 3);
  QCOMPARE(left_with({{"dice", 0.95}, {"error_mm", std::nan("")}}), 3);
}

void AimsTest::WhatWasAbsentIsNotMet() {
  QCOMPARE(left_with({{"dice", 0.95}, {"error_mm", 0.2}}, {"fault another_patient"}), 3);
  QCOMPARE(left_with({{"dice", 0.95}, {"error_mm", 0.9}}, {"fault another_patient"}), 1);
}

void AimsTest::ThePageSaysFigureAimAndVerdict() {
  const std::string text =
      page_of({{"dice", 0.95}, {"error_mm", 0.9}, {"nodes", 12345.0}, {"share", 0.123456}});
  for (const char* line : {"# A ball\n", "`glisson prove ball --seed 1`", "Measured on a ball.",
                           "1 of 2 aims met, 1 not met, 0 not measured.",
                           "| Dice of a ball | in silico | 0.950 | ≥ 0.900 | met |\n",
                           "| its distance, mm | real | 0.90 | ≤ 0.50 | **not met** |\n",
                           "    near      100\n", "| `nodes` | 12345 |\n", "| `share` | 0.1235 |\n"})
    QVERIFY2(text.find(line) != std::string::npos, (std::string(line) + "\nin\n" + text).c_str());
}

void AimsTest::ThePageHoldsNoTimes() {
  const Figures once = {{"dice", 0.95}, {"seconds", 3.0}, {"seconds_segment", 2.0}, {"frame_p50_ms", 9.0}};
  QCOMPARE(page_of(once), page_of({{"dice", 0.95}, {"seconds", 4.0}}));
}

void AimsTest::ThePageHoldsTimesThatAreAims() {
  ProofPage page;
  page.aims = patient_aims();
  page.figures = {{"trial_seconds_longest", 16.25}, {"trial_correction_seconds_longest", 1.5}};
  const TemporaryFolder folder;
  write_page(folder.path() / "patient.md", page);
  const std::string text = read_file(folder.path() / "patient.md");
  QVERIFY(text.find(" | 16.2 | ≤ 15.0 | **not met** |") != std::string::npos);
  QVERIFY(text.find(" | 1.5 | ≤ 2.0 | met |") != std::string::npos);
}

void AimsTest::ClicksInSilicoDependOnNoCt() {
  // With both CTs of seed 1, and with the one of all others, they were these.
  QCOMPARE(clicks_on_pathology(1, 0), std::uint64_t{1003});
  QCOMPARE(clicks_on_pathology(1, 4), std::uint64_t{1007});
  QCOMPARE(clicks_on_pathology(2, 0), std::uint64_t{2002});
}

void AimsTest::UnusedCtsAreNamed() {
  const TemporaryFolder data;
  for (const char* name : {"ct_ircad1", "ct_chaos3", "ct_two", "ct_one", "stereo_heart"})
    fs::create_directory(data.path() / name);
  QCOMPARE(unused_cts(data.path(), 1), (std::vector<std::string>{"ct_one", "ct_two"}));
  QCOMPARE(unused_cts(data.path(), 2), (std::vector<std::string>{"ct_chaos3", "ct_one", "ct_two"}));
  QVERIFY(unused_cts(data.path() / "none", 1).empty());
  ProofPage page;
  page.aims = tiny_aims();
  page.unused = unused_cts(data.path(), 1);
  write_page(data.path() / "ball.md", page);
  QVERIFY(read_file(data.path() / "ball.md").find("2 not measured. Not used: `ct_one`, `ct_two`.") !=
          std::string::npos);
}

void AimsTest::ThePageNamesWhatWasAbsent() {
  const std::string text = page_of({{"dice", 0.95}}, {"ct_x", "stereo_y"});
  QVERIFY(text.find("1 not measured. Not there: `ct_x`, `stereo_y`.") != std::string::npos);
  QVERIFY(text.find("| its distance, mm | real |  | ≤ 0.50 | not measured |\n") != std::string::npos);
}

void AimsTest::AFolderThatCannotBeWrittenIsRefused() {
  QVERIFY_THROWS_EXCEPTION(FileError, write_page("no/such/folder/ball.md", ProofPage()));
}

void AimsTest::OnlyACheckoutHasAPlaceForFigures() {
  const fs::path root(qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString());
  QCOMPARE(figures_of_checkout(root), root / "packaging/figures");
  QVERIFY(figures_of_checkout(TemporaryFolder().path()).empty());
}

void AimsTest::EveryAimIsNamedOnce() {
  for (const auto* aims : {&patient_aims(), &stereo_aims()}) {
    QVERIFY(aims->size() > 10);
    std::set<std::pair<std::string, Aim::Sense>> seen;
    for (const Aim& aim : *aims) {
      QVERIFY2(seen.emplace(aim.key, aim.sense).second, aim.key.c_str());
      QVERIFY2(!aim.what.empty() && std::isfinite(aim.bound), aim.key.c_str());
    }
  }
}

QTEST_APPLESS_MAIN(AimsTest)
#include "aims_test.moc"
