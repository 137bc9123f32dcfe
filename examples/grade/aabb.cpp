// Do two axis-aligned boxes share a point? What it reads and answers: isect grade aabb
// c++ -O2 aabb.cpp -o aabb && isect grade aabb --plain ./aabb
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
    const std::vector<double> alo = read(3);
    const std::vector<double> ahi = read(3);
    const std::vector<double> blo = read(3);
    const std::vector<double> bhi = read(3);
    // Write the test here.
    std::cout << "0" << std::endl;
  }
}
