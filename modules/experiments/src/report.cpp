// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "glisson/core/files.h"

namespace glisson::experiments {
namespace {

std::string escaped(const std::string& text) {
  std::string html;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += letter;
    }
  }
  return html;
}

std::string with_unit(const std::string& key, double value) {
  struct Ending {
    const char* ending;
    const char* unit;
    const char* format;
  };
  static constexpr std::array<Ending, 7> kEndings = {{{"_mm", "mm", "%.2f"},
                                                      {"_ms", "ms", "%.1f"},
                                                      {"_ml", "ml", "%.1f"},
                                                      {"_deg", "&deg;", "%.1f"},
                                                      {"_per_cm2", "/cm&sup2;", "%.2f"},
                                                      {"_pa", "Pa", "%.0f"},
                                                      {"_per_second", "/s", "%.1f"}}};
  std::array<char, 64> buffer{};
  if (!std::isfinite(value)) return "unknown";
  if (key.starts_with("seconds")) {
    std::snprintf(buffer.data(), buffer.size(), "%.1f s", value);
    return buffer.data();
  }
  if (key.ends_with("_share")) {
    std::snprintf(buffer.data(), buffer.size(), "%.1f %%", 100.0 * value);
    return buffer.data();
  }
  for (const Ending& one : kEndings) {
    if (!key.ends_with(one.ending)) continue;
    std::snprintf(buffer.data(), buffer.size(), one.format, value);
    return std::string(buffer.data()) + " " + one.unit;
  }
  std::snprintf(buffer.data(), buffer.size(), value == std::floor(value) ? "%.0f" : "%.3f", value);
  return buffer.data();
}

std::string row_of(const std::vector<std::string>& cells, const std::string& tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) row += "<" + tag + ">" + escaped(cell) + "</" + tag + ">";
  return row + "</tr>\n";
}

constexpr const char* kStyle = R"(
body { background: #14171c; color: #e6e9ee; font: 16px/1.5 "DejaVu Sans", sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2 { font-weight: 600; } h2 { margin-top: 2.5rem; border-bottom: 1px solid #39414d; padding-bottom: .3rem; }
table { border-collapse: collapse; min-width: 32rem; } td, th { padding: .35rem .8rem; border-bottom: 1px solid #2a313b; text-align: left; }
td.value { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
code { color: #9fb4cc; } figure { margin: 1.5rem 0; } img { max-width: 100%; border-radius: 4px; } figcaption, .remark { color: #aab4c2; }
.warning { border-left: 4px solid #e69f00; padding: .5rem 1rem; background: #221d12; })";

}  // namespace

void write_report(const std::filesystem::path& path, const std::string& title,
                  const std::string& introduction, const std::vector<ReportTable>& tables,
                  const std::vector<ReportPicture>& pictures, const Figures& figures,
                  const std::vector<std::string>& notes) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                     escaped(title) + "</title><style>" + kStyle + "</style></head>\n<body>\n<h1>" +
                     escaped(title) + "</h1>\n<p>" + escaped(introduction) +
                     "</p>\n<p class=\"warning\">Research software. Not for clinical use.</p>\n";
  for (const ReportTable& table : tables) {
    std::string rows;
    for (const auto& [key, meaning] : table.rows) {
      const auto figure = figures.find(key);
      if (figure == figures.end()) continue;
      rows += "<tr><td>" + escaped(meaning) + "</td><td class=\"value\">" + with_unit(key, figure->second) +
              "</td><td><code>" + escaped(key) + "</code></td></tr>\n";
    }
    if (!table.lines.empty()) rows += row_of(table.heads, "th");
    for (const std::vector<std::string>& line : table.lines) rows += row_of(line, "td");
    if (rows.empty()) continue;
    html += "<h2>" + escaped(table.title) + "</h2>\n";
    if (!table.remark.empty()) html += "<p class=\"remark\">" + escaped(table.remark) + "</p>\n";
    html += "<table>\n" + rows + "</table>\n";
  }
  if (!notes.empty()) {
    html += "<h2>What the stages doubt</h2>\n<ul>\n";
    for (const std::string& note : notes) html += "<li>" + escaped(note) + "</li>\n";
    html += "</ul>\n";
  }
  if (!pictures.empty()) html += "<h2>Pictures</h2>\n";
  for (const ReportPicture& picture : pictures)
    html += "<figure><img src=\"" + escaped(picture.file) + "\" alt=\"" + escaped(picture.caption) +
            "\"><figcaption>" + escaped(picture.caption) + "</figcaption></figure>\n";
  html += "</body></html>\n";
  write_file_atomically(path, html);
}

}  // namespace glisson::experiments
