// SPDX-License-Identifier: GPL-3.0-or-later
#include "igtl_argument.h"

#include <chrono>
#include <thread>

#include "glisson/ui/scene/sent_model.h"

namespace glisson::app {
namespace {

constexpr const char* kSend = "igtl-send";
constexpr const char* kWait = "igtl-wait";

}  // namespace

void FrameTeller::declare(Arguments& arguments) {
  arguments.option_with_usual_value(
      kSend,
      Cli::tr("Listens at this address and tells programs that connect by OpenIGTLink (3D "
              "Slicer, CustusX, PLUS) of each frame: level, pose, surfaces. Without an address "
              "127.0.0.1:18944, which other computers do not reach; port 0: a free one."),
      "ADDRESS:PORT");
  arguments.flag(kWait, Cli::tr("With --igtl-send: begins when a program has connected."));
}

FrameTeller::FrameTeller(const Arguments& arguments) : waits_(arguments.has(kWait)) {
  if (!arguments.has(kSend)) {
    if (waits_) throw UsageError("--igtl-wait: needs --igtl-send.");
    return;
  }
  openigtlink::SenderOptions options;
  options.address = openigtlink::parse_address(arguments.value(kSend).toStdString());
  sender_ = std::make_unique<openigtlink::Sender>(options);
  const QString address = QString::fromStdString(sender_->address().text());
  say(sender_->address().is_local()
          ? Cli::tr("OpenIGTLink: listening at %1.").arg(address)
          : Cli::tr("OpenIGTLink: listening at %1, where other computers may reach it.").arg(address));
}

void FrameTeller::begin(const std::shared_ptr<const model::BuiltModel>& tracked, const RunContext& context) {
  if (!sender_) return;
  // Of the model, whoever owns the rest.
  const std::shared_ptr<const PatientModel> patient(tracked, &tracked->model);
  model_ = scene::sent_model(*scene::make_drawable(patient));
  while (waits_ && sender_->state().peers == 0) {
    if (context.cancelled()) throw Interrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void FrameTeller::tell(const OverlayFrame& overlay) {
  if (sender_) sender_->tell(model_, overlay);
}

}  // namespace glisson::app
