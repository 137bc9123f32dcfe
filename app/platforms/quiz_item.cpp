#include "app/platforms/quiz_item.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "app/figures/blocks.h"
#include "app/figures/digest.h"
#include "app/figures/ownership.h"
#include "viz/walk/given_answer.h"
#include "viz/walk/given_order.h"
#include "viz/walk/pointed_line.h"

namespace isect::program::platforms {

namespace {

/// Returns the pseudocode, each line with its number; neither that nor its indentation shrinks on a web page.
std::vector<std::string> numbered_code(const Excerpt& e) {
  constexpr const char* space = "\u00a0";
  std::vector<std::string> lines;
  for (const std::string& line : code(e).lines) {
    const std::size_t in = std::min(line.find_first_not_of(' '), line.size());
    std::string numbered = fmt::format("{}{}{}", lines.size() + 1, space, space);
    for (std::size_t i = 0; i < in; ++i) numbered += space;
    lines.push_back(numbered + line.substr(in));
  }
  return lines;
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

}  // namespace

QuizItem item_of(const Excerpt& e, int step, std::string title) {
  const viz::QuestionText q = *viz::question_text(e.walk, step);
  const viz::Question& asked = *q.asked;
  const std::vector<std::string> lines = numbered_code(e);
  QuizItem item;
  item.id = identifier(file_of(e, step));
  item.title = std::move(title);
  item.given = given(*e.lesson, e.parameters, e.walk);
  item.prompt = q.whole_prompt;
  item.number = asked.number, item.order = asked.order;
  const std::string answer = asked.line || asked.order ? q.answer : q.choices.at(q.right) + ".";
  item.solution = q.because.empty() ? answer : answer + " " + q.because;
  if (asked.line) {
    const std::vector<std::string> replies = viz::line_replies(e.walk, step);
    for (std::size_t i = 0; i < lines.size(); ++i) item.choices.push_back({lines[i], replies.at(i)});
    item.right = static_cast<std::size_t>(asked.line->truth), item.lines = true;
    return item;
  }
  item.code = lines, item.right = q.right;
  for (std::size_t i = 0; i < q.choices.size(); ++i) {
    const bool wrong = i != q.right;
    item.choices.push_back(
        {q.choices[i], wrong ? viz::reply_to(e.walk, step, viz::GivenAnswer{static_cast<int>(i)}) : std::string()});
  }
  return item;
}

std::string identifier(const std::string& name) {
  constexpr std::size_t most = 100;
  const std::string end = "-" + digest(name);
  std::string id = "isect.";
  for (const char c : name) id += is_plain(c) ? c : c == '/' ? '.' : '_';
  const bool changed = std::ranges::any_of(name, [](char c) { return c != '/' && !is_plain(c); });
  if (!changed && id.size() <= most) return id;
  return id.substr(0, most - end.size()) + end;
}

std::string uuid(const std::string& name) {
  std::string digits = digest(name) + digest("isect " + name);
  digits[12] = '4', digits[16] = '8';  // the version and the variant that H5P expects
  for (const std::size_t at : {20, 16, 12, 8}) digits.insert(at, "-");
  return digits;
}

std::string decimal(double x) {
  std::string text = fmt::format("{}", x);
  if (text.find('e') == text.npos) return text;
  text = fmt::format("{:.20f}", x);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::vector<std::vector<int>> right_orders(const viz::OrderAsked& asked) {
  std::vector<int> order(asked.tiles.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<std::vector<int>> all;
  do
    if (viz::first_wrong(asked, order) < 0) all.push_back(order);
  while (std::next_permutation(order.begin(), order.end()));
  return all;
}

std::vector<QuizOrder> wrong_orders(const viz::OrderAsked& asked) {
  std::vector<QuizOrder> all;
  const auto add = [&](const std::vector<int>& order) {
    if (viz::first_wrong(asked, order) >= 0 && std::ranges::count(all, order, &QuizOrder::order) == 0)
      all.push_back({order, viz::reply_to(asked, order)});
  };
  for (const viz::WrongOrder& wrong : asked.wrong) add(wrong.order);
  for (const std::vector<int>& order : asked.offered) add(order);
  return all;
}

}  // namespace isect::program::platforms
