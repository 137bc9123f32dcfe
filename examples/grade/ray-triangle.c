// Where does a ray first meet a triangle? What it reads and answers: isect grade ray-triangle
// cc -O2 ray-triangle.c -o ray-triangle -lm && isect grade ray-triangle --plain ./ray-triangle
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
    double tri[3][3]; read(tri[0], 3 * 3);
    // Write the test here.
    puts("miss");
    fflush(stdout);
  }
}
