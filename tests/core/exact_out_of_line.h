#pragma once
// The exact scalar without its code, for zero_cost_trace.cmake: big numbers are some other library's text on both sides
// of its comparison, and the compiler inlines them as the wind blows.

namespace isect {

class Exact {
 public:
  Exact();
  Exact(double);
  Exact(const Exact&);
  Exact& operator=(const Exact&);
  ~Exact();

  friend Exact operator*(const Exact&, const Exact&);
  friend Exact operator+(const Exact&, const Exact&);
  friend Exact operator-(const Exact&);
  friend Exact operator-(const Exact&, const Exact&);
  friend Exact abs(const Exact&);
  friend Exact sqrt(const Exact&);
  friend double quotient(const Exact&, const Exact&);
  friend double near_quotient(const Exact&, const Exact&);

  int sign() const;
  double rounded() const;

 private:
  long mantissa_;
};

}  // namespace isect
