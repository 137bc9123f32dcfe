// Do two balls share a point? What it reads and answers: isect grade sphere-sphere
// c++ -O2 sphere-sphere.cpp -o sphere-sphere && isect grade sphere-sphere --plain ./sphere-sphere
#include <cstdlib>
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
    const std::vector<double> c1 = read(3);
    const double r1 = number();
    const std::vector<double> c2 = read(3);
    const double r2 = number();
    // Write the test here.
    std::cout << "0" << std::endl;
  }
}
