// MP4 by ffmpeg, a separate program: pictures go to it through a socket, the file comes back through memory, so that no
// file is left behind however either of them ends.

#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>

#include "viz/formats/animation.h"
#include "viz/formats/metadata_limit.h"
#include "viz/formats/metadata_text.h"

namespace isect::viz {
namespace {

constexpr int frames_a_second = 25;                 ///< players stumble over slower videos
constexpr std::size_t most_mp4_metadata = 1 << 20;  ///< far above any figure's

FileError failure(const std::string& why) { return FileError("mp4: " + why); }

/// A file descriptor that is closed by the destructor.
class OwnedNumber {
 public:
  explicit OwnedNumber(int number) : number_(number) {
    if (number < 0) throw failure(std::strerror(errno));
  }
  ~OwnedNumber() { close(); }
  OwnedNumber(const OwnedNumber&) = delete;
  OwnedNumber& operator=(const OwnedNumber&) = delete;

  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

/// A file without a name, which disappears with its last holder.
class Nameless {
 public:
  Nameless() : file_(::memfd_create("isect", 0)) {}
  int number() const { return file_.number(); }
  /// Returns its path for a child that inherits it.
  std::string path() const { return fmt::format("/proc/self/fd/{}", number()); }
  std::string contents() const {
    std::string all;
    std::array<char, 65536> part;
    for (off_t at = 0;;) {
      const ssize_t got = ::pread(number(), part.data(), part.size(), at);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return all;
      all.append(part.data(), static_cast<std::size_t>(got));
      at += got;
    }
  }

 private:
  OwnedNumber file_;
};

std::vector<std::string> command(int width, int height, const Metadata& metadata, const Imprint& imprint,
                                 const std::string& to) {
  std::vector<std::string> words = {"ffmpeg", "-nostdin", "-y", "-loglevel", "error", "-f", "rawvideo"};
  const auto add = [&](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
  add({"-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", width, height)});
  add({"-framerate", std::to_string(frames_a_second), "-i", "pipe:0"});
  // Same input, same bytes: no date, no version, one thread.
  add({"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-threads", "1"});
  add({"-vf", "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p", "-colorspace", "bt709"});
  add({"-color_primaries", "bt709", "-color_trc", "bt709", "-c:v", "libx264", "-crf", "16", "-tune", "stillimage"});
  if (!metadata.empty()) add({"-metadata", fmt::format("comment={}{}", metadata_mark, metadata_text(metadata))});
  if (!imprint.title.empty()) add({"-metadata", "title=" + imprint.title});
  if (!imprint.alt.empty()) add({"-metadata", "description=" + imprint.alt});
  add({"-movflags", "+faststart", "-f", "mp4", to});
  return words;
}

/// Returns three bytes a pixel. The format needs even sides: where needed, the last row or column is repeated.
std::string rgb_of(const Picture& picture, int width, int height) {
  std::string bytes;
  bytes.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int row = std::min(y, picture.height - 1), column = std::min(x, picture.width - 1);
      const std::uint8_t* const from = &picture.rgba[4 * (static_cast<std::size_t>(row) * picture.width + column)];
      bytes.append(reinterpret_cast<const char*>(from), 3);
    }
  return bytes;
}

/// Whether all was sent. A reader that has gone raises no signal here.
bool send_all(int to, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t sent = ::send(to, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += static_cast<std::size_t>(sent);
  }
  return true;
}

/// A running ffmpeg; the destructor waits for it.
class Encoder {
 public:
  Encoder(const std::vector<std::string>& words, const Nameless& said) {
    std::array<int, 2> ends;
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw failure(std::strerror(errno));
    in_ = std::make_unique<OwnedNumber>(ends[0]);
    const OwnedNumber out(ends[1]);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, out.number(), STDIN_FILENO);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_adddup2(&actions, said.number(), stream);
    std::vector<char*> list;
    for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
    list.push_back(nullptr);
    const int failed = ::posix_spawnp(&child_, list[0], &actions, nullptr, list.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw failure(fmt::format("{}: {}", words[0], std::strerror(failed)));
  }
  ~Encoder() { wait(); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  int in() const { return in_->number(); }
  /// Ends its input and waits. Returns its exit status as a shell gives it.
  int wait() {
    in_->close();
    if (child_ == 0) return status_;
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = 0;
    return status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  std::unique_ptr<OwnedNumber> in_;
  pid_t child_ = 0;
  int status_ = 0;
};

}  // namespace

bool can_write_mp4() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
  return false;
}

std::string mp4(const std::vector<Picture>& pictures, const Timing& timing, const Metadata& metadata,
                const Imprint& imprint) {
  need_alike(pictures);
  const int width = (pictures.front().width + 1) / 2 * 2, height = (pictures.front().height + 1) / 2 * 2;
  const Nameless file, said;
  Encoder ffmpeg(command(width, height, metadata, imprint, file.path()), said);
  bool taken = true;
  for (std::size_t p = 0; p < pictures.size() && taken; ++p) {
    const std::string bytes = rgb_of(pictures[p], width, height);
    const auto times = std::max(1L, std::lround(frames_a_second * timing.of(p)));
    for (long i = 0; i < times && taken; ++i) taken = send_all(ffmpeg.in(), bytes);
  }
  const int status = ffmpeg.wait();
  std::string bytes = file.contents();
  if (status == 0 && taken && !bytes.empty()) return bytes;
  std::string why = said.contents();
  while (!why.empty() && (why.back() == '\n' || why.back() == ' ')) why.pop_back();
  throw failure(fmt::format("ffmpeg ended with status {}{}{}", status, why.empty() ? "" : ": ", why));
}

Metadata mp4_metadata(const std::string& bytes) {
  if (bytes.size() < 8 || bytes.compare(4, 4, "ftyp") != 0) throw FileError("not an MP4 file");
  // In an atom "data": its size, its name, eight bytes of type and place, the text.
  for (std::size_t at = 0; (at = bytes.find(metadata_mark, at)) != bytes.npos; ++at) {
    constexpr std::size_t head = 16;
    if (at < head || bytes.compare(at - head + 4, 4, "data") != 0) continue;
    std::size_t size = 0;
    for (std::size_t i = at - head; i < at - head + 4; ++i) size = size << 8 | static_cast<unsigned char>(bytes[i]);
    const std::size_t text = size - std::min(size, head);
    if (text < metadata_mark.size() || text > most_mp4_metadata || at + text > bytes.size()) continue;
    return metadata_of_text(bytes.substr(at + metadata_mark.size(), text - metadata_mark.size()), "MP4");
  }
  return {};
}

}  // namespace isect::viz
