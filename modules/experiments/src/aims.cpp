// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/aims.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "glisson/core/files.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

std::string number(const char* format, int digits, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

const char* word(Evidence evidence) {
  return evidence == Evidence::in_silico ? "in silico" : evidence == Evidence::phantom ? "phantom" : "real";
}

const char* word(Verdict verdict) {
  return verdict == Verdict::met ? "met" : verdict == Verdict::missed ? "**not met**" : "not measured";
}

std::string row(const Aim& aim, const Figures& figures) {
  const Verdict found = verdict(aim, figures);
  const std::string value =
      found == Verdict::not_measured ? "" : number("%.*f", aim.decimals, figures.at(aim.key));
  return "| " + aim.what + " | " + word(aim.evidence) + " | " + value + " | " +
         (aim.sense == Aim::Sense::at_least ? "≥ " : "≤ ") + number("%.*f", aim.decimals, aim.bound) + " | " +
         word(found) + " |\n";
}

/// How long something took says more of the machine than of the method, and differs each time.
bool is_time(const std::string& key) {
  return key.find("seconds") != std::string::npos || key.ends_with("_ms");
}

/// " Not there: `one`, `two`."; empty where there is none.
std::string listed(const std::string& what, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? " " + what + ": `" : ", `") + name + "`";
  return text.empty() ? text : text + ".";
}

std::string sentence_of(const ProofPage& page) {
  const auto count = [&](Verdict wanted) {
    return std::count_if(page.aims.begin(), page.aims.end(),
                         [&](const Aim& aim) { return verdict(aim, page.figures) == wanted; });
  };
  std::string text = std::to_string(count(Verdict::met)) + " of " + std::to_string(page.aims.size()) +
                     " aims met, " + std::to_string(count(Verdict::missed)) + " not met, " +
                     std::to_string(count(Verdict::not_measured)) + " not measured.";
  return text + listed("Not there", page.absent) + listed("Not used", page.unused);
}

}  // namespace

Verdict verdict(const Aim& aim, const Figures& figures) {
  const auto figure = figures.find(aim.key);
  if (figure == figures.end() || std::isnan(figure->second)) return Verdict::not_measured;
  const bool met =
      aim.sense == Aim::Sense::at_least ? figure->second >= aim.bound : figure->second <= aim.bound;
  return met ? Verdict::met : Verdict::missed;
}

Verdict verdict(const ProofPage& page) {
  Verdict all = page.absent.empty() ? Verdict::met : Verdict::not_measured;
  for (const Aim& aim : page.aims) {
    const Verdict one = verdict(aim, page.figures);
    if (one == Verdict::missed) return Verdict::missed;
    if (one == Verdict::not_measured) all = Verdict::not_measured;
  }
  return all;
}

void write_page(const fs::path& file, const ProofPage& page) {
  std::string text = "# " + page.title + "\n\nWritten by `" + page.command + "`; not to be edited.\n\n" +
                     page.introduction + "\n\n" + sentence_of(page) +
                     "\n\n| what | measured on | figure | aim | |\n|---|---|---:|---:|---|\n";
  for (const Aim& aim : page.aims) text += row(aim, page.figures);
  if (!page.table.empty()) text += "\n## Trials\n\n";
  for (const std::string& line : page.table) text += "    " + line + "\n";
  std::set<std::string> shown;
  for (const Aim& aim : page.aims) shown.insert(aim.key);
  const auto shortly = [](double value) {
    const bool is_count = value == std::round(value) && std::abs(value) < 1e9;
    return number(is_count ? "%.*f" : "%.*g", is_count ? 0 : 4, value);
  };
  std::string rest;
  for (const auto& [key, value] : page.figures)
    if (!shown.contains(key) && !is_time(key) && std::isfinite(value))
      rest += "| `" + key + "` | " + shortly(value) + " |\n";
  if (!rest.empty()) text += "\n## All other figures\n\n| figure | |\n|---|---:|\n" + rest;
  write_file_atomically(file, text);
}

fs::path figures_of_checkout(const fs::path& folder) {
  const bool is_checkout = fs::is_directory(folder / "packaging") && fs::is_directory(folder / "modules");
  return is_checkout ? folder / "packaging" / "figures" : fs::path();
}

}  // namespace glisson::experiments
