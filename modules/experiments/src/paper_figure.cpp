// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/paper_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glisson/core/files.h"

namespace glisson::experiments {
namespace {

/// Letters as a terminal counts them, not bytes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char letter : cell) text += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return text + "\"";
}

std::string joined(const std::vector<std::string>& cells, const char* between, bool quotes) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += (i > 0 ? between : "") + (quotes ? quoted(cells[i]) : cells[i]);
  return line;
}

std::string rule(std::size_t columns) {
  std::string line = "|";
  for (std::size_t i = 0; i < columns; ++i) line += "---|";
  return line + "\n";
}

}  // namespace

std::string in_millimetres(double metres) {
  if (!std::isfinite(metres)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", 1e3 * metres);
  return text;
}

double drawn_millimetres(double metres) { return std::isfinite(metres) ? 1e3 * metres : -1.0; }

std::vector<std::string> lines_of(const Table& table) {
  std::vector<std::vector<std::string>> rows = {table.heads};
  rows.insert(rows.end(), table.rows.begin(), table.rows.end());
  std::vector<std::size_t> widths(table.heads.size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  std::vector<std::string> lines;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string room(widths[i] - width_of(row[i]), ' ');
      line += (i == 0 ? row[i] + room : "  " + room + row[i]);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string markdown_of(const Table& table) {
  std::string text = "| " + joined(table.heads, " | ", false) + " |\n" + rule(table.heads.size());
  for (const auto& row : table.rows) text += "| " + joined(row, " | ", false) + " |\n";
  return text;
}

std::string csv_of(const Table& table) {
  std::string text = joined(table.heads, ",", true) + "\n";
  for (const auto& row : table.rows) text += joined(row, ",", true) + "\n";
  return text;
}

void write_figure(const std::filesystem::path& folder, const PaperFigure& figure) {
  const std::string name = "figure_" + std::to_string(figure.number);
  std::string page = "# " + figure.title + "\n\nWritten by `" + figure.command + "`; not to be edited.\n\n" +
                     figure.introduction + "\n\n![" + figure.title + "](" + name +
                     ".png)\n\n## Beside the paper\n\n" + markdown_of(figure.paper) + "\n## Measured\n\n" +
                     markdown_of(figure.table);
  if (!figure.absent.empty())
    page += "\nNot there and left out: " + joined(figure.absent, ", ", false) + ".\n";
  write_file_atomically(folder / (name + ".md"), page);
  write_file_atomically(folder / (name + ".csv"), csv_of(figure.table));
}

}  // namespace glisson::experiments
