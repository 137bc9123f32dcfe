# Where does a ray first meet a triangle? What it reads and answers: isect grade ray-triangle
# isect grade ray-triangle --plain python3 ray-triangle.py
import sys

for line in sys.stdin:
    x = iter(map(float, line.split()))
    origin = [next(x) for _ in range(3)]
    dir = [next(x) for _ in range(3)]
    tri = [[next(x) for _ in range(3)] for _ in range(3)]
    # Write the test here.
    print("miss", flush=True)
