// Do two axis-aligned boxes share a point? What it reads and answers: isect grade aabb
// rustc -O aabb.rs && isect grade aabb --plain ./aabb
#![allow(unused)]
use std::io::{self, BufRead, Write};

fn read(x: &mut impl Iterator<Item = f64>, count: usize) -> Vec<f64> {
    x.take(count).collect()
}

fn main() {
    for line in io::stdin().lock().lines() {
        let line = line.unwrap();
        let mut x = line.split_whitespace().map(|word| word.parse::<f64>().unwrap());
        let alo = read(&mut x, 3);
        let ahi = read(&mut x, 3);
        let blo = read(&mut x, 3);
        let bhi = read(&mut x, 3);
        // Write the test here.
        println!("0");
        io::stdout().flush().unwrap();
    }
}
