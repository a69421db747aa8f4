// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/openigtlink/address.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"

namespace glisson::openigtlink {

/// A surface that goes where the model's mesh goes.
struct SentSurface {
  Label structure = 0;
  Triangles triangles;
  Binding binding;  ///< of its vertices to the model's mesh
};
/// What is sent of a model, besides its pose.
struct SentModel {
  std::shared_ptr<const PatientModel> model;
  std::vector<SentSurface> surfaces;
};

/// Where a sender listens, how much it tells, and when it gives up.
struct SenderOptions {
  Address address;                   ///< to listen at
  double surfaces_per_second = 5.0;  ///< by the frames' own times, at most, but for corrected frames
  double silence = 1.0;              ///< seconds without a frame, after which what was told holds no longer
  double patience = 2.0;             ///< seconds for which a peer may take nothing of what waits for it
  int most_peers = 8;
  /// Seconds since 1970 at which the frames' time 0 was; empty: so that the first frame is of now.
  std::optional<double> epoch = {};
  /// @throws InputError naming the field.
  void validate() const;
};

/// How a sender does at one moment.
struct SenderState {
  int peers = 0;             ///< connected now
  int given_up = 0;          ///< peers that took nothing for too long, so far
  std::uint64_t frames = 0;  ///< told to at least one peer
};

/// A server of OpenIGTLink: tells 3D Slicer, CustusX, PLUS or whoever connects what is known of each frame,
/// from a thread of its own. Messages (millimetres, time stamp of the frame):
///   STATUS, STRING "GlissonLevel"   "level=degraded reason=partly_covered frame=12 doubtful=no"
///   TRANSFORM "LeftCameraToCtRas"   pose of the left camera (OpenCV's axes) in the CT, whose axes are RAS
///   POLYDATA, one a structure       its surface as deformed, in the left camera's frame
/// What the window would not draw is not sent: a withdrawn frame has neither pose nor surfaces, a degraded
/// one the organ's surface alone, a lesion only while it is itself valid. A surface that is not shown any
/// more is sent once more without points and cells, so that no receiver goes on showing the last one.
/// Any thread.
class Sender {
 public:
  /// Listens. @throws InputError options, an address that cannot be listened at.
  explicit Sender(const SenderOptions& options = {});
  /// Withdraws what was told, waits a tenth of a second for peers to take it, and closes.
  ~Sender();
  Sender(const Sender&) = delete;
  Sender& operator=(const Sender&) = delete;

  /// Where it listens; the port is the true one.
  Address address() const;

  /// The newest wins: returns at once, whatever the peers do. Told again (its index and time), with
  /// other nodes or not: it is corrected, but no younger, and holds no longer than `silence` in all.
  /// @param model the same object as long as it is the same model. @pre not null.
  void tell(std::shared_ptr<const SentModel> model, OverlayFrame frame);
  /// What was told holds no longer, as when tracking ends. @pre the reason's level is `withdrawn`.
  void withdraw(Validity reason);

  /// As it is now; from any thread.
  SenderState state() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::openigtlink
