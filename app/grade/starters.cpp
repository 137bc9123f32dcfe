#include "app/grade/starters.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/grade/answers.h"
#include "viz/lesson.h"

namespace isect::grade {

namespace {

/// What stands before and after the lines that read the fields.
struct Template {
  const char* comment;
  const char* before;
  const char* number;  ///< what reads a field of each shape, with {name}, {rows}, {width}
  const char* vector;
  const char* rows;
  const char* list;
  const char* after;  ///< with {answer}
};

constexpr Template c_template = {
    "//",
    R"(#include <stdio.h>
#include <stdlib.h>

static double number(void) {
  double x;
  if (scanf("%lf", &x) != 1) exit(0);
  return x;
}
static void read(double *to, int count) {
  for (int i = 0; i < count; ++i) to[i] = number();
}

int main(void) {
  for (;;) {
)",
    "    double {name} = number();\n",
    "    double {name}[{width}]; read({name}, {width});\n",
    "    double {name}[{rows}][{width}]; read({name}[0], {rows} * {width});\n",
    "    int {name}_count = (int)number(); double {name}[{most}][{width}]; read({name}[0], {name}_count * {width});\n",
    R"(    // Write the test here.
    puts("{answer}");
    fflush(stdout);
  }
}
)"};

constexpr Template cpp_template = {
    "//",
    R"(#include <cstdlib>
#include <iostream>
#include <vector>

double number() {
  double x;
  if (std::cin >> x) return x;
  std::exit(0);
}
std::vector<double> read(int count) {
  std::vector<double> x;
  while (count-- > 0) x.push_back(number());
  return x;
}

int main() {
  for (;;) {
)",
    "    const double {name} = number();\n",
    "    const std::vector<double> {name} = read({width});\n",
    "    std::vector<std::vector<double>> {name}; for (int n = {rows}; n > 0; --n) {name}.push_back(read({width}));\n",
    "    std::vector<std::vector<double>> {name}; for (int n = int(number()); n > 0; --n) "
    "{name}.push_back(read({width}));\n",
    R"(    // Write the test here.
    std::cout << "{answer}" << std::endl;
  }
}
)"};

constexpr Template python_template = {"#",
                                      R"(import sys

for line in sys.stdin:
    x = iter(map(float, line.split()))
)",
                                      "    {name} = next(x)\n",
                                      "    {name} = [next(x) for _ in range({width})]\n",
                                      "    {name} = [[next(x) for _ in range({width})] for _ in range({rows})]\n",
                                      "    {name} = [[next(x) for _ in range({width})] for _ in range(int(next(x)))]\n",
                                      R"(    # Write the test here.
    print("{answer}", flush=True)
)"};

constexpr Template java_template = {"//",
                                    R"(import java.io.*;
import java.util.*;
class Starter {
  static StringTokenizer words;
  static double number() { return Double.parseDouble(words.nextToken()); }
  static double[] read(int count) {
    double[] x = new double[count];
    Arrays.setAll(x, i -> number());
    return x;
  }
  static double[][] rows(int count, int width) {
    double[][] x = new double[count][];
    Arrays.setAll(x, i -> read(width));
    return x;
  }
  public static void main(String[] arguments) throws IOException {
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String line; (line = in.readLine()) != null; System.out.flush()) {
      words = new StringTokenizer(line);
)",
                                    "      double {name} = number();\n",
                                    "      double[] {name} = read({width});\n",
                                    "      double[][] {name} = rows({rows}, {width});\n",
                                    "      double[][] {name} = rows((int) number(), {width});\n",
                                    R"(      System.out.println("{answer}");  // write the test here
    }
  }
}
)"};

constexpr Template javascript_template = {"//",
                                          R"(const lines = require('readline').createInterface({input: process.stdin});

lines.on('line', (line) => {
  const x = line.trim().split(/\s+/).map(Number);
  const read = (count) => x.splice(0, count);
  const rows = (count, width) => Array.from({length: count}, () => read(width));
)",
                                          "  const {name} = x.shift();\n",
                                          "  const {name} = read({width});\n",
                                          "  const {name} = rows({rows}, {width});\n",
                                          "  const {name} = rows(x.shift(), {width});\n",
                                          R"(  // Write the test here.
  console.log('{answer}');
});
)"};

