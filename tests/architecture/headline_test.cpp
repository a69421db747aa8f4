// SPDX-License-Identifier: GPL-3.0-or-later
// The README begins with how far off a registration is: the one copy of figures outside of packaging/figures.
// Each of them is held against the page that the proof has written.
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <cmath>

namespace {

QString content_of(const char* name) {
  QFile file(qEnvironmentVariable("GLISSON_SOURCE_DIR") + QLatin1Char('/') + QLatin1String(name));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList cells_of(const QString& line) {
  QStringList cells = line.split(QLatin1Char('|')).mid(1);
  if (!cells.isEmpty()) cells.removeLast();
  for (QString& cell : cells) cell = cell.trimmed();
  return cells;
}

QString rounded(double value, int decimals = 1) { return QString::number(value, 'f', decimals); }

/// What packaging/figures/registration.md says of the validation patients.
class Page {
 public:
  Page() : text_(content_of("packaging/figures/registration.md")) {
    const qsizetype begin = text_.indexOf(QLatin1String("\n    validation\n"));
    trials_ = text_.mid(begin, text_.indexOf(QLatin1String("\n    development\n")) - begin);
  }
  bool is_there() const { return trials_.size() > 100; }

  /// Of the list at its end. NaN: it has none of that name.
  double figure(const QString& name) const {
    return number(QStringLiteral("\\| `registration_validation_%1` \\| ([0-9.]+) \\|").arg(name));
  }
  /// Of its table of aims, which names them: what was found, and what it should be.
  double found(const QString& what) const { return aim(what).first; }
  double bound(const QString& what) const { return aim(what).second; }
  /// Of all handlings at one share: trials, ours, the paper's, rigid, lesion, doubted.
  QStringList of_share(int percent) const { return row(QStringLiteral("all +%1").arg(percent), 6); }
  /// Of one kind of fault: trials, refused, doubted, over 10 mm, told, under 3 mm, doubted.
  QStringList of_fault(const QString& fault) const { return row(fault, 7); }

 private:
  double number(const QString& pattern) const {
    const auto match = QRegularExpression(pattern).match(text_);
    return match.hasMatch() ? match.captured(1).toDouble() : NAN;
  }
  std::pair<double, double> aim(const QString& what) const {
    for (const QString& line : text_.split(QLatin1Char('\n')))
      if (const QStringList cells = cells_of(line); cells.size() == 5 && cells[0] == what)
        return {cells[2].toDouble(), cells[3].mid(2).toDouble()};
    return {NAN, NAN};
  }
  /// The last line of so many numbers: those of faults come after those of shares.
  QStringList row(const QString& name, int count) const {
    const QRegularExpression pattern(
        QStringLiteral("\n +%1((?: +[0-9.-]+){%2})(?=\n|$)").arg(name).arg(count));
    QStringList cells;
    for (auto match = pattern.globalMatch(trials_); match.hasNext();)
      cells = match.next().captured(1).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return cells;
  }

  QString text_, trials_;
};

/// Of the README's table of registrations, by what its rows are called. The first row holds the heads.
QMap<QString, QStringList> headline() {
  QMap<QString, QStringList> rows;
  bool is_table = false;
  for (const QString& line : content_of("README.md").split(QLatin1Char('\n'))) {
    is_table = line.startsWith(QLatin1String("| of the surface seen ")) ||
               (is_table && line.startsWith(QLatin1Char('|')));
    if (!is_table) continue;
    const QStringList cells = cells_of(line);
    rows.insert(cells.front(), cells.mid(1));
  }
  return rows;
}

}  // namespace

class HeadlineTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    QVERIFY(page_.is_there());
    QCOMPARE(headline_.size(), qsizetype{7});  // with the heads and the line below them
  }
  void EachColumnIsThePages_data();
  void EachColumnIsThePages();
  void RefusedOnesAreAsManyAsThePageHas();
  void AimsAreThePages();
  void TheSentencesBelowAreThePages();

 private:
  const Page page_;
  const QMap<QString, QStringList> headline_ = headline();
};

