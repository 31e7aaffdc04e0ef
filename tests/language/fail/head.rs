mechanism_macros::mechanism! {
    coordinates { x [m]; }
    bodies { point: mass 1 at [x, 0]; }
}

fn main() {}
