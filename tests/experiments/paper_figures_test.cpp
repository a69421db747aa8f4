// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Figs. 5 and 6: known shifts have known distances, nothing altered is nothing off.
#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/experiments/sensitivity.h"
#include "glisson/experiments/transfer_study.h"
#include "glisson/geometry/distance.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::experiments;

namespace {

/// The liver-like body with a notch in its margin and a vena cava behind.
PatientModel patient() {
  PatientModel model;
  model.mesh = phantom::tetrahedra(8, 6, 3);
  model.surface = boundary_surface(model.mesh);
  model.landmarks.umbilical_notch = phantom::shape(0.15, -1.0, -1.0).transpose();
  model.landmarks.vena_cava.resize(3, 3);
  for (int i = 0; i < 3; ++i)
    model.landmarks.vena_cava.row(i) = phantom::shape(0.1 * i - 0.1, 0.9, 0.5 * i - 0.5).transpose();
  return model;
}

const ShiftRow& row(const Sensitivity& found, Support support, double shift) {
  for (const ShiftRow& one : found.shifts)
    if (one.support == support && one.shift == shift) return one;
  throw PreconditionError("no such row");
}

}  // namespace

class PaperFiguresTest : public QObject {
  Q_OBJECT
 private slots:
  void setsThatWereShiftedAreAsFarAsTheyWereShifted() {
    Points a(3, 3);
    a << 0, 0, 0, 1, 0, 0, 2, 0, 0;
    const Points aside = a.rowwise() + Eigen::RowVector3d(0.0, 0.3, 0.0);
    QVERIFY(std::abs(set_distance(a, aside).mean - 0.3) < 1e-12);
    QVERIFY(std::abs(set_distance(a, aside).largest - 0.3) < 1e-12);
    // One way all are close, the other way one is far.
    const SetDistance part = set_distance(a, a.topRows(2));
    QVERIFY(std::abs(part.mean - 0.5 * (1.0 / 3.0)) < 1e-12 && std::abs(part.largest - 1.0) < 1e-12);
    QVERIFY(std::isinf(set_distance(a, Points(0, 3)).mean));
  }

  void aShapeIsNotFarFromItselfAndARigidShiftIsSeen() {
    const PatientModel model = patient();
    const Points& rest = model.mesh.vertices;
    QCOMPARE(shape_distance(model, rest, rest).surface, 0.0);
    const Points away = rest.rowwise() + Eigen::RowVector3d(1.0, 0.0, 0.0);
    const ShapeDistance far = shape_distance(model, rest, away);
    QVERIFY(std::abs(far.nodes - 1.0) < 1e-12);
    // 21 cm wide: the closest points of a body a metre away are nearer than the same points.
    QVERIFY2(far.surface > 0.8 && far.surface < 1.0, qPrintable(QString::number(far.surface)));
  }

  void moreShiftIsMoreErrorAndNoneIsNone() {
    SensitivityOptions options;
    options.shifts = {0.0, 2e-3, 12e-3};
    options.directions = 3;
    options.factors = {0.1, 1.0};
    const auto found = boundary_sensitivity(patient(), options, {});
    QVERIFY(found.has_value());
    QVERIFY(found->motion_mean > 1e-3);
    for (const Support support : kSupports) {
      QVERIFY(row(*found, support, 0.0).mean.surface < 1e-9);
      const ShiftRow &near = row(*found, support, 2e-3), &far = row(*found, support, 12e-3);
      QCOMPARE(far.tried, 3);
      QVERIFY(near.solved > 0 && far.solved > 0);
      QVERIFY(near.mean.surface > 1e-6 && far.mean.surface > 2.0 * near.mean.surface);
      QVERIFY(far.least <= far.mean.surface && far.mean.surface <= far.most);
      QVERIFY(found->exponents[static_cast<std::size_t>(support)] > 0.3);
    }
    for (const StiffnessRow& one : found->stiffness)
      QVERIFY(one.factor == 1.0 ? one.distance.surface < 1e-9 : one.distance.surface > 1e-6);
    const PaperFigure figure = figure_of(*found);
    QCOMPARE(figure.figures.at("figure6_both_stiffness_1_mm") < 1e-6, true);
    QVERIFY(figure.figures.count("figure6_cava_exponent") == 1);
    QCOMPARE(figure.table.rows.size(), found->shifts.size() + found->stiffness.size());
    plotsShowEveryRow(*found, figure);
  }

  void whatCannotBeIsRefused() {
    PatientModel model = patient();
    SensitivityOptions options;
    options.directions = 0;
    QVERIFY_THROWS_EXCEPTION(InputError, boundary_sensitivity(model, options, {}));
    model.landmarks.vena_cava.resize(0, 3);
    QVERIFY_THROWS_EXCEPTION(InputError, boundary_sensitivity(model, {}, {}));
    QVERIFY_THROWS_EXCEPTION(InputError, study_transfer({}, {}));
  }

