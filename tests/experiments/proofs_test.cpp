// SPDX-License-Identifier: GPL-3.0-or-later
// What a proof's page says, and where it goes.
#include "glisson/experiments/proofs.h"

#include <QTest>
#include <set>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

using namespace glisson;
using namespace glisson::experiments;
namespace fs = std::filesystem;

namespace {

ProofPage page_with(const Figures& figures) {
  ProofPage page;
  page.aims = {{"dice", "Dice of a ball", Evidence::in_silico, Aim::Sense::at_least, 0.9, 3}};
  page.figures = figures;
  return page;
}

}  // namespace

class ProofsTest : public QObject {
  Q_OBJECT
 private slots:
  void EachProofHasItsNameItsPageAndItsAims();
  void ThePageSaysHowItIsMeasuredAgain();
  void ThePageSaysOnWhomLimitsWereSet();
  void ThePageHasTheTableWithoutTimes();
  void APageWithGapsTakesNoPlaceUnasked();
  void AMissingAtlasIsRefused();
};

void ProofsTest::EachProofHasItsNameItsPageAndItsAims() {
  std::set<std::string> names;
  for (const Proof& proof : proofs()) {
    QVERIFY2(names.insert(proof.name).second, proof.name);
    QCOMPARE(proof_named(proof.name), &proof);
    QVERIFY2(std::string(proof.title).size() > 10 && std::string(proof.introduction).size() > 50, proof.name);
    QVERIFY2(!proof.aims().empty(), proof.name);
  }
  QCOMPARE(names.size(), std::size_t{6});
  QVERIFY(proof_named("ball") == nullptr && proof_named("") == nullptr);
}

void ProofsTest::ThePageSaysHowItIsMeasuredAgain() {
  const Proof& proof = *proof_named("registration");
  ProofChoices choices;
  choices.former = "cut_short";  // says nothing of what is measured
  QCOMPARE(page_of(proof, choices, {}).command, std::string("glisson prove registration --seed 1"));
  choices.real_only = choices.development_only = choices.quick = choices.looks = true;
  choices.long_films = true;
  choices.seed = 7;
  QCOMPARE(page_of(proof, choices, {}).command,
           std::string(
               "glisson prove registration --real-only --development-only --quick --looks --long --seed 7"));
}

void ProofsTest::ThePageSaysOnWhomLimitsWereSet() {
  const auto introduction = [](const char* proof, std::uint64_t seed) {
    ProofChoices choices;
    choices.seed = seed;
    return QString::fromStdString(page_of(*proof_named(proof), choices, {}).introduction);
  };
  QVERIFY(introduction("live", 1).contains("of seed 15, 16 (in silico) did not serve to set limits"));
  QVERIFY(introduction("live", 101).contains("of seed 101 (in silico) served development"));
  QVERIFY(introduction("patient", 1).contains("ill livers of another seed; ct_chaos3 is for validation ("));
  QVERIFY(introduction("patient", 2).contains("on these ill livers; ct_chaos3"));
  for (const char* proof : {"live", "patient", "stereo"})
    QVERIFY2(introduction(proof, 1).endsWith('.') && !introduction(proof, 1).contains("  "), proof);
}

void ProofsTest::ThePageHasTheTableWithoutTimes() {
  Proven found;
  found.table = {"liver  dice  seconds"};
  found.page_table = {"liver  dice"};
  found.absent = {"ct_x"};
  const Proof& proof = *proof_named("patient");
  const ProofPage page = page_of(proof, {}, found);
  QCOMPARE(page.table, found.page_table);
  QCOMPARE(page.absent, found.absent);
  QCOMPARE(page.title, std::string(proof.title));
  QCOMPARE(page.aims.size(), proof.aims().size());
}

void ProofsTest::APageWithGapsTakesNoPlaceUnasked() {
  const fs::path checkout(qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString());
  const TemporaryFolder elsewhere;
  const ProofPage whole = page_with({{"dice", 0.8}}), gap = page_with({});
  QCOMPARE(folder_for(whole, {}, checkout), checkout / "packaging/figures");  // missed, but measured
  QVERIFY(folder_for(gap, {}, checkout).empty());
  ProofPage missed_with_gap = page_with({{"dice", 0.8}});
  missed_with_gap.aims.push_back(
      {"volume", "Volume of a ball", Evidence::in_silico, Aim::Sense::at_most, 1.0, 1});
  QVERIFY(folder_for(missed_with_gap, {}, checkout).empty());
  QVERIFY(folder_for(whole, {}, elsewhere.path()).empty());
  QCOMPARE(folder_for(gap, fs::path("wanted"), checkout), fs::path("wanted"));
}

void ProofsTest::AMissingAtlasIsRefused() {
  QVERIFY_THROWS_EXCEPTION(InputError, proof_named("atlas")->run({}, {}, RunContext()));
}

QTEST_APPLESS_MAIN(ProofsTest)
#include "proofs_test.moc"
