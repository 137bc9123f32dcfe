// Do two balls share a point? What it reads and answers: isect grade sphere-sphere
// cc -O2 sphere-sphere.c -o sphere-sphere -lm && isect grade sphere-sphere --plain ./sphere-sphere
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
    double c1[3]; read(c1, 3);
    double r1 = number();
    double c2[3]; read(c2, 3);
    double r2 = number();
    // Write the test here.
    puts("0");
    fflush(stdout);
  }
}
