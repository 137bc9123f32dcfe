// The folder of figures: what a render adds to it, lists in it and takes away, and what it never touches.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/files.h"

namespace figure_folder_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::StartsWith;

TEST_CASE("figures of a changed setting have a folder of their own, named after the change", "[render]") {
  const Shell shell;
  const std::string render = "isect render ray-sphere --step 1 --format svg ";
  const auto folder = [&](const std::string& changes) {
    const Ran r = shell(render + changes);
    CHECK(r.status == 0);
    return fs::path(r.out).parent_path().filename().string();
  };
  CHECK(folder("--set radius=1.25 --set origin=-4,1,0") == "two-roots+origin=-4,1,0+radius=1.25");
  CHECK(folder("--set origin=-4.0,1,0 --set radius=3 --set radius=1.250") == "two-roots+origin=-4,1,0+radius=1.25");
  CHECK(folder("--set radius=1.5234375") == "two-roots");  // as it is
  const std::string extremes = "--set origin=-1.2345678901e-200,2,3 --set direction=1,2,3.000000000001 --set t_max=";
  const std::string a = folder(extremes + "7.000000000001"), b = folder(extremes + "7.000000000002");
  CHECK(a != b);
  CHECK(a.size() <= 100);
  CHECK_THAT(a, StartsWith("two-roots+direction=1,2,3.000000000001+origin="));
}

TEST_CASE("a setting of fewer steps leaves no figures of the longer one behind", "[render]") {
  const Shell shell;
  const auto folder = shell.work() / "figures/ray-sphere/mine";
  const auto stems = [&] {
    std::vector<std::string> names = files_in(folder);
    return std::ranges::count_if(names, [](const std::string& n) { return n.ends_with(".svg"); });
  };
  const auto set = [&](const std::string& preset) {
    write(shell.work() / "mine.json", R"({"lesson": "ray-sphere", "preset": ")" + preset + "\"}");
  };
  set("two-roots");
  REQUIRE(shell("isect render --preset mine.json --format svg").status == 0);
  REQUIRE(shell("isect render --preset mine.json --step 12 --format png").status == 0);
  REQUIRE(stems() == 13);
  // Files that a user put there: a picture, a note, a copy with its metadata, a link.
  write(folder / "14-photo.png", viz::png({1, 1, {1, 2, 3, 255}}));
  write(folder / "12-note.txt", "mine");
  fs::copy_file(folder / "11-intersect.svg", folder / "11-intersect-annotated.svg");
  fs::create_symlink("11-intersect.svg", folder / "14-link.svg");

  set("miss");
  const Ran r = shell("isect render --preset mine.json --format svg");
  CHECK(r.status == 0);
  CHECK_THAT(r.err, Contains("removed ") && Contains("ray-sphere/mine"));
  const auto left = files_in(folder);
  const auto has = [&](const std::string& name) { return std::ranges::find(left, name) != left.end(); };
  for (const std::string name : {"14-photo.png", "12-note.txt", "11-intersect-annotated.svg"}) CHECK(has(name));
  CHECK(fs::is_symlink(folder / "14-link.svg"));
  CHECK_FALSE(has("11-intersect.svg"));
  CHECK_FALSE(has("11-intersect.txt"));
  CHECK_FALSE(has("12-cases.png"));
  const auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  for (const auto& figure : manifest["figures"])
    CHECK(fs::exists(shell.work() / "figures" / figure["file"].get<std::string>()));
  CHECK(shell("isect render --preset mine.json --format svg").err.empty());
}

TEST_CASE("an alt text that someone has edited is neither written over nor removed", "[render]") {
  const Shell shell;
  const auto folder = shell.work() / "figures/ray-sphere/mine";
  const auto render = [&](const std::string& preset) {
    write(shell.work() / "mine.json", R"({"lesson": "ray-sphere", "preset": ")" + preset + "\"}");
    return shell("isect render --preset mine.json --format svg");
  };
  REQUIRE(render("two-roots").err.empty());
  write(folder / "01-to-center.txt", "My own words.");
  write(folder / "11-intersect.txt", "Where they meet.");

  const Ran r = render("miss");  // its first step says something else, and it has no eleventh one
  CHECK(r.status == 0);
  for (const std::string name : {"01-to-center.txt", "11-intersect.txt"})
    CHECK_THAT(r.err, Contains("left alone: figures/ray-sphere/mine/" + name));
  CHECK(contents(folder / "01-to-center.txt") == "My own words.");
  CHECK(contents(folder / "11-intersect.txt") == "Where they meet.");
  CHECK_FALSE(fs::exists(folder / "11-intersect.svg"));
  CHECK_THAT(contents(folder / "07-reject.txt"), Contains("Verdict"));
}

