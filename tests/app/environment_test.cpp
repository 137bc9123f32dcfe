// What the program says, and leaves behind, where the machine lacks something: fonts, memory, a reader, a disk.

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace environment_test {
namespace fs = std::filesystem;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using isect::test::Contains;
using isect::test::contents;
using isect::test::Ran;
using isect::test::Shell;
using isect::test::write;

namespace {

/// Writes a font configuration of this folder only; without any folder if it is empty.
void configure_fonts(const Shell& shell, const std::string& folder) {
  write(shell.work() / "fonts.conf", "<fontconfig>" + (folder.empty() ? "" : "<dir>" + folder + "</dir>") +
                                         "<cachedir>" + (shell.work() / "cache").string() + "</cachedir></fontconfig>");
}

const std::string one_case = R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1]})"
                             "\n";
const std::string with_these_fonts = "FONTCONFIG_FILE=$PWD/fonts.conf ";

}  // namespace

TEST_CASE("without fonts nothing is drawn, and the packages to install are named", "[environment]") {
  const Shell shell;
  configure_fonts(shell, "");
  for (const std::string command : {"isect render ray-sphere --step 1", "isect render ray-sphere --format svg",
                                    "isect render ray-sphere --step 1 --format svg --out -",
                                    "isect check ray-sphere --update", "isect show ray-sphere", "isect"}) {
    INFO(command);
    const Ran r = shell(with_these_fonts + command);
    CHECK(r.status == 77);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, Contains("fonts-stix fonts-dejavu-core"));
    CHECK_FALSE(fs::exists(shell.work() / "figures"));
  }
}

TEST_CASE("without fonts everything that is text works as ever", "[environment]") {
  const Shell shell;
  configure_fonts(shell, "");
  write(shell.work() / "case.jsonl", one_case);
  for (const std::string command :
       {"isect list --json", "isect explain ray-sphere", "isect query case.jsonl", "isect --help"}) {
    INFO(command);
    const Ran r = shell(with_these_fonts + command);
    CHECK(r.status == 0);
    CHECK(r.err.empty());
    CHECK(r.out == shell(command).out);
  }
}

TEST_CASE("another font draws, after one word about it, and check names it", "[environment]") {
  const Shell shell;
  const Ran found = shell("dirname \"$(fc-match -f '%{file}' 'DejaVu Sans')\"");
  REQUIRE(found.status == 0);
  configure_fonts(shell, found.out.substr(0, found.out.find('\n')));

  const Ran r = shell(with_these_fonts + "isect render ray-sphere --format svg");
  CHECK(r.status == 0);
  CHECK_THAT(r.err, Contains("DejaVu Serif") && Contains("fonts-stix"));
  CHECK(std::ranges::count(r.err, '\n') == 1);

  shell("isect check ray-sphere --preset miss --update");
  const Ran check = shell(with_these_fonts + "isect check ray-sphere --preset miss");
  CHECK(check.status == 1);
  CHECK_THAT(check.out, Contains("font was STIXGeneral, DejaVu Sans, is DejaVu Serif, DejaVu Sans"));
  CHECK_THAT(shell(with_these_fonts + "isect doctor").out, Contains("apt-get install fonts-stix"));
}

TEST_CASE("doctor's status says whether figures can be drawn, and are the accepted ones", "[environment]") {
  const Shell shell;
  CHECK(shell("isect doctor").status == 0);
  configure_fonts(shell, "");
  const Ran none = shell(with_these_fonts + "isect doctor");
  CHECK(none.status == 77);
  CHECK_THAT(none.out, Contains("none, so no figure") && Contains("fonts-dejavu-core"));
  configure_fonts(shell, "/usr/share/fonts/truetype/dejavu");
  CHECK(shell(with_these_fonts + "isect doctor").status == 1);
  CHECK_THAT(shell("isect doctor --help").out, Contains("77 none can be drawn") && !Contains("--trial"));
  CHECK(shell("GALLIUM_DRIVER=softpipe isect doctor").status == 77);
}

TEST_CASE("vectors that crash Mesa's compiler are refused by name", "[environment]") {
  const Shell shell;
  for (const std::string command :
       {"isect render ray-sphere --step 1", "isect check ray-sphere --preset miss --update=all"})
    for (const std::string backend : {"auto", "osmesa", "egl"}) {
      INFO(command << " " << backend);
      const Ran r = shell("LP_NATIVE_VECTOR_WIDTH=512 " + command + " --backend " + backend);
      CHECK(r.status == 77);
      CHECK_THAT(r.err, Contains("LP_NATIVE_VECTOR_WIDTH=512") && Contains("128 or 256"));
    }
  const Ran doctor = shell("LP_NATIVE_VECTOR_WIDTH=512 isect doctor");
  CHECK(doctor.status == 77);
  CHECK_THAT(doctor.out, Contains("LP_NATIVE_VECTOR_WIDTH=512"));
  for (const std::string width : {"128", "256"})
    CHECK(shell("LP_NATIVE_VECTOR_WIDTH=" + width + " isect render ray-sphere --step 1").status == 0);
}

