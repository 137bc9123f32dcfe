#include "bench/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

#include "bench/maps.h"
#include "bench/prose.h"
#include "bench/rows.h"
#include "bench/suite_names.h"
#include "viz/formats/files.h"
#include "viz/formats/formats.h"

namespace isect::bench {
namespace {

constexpr double wide = 340;  ///< points: 12 cm, as the text's own width on paper

/// `text` with every match of `pattern` replaced by what `change` makes of it.
template <class Change>
std::string changed(const std::string& text, const std::regex& pattern, const Change& change) {
  std::string out;
  std::size_t from = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    out.append(text, from, static_cast<std::size_t>(it->position()) - from);
    out += change(*it);
    from = static_cast<std::size_t>(it->position() + it->length());
  }
  return out.append(text, from, text.npos);
}

/// Halves the size of a picture: cuts coordinates to an eightieth of a point, and writes each style once.
std::string compact(const std::string& svg) {
  static const std::regex digits(R"((\d+\.\d)\d+)"), places(R"( (d|x|y)="[^"]*")"), styles(R"re(style="([^"]*)")re");
  const std::string rounded =
      changed(svg, places, [](const std::smatch& m) { return std::regex_replace(m.str(), digits, "$1"); });
  std::map<std::string, std::string> classes;
  std::string sheet;
  const std::string styled = changed(rounded, styles, [&](const std::smatch& m) {
    const auto [it, fresh] = classes.try_emplace(m[1].str(), fmt::format("c{}", classes.size()));
    if (fresh) sheet += fmt::format(".{}{{{}}}\n", it->second, it->first);
    return fmt::format("class=\"{}\"", it->second);
  });
  const std::size_t at = styled.find("<defs>");
  return at == styled.npos ? rounded : styled.substr(0, at) + "<style>\n" + sheet + "</style>\n" + styled.substr(at);
}

/// Figures in the order in which the text names them.
class Figures {
 public:
  std::string show(Plotted plot, bool as_pixels = false) {
    const std::string file = plot.name + (as_pixels ? ".png" : ".svg");
    if (!as_pixels) plot.width = wide;
    files.emplace_back(file,
                       as_pixels ? png_of(plot, viz::ThemeName::print) : compact(svg_of(plot, viz::ThemeName::print)));
    std::string alt = plot.alt;
    std::ranges::replace(alt, '[', '(');
    std::ranges::replace(alt, ']', ')');
    return fmt::format("![{}](report/{})\n\nFigure {}. {}\n\n", alt, file, files.size(), plot.caption);
  }
  std::vector<std::pair<std::string, std::string>> files;
};

bool any(const std::vector<const Row*>& rows, bool (*has)(const Row&)) {
  return std::ranges::any_of(rows, [has](const Row* r) { return has(*r); });
}
bool has_value(const Row& r) { return r.ulps.has_value(); }
bool has_distribution(const Row& r) { return !r.quantiles.empty(); }
bool is_wrong(const Row& r) { return r.wrong() > 0; }

const std::string title = "# Speed against error\n";

std::string opening(const Measured& m) {
  return title +
         "\nHow long each test takes, and how often and how far it is wrong: every method, on ordinary input "
         "and on input "
         "made to break it. `isect bench` measures, an exact oracle judges, and this text, its tables and "
         "its figures "
         "are written from the measurements by one command (at the end).\n\n" +
         machine_text(m) + summary_text(m);
}

/// The section that compares the times of other libraries.
std::string ratios(const Measured& m, Figures& figures) {
  if (!m.peers || !has_peers(*m.peers)) return {};
  return "## Beside other libraries\n\n" + figures.show(ratio_plot(*m.peers)) +
         "Shapes are converted before the clock starts. Where a library stores something else than our input, "
         "conversion "
         "rounds: a squared radius and a ray by two points (CGAL, but for EPECK), a capsule by frame and length (FCL), "
         "floats (Bullet, Embree). The verdict is judged against our input all the same, so such errors are the "
         "interface's, not the predicate's. Boost's `within` leaves out the boundary by its contract. CGAL's tests of "
         "rays answer yes or no; the exact call also finds t.\n\n" +
         verdicts_text(*m.peers);
}

