// Do two balls share a point? What it reads and answers: isect grade sphere-sphere
// isect grade sphere-sphere --plain java sphere-sphere.java
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
      double[] c1 = read(3);
      double r1 = number();
      double[] c2 = read(3);
      double r2 = number();
      System.out.println("0");  // write the test here
    }
  }
}