TEST_CASE("the manifest lists what is in the folder, from whichever run", "[render]") {
  const Shell shell;
  const auto listed = [&] {
    std::vector<std::string> files;
    const auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
    for (const auto& figure : manifest["figures"]) files.push_back(figure["file"]);
    return files;
  };
  const std::string render = "isect render ray-sphere --format svg ";
  REQUIRE(shell(render + "--preset two-roots --step 2").status == 0);
  REQUIRE(shell(render + "--preset miss --step 1").status == 0);
  REQUIRE(shell(render + "--preset two-roots --step 1 --theme dark").status == 0);
  const std::vector<std::string> all = {"ray-sphere/miss/01-to-center.svg", "ray-sphere/two-roots/01-to-center.svg",
                                        "ray-sphere/two-roots/02-along-the-ray.svg"};
  CHECK(listed() == all);
  fs::remove(shell.work() / "figures" / all[0]);
  REQUIRE(shell(render + "--preset two-roots --step 1").status == 0);
  CHECK(listed() == std::vector<std::string>{all[1], all[2]});

  SECTION("two renders at once list everything") {
    for (int i = 0; i < 10; ++i) {
      fs::remove_all(shell.work() / "figures");
      REQUIRE(shell(render + "--preset miss --step 1 & " + render + "--preset behind & " + render +
                    "--preset two-roots --step 1; wait")
                  .status == 0);
      std::vector<std::string> figures = files_in(shell.work() / "figures");
      std::erase_if(figures, [](const std::string& name) { return !name.ends_with(".svg"); });
      CHECK(figures.size() > 3);
      CHECK(listed() == figures);
      CHECK_FALSE(fs::exists(shell.work() / "figures/.isect-manifest.lock"));
    }
  }
  SECTION("a lock that a killed render left keeps nobody out") {
    write(shell.work() / "figures/.isect-manifest.lock", "");
    CHECK(shell("timeout 60 " + render + "--preset miss --step 1").status == 0);
    CHECK(listed() == all);
  }
  SECTION("a manifest that is damaged or another program's stays, and nothing is drawn") {
    const std::string deep = R"({"program": "isect", "figures": [{"file": "a.png", "of": )" +
                             std::string(300'000, '[') + std::string(300'000, ']') + "}]}";
    for (const std::string& text : {std::string("{\"name\": \"app\"}"), std::string("[]"),
                                    std::string("{\"program\": \"isect\""), std::string(), deep}) {
      write(shell.work() / "web/manifest.json", text);
      const Ran r = shell(render + "--step 1 --out web");
      CHECK(r.status == 4);
      CHECK(r.out.empty());
      CHECK_THAT(r.err, Contains("web/manifest.json") && Contains("not made by isect"));
      CHECK(contents(shell.work() / "web/manifest.json") == text);
      CHECK(files_in(shell.work() / "web").size() == 1);
    }
  }
}

TEST_CASE("a file of another's where a figure goes is named and stays", "[render]") {
  const Shell shell;
  const std::string photo = viz::png({1, 1, {1, 2, 3, 255}});
  write(shell.work() / "figures/ray-sphere/two-roots/02-along-the-ray.png", photo);
  const Ran r = shell("isect render ray-sphere --step 2");
  CHECK(r.status == 4);
  CHECK_THAT(r.err, Contains("02-along-the-ray.png") && Contains("not made by isect"));
  CHECK(contents(shell.work() / "figures/ray-sphere/two-roots/02-along-the-ray.png") == photo);
  CHECK(shell("isect render ray-sphere --step 1").status == 0);
}

TEST_CASE("a figure that someone has edited is neither written over nor removed, and neither is its alt text",
          "[render]") {
  const Shell shell;
  const auto folder = shell.work() / "figures/ray-sphere/mine";
  const auto render = [&](const std::string& preset, const std::string& more = "") {
    write(shell.work() / "mine.json", R"({"lesson": "ray-sphere", "preset": ")" + preset + "\"}");
    return shell("isect render --preset mine.json --format svg" + more);
  };
  REQUIRE(render("two-roots").err.empty());
  REQUIRE(fs::exists(folder / "12-cases.svg"));
  const auto manifest = [&] { return contents(shell.work() / "figures/manifest.json"); };
  const std::string listed = manifest(), text = contents(folder / "01-to-center.txt");
  // A figure that was drawn anew, and one that keeps its metadata, whose step the other preset does not have.
  const std::string drawing = "<svg>my own drawing</svg>\n",
                    note = contents(folder / "11-intersect.svg") + "<!-- a note -->\n";
  write(folder / "01-to-center.svg", drawing);
  write(folder / "11-intersect.svg", note);
  const auto check_kept = [&](const Ran& r) {
    CHECK(r.status == 0);
    CHECK_THAT(r.err, Contains("left alone: figures/ray-sphere/mine/01-to-center.svg was edited; remove it"));
    CHECK_THAT(r.out, !Contains("01-to-center.svg") && Contains("02-along-the-ray.svg"));
    CHECK(contents(folder / "01-to-center.svg") == drawing);
    CHECK(contents(folder / "11-intersect.svg") == note);
  };

  check_kept(render("two-roots"));
  CHECK(manifest() == listed);
  check_kept(render("two-roots", " --theme dark"));
  const Ran shorter = render("miss");
  check_kept(shorter);
  CHECK_THAT(shorter.err, Contains("left alone: figures/ray-sphere/mine/11-intersect.svg was edited"));
  CHECK(contents(folder / "01-to-center.txt") == text);
  CHECK(fs::exists(folder / "11-intersect.txt"));
  CHECK_FALSE(fs::exists(folder / "12-cases.svg"));

  fs::remove(folder / "01-to-center.svg");
  const Ran again = render("miss");
  CHECK_THAT(again.err, !Contains("01-to-center"));
  CHECK_THAT(contents(folder / "01-to-center.svg"), Contains("data-isect"));
  CHECK_THAT(render("two-roots").err, Contains("11-intersect.svg") && !Contains("01-to-center"));
}

