// Where does a ray first meet a sphere's surface? What it reads and answers: isect grade ray-sphere
// rustc -O ray-sphere.rs && isect grade ray-sphere --plain ./ray-sphere
#![allow(unused)]
use std::io::{self, BufRead, Write};

fn read(x: &mut impl Iterator<Item = f64>, count: usize) -> Vec<f64> {
    x.take(count).collect()
}

fn main() {
    for line in io::stdin().lock().lines() {
        let line = line.unwrap();
        let mut x = line.split_whitespace().map(|word| word.parse::<f64>().unwrap());
        let origin = read(&mut x, 3);
        let dir = read(&mut x, 3);
        let center = read(&mut x, 3);
        let radius = x.next().unwrap();
        // Write the test here.
        println!("miss");
        io::stdout().flush().unwrap();
    }
}
