// SPDX-License-Identifier: GPL-3.0-or-later
#include "foreign_pictures.h"

#include <fstream>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/late_library.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_reader.h"
#include "picture_header.h"

namespace glisson::stereo {
namespace fs = std::filesystem;
namespace {

/// By the clock, beyond the reader's own limit of processor time: it is killed then.
constexpr double kPatience = 60.0;

std::string reader_program() {
  return helper_program("glisson-read-pictures", "GLISSON_READ_PICTURES").string();
}

bool fits(const reader::PixelAnswer& answer, long width, long height) {
  return answer.width == width && answer.height == height && (answer.channels == 1 || answer.channels == 3);
}

std::size_t bytes_of(const reader::PixelAnswer& answer) {
  return static_cast<std::size_t>(answer.width) * static_cast<std::size_t>(answer.height) *
         static_cast<std::size_t>(answer.channels);
}

/// libjpeg fills what is missing with grey and reports success; libpng complains on the terminal.
bool has_its_end(const std::string& content) {
  if (content.starts_with("\x89PNG")) return content.rfind("IEND") != std::string::npos;
  if (content.starts_with("\xFF\xD8")) return content.rfind("\xFF\xD9") != std::string::npos;
  return true;
}

}  // namespace

struct PictureReader::Impl {
  std::unique_ptr<Conversation> reader;

  Picture decoded(const std::string& content, const PictureHeader& header) {
    if (!reader)
      reader = std::make_unique<Conversation>(reader_program(), std::vector<std::string>{"pictures"});
    const reader::PictureQuestion question{
        content.size(), static_cast<std::uint64_t>(header.width) * static_cast<std::uint64_t>(header.height)};
    reader::PixelAnswer answer;
    Picture picture;
    bool heard = reader->send(question, kPatience) &&
                 reader->send(content.data(), content.size(), kPatience) &&
                 reader->receive(answer, kPatience);
    if (heard && fits(answer, header.width, header.height)) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>(bytes_of(answer));
      heard = reader->receive(bytes->data(), bytes->size(), kPatience);
      if (heard) picture = {answer.width, answer.height, answer.channels, std::move(bytes)};
    } else if (answer.width != 0) {
      heard = false;  // pixels would follow that nobody wants
    }
    if (!heard) reader.reset();
    return picture;
  }
};

PictureReader::PictureReader() : impl_(std::make_unique<Impl>()) {}
PictureReader::~PictureReader() = default;

Picture PictureReader::read(const fs::path& path) { return decode(read_file(path), path.string()); }

Picture PictureReader::decode(const std::string& content, const std::string& name) {
  const auto header = picture_header(content);
  if (header && header->width > kMostPixels / header->height)
    throw InputError(name, "size",
                     "claims " + std::to_string(header->width) + " x " + std::to_string(header->height) +
                         " pixels, more than any camera has",
                     "The file is damaged: copy it again");
  Picture picture;
  if (header && has_its_end(content)) picture = impl_->decoded(content, *header);
  if (picture.empty())
    throw InputError(name, "", "is not a whole picture that can be read",
                     "Use PNG, JPEG, BMP or TIFF, and copy it again if it was cut off");
  return picture;
}

Picture read_picture(const fs::path& path) { return PictureReader().read(path); }

std::vector<std::string> picture_reader_escapes() {
  const TemporaryFolder work;
  (void)run_child(reader_program(), {"escapes", work.path().string()}, RunContext(), {});
  std::ifstream file(work.path() / "escapes");
  if (!file) throw FileError(reader_program() + ": cannot run. Install Glisson again.");
  std::vector<std::string> words;
  for (std::string word; file >> word;) words.push_back(word);
  return words;
}

ForeignVideo::ForeignVideo(const fs::path& path)
    : reader_(reader_program(), {"video", fs::absolute(path).string()}) {
  reader::VideoAnswer answer;
  if (!reader_.receive(answer, kPatience)) return;
  if (answer.opened == reader::kNoDecoder) throw MissingLibrary(reader_program());
  if (answer.opened == reader::kOpened) header_ = answer;
}

std::optional<reader::GrabAnswer> ForeignVideo::grab() {
  reader::GrabAnswer answer;
  if (!std::exchange(asked_, false) && !reader_.send(reader::kGrab, kPatience)) return std::nullopt;
  if (!reader_.receive(answer, kPatience)) return std::nullopt;
  return answer;
}

bool ForeignVideo::retrieve(cv::Mat& image) {
  reader::PixelAnswer answer;
  if (!reader_.send(reader::kRetrieve, kPatience) || !reader_.receive(answer, kPatience)) return false;
  if (!fits(answer, header_->width, header_->height)) {
    if (answer.width != 0) reader_.end();  // pixels would follow that nobody wants
    return false;
  }
  image.create(answer.height, answer.width, CV_8UC(answer.channels));
  if (!reader_.receive(image.data, bytes_of(answer), kPatience)) return false;
  asked_ = reader_.send(reader::kGrab, kPatience);  // decoded while this one is worked on
  return true;
}

}  // namespace glisson::stereo
