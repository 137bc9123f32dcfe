#include "app/pages/latex_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "app/pages/latex.h"
#include "app/shell/subprocess.h"
#include "viz/gl/offscreen.h"

namespace isect::program {

namespace {

constexpr int most_seconds = 120;  ///< of one run: a deck of a whole lesson takes some 5
constexpr int most_runs = 3;

bool is_in_path(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/" + name).c_str(), X_OK) == 0) return true;
  return false;
}

std::string engine_here() {
  for (const char* name : {"lualatex", "pdflatex"})
    if (is_in_path(name)) return name;
  throw viz::NoBackend(
      "format: pdf is made by LaTeX, which is not here; on Debian: apt-get install texlive-luatex "
      "texlive-latex-recommended texlive-pictures; or give --format tex");
}

/// Returns the place and message of a line of the log, "./handout.tex:12: Undefined control sequence."; empty if it is
/// no error.
std::string error_in(const std::string& line) {
  if (line.starts_with("! ")) return line.substr(2);
  for (std::size_t colon = line.find(':'); colon != line.npos; colon = line.find(':', colon + 1)) {
    const std::size_t stop = line.find_first_not_of("0123456789", colon + 1);
    if (stop == line.npos || stop == colon + 1 || line.compare(stop, 2, ": ") != 0) continue;
    const std::string file = line.substr(line.starts_with("./") ? 2 : 0, colon - (line.starts_with("./") ? 2 : 0));
    return fmt::format("{}, line {}: {}", file, line.substr(colon + 1, stop - colon - 1), line.substr(stop + 2));
  }
  return {};
}

}  // namespace

std::string first_latex_error(const std::string& log) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (std::string error = error_in(line); !error.empty()) {
      const bool missing = error.find(".sty' not found") != error.npos || error.find(".cls' not found") != error.npos;
      if (missing) error += " On Debian: apt-get install texlive-latex-recommended texlive-latex-extra";
      return error;
    }
  return {};
}

struct LatexRun::Outcome {
  bool done = false;
  std::string log;
  std::string trouble;  ///< why not
};

LatexRun::LatexRun(const std::string& kind) : kind_(kind), engine_(engine_here()) {}

void LatexRun::add(const std::string& file, const std::string& bytes) const {
  viz::write_file(folder_.path() + "/" + file, bytes);
}

LatexRun::Outcome LatexRun::compile(bool tags) const {
  // In its folder, with bounded files, and no terminal to ask on. The log has no broken lines.
  const std::string alone = "cd \"$1\" && ulimit -f 400000 && shift && exec \"$@\" </dev/null";
  const std::vector<std::string> command = {
      "sh",
      "-c",
      alone,
      "sh",
      folder_.path(),
      "env",
      "max_print_line=2000",
      "timeout",
      "--foreground",
      "-k",
      "5",
      std::to_string(most_seconds),
      engine_,
      "-no-shell-escape",
      "-interaction=batchmode",
      "-halt-on-error",
      "-file-line-error",
      "-jobname=" + kind_,
      fmt::format("{}\\input{{{}.tex}}", tags ? "" : "\\def\\isectuntagged{}", kind_)};
  const std::string log = folder_.path() + "/" + kind_ + ".log";
  Outcome made;
  for (int run = 1; run <= most_runs; ++run) {
    const CompletedProcess process = run_subprocess(command, [](const std::string&) {});
    made.log = viz::is_there(log) ? viz::read_regular_file(log) : std::string();
    made.done = process.status == 0;
    if (!made.done) {
      const bool late = process.status == 124 || process.status == 137;
      made.trouble = late ? fmt::format("it took more than {} s", most_seconds) : first_latex_error(made.log);
      if (made.trouble.empty()) made.trouble = fmt::format("it ended with status {} and told no error", process.status);
      return made;
    }
    if (run > 1 && made.log.find("Rerun to get") == made.log.npos) return made;
  }
  return made;
}

LatexPdf LatexRun::run(const std::string& page) const {
  add(kind_ + ".tex", page);
  LatexPdf pdf;
  pdf.engine = engine_;
  Outcome made = compile(true);
  if (!made.done && engine_ == "lualatex" && page.find(untagged_macro) != page.npos) {
    pdf.untagged_because = made.trouble;
    for (const char* ending : {".aux", ".log", ".out", ".pdf"})  // none of the failed run's
      std::filesystem::remove(folder_.path() + "/" + kind_ + ending);
    made = compile(false);
  }
  if (!made.done)
    throw viz::FileError(fmt::format("cannot write '{0}.pdf': {1} stopped: {2} (--format {3} writes {0}.tex itself)",
                                     kind_, engine_, made.trouble, kind_ == "quiz" ? "paper" : "tex"));
  pdf.tagged = made.log.find(tagged_note) != made.log.npos;
  pdf.bytes = viz::read_file(folder_.path() + "/" + kind_ + ".pdf");
  return pdf;
}

}  // namespace isect::program
