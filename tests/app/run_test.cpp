// The script `run` before it builds: what it installs, or says, on machines that lack something. The package
// tools are stand-ins that write down how they were called.

#include <filesystem>

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace run_test {
namespace fs = std::filesystem;
using namespace isect::test;
using Catch::Matchers::StartsWith;

namespace {

/// A machine on which everything but libosmesa6-dev is installed.
class Machine : public Shell {
 public:
  explicit Machine(bool root) {
    fs::create_directory(work() / "tools");
    for (const std::string tool : {"dirname", "sed", "tr", "cat", "env", "sh"})
      REQUIRE((*this)("ln -s \"$(command -v " + tool + ")\" tools/").status == 0);
    command("dpkg-query", "for name; do case $name in -*|libosmesa6-dev) ;; *) echo \"installed $name\" ;; esac; done");
    command("id", root ? "echo 0" : "echo 1000");
    command("sudo", "exit 1");
    command("apt-cache", "exit 0");
    command("apt-get", "cat; echo \"$@\" >>\"$LOG\"; exit 1");
  }
  void command(const std::string& name, const std::string& script) const {
    write(work() / "tools" / name, "#!/bin/sh\n" + script + "\n");
    fs::permissions(work() / "tools" / name, fs::perms::owner_all);
  }
  Ran run(const std::string& words = "--version") const {
    return (*this)("export LOG=\"$PWD/log\" PATH=\"$PWD/tools\"; echo left | { sh '" ISECT_RUN "' " + words +
                   "; status=$?; cat; exit $status; }");
  }
  std::string log() const { return contents(work() / "log"); }
};

}  // namespace

TEST_CASE("root installs exactly what is missing, and fetches the lists when that fails", "[run]") {
  const Machine machine(true);
  const Ran r = machine.run();
  CHECK(r.status == 1);
  CHECK(r.out == "left\n");  // stdin is not read, stdout not written
  CHECK_THAT(r.err, Contains("installing: libosmesa6-dev") && Contains("could not install: libosmesa6-dev"));
  const std::string log = machine.log();
  CHECK_THAT(log, Contains("install -y --no-install-recommends libosmesa6-dev\n"));
  CHECK_THAT(log, Contains("update\n"));
}

TEST_CASE("sudo is used where it asks nothing", "[run]") {
  const Machine machine(false);
  machine.command("sudo", "echo \"sudo $@\" >>\"$LOG\"; [ \"$2\" = true ]");
  const Ran r = machine.run();
  CHECK_THAT(machine.log(), Contains("sudo -n true") && Contains("sudo -n env DEBIAN_FRONTEND=noninteractive apt-get"));
}

TEST_CASE("without root the exact line is told", "[run]") {
  const Machine machine(false);
  const Ran r = machine.run();
  CHECK(r.status == 1);
  CHECK(r.out == "left\n");
  CHECK_THAT(r.err, Contains("sudo apt-get update && sudo apt-get install --no-install-recommends libosmesa6-dev"));
  CHECK(machine.log().empty());
}

TEST_CASE("packages are installed with those of the tests and others that are named, and nothing is built", "[run]") {
  const Machine machine(true);
  machine.command("dpkg-query",
                  "for name; do case $name in -*|catch2|xvfb|zopfli) ;; *) echo \"installed $name\" ;; esac; done");
  machine.command("apt-get", "echo \"$@\" >>\"$LOG\"");
  const Ran r = machine.run("packages zopfli");
  CHECK(r.status == 0);
  CHECK(r.out == "left\n");
  CHECK(r.err == "run: installing: catch2 xvfb zopfli\n");
  CHECK_THAT(machine.log(), Contains("install -y --no-install-recommends catch2 xvfb zopfli\n"));
}

TEST_CASE("another system is told what is needed", "[run]") {
  const Machine machine(true);
  fs::remove(machine.work() / "tools/dpkg-query");
  const Ran r = machine.run();
  CHECK(r.status == 1);
  CHECK(r.out == "left\n");
  CHECK_THAT(r.err, StartsWith("run: this is no Debian-like system") && Contains("libosmesa6-dev") &&
                        Contains("cmake --preset release"));
  CHECK(machine.log().empty());
}

}  // namespace run_test