std::string reading() {
  return R"(## How to read it

- A time is the median of several passes over distinct random inputs, in nanoseconds a call. [a, b] after it is its 95 % interval, by the bootstrap over the passes. Methods of one family take turns, so that a busy moment of the machine meets them all.
- Latency: the time of a call whose input is not known before the answer of the one before. Otherwise the processor may work on several calls at once (throughput); calls are inlined into one loop.
- A ratio is that of two medians of one run. Its interval is what the ends of theirs allow: the lower end of one by the upper end of the other, and the other way round. Without a name it is to the test's naive method.
- One time is called less than another only if their intervals are apart, and the medians by more than the noise; a choice asks for a tenth, as the next build may place a loop in another way. Noise: how much more the slowest of twelve medians of a fixed loop takes than the fastest, before a suite and after it; a suite that met more than 10 % is measured again.
- What takes less: the best of the inexact methods and, where they were measured, of other libraries. That has the least time; of those that take as little, it is the one least often wrong. None: nothing takes clearly less.
- Ordinary: 65,536 random cases of like sizes, not made to be hard: more than a branch predictor can learn. Of large polygons there are fewer. Hard families: mostly 8,192 cases each, of which it may learn some; so compare times within a family only.
- The exact call is `intersects(a, b)`; for rays `intersect(ray, shape)`, which also finds t (yes or no: `intersects`); for relations `relate(a, b)`; for points in polygons `locate`. Batch: the same for many shapes at once. Grid, slabs, trapezoids: a polygon prepared for many points. Polygons have the number of vertices n that is named; without one point-polygon has 100, convex-polygon 64, point-location 256.
- The oracle: rational numbers (GMP) and roots of 400 digits (MPFR), which share no arithmetic with the library.
- A verdict is wrong if it differs from the true one for the numbers as given. Never wrong: in all cases judged, those of the hard families included. Not asked: families that would stop the library's program, or that it does not allow.
- Called on, wrong side: where an answer is a sign or a location, "on" (zero) for what lies on a side; and a side for what lies on the other one or on. They add up to all wrong verdicts. A method that answers yes or no never answers "on".
- The error of a value is counted in units in the last place (ulp) of the true value, where the verdict is right: half the cases lie below the median, all but one in a hundred below the 99th percentile. An error of n ulp loses about log2(1 + n) bits.
- Like boxes are all of one size; of heavy-tailed ones a few are much larger. A smooth polygon has five waves, a spiky one a random radius at each vertex. A hierarchy is a tree of boxes. u is 2^-53, half the distance from 1 to the next double.
- In a figure, down is more accurate and left takes less time. A method is on the front if no other is both at least as fast and at least as accurate. What lies on the tinted side is beaten.
- Growth: processor time of one thread, the least of a few passes at each size, from the run beside other libraries where there is one; all pairs and Embree in float. So these times are not to be compared with the medians above. A power of n is fitted to three sizes or more; it tells the sizes shown, not the complexity.

)";
}

std::string families(const Report& report) {
  std::string text = "### The hard families\n\n";
  std::string last;
  std::set<std::string> told;
  for (const Row& r : report.rows) {
    const std::string base = r.test.substr(0, r.test.find_first_of(" ,"));  // variants have the same families
    if (!r.hard || !told.insert(base + '/' + r.family).second) continue;
    const std::string note = report.note(r.test, r.family);
    if (note.empty()) continue;
    if (base != last) text += (last.empty() ? "" : "\n") + sentence(base) + ":\n\n";
    last = base;
    text += fmt::format("- {}: {}\n", words(r.family), note);
  }
  return last.empty() ? "" : text + '\n';
}

std::string tests(const Measured& m, Figures& figures) {
  std::string text = "## Test by test\n\n";
  for (const std::string& test : tests_of(m.portable)) {
    const std::string told = test_text(m, test);
    if (told.empty()) continue;
    text += fmt::format("### {}\n\n{}", sentence(test), told);
    const std::vector<const Row*> rows = rows_of(m.portable, test, "double");
    if (families_of(rows).size() < 2 || test.find(',') != std::string::npos) continue;  // a variant has its table only
    if (any(rows, has_value)) text += figures.show(error_plot(m.portable, test, "double"));
    if (any(rows, is_wrong)) text += figures.show(verdict_plot(m.portable, test, "double"));
    if (test == "ray-sphere" && any(rows, has_distribution))
      text += figures.show(distribution_plot(m.portable, test, "double"));
  }
  return text;
}

std::string growths(const Report& report, Figures& figures) {
  std::string text;
  std::set<std::pair<std::string, std::string>> told;
  for (const Growth& g : report.growths) {
    if (!told.insert({g.test, g.unit}).second) continue;
    if (text.empty()) text = "## As the number of elements grows\n\n";
    std::vector<const Growth*> all;
    for (const Growth& other : report.growths)
      if (other.test == g.test && other.unit == g.unit && !other.n.empty()) all.push_back(&other);
    std::vector<std::string> parts;
    for (const Growth* other : all)
      if (other->power()) parts.push_back(fmt::format("{} as n^{:.2f}", name_of(*other), *other->power()));
    if (parts.empty()) parts.emplace_back("too few sizes for a power of n");
    const std::string unit = g.test.find(g.unit) == std::string::npos ? ", " + g.unit : "";
    text += fmt::format("{}{}: {}.\n\n", sentence(g.test), unit, listed(parts));
    text += figures.show(growth_plot(report, g.test, g.unit));
  }
  return text;
}

