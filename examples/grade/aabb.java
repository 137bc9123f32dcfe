// Do two axis-aligned boxes share a point? What it reads and answers: isect grade aabb
// isect grade aabb --plain java aabb.java
import java.io.*;
import java.util.*;
class Starter {
  static StringTokenizer words;
  static double number() { return Double.parseDouble(words.nextToken()); }
  static double[] read(int count) {
    double[] x = new double[count];
    Arrays.setAll(x, i -> number());
    return x;
  }
  static double[][] rows(int count, int width) {
    double[][] x = new double[count][];
    Arrays.setAll(x, i -> read(width));
    return x;
  }
  public static void main(String[] arguments) throws IOException {
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String line; (line = in.readLine()) != null; System.out.flush()) {
      words = new StringTokenizer(line);
      double[] alo = read(3);
      double[] ahi = read(3);
      double[] blo = read(3);
      double[] bhi = read(3);
      System.out.println("0");  // write the test here
    }
  }
}
