#include "lessons/query/request.h"

#include <cmath>
#include <limits>

namespace isect::query {

namespace {

/// What a value is, for complaints.
std::string kind_of(const Json& value) {
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  if (value.is_string()) {
    const std::string text = value.get<std::string>();
    return text.size() <= 40 ? "the text \"" + text + "\""
                             : "a text of " + std::to_string(text.size()) + " bytes";
  }
  if (value.is_object()) return "an object";
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  return value.is_null() ? "null" : "the number " + value.dump();
}

template <class S>
constexpr const char* scalar_name = std::is_same_v<S, float> ? "f32" : "f64";

}  // namespace

void Field::complain(const std::string& what) const {
  throw BadCase((path_.empty() ? "the case" : "field \"" + path_ + "\"") + ": " + what + ", not " +
                kind_of(value_));
}

std::optional<Field> Field::find(const std::string& key) const {
  if (!value_.is_object()) complain("an object is expected");
  const auto found = value_.find(key);
  if (found == value_.end()) return {};
  return Field(*found, path_.empty() ? key : path_ + "." + key);
}

Field Field::operator[](const std::string& key) const {
  if (const std::optional<Field> found = find(key)) return *found;
  throw BadCase("field \"" + (path_.empty() ? key : path_ + "." + key) + "\" is missing");
}

std::vector<Field> Field::list() const {
  if (!value_.is_array()) complain("a list is expected");
  std::vector<Field> entries;
  entries.reserve(value_.size());
  for (std::size_t i = 0; i < value_.size(); ++i)
    entries.emplace_back(value_[i], path_ + "[" + std::to_string(i) + "]");
  return entries;
}

std::vector<Field> Field::list(std::size_t count) const {
  if (!value_.is_array() || value_.size() != count)
    complain("a list of " + std::to_string(count) + " is expected");
  return list();
}

std::string Field::text() const {
  if (!value_.is_string()) complain("a text is expected");
  return value_.get<std::string>();
}

bool Field::boolean() const {
  if (!value_.is_boolean()) complain("true or false is expected");
  return value_.get<bool>();
}

template <class S>
S Field::number() const {
  if (!value_.is_number()) complain("a finite number is expected");
  const double x = value_.get<double>();
  const S rounded = static_cast<S>(x);
  if (!std::isfinite(rounded)) complain(std::string("a number within ") + scalar_name<S> + " is expected");
  return rounded;
}

template <class S>
S Field::end() const {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  if (value_ == "inf") return infinity;
  if (value_ == "-inf") return -infinity;
  if (!value_.is_number()) complain("a number, \"inf\" or \"-inf\" is expected");
  return number<S>();
}

template float Field::number<float>() const;
template double Field::number<double>() const;
template float Field::end<float>() const;
template double Field::end<double>() const;

int dimension(const Field& field) {
  const std::size_t size = field.list().size();
  if (size != 2 && size != 3) field.complain("a list of 2 or 3 numbers is expected");
  return static_cast<int>(size);
}

}  // namespace isect::query
