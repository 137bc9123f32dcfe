#include "lessons/rounding_bound/setup.h"

#include <optional>

namespace isect::lessons::rounding_bound_lesson {

using namespace viz;

namespace {

struct Heard : HearsOperations, HearsStages {
  std::vector<Operation> operations;
  std::vector<Stage> stages;
  void operator()(const Operation& operation) { operations.push_back(operation); }
  void operator()(const Stage& stage) { stages.push_back(stage); }
  void operator()(const Fallback&) {}
};

/// Hears the first stage and the last one: there are thousands of cells.
struct Ends : HearsStages {
  std::optional<Stage> first, last;
  void operator()(const Stage& stage) {
    if (!first) first = stage;
    last = stage;
  }
  void operator()(const Fallback&) {}
};

}  // namespace

Setup::Setup(const Parameters& values)
    : a(std::get<Vec3>(values.at("a"))),
      b(std::get<Vec3>(values.at("b"))),
      c(std::get<Vec3>(values.at("c"))),
      factor(std::get<double>(values.at("factor"))),
      selected(microscope::selected_of(values)) {
  const std::string& name = std::get<std::string>(values.at("unit"));
  unit = name == "huge" ? 0x1p515 : name == "tiny" ? 0x1p-530 : 1;
  tested_b = unit * b.head<2>(), tested_c = unit * c.head<2>();
}

Point2 Setup::tested_a() const {
  return {microscope::neighbour<double>(unit * a.x(), selected[0]),
          microscope::neighbour<double>(unit * a.y(), selected[1])};
}

Run::Run(const Setup& s) {
  Heard heard;
  truth = orient2d(s.tested_a(), s.tested_b, s.tested_c, heard);
  const std::vector<Operation>& o = heard.operations;
  differences = {o.at(0), o.at(1), o.at(3), o.at(4)};
  left = o.at(2), right = o.at(5), det = o.at(6);
  stages = heard.stages;
}

std::vector<Neighbour> neighbours(const Setup& s) {
  std::array<double, microscope::columns> x, y;
  for (int k = 0; k < microscope::columns; ++k) {
    const auto at = static_cast<std::size_t>(k);
    x[at] = microscope::neighbour<double>(s.unit * s.a.x(), k - microscope::half);
    y[at] = microscope::neighbour<double>(s.unit * s.a.y(), k - microscope::half);
  }
  std::vector<Neighbour> all;
  microscope::for_each_neighbour([&](int i, int j) {
    const Point2 a(x[static_cast<std::size_t>(i + microscope::half)],
                   y[static_cast<std::size_t>(j + microscope::half)]);
    Ends heard;
    const int truth = orient2d(a, s.tested_b, s.tested_c, heard);
    all.push_back({heard.first->value, heard.first->bound, heard.last->kind, truth});
  });
  return all;
}

std::string place(int sign) { return sign > 0 ? "left of the line" : sign < 0 ? "right of the line" : "on the line"; }

const StageWords& words_of(Stage::Kind kind) {
  static const std::array<StageWords, 7> all = {{{"doubles", "doubles", 53, 2.4},
                                                 {"a zero check", "zero-check", 0, 10},
                                                 {"two doubles", "two-doubles", 100, 13},
                                                 {"three doubles", "three-doubles", 150, 39},
                                                 {"255 bits", "bits-255", 255, 120},
                                                 {"127 bits", "bits-127", 127, 54},
                                                 {"all bits", "all-bits", 0, 200}}};
  return all.at(static_cast<std::size_t>(kind));
}

}  // namespace isect::lessons::rounding_bound_lesson
