// A table of faults: what the program says, how it ends, and what lies on disk afterwards.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/files.h"

namespace faults_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;

namespace {

struct Fault {
  std::string name;
  std::string before;   ///< makes the fault, in the shell
  std::string command;  ///< the command that meets the fault
  int status;
  std::string says;   ///< on stdout or stderr
  std::string after;  ///< what must be true of the disk then, in the shell
};

/// A command that checks that every figure and list below `folder` is whole.
std::string all_whole(const std::string& folder) {
  return "! find " + folder + " -name '*.tmp-*' | grep . && for f in $(find " + folder +
         " -name '*.svg'); do tail -c 7 $f | grep -q '</svg>' || exit 1; done";
}

const std::string svg = "isect render ray-sphere --format svg --out disk";
const std::string accept = "isect check intervals --preset touching --snapshots disk --update";
const std::string check = "isect check intervals --preset touching --snapshots disk";
const std::string picture = "disk/intervals/touching/04-relation.png",
                  text = "disk/ray-sphere/two-roots/01-to-center.txt";
const std::string at_once = "timeout 60 ";  ///< ends a command that would wait for ever, with another status
const std::string a_state = R"(printf '{"lesson": "intervals"}' >preset.json)";

const std::vector<Fault> full_or_closed = {
    {"a full disk, under figures", "mount -t tmpfs -o size=64k none disk", svg, 4, "No space left on device",
     all_whole("disk")},
    {"a full disk, under baselines", "mount -t tmpfs -o size=16k none disk", accept, 4, "No space left on device",
     all_whole("disk")},
    {"a full disk, under a report", "mount -t tmpfs -o size=4k none disk; head -c 4096 /dev/zero >disk/full",
     "isect check ray-sphere --preset miss --report disk/r.html", 4, "No space left on device",
     "test $(ls disk) = full"},
    {"a read-only disk, under figures", "mount -t tmpfs -o ro none disk", svg, 4, "Read-only file system",
     "! ls disk | grep ."},
    {"a read-only disk, under baselines", "mount -t tmpfs -o ro none disk", accept, 4, "Read-only file system",
     "! ls disk | grep ."},
    {"a limit on a file's size", "ulimit -f 8", svg, 4, "File too large", all_whole("disk")},
    {"a file where a folder should be", "rmdir disk; echo mine >disk", svg, 4, "disk", "test $(cat disk) = mine"},
    {"a folder where a figure should be", "mkdir -p disk/ray-sphere/two-roots/01-to-center.svg", svg, 4,
     "01-to-center.svg", "test -d disk/ray-sphere/two-roots/01-to-center.svg"},
    {"a device that is full", "", "isect render ray-sphere --step 1 --format svg --out - >/dev/full", 4,
     "standard output", "test -c /dev/full"},
};

/// Sets $user to run commands as a user bound by permissions: as nobody, where the tests run as root.
const std::string as_user =
    "test $(id -u) != 0 || user='setpriv --reuid=65534 --regid=65534 --clear-groups'; chmod 755 . ..; ";

const std::vector<Fault> forbidden = {
    {"a folder without write permission, under figures", as_user + "chmod 555 disk", "$user " + svg, 4,
     "Permission denied", "! ls disk | grep ."},
    {"a folder without write permission, under baselines", as_user + "chmod 555 disk", "$user " + accept, 4,
     "Permission denied", "! ls disk | grep ."},
    {"a file without read permission", as_user + a_state + "; chmod 0 preset.json",
     "$user isect render --preset preset.json", 4, "preset.json': Permission denied", "test ! -e figures"},
};

const std::vector<Fault> surroundings = {
    {"no HOME", "unset HOME XDG_CACHE_HOME XDG_STATE_HOME", svg, 0, "01-to-center.svg", all_whole("disk")},
    {"a HOME that is not there", "export HOME=/nowhere", svg, 0, "01-to-center.svg", all_whole("disk")},
    {"a HOME that can't be written", "mkdir home; mount -t tmpfs -o ro none home; export HOME=$PWD/home",
     "isect render ray-sphere --step 1 --out disk", 0, "01-to-center.png", all_whole("disk")},
    {"no TMPDIR", "export TMPDIR=/nowhere", svg, 0, "01-to-center.svg", all_whole("disk")},
    {"an odd locale", "export LC_ALL=xx_YY.ISO-8859-9 LANG=tr_TR", svg, 0, "01-to-center.svg",
     "isect render ray-sphere --format svg --out usual >/dev/null && diff -r disk usual"},
    {"two at once, into one folder", "", "isect render intervals --format svg --out disk & " + svg + "; wait", 0,
     "01-to-center.svg",
     all_whole("disk") + " && test $(find disk -name '*.svg' | wc -l) = $(grep -c '\"file\"' disk/manifest.json)"},
    {"two at once, accepting the same", "", accept + " & " + accept + "; wait", 0, "", check},
};

const std::string state_home = "export XDG_STATE_HOME=$PWD/state; mkdir -p state/isect; ";

const std::vector<Fault> damaged = {
    {"a preset cut short", a_state + "; truncate -s 9 preset.json", "isect render --preset preset.json", 2,
     "preset.json: ", "test ! -e figures"},
    {"a preset that is empty", ">preset.json", "isect render --preset preset.json", 2,
     "preset.json: ", "test ! -e figures"},
    {"a preset of bytes", "printf '\\377\\0\\1' >preset.json", "isect render --preset preset.json", 2,
     "preset.json: ", "test ! -e figures"},
    {"a preset nested without end", "for i in $(seq 2000); do printf '%0100d' 0; done | tr 0 '[' >preset.json",
     "isect render --preset preset.json", 2, "preset.json: ", "test ! -e figures"},
    {"a preset nested deeply",
     "{ printf '{\"lesson\": '; seq 100000 | sed 's/.*/[/'; seq 100000 | sed 's/.*/]/'; printf '}'; } "
     ">preset.json",
     "isect render --preset preset.json", 2, "preset.json: ", "test ! -e figures"},
    {"a preset of another program", "echo '{\"name\": \"left-pad\"}' >preset.json", "isect render --preset preset.json",
     2, "preset.json: ", "test ! -e figures"},
    {"a preset that is a folder", "mkdir preset.json", "isect render --preset preset.json", 4, "preset.json",
     "test -d preset.json"},
    {"a trace cut short", accept + "; truncate -s 99 disk/intervals/touching/trace.json", check, 1, "damaged",
     "test $(wc -c <disk/intervals/touching/trace.json) = 99"},
    {"a baseline cut short", accept + "; for f in disk/intervals/touching/*.png; do truncate -s 999 $f; done", check, 1,
     "broken PNG", "cat disk/intervals/touching/0?-*[a-z].png >/dev/null"},
    {"a baseline that is empty", accept + "; for f in disk/intervals/touching/*.png; do : >$f; done", check, 1,
     "not a PNG file", "ls disk/intervals/touching/*.png"},
    {"a baseline that is a text", accept + "; for f in disk/intervals/touching/*.png; do echo mine >$f; done", check, 1,
     "not a PNG file", "grep -l mine disk/intervals/touching/*.png"},
    {"a manifest that is damaged", svg + "; truncate -s 99 disk/manifest.json", svg, 4, "manifest.json",
     "test $(wc -c <disk/manifest.json) = 99 && " + all_whole("disk")},
    {"a window's state that is damaged", state_home + "echo '{\"place\": [' >state/isect/window.json", "isect", 77,
     "display", "grep place state/isect/window.json"},
    {"a bench result cut short", "echo '{\"cases\": [' >r.json", "isect bench --from r.json", 2,
     "r.json: ", "test -s r.json"},
    {"a bench result of another program", "echo '[1, 2]' >r.json", "isect bench --from r.json", 2,
     "r.json: ", "test -s r.json"},
    {"a bench result that is a folder", "mkdir r.json", "isect bench --from r.json", 4, "r.json", "test -d r.json"},
    {"cases of a query that are a folder", "mkdir cases", "isect query cases", 4, "Is a directory", "test -d cases"},
    {"cases of a query that are bytes", "head -c 99 /dev/zero >cases", "isect query cases", 1, "error",
     "test -s cases"},
    {"a figure cut short",
     "isect render ray-sphere --step 1 --out disk; truncate -s 99 disk/ray-sphere/two-roots/01*.png",
     "isect show disk/ray-sphere/two-roots/01-to-center.png", 4, "broken PNG", "test -e disk"},
    {"a figure that is enormous", "truncate -s 9G big.svg", "isect show big.svg", 4, "File too large",
     "test -e big.svg"},
    {"a figure without end", "ln -s /dev/zero big.png", "isect show big.png", 4, "File too large", "test -c /dev/zero"},
    {"a figure of another program", "echo '<svg xmlns=\"http://www.w3.org/2000/svg\"/>' >o.svg", "isect show o.svg", 2,
     "o.svg: it carries no isect metadata", "test -s o.svg"},
    {"a pipe in the place of a trace", accept + "; cd disk/intervals/touching; rm trace.json; mkfifo trace.json; cd -",
     at_once + check, 1, "trace.json': not a regular file", "test -p disk/intervals/touching/trace.json"},
    {"a device in the place of a trace", accept + "; ln -sf /dev/zero disk/intervals/touching/trace.json",
     at_once + check + " --update=all", 1, "trace.json': not a regular file",
     "test -c disk/intervals/touching/trace.json"},
    {"a pipe in the place of a baseline", accept + "; rm " + picture + "; mkfifo " + picture, at_once + check, 1,
     "png': not a regular file", "test -p " + picture},
    {"a link to itself in the place of a baseline", accept + "; ln -sf 04-relation.png " + picture, check, 1,
     "unreadable: cannot read 'disk/intervals/touching/04-relation.png'", "test -h " + picture},
    {"a pipe in the place of an alt text",
     svg + "; rm " + text + "; mkfifo " + text + "; timeout 60 cat " + text + " >disk/copy &",
     at_once + svg + " && wait", 0, "01-to-center.svg", "test -p " + text + " && grep -q sphere disk/copy"},
    {"a pipe in the place of a manifest", "mkfifo disk/manifest.json", at_once + svg, 4,
     "disk/manifest.json': not a regular file", "test -p disk/manifest.json"},
    {"a manifest whose alt text is a number",
     "echo '{\"program\": \"isect\", \"figures\": [{\"file\": \"ray-sphere/two-roots/01-to-center.svg\", \"alt\": "
     "3}]}' "
     ">disk/manifest.json",
     svg, 4, "disk/manifest.json': the file there was not made by isect", "grep -q 3 disk/manifest.json"},
    {"figures go to a link to itself", "rmdir disk; ln -s disk disk", svg, 4,
     "isect: cannot read 'disk/manifest.json': Too many levels of symbolic links", "test -h disk"},
    {"a pipe among presets", "mkfifo disk/a.json", at_once + "isect check --dir disk", 2,
     "disk/a.json': not a regular file", "test -p disk/a.json"},
    {"a link to itself among presets", "ln -s a.json disk/a.json", "isect render --dir disk", 2,
     "disk/a.json': Too many levels of symbolic links", "test -h disk/a.json"},
    {"a preset through a pipe", "", "echo '{\"lesson\": \"intervals\"}' | isect explain --preset /dev/stdin", 0,
     "Interval and interval", "test ! -e figures"},
    {"a preset that says one thing twice", "echo '{\"lesson\": \"rays\", \"lesson\": \"intervals\"}' >preset.json",
     "isect render --preset preset.json", 2, "preset.json: the state: \"lesson\" is given twice", "test ! -e figures"},
    {"a preset with something behind a NUL byte", "printf '{\"lesson\": \"intervals\"}\\0, or not' >preset.json",
     "isect render --preset preset.json", 2, "preset.json: the state: not JSON; there is a NUL byte in it",
     "test ! -e figures"},
    {"a preset without end", "", at_once + "isect render --preset /dev/zero", 4, "/dev/zero': File too large",
     "test ! -e figures"},
    {"a bench result without end", "", at_once + "isect bench --from /dev/zero", 4, "/dev/zero': File too large",
     "test -c /dev/zero"},
    {"a figure that is hostile",
     "{ printf '<!DOCTYPE s [<!ENTITY a \"ha\">'; for i in $(seq 30); do printf '<!ENTITY a%d "
     "\"&a%d;&a%d;\">' $i "
     "$((i-1)) $((i-1)); done; printf ']><svg>&a30;</svg>'; } | sed 's/a0;/a;/g' >o.svg",
     "isect show o.svg", 4, "broken SVG", "test -s o.svg"},
};

/// How a user who may not mount can do so: as root of a namespace of its own.
std::string in_own_mounts(const Shell& shell) {
  for (const std::string unshare : {"unshare -m", "unshare -rm"})
    if (shell(unshare + " mount -t tmpfs none /tmp").status == 0) return unshare + " ";
  return {};
}

void meet(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    INFO(fault.name << ": " << fault.command);
    const Shell shell;
    const std::string unshare = in_own_mounts(shell);
    const bool mounts = fault.before.find("mount ") != std::string::npos;
    if (mounts && unshare.empty()) {
      WARN(fault.name << ": not tried, for no file system can be mounted here");
      continue;
    }
    write(shell.work() / "row.sh", "mkdir disk\n{ :\n" + fault.before + "\n} >before\n{ " + fault.command +
                                       "\n} >out 2>&1\nstatus=$?\n" + "( " + fault.after +
                                       " ) >&2 || echo 'the disk is not as it should be'\n" + "exit $status\n");
    const Ran r = shell((mounts ? unshare : "") + "sh row.sh");
    const std::string said = contents(shell.work() / "out");
    INFO(said);
    INFO(r.err);
    CHECK(r.status == fault.status);
    CHECK_THAT(said, Contains(fault.says));
    CHECK(r.out.empty());
  }
}

}  // namespace

TEST_CASE("faults of the disk are told, and leave every file whole", "[faults]") { meet(full_or_closed); }

TEST_CASE("what may not be written or read is told", "[faults]") {
  if (Shell()(as_user + "$user isect --version").status != 0)
    WARN("not tried: the tests run as root, and nobody may not run isect or setpriv is missing");
  else
    meet(forbidden);
}

TEST_CASE("odd surroundings change nothing", "[faults]") { meet(surroundings); }

TEST_CASE("damaged files are named, and stay as they are", "[faults]") { meet(damaged); }

}  // namespace faults_test