void HeadlineTest::EachColumnIsThePages_data() {
  QTest::addColumn<int>("column");
  QTest::addColumn<int>("share");
  const QList<int> shares = {10, 20, 30, 50};
  for (int column = 0; column < shares.size(); ++column)
    QTest::addRow("%d %%", shares[column]) << column << shares[column];
}

void HeadlineTest::EachColumnIsThePages() {
  QFETCH(int, column);
  QFETCH(int, share);
  const auto cell = [&](const char* row) { return headline_.value(QLatin1String(row)).value(column); };
  QVERIFY(cell("of the surface seen").contains(QStringLiteral("%1 %").arg(share)));
  const auto figure = [&](const char* name) {
    return page_.figure(QString::number(share) + QLatin1Char('_') + QLatin1String(name));
  };
  const double mean = figure("mean_mm");
  QCOMPARE(cell("all"), rounded(mean));
  // The page does not tell them apart; together they are all.
  const double real = cell("three real livers' shapes").toDouble();
  const double smooth = cell("two smooth synthetic ones").toDouble();
  QVERIFY2(std::abs((3.0 * real + 2.0 * smooth) / 5.0 - mean) < 0.1, qPrintable(rounded(mean, 2)));
  const double paper = figure("paper_mean_mm");
  QCOMPARE(cell("best rigid alignment; the paper's method"),
           rounded(figure("rigid_mean_mm")) + QLatin1String("; ") +
               (std::isnan(paper) ? QStringLiteral("-") : rounded(paper)));
  const QStringList trials = page_.of_share(share);
  QCOMPARE(trials.size(), qsizetype{6});
  QCOMPARE(trials.front(), QStringLiteral("20"));
  QCOMPARE(cell("refused; refused or doubted, of 20").section(QLatin1String("; "), 1), trials.back());
}

void HeadlineTest::RefusedOnesAreAsManyAsThePageHas() {
  int refused = 0;
  for (const QString& cell : headline_.value(QStringLiteral("refused; refused or doubted, of 20")))
    refused += cell.section(QLatin1Char(';'), 0, 0).toInt();
  QCOMPARE(QString::number(refused), page_.of_fault(QStringLiteral("none")).value(1));
}

void HeadlineTest::AimsAreThePages() {
  const auto aim = [this](int share) {
    return QStringLiteral("%1 at %2 %")
        .arg(page_.bound(QStringLiteral("mean error, %1 % of the surface seen, mm").arg(share)))
        .arg(share);
  };
  QCOMPARE(headline_.value(QStringLiteral("three real livers' shapes")).value(4),
           aim(20) + QLatin1String(", ") + aim(30));
}

void HeadlineTest::TheSentencesBelowAreThePages() {
  const QString readme = content_of("README.md").simplified();
  const auto percent = [](double share) { return QString::number(100.0 * share); };
  const QStringList all = page_.of_fault(QStringLiteral("all")),
                    none = page_.of_fault(QStringLiteral("none"));
  QVERIFY(all.size() == 7 && none.size() == 7);
  const QString told = QStringLiteral("registrations over 10 mm at a lesion, refused or doubted, share"),
                near = QStringLiteral("registrations under 3 mm at all lesions, doubted, share"),
                within = QStringLiteral("lesions within their 95 % ellipsoid, share, at least"),
                outside = QStringLiteral("lesions outside of their 95 % ellipsoid, share");
  const QStringList sentences = {
      QStringLiteral("%1 of %2 were refused or doubted (%3 %; aim: %4)")
          .arg(all[4], all[3], percent(page_.found(told)), percent(page_.bound(told))),
      QStringLiteral("%1 % of the lesions lay in their 95 % ellipsoids (aim: %2 to %3)")
          .arg(rounded(100.0 * page_.found(within), 0), percent(page_.bound(within)),
               percent(1.0 - page_.bound(outside))),
      QStringLiteral("(%1 of %2; %3 of %4 that were under 3 mm at all lesions; aim: %5 %)")
          .arg(none[2], none[0], all[6], all[5], percent(page_.bound(near)))};
  for (const QString& sentence : sentences) QVERIFY2(readme.contains(sentence), qPrintable(sentence));
}

QTEST_APPLESS_MAIN(HeadlineTest)
#include "headline_test.moc"
