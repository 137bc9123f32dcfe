#pragma once
// Runs the built programs as a user does: a shell in a scratch folder, with `isect` in its PATH.

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace isect::test {

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/// The files below a folder, by their paths from there, in order.
inline std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.push_back(std::filesystem::relative(entry.path(), folder).string());
  std::ranges::sort(names);
  return names;
}

/// How often a part stands in a text.
inline int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

/// All that stands between `before` and the next `end`.
inline std::vector<std::string> all_between(const std::string& text, const std::string& before, char end = '"') {
  std::vector<std::string> all;
  for (std::size_t at = text.find(before); at != text.npos; at = text.find(before, at)) {
    at += before.size();
    all.push_back(text.substr(at, text.find(end, at) - at));
  }
  return all;
}

struct Ran {
  int status = -1;
  std::string out, err;
};

/// A folder of its own for each test, removed at the end.
class Shell {
 public:
  Shell() {
    std::string name = (std::filesystem::temp_directory_path() / "isect-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no scratch folder");
    folder_ = name;
    std::filesystem::create_directory(work());
  }
  ~Shell() { std::filesystem::remove_all(folder_); }
  Shell(const Shell&) = delete;
  Shell& operator=(const Shell&) = delete;

  /// No display, no colour, no CI unless `command` sets them; stdin is empty.
  Ran operator()(const std::string& command) const {
    write(folder_ / "command", "unset DISPLAY WAYLAND_DISPLAY CI NO_COLOR\nexport PATH=\"" ISECT_BIN ":$PATH\"\ncd '" +
                                   work().string() + "'\n" + command + "\n");
    const std::string run = "sh '" + (folder_ / "command").string() + "' </dev/null >'" + (folder_ / "out").string() +
                            "' 2>'" + (folder_ / "err").string() + "'";
    const int status = std::system(run.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(folder_ / "out"), contents(folder_ / "err")};
  }

  /// Where commands run.
  std::filesystem::path work() const { return folder_ / "work"; }

 private:
  std::filesystem::path folder_;
};

}  // namespace isect::test
