// SPDX-License-Identifier: GPL-3.0-or-later
#include "seen_shares.h"

#include <QTest>
#include <functional>
#include <random>

using namespace glisson;
using guidance::SeenShares;

namespace {

constexpr int kTriangles = 60;

/// Ten rays on each of these triangles, and whether stereo sees the organ there.
struct Look {
  std::vector<ClosestPoint> hits;
  std::vector<char> seen;
};
Look look(int first, int last, const std::function<double(int)>& share, unsigned seed) {
  Look made;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int t = first; t < last; ++t)
    for (int n = 0; n < 10; ++n) {
      ClosestPoint hit;
      hit.triangle = t;
      made.hits.push_back(hit);
      made.seen.push_back(any(random) < share(t) ? 1 : 0);
    }
  made.hits.emplace_back();  // beside the organ
  made.seen.push_back(1);
  return made;
}
SeenShares learnt(const Look& first) {
  SeenShares shares(kTriangles);
  shares.learn(first.hits, first.seen);
  return shares;
}
/// Half of the organ has texture.
double usual(int triangle) { return triangle % 2 == 0 ? 0.8 : 0.05; }

}  // namespace

class SeenSharesTest : public QObject {
  Q_OBJECT
 private slots:
  void NothingIsMissingOfWhatWasNeverSeen();
  void PlainTissueIsNoCover();
  void WhatIsHiddenIsMissing();
  void WhatComesIntoSightIsNotMissing();
  void WhatIsLearntOnceStays();
};

void SeenSharesTest::NothingIsMissingOfWhatWasNeverSeen() {
  const SeenShares shares(kTriangles);
  const Look none = look(
      0, kTriangles, [](int) { return 0.0; }, 1);
  QCOMPARE(shares.missing(none.hits, none.seen), 0.0);
}

void SeenSharesTest::PlainTissueIsNoCover() {
  const SeenShares shares = learnt(look(0, kTriangles, usual, 1));
  const Look next = look(0, kTriangles, usual, 2);
  QVERIFY(shares.missing(next.hits, next.seen) < 0.15);
  // The scope looks at the plain half alone: far less is seen, and nothing is hidden.
  Look plain;
  for (std::size_t i = 0; i + 1 < next.hits.size(); ++i)
    if (next.hits[i].triangle % 2 == 1 || next.hits[i].triangle < 12) {
      plain.hits.push_back(next.hits[i]);
      plain.seen.push_back(next.seen[i]);
    }
  QVERIFY(shares.missing(plain.hits, plain.seen) < 0.25);
}

void SeenSharesTest::WhatIsHiddenIsMissing() {
  const SeenShares shares = learnt(look(0, kTriangles, usual, 1));
  const Look hidden = look(
      0, kTriangles, [](int t) { return t < kTriangles / 2 ? 0.0 : usual(t); }, 2);
  const double missing = shares.missing(hidden.hits, hidden.seen);
  QVERIFY2(std::abs(missing - 0.5) < 0.12, qPrintable(QString::number(missing)));
}

void SeenSharesTest::WhatComesIntoSightIsNotMissing() {
  const SeenShares shares = learnt(look(0, kTriangles / 2, usual, 1));
  const Look all = look(
      0, kTriangles, [](int t) { return t < kTriangles / 2 ? usual(t) : 0.0; }, 2);
  QVERIFY(shares.missing(all.hits, all.seen) < 0.15);
}

void SeenSharesTest::WhatIsLearntOnceStays() {
  SeenShares shares = learnt(look(0, kTriangles, usual, 1));
  const Look smoke = look(
      0, kTriangles, [](int t) { return 0.3 * usual(t); }, 2);
  for (int n = 0; n < 20; ++n) shares.learn(smoke.hits, smoke.seen);
  QVERIFY(shares.missing(smoke.hits, smoke.seen) > 0.5);
}

QTEST_APPLESS_MAIN(SeenSharesTest)
#include "seen_shares_test.moc"
