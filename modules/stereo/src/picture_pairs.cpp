// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_pairs.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/side.h"

namespace glisson::stereo {
namespace fs = std::filesystem;
namespace {

constexpr const char* kNames =
    "Name them so that only the side differs, as left-001.png and right-001.png, or put them into folders "
    "left "
    "and right";

bool digit(char c) { return c >= '0' && c <= '9'; }

/// "left-798" before "left-1095": runs of digits by value.
bool before(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!digit(a[i]) || !digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const auto run = [](const std::string& text, std::size_t& k) {
      std::string value;
      for (; k < text.size() && digit(text[k]); ++k)
        if (text[k] != '0' || !value.empty()) value += text[k];
      return value;
    };
    const std::string x = run(a, i), y = run(b, j);
    if (x.size() != y.size()) return x.size() < y.size();
    if (x != y) return x < y;
  }
  return a.size() - i < b.size() - j;
}

bool is_picture(const fs::path& path) {
  const std::string extension = lower_extension(path);
  for (const char* known : {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"})
    if (extension == known) return true;
  return false;
}

/// * any run, ? any one character.
bool fits(const std::string& name, const std::string& pattern) {
  std::size_t n = 0, p = 0, star = std::string::npos, back = 0;
  while (n < name.size()) {
    if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++n, ++p;
    } else if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      back = n;
    } else if (star != std::string::npos) {
      p = star + 1;
      n = ++back;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

std::vector<fs::path> sorted(std::vector<fs::path> files) {
  std::sort(files.begin(), files.end(),
            [](const fs::path& a, const fs::path& b) { return before(a.filename(), b.filename()); });
  return files;
}

std::vector<fs::path> pictures_in(const fs::path& folder, const std::string& pattern) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder, failure))
    if (entry.is_regular_file() && is_picture(entry.path()) && fits(entry.path().filename(), pattern))
      files.push_back(entry.path());
  if (failure)
    throw FileError(folder.string() + ": cannot be read (" + failure.message() + "). Check the path.");
  return sorted(std::move(files));
}

std::vector<fs::path> expand(const fs::path& source) {
  if (fs::is_directory(source)) {
    auto files = pictures_in(source, "*");
    if (files.empty()) throw FileError(source.string() + ": holds no pictures. Check the path.");
    return files;
  }
  const fs::path folder = source.has_parent_path() ? source.parent_path() : fs::path(".");
  if (!fs::is_directory(folder))
    throw FileError(source.string() + ": its folder does not exist. Check the path.");
  auto files = pictures_in(folder, source.filename());
  if (files.empty()) throw FileError(source.string() + ": no picture has such a name. Check the pattern.");
  return files;
}

/// The side that a name tells, and the name without it. The last mention counts: folders' prefixes come
/// first.
struct Named {
  std::optional<Side> side;
  std::string rest;
};
Named named(const fs::path& file) {
  const std::string stem = lower_case(file.stem().string());
  for (const auto& [word, side] : {std::pair<std::string, Side>{"left", Side::left}, {"right", Side::right}})
    if (const std::size_t at = stem.rfind(word); at != std::string::npos)
      return {side, stem.substr(0, at) + stem.substr(at + word.size())};
  // A single letter counts where it stands alone: "f7_L_0100", "0100-r", "l01".
  const auto letter = [&](std::size_t i) {
    return i < stem.size() && std::isalpha(static_cast<unsigned char>(stem[i])) != 0;
  };
  for (std::size_t i = stem.size(); i-- > 0;) {
    if ((stem[i] != 'l' && stem[i] != 'r') || letter(i + 1) || (i > 0 && letter(i - 1))) continue;
    return {stem[i] == 'l' ? Side::left : Side::right, stem.substr(0, i) + stem.substr(i + 1)};
  }
  return {std::nullopt, stem};
}

std::string pair_name(const std::string& rest, const fs::path& left) {
  const auto first = rest.find_first_not_of("-_. "), last = rest.find_last_not_of("-_. ");
  return first == std::string::npos ? left.stem().string() : rest.substr(first, last - first + 1);
}

/// Of two files of one name, as 1.jpg and 1.png, each takes the other view's of its own format, and what is
/// left then any other's.
PicturePairs matched(const std::vector<fs::path>& left, const std::vector<fs::path>& right) {
  std::multimap<std::string, fs::path> partners;
  for (const fs::path& file : right) partners.emplace(named(file).rest, file);
  const auto take = [&](const fs::path& file, bool of_its_format) -> fs::path {
    const auto [begin, end] = partners.equal_range(named(file).rest);
    const auto partner = std::find_if(begin, end, [&](const auto& one) {
      return !of_its_format || lower_extension(one.second) == lower_extension(file);
    });
    return partner == end ? fs::path() : partners.extract(partner).mapped();
  };
  std::vector<fs::path> of_left;
  of_left.reserve(left.size());
  for (const fs::path& file : left) of_left.push_back(take(file, true));
  PicturePairs result;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (of_left[i].empty()) of_left[i] = take(left[i], false);
    if (of_left[i].empty())
      result.alone.push_back(left[i]);
    else
      result.pairs.push_back({pair_name(named(left[i]).rest, left[i]), left[i], of_left[i]});
  }
  for (const auto& [rest, file] : partners) result.alone.push_back(file);
  return result;
}

}  // namespace

PicturePairs picture_pairs(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw FileError(folder.string() + ": is no folder. Check the path.");
  if (fs::is_directory(folder / "left") && fs::is_directory(folder / "right"))
    return picture_pairs(folder / "left", folder / "right");
  std::vector<fs::path> left, right;
  for (const fs::path& file : pictures_in(folder, "*")) {
    const auto side = named(file).side;
    if (side == Side::left) left.push_back(file);
    if (side == Side::right) right.push_back(file);
  }
  PicturePairs result = matched(left, right);
  if (result.pairs.empty())
    throw InputError(folder.string(), "",
                     "holds no pair (" + std::to_string(left.size()) + " left pictures, " +
                         std::to_string(right.size()) + " right ones)",
                     kNames);
  return result;
}

PicturePairs picture_pairs(const fs::path& left, const fs::path& right) {
  const std::vector<fs::path> in_left = expand(left), in_right = expand(right);
  PicturePairs result = matched(in_left, in_right);
  if (!result.pairs.empty()) return result;
  if (in_left.size() != in_right.size())
    throw InputError(left.string() + " and " + right.string(), "",
                     "hold " + std::to_string(in_left.size()) + " and " + std::to_string(in_right.size()) +
                         " pictures with no name in common",
                     kNames);
  result = {};
  for (std::size_t i = 0; i < in_left.size(); ++i)
    result.pairs.push_back({in_left[i].stem().string(), in_left[i], in_right[i]});
  return result;
}

}  // namespace glisson::stereo
