#include "app/query/request.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "app/query/spelling.h"

namespace isect::query {

namespace {

/// Returns what a value is, for complaints.
std::string described(const Document& document, std::size_t at) {
  switch (document.value(at).type) {
    case Type::list:
      return "a list of " + std::to_string(document.value(at).size);
    case Type::text:
      return (document.value(at).size <= most_quoted ? "the text " : "") + described_text(document.text(at));
    case Type::number:
      return described_number(document.number(at));
    case Type::object:
      return "an object";
    case Type::null:
      return "null";
    default:
      return document.value(at).type == Type::yes ? "true" : "false";
  }
}

/// Returns the nearest S, infinite beyond the largest.
template <class S>
S rounded(std::string_view number) {
  S x = 0;
  if (std::from_chars(number.data(), number.data() + number.size(), x).ec == std::errc()) return x;
  const std::string text(number);  // too large, or too small: there x is left as it was
  return std::is_same_v<S, float> ? std::strtof(text.c_str(), nullptr)
                                  : static_cast<S>(std::strtod(text.c_str(), nullptr));
}

template <class S>
constexpr const char* scalar_name = std::is_same_v<S, float> ? "f32" : "f64";

}  // namespace

std::string Field::name() const { return at_ == 0 ? "the case" : "field \"" + path() + "\""; }

void Field::complain(const std::string& what) const { refuse(what + ", not " + described(*document_, at_)); }
void Field::refuse(const std::string& why) const { throw BadCase(name() + ": " + why); }

std::optional<Field> Field::find(std::string_view key) const {
  if (type() != Type::object) complain("an object is expected");
  for (std::size_t i = at_ + 1; i < document_->next(at_); i = document_->next(i + 1))
    if (document_->text(i) == key) return Field(*document_, i + 1);
  return {};
}

Field Field::operator[](std::string_view key) const {
  if (const std::optional<Field> found = find(key)) return *found;
  const std::string within = path();
  throw BadCase("field \"" + within + (within.empty() ? "" : ".") + std::string(key) + "\" is missing");
}

void Field::only(const std::vector<std::string>& names) const {
  if (type() != Type::object) complain("an object is expected");
  for (std::size_t i = at_ + 1; i < document_->next(at_); i = document_->next(i + 1)) {
    const std::string_view name = document_->text(i);
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    Field(*document_, i + 1).refuse("it is not known" + spelling::instead(name, names, "allowed: " + listed(names)));
  }
}

std::size_t Field::size() const {
  if (type() != Type::list) complain("a list is expected");
  return document_->value(at_).size;
}

Field::Entries Field::list() const {
  if (type() != Type::list) complain("a list is expected");
  return {*document_, at_};
}

Field::Entries Field::list(std::size_t count) const {
  if (type() != Type::list || document_->value(at_).size != count)
    complain("a list of " + std::to_string(count) + " is expected");
  return {*document_, at_};
}

std::string Field::text() const {
  if (type() != Type::text) complain("a text is expected");
  return std::string(document_->text(at_));
}

bool Field::boolean() const {
  if (type() != Type::yes && type() != Type::no) complain("true or false is expected");
  return type() == Type::yes;
}

template <class S>
S Field::number() const {
  if (type() != Type::number) complain("a finite number is expected");
  const S x = rounded<S>(document_->number(at_));
  if (!std::isfinite(x)) complain(std::string("a number within ") + scalar_name<S> + " is expected");
  return x;
}

template <class S>
S Field::end() const {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  if (says("inf")) return infinity;
  if (says("-inf")) return -infinity;
  if (type() != Type::number) complain("a number, \"inf\" or \"-inf\" is expected");
  return number<S>();
}

template float Field::number<float>() const;
template double Field::number<double>() const;
template float Field::end<float>() const;
template double Field::end<double>() const;

void need_finite_ends(const Field& lo, const Field& hi) {
  for (const Field& ends : {lo, hi})
    for (const Field end : ends.list())
      if (end.infinite()) end.complain("a finite number is expected of a box that is not empty");
}

int dimension(const Field& field) {
  const std::size_t size = field.size();
  if (size != 2 && size != 3) field.complain("a list of 2 or 3 numbers is expected");
  return static_cast<int>(size);
}

}  // namespace isect::query
