#include "app/named_file.h"

#include <sys/stat.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "app/terminal.h"
#include "viz/files.h"

namespace isect::program {

namespace {

/// Says one line, unless it ends before.
class SaidLater {
 public:
  SaidLater(std::chrono::milliseconds after, std::string line)
      : thread_([this, after, text = std::move(line)](const std::stop_token& ended) {
          std::unique_lock lock(mutex_);
          wake_.wait_for(lock, ended, after, [] { return false; });
          if (!ended.stop_requested()) say(text);
        }) {}

 private:
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;  // the last one, as it uses the others
};

}  // namespace

std::string read_named_file(const std::string& path) {
  struct stat there;
  if (::stat(path.c_str(), &there) != 0 || S_ISREG(there.st_mode)) return viz::read_file(path);
  const SaidLater waiting(std::chrono::seconds(1), path + ": waiting for what somebody is to write there");
  return viz::read_file(path);
}

}  // namespace isect::program
