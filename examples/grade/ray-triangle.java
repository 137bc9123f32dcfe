// Where does a ray first meet a triangle? What it reads and answers: isect grade ray-triangle
// isect grade ray-triangle --plain java ray-triangle.java
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
      double[] origin = read(3);
      double[] dir = read(3);
      double[][] tri = rows(3, 3);
      System.out.println("miss");  // write the test here
    }
  }
}