TEST_CASE("a reader who goes away ends the work, quietly, as it ends other programs", "[environment]") {
  const Shell shell;
  write(shell.work() / "case.jsonl", one_case);
  for (const std::string command :
       {"isect list", "isect explain ray-sphere --step all", "isect query case.jsonl", "isect check --json ray-sphere",
        "isect render ray-sphere --format svg", "isect render ray-sphere --step 1 --format svg --out -", "isect --help",
        "isect doctor", "ray-sphere explain"}) {
    INFO(command);
    // The reader is gone before a word is written.
    const Ran r = shell("{ sleep 0.2; " + command + "; echo $? >status; } | true; cat status");
    CHECK(r.out == "141\n");
    CHECK(r.err.empty());
  }
  shell("isect render ray-sphere --format svg | head -1");
  int figures = 0;
  for (const auto& entry : fs::recursive_directory_iterator(shell.work() / "figures")) {
    const std::string name = entry.path().filename();
    CHECK(name.find(".tmp") == name.npos);
    if (!name.ends_with(".svg")) continue;
    CHECK_THAT(contents(entry.path()), EndsWith("</svg>\n"));
    ++figures;
  }
  CHECK(figures >= 1);
  CHECK(figures < 12);
}

TEST_CASE("a full disk behind standard output is a file that can't be written", "[environment]") {
  const Shell shell;
  write(shell.work() / "case.jsonl", one_case);
  for (const std::string command :
       {"isect list", "isect explain ray-sphere", "isect query case.jsonl",
        "isect check --json ray-sphere --preset miss", "isect render ray-sphere --step 1 --format svg --out -",
        "isect --version", "isect doctor"}) {
    INFO(command);
    const Ran r = shell(command + " >/dev/full");
    CHECK(r.status == 4);
    CHECK_THAT(r.err, Contains("standard output: No space left on device"));
  }
}

#ifndef __SANITIZE_ADDRESS__  // it takes terabytes of addresses, and files and threads at the end
TEST_CASE("little memory is told or is enough, and nothing crashes", "[environment]") {
  const Shell shell;
  write(shell.work() / "case.jsonl", one_case);
  for (const std::string limit : {"200000", "400000", "800000"})
    for (const std::string command :
         {"isect list", "isect explain ray-sphere", "isect query case.jsonl", "isect show ray-sphere",
          "isect render ray-sphere --step 1 --out png", "isect render ray-sphere --step 1 --backend egl --out png",
          "isect render ray-sphere --step 1 --format svg --out svg",
          "isect check ray-sphere --preset miss --update=all", "isect doctor"}) {
      INFO(command << " in " << limit << " KB");
      const Ran r = shell("ulimit -v " + limit + "; " + command);
      CHECK((r.status == 0 || r.status == 3 || r.status == 4 || r.status == 77));
      if (r.status == 4 || r.status == 77) CHECK((r.err + r.out).find("isect") != std::string::npos);
    }
  // The memory that one thread needs is enough, whatever the number of processors.
  const Ran enough = shell("ulimit -v 800000; LP_NUM_THREADS=16 isect render ray-sphere --step 1 --out few");
  INFO(enough.err);
  CHECK(enough.status == 0);
  const Ran little = shell("ulimit -v 400000; isect render ray-sphere --step 1 --out none");
  CHECK(little.status == 77);
  CHECK_THAT(little.err, Contains("too little memory") && Contains("ulimit -v"));
  CHECK_FALSE(fs::exists(shell.work() / "none"));
  shell("isect render ray-sphere --step 1 --out many");
  CHECK(contents(shell.work() / "few/ray-sphere/two-roots/01-to-center.png") ==
        contents(shell.work() / "many/ray-sphere/two-roots/01-to-center.png"));
}

TEST_CASE("a picture too large for the memory is told by name", "[environment]") {
  const Shell shell;
  const Ran r = shell("ulimit -v 900000; isect render ray-sphere --step 1 --size 8192x8192");
  CHECK(r.status == 4);
  CHECK(r.err == "isect: out of memory\n");
}

TEST_CASE("few descriptors, no room for a file, closed streams: an error or nothing, never a crash", "[environment]") {
  const Shell shell;
  const std::string render = "isect render ray-sphere --step 1 --format svg";
  // Files that the test's own caller left open would take the places of 3 and 4.
  const std::string close = "exec 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-; ";
  const Ran descriptors = shell(close + "ulimit -n 5; " + render + " --out few");
  CHECK(descriptors.status == 4);
  CHECK_THAT(descriptors.err, Contains("Too many open files"));

  const Ran size = shell("{ (ulimit -f 0; " + render + " 2>&1; echo $?) | cat; }");
  CHECK_THAT(size.out, Contains("cannot write 'figures") && Contains("File too large") && EndsWith("4\n"));
  CHECK(shell("find figures -type f").out.empty());

  CHECK(shell(render + " --out a 2>&-").status == 0);
  CHECK(shell(render + " --out b <&-").status == 0);
  CHECK(shell(render + " --out c >&-").status == 4);
  CHECK(shell("isect rendr >&- 2>&- <&-").status == 2);
}

TEST_CASE("where threads are refused, drawing is refused in words", "[environment]") {
  const Shell shell;
  // The system counts the threads of ordinary users only, all of them.
  const std::string as_nobody = "setpriv --reuid=65534 --clear-groups bash -c ";
  if (shell(as_nobody + "'ulimit -u 1; isect --version'").status != 0) {
    WARN("this user can't become another one to be limited: not tried");
    return;
  }
  for (const std::string format : {"png", "svg"}) {
    const Ran r =
        shell(as_nobody + "'ulimit -u 2; exec isect render ray-sphere --step 1 --out - --format " + format + "'");
    CHECK(r.status == 77);
    CHECK_THAT(r.err, Contains("too few threads") && Contains("ulimit -u"));
  }
}
#endif

}  // namespace environment_test
