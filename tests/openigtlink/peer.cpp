// SPDX-License-Identifier: GPL-3.0-or-later
// The other end, made with the library alone: nothing of Glisson is in it.
//   openigtlink_peer listen PORT   connects, prints each message as a line, ends when the server closes
//   openigtlink_peer idle PORT     connects, reads nothing, until its input ends
//   openigtlink_peer babble PORT   connects, says what is no message, until its input ends
//   openigtlink_peer serve KIND    prints "port N" and sends to whoever connects, one after the other, of
//   whom each is told by a line "client": pictures
//     (frame i: pixel (x, y) is (x + i, y, 200) in red, green, blue, 7 more in the right one; time 1000 + i /
//     25) and the pose of a tool. KIND: good, grey, skewed, lagging (the right view one frame behind),
//     fast (time 1000 + i / 60, every third left view is lost), damaged, lying, endless, silent, noise, nan,
//     brief
#include <igtlClientSocket.h>
#include <igtlImageMessage.h>
#include <igtlMessageHeader.h>
#include <igtlOSUtil.h>
#include <igtlPolyDataMessage.h>
#include <igtlServerSocket.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTransformMessage.h>
#include <igtl_header.h>
#include <igtl_util.h>

#include <cmath>
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

constexpr int kWidth = 64, kHeight = 48;

void stamp(igtl::MessageBase* message, const char* name, double seconds) {
  message->SetDeviceName(name);
  const auto whole = static_cast<unsigned>(seconds);
  message->SetTimeStamp(whole, static_cast<unsigned>((seconds - whole) * 4294967296.0));
}

igtl::ImageMessage::Pointer picture(const char* name, int frame, int more, double seconds, int components) {
  auto message = igtl::ImageMessage::New();
  message->SetDimensions(kWidth, kHeight, 1);
  message->SetSpacing(1, 1, 1);
  message->SetNumComponents(components);
  message->SetScalarType(igtl::ImageMessage::TYPE_UINT8);
  stamp(message, name, seconds);
  message->AllocateScalars();
  auto* to = static_cast<unsigned char*>(message->GetScalarPointer());
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int values[] = {x + frame + more, y + more, 200};
      for (int c = 0; c < components; ++c) *to++ = static_cast<unsigned char>(values[c]);
    }
  message->Pack();
  return message;
}

igtl::TransformMessage::Pointer tool(int frame, double seconds, bool is_number) {
  auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix = {
      {0, -1, 0, 10.0F + static_cast<float>(frame)}, {1, 0, 0, -20}, {0, 0, 1, 120}, {0, 0, 0, 1}};
  if (!is_number) matrix[0][3] = NAN;
  message->SetMatrix(matrix);
  stamp(message, "Tip", seconds);
  message->Pack();
  return message;
}

igtl::TransformMessage::Pointer still_tool(const std::string& kind, double seconds) {
  auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix = {{1, 0, 0, 10}, {0, 1, 0, -20}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  matrix[2][3] = static_cast<float>(std::atof(kind.c_str() + 1));
  message->SetMatrix(matrix);
  stamp(message, "Tip", seconds);
  message->Pack();
  return message;
}

/// With the header's sum made right again: only what the message says is wrong.
std::string lied(igtl::ImageMessage::Pointer message, std::size_t at, unsigned char value) {
  std::string bytes(static_cast<char*>(message->GetPackPointer()),
                    static_cast<std::size_t>(message->GetPackSize()));
  bytes[IGTL_HEADER_SIZE + at] = static_cast<char>(value);
  const igtl_uint64 sum = crc64(reinterpret_cast<unsigned char*>(bytes.data()) + IGTL_HEADER_SIZE,
                                bytes.size() - IGTL_HEADER_SIZE, 0);
  for (int i = 0; i < 8; ++i)
    bytes[50 + static_cast<std::size_t>(i)] = static_cast<char>(sum >> (56 - 8 * i));
  return bytes;
}

bool send(igtl::Socket* socket, const std::string& bytes) {
  return socket->Send(bytes.data(), static_cast<int>(bytes.size())) != 0;
}
bool send(igtl::Socket* socket, igtl::MessageBase* message) {
  return socket->Send(message->GetPackPointer(), message->GetPackSize()) != 0;
}

/// One frame's messages. @return false: the other end has gone, or it is over.
bool send_frame(igtl::Socket* socket, const std::string& kind, int frame) {
  const double seconds = 1000.0 + frame / (kind == "fast" ? 60.0 : 25.0);
  const int components = kind == "grey" ? 1 : 3;
  auto left = picture("Left", frame, 0, seconds, components);
  if (kind == "lagging") {
    auto late = picture("Right", frame - 1, 7, seconds - 1.0 / 25.0, 3);
    return send(socket, left) && (frame == 0 || send(socket, late));
  }
  auto right = picture("Right", frame, 7, seconds + (kind == "skewed" ? 0.5 : 0.004), components);
  if (kind == "silent") return true;
  if (kind == "fast") return (frame % 3 == 0 || send(socket, left)) && send(socket, right);
  if (kind == "noise") return send(socket, std::string(5000, 'x'));
  if (kind == "damaged") static_cast<char*>(left->GetPackBodyPointer())[500] ^= 1;
  if (kind == "endless") {  // a header of 99 MB, and nothing behind it
    std::string bytes(static_cast<char*>(left->GetPackPointer()), IGTL_HEADER_SIZE);
    bytes.replace(42, 8, std::string("\0\0\0\0\5\xe6\x9e\xc0", 8));
    return frame > 0 || send(socket, bytes);
  }
  if (kind == "lying") {
    const std::size_t sizes[] = {6, 8, 10, 2, 3, 62, 66};  // sides, slices, components, scalars, its part
    return send(socket, lied(left, sizes[frame % 7], 0xff)) && send(socket, right) &&
           send(socket, tool(frame, seconds, true));
  }
  if (kind == "brief" && frame == 3) return false;
  return send(socket, picture("Other", frame, 50, seconds, 3)) && send(socket, left) && send(socket, right) &&
         send(socket, kind[0] == 'z' ? still_tool(kind, seconds) : tool(frame, seconds, kind != "nan"));
}

int serve(const std::string& kind) {
  auto server = igtl::ServerSocket::New();
  if (server->CreateServer(0) != 0) return 3;
  std::printf("port %d\n", server->GetServerPort());
  std::fflush(stdout);
  for (;;) {
    auto socket = server->WaitForConnection(1000);
    if (socket.IsNull()) continue;
    std::printf("client\n");
    std::fflush(stdout);
    constexpr int kPause = 10;  // milliseconds
    for (int frame = 0; send_frame(socket, kind, frame); ++frame) igtl::Sleep(kPause);
    socket->CloseSocket();
  }
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) return 2;
  const std::string mode = words[1];
  if (mode == "serve") return serve(words[2]);
  const int port = std::atoi(words[2]);
  if (mode == "listen") return listen(port);
  if (mode == "idle") return idle(port);
  if (mode == "babble") return babble(port);
  return 2;
}
