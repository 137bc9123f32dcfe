#include "app/shell/named_file.h"

#include <sys/stat.h>

#include "app/shell/terminal.h"
#include "viz/formats/files.h"

namespace isect::program {

std::string read_named_file(const std::string& path) {
  const std::string from = path == "-" ? "/dev/stdin" : path;
  struct stat there;
  if (::stat(from.c_str(), &there) != 0 || S_ISREG(there.st_mode)) return viz::read_file(from);
  const SaidLater waiting(path + ": waiting for what somebody is to write there");
  return viz::read_file(from);
}

}  // namespace isect::program
