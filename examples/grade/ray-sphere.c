// Where does a ray first meet a sphere's surface? What it reads and answers: isect grade ray-sphere
// cc -O2 ray-sphere.c -o ray-sphere -lm && isect grade ray-sphere --plain ./ray-sphere
#include <stdio.h>
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
    double origin[3]; read(origin, 3);
    double dir[3]; read(dir, 3);
    double center[3]; read(center, 3);
    double radius = number();
    // Write the test here.
    puts("miss");
    fflush(stdout);
  }
}
