// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "glisson/core/json_file.h"

/// @file
/// A figure of the paper (Plantefève et al. 2016, section 3.1) measured again, as it is written down.

namespace glisson::experiments {

/// Words and numbers as they are shown. English: files and pages are.
struct Table {
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the heads
};

/// A line or a row of bars in a plot.
struct FigureSeries {
  std::string name;  ///< for people, English; marked for translation where the plot is made
  /// Of a line: x and y in the axes' units; of bars: the category's number and y. A y below 0: not known.
  std::vector<std::pair<double, double>> values;
  std::vector<double> low, high;  ///< of each value's spread, in y's unit; or empty
};

/// What a figure's picture shows. Whoever draws it translates the words, but not the categories, which are
/// names and numbers.
struct FigurePlot {
  std::string title, x, y;              ///< axes with units; marked for translation likewise
  std::vector<std::string> categories;  ///< of bars, if there are any
  std::vector<FigureSeries> series;
};

/// Millimetres of metres; below 0 (nothing is drawn) where it is not a number.
double drawn_millimetres(double metres);

/// One of the paper's figures, measured again: ours beside the paper's.
struct PaperFigure {
  int number = 0;  ///< in the paper
  std::string title, introduction;
  std::string command;              ///< by which it is measured again
  Table table;                      ///< what was measured
  Table paper;                      ///< what, the paper's words or values, ours
  std::vector<std::string> absent;  ///< data that were not there
  Figures figures;                  ///< the same as flat keys, with units in them
  std::vector<FigurePlot> plots;    ///< its picture, from left to right
};

/// Millimetres of metres, two decimals; "-" where it is not a number.
std::string in_millimetres(double metres);

/// Lines of even columns: words to the left, the others to the right.
std::vector<std::string> lines_of(const Table& table);
/// A table in Markdown, and as comma-separated values (a cell with a comma is quoted).
std::string markdown_of(const Table& table);
std::string csv_of(const Table& table);

/// figure_N.md, which shows figure_N.png, and figure_N.csv. No dates: the same figures give the same files.
/// Atomic. @throws FileError
void write_figure(const std::filesystem::path& folder, const PaperFigure& figure);

}  // namespace glisson::experiments