  void cancelledIsEmpty() {
    auto cancel = std::make_shared<CancelFlag>();
    cancel->request();
    QVERIFY(!boundary_sensitivity(patient(), {}, RunContext({}, cancel, 1)).has_value());
  }

  /// A real liver's notch stays unknown, whatever is foretold of it.
  void figureFiveCountsWhatIsKnown() {
    atlas::LeftOut left;
    left.name = "0002";
    left.mean_distance = 0.001;
    left.max_distance = 0.004;
    left.structures[atlas::Structure::umbilical_notch].mean_error = 0.012;
    left.structures[atlas::Structure::vena_cava].area_distance = 0.003;
    left.structures[atlas::Structure::vena_cava].area_largest = 0.009;
    TransferStudy study;
    study.rows = {row_of(left, false, false), row_of(left, true, false)};
    QVERIFY(std::isnan(study.rows[1].notch));
    const PaperFigure figure = figure_of(study);
    QCOMPARE(figure.table.rows[1][5], std::string("-"));
    QCOMPARE(figure.table.rows[0][5], std::string("12.00"));
    QVERIFY(figure.figures.count("figure5_real_notch_mean_mm") == 0);
    QVERIFY(std::abs(figure.figures.at("figure5_real_cava_largest_worst_mm") - 9.0) < 1e-9);
    bool counted = false;
    for (const auto& line : figure.paper.rows)
      if (line[0] == "notch: livers of 10 mm and more") counted = line[2] == "1 of 1";
    QVERIFY(counted);
  }

  /// Neither the reference itself nor what found no equilibrium is an error of nothing.
  void figureSixSaysNothingOfWhatWasNotTried() {
    const double unknown = std::nan("");
    Sensitivity found;
    found.shifts = {{Support::both, 0.0, {0.0, 0.0}, 0.0, 0.0, 1, 1},
                    {Support::both, 3e-3, {unknown, unknown}, unknown, unknown, 0, 6}};
    found.stiffness = {{Support::both, 1.0, {0.0, 0.0}}, {Support::both, 2.0, {unknown, unknown}}};
    found.exponents.fill(unknown);
    const PaperFigure figure = figure_of(found);
    for (std::size_t line = 0; line < 5; ++line)
      if (line != 1) QCOMPARE(figure.paper.rows[line][2], std::string("-"));
    QVERIFY(!figure.figures.contains("figure6_shift_upto_3mm_mm"));
    QCOMPARE(figure.figures.at("figure6_without_equilibrium"), 7.0);
  }

  void whatIsNotKnownHasNoBar() {
    TransferStudy study;
    study.rows = {{"synthetic_7", false, true, 0.001, 0.002, 0.003, 0.004, 0.005},
                  {"0002", true, false, 0.001, 0.002, std::nan(""), 0.004, 0.005}};
    const FigurePlot plot = figure_of(study).plots.at(0);
    QCOMPARE(plot.categories, (std::vector<std::string>{"s 7 *", "0002"}));
    QCOMPARE(plot.series.at(1).values.at(0).second, 3.0);
    QCOMPARE(plot.series.at(1).values.at(1), (std::pair<double, double>{1.0, -1.0}));
    QCOMPARE(plot.series.at(2).values.at(1).second, 4.0);
  }

  void tablesKeepTheirColumnsAndQuoteCommas() {
    const Table table{{"a", "b"}, {{"x, y", "10"}, {"z", "2"}}};
    QCOMPARE(csv_of(table), std::string("a,b\n\"x, y\",10\nz,2\n"));
    QCOMPARE(lines_of(table), (std::vector<std::string>{"a      b", "x, y  10", "z      2"}));
  }

 private:
  static void plotsShowEveryRow(const Sensitivity& found, const PaperFigure& figure) {
    QCOMPARE(figure.plots.size(), std::size_t{2});
    const FigurePlot &places = figure.plots[0], &stiffness = figure.plots[1];
    QCOMPARE(stiffness.categories, (std::vector<std::string>{"× 0.1", "× 1"}));
    QVERIFY(places.categories.empty());
    for (const FigurePlot* plot : {&places, &stiffness}) QCOMPARE(plot->series.size(), kSupports.size());
    for (std::size_t i = 0; i < kSupports.size(); ++i) {
      const auto& [x, y] = places.series[i].values.at(2);
      const ShiftRow& far = row(found, kSupports[i], 12e-3);
      QCOMPARE(x, 12.0);
      QCOMPARE(y, 1e3 * far.mean.surface);
      QCOMPARE(places.series[i].low.at(2), 1e3 * far.least);
      QCOMPARE(places.series[i].high.at(2), 1e3 * far.most);
      QCOMPARE(stiffness.series[i].values.at(1).first, 1.0);
    }
  }
};

QTEST_GUILESS_MAIN(PaperFiguresTest)
#include "paper_figures_test.moc"
