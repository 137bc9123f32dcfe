// Do two balls share a point? What it reads and answers: isect grade sphere-sphere
// rustc -O sphere-sphere.rs && isect grade sphere-sphere --plain ./sphere-sphere
#![allow(unused)]
use std::io::{self, BufRead, Write};

fn read(x: &mut impl Iterator<Item = f64>, count: usize) -> Vec<f64> {
    x.take(count).collect()
}

fn main() {
    for line in io::stdin().lock().lines() {
        let line = line.unwrap();
        let mut x = line.split_whitespace().map(|word| word.parse::<f64>().unwrap());
        let c1 = read(&mut x, 3);
        let r1 = x.next().unwrap();
        let c2 = read(&mut x, 3);
        let r2 = x.next().unwrap();
        // Write the test here.
        println!("0");
        io::stdout().flush().unwrap();
    }
}
