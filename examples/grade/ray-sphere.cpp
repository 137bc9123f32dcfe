// Where does a ray first meet a sphere's surface? What it reads and answers: isect grade ray-sphere
// c++ -O2 ray-sphere.cpp -o ray-sphere && isect grade ray-sphere --plain ./ray-sphere
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
    const std::vector<double> center = read(3);
    const double radius = number();
    // Write the test here.
    std::cout << "miss" << std::endl;
  }
}