TEST_CASE("what an older isect listed, without digests, is written over as ever", "[render]") {
  const Shell shell;
  const std::string render = "isect render ray-sphere --step 1 --format svg",
                    file = "figures/ray-sphere/two-roots/01-to-center.svg";
  REQUIRE(shell(render).status == 0);
  const std::string figure = contents(shell.work() / file);
  auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  REQUIRE(manifest["figures"][0].erase("digest") == 1);
  write(shell.work() / "figures/manifest.json", manifest.dump());
  write(shell.work() / file, "<svg/>");  // stripped of its metadata by another program
  const Ran r = shell(render);
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  CHECK(contents(shell.work() / file) == figure);
}

TEST_CASE("figures that a failed run wrote before it failed count as its own in the next one", "[render]") {
  const Shell shell;
  const std::string render = "isect render ray-sphere --step 1-3 --format svg";
  const auto folder = shell.work() / "figures/ray-sphere/two-roots";
  REQUIRE(shell(render).status == 0);
  REQUIRE(fs::remove(folder / "03-distance.svg"));
  fs::create_directories(folder / "03-distance.svg/x");
  CHECK(shell(render + " --theme dark").status == 4);
  fs::remove_all(folder / "03-distance.svg");
  CHECK_THAT(shell(render).err, !Contains("left alone"));
}

TEST_CASE("figures never go among baselines", "[render]") {
  const Shell shell;
  REQUIRE(shell("isect check ray-sphere --preset behind --update").status == 0);
  const auto before = files_in(shell.work());
  for (const std::string out : {"snapshots", "snapshots/", "snapshots/ray-sphere", "./snapshots/ray-sphere/behind"}) {
    INFO(out);
    const Ran r = shell("isect render ray-sphere --preset miss --format svg --out " + out);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, Contains("out: " + out + " holds baselines") && Contains("--out figures"));
  }
  CHECK(files_in(shell.work()) == before);
  CHECK(shell("isect render ray-sphere --step 1 --format svg --out .").status == 0);
}

}  // namespace figure_folder_test
