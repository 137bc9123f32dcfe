// A reader's answers as text. Pages keep them in the same form.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "viz/walk/review.h"

namespace isect::viz {
namespace {

constexpr int record_version = 1;
constexpr double most_answers = 1e9;

using RecordJson = nlohmann::json;

[[noreturn]] void damaged(const std::string& path, const std::string& why) {
  throw BadInput(fmt::format("{}: {}", path, why));
}

const RecordJson& object_in(const RecordJson& from, const char* name, const std::string& path) {
  const auto found = from.find(name);
  if (found == from.end() || !found->is_object()) damaged(path + " " + name, "there is no such object");
  return *found;
}

/// Returns a count from 0 to a thousand million. Read as a double first: the library wraps what no int holds.
int count_in(const RecordJson& from, const char* name, const std::string& path) {
  const auto found = from.find(name);
  const bool whole = found != from.end() && found->is_number_integer();
  const double x = whole ? found->get<double>() : -1;
  if (!(x >= 0 && x <= most_answers)) damaged(path + " " + name, "there is no such count");
  return static_cast<int>(x);
}

AskedBefore asked_in(const RecordJson& from, const std::string& path) {
  if (!from.is_object()) damaged(path, "it is no object");
  const auto right = from.find("right");
  if (right == from.end() || !right->is_boolean()) damaged(path + " right", "it is neither true nor false");
  return {right->get<bool>(), count_in(from, "times", path), count_in(from, "wrong", path),
          count_in(from, "last", path)};
}

/// Returns the number of a review, which is a key.
int review_number(const std::string& key) {
  const bool good = !key.empty() && key.size() <= 4 && key.find_first_not_of("0123456789") == key.npos;
  if (!good) damaged("record reviews", "“" + key + "” is no review's number");
  return std::stoi(key);
}

AnswerRecord record_in(const RecordJson& json) {
  const std::string path = "record";
  if (!json.is_object()) damaged(path, "it is no object");
  if (const int version = count_in(json, "version", path); version != record_version)
    damaged(path + " version", fmt::format("{} is unknown; this program reads {}", version, record_version));
  AnswerRecord record;
  record.answers = count_in(json, "answers", path);
  for (const auto& lesson : object_in(json, "lessons", path).items()) {
    if (!lesson.value().is_object()) damaged(path + " " + lesson.key(), "it is no object");
    for (const auto& asked : lesson.value().items())
      record.lessons[lesson.key()][asked.key()] =
          asked_in(asked.value(), fmt::format("{} {} {}", path, lesson.key(), asked.key()));
  }
  for (const auto& review : object_in(json, "reviews", path).items()) {
    const std::string at = path + " review " + review.key();
    if (!review.value().is_object()) damaged(at, "it is no object");
    record.reviews[review_number(review.key())] = {count_in(review.value(), "right", at),
                                                   count_in(review.value(), "of", at)};
  }
  return record;
}

}  // namespace

std::string text_of(const AnswerRecord& record) {
  RecordJson lessons = RecordJson::object(), reviews = RecordJson::object();
  for (const auto& [lesson, questions] : record.lessons)
    for (const auto& [question, asked] : questions) {
      RecordJson& to = lessons[lesson][question];
      to["right"] = asked.right;
      to["times"] = asked.times, to["wrong"] = asked.wrong, to["last"] = asked.last;
    }
  for (const auto& [number, result] : record.reviews) {
    RecordJson& to = reviews[std::to_string(number)];
    to["right"] = result.right, to["of"] = result.of;
  }
  RecordJson json;
  json["version"] = record_version, json["answers"] = record.answers;
  json["lessons"] = lessons, json["reviews"] = reviews;
  return json.dump();
}

AnswerRecord answer_record_from(const std::string& text) {
  RecordJson json;
  try {
    json = RecordJson::parse(text);
  } catch (const RecordJson::exception&) {
    damaged("record", "it is not JSON");
  }
  return record_in(json);
}

}  // namespace isect::viz