std::string pictures(Figures& figures) {
  std::string text =
      "## Where naive verdicts fall\n\n"
      "Each cell of a map is one floating-point neighbour of a point. Yellow and violet cells are wrong verdicts. "
      "These "
      "figures are computed, not measured: they are the same on every machine that rounds as IEEE 754 asks.\n\n";
  for (Plotted& map : maps()) {
    const bool cells = std::holds_alternative<viz::Maps>(map.chart.kind);
    text += figures.show(std::move(map), cells);
  }
  return text;
}

std::string duties(const Report& report, Figures& figures) {
  if (report.duties.empty()) return {};
  std::string text = "## Starting and drawing\n\n| what | measured | target |\n| --- | --- | --- |\n";
  bool targets = false;
  for (const Duty& d : report.duties) {
    targets = targets || d.target;
    text += fmt::format(
        "| {} | {} {} | {} |\n", d.what, number(d.value), d.unit,
        d.target ? fmt::format("{} {} {}", d.unit == "frames/s" ? "at least" : "at most", number(*d.target), d.unit)
                 : "");
  }
  return text + '\n' + (targets ? figures.show(duty_plot(report)) : "");
}

std::string ending() {
  return R"(## How to make this report again

On an idle machine, with every change committed, from the root of the repository:

```
cmake --preset release -DISECT_PEERS=ON && cmake --build --preset release --target isect measure measure_native measure_peers
build/release/bin/isect bench --publish bench
```

It measures three times: for any machine of the kind, for this machine's own instructions, and beside the other libraries that are installed. The last two are left out if their programs were not built. `--json FILE` keeps a run, `--publish bench --from FILE --from FILE` writes the report from runs that were kept. Quick runs, noisy ones, and builds of changed sources or of different commits are not published. Times differ from machine to machine. The verdicts and errors of isect do not; those of long double, of hypot and of other libraries may.
)";
}

// A file may be overwritten or removed only if it was published before.

[[noreturn]] void not_ours(const std::string& file) {
  throw viz::FileError("cannot write '" + file + "': the file there was not published by isect; move it away");
}
bool is_text_of_ours(const std::string& file) {
  return !viz::is_there(file) || viz::read_regular_file(file).starts_with(title);
}
bool are_results_of_ours(const std::string& file) try {
  if (viz::is_there(file)) report_of(viz::read_regular_file(file));
  return true;
} catch (const std::runtime_error&) {
  return false;
}
bool is_figure_of_ours(const std::filesystem::path& file) try {
  const viz::Format* format = viz::format_of(file);
  if (!format || std::filesystem::is_symlink(file)) return false;
  const viz::Metadata data = format->metadata(viz::read_regular_file(file));
  return data.contains("figure") && data.at("figure") == file.stem();
} catch (const viz::FileError&) {
  return false;
}

/// The names of all tests with rows or growths.
std::set<std::string> all_tests(const Report& r) {
  const std::vector<std::string> tests = tests_of(r);
  std::set<std::string> all(tests.begin(), tests.end());
  for (const Growth& g : r.growths) all.insert(g.test);
  return all;
}

/// The index of the suite with whose name the report's first test begins; behind all suites if there is none.
std::ptrdiff_t place_of(const Report& r) {
  const std::vector<std::string>& suites = suite_names();
  const auto begins = [&](const std::string& suite) { return !r.rows.empty() && r.rows[0].test.starts_with(suite); };
  return std::ranges::find_if(suites, begins) - suites.begin();
}

}  // namespace

Measured measured_of(std::vector<Report> reports) {
  std::ranges::stable_sort(reports, {}, place_of);
  std::map<std::string, Report> builds;
  for (Report& r : reports) {
    const std::string build = r.machine.build;
    const auto [place, first] = builds.try_emplace(build, r);
    if (first) continue;
    const std::set<std::string> known = all_tests(place->second);
    for (const std::string& test : all_tests(r))
      if (known.contains(test))
        throw std::runtime_error(fmt::format("two reports of the {} build have {}", build, test));
    place->second.add(std::move(r));
  }
  const auto taken = [&](const char* build) -> std::optional<Report> {
    const auto place = builds.find(build);
    return place == builds.end() ? std::nullopt : std::optional(std::move(place->second));
  };
  std::optional<Report> portable = taken("portable");
  if (!portable) throw std::runtime_error("none of the reports is of the portable build");
  for (const auto& [build, r] : builds)
    if (build != "portable" && build != "native" && build != "peers")
      throw std::runtime_error(
          fmt::format("a report is of the build \"{}\"; known are portable, native and peers", build));
  return {std::move(*portable), taken("native"), taken("peers")};
}

