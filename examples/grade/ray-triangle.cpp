// Where does a ray first meet a triangle? What it reads and answers: isect grade ray-triangle
// c++ -O2 ray-triangle.cpp -o ray-triangle && isect grade ray-triangle --plain ./ray-triangle
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
    const std::vector<double> origin = read(3);
    const std::vector<double> dir = read(3);
    std::vector<std::vector<double>> tri; for (int n = 3; n > 0; --n) tri.push_back(read(3));
    // Write the test here.
    std::cout << "miss" << std::endl;
  }
}
