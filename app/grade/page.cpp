#include "app/grade/page.h"

#include <fmt/format.h>

#include <limits>
#include <vector>

#include "app/grade/cases.h"
#include "app/grade/truth.h"
#include "app/shell/terminal.h"

namespace isect::grade {

namespace {

/// Returns how many numbers a field has, and in which order.
std::string size_of_field(const Field& field) {
  switch (field.shape) {
    case Field::Shape::number:
      return "1 number";
    case Field::Shape::vector:
      return fmt::format("{} numbers", field.width);
    case Field::Shape::rows:
      return fmt::format("{} numbers, {} rows of {}", field.rows * field.width, field.rows, field.width);
    default:
      return fmt::format("n, then n rows of {}", field.width);
  }
}

std::string told(const Field& field) {
  return field.bounds.empty() ? field.what : fmt::format("{}; {}", field.what, field.bounds);
}

std::string tolerance(const Task& task) {
  if (task.output == Output::corners) return "A coordinate is right if it is that of the point.";
  if (task.ulps == 0) return "";
  return fmt::format(
      "A value is right if it is at most {} ulps off: ulps of the true value, or of 1 where that is smaller than 1.",
      task.ulps);
}

std::string of_numbers() {
  return fmt::format(
      "Every number is 0 or {:.2g} to {} in size; positions, lengths and sizes have one unit, whatever it is. "
      "A case in plain numbers is one line, in this order, with a blank between two numbers. In JSON it is an object "
      "on "
      "one line, with the same names; id counts the cases.",
      std::numeric_limits<double>::min(), largest);
}

struct CaseOnPage {
  std::string plain, json, answer;
};
CaseOnPage example_of(const Task& task) {
  for (const Case& one : cases(task, 1, 3)) {
    if (one.family == "ordinary") continue;
    const auto answer = truth(task, one.numbers);
    return {plain_line(one.numbers), json_line(task, one.numbers, 1), answer_line(task, *answer)};
  }
  return {};
}

}  // namespace

std::string count_of(const Task& task) {
  std::string text;
  int fixed = 0, lists = 0;
  for (const Field& field : task.fields) {
    if (field.shape != Field::Shape::list) {
      fixed += field.rows * field.width;
      continue;
    }
    text += fmt::format("{}1 + {} {}", text.empty() ? "" : " + ", field.width, lists++ == 0 ? "n" : "m");
  }
  if (text.empty()) return fmt::format("{}", fixed);
  return fixed == 0 ? text : fmt::format("{} + {}", fixed, text);
}

std::string markdown_page(const Task& task) {
  std::string page = fmt::format(
      "# {}: {}\n\n{}\n\nLesson: `isect show {}`\n\n## Input\n\n| field | numbers | what |\n"
      "| --- | --- | --- |\n",
      task.id, task.title, task.question, task.lesson);
  for (const Field& field : task.fields)
    page += fmt::format("| `{}` | {} | {} |\n", field.name, size_of_field(field), told(field));
  page += fmt::format("\n{} numbers a case. {}\n\n## Answer\n\nOne line a case: {}. {}\n\n## Conventions\n\n",
                      count_of(task), of_numbers(), task.answer, tolerance(task));
  for (const std::string& convention : task.conventions) page += fmt::format("- {}\n", convention);
  if (!task.note.empty()) page += fmt::format("- With `--convention note`, as in the lecture note: {}\n", task.note);
  const CaseOnPage example = example_of(task);
  page += fmt::format("\n## Example\n\n```\n{}\n{}\n```\n\nThe answer: `{}`\n\n## Families of cases\n\n", example.plain,
                      example.json, example.answer);
  for (const Family& family : families(task)) page += fmt::format("- {}: {}\n", family.name, family.what);
  return page;
}

std::string text_page(const Task& task, std::size_t width) {
  const auto paragraph = [&](const std::string& text, std::size_t indent) {
    return program::wrapped(text, width, indent);
  };
  std::string page = fmt::format("{}: {}\n", task.id, task.title) + paragraph(task.question, 0);
  page += fmt::format("Lesson: isect show {}\n\nInput, {} numbers a case:\n", task.lesson, count_of(task));
  for (const Field& field : task.fields)
    page += paragraph(fmt::format("{}: {} ({})", field.name, told(field), size_of_field(field)), 2);
  page += "\n" + paragraph(of_numbers(), 0) + "\nAnswer, one line a case:\n" + paragraph(task.answer, 2);
  if (const std::string rule = tolerance(task); !rule.empty()) page += paragraph(rule, 2);
  page += "\nConventions:\n";
  for (const std::string& convention : task.conventions) page += paragraph(convention, 2);
  if (!task.note.empty()) page += paragraph("With --convention note, as in the lecture note: " + task.note, 2);
  const CaseOnPage example = example_of(task);
  page += fmt::format("\nExample, as plain numbers, in JSON, and the answer:\n  {}\n  {}\n  {}\n\nFamilies of cases:\n",
                      example.plain, example.json, example.answer);
  for (const Family& family : families(task)) page += paragraph(fmt::format("{}: {}", family.name, family.what), 2);
  return page;
}

}  // namespace isect::grade