Publication publication(const Measured& m, const std::optional<Proof>& proof) {
  Figures figures;
  Report growing = m.peers ? *m.peers : m.portable;
  const std::vector<Growth> beside_others = growing.growths;
  for (const Growth& g : m.portable.growths)  // of what was not measured beside other libraries
    if (std::ranges::none_of(beside_others, [&](const Growth& o) { return o.test == g.test && o.unit == g.unit; }))
      growing.growths.push_back(g);
  std::string text = opening(m);
  text += ratios(m, figures);
  text += tests(m, figures);
  text += growths(growing, figures);
  text += pictures(figures);
  text += duties(m.portable, figures);
  text +=
      target_text(m) + loss_text(m) + (proof ? proof_text(*proof) : "") + reading() + families(m.portable) + ending();
  return {text, std::move(figures.files)};
}

Report lesson_excerpt(const Report& report) {
  const std::set<std::string> tests = {"ray-sphere",  "sphere-sphere", "orient2d",    "point-polygon",
                                       "sphere-aabb", "obb-obb",       "ray-triangle"};
  Report excerpt = {report.machine, report.seed, report.quick};
  for (Row r : report.rows) {
    if (!tests.contains(r.test) || (r.scalar != "double" && r.test != "ray-sphere")) continue;
    r.first_wrong.clear(), r.quantiles.clear();
    r.conditioned.reset(), r.residual.reset(), r.latency.reset(), r.sides.reset();
    excerpt.rows.push_back(std::move(r));
  }
  for (const Note& n : report.notes)
    if (tests.contains(n.test)) excerpt.notes.push_back(n);
  return excerpt;
}

void require_quiet(const Machine& m) {
  if (m.noise > most_noise)
    throw std::runtime_error(
        fmt::format("the {} build was measured at {:.0f} % noise; at most {:.0f} % makes a report: "
                    "measure on an idle machine",
                    m.build, 100 * m.noise, 100 * most_noise));
}

void require_one_commit(const std::vector<Machine>& builds) {
  for (const Machine& m : builds) {
    if (commits(m).size() > 1)
      throw std::runtime_error(
          fmt::format("the programs of the {} build come from several commits ({}): build all of them "
                      "again",
                      m.build, m.commit));
    if (m.commit.ends_with("-dirty"))
      throw std::runtime_error(
          fmt::format("the {} build has changes that no commit has ({}): commit them, then build and measure again",
                      m.build, m.commit));
  }
  const auto known = [](const Machine& m) { return m.commit.empty() ? "an unknown commit" : m.commit; };
  for (const Machine& m : builds)
    if (m.commit != builds.front().commit)
      throw std::runtime_error(
          fmt::format("the builds come from different commits, {} from {} and {} from {}: measure "
                      "them again",
                      builds.front().build, known(builds.front()), m.build, known(m)));
}

void require_publishable(const Measured& m) {
  std::vector<const Report*> all = {&m.portable};
  for (const std::optional<Report>* other : {&m.native, &m.peers})
    if (*other) all.push_back(&**other);
  std::vector<Machine> builds;
  for (const Report* r : all) {
    require_quiet(r->machine);
    if (r->quick)
      throw std::runtime_error(
          fmt::format("the run of the {} build was quick, with few passes and few cases judged: "
                      "measure it without --quick",
                      r->machine.build));
    builds.push_back(r->machine);
  }
  require_one_commit(builds);
}

void publish(const Measured& m, const std::string& folder) {
  require_publishable(m);
  const std::string pictures = folder + "/report", results = folder + "/results.json", text = folder + "/REPORT.md";
  if (!are_results_of_ours(results)) not_ours(results);
  if (!is_text_of_ours(text)) not_ours(text);
  std::optional<Proof> proof;
  if (const std::string file = folder + "/proof.json"; viz::is_there(file)) proof = proof_of(viz::read_file(file));
  const Publication p = publication(m, proof);
  std::set<std::string> named;
  for (const auto& [name, bytes] : p.files) {
    const std::string file = pictures + '/' + name;
    if (viz::is_there(file) && !is_figure_of_ours(file)) not_ours(file);
    viz::write_file(file, bytes);
    named.insert(name);
  }
  for (const auto& entry : std::filesystem::directory_iterator(pictures))  // figures of an earlier report
    if (!named.contains(entry.path().filename()) && is_figure_of_ours(entry.path()))
      std::filesystem::remove(entry.path());
  viz::write_file(results, json(lesson_excerpt(m.portable)));
  viz::write_file(text, p.text);
}

}  // namespace isect::bench
