// SPDX-License-Identifier: GPL-3.0-or-later
// The other end, made with the library alone: nothing of Glisson is in it.
//   openigtlink_peer listen PORT   connects, prints each message as a line, ends when the server closes
//   openigtlink_peer idle PORT     connects, reads nothing, until its input ends
//   openigtlink_peer babble PORT   connects, says what is no message, until its input ends
#include <igtlClientSocket.h>
#include <igtlMessageHeader.h>
#include <igtlPolyDataMessage.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTransformMessage.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

igtl::ClientSocket::Pointer connect_to(int port) {
  auto socket = igtl::ClientSocket::New();
  if (socket->ConnectToServer("127.0.0.1", port) != 0) std::exit(3);
  return socket;
}

/// The message of a header, unpacked with its check sum. Ends the program where it is none.
template <class Message>
typename Message::Pointer body_of(igtl::ClientSocket::Pointer& socket, igtl::MessageHeader::Pointer& header) {
  auto message = Message::New();
  message->SetMessageHeader(header);
  message->AllocatePack();
  if (message->GetPackBodySize() > 0 &&
      socket->Receive(message->GetPackBodyPointer(), message->GetPackBodySize()) !=
          message->GetPackBodySize())
    std::exit(4);
  if ((message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY) == 0) std::exit(5);
  return message;
}

void print_transform(igtl::TransformMessage::Pointer message) {
  igtl::Matrix4x4 matrix;
  message->GetMatrix(matrix);
  for (const auto& row : matrix)
    for (const float value : row) std::printf(" %.9g", static_cast<double>(value));
}

void print_poly_data(igtl::PolyDataMessage::Pointer message) {
  igtl::PolyDataPointArray::Pointer points = message->GetPoints();
  igtl::PolyDataCellArray::Pointer polygons = message->GetPolygons();
  const int count = points.IsNotNull() ? points->GetNumberOfPoints() : 0;
  const unsigned cells = polygons.IsNotNull() ? polygons->GetNumberOfCells() : 0;
  std::printf(" %d %u", count, cells);
  constexpr int kMost = 100;  // of those that are printed
  for (int i = 0; i < count && i < kMost; ++i) {
    float at[3];
    points->GetPoint(static_cast<unsigned>(i), at);
    for (const float value : at) std::printf(" %.9g", static_cast<double>(value));
  }
  for (unsigned i = 0; i < cells && i < kMost; ++i) {
    std::vector<igtlUint32> cell(polygons->GetCellSize(i));
    polygons->GetCell(i, cell.data());
    for (const igtlUint32 corner : cell) std::printf(" %u", corner);
  }
}

int listen(int port) {
  auto socket = connect_to(port);
  for (;;) {
    auto header = igtl::MessageHeader::New();
    header->InitPack();
    if (socket->Receive(header->GetPackPointer(), header->GetPackSize()) != header->GetPackSize()) return 0;
    header->Unpack(1);
    unsigned seconds = 0, fraction = 0;
    header->GetTimeStamp(&seconds, &fraction);
    const std::string type = header->GetDeviceType();
    std::printf("%s %s %.6f", type.c_str(), header->GetDeviceName(), seconds + fraction / 4294967296.0);
    if (type == "TRANSFORM") print_transform(body_of<igtl::TransformMessage>(socket, header));
    if (type == "POLYDATA") print_poly_data(body_of<igtl::PolyDataMessage>(socket, header));
    if (type == "STRING") std::printf(" %s", body_of<igtl::StringMessage>(socket, header)->GetString());
    if (type == "STATUS") {
      auto status = body_of<igtl::StatusMessage>(socket, header);
      std::printf(" %d %ld %s", status->GetCode(), static_cast<long>(status->GetSubCode()),
                  status->GetErrorName());
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

/// Until the input ends.
void wait_for_end() {
  while (std::getchar() != EOF) {
  }
}

int idle(int port) {
  auto socket = connect_to(port);
  std::printf("connected\n");
  std::fflush(stdout);
  wait_for_end();
  return 0;
}

int babble(int port) {
  auto socket = connect_to(port);
  std::string noise(100000, '\xff');
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<char>(i * 7919 % 251);
  for (int i = 0; i < 20; ++i) socket->Send(noise.data(), static_cast<int>(noise.size()));
  std::printf("said\n");
  std::fflush(stdout);
  wait_for_end();
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) return 2;
  const std::string mode = words[1];
  const int port = std::atoi(words[2]);
  if (mode == "listen") return listen(port);
  if (mode == "idle") return idle(port);
  if (mode == "babble") return babble(port);
  return 2;
}
