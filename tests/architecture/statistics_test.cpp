// SPDX-License-Identifier: GPL-3.0-or-later
// Medians and percentiles stand once, in core/statistics.h: nobody sorts up to a place of his own, names a
// private median or writes the deviation over the MAD as a number.
#include <QTest>

#include "house.h"

using namespace glisson::house;
namespace fs = std::filesystem;

namespace {

/// Sources that part a list themselves, and why.
const std::map<std::string, std::string>& of_their_own() {
  static const std::map<std::string, std::string> kReasons = {
      {"statistics.h", "stands here"},
      {"closest_point_tree.cpp", "parts the points between two boxes: no value is asked for"},
      {"joint_smoothing.cpp", "a count of voxels, not a share, on either side of a threshold"},
      {"scalar_field.cpp", "two neighbours among millions of voxels, parted once"},
      {"star.cpp", "five numbers in an array, in the inmost loop"},
  };
  return kReasons;
}

/// What a source does of that, one word each.
std::vector<std::string> faults_in(const std::string& code) {
  static const std::regex kFault(
      "\\bnth_element\\b|\\b1\\.4826\\b|\\b(?:double|float|int|long) "
      "(?:[a-z_]*_)?(?:median|percentile|quantile)(?:_of)?\\(");
  std::vector<std::string> faults;
  for (auto match = std::sregex_iterator(code.begin(), code.end(), kFault); match != std::sregex_iterator();
       ++match)
    faults.push_back(match->str());
  return faults;
}

std::vector<std::string> faults_of(const fs::path& source) {
  std::ifstream stream(source);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  // Most sources have none of it and need not be taken apart.
  for (const char* word : {"nth_element", "1.4826", "median", "percentile", "quantile"})
    if (text.find(word) != std::string::npos) return faults_in(code_of(source));
  return {};
}

bool is_core(const std::string& room) { return room == "core"; }

/// Every room's, and those of the tests and benchmarks.
std::map<std::string, std::vector<fs::path>> all_sources() {
  auto sources = rooms_on_disk();
  sources["tests"] = sources_below(source_root() / "tests");
  return sources;
}

}  // namespace

class StatisticsTest : public QObject {
  Q_OBJECT
 private slots:
  void StatisticsStandOnce();
  void EveryExceptionIsNeeded();
  void FaultsAreSeen();
};

void StatisticsTest::StatisticsStandOnce() {
  std::string offences;
  for (const auto& [room, sources] : all_sources())
    for (const fs::path& source : sources) {
      const std::string name = source.filename().string();
      if (is_core(room) || of_their_own().contains(name)) continue;
      for (const std::string& fault : faults_of(source)) offences += room + "/" + name + ": " + fault + "\n";
    }
  QVERIFY2(offences.empty(), ("use core/statistics.h:\n" + offences).c_str());
}

void StatisticsTest::EveryExceptionIsNeeded() {
  std::set<std::string> unused;
  for (const auto& [name, why] : of_their_own()) unused.insert(name);
  for (const auto& [room, sources] : all_sources())
    for (const fs::path& source : sources)
      if (!faults_of(source).empty()) unused.erase(source.filename().string());
  QVERIFY2(unused.empty(), unused.empty() ? "" : unused.begin()->c_str());
}

void StatisticsTest::FaultsAreSeen() {
  const auto found = faults_in(
      "double median(std::vector<double>& v) { std::ranges::nth_element(v, m); return 1.4826 * *m; }\n"
      "float lower_quantile(V v); const double median = upper_median(v); double x = at_rank(v, 2);\n");
  QVERIFY((found ==
           std::vector<std::string>{"double median(", "nth_element", "1.4826", "float lower_quantile("}));
}

QTEST_APPLESS_MAIN(StatisticsTest)
#include "statistics_test.moc"