constexpr Template rust_template = {
    "//",
    R"(#![allow(unused)]
use std::io::{self, BufRead, Write};

fn read(x: &mut impl Iterator<Item = f64>, count: usize) -> Vec<f64> {
    x.take(count).collect()
}

fn main() {
    for line in io::stdin().lock().lines() {
        let line = line.unwrap();
        let mut x = line.split_whitespace().map(|word| word.parse::<f64>().unwrap());
)",
    "        let {name} = x.next().unwrap();\n",
    "        let {name} = read(&mut x, {width});\n",
    "        let {name}: Vec<Vec<f64>> = (0..{rows}).map(|_| read(&mut x, {width})).collect();\n",
    "        let {name}_count = x.next().unwrap() as usize;\n"
    "        let {name}: Vec<Vec<f64>> = (0..{name}_count).map(|_| read(&mut x, {width})).collect();\n",
    R"(        // Write the test here.
        println!("{answer}");
        io::stdout().flush().unwrap();
    }
}
)"};

const Template& template_of(const Language& language) {
  if (language.name == "c") return c_template;
  if (language.name == "c++") return cpp_template;
  if (language.name == "python") return python_template;
  if (language.name == "java") return java_template;
  if (language.name == "javascript") return javascript_template;
  return rust_template;
}

std::string put_in(std::string text, const std::string& key, const std::string& value) {
  for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + value.size()))
    text.replace(at, key.size(), value);
  return text;
}

/// An answer that can be read, if mostly a wrong one.
std::string any_answer(const Task& task) {
  switch (task.output) {
    case Output::yes_no:
    case Output::corners:
    case Output::pairs:
      return "0";
    case Output::location:
      return "out";
    default:
      return "miss";
  }
}

std::string reading(const Template& of, const Field& field) {
  const char* const line = field.shape == Field::Shape::number   ? of.number
                           : field.shape == Field::Shape::vector ? of.vector
                           : field.shape == Field::Shape::rows   ? of.rows
                                                                 : of.list;
  std::string text = put_in(line, "{name}", put_in(put_in(field.name, ".", "_"), "rings", "polygon"));
  text = put_in(text, "{rows}", std::to_string(field.rows));
  text = put_in(text, "{most}", std::to_string(most_rows));
  return put_in(text, "{width}", std::to_string(field.width));
}

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> all = {{"c", "c"},       {"c++", "cpp"},       {"python", "py"},
                                            {"java", "java"}, {"javascript", "js"}, {"rust", "rs"}};
  return all;
}

const Language& language_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Language& language : languages()) {
    if (language.name == name || language.ending == name) return language;
    names.push_back(language.name);
  }
  throw viz::unknown("--language", name, names);
}

std::string starter_file(const Task& task, const Language& language) { return task.id + '.' + language.ending; }

std::vector<std::string> commands_for(const Task& task, const Language& language) {
  const std::string file = starter_file(task, language), judge = fmt::format("isect grade {} --plain ", task.id);
  if (language.name == "c") return {fmt::format("cc -O2 {} -o {} -lm", file, task.id), judge + "./" + task.id};
  if (language.name == "c++") return {fmt::format("c++ -O2 {} -o {}", file, task.id), judge + "./" + task.id};
  if (language.name == "rust") return {fmt::format("rustc -O {}", file), judge + "./" + task.id};
  const std::string runner = language.name == "javascript" ? "node" : language.name == "python" ? "python3" : "java";
  return {judge + runner + ' ' + file};
}

std::string starter(const Task& task, const Language& language) {
  const Template& of = template_of(language);
  std::string text =
      fmt::format("{0} {1} What it reads and answers: isect grade {2}\n{0}", of.comment, task.question, task.id);
  const char* before = " ";
  for (const std::string& command : commands_for(task, language)) text += before + command, before = " && ";
  text += std::string("\n") + of.before;
  for (const Field& field : task.fields) text += reading(of, field);
  return text + put_in(of.after, "{answer}", any_answer(task));
}

}  // namespace isect::grade
